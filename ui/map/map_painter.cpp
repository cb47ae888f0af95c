#include "ui/map/map_painter.h"

#include "ui/convert/convert.h"
#include "ui/convert/glyphs.h"
#include "ui/convert/kind_style.h"

#include <QFontMetricsF>
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

} // namespace

MapPainter::MapPainter(const MapScene& scene, double level, const ViewTransform& view,
                       const MapColours& colours, QFont font, MapStyle style)
    : m_scene(scene),
      m_level(scene.level(level)),
      m_view(view),
      m_colours(colours),
      m_font(std::move(font)),
      m_style(style) {}

Box2 MapPainter::seen() const {
    constexpr double kMarginPx = 24.0; // symbols and wide pens reach into the picture from outside
    const QSizeF size = m_view.size();
    const Point2 low = m_view.mapFromScreen({-kMarginPx, size.height() + kMarginPx});
    const Point2 high = m_view.mapFromScreen({size.width() + kMarginPx, -kMarginPx});
    return {low, high};
}

double MapPainter::symbolSize() const {
    return std::clamp(m_view.pixelsPerMetre() * 0.9, kSmallestSymbol, kLargestSymbol);
}

void MapPainter::paintGround(QPainter& painter) const {
    painter.fillRect(QRectF(QPointF(), m_view.size()), m_colours.outside);
    if (!m_level) return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    const QTransform transform = m_view.painterTransform();
    for (const std::size_t i : m_level->regionIndex.meeting(seen())) {
        const RegionShape& shape = m_level->regions[i];
        const building::RegionKind kind = m_scene.building().regions()[shape.index].kind;
        const bool way = kind == building::RegionKind::Corridor || kind == building::RegionKind::Hall;
        painter.setBrush(m_style.kinds ? m_colours.fill(kind) : way ? m_colours.corridor : m_colours.floor);
        painter.drawPath(transform.map(shape.path));
    }
}

void MapPainter::paintFurnishing(QPainter& painter) const {
    if (!m_level) return;
    painter.setRenderHint(QPainter::Antialiasing);
    const QTransform transform = m_view.painterTransform();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(roundPen(m_colours.border, 1.4));
    for (const std::size_t i : m_level->regionIndex.meeting(seen()))
        painter.drawPath(transform.map(m_level->regions[i].path));
    painter.setPen(roundPen(m_colours.wall, std::clamp(m_view.pixelsPerMetre() * 0.12, 1.2, 5.0)));
    for (const std::size_t i : m_level->wallIndex.meeting(seen()))
        painter.drawPolyline(toScreen(m_scene.building().data().walls[m_level->walls[i]].line, m_view));
    for (const std::size_t i : m_level->accessIndex.meeting(seen()))
        paintAccess(painter, m_level->accesses[i]);
    if (m_view.pixelsPerMetre() < kSymbolsFromScale) return;
    for (const std::size_t i : m_level->landmarkIndex.meeting(seen()))
        paintLandmark(painter, m_scene.building().landmarks()[m_level->landmarks[i]]);
}

bool MapPainter::accessHasSymbol(const AccessShape& shape) const {
    const building::Access& access = m_scene.building().accesses()[shape.index];
    return access.changesLevel() || access.kind == building::AccessKind::Ramp || shape.line.size() < 2;
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
        const double leaf = access.kind == building::AccessKind::Window ? 3.6 : 2.6;
        painter.setPen(QPen(colour, leaf, dashed ? Qt::DotLine : Qt::SolidLine, Qt::FlatCap));
        painter.drawPolyline(gap);
        if (access.kind == building::AccessKind::Window) { // two thin lines, as on any plan
            painter.setPen(QPen(m_colours.floor, 1.0, Qt::SolidLine, Qt::FlatCap));
            painter.drawPolyline(gap);
        }
    }
    const bool symbol = accessHasSymbol(shape);
    if (symbol && m_view.pixelsPerMetre() >= kSymbolsFromScale) {
        painter.setPen(QPen(colour, 1.2));
        painter.setBrush(m_colours.floor);
        painter.drawEllipse(middle, 9.0, 9.0);
        paintGlyph(painter, pathOf(access.kind), middle, 13.0, colour);
    } else if (symbol) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        painter.drawEllipse(middle, 2.2, 2.2);
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

std::vector<QRectF> MapPainter::symbolBoxes() const {
    std::vector<QRectF> boxes;
    if (m_view.pixelsPerMetre() < kSymbolsFromScale) return boxes;
    const auto add = [&](Point2 at, double size) {
        const QPointF centre = screen(at);
        boxes.emplace_back(centre.x() - size / 2, centre.y() - size / 2, size, size);
    };
    for (const std::size_t i : m_level->accessIndex.meeting(seen()))
        if (accessHasSymbol(m_level->accesses[i])) add(m_level->accesses[i].middle, 18.0);
    for (const std::size_t i : m_level->landmarkIndex.meeting(seen()))
        add(m_scene.building().landmarks()[m_level->landmarks[i]].position, symbolSize());
    return boxes;
}

} // namespace farol::ui
