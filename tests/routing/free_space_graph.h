#pragma once
// The truth that planned ways are measured against, found in another way: every corner of every polygon sees
// every other one over the whole floor or does not, tried pair by pair against every wall; then Dijkstra's
// algorithm of Boost. Slow, and shares nothing with the planner but the map.

#include "core/routing/route.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace farol::test {

class FreeSpaceGraph {
public:
    FreeSpaceGraph(std::shared_ptr<const building::Building> building, routing::RouteOptions options);
    ~FreeSpaceGraph();

    /// Least seconds, or nothing where there is no way. Both locations with a position.
    std::optional<double> seconds(const building::Location& from, const building::Location& to) const;

private:
    struct Node {
        Point2 point;
        std::size_t region;
    };
    struct Gate { ///< a wide opening: crossed anywhere between a and b
        Point2 a, b;
        std::size_t first, second;
        bool forward, backward;
    };
    struct Arc {
        std::size_t from, to;
        double seconds;
    };
    struct Floor {
        double level;
        std::vector<std::size_t> regions;
        std::vector<std::array<Point2, 2>> walls;
        std::vector<Gate> gates;
        std::vector<std::size_t> nodes;
    };

    bool usable(std::size_t access, bool forward) const;
    double price(const building::Access& access, double levels) const;
    Floor& floorOf(double level);
    std::size_t addNode(std::size_t region, Point2 point);
    void addAccess(std::size_t index);
    void addRides();
    void addSight();
    bool sees(const Floor& floor, const Node& from, const Node& to) const;
    static void cross(const Floor& floor, Point2 at, std::vector<std::size_t>& regions);

    std::shared_ptr<const building::Building> m_building;
    routing::RouteOptions m_options;
    std::vector<Floor> m_floors;
    std::vector<Node> m_nodes;
    std::vector<Arc> m_arcs;
    struct Ride { ///< a lift taken: where one steps in, and where one is then
        std::size_t access, in, out;
    };
    std::vector<Ride> m_rides;
};

} // namespace farol::test
