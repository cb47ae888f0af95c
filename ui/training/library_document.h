#pragma once
// The landmark library that the curator works on. Every step is written into the file at once, in the
// background, and can be taken back. GUI thread; the library itself is immutable and replaced by each step.

#include "core/recognition/library_edit.h"
#include "ui/convert/background.h"

#include <QDateTime>
#include <QObject>
#include <QString>
#include <QUndoStack>

#include <functional>
#include <memory>

namespace farol::ui {

class LibraryDocument : public QObject {
    Q_OBJECT

public:
    using Library = std::shared_ptr<const recognition::LandmarkLibrary>;
    using MakeStep =
        std::function<Result<recognition::LibraryStep>(const recognition::LandmarkLibrary& library)>;

    explicit LibraryDocument(QObject* parent = nullptr);
    ~LibraryDocument() override; ///< waits for what is being written

    void open(const QString& path);
    /// An empty library in a new file.
    void create(const QString& path);
    /// Works the step out in the background, makes it and writes it. One at a time: false while busy.
    bool change(const QString& text, MakeStep make);
    /// Writes again after a failure, also over what another program wrote meanwhile.
    void saveAnyway();
    void saveAs(const QString& path);

    const Library& library() const { return m_library; }
    const QString& path() const { return m_path; }
    bool busy() const { return m_opening || m_changing; }
    bool unsaved() const { return m_library != m_written; }
    bool settled() const { return !busy() && !m_writing; }
    QUndoStack& undoStack() { return m_undo; }

Q_SIGNALS:
    void opened(); ///< another library
    void edited(); ///< also by undo and redo
    void stateChanged();
    void saved();
    void failed(const QString& message);     ///< opening
    void unwritable(const QString& message); ///< what was changed is not in the file
    void overtaken();                        ///< another program has written the file meanwhile
    void refused(const QString& message);

private:
    friend class LibraryCommand;

    void apply(const recognition::LibraryStep& step);
    void take(const QString& path, Library library);
    void write();
    void remember(); ///< how the file looks now
    bool changedOutside() const;

    Library m_library, m_written;
    QString m_path;
    QDateTime m_stamp;
    qint64 m_size = 0;
    QUndoStack m_undo;
    bool m_opening = false, m_changing = false, m_writing = false;
    std::uint64_t m_job = 0;
    Background m_background; ///< last: its jobs use the rest
};

} // namespace farol::ui
