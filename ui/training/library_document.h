#pragma once
// The landmark library that the curator works on. Every step is written into the file at once, in the
// background, and can be taken back. GUI thread; the library itself is immutable and replaced by each step.
// Another Farol may work on the same file: one writes at a time, what it wrote is noticed, and put together
// with what was made here.

#include "core/recognition/library_edit.h"
#include "ui/convert/background.h"
#include "ui/convert/map_watch.h"

#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QTimer>
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
    void overtaken();      ///< not saved: another program has changed the same landmarks meanwhile
    void joined();         ///< saved, together with what another program has changed meanwhile
    void changedOutside(); ///< another program has changed the file; nothing here is unsaved
    void refused(const QString& message);

private:
    friend class LibraryCommand;

    void apply(const recognition::LibraryStep& step);
    void take(const QString& path, Library library, const FileStamp& stamp);
    struct Written {
        Library library; ///< what the file holds now; null: it is another program's, and could not be joined
        FileStamp stamp;
    };
    static Result<Written> save(const QString& path, const Library& mine, const Library& base,
                                const FileStamp& known);
    void write();
    void written(const Library& what, Result<Written> result);
    void follow(const FileStamp& stamp); ///< the file looks so now, and is known
    void look();

    Library m_library, m_written;
    QString m_path;
    FileStamp m_stamp; ///< of what is known of the file
    FileStamp m_told;  ///< of what was told last
    QFileSystemWatcher m_watcher;
    QTimer m_rest; ///< a program that writes does so many times
    QUndoStack m_undo;
    bool m_opening = false, m_changing = false, m_writing = false;
    std::uint64_t m_job = 0;
    Background m_background; ///< last: its jobs use the rest
};

} // namespace farol::ui
