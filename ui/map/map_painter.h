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
               QFont font, MapStyle style = {});

    void paintGround(QPainter& painter) const;                              ///< floors
    void paintPictures(QPainter& painter, const MapOverlay& overlay) const; ///< of the floor, under the map
    void paintTint(QPainter& painter, const MapOverlay& overlay) const;
    void paintFurnishing(QPainter& painter) const; ///< borders, walls, accesses, landmarks
    void paintRoute(QPainter& painter, const MapOverlay& overlay) const;
    void paintNames(QPainter& painter) const; ///< above the route, which runs along the middle of corridors
    void paintMarks(QPainter& painter, const MapOverlay& overlay) const; ///< destination, where one is
    void paintSelection(QPainter& painter, const MapHit& hit, bool strong) const;
    /// A few words and a scale in the lower left corner.
    void paintLegend(QPainter& painter, const QString& unlikely, const QString& likely) const;
    /// A bar of a round number of metres in the lower right corner.
    void paintScale(QPainter& painter) const;
    /// A thing on its way to another spot.
    void paintMoving(QPainter& painter, const MapHit& hit, Point2 by) const;

private:
    void paintCoverage(QPainter& painter, const CoverageLayer& layer) const;
    void paintMarked(QPainter& painter, const std::vector<RegionMark>& marks) const;
    void paintAccess(QPainter& painter, const AccessShape& shape) const;
    void paintLandmark(QPainter& painter, const building::Landmark& landmark) const;
    void paintOutline(QPainter& painter, const RegionShape& shape, const QColor& colour,
                      Qt::PenStyle style) const;
    void paintArrows(QPainter& painter, const QPolygonF& line) const;
    void paintPlaceMark(QPainter& painter, const MapOverlay& overlay) const;
    void paintTruth(QPainter& painter, const TruePlace& truth) const;
    void paintPin(QPainter& painter, const RegionId& region, const QColor& colour) const;
    void paintText(QPainter& painter, QPointF centre, const QString& text, bool upright) const;
    bool paintName(QPainter& painter, const RegionShape& shape, const QString& name,
                   std::vector<QRectF>& taken) const;
    std::vector<QRectF> symbolBoxes() const;
    bool accessHasSymbol(const AccessShape& shape) const;
    double symbolSize() const;
    QPointF screen(Point2 p) const { return m_view.screenFromMap(p); }
    Box2 seen() const; ///< what of the map the picture shows, and a little more

    const MapScene& m_scene;
    const LevelScene* m_level;
    const ViewTransform& m_view;
    const MapColours& m_colours;
    QFont m_font;
    MapStyle m_style;
};

} // namespace farol::ui
