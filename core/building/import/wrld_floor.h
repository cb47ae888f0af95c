#pragma once
// One floor of a WRLD map. It has walls, doors and windows as thin polygons and hardly a room: the rooms are
// what is left of the building's outline without them.

#include "core/building/import/importer.h"
#include "core/building/import/local_plane.h"
#include "core/building/import/tagged_feature.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace farol::building {

class WrldFloor {
public:
    /// `name` starts the ids ("G/103"). Results are in metres of the plane.
    WrldFloor(std::vector<TaggedFeature> features, const LocalPlane& plane, double level, std::string name);

    void build();

    std::vector<Region> regions;
    std::vector<Access> accesses;
    std::vector<Wall> walls;
    std::vector<std::string> narrow; ///< ids of left-over strips that nobody fits into
    std::size_t closedSpaces = 0;    ///< regions without a polygon of their own in the source

private:
    std::string idOf(const TaggedFeature& feature) const { return m_name + "/" + feature.id; }
    GeometryPtr unionOfTypes(const std::vector<std::string>& types, double grow) const;
    void closeBarrier();
    void addNamed();
    void addClosedSpaces();
    void addDoors();
    void addWalls();
    void nameKinds();
    std::optional<std::size_t> regionBeside(Point2 from, Point2 direction) const;

    std::vector<TaggedFeature> m_features;
    double m_level;
    std::string m_name;
    GeometryPtr m_barrier;
};

} // namespace farol::building
