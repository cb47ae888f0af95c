#pragma once
// The floor map: zoom and pan by mouse and keyboard, hover and selection. It shows; it decides nothing.

#include "ui/map/hit_detector.h"
#include "ui/map/map_overlay.h"
#include "ui/map/map_scene.h"
#include "ui/map/view_transform.h"

#include <QPixmap>
#include <QWidget>

#include <functional>
#include <optional>

namespace farol::ui {

class MapView : public QWidget {
    Q_OBJECT

public:
    explicit MapView(QWidget* parent = nullptr);

    void setBuilding(const std::shared_ptr<const building::Building>& building); ///< null: an empty map
    const MapScene* scene() const { return m_scene.get(); }
    void setOverlay(const MapOverlay& overlay);
    const MapOverlay& overlay() const { return m_overlay; }
    void setLevel(double ordinal);
    double level() const { return m_level; }
    void fit();
    void zoom(double factor); ///< around the middle
    const ViewTransform& viewTransform() const { return m_view; }
    void setViewTransform(const ViewTransform& view);
    void select(const std::optional<MapHit>& hit, bool centre);
    const std::optional<MapHit>& selected() const { return m_selected; }
    /// Words for a thing, shown when the pointer rests on it; without, its name alone.
    void setDescriber(std::function<QString(const MapHit&)> describe) { m_describe = std::move(describe); }

    QSize sizeHint() const override { return {560, 420}; }
    QSize minimumSizeHint() const override { return {240, 180}; }

Q_SIGNALS:
    void levelChanged(double ordinal);
    void selectionChanged(const std::optional<farol::ui::MapHit>& hit);
    void activated(const farol::ui::MapHit& hit); ///< double click or Return
    void menuWanted(const farol::ui::MapHit& hit, const QPoint& globalPosition);
    void movedByHand(); ///< the user panned or zoomed

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;

private:
    void renderCache();
    void dropCache();
    void stepLevel(int by);
    std::optional<MapHit> hit(QPointF screen) const;

    std::unique_ptr<MapScene> m_scene;
    MapOverlay m_overlay;
    double m_level = 0.0;
    ViewTransform m_view;
    bool m_fitted = true; ///< keep showing all on a resize, until the user moves the map
    QPixmap m_ground, m_furnishing, m_names;
    std::optional<MapHit> m_hovered, m_selected;
    std::optional<QPointF> m_pressedAt;
    bool m_dragging = false;
    std::function<QString(const MapHit&)> m_describe;
};

} // namespace farol::ui
