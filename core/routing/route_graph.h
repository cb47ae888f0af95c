#pragma once
// What both planners share: which accesses may be passed, what that costs, and the Route made from a chosen
// row of them.

#include "core/routing/route.h"
#include "core/routing/walking_space.h"

#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace farol::routing {

/// One access passed, by indices of the building. `crossing`: which of RouteGraph::crossings(access).
struct Step {
    std::size_t access;
    std::size_t from;
    std::size_t into;
    std::size_t crossing = 0;
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

    /// NotFound for a region that is not in the map; a position outside its region is taken at the region's
    /// border.
    Result<Endpoint> endpoint(const Location& location, const std::string& role) const;
    /// Where an access may be crossed: its middle, and for a wide opening further points beside it.
    const std::vector<Point2>& crossings(std::size_t access) const { return m_crossings[access]; }
    /// The steps out of a region that may be taken on the way from `start` to `goal`, in the order of the
    /// map; each over the middle.
    std::vector<Step> stepsFrom(std::size_t region, std::size_t start, std::size_t goal) const;
    /// Seconds to pass the access after `previous` (a lift is waited for once a ride).
    double seconds(const Step& step, const Step* previous) const;
    double walkingSeconds(double metres) const { return metres / m_options.walkingSpeed; }
    /// Metres within the region from the crossing of `a` to the crossing of `b`.
    double between(std::size_t region, const Step& a, const Step& b) const;
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

    static const Obstacles& allObstacles();
    static const char* obstacleWords(Obstacle obstacle);

    std::optional<Obstacles> obstacles(const Step& step, std::size_t start, std::size_t goal) const;
    std::vector<Step> fewestObstacles(const Obstacles& allowed, std::size_t from, std::size_t to) const;
    std::string severalObstacles(std::size_t from, std::size_t to) const;
    std::string where(Obstacle obstacle, const Obstacles& allowed, std::size_t from, std::size_t to) const;
    double heightM(const Step& step) const;
    double verticalM(const Step& step) const;
    std::vector<double> lengthsWithin(std::size_t region) const;
    std::vector<Point2> pulledStraight(const Endpoint& from, const Endpoint& to,
                                       const std::vector<Step>& steps) const;
    void slide(std::vector<Point2>& points, const std::vector<Step>& steps, std::size_t i) const;
    void appendLeg(Route& route, std::size_t region, Point2 from, Point2 to) const;

    std::shared_ptr<const Building> m_building;
    RouteOptions m_options;
    std::vector<Polyline> m_widths; ///< of wide openings, within which one walks; empty for others
    std::vector<std::vector<Point2>> m_crossings;
    std::unique_ptr<Room[]> m_rooms; ///< filled when first needed, safe from several threads
};

} // namespace farol::routing
