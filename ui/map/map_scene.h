#pragma once
// A building prepared for drawing: one set of shapes in metres for each level.

#include "core/building/building.h"

#include <QPainterPath>

#include <memory>
#include <optional>
#include <vector>

namespace farol::ui {

struct RegionShape {
    std::size_t index = 0; ///< in Building::regions()
    QPainterPath path;     ///< metres, y north
    QRectF bounds;
    Point2 labelAt; ///< surely inside
    QString label;
};

struct AccessShape {
    std::size_t index = 0;
    Polyline line;
    Point2 middle;
};

struct LevelScene {
    double ordinal = 0.0;
    std::vector<RegionShape> regions; ///< largest first, so that small ones lie on top
    std::vector<AccessShape> accesses;
    std::vector<std::size_t> landmarks;
    QPainterPath walls;
    Box2 bounds;
};

/// Built once per building; never changed afterwards. Stairs and lifts are drawn on both of the levels they
/// join.
class MapScene {
public:
    explicit MapScene(std::shared_ptr<const building::Building> building);

    const building::Building& building() const { return *m_building; }
    const std::vector<LevelScene>& levels() const { return m_levels; } ///< by ordinal
    const LevelScene* level(double ordinal) const;
    const RegionShape* shapeOf(const RegionId& id) const; ///< nullptr when unknown

private:
    LevelScene& levelFor(double ordinal);
    void addRegions();
    void addAccesses();

    std::shared_ptr<const building::Building> m_building;
    std::vector<LevelScene> m_levels;
};

} // namespace farol::ui
