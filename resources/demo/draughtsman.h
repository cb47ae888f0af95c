#pragma once
// What the demo building is drawn with: rooms as boxes, doors on their walls, things on the walls beside
// them.

#include "core/building/building.h"

#include <string>
#include <tuple>

namespace farol::demo {

struct Box {
    double west, south, east, north;
};

struct Names {
    std::string english, portuguese, ref{};
};

struct Thing {
    Kind kind;
    std::string templateId, text;
    double middleM, wideM, tallM; ///< height of its middle above the floor, and its size
};

class Draughtsman {
public:
    void beginLevel(double ordinal, const Names& names);
    void returnToLevel(double ordinal) { m_level = ordinal; }
    RegionId region(const std::string& id, building::RegionKind kind, const Names& names, const Box& box);
    /// A door of `widthM` with its landmarks on both sides; `at` is its middle, `facingA` the way its A side
    /// faces.
    building::Access& door(const RegionId& a, const RegionId& b, Point2 at, double facingA,
                           double widthM = 0.9);
    building::Access& opening(const RegionId& a, const RegionId& b, Point2 from, Point2 to);
    /// A flight or a ride up from region `low`, on the level being drawn, to the same place above.
    void shaft(building::AccessKind kind, const std::string& shaft, const RegionId& low, const RegionId& high,
               Point2 from, Point2 to);
    void landmark(const RegionId& region, const Thing& thing, Point2 at, double facing);
    std::string id(const std::string& name) const; ///< with the level in front: "1-bar"
    std::string ref(int number) const;             ///< "1.07"
    double level() const { return m_level; }
    building::BuildingData take(); ///< with the walls that stand between what was drawn

private:
    /// A straight line that walls stand on: level, east-west or not, and where, in whole centimetres.
    using WallLine = std::tuple<double, bool, long>;

    void drawWalls();
    void drawWall(const WallLine& line, double from, double to);

    building::BuildingData m_data;
    double m_level = 0.0;
    int m_things = 0;
};

} // namespace farol::demo
