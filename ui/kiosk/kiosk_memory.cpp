#include "ui/kiosk/kiosk_memory.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>

namespace farol::ui {

namespace {

constexpr qint64 kMostBytes = 100000; // more was not written by us

const QString kMap = QStringLiteral("map");
const QString kDestination = QStringLiteral("destination");
const QString kRegion = QStringLiteral("region");

} // namespace

std::optional<KioskMoment> KioskMemory::load() const {
    QFile file(m_file);
    if (!file.open(QIODevice::ReadOnly)) return std::nullopt;
    const QJsonObject object = QJsonDocument::fromJson(file.read(kMostBytes)).object();
    const KioskMoment moment{object[kMap].toString(), object[kDestination].toString(),
                             object[kRegion].toString()};
    if (moment.destination.isEmpty()) return std::nullopt;
    return moment;
}

bool KioskMemory::save(const KioskMoment& moment) const {
    QDir().mkpath(QFileInfo(m_file).absolutePath());
    QSaveFile file(m_file);
    if (!file.open(QIODevice::WriteOnly)) return false;
    const QByteArray text =
        QJsonDocument(
            QJsonObject{{kMap, moment.map}, {kDestination, moment.destination}, {kRegion, moment.region}})
            .toJson();
    // commit() alone forgets that the last bytes could not be written, and puts an empty file in place.
    if (file.write(text) != text.size() || !file.flush()) file.cancelWriting();
    return file.commit();
}

bool KioskMemory::writable() const {
    QDir().mkpath(QFileInfo(m_file).absolutePath());
    QSaveFile file(m_file);
    const bool opened = file.open(QIODevice::WriteOnly);
    file.cancelWriting();
    return opened;
}

void KioskMemory::forget() const {
    QFile::remove(m_file);
}

} // namespace farol::ui
