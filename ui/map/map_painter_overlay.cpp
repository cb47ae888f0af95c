#include "ui/convert/convert.h"
#include "ui/convert/glyphs.h"
#include "ui/convert/kind_style.h"
#include "ui/map/coverage.h"
#include "ui/map/floor_picture.h"
#include "ui/map/map_painter.h"

#include <QFontMetricsF>
#include <QLinearGradient>
#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace farol::ui {

namespace {

QPen roundPen(const QColor& colour, double width, Qt::PenStyle style = Qt::SolidLine) {
    return {colour, width, style, Qt::RoundCap, Qt::RoundJoin};
}

QColor withAlpha(QColor colour, int alpha) {
    colour.setAlpha(alpha);
    return colour;
}

/// The largest of 1, 2, 5, 10, ... metres that is no longer than `most`.
double roundMetres(double most) {
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    for (const double step : {5.0, 2.0})
        if (step * power <= most) return step * power;
    return power;
}

} // namespace

void MapPainter::paintPictures(QPainter& painter, const MapOverlay& overlay) const {
    if (!m_level) return;
    for (const auto& picture : overlay.pictures) {
        if (picture->level != m_level->ordinal) continue;
        painter.save();
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.setOpacity(picture->opacity);
        painter.setTransform(picture->toMap * m_view.painterTransform(), true);
        painter.drawImage(QPointF(), picture->image);
        painter.restore();
    }
}

void MapPainter::paintCoverage(QPainter& painter, const CoverageLayer& layer) const {
    const auto& levels = layer.coverage.levels;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        if (levels[i].level != m_level->ordinal || levels[i].columns == 0) continue;
        const double cell = levels[i].cellM;
        const Point2 north = levels[i].corner + Point2{0.0, levels[i].rows * cell};
        const Point2 east = levels[i].corner + Point2{levels[i].columns * cell, 0.0};
        painter.save();
        painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
        painter.drawImage(QRectF(screen(north), screen(east)),
                          m_colours.dark ? layer.dark[i] : layer.light[i]);
        painter.restore();
    }
}

void MapPainter::paintTint(QPainter& painter, const MapOverlay& overlay) const {
    if (!m_level) return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    if (overlay.coverage) paintCoverage(painter, *overlay.coverage);
    if (overlay.marks) paintMarked(painter, *overlay.marks);
    if (!overlay.fix) return;
    std::vector<std::pair<const RegionShape*, double>> tinted;
    for (const localisation::RegionVote& vote : overlay.fix->votes) {
        const RegionShape* shape = m_scene.shapeOf(vote.region);
        if (!shape || m_scene.building().regions()[shape->index].level != m_level->ordinal) continue;
        const double heat = std::clamp(vote.vote / overlay.fix->votes.front().vote, 0.0, 1.0);
        if (heat > 0.0) tinted.emplace_back(shape, heat);
    }
    std::sort(tinted.begin(), tinted.end()); // as the shapes lie: small ones on top
    const QTransform transform = m_view.painterTransform();
    for (const auto& [shape, heat] : tinted) {
        painter.setBrush(m_colours.heat(heat));
        painter.drawPath(transform.map(shape->path));
    }
}

void MapPainter::paintMarked(QPainter& painter, const std::vector<RegionMark>& marks) const {
    const QTransform transform = m_view.painterTransform();
    for (const std::size_t i : m_level->regionIndex.meeting(seen())) {
        const RegionShape& shape = m_level->regions[i];
        const RegionMark mark = shape.index < marks.size() ? marks[shape.index] : RegionMark::None;
        if (mark == RegionMark::None) continue;
        const RegionMarkStyle style = regionMarkStyle(mark, m_colours.dark);
        const QPainterPath path = transform.map(shape.path);
        painter.setBrush(withAlpha(style.colour, 45));
        painter.drawPath(path);
        painter.setBrush(QBrush(style.colour, style.pattern));
        painter.drawPath(path);
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

bool MapPainter::isHere(const RegionShape* shape) const {
    return shape && m_scene.building().regions()[shape->index].level == m_level->ordinal;
}

bool MapPainter::isHere(const TruePlace& truth) const {
    return std::abs(truth.level - m_level->ordinal) <= 0.5;
}

/// Above the name.
QRectF MapPainter::pinBox(const RegionId& region) const {
    const RegionShape* shape = m_scene.shapeOf(region);
    if (!isHere(shape)) return {};
    const QPointF foot = screen(shape->labelAt) - QPointF(0, 12);
    return {foot.x() - 12, foot.y() - 27, 24, 27};
}

void MapPainter::paintPin(QPainter& painter, const RegionId& region, const QColor& colour) const {
    const RegionShape* shape = m_scene.shapeOf(region);
    if (!isHere(shape)) return;
    paintOutline(painter, *shape, colour, Qt::DashLine);
    const QRectF box = pinBox(region);
    const QPointF foot(box.center().x(), box.bottom());
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

std::optional<QPointF> MapPainter::markAt(const MapOverlay& overlay) const {
    if (!overlay.fix) return std::nullopt;
    const localisation::Fix& fix = *overlay.fix;
    const RegionShape* shape = fix.region ? m_scene.shapeOf(*fix.region) : nullptr;
    if (fix.level && *fix.level != m_level->ordinal) return std::nullopt;
    if (fix.position) return screen(*fix.position);
    return isHere(shape) ? std::optional(screen(shape->labelAt)) : std::nullopt;
}

QPointF MapPainter::ahead(Radians heading) {
    return {std::cos(heading.value), -std::sin(heading.value)};
}

void MapPainter::paintPlaceMark(QPainter& painter, const MapOverlay& overlay) const {
    const localisation::Fix& fix = *overlay.fix;
    const bool sure = fix.confidence >= overlay.sureConfidence;
    const RegionShape* shape = fix.region ? m_scene.shapeOf(*fix.region) : nullptr;
    if (isHere(shape)) paintOutline(painter, *shape, m_colours.fix, sure ? Qt::SolidLine : Qt::DashLine);
    const auto mark = markAt(overlay);
    if (!mark) return;
    const QPointF at = *mark;
    if (fix.position && fix.sigmaM > 0.0) {
        const double radius = fix.sigmaM * m_view.pixelsPerMetre();
        painter.setPen(QPen(m_colours.fix, 1.2, Qt::DashLine));
        painter.setBrush(withAlpha(m_colours.fix, 40));
        painter.drawEllipse(at, radius, radius);
    }
    if (fix.heading) {
        const QPointF front = ahead(*fix.heading);
        const QPointF side(-front.y(), front.x());
        const QPointF foot = at + front * kArrowFoot;
        painter.setPen(QPen(m_colours.fixCasing, 1.5));
        painter.setBrush(m_colours.fix);
        painter.drawPolygon(QPolygonF{at + front * kArrowTip, foot + side * 7.0, foot - side * 7.0});
    }
    painter.setPen(QPen(m_colours.fixCasing, 2.5));
    painter.setBrush(fix.position ? m_colours.fix : m_colours.floor);
    painter.drawEllipse(at, kMarkRadius, kMarkRadius);
    if (!fix.position) { // only the place is known, not the spot
        painter.setPen(QPen(m_colours.fix, 3.0));
        painter.drawEllipse(at, 6.5, 6.5);
    }
    painter.setBrush(Qt::NoBrush);
}

/// A figure in a ring, unlike the dot of where Farol takes somebody to be.
void MapPainter::paintTruth(QPainter& painter, const TruePlace& truth) const {
    if (!isHere(truth)) return;
    const QPointF at = screen(truth.position);
    painter.setPen(QPen(m_colours.text, 2.0));
    painter.setBrush(m_colours.floor);
    painter.drawEllipse(at, kTruthRadius, kTruthRadius);
    paintGlyph(painter, pathOf(Glyph::Visitor), at, 17.0, m_colours.text);
}

void MapPainter::paintMarks(QPainter& painter, const MapOverlay& overlay,
                            const std::vector<PlacedName>& moved) const {
    if (!m_level) return;
    std::vector<PlacedName> below, above;
    for (const PlacedName& name : moved) (name.overMark ? above : below).push_back(name);
    paintNames(painter, below);
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
    if (overlay.truth) paintTruth(painter, *overlay.truth);
    paintNames(painter, above);
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

void MapPainter::paintScale(QPainter& painter) const {
    const double metres = roundMetres(std::max(1e-3, 140.0 / m_view.pixelsPerMetre()));
    const double length = metres * m_view.pixelsPerMetre();
    const QFontMetricsF metrics(m_font);
    const QString text = QStringLiteral("%1 m").arg(QLocale().toString(metres));
    const double width = std::max(length, metrics.horizontalAdvance(text)) + 20.0;
    const double height = metrics.height() + 14.0;
    const QRectF box(m_view.size().width() - width - 8.0, m_view.size().height() - height - 8.0, width,
                     height);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(m_colours.border, 1.0));
    painter.setBrush(m_colours.floor);
    painter.drawRoundedRect(box, 4, 4);
    painter.setFont(m_font);
    painter.setPen(m_colours.text);
    painter.drawText(box.adjusted(0, 2, 0, -10), Qt::AlignHCenter | Qt::AlignTop, text);
    const double y = box.bottom() - 6.0;
    const double left = box.center().x() - length / 2;
    painter.setPen(QPen(m_colours.text, 1.6));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(QPolygonF{QPointF(left, y - 5), QPointF(left, y), QPointF(left + length, y),
                                   QPointF(left + length, y - 5)});
}

void MapPainter::paintMoving(QPainter& painter, const MapHit& hit, Point2 by) const {
    const QPointF from = screen(positionOf(hit, m_scene));
    const QPointF to = screen(positionOf(hit, m_scene) + by);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(roundPen(m_colours.fix, 2.0, Qt::DotLine));
    painter.drawLine(from, to);
    painter.setPen(roundPen(m_colours.fix, 2.4));
    painter.drawRoundedRect(QRectF(to.x() - 12, to.y() - 12, 24, 24), 6, 6);
    painter.drawLine(to - QPointF(5, 0), to + QPointF(5, 0));
    painter.drawLine(to - QPointF(0, 5), to + QPointF(0, 5));
}

} // namespace farol::ui
