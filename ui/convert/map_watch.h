#pragma once
// Notices that another program has changed the file of a map that is open here. GUI thread; files are read in
// the background.

#include "core/base/error.h"
#include "core/building/building.h"
#include "ui/convert/background.h"

#include <QDateTime>
#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QTimer>

#include <memory>

namespace farol::ui {

/// How a file looks from outside. With the log that SQLite keeps beside it: QGIS writes there first.
struct FileStamp {
    QDateTime written, logWritten;
    qint64 size = -1, logSize = 0; ///< no file: -1

    static FileStamp of(const QString& path);
    bool exists() const { return size >= 0; }
    bool operator==(const FileStamp&) const = default;
};

class MapWatch : public QObject {
    Q_OBJECT

public:
    using Map = std::shared_ptr<const building::Building>;

    explicit MapWatch(QObject* parent = nullptr);
    ~MapWatch() override; ///< waits for what is being read

    /// From now on `path` is watched; `asRead` is what stood in it when it looked like `stamp`. What is no
    /// file (a database) is not watched. An empty path: nothing is.
    void follow(const QString& path, const FileStamp& stamp, Map asRead);
    /// We write it ourselves: looks away until follow().
    void lookAway();
    /// The file as it stands now would be lost by a save: nobody has read it. Reads it, in any thread.
    static bool changedSince(const QString& path, const FileStamp& stamp, const Map& asRead);
    const FileStamp& stamp() const { return m_stamp; }
    const Map& asRead() const { return m_asRead; }

Q_SIGNALS:
    /// Another map than the one that was read last. Comes again with each further change.
    void changed(const farol::ui::MapWatch::Map& map, const farol::ui::FileStamp& stamp);
    void changedBack(); ///< it says again what was read
    void gone();
    void unreadable(const farol::Error& error); ///< changed, and no map any more, or not yet

private:
    void follow();
    void look();
    void judge(const FileStamp& stamp, Result<Map> found);

    QString m_path;
    FileStamp m_stamp;  ///< of what is known
    FileStamp m_looked; ///< of what was told last
    Map m_asRead;
    QFileSystemWatcher m_watcher;
    QTimer m_rest; ///< a program that writes does so many times
    std::uint64_t m_job = 0;
    Background m_background; ///< last: its jobs use the rest
};

} // namespace farol::ui
