#pragma once
// Draws a level: the parts that stay (cached pictures below and above the tint, and the
// names) and the light ones that change.

#include "ui/map/hit_detector.h"
#include "ui/map/map_colours.h"
#include "ui/map/map_overlay.h"
#include "ui/map/map_scene.h"
#include "ui/map/view_transform.h"

#include <QFont>
#include <QRectF>
#include <QString>

#include <optional>
#include <vector>

class QPainter;

namespace farol::ui {

/// A region's name as it stands on the picture.
struct PlacedName {
    std::size_t shape = 0; ///< among the regions of the level
    QString text;
    QPointF centre;
    bool upright = false;
    QRectF box;
    QRectF home;           ///< of a name that has moved: its box before
    bool overMark = false; ///< there is no room beside the mark: painted after it
};

class MapPainter {
public:
    MapPainter(const MapScene& scene, double level, const ViewTransform& view, const MapColours& colours,
               QFont font, MapStyle style = {});

    void paintGround(QPainter& painter) const;                              ///< floors
    void paintPictures(QPainter& painter, const MapOverlay& overlay) const; ///< of the floor, under the map
    void paintTint(QPainter& painter, const MapOverlay& overlay) const;
    void paintFurnishing(QPainter& painter) const; ///< borders, walls, accesses, landmarks
    void paintRoute(QPainter& painter, const MapOverlay& overlay) const;
    /// Where the names stand, each clear of the symbols and of the others.
    std::vector<PlacedName> placedNames() const;
    /// Above the route, which runs along the middle of corridors.
    void paintNames(QPainter& painter, const std::vector<PlacedName>& names) const;
    /// Those of the names that paintMarks() would paint over, where they can be read beside the marks.
    std::vector<PlacedName> movedAside(const std::vector<PlacedName>& names, const MapOverlay& overlay) const;
    /// The marks, and the moved names below or above them.
    void paintMarks(QPainter& painter, const MapOverlay& overlay, const std::vector<PlacedName>& moved) const;
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
    std::optional<PlacedName> placedName(std::size_t shape, const QString& name,
                                         const std::vector<QRectF>& taken) const;
    std::vector<QRectF> symbolBoxes() const;
    std::vector<QRectF> markBoxes(const MapOverlay& overlay) const;
    QRectF pinBox(const RegionId& region) const; ///< null: it is on another level
    /// Empty: the mark of where one is stands on another level.
    std::optional<QPointF> markAt(const MapOverlay& overlay) const;
    bool isHere(const RegionShape* shape) const;
    bool isHere(const TruePlace& truth) const;
    bool accessHasSymbol(const AccessShape& shape) const;
    double symbolSize() const;
    static constexpr double kMarkRadius = 8.0, kTruthRadius = 11.0;
    static constexpr double kArrowTip = 20.0, kArrowFoot = 7.0;
    static QPointF ahead(Radians heading); ///< of length 1, on the screen
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
