#include "ui/map/map_view.h"

#include "ui/convert/convert.h"
#include "ui/convert/kind_style.h"
#include "ui/map/map_painter.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace farol::ui {

namespace {

constexpr double kZoomStep = 1.25;
constexpr double kPanStepPx = 48.0;
constexpr double kFitMarginPx = 34.0;
constexpr double kLegendPx = 26.0; // at the lower edge, beside that margin
constexpr std::size_t kLargeFrom =
    1200; // regions and doors of a level; drawing fewer takes a few milliseconds

} // namespace

MapView::MapView(QWidget* parent) : QWidget(parent), m_background(this) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void MapView::setBuilding(const std::shared_ptr<const building::Building>& building) {
    setScene(building ? std::make_shared<const MapScene>(building) : nullptr);
    m_overlay = {};
    m_selected.reset();
    m_pictureVersion = 0; // of another building: not even for a moment
    if (m_scene && !m_scene->levels().empty() && !m_scene->level(m_level))
        m_level = m_scene->levels().front().ordinal;
    fit();
    Q_EMIT levelChanged(m_level);
}

void MapView::setScene(std::shared_ptr<const MapScene> scene) {
    m_scene = std::move(scene);
    m_hovered.reset();
    m_grip.reset();
    m_pressedAt.reset();
    m_dragging = false;
    dropCache();
}

void MapView::replaceBuilding(const std::shared_ptr<const building::Building>& building) {
    if (!building || !m_scene) return setBuilding(building);
    setScene(std::make_shared<const MapScene>(building));
    if (m_selected) {
        const std::size_t count = m_selected->what == MapHit::What::Region   ? building->regions().size()
                                  : m_selected->what == MapHit::What::Access ? building->accesses().size()
                                                                             : building->landmarks().size();
        if (m_selected->index >= count) select(std::nullopt, false);
    }
    if (!m_scene->levels().empty() && !m_scene->level(m_level)) setLevel(m_scene->levels().front().ordinal);
}

void MapView::setStyle(const MapStyle& style) {
    if (style == m_style) return;
    m_style = style;
    dropCache();
}

void MapView::setTool(Tool tool) {
    m_tool = tool;
    m_grip.reset();
    setCursor(tool == Tool::Place ? Qt::CrossCursor : Qt::ArrowCursor);
    update();
}

void MapView::setOverlay(const MapOverlay& overlay) {
    m_overlay = overlay;
    update();
}

void MapView::setLevel(double ordinal) {
    if (ordinal == m_level || !m_scene || !m_scene->level(ordinal)) return;
    m_level = ordinal;
    m_hovered.reset();
    if (m_fitted) fit();
    update();
    Q_EMIT levelChanged(m_level);
}

void MapView::fit() {
    m_fitted = true;
    const LevelScene* level = m_scene ? m_scene->level(m_level) : nullptr;
    if (!level) return setViewTransform(ViewTransform({}, 20.0, size()));
    const QSizeF above(width(), std::max(1.0, height() - kLegendPx)); // nothing lies under the legend
    const ViewTransform whole = ViewTransform::fitted(level->bounds, above, kFitMarginPx);
    const Point2 down{0.0, kLegendPx / 2 / whole.pixelsPerMetre()};
    setViewTransform(ViewTransform(whole.centre() - down, whole.pixelsPerMetre(), size()));
}

void MapView::zoom(double factor) {
    m_fitted = false;
    setViewTransform(m_view.zoomedAt(QRectF(rect()).center(), factor));
    Q_EMIT movedByHand();
}

void MapView::setViewTransform(const ViewTransform& view) {
    m_view = view;
    update();
}

void MapView::select(const std::optional<MapHit>& hit, bool centre) {
    if (hit && m_scene) {
        setLevel(levelOf(*hit, m_scene->building()));
        const Point2 at = positionOf(*hit, *m_scene);
        if (centre && !QRectF(rect()).adjusted(30, 30, -30, -30).contains(m_view.screenFromMap(at))) {
            m_fitted = false;
            setViewTransform(withSurroundings(at));
        }
    }
    if (hit == m_selected) return;
    m_selected = hit;
    update();
    Q_EMIT selectionChanged(hit);
}

/// What lies outside the floor is shown together with it, so that one sees where it is.
ViewTransform MapView::withSurroundings(Point2 at) const {
    const LevelScene* level = m_scene->level(m_level);
    Box2 box = level ? level->bounds : Box2{at, at};
    const bool inside = at.x >= box.low.x && at.x <= box.high.x && at.y >= box.low.y && at.y <= box.high.y;
    if (inside) return m_view.centredOn(at);
    box.low = {std::min(box.low.x, at.x), std::min(box.low.y, at.y)};
    box.high = {std::max(box.high.x, at.x), std::max(box.high.y, at.y)};
    return ViewTransform::fitted(box, size(), kFitMarginPx);
}

std::optional<MapHit> MapView::hit(QPointF screen) const {
    return m_scene ? hitAt(screen, *m_scene, m_level, m_view) : std::nullopt;
}

void MapView::dropCache() {
    ++m_version;
    update();
}

bool MapView::isLarge() const {
    const LevelScene* level = m_scene->level(m_level);
    return level && level->regions.size() + level->accesses.size() + level->walls.size() / 4 > kLargeFrom;
}

MapView::Order MapView::order() const {
    return {m_scene,  m_level, m_view, isDark(palette()), font(), m_style, size(), devicePixelRatioF(),
            m_version};
}

MapView::Picture MapView::draw(const Order& order) {
    const MapColours colours = MapColours::of(order.dark);
    const MapPainter map(*order.scene, order.level, order.view, colours, order.font, order.style);
    const auto layer = [&](QImage::Format format, const auto& paint) {
        QImage image(order.size * order.ratio, format);
        image.setDevicePixelRatio(order.ratio);
        image.fill(Qt::transparent);
        QPainter painter(&image);
        paint(painter);
        return image;
    };
    std::vector<PlacedName> placed = map.placedNames();
    QImage names = layer(QImage::Format_ARGB32_Premultiplied,
                         [&](QPainter& painter) { map.paintNames(painter, placed); });
    return {
        layer(QImage::Format_RGB32, [&](QPainter& painter) { map.paintGround(painter); }),
        layer(QImage::Format_ARGB32_Premultiplied, [&](QPainter& painter) { map.paintFurnishing(painter); }),
        std::move(names),
        std::move(placed),
        order.view,
        order.level,
        order.version};
}

void MapView::take(Picture picture) {
    m_ground = QPixmap::fromImage(std::move(picture.ground));
    m_furnishing = QPixmap::fromImage(std::move(picture.furnishing));
    m_names = QPixmap::fromImage(std::move(picture.names));
    m_placedNames = std::move(picture.placedNames);
    m_pictureView = picture.view;
    m_pictureLevel = picture.level;
    m_pictureVersion = picture.version;
}

/// Small floors are drawn at once. Large ones are drawn on another thread, while the old picture is moved and
/// stretched to where the view is now: the window never waits.
void MapView::refreshPicture() {
    if (settled() || m_drawing) return;
    if (!isLarge()) return take(draw(order()));
    m_drawing = true;
    m_background.run([order = order()] { return draw(order); },
                     [this](Picture picture) {
                         m_drawing = false;
                         take(std::move(picture));
                         update();
                     });
}

bool MapView::settled() const {
    return !m_scene ||
           (m_pictureVersion == m_version && m_pictureView == m_view && m_pictureLevel == m_level);
}

void MapView::paintPicture(QPainter& painter, const QPixmap& picture) const {
    if (m_pictureView == m_view) return painter.drawPixmap(0, 0, picture);
    const double scale = m_view.pixelsPerMetre() / m_pictureView.pixelsPerMetre();
    const QPointF corner = m_view.screenFromMap(m_pictureView.mapFromScreen({0.0, 0.0}));
    painter.save();
    painter.translate(corner);
    painter.scale(scale, scale);
    painter.drawPixmap(0, 0, picture);
    painter.restore();
}

/// All but those that have moved.
void MapView::paintNames(QPainter& painter, const std::vector<PlacedName>& moved) const {
    constexpr double kHalo = 2.0;
    QRegion rest(rect());
    for (const PlacedName& name : moved)
        rest -= name.home.adjusted(-kHalo, -kHalo, kHalo, kHalo).toAlignedRect();
    painter.save();
    if (!moved.empty()) painter.setClipRegion(rest);
    paintPicture(painter, m_names);
    painter.restore();
}

void MapView::paintMap(QPainter& painter) {
    const MapColours colours = MapColours::of(isDark(palette()));
    const MapPainter map(*m_scene, m_level, m_view, colours, font(), m_style);
    const bool usable = m_pictureVersion != 0 && m_pictureLevel == m_level;
    painter.fillRect(rect(), colours.outside);
    if (usable) paintPicture(painter, m_ground);
    map.paintPictures(painter, m_overlay);
    map.paintTint(painter, m_overlay);
    if (usable) paintPicture(painter, m_furnishing);
    map.paintRoute(painter, m_overlay);
    // While the view moves, the names are those of the old picture.
    std::vector<PlacedName> moved;
    if (usable && m_pictureView == m_view) moved = map.movedAside(m_placedNames, m_overlay);
    if (usable) paintNames(painter, moved);
    map.paintMarks(painter, m_overlay, moved);
    if (m_hovered) map.paintSelection(painter, *m_hovered, false);
    if (m_selected) map.paintSelection(painter, *m_selected, true);
    if (m_grip && m_dragging && m_selected) map.paintMoving(painter, *m_selected, m_movedBy);
    if (m_style.likelihood) map.paintLegend(painter, tr("Less likely"), tr("More likely"));
    if (m_style.scale) map.paintScale(painter);
}

/// Where Return would put the new thing.
void MapView::paintCross(QPainter& painter) const {
    const QPointF middle = QRectF(rect()).center();
    const MapColours colours = MapColours::of(isDark(palette()));
    for (const QPen& pen : {QPen(colours.halo, 6), QPen(colours.fix, 2)}) { // on a picture of any colour
        painter.setPen(pen);
        painter.drawLine(middle - QPointF(14, 0), middle + QPointF(14, 0));
        painter.drawLine(middle - QPointF(0, 14), middle + QPointF(0, 14));
    }
}

void MapView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    if (!m_scene) {
        const MapColours colours = MapColours::of(isDark(palette()));
        painter.fillRect(rect(), colours.outside);
        painter.setPen(colours.text);
        painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("No map is open.\nOpen one with Ctrl+O."));
        return;
    }
    refreshPicture();
    paintMap(painter);
    if (m_tool == Tool::Place) paintCross(painter);
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

void MapView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (m_fitted)
        fit();
    else
        setViewTransform(m_view.resized(size()));
}

void MapView::wheelEvent(QWheelEvent* event) {
    m_fitted = false;
    setViewTransform(
        m_view.zoomedAt(event->position(), std::pow(kZoomStep, event->angleDelta().y() / 120.0)));
    Q_EMIT movedByHand();
    event->accept();
}

void MapView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
    m_pressedAt = event->position();
    m_dragging = false;
    // Only what is selected already can be dragged: nothing moves by a slip of the hand.
    const std::optional<MapHit> under = m_tool == Tool::Move ? hit(event->position()) : std::nullopt;
    if (under && under == m_selected && under->what != MapHit::What::Region)
        m_grip = m_view.mapFromScreen(event->position());
}

/// True when the pointer holds the selected thing rather than the map.
bool MapView::dragSelected(QPointF at) {
    if (!m_grip) return false;
    m_movedBy = m_view.mapFromScreen(at) - *m_grip;
    update();
    return true;
}

void MapView::mouseMoveEvent(QMouseEvent* event) {
    if (m_pressedAt) {
        const QPointF delta = event->position() - *m_pressedAt;
        if (!m_dragging && std::hypot(delta.x(), delta.y()) < 4.0) return;
        m_dragging = true;
        if (dragSelected(event->position())) return;
        m_fitted = false;
        setCursor(Qt::ClosedHandCursor);
        m_pressedAt = event->position();
        setViewTransform(m_view.panned(delta));
        Q_EMIT movedByHand();
        return;
    }
    const std::optional<MapHit> now = hit(event->position());
    if (now == m_hovered) return;
    m_hovered = now;
    update();
}

void MapView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !m_pressedAt) return QWidget::mouseReleaseEvent(event);
    const bool dragged = m_dragging;
    const bool moved = dragged && m_grip && m_selected;
    m_pressedAt.reset();
    m_grip.reset();
    m_dragging = false;
    setCursor(m_tool == Tool::Place ? Qt::CrossCursor : Qt::ArrowCursor);
    update();
    if (moved)
        Q_EMIT moveWanted(*m_selected, m_movedBy, false);
    else if (!dragged && m_tool == Tool::Place)
        Q_EMIT placeWanted(m_view.mapFromScreen(event->position()));
    else if (!dragged)
        select(hit(event->position()), false);
}

void MapView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (const auto found = hit(event->position())) Q_EMIT activated(*found);
}

void MapView::contextMenuEvent(QContextMenuEvent* event) {
    const bool byMouse = event->reason() == QContextMenuEvent::Mouse;
    const std::optional<MapHit> found = byMouse ? hit(event->pos()) : m_selected;
    if (!found) return;
    select(found, false);
    const QPoint at = byMouse ? event->globalPos()
                              : mapToGlobal(m_view.screenFromMap(positionOf(*found, *m_scene)).toPoint());
    Q_EMIT menuWanted(*found, at);
}

void MapView::stepLevel(int by) {
    if (!m_scene) return;
    const auto& levels = m_scene->levels();
    for (std::size_t i = 0; i < levels.size(); ++i) {
        if (levels[i].ordinal != m_level) continue;
        const auto next = static_cast<std::ptrdiff_t>(i) + by;
        if (next < 0 || next >= static_cast<std::ptrdiff_t>(levels.size())) return;
        setLevel(levels[static_cast<std::size_t>(next)].ordinal);
        Q_EMIT movedByHand();
        return;
    }
}

/// Alt and an arrow move the selected thing by 10 cm, with Shift by 1 m.
bool MapView::nudge(const QKeyEvent& event) {
    if (m_tool != Tool::Move || !m_selected || m_selected->what == MapHit::What::Region) return false;
    if (!event.modifiers().testFlag(Qt::AltModifier)) return false;
    const double step = event.modifiers().testFlag(Qt::ShiftModifier) ? 1.0 : 0.1;
    Point2 by;
    if (event.key() == Qt::Key_Left) by.x = -step;
    if (event.key() == Qt::Key_Right) by.x = step;
    if (event.key() == Qt::Key_Up) by.y = step;
    if (event.key() == Qt::Key_Down) by.y = -step;
    if (by == Point2{}) return false;
    Q_EMIT moveWanted(*m_selected, by, true);
    return true;
}

void MapView::keyPressEvent(QKeyEvent* event) {
    if (nudge(*event)) return;
    const auto pan = [this](double dx, double dy) {
        m_fitted = false;
        setViewTransform(m_view.panned({dx, dy}));
        Q_EMIT movedByHand();
    };
    switch (event->key()) {
    case Qt::Key_Left:
        return pan(kPanStepPx, 0);
    case Qt::Key_Right:
        return pan(-kPanStepPx, 0);
    case Qt::Key_Up:
        return pan(0, kPanStepPx);
    case Qt::Key_Down:
        return pan(0, -kPanStepPx);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return zoom(kZoomStep);
    case Qt::Key_Minus:
        return zoom(1.0 / kZoomStep);
    case Qt::Key_0:
    case Qt::Key_Home:
        return fit();
    case Qt::Key_PageUp:
        return stepLevel(1);
    case Qt::Key_PageDown:
        return stepLevel(-1);
    case Qt::Key_Escape:
        if (m_grip) { // the drag under way is given up
            m_grip.reset();
            m_pressedAt.reset();
            m_dragging = false;
            return update();
        }
        if (m_tool == Tool::Place) return void(Q_EMIT placeGivenUp());
        if (m_selected) return select(std::nullopt, false);
        break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (m_tool == Tool::Place)
            return void(Q_EMIT placeWanted(m_view.mapFromScreen(QRectF(rect()).center())));
        if (m_selected) Q_EMIT activated(*m_selected);
        return;
    default:
        break;
    }
    QWidget::keyPressEvent(event);
}

void MapView::leaveEvent(QEvent* event) {
    m_hovered.reset();
    update();
    QWidget::leaveEvent(event);
}

void MapView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) dropCache();
    if (event->type() == QEvent::LanguageChange) update();
    QWidget::changeEvent(event);
}

bool MapView::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const std::optional<MapHit> found = hit(help->pos());
        if (found && m_describe)
            QToolTip::showText(help->globalPos(), m_describe(*found), this);
        else
            QToolTip::showText(help->globalPos(), toolTip(), this);
        return true;
    }
    return QWidget::event(event);
}

} // namespace farol::ui
