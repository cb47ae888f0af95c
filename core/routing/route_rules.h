#pragma once
// What a step through an access costs and whether it may be taken, and why there is no way where all are
// barred.

#include "core/routing/route.h"

#include <array>
#include <cstdint>
#include <memory>
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

class RouteRules {
public:
    RouteRules(std::shared_ptr<const Building> building, RouteOptions options);

    const Building& building() const { return *m_building; }
    const RouteOptions& options() const { return m_options; }

    /// The step through an access out of that region; empty where it does not join two known regions.
    std::optional<Step> stepThrough(std::size_t access, std::size_t region) const;
    /// May it be taken at all, wherever one comes from and goes to? Restricted regions are not looked at.
    bool allowed(const Step& step) const;
    /// May it be taken on the way from region `start` to region `goal`?
    bool allowed(const Step& step, std::size_t start, std::size_t goal) const;
    /// A region that one may only start or end in (restricted ones and moving walkways, where avoided).
    bool barred(std::size_t region) const;
    /// The steps out of a region that may be taken, in the order of the map.
    std::vector<Step> stepsFrom(std::size_t region, std::size_t start, std::size_t goal) const;

    /// Seconds to pass the access after `previous` (a lift is waited for once a ride).
    double seconds(const Step& step, const Step* previous) const;
    double walkingSeconds(double metres) const { return metres / m_options.walkingSpeed; }
    /// Metres walked on stairs, ramps and escalators, beside what is walked in the regions.
    double verticalM(const Step& step) const;
    bool changesLevel(const Step& step) const;
    /// Does the step's price depend on the one before? Only a ride's that goes on.
    bool isLift(std::size_t access) const;

    bool reachable(std::size_t from, std::size_t to) const;
    /// Why there is no way to `to`.
    NoRoute noRoute(std::size_t from, std::size_t to) const;
    /// The same in words: by what is closed or to be avoided only, or not at all.
    Error unreachable(std::size_t from, std::size_t to) const;

private:
    using Obstacles = std::set<Obstacle>;
    static constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

    static const Obstacles& allObstacles();
    static const char* obstacleWords(Obstacle obstacle);

    bool hasWay(std::size_t access) const; ///< neither a window nor of a kind nobody is led through
    bool narrow(std::size_t access) const;
    template <class Visit>
    void forEachObstacle(const Step& step, std::size_t start, std::size_t goal, Visit visit) const;
    Obstacles obstacles(const Step& step, std::size_t start, std::size_t goal) const;
    std::vector<Step> fewestObstacles(const Obstacles& allowed, std::size_t from, std::size_t to) const;
    void addBarrier(NoRoute& why, Obstacle obstacle, const Obstacles& allowed, std::size_t from,
                    std::size_t to) const;
    std::string inWords(const NoRoute::Barrier& barrier) const;
    double levelsOf(const Step& step) const;
    double heightM(const Step& step) const;
    double liftSeconds(const Step& step, const Step* previous) const;
    double stairsSeconds(const Step& step) const;

    std::shared_ptr<const Building> m_building;
    RouteOptions m_options;
    std::vector<std::array<std::size_t, 2>> m_sides; ///< of each access; kNowhere where it joins nothing
};

} // namespace farol::routing
