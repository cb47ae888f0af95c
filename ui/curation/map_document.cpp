#include "ui/curation/map_document.h"

#include "core/building/geopackage.h"
#include "ui/convert/convert.h"

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

MapDocument::MapDocument(QObject* parent) : QObject(parent), m_background(this) {
    connect(&m_undo, &QUndoStack::cleanChanged, this, &MapDocument::stateChanged);
}

MapDocument::~MapDocument() {
    m_undo.disconnect(this);
}

Result<MapDocument::Loaded> MapDocument::import(const std::string& source,
                                                const building::ImportOptions& options) {
    auto imported = building::importBuilding(source, options);
    if (!imported) return imported.error();
    return Loaded{std::move(imported->building), std::move(imported->findings), true};
}

Result<MapDocument::Loaded> MapDocument::load(const std::string& source) {
    auto loaded = building::loadBuilding(source);
    if (!loaded) {
        if (loaded.error().code == ErrorCode::NotFound && source.rfind("PG:", 0) == 0) return loaded.error();
        auto imported = import(source, {});
        // A damaged building file is not made better by what an importer says of it.
        return imported || loaded.error().code == ErrorCode::UnsupportedFormat ? std::move(imported)
                                                                               : loaded.error();
    }
    Loaded result{loaded->building, building::checkBuilding(*loaded->building), false};
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
    if (!result) return void(Q_EMIT failed(toQString(result.error().text())));
    m_undo.clear();
    m_building = std::move(result->building);
    m_findings = std::move(result->findings);
    m_findingsOf = m_building;
    m_imported = result->imported;
    m_neverSaved = m_imported;
    m_source = source;
    m_path = m_imported ? QString() : source;
    Q_EMIT opened();
    Q_EMIT findingsChanged();
    Q_EMIT stateChanged();
}

void MapDocument::save(const QString& path) {
    if (!m_building || m_work != Work::None) return;
    begin(Work::Saving);
    // Under another name, too, the file keeps what Farol does not know of: it begins as a copy of the old
    // one.
    m_background.run([building = m_building, name = toUtf8(path),
                      origin = toUtf8(m_path)] { return building::saveBuilding(*building, name, origin); },
                     [this, path, what = m_building, step = m_undo.index()](Result<void> result) {
                         begin(Work::None);
                         if (!result) return void(Q_EMIT failed(toQString(result.error().text())));
                         m_path = path;
                         m_neverSaved = false;
                         if (what == m_building && step == m_undo.index())
                             m_undo.setClean();
                         else
                             m_undo.resetClean();
                         Q_EMIT stateChanged();
                         Q_EMIT saved(path);
                     });
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
        Q_EMIT refused(toQString(edit.error().text()));
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
