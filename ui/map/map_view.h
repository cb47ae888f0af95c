#pragma once
// The floor map: zoom and pan by mouse and keyboard, hover and selection. It shows; it decides nothing.

#include "ui/convert/background.h"
#include "ui/map/hit_detector.h"
#include "ui/map/map_overlay.h"
#include "ui/map/map_painter.h"
#include "ui/map/map_scene.h"
#include "ui/map/view_transform.h"

#include <QImage>
#include <QPixmap>
#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

namespace farol::ui {

class MapView : public QWidget {
    Q_OBJECT

public:
    explicit MapView(QWidget* parent = nullptr);

    void setBuilding(const std::shared_ptr<const building::Building>& building); ///< null: an empty map
    /// The same building after an edit: level, view and overlay stay. The selection stays where it still
    /// means a thing.
    void replaceBuilding(const std::shared_ptr<const building::Building>& building);
    const MapScene* scene() const { return m_scene.get(); }
    void setStyle(const MapStyle& style);
    /// What the user may change with the pointer and the keys: nothing, the selected thing's place, or a
    /// new spot.
    enum class Tool { Look, Move, Place };
    void setTool(Tool tool);
    Tool tool() const { return m_tool; }
    void setOverlay(const MapOverlay& overlay);
    const MapOverlay& overlay() const { return m_overlay; }
    void setLevel(double ordinal);
    double level() const { return m_level; }
    /// Is what is shown drawn for the view as it is?
    bool settled() const;
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
    void moveWanted(const farol::ui::MapHit& hit, farol::Point2 by, bool byKey);
    void placeWanted(farol::Point2 at); ///< where the new thing shall stand
    void placeGivenUp();

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
    /// The still parts of the map as pictures, for one level and one view.
    struct Picture {
        QImage ground, furnishing, names;
        std::vector<PlacedName> placedNames;
        ViewTransform view;
        double level = 0.0;
        std::uint64_t version = 0; ///< of what was drawn
    };
    struct Order { ///< what a picture is made from, on any thread
        std::shared_ptr<const MapScene> scene;
        double level;
        ViewTransform view;
        bool dark;
        QFont font;
        MapStyle style;
        QSize size;
        double ratio;
        std::uint64_t version;
    };
    static Picture draw(const Order& order);
    Order order() const;
    bool isLarge() const; ///< so large that drawing it would be felt
    void refreshPicture();
    void take(Picture picture);
    void paintPicture(QPainter& painter, const QPixmap& picture) const;
    void paintNames(QPainter& painter, const std::vector<PlacedName>& moved) const;
    void paintMap(QPainter& painter);
    void paintCross(QPainter& painter) const;
    void setScene(std::shared_ptr<const MapScene> scene);
    ViewTransform withSurroundings(Point2 at) const;
    void dropCache();
    bool dragSelected(QPointF at);
    bool nudge(const QKeyEvent& event);
    void stepLevel(int by);
    std::optional<MapHit> hit(QPointF screen) const;

    std::shared_ptr<const MapScene> m_scene;
    MapStyle m_style;
    Tool m_tool = Tool::Look;
    MapOverlay m_overlay;
    double m_level = 0.0;
    ViewTransform m_view;
    bool m_fitted = true; ///< keep showing all on a resize, until the user moves the map
    QPixmap m_ground, m_furnishing, m_names;
    std::vector<PlacedName> m_placedNames;
    ViewTransform m_pictureView; ///< of the pictures
    double m_pictureLevel = 0.0;
    std::uint64_t m_version = 1, m_pictureVersion = 0;
    bool m_drawing = false; ///< a picture is being made on another thread
    std::optional<MapHit> m_hovered, m_selected;
    std::optional<QPointF> m_pressedAt;
    bool m_dragging = false;
    std::optional<Point2> m_grip; ///< where the selected thing was taken hold of, in the map
    Point2 m_movedBy;
    std::function<QString(const MapHit&)> m_describe;
    Background m_background; ///< last: its jobs use the rest
};

} // namespace farol::ui
