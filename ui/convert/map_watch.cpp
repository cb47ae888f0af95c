#include "ui/convert/map_watch.h"

#include "core/building/compare.h"
#include "core/building/geopackage.h"
#include "ui/convert/convert.h"

#include <QFileInfo>

#include <utility>

namespace farol::ui {

namespace {

constexpr int kRestMs = 300;

QString logOf(const QString& path) {
    return path + QStringLiteral("-wal");
}

Result<MapWatch::Map> read(const QString& path) {
    auto loaded = building::loadBuilding(toUtf8(path));
    if (!loaded) return loaded.error();
    return MapWatch::Map(std::move(loaded->building));
}

} // namespace

FileStamp FileStamp::of(const QString& path) {
    FileStamp stamp;
    const QFileInfo info(path);
    if (!info.exists()) return stamp;
    stamp.written = info.lastModified();
    stamp.size = info.size();
    // An empty log comes and goes with each reader and says nothing.
    if (const QFileInfo log(logOf(path)); log.size() > 0) {
        stamp.logWritten = log.lastModified();
        stamp.logSize = log.size();
    }
    return stamp;
}

MapWatch::MapWatch(QObject* parent) : QObject(parent), m_background(this) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMs);
    connect(&m_rest, &QTimer::timeout, this, &MapWatch::look);
    const auto stir = [this] {
        if (!m_path.isEmpty() && !m_rest.isActive()) m_rest.start();
    };
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, stir);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, stir);
}

MapWatch::~MapWatch() = default;

void MapWatch::lookAway() {
    ++m_job;
    m_path.clear();
    m_rest.stop();
    const QStringList watched = m_watcher.files() + m_watcher.directories();
    if (!watched.isEmpty()) m_watcher.removePaths(watched);
}

void MapWatch::follow(const QString& path, const FileStamp& stamp, Map asRead) {
    lookAway();
    m_stamp = stamp;
    m_looked = stamp;
    m_asRead = std::move(asRead);
    if (path.isEmpty() || !m_asRead || !QFileInfo(path).isFile()) return;
    m_path = path;
    follow();
    m_rest.start(); // what was written between the reading and now
}

/// A file that is replaced by another one of its name is forgotten by the system: it is named anew. The
/// folder tells when it comes.
void MapWatch::follow() {
    for (const QString& path : {m_path, logOf(m_path), QFileInfo(m_path).absolutePath()})
        if (!m_watcher.files().contains(path) && !m_watcher.directories().contains(path) &&
            QFileInfo::exists(path))
            m_watcher.addPath(path);
}

void MapWatch::look() {
    if (m_path.isEmpty()) return;
    follow();
    const FileStamp now = FileStamp::of(m_path);
    if (now == m_looked) return;
    m_looked = now;
    const std::uint64_t job = ++m_job;
    if (!now.exists()) return void(Q_EMIT gone());
    m_background.run([path = m_path] { return read(path); },
                     [this, job, now](Result<Map> found) {
                         if (job == m_job) judge(now, std::move(found));
                     });
}

void MapWatch::judge(const FileStamp& stamp, Result<Map> found) {
    if (!found) return void(Q_EMIT unreadable(found.error()));
    if (!building::sameContent((*found)->data(), m_asRead->data()))
        return void(Q_EMIT changed(*found, stamp));
    m_stamp = stamp;
    Q_EMIT changedBack();
}

bool MapWatch::changedSince(const QString& path, const FileStamp& stamp, const Map& asRead) {
    const FileStamp now = FileStamp::of(path);
    if (!asRead || !now.exists() || now == stamp) return false;
    const auto found = read(path);
    return !found || !building::sameContent((*found)->data(), asRead->data());
}

} // namespace farol::ui
