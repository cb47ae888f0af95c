#include "ui/training/library_document.h"

#include "ui/convert/convert.h"

#include <QFileInfo>
#include <QUndoCommand>

#include <utility>

namespace farol::ui {

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

LibraryDocument::LibraryDocument(QObject* parent) : QObject(parent), m_background(this) {}

LibraryDocument::~LibraryDocument() {
    m_undo.disconnect(); // its end is no change
}

void LibraryDocument::take(const QString& path, Library library) {
    m_undo.clear();
    m_library = std::move(library);
    m_written = m_library;
    m_path = path;
    remember();
    Q_EMIT opened();
    Q_EMIT stateChanged();
}

void LibraryDocument::open(const QString& path) {
    const std::uint64_t job = ++m_job;
    m_opening = true;
    Q_EMIT stateChanged();
    m_background.run([name = toUtf8(path)] { return recognition::loadLibrary(name); },
                     [this, job, path](Result<recognition::LandmarkLibrary> result) {
                         if (job != m_job) return;
                         m_opening = false;
                         Q_EMIT stateChanged();
                         if (!result) return void(Q_EMIT failed(toQString(result.error().text())));
                         take(path, std::make_shared<const recognition::LandmarkLibrary>(std::move(*result)));
                     });
}

void LibraryDocument::create(const QString& path) {
    const std::uint64_t job = ++m_job;
    m_opening = true;
    Q_EMIT stateChanged();
    auto fresh = std::make_shared<const recognition::LandmarkLibrary>();
    m_background.run([fresh, name = toUtf8(path)] { return recognition::saveLibrary(*fresh, name); },
                     [this, job, path, fresh](Result<void> result) {
                         if (job != m_job) return;
                         m_opening = false;
                         Q_EMIT stateChanged();
                         if (!result) return void(Q_EMIT failed(toQString(result.error().text())));
                         take(path, fresh);
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
                         if (!step) return void(Q_EMIT refused(toQString(step.error().text())));
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

void LibraryDocument::remember() {
    const QFileInfo info(m_path);
    m_stamp = info.lastModified();
    m_size = info.size();
}

bool LibraryDocument::changedOutside() const {
    const QFileInfo info(m_path);
    return info.exists() && (info.lastModified() != m_stamp || info.size() != m_size);
}

void LibraryDocument::write() {
    if (m_writing || !m_library || !unsaved()) return;
    if (changedOutside()) {
        Q_EMIT stateChanged();
        return void(Q_EMIT overtaken());
    }
    m_writing = true;
    Q_EMIT stateChanged();
    m_background.run(
        [library = m_library, name = toUtf8(m_path)] { return recognition::saveLibrary(*library, name); },
        [this, what = m_library](Result<void> result) {
            m_writing = false;
            if (!result) {
                Q_EMIT stateChanged();
                return void(Q_EMIT unwritable(toQString(result.error().text())));
            }
            m_written = what;
            remember();
            Q_EMIT stateChanged();
            Q_EMIT saved();
            write(); // what came meanwhile
        });
}

void LibraryDocument::saveAnyway() {
    remember();
    write();
}

void LibraryDocument::saveAs(const QString& path) {
    if (!m_library || m_writing) return;
    m_path = path;
    m_written.reset();
    remember();
    write();
}

} // namespace farol::ui
