#include "ui/training/library_document.h"

#include "ui/convert/convert.h"
#include "ui/models/core_words.h"
#include "ui/training/library_merge.h"

#include <QFileInfo>
#include <QLockFile>
#include <QUndoCommand>

#include <utility>

namespace farol::ui {

namespace {

constexpr int kRestMs = 300;
constexpr int kLockMs = 20000; // a large library takes seconds to be written

} // namespace

class LibraryCommand : public QUndoCommand {
public:
    LibraryCommand(LibraryDocument& document, recognition::LibraryStep step, const QString& text)
        : QUndoCommand(text), m_document(document), m_step(std::move(step)) {}

    void redo() override { m_document.apply(m_step); }
    void undo() override { m_document.apply(recognition::reversed(m_step)); }

private:
    LibraryDocument& m_document;
    recognition::LibraryStep m_step;
};

LibraryDocument::LibraryDocument(QObject* parent) : QObject(parent), m_background(this) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMs);
    connect(&m_rest, &QTimer::timeout, this, &LibraryDocument::look);
    const auto stir = [this] {
        if (!m_rest.isActive()) m_rest.start();
    };
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, stir);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, stir);
}

LibraryDocument::~LibraryDocument() {
    m_undo.disconnect(); // its end is no change
}

void LibraryDocument::take(const QString& path, Library library, const FileStamp& stamp) {
    m_undo.clear();
    m_library = std::move(library);
    m_written = m_library;
    m_path = path;
    follow(stamp);
    Q_EMIT opened();
    Q_EMIT stateChanged();
}

void LibraryDocument::open(const QString& path) {
    const std::uint64_t job = ++m_job;
    m_opening = true;
    Q_EMIT stateChanged();
    m_background.run(
        [path]() -> Result<Written> {
            const FileStamp stamp = FileStamp::of(path); // before it is read: what comes later is news
            auto read = recognition::loadLibrary(toUtf8(path));
            if (!read) return read.error();
            return Written{std::make_shared<const recognition::LandmarkLibrary>(std::move(*read)), stamp};
        },
        [this, job, path](Result<Written> result) {
            if (job != m_job) return;
            m_opening = false;
            Q_EMIT stateChanged();
            if (!result) return void(Q_EMIT failed(CoreWords::problem(result.error())));
            take(path, std::move(result->library), result->stamp);
        });
}

void LibraryDocument::create(const QString& path) {
    const std::uint64_t job = ++m_job;
    m_opening = true;
    Q_EMIT stateChanged();
    auto fresh = std::make_shared<const recognition::LandmarkLibrary>();
    m_background.run([fresh, path] { return save(path, fresh, nullptr, FileStamp::of(path)); },
                     [this, job, path, fresh](Result<Written> result) {
                         if (job != m_job) return;
                         m_opening = false;
                         Q_EMIT stateChanged();
                         if (!result) return void(Q_EMIT failed(CoreWords::problem(result.error())));
                         take(path, fresh, result->stamp);
                     });
}

bool LibraryDocument::change(const QString& text, MakeStep make) {
    if (!m_library || busy()) return false;
    m_changing = true;
    Q_EMIT stateChanged();
    m_background.run([library = m_library, make = std::move(make)] { return make(*library); },
                     [this, text, from = m_library](Result<recognition::LibraryStep> step) {
                         m_changing = false;
                         Q_EMIT stateChanged();
                         // Undo may have been pressed meanwhile: the step no longer fits.
                         if (from != m_library)
                             return void(Q_EMIT refused(tr("The library was changed meanwhile; try again.")));
                         if (!step) return void(Q_EMIT refused(CoreWords::problem(step.error())));
                         m_undo.push(new LibraryCommand(*this, std::move(*step), text));
                     });
    return true;
}

void LibraryDocument::apply(const recognition::LibraryStep& step) {
    auto next = std::make_shared<recognition::LandmarkLibrary>(*m_library);
    recognition::apply(*next, step);
    m_library = std::move(next);
    Q_EMIT edited();
    write();
}

/// A file that is replaced by another one of its name is forgotten by the system: it is named anew.
void LibraryDocument::follow(const FileStamp& stamp) {
    m_stamp = m_told = stamp;
    for (const QString& path : m_watcher.files() + m_watcher.directories())
        if (path != m_path && path != QFileInfo(m_path).absolutePath()) m_watcher.removePath(path);
    for (const QString& path : {m_path, QFileInfo(m_path).absolutePath()})
        if (!m_watcher.files().contains(path) && !m_watcher.directories().contains(path) &&
            QFileInfo::exists(path))
            m_watcher.addPath(path);
}

void LibraryDocument::look() {
    if (!m_library || m_opening || m_writing) return; // the next step, or the end of this one, looks again
    const FileStamp now = FileStamp::of(m_path);
    if (now == m_told || !now.exists()) return;
    m_told = now;
    if (!m_watcher.files().contains(m_path)) m_watcher.addPath(m_path);
    if (!unsaved()) Q_EMIT changedOutside();
}

/// In any thread. Looking and writing are one: two programs that both look first would both write.
Result<LibraryDocument::Written> LibraryDocument::save(const QString& path, const Library& mine,
                                                       const Library& base, const FileStamp& known) {
    QLockFile lock(path + QStringLiteral(".lock"));
    lock.setStaleLockTime(0); // one that has crashed is known by its process
    if (!lock.tryLock(kLockMs) && lock.error() == QLockFile::LockFailedError)
        return Error{ErrorCode::Unavailable, toUtf8(tr("another program is writing this library; try again")),
                     toUtf8(path)};
    // Where no lock can be made, in a folder that cannot be written, the library says so itself.
    Library all = mine;
    const FileStamp now = FileStamp::of(path);
    if (now.exists() && now != known) {
        auto theirs = recognition::loadLibrary(toUtf8(path));
        if (!base || !theirs) return Written{};
        auto merged = mergedLibraries(*base, *mine, *theirs);
        if (!merged) return Written{};
        all = std::make_shared<const recognition::LandmarkLibrary>(std::move(*merged));
    }
    if (auto done = recognition::saveLibrary(*all, toUtf8(path)); !done) return done.error();
    return Written{std::move(all), FileStamp::of(path)};
}

void LibraryDocument::write() {
    if (m_writing || !m_library || !unsaved()) return;
    m_writing = true;
    Q_EMIT stateChanged();
    m_background.run([library = m_library, base = m_written, path = m_path,
                      known = m_stamp] { return save(path, library, base, known); },
                     [this, what = m_library](Result<Written> result) { written(what, std::move(result)); });
}

void LibraryDocument::written(const Library& what, Result<Written> result) {
    m_writing = false;
    if (!result || !result->library) {
        Q_EMIT stateChanged();
        if (!result) return void(Q_EMIT unwritable(CoreWords::problem(result.error())));
        return void(Q_EMIT overtaken());
    }
    follow(result->stamp);
    m_written = result->library;
    if (result->library != what) { // what was made here meanwhile is put on top
        auto newer = m_library == what ? std::nullopt : mergedLibraries(*what, *m_library, *m_written);
        const bool lost = m_library != what && !newer;
        if (!lost) {
            m_library =
                newer ? std::make_shared<const recognition::LandmarkLibrary>(std::move(*newer)) : m_written;
            m_undo.clear(); // its steps know the places in the library as it was
            Q_EMIT edited();
        }
        Q_EMIT stateChanged();
        if (lost) return void(Q_EMIT overtaken());
        Q_EMIT joined();
    }
    Q_EMIT stateChanged();
    Q_EMIT saved();
    write(); // what came meanwhile
}

void LibraryDocument::saveAnyway() {
    m_stamp = FileStamp::of(m_path);
    write();
}

void LibraryDocument::saveAs(const QString& path) {
    if (!m_library || m_writing) return;
    m_path = path;
    m_written.reset();
    m_stamp = FileStamp::of(path);
    write();
}

} // namespace farol::ui
