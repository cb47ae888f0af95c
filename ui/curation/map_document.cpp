#include "ui/curation/map_document.h"

#include "core/building/geopackage.h"
#include "ui/convert/convert.h"
#include "ui/models/core_words.h"

#include <QUndoCommand>

#include <utility>

namespace farol::ui {

/// One step of the curator. A row of nudges by key is one step.
class EditCommand : public QUndoCommand {
public:
    EditCommand(MapDocument& document, building::Edit edit, const QString& text, bool nudge)
        : QUndoCommand(text), m_document(document), m_edit(std::move(edit)), m_nudge(nudge) {}

    void redo() override { m_document.apply(m_edit); }
    void undo() override { m_document.apply(building::reversed(m_edit)); }
    int id() const override { return m_nudge ? 1 : -1; }
    bool mergeWith(const QUndoCommand* next) override {
        const auto* later = static_cast<const EditCommand*>(next);
        const bool same = m_edit.after && later->m_edit.after && m_edit.index == later->m_edit.index &&
                          m_edit.after->index() == later->m_edit.after->index();
        if (same) m_edit.after = later->m_edit.after;
        return same;
    }

private:
    MapDocument& m_document;
    building::Edit m_edit;
    bool m_nudge;
};

/// The whole map replaced by what another program made of it.
class OutsideCommand : public QUndoCommand {
public:
    OutsideCommand(MapDocument& document, MapWatch::Map before, MapWatch::Map after, const QString& text)
        : QUndoCommand(text), m_document(document), m_before(std::move(before)), m_after(std::move(after)) {}

    void redo() override { m_document.put(m_after); }
    void undo() override { m_document.put(m_before); }

private:
    MapDocument& m_document;
    MapWatch::Map m_before, m_after;
};

MapDocument::MapDocument(QObject* parent) : QObject(parent), m_background(this) {
    connect(&m_undo, &QUndoStack::cleanChanged, this, &MapDocument::stateChanged);
    connectWatch();
}

void MapDocument::connectWatch() {
    connect(&m_watch, &MapWatch::changed, this, [this](const MapWatch::Map& map, const FileStamp& stamp) {
        m_outside = map;
        m_outsideStamp = stamp;
        setOnlyHere(false);
        Q_EMIT changedOutside();
    });
    connect(&m_watch, &MapWatch::changedBack, this, [this] {
        m_outside.reset();
        setOnlyHere(false);
        Q_EMIT outsideSettled();
    });
    connect(&m_watch, &MapWatch::gone, this, [this] {
        setOnlyHere(true);
        Q_EMIT fileGone();
    });
    connect(&m_watch, &MapWatch::unreadable, this, [this](const Error& error) {
        setOnlyHere(true);
        Q_EMIT fileUnreadable(CoreWords::problem(error));
    });
}

/// The file holds the map no more: leaving without a save would lose it.
void MapDocument::setOnlyHere(bool only) {
    m_outside = only ? nullptr : m_outside;
    m_onlyHere = only;
    Q_EMIT stateChanged();
}

MapDocument::~MapDocument() {
    m_undo.disconnect(this);
}

Result<MapDocument::Loaded> MapDocument::import(const std::string& source,
                                                const building::ImportOptions& options) {
    auto imported = building::importBuilding(source, options);
    if (!imported) return imported.error();
    return Loaded{std::move(imported->building), std::move(imported->findings), true, {}};
}

Result<MapDocument::Loaded> MapDocument::load(const std::string& source) {
    const FileStamp stamp = FileStamp::of(toQString(source));
    auto loaded = building::loadBuilding(source);
    if (!loaded) {
        if (loaded.error().code == ErrorCode::NotFound && source.rfind("PG:", 0) == 0) return loaded.error();
        auto imported = import(source, {});
        // A damaged building file is not made better by what an importer says of it.
        return imported || loaded.error().code == ErrorCode::UnsupportedFormat ? std::move(imported)
                                                                               : loaded.error();
    }
    Loaded result{loaded->building, building::checkBuilding(*loaded->building), false, stamp};
    return result;
}

void MapDocument::begin(Work work) {
    m_work = work;
    Q_EMIT workChanged();
}

void MapDocument::open(const QString& source) {
    const std::uint64_t job = ++m_job;
    begin(Work::Opening);
    m_background.run([name = toUtf8(source)] { return load(name); },
                     [this, job, source](Result<Loaded> result) {
                         if (job == m_job) loaded(source, std::move(result));
                     });
}

void MapDocument::importFrom(const QString& source, const building::ImportOptions& options) {
    const std::uint64_t job = ++m_job;
    begin(Work::Importing);
    m_background.run([name = toUtf8(source), options] { return import(name, options); },
                     [this, job, source](Result<Loaded> result) {
                         if (job == m_job) loaded(source, std::move(result));
                     });
}

void MapDocument::cancel() {
    if (m_work != Work::Opening && m_work != Work::Importing) return;
    ++m_job;
    begin(Work::None);
}

void MapDocument::loaded(const QString& source, Result<Loaded> result) {
    begin(Work::None);
    if (!result) return void(Q_EMIT failed(CoreWords::problem(result.error())));
    m_undo.clear();
    m_building = std::move(result->building);
    m_findings = std::move(result->findings);
    m_findingsOf = m_building;
    m_imported = result->imported;
    m_neverSaved = m_imported;
    m_source = source;
    m_path = m_imported ? QString() : source;
    m_onlyHere = false;
    m_outside.reset();
    m_watch.follow(m_path, result->stamp, m_building);
    Q_EMIT outsideSettled();
    Q_EMIT opened();
    Q_EMIT findingsChanged();
    Q_EMIT stateChanged();
}

/// What stands in the file afterwards is read again: only then can another program's change be told from
/// ours.
Result<MapDocument::Saved> MapDocument::write(const building::Building& building, const QString& path,
                                              const QString& origin) {
    const auto saved = building::saveBuilding(building, toUtf8(path), toUtf8(origin));
    if (!saved) return saved.error();
    const FileStamp stamp = FileStamp::of(path);
    if (!stamp.exists()) return Saved{}; // a database
    auto again = building::loadBuilding(toUtf8(path));
    if (!again) return again.error();
    return Saved{stamp, std::move(again->building)};
}

void MapDocument::save(const QString& path, bool anyway) {
    if (!m_building || m_work != Work::None) return;
    begin(Work::Saving);
    const bool guarded = !anyway && path == m_path;
    const FileStamp known = m_watch.stamp();
    const MapWatch::Map asRead = m_watch.asRead();
    m_watch.lookAway();
    // Under another name, too, the file keeps what Farol does not know of: it begins as a copy of the old
    // one.
    m_background.run(
        [building = m_building, path, origin = m_onlyHere ? QString() : m_path, guarded, known,
         asRead]() -> Result<Saved> {
            if (guarded && MapWatch::changedSince(path, known, asRead)) return Saved{{}, {}, true};
            return write(*building, path, origin);
        },
        [this, path, known, asRead, what = m_building, step = m_undo.index()](Result<Saved> result) {
            begin(Work::None);
            if (!result || result->overtaken) m_watch.follow(m_path, known, asRead);
            if (!result) return void(Q_EMIT failed(CoreWords::problem(result.error())));
            if (result->overtaken) return void(Q_EMIT overtaken(path));
            if (what == m_building && step == m_undo.index())
                m_undo.setClean();
            else
                m_undo.resetClean();
            written(path, *result);
        });
}

void MapDocument::written(const QString& path, const Saved& saved) {
    m_path = path;
    m_neverSaved = false;
    m_onlyHere = false;
    m_outside.reset();
    m_watch.follow(path, saved.stamp, saved.asRead);
    Q_EMIT outsideSettled();
    Q_EMIT stateChanged();
    Q_EMIT this->saved(path);
}

void MapDocument::takeOutside() {
    if (!m_outside || (m_work != Work::None && m_work != Work::Checking)) return;
    const MapWatch::Map map = std::exchange(m_outside, nullptr);
    m_watch.follow(m_path, m_outsideStamp, map);
    m_undo.push(new OutsideCommand(*this, m_building, map, tr("Load the map again")));
    m_undo.setClean();
    Q_EMIT outsideSettled();
    check();
}

void MapDocument::put(const std::shared_ptr<const building::Building>& building) {
    m_building = building;
    Q_EMIT replaced();
    Q_EMIT findingsChanged();
    Q_EMIT stateChanged();
}

void MapDocument::check() {
    if (!m_building || m_work != Work::None) return;
    begin(Work::Checking);
    m_background.run([building = m_building] { return building::checkBuilding(*building); },
                     [this, what = m_building](std::vector<building::Finding> findings) {
                         begin(Work::None);
                         m_findings = std::move(findings);
                         m_findingsOf = what;
                         Q_EMIT findingsChanged();
                     });
}

bool MapDocument::push(const Result<building::Edit>& edit, const QString& text, bool nudge) {
    if (!edit) {
        Q_EMIT refused(CoreWords::problem(edit.error()));
        return false;
    }
    m_undo.push(new EditCommand(*this, *edit, text, nudge));
    return true;
}

void MapDocument::apply(const building::Edit& edit) {
    building::BuildingData data = m_building->data();
    building::apply(data, edit);
    m_building = std::make_shared<const building::Building>(std::move(data));
    Q_EMIT edited(edit);
    Q_EMIT findingsChanged(); // they are of the map as it was
    Q_EMIT stateChanged();
}

} // namespace farol::ui
