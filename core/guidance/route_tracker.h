#pragma once
// Follows the fix along the route: next access, off route, arrival (paper 4.1, 4.2 f).

#include "core/guidance/cue.h"

#include <memory>

namespace farol::guidance {

enum class Travel { NoDestination, NoFix, OnRoute, OffRoute, Arrived, Unreachable };

struct Progress {
    Travel travel = Travel::NoDestination;
    std::uint64_t routeVersion = 0;          ///< rises with every plan
    std::shared_ptr<const routing::Route> route;
    std::size_t regionsPassed = 0;           ///< index into route->regions of the current region
    std::optional<routing::Manoeuvre> next;  ///< the next thing to do
    std::optional<routing::Manoeuvre> afterNext;
    std::optional<double> distanceM;         ///< to it; only with a position
    std::optional<double> remainingM;        ///< to the destination; only with a position
    bool replanned = false;                  ///< in this very step
    std::string reason;                      ///< why there is no route
};

std::string travelName(Travel travel);

struct TrackerOptions {
    /// A fix off the route is believed once it came this often in a row, or at this confidence at once.
    int offRouteFixes = 2;
    double offRouteConfidence = 0.6;
    double minConfidence = 0.0; ///< fixes below change nothing

    Result<void> check() const;
};

/// Plans when destination and region are known, and again when off route; no state of an old route is left over.
class RouteTracker {
public:
    RouteTracker(std::shared_ptr<const building::Building> building, std::shared_ptr<const routing::Planner> planner,
                 TrackerOptions options = {});

    void setDestination(const std::optional<building::Location>& destination);
    const std::optional<building::Location>& destination() const { return m_destination; }
    Progress update(const localisation::Fix& fix);
    /// For the localiser: regions from the current one on, and where the next access is.
    localisation::RouteContext context() const;

private:
    void plan(const localisation::Fix& fix);
    void describeNext(const localisation::Fix& fix);

    std::shared_ptr<const building::Building> m_building;
    std::shared_ptr<const routing::Planner> m_planner;
    TrackerOptions m_options;
    std::optional<building::Location> m_destination;
    Progress m_progress;
    int m_fixesOffRoute = 0;
};

} // namespace farol::guidance
