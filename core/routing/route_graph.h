#pragma once
// What both planners share: which accesses may be passed, what that costs, and the Route made from a chosen row of them.

#include "core/routing/route.h"
#include "core/routing/walking_space.h"

#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace farol::routing {

/// One access passed, by indices of the building.
struct Step {
    std::size_t access;
    std::size_t from;
    std::size_t into;
};

struct Endpoint {
    std::size_t region = 0;
    Point2 position;
};

class RouteGraph {
public:
    RouteGraph(std::shared_ptr<const Building> building, RouteOptions options);
    ~RouteGraph();

    const Building& building() const { return *m_building; }
    const RouteOptions& options() const { return m_options; }

    /// NotFound for a region that is not in the map; a position outside its region is taken at the region's border.
    Result<Endpoint> endpoint(const Location& location, const std::string& role) const;
    /// The steps out of a region that may be taken on the way from `start` to `goal`, in the order of the map.
    std::vector<Step> stepsFrom(std::size_t region, std::size_t start, std::size_t goal) const;
    /// Seconds to pass the access after `previous` (a lift is waited for once a ride).
    double seconds(const Step& step, const Step* previous) const;
    double walkingSeconds(double metres) const { return metres / m_options.walkingSpeed; }
    /// Metres between the middles of two accesses of a region, and from the middle of one to a point.
    double between(std::size_t region, std::size_t accessA, std::size_t accessB) const;
    const WalkingSpace& space(std::size_t region) const;
    bool reachable(std::size_t from, std::size_t to) const;
    /// Why `to` cannot be reached: by what is closed or to be avoided only, or not at all.
    Error unreachable(std::size_t from, std::size_t to) const;
    Route routeAlong(const std::string& planner, const Endpoint& from, const Endpoint& to,
                     const std::vector<Step>& steps) const;

private:
    struct Room;
    enum class Obstacle { Stairs, Elevator, Escalator, Restricted, Closed, OneWay };
    using Obstacles = std::set<Obstacle>;

    std::optional<Obstacles> obstacles(const Step& step, std::size_t start, std::size_t goal) const;
    std::vector<Step> fewestObstacles(std::size_t from, std::size_t to) const;
    std::string reason(const std::vector<Step>& steps, std::size_t from, std::size_t to) const;
    double heightM(const Step& step) const;
    double verticalM(const Step& step) const;
    std::vector<Point2> crossings(const Endpoint& from, const Endpoint& to, const std::vector<Step>& steps) const;
    void slide(std::vector<Point2>& points, const std::vector<Step>& steps, std::size_t i) const;
    void appendLeg(Route& route, std::size_t region, Point2 from, Point2 to) const;

    std::shared_ptr<const Building> m_building;
    RouteOptions m_options;
    std::unique_ptr<Room[]> m_rooms; ///< filled when first needed, safe from several threads
};

} // namespace farol::routing
