// The names on the map: where each one stands, clear of symbols, of the other names and of the marks of a
// walk.

#include "ui/map/map_painter.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace farol::ui {

namespace {

bool meetsAny(const QRectF& box, const std::vector<QRectF>& others) {
    return std::any_of(others.begin(), others.end(),
                       [&](const QRectF& other) { return other.intersects(box); });
}

QRectF around(QPointF centre, double radius) {
    return {centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius};
}

} // namespace

void MapPainter::paintText(QPainter& painter, QPointF centre, const QString& text, bool upright) const {
    const QFontMetricsF metrics(m_font);
    QPainterPath path;
    path.addText(-metrics.boundingRect(text).center(), m_font, text);
    QColor halo = m_colours.halo;
    halo.setAlpha(225);
    painter.save();
    painter.translate(centre);
    if (upright) painter.rotate(-90.0);
    painter.setPen(QPen(halo, 3.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(path);
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_colours.text);
    painter.drawPath(path);
    painter.restore();
}

/// Empty: there is no room for it.
std::optional<PlacedName> MapPainter::placedName(std::size_t index, const QString& name,
                                                 const std::vector<QRectF>& taken) const {
    const RegionShape& shape = m_level->regions[index];
    const QFontMetricsF metrics(m_font);
    const double scale = m_view.pixelsPerMetre();
    const double width = metrics.horizontalAdvance(name);
    const double roomAcross = shape.bounds.width() * scale;
    const double roomUp = shape.bounds.height() * scale;
    const bool upright = width > roomAcross && roomUp > 1.5 * roomAcross;
    const double along = upright ? roomUp : roomAcross;
    const double across = upright ? roomAcross : roomUp;
    // A name that does not fit would be taken for the neighbour's; the pointer and the list tell it.
    if (width > along || metrics.height() > 1.6 * across) return std::nullopt;
    const QPointF home = screen(shape.labelAt);
    const QSizeF size = upright ? QSizeF(metrics.height(), width) : QSizeF(width, metrics.height());
    const double slack = std::max(0.0, (along - width) / 2);
    const double aside = std::max(0.0, (across - metrics.height()) / 2);
    for (const double sideways : {0.0, -1.0, 1.0})
        for (const double share : {0.0, -0.5, 0.5, -1.0, 1.0}) {
            const double a = share * slack;
            const double b = sideways * std::min(aside, metrics.height() * 1.2);
            const QPointF centre = home + (upright ? QPointF(b, a) : QPointF(a, b));
            const QRectF box(centre.x() - size.width() / 2, centre.y() - size.height() / 2, size.width(),
                             size.height());
            if (meetsAny(box, taken)) continue;
            return PlacedName{index, name, centre, upright, box, {}, false};
        }
    return std::nullopt;
}

std::vector<PlacedName> MapPainter::placedNames() const {
    std::vector<PlacedName> names;
    if (!m_level) return names;
    std::vector<QRectF> taken = symbolBoxes(); // what is set already keeps its place
    for (const std::size_t i : m_level->regionIndex.meeting(seen())) {
        const RegionShape& shape = m_level->regions[i];
        std::optional<PlacedName> name = placedName(i, shape.label, taken);
        if (!name && !shape.brief.isEmpty()) name = placedName(i, shape.brief, taken);
        if (!name) continue;
        taken.push_back(name->box);
        names.push_back(std::move(*name));
    }
    return names;
}

void MapPainter::paintNames(QPainter& painter, const std::vector<PlacedName>& names) const {
    painter.setRenderHint(QPainter::Antialiasing);
    for (const PlacedName& name : names) paintText(painter, name.centre, name.text, name.upright);
}

/// What paintMarks() covers.
std::vector<QRectF> MapPainter::markBoxes(const MapOverlay& overlay) const {
    std::vector<QRectF> boxes;
    constexpr double kPen = 1.5;
    if (overlay.destination) boxes.push_back(pinBox(*overlay.destination));
    if (const auto at = markAt(overlay)) {
        boxes.push_back(around(*at, kMarkRadius + kPen));
        const double middle = (kArrowFoot + kArrowTip) / 2;
        if (overlay.fix->heading)
            boxes.push_back(around(*at + ahead(*overlay.fix->heading) * middle, kArrowTip - middle));
    }
    if (overlay.truth && isHere(*overlay.truth))
        boxes.push_back(around(screen(overlay.truth->position), kTruthRadius + kPen));
    return boxes;
}

std::vector<PlacedName> MapPainter::movedAside(const std::vector<PlacedName>& names,
                                               const MapOverlay& overlay) const {
    std::vector<PlacedName> moved;
    if (!m_level) return moved;
    const std::vector<QRectF> marks = markBoxes(overlay);
    const auto covered = [&](const PlacedName& name) { return meetsAny(name.box, marks); };
    if (std::none_of(names.begin(), names.end(), covered)) return moved;
    std::vector<QRectF> taken = symbolBoxes();
    taken.insert(taken.end(), marks.begin(), marks.end());
    for (const PlacedName& name : names)
        if (!covered(name)) taken.push_back(name.box);
    for (const PlacedName& name : names) {
        if (!covered(name)) continue;
        std::optional<PlacedName> beside = placedName(name.shape, name.text, taken);
        const QString& brief = m_level->regions[name.shape].brief;
        if (!beside && !brief.isEmpty()) beside = placedName(name.shape, brief, taken);
        moved.push_back(beside.value_or(name));
        moved.back().home = name.box;
        moved.back().overMark = !beside;
        taken.push_back(moved.back().box);
    }
    return moved;
}

} // namespace farol::ui
