#pragma once
// Draws a level: the parts that stay (cached pictures below and above the tint, and the
// names) and the light ones that change.

#include "ui/map/hit_detector.h"
#include "ui/map/map_colours.h"
#include "ui/map/map_overlay.h"
#include "ui/map/map_scene.h"
#include "ui/map/view_transform.h"

#include <QFont>

class QPainter;

namespace farol::ui {

class MapPainter {
public:
    MapPainter(const MapScene& scene, double level, const ViewTransform& view, const MapColours& colours,
               QFont font);

    void paintGround(QPainter& painter) const; ///< floors
    void paintTint(QPainter& painter, const MapOverlay& overlay) const;
    void paintFurnishing(QPainter& painter) const; ///< borders, walls, accesses, landmarks
    void paintRoute(QPainter& painter, const MapOverlay& overlay) const;
    void paintNames(QPainter& painter) const; ///< above the route, which runs along the middle of corridors
    void paintMarks(QPainter& painter, const MapOverlay& overlay) const; ///< destination, where one is
    void paintSelection(QPainter& painter, const MapHit& hit, bool strong) const;
    /// A few words and a scale in the lower left corner.
    void paintLegend(QPainter& painter, const QString& unlikely, const QString& likely) const;

private:
    void paintAccess(QPainter& painter, const AccessShape& shape) const;
    void paintLandmark(QPainter& painter, const building::Landmark& landmark) const;
    void paintOutline(QPainter& painter, const RegionShape& shape, const QColor& colour,
                      Qt::PenStyle style) const;
    void paintArrows(QPainter& painter, const QPolygonF& line) const;
    void paintPlaceMark(QPainter& painter, const MapOverlay& overlay) const;
    void paintPin(QPainter& painter, const RegionId& region, const QColor& colour) const;
    void paintText(QPainter& painter, QPointF centre, const QString& text, bool upright) const;
    double symbolSize() const;
    QPointF screen(Point2 p) const { return m_view.screenFromMap(p); }

    const MapScene& m_scene;
    const LevelScene* m_level;
    const ViewTransform& m_view;
    const MapColours& m_colours;
    QFont m_font;
};

} // namespace farol::ui
