#include "ui/convert/convert.h"

#include "core/base/text.h"
#include "ui/speech/phrasebook.h"

#include <cmath>

namespace farol::ui {

QImage toQImage(const cv::Mat& image) {
    if (image.empty() || image.depth() != CV_8U) return {};
    QImage::Format format = QImage::Format_Invalid;
    switch (image.channels()) {
    case 1:
        format = QImage::Format_Grayscale8;
        break;
    case 3:
        format = QImage::Format_BGR888;
        break;
    case 4:
        format = QImage::Format_ARGB32;
        break;
    default:
        return {};
    }
    const QImage view(image.data, image.cols, image.rows, static_cast<qsizetype>(image.step[0]), format);
    return view.convertToFormat(image.channels() == 4 ? QImage::Format_ARGB32 : QImage::Format_RGB32);
}

QPolygonF toPolygon(const Quad& quad) {
    QPolygonF polygon;
    for (const ImagePoint& corner : quad) polygon << toPoint(corner);
    return polygon;
}

QString clockText(double seconds) {
    if (!std::isfinite(seconds)) return QStringLiteral("–");
    const qint64 tenths = std::llround(std::max(0.0, seconds) * 10.0);
    return QStringLiteral("%1:%2.%3")
        .arg(tenths / 600)
        .arg(tenths / 10 % 60, 2, 10, QLatin1Char('0'))
        .arg(tenths % 10);
}

QString levelLabel(const building::Building& building, double ordinal) {
    const building::Level* level = building.level(ordinal);
    if (level && !level->ref.empty()) return toQString(level->ref);
    if (level && !level->name.empty()) return toQString(level->name);
    return toQString(formatNumber(ordinal));
}

QString regionLabel(const building::Region& region) {
    const QString name = toQString(building::spokenName(region, toUtf8(installedLanguage())));
    const QString ref = toQString(region.ref);
    if (ref.isEmpty() || name.contains(ref, Qt::CaseInsensitive)) return name;
    return QStringLiteral("%1 · %2").arg(name, ref);
}

QString regionName(const building::Building* building, const RegionId& id) {
    const building::Region* region = building ? building->region(id) : nullptr;
    return region ? toQString(building::spokenName(*region, toUtf8(installedLanguage())))
                  : toQString(id.value);
}

} // namespace farol::ui
