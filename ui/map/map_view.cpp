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

#include <cmath>

namespace farol::ui {

namespace {

constexpr double kZoomStep = 1.25;
constexpr double kPanStepPx = 48.0;
constexpr double kFitMarginPx = 34.0;

} // namespace

MapView::MapView(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void MapView::setBuilding(const std::shared_ptr<const building::Building>& building) {
    m_scene = building ? std::make_unique<MapScene>(building) : nullptr;
    m_overlay = {};
    m_hovered.reset();
    m_selected.reset();
    if (m_scene && !m_scene->levels().empty() && !m_scene->level(m_level))
        m_level = m_scene->levels().front().ordinal;
    fit();
    Q_EMIT levelChanged(m_level);
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
    dropCache();
    Q_EMIT levelChanged(m_level);
}

void MapView::fit() {
    m_fitted = true;
    const LevelScene* level = m_scene ? m_scene->level(m_level) : nullptr;
    setViewTransform(level ? ViewTransform::fitted(level->bounds, size(), kFitMarginPx)
                           : ViewTransform({}, 20.0, size()));
}

void MapView::zoom(double factor) {
    m_fitted = false;
    setViewTransform(m_view.zoomedAt(QRectF(rect()).center(), factor));
    Q_EMIT movedByHand();
}

void MapView::setViewTransform(const ViewTransform& view) {
    m_view = view;
    dropCache();
}

void MapView::select(const std::optional<MapHit>& hit, bool centre) {
    if (hit && m_scene) {
        setLevel(levelOf(*hit, m_scene->building()));
        const Point2 at = positionOf(*hit, *m_scene);
        if (centre && !QRectF(rect()).adjusted(30, 30, -30, -30).contains(m_view.screenFromMap(at))) {
            m_fitted = false;
            setViewTransform(m_view.centredOn(at));
        }
    }
    if (hit == m_selected) return;
    m_selected = hit;
    update();
    Q_EMIT selectionChanged(hit);
}

std::optional<MapHit> MapView::hit(QPointF screen) const {
    return m_scene ? hitAt(screen, *m_scene, m_level, m_view) : std::nullopt;
}

void MapView::dropCache() {
    m_ground = QPixmap();
    m_furnishing = QPixmap();
    m_names = QPixmap();
    update();
}

void MapView::renderCache() {
    const double ratio = devicePixelRatioF();
    const MapColours colours = MapColours::of(isDark(palette()));
    const MapPainter map(*m_scene, m_level, m_view, colours, font());
    const auto fresh = [&] {
        QPixmap pixmap(size() * ratio);
        pixmap.setDevicePixelRatio(ratio);
        pixmap.fill(Qt::transparent);
        return pixmap;
    };
    m_ground = fresh();
    QPainter ground(&m_ground);
    map.paintGround(ground);
    ground.end();
    m_furnishing = fresh();
    QPainter furnishing(&m_furnishing);
    map.paintFurnishing(furnishing);
    furnishing.end();
    m_names = fresh();
    QPainter names(&m_names);
    map.paintNames(names);
}

void MapView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const MapColours colours = MapColours::of(isDark(palette()));
    if (!m_scene) {
        painter.fillRect(rect(), colours.outside);
        painter.setPen(colours.text);
        painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("No map is open.\nOpen one with Ctrl+O."));
        return;
    }
    if (m_ground.isNull()) renderCache();
    const MapPainter map(*m_scene, m_level, m_view, colours, font());
    painter.drawPixmap(0, 0, m_ground);
    map.paintTint(painter, m_overlay);
    painter.drawPixmap(0, 0, m_furnishing);
    map.paintRoute(painter, m_overlay);
    painter.drawPixmap(0, 0, m_names);
    map.paintMarks(painter, m_overlay);
    if (m_hovered) map.paintSelection(painter, *m_hovered, false);
    if (m_selected) map.paintSelection(painter, *m_selected, true);
    map.paintLegend(painter, tr("Less likely"), tr("More likely"));
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
}

void MapView::mouseMoveEvent(QMouseEvent* event) {
    if (m_pressedAt) {
        const QPointF delta = event->position() - *m_pressedAt;
        if (!m_dragging && std::hypot(delta.x(), delta.y()) < 4.0) return;
        m_dragging = true;
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
    if (!m_dragging) select(hit(event->position()), false);
    m_pressedAt.reset();
    m_dragging = false;
    unsetCursor();
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

void MapView::keyPressEvent(QKeyEvent* event) {
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
        if (m_selected) return select(std::nullopt, false);
        break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
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
