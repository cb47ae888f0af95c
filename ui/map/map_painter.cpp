#include "ui/map/map_painter.h"

#include "ui/convert/convert.h"
#include "ui/convert/glyphs.h"
#include "ui/convert/kind_style.h"

#include <QFontMetricsF>
#include <QLinearGradient>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace farol::ui {

namespace {

constexpr double kSymbolsFromScale = 3.0; // pixels a metre; smaller maps would be all symbols
constexpr double kLargestSymbol = 17.0;
constexpr double kSmallestSymbol = 6.0; // a plain dot
constexpr double kGlyphFrom = 12.0;     // smaller symbols have no drawing inside

QPolygonF toScreen(const Polyline& line, const ViewTransform& view) {
    QPolygonF polygon;
    for (const Point2& point : line) polygon << view.screenFromMap(point);
    return polygon;
}

QPen roundPen(const QColor& colour, double width, Qt::PenStyle style = Qt::SolidLine) {
    return {colour, width, style, Qt::RoundCap, Qt::RoundJoin};
}

QColor withAlpha(QColor colour, int alpha) {
    colour.setAlpha(alpha);
    return colour;
}

} // namespace

MapPainter::MapPainter(const MapScene& scene, double level, const ViewTransform& view,
                       const MapColours& colours, QFont font)
    : m_scene(scene),
      m_level(scene.level(level)),
      m_view(view),
      m_colours(colours),
      m_font(std::move(font)) {}

double MapPainter::symbolSize() const {
    return std::clamp(m_view.pixelsPerMetre() * 0.9, kSmallestSymbol, kLargestSymbol);
}

void MapPainter::paintGround(QPainter& painter) const {
    painter.fillRect(QRectF(QPointF(), m_view.size()), m_colours.outside);
    if (!m_level) return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    const QTransform transform = m_view.painterTransform();
    for (const RegionShape& shape : m_level->regions) {
        const building::RegionKind kind = m_scene.building().regions()[shape.index].kind;
        const bool way = kind == building::RegionKind::Corridor || kind == building::RegionKind::Hall;
        painter.setBrush(way ? m_colours.corridor : m_colours.floor);
        painter.drawPath(transform.map(shape.path));
    }
}

void MapPainter::paintTint(QPainter& painter, const MapOverlay& overlay) const {
    if (!m_level || !overlay.fix) return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    const QTransform transform = m_view.painterTransform();
    for (const RegionShape& shape : m_level->regions) {
        const double heat = overlay.heatOf(m_scene.building().regions()[shape.index].id);
        if (heat <= 0.0) continue;
        painter.setBrush(m_colours.heat(heat));
        painter.drawPath(transform.map(shape.path));
    }
}

void MapPainter::paintFurnishing(QPainter& painter) const {
    if (!m_level) return;
    painter.setRenderHint(QPainter::Antialiasing);
    const QTransform transform = m_view.painterTransform();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(roundPen(m_colours.border, 1.4));
    for (const RegionShape& shape : m_level->regions) painter.drawPath(transform.map(shape.path));
    painter.setPen(roundPen(m_colours.wall, std::clamp(m_view.pixelsPerMetre() * 0.12, 1.2, 5.0)));
    painter.drawPath(transform.map(m_level->walls));
    for (const AccessShape& shape : m_level->accesses) paintAccess(painter, shape);
    if (m_view.pixelsPerMetre() >= kSymbolsFromScale)
        for (const std::size_t index : m_level->landmarks)
            paintLandmark(painter, m_scene.building().landmarks()[index]);
}

void MapPainter::paintAccess(QPainter& painter, const AccessShape& shape) const {
    const building::Access& access = m_scene.building().accesses()[shape.index];
    const QColor colour = access.closed           ? m_colours.closed
                          : access.changesLevel() ? m_colours.shaft
                                                  : m_colours.door;
    const QPointF middle = screen(shape.middle);
    if (shape.line.size() >= 2) { // the gap in the wall, then the leaf
        const QPolygonF gap = toScreen(shape.line, m_view);
        painter.setPen(QPen(m_colours.floor, 5.0, Qt::SolidLine, Qt::FlatCap));
        painter.drawPolyline(gap);
        const bool dashed = access.kind == building::AccessKind::Opening;
        painter.setPen(QPen(colour, 2.6, dashed ? Qt::DotLine : Qt::SolidLine, Qt::FlatCap));
        painter.drawPolyline(gap);
    }
    const bool symbol =
        access.changesLevel() || access.kind == building::AccessKind::Ramp || shape.line.size() < 2;
    if (symbol && m_view.pixelsPerMetre() >= kSymbolsFromScale) {
        painter.setPen(QPen(colour, 1.2));
        painter.setBrush(m_colours.floor);
        painter.drawEllipse(middle, 9.0, 9.0);
        paintGlyph(painter, pathOf(access.kind), middle, 13.0, colour);
    } else if (symbol) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        painter.drawEllipse(middle, 3.0, 3.0);
    }
    painter.setBrush(Qt::NoBrush);
    if (access.closed) {
        painter.setPen(QPen(m_colours.closed, 2.0));
        painter.drawLine(middle - QPointF(5, 5), middle + QPointF(5, 5));
        painter.drawLine(middle - QPointF(5, -5), middle + QPointF(5, -5));
    }
}

void MapPainter::paintLandmark(QPainter& painter, const building::Landmark& landmark) const {
    const QPointF at = screen(landmark.position);
    const QColor colour = kindColour(landmark.kind, m_colours.dark);
    const double size = symbolSize();
    if (landmark.heading) { // a short stroke the way it faces
        const double turn = landmark.heading->value;
        painter.setPen(roundPen(colour, size < kGlyphFrom ? 1.4 : 2.0));
        painter.drawLine(at, at + QPointF(std::cos(turn), -std::sin(turn)) * (size * 0.9));
    }
    if (size < kGlyphFrom) {
        painter.setPen(QPen(m_colours.floor, 1.0));
        painter.setBrush(colour);
        painter.drawEllipse(at, size / 2, size / 2);
        painter.setBrush(Qt::NoBrush);
        return;
    }
    painter.setPen(QPen(colour, 1.4));
    painter.setBrush(m_colours.floor);
    painter.drawRoundedRect(QRectF(at.x() - size / 2, at.y() - size / 2, size, size), 4.0, 4.0);
    painter.setBrush(Qt::NoBrush);
    paintGlyph(painter, pathOf(landmark.kind), at, size - 4.0, colour);
}

void MapPainter::paintText(QPainter& painter, QPointF centre, const QString& text, bool upright) const {
    const QFontMetricsF metrics(m_font);
    QPainterPath path;
    path.addText(-metrics.boundingRect(text).center(), m_font, text);
    painter.save();
    painter.translate(centre);
    if (upright) painter.rotate(-90.0);
    painter.setPen(QPen(withAlpha(m_colours.halo, 225), 3.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(path);
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_colours.text);
    painter.drawPath(path);
    painter.restore();
}

void MapPainter::paintNames(QPainter& painter) const {
    if (!m_level) return;
    painter.setRenderHint(QPainter::Antialiasing);
    const QFontMetricsF metrics(m_font);
    std::vector<QRectF> taken; // names already set keep their place
    for (const RegionShape& shape : m_level->regions) {
        const double scale = m_view.pixelsPerMetre();
        const double width = metrics.horizontalAdvance(shape.label);
        const double roomAcross = shape.bounds.width() * scale;
        const double roomUp = shape.bounds.height() * scale;
        const bool upright = width > roomAcross && roomUp > 1.5 * roomAcross;
        const double along = upright ? roomUp : roomAcross;
        const double across = upright ? roomAcross : roomUp;
        // A name that does not fit would be taken for the neighbour's; the pointer and the list tell it.
        if (width > 1.1 * along || metrics.height() > 1.6 * across) continue;
        const QPointF home = screen(shape.labelAt);
        const QSizeF size = upright ? QSizeF(metrics.height(), width) : QSizeF(width, metrics.height());
        const double slack = std::max(0.0, (along - width) / 2);
        for (const double share : {0.0, -0.5, 0.5, -1.0, 1.0}) {
            const QPointF centre = home + (upright ? QPointF(0, share * slack) : QPointF(share * slack, 0));
            const QRectF box(centre.x() - size.width() / 2, centre.y() - size.height() / 2, size.width(),
                             size.height());
            if (std::any_of(taken.begin(), taken.end(),
                            [&](const QRectF& other) { return other.intersects(box); }))
                continue;
            paintText(painter, centre, shape.label, upright);
            taken.push_back(box);
            break;
        }
    }
}

void MapPainter::paintArrows(QPainter& painter, const QPolygonF& line) const {
    double untilNext = 22.0;
    for (qsizetype i = 1; i < line.size(); ++i) {
        const QPointF step = line[i] - line[i - 1];
        const double stepLength = std::hypot(step.x(), step.y());
        if (stepLength < 1e-6) continue;
        const QPointF along = step / stepLength;
        const QPointF across(-along.y(), along.x());
        double at = untilNext;
        for (; at < stepLength; at += 44.0) {
            const QPointF tip = line[i - 1] + along * (at + 3.0);
            painter.drawPolyline(
                QPolygonF{tip - along * 5.0 + across * 4.0, tip, tip - along * 5.0 - across * 4.0});
        }
        untilNext = at - stepLength;
    }
}

void MapPainter::paintRoute(QPainter& painter, const MapOverlay& overlay) const {
    if (!m_level || !overlay.route) return;
    painter.setRenderHint(QPainter::Antialiasing);
    std::vector<QPolygonF> pieces;
    bool here = false;
    for (const routing::PathPoint& point : overlay.route->path) {
        const bool onLevel = point.level == m_level->ordinal;
        if (onLevel && !here) pieces.emplace_back();
        if (onLevel) pieces.back() << screen(point.position);
        here = onLevel;
    }
    for (const QPolygonF& piece : pieces) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(roundPen(m_colours.routeCasing, 8.5));
        painter.drawPolyline(piece);
        painter.setPen(roundPen(m_colours.route, 5.5));
        painter.drawPolyline(piece);
        painter.setPen(roundPen(readableOn(m_colours.route), 1.6));
        paintArrows(painter, piece);
    }
}

void MapPainter::paintOutline(QPainter& painter, const RegionShape& shape, const QColor& colour,
                              Qt::PenStyle style) const {
    const QPainterPath path = m_view.painterTransform().map(shape.path);
    painter.save();
    painter.setClipPath(path); // inside only: doors and walls on the border stay visible
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colour, 6.0, style, Qt::FlatCap, Qt::MiterJoin));
    painter.drawPath(path);
    painter.restore();
}

void MapPainter::paintPin(QPainter& painter, const RegionId& region, const QColor& colour) const {
    const RegionShape* shape = m_scene.shapeOf(region);
    if (!shape || m_scene.building().regions()[shape->index].level != m_level->ordinal) return;
    paintOutline(painter, *shape, colour, Qt::DashLine);
    const QPointF foot = screen(shape->labelAt) - QPointF(0, 12);
    QPainterPath pin;
    pin.moveTo(foot);
    pin.cubicTo(foot + QPointF(-12, -12), foot + QPointF(-10, -26), foot + QPointF(0, -26));
    pin.cubicTo(foot + QPointF(10, -26), foot + QPointF(12, -12), foot);
    painter.setPen(QPen(m_colours.fixCasing, 1.5));
    painter.setBrush(colour);
    painter.drawPath(pin);
    painter.setBrush(m_colours.floor);
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(foot + QPointF(0, -17), 3.6, 3.6);
}

void MapPainter::paintPlaceMark(QPainter& painter, const MapOverlay& overlay) const {
    const localisation::Fix& fix = *overlay.fix;
    const bool sure = fix.confidence >= overlay.sureConfidence;
    const RegionShape* shape = fix.region ? m_scene.shapeOf(*fix.region) : nullptr;
    const bool shapeHere = shape && m_scene.building().regions()[shape->index].level == m_level->ordinal;
    if (shapeHere) paintOutline(painter, *shape, m_colours.fix, sure ? Qt::SolidLine : Qt::DashLine);
    const bool levelHere = !fix.level || *fix.level == m_level->ordinal;
    if (!levelHere || (!fix.position && !shapeHere)) return;
    const QPointF at = screen(fix.position ? *fix.position : shape->labelAt);
    if (fix.position && fix.sigmaM > 0.0) {
        const double radius = fix.sigmaM * m_view.pixelsPerMetre();
        painter.setPen(QPen(m_colours.fix, 1.2, Qt::DashLine));
        painter.setBrush(withAlpha(m_colours.fix, 40));
        painter.drawEllipse(at, radius, radius);
    }
    if (fix.heading) {
        const double turn = fix.heading->value;
        const QPointF ahead(std::cos(turn), -std::sin(turn));
        const QPointF side(-ahead.y(), ahead.x());
        painter.setPen(QPen(m_colours.fixCasing, 1.5));
        painter.setBrush(m_colours.fix);
        painter.drawPolygon(
            QPolygonF{at + ahead * 20.0, at + ahead * 7.0 + side * 7.0, at + ahead * 7.0 - side * 7.0});
    }
    painter.setPen(QPen(m_colours.fixCasing, 2.5));
    painter.setBrush(fix.position ? m_colours.fix : m_colours.floor);
    painter.drawEllipse(at, 8.0, 8.0);
    if (!fix.position) { // only the place is known, not the spot
        painter.setPen(QPen(m_colours.fix, 3.0));
        painter.drawEllipse(at, 6.5, 6.5);
    }
    painter.setBrush(Qt::NoBrush);
}

void MapPainter::paintMarks(QPainter& painter, const MapOverlay& overlay) const {
    if (!m_level) return;
    painter.setRenderHint(QPainter::Antialiasing);
    if (overlay.destination) paintPin(painter, *overlay.destination, m_colours.destination);
    if (overlay.fix) {
        if (const building::Landmark* seen = m_scene.building().landmark(overlay.fix->landmark);
            seen && seen->level == m_level->ordinal) {
            painter.setPen(QPen(m_colours.fix, 2.4));
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(screen(seen->position), 14.0, 14.0);
        }
        paintPlaceMark(painter, overlay);
    }
}

void MapPainter::paintSelection(QPainter& painter, const MapHit& hit, bool strong) const {
    if (!m_level || levelOf(hit, m_scene.building()) != m_level->ordinal) return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_colours.text, strong ? 2.4 : 1.4, strong ? Qt::SolidLine : Qt::DotLine));
    if (hit.what == MapHit::What::Region) {
        if (const RegionShape* shape = m_scene.shapeOf(m_scene.building().regions()[hit.index].id))
            painter.drawPath(m_view.painterTransform().map(shape->path));
        return;
    }
    const QPointF at = screen(positionOf(hit, m_scene));
    painter.drawRoundedRect(QRectF(at.x() - 12, at.y() - 12, 24, 24), 6, 6);
}

void MapPainter::paintLegend(QPainter& painter, const QString& unlikely, const QString& likely) const {
    const QFontMetricsF metrics(m_font);
    const double left = metrics.horizontalAdvance(unlikely);
    const double right = metrics.horizontalAdvance(likely);
    constexpr double kBar = 70.0;
    const double height = metrics.height() + 8.0;
    const QRectF box(8.0, m_view.size().height() - height - 8.0, left + right + kBar + 28.0, height);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(m_colours.border, 1.0));
    painter.setBrush(m_colours.floor);
    painter.drawRoundedRect(box, 4, 4);
    QLinearGradient ramp(QPointF(box.left() + left + 14, 0), QPointF(box.left() + left + 14 + kBar, 0));
    ramp.setColorAt(0.0, m_colours.heat(0.0));
    ramp.setColorAt(1.0, m_colours.heat(1.0));
    painter.setBrush(ramp);
    painter.drawRect(QRectF(box.left() + left + 14, box.top() + 5, kBar, height - 10));
    painter.setFont(m_font);
    painter.setPen(m_colours.text);
    painter.drawText(QRectF(box.left() + 8, box.top(), left + 2, height), Qt::AlignVCenter, unlikely);
    painter.drawText(QRectF(box.right() - right - 8, box.top(), right + 2, height), Qt::AlignVCenter, likely);
}

} // namespace farol::ui
