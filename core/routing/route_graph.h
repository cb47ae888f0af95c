#pragma once
// What both planners share: the rules of the way, walking within regions, and where a way starts and ends.

#include "core/routing/route.h"
#include "core/routing/route_rules.h"
#include "core/routing/walking_space.h"

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace farol::routing {

struct Endpoint {
    std::size_t region = 0;
    Point2 position;
};

class RouteGraph {
public:
    RouteGraph(std::shared_ptr<const Building> building, RouteOptions options);
    ~RouteGraph();

    const Building& building() const { return m_rules.building(); }
    const RouteRules& rules() const { return m_rules; }

    /// NotFound for a region that is not in the map; a position outside its region is taken at the region's
    /// border.
    Result<Endpoint> endpoint(const Location& location, const std::string& role) const;
    const WalkingSpace& space(std::size_t region) const;

private:
    struct Room;

    RouteRules m_rules;
    std::unique_ptr<Room[]> m_rooms; ///< filled when first needed, safe from several threads
};

/// A route as it is put together, leg by leg.
class RouteMaker {
public:
    RouteMaker(const RouteGraph& graph, std::string planner, const Endpoint& from);

    /// On to a point of the region one is in.
    void walkTo(Point2 to);
    /// Straight on, within what is known to be free.
    void walkStraightTo(Point2 to) { add(to); }
    /// Through the access one has come to. One comes out at `landing`.
    void pass(const Step& step, Point2 landing);
    Point2 position() const { return m_route.path.back().position; }
    std::size_t region() const { return m_region; }
    Route finished(); ///< once

private:
    void add(Point2 p);

    const RouteGraph& m_graph;
    Route m_route;
    std::size_t m_region;
    double m_level;
    double m_vertical = 0.0;
    double m_flat = 0.0;
    std::optional<Step> m_last;
    std::vector<std::size_t> m_portals;
};

} // namespace farol::routing
