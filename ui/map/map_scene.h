#pragma once
// A building prepared for drawing: one set of shapes in metres for each level.

#include "core/building/box_index.h"
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
    QString brief; ///< the number on the door, where the whole name finds no room; may be empty
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
    std::vector<std::size_t> walls; ///< in BuildingData::walls
    Box2 bounds;
    building::BoxIndex regionIndex, accessIndex, landmarkIndex, wallIndex; ///< of the lists above
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
    void finishLevel(LevelScene& level);

    struct Home {
        std::size_t level = 0, shape = 0;
    };

    std::shared_ptr<const building::Building> m_building;
    std::vector<LevelScene> m_levels;
    std::vector<Home> m_homes; ///< of each region
};

} // namespace farol::ui
