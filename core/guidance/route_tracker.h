#pragma once
// Follows the fix along the route: next access, off route, arrival (paper 4.1, 4.2 f).

#include "core/guidance/cue.h"

#include <memory>

namespace farol::guidance {

enum class Travel { NoDestination, NoFix, OnRoute, OffRoute, Arrived, Unreachable };

struct Progress {
    Travel travel = Travel::NoDestination;
    RegionId destination;           ///< empty without one
    std::uint64_t routeVersion = 0; ///< rises with every plan
    std::shared_ptr<const routing::Route> route;
    std::size_t regionsPassed = 0;          ///< index into route->regions of the current region
    std::optional<routing::Manoeuvre> next; ///< the next thing to do
    std::optional<routing::Manoeuvre> afterNext;
    std::optional<double> distanceM;            ///< to it; only with a position
    std::optional<double> remainingM;           ///< to the destination; only with a position
    bool replanned = false;                     ///< in this very step, because the route was left
    Deviation deviation = Deviation::LeftRoute; ///< of `replanned`: how
    std::optional<Radians> walking; ///< of `replanned`: the way of walking that was seen to be wrong
    bool backAgain = false; ///< of `replanned`: the new way begins with what one has just come through
    bool doubtful = false;  ///< arrived, probably: nothing was seen that belongs to the destination only
    std::string reason;     ///< why there is no route
};

std::string travelName(Travel travel);

struct TrackerOptions {
    /// A fix off the route, one that jumps over regions of it, or one in the destination is believed once it
    /// came this often in a row (each time from a new observation) and has lasted so long, or at this
    /// confidence at once. Who is sent back by a guess is lost, who walks on for some seconds is not.
    int offRouteFixes = 2;
    double offRouteSeconds = 0.0;
    double offRouteConfidence = 0.6;
    /// Below this confidence a fix is a guess: no way begins with it, and none is given up for it, before it
    /// has lasted longer than a look around takes.
    double guessConfidence = 0.0, guessSeconds = 30.0;
    /// Below this nobody knows where the user is, however long it lasts: no way follows from it.
    double hopelessConfidence = 0.0;
    double minConfidence = 0.0; ///< fixes below change nothing
    /// Above 0: a fix in the destination is believed at this confidence only, and only once something was
    /// seen after the first one. For localisers whose confidence is a probability.
    double arrivalConfidence = 0.0;
    /// Some rooms show nothing that tells them from the next: whoever has been in the destination, as far as
    /// can be told, at this confidence or a better one for so long has probably arrived. 0 seconds: never.
    double patientConfidence = 0.7, patientSeconds = 0.0;

    Result<void> check() const;
};

/// Plans when destination and region are known, and again when off route; no state of an old route is left
/// over.
class RouteTracker {
public:
    RouteTracker(std::shared_ptr<const building::Building> building,
                 std::shared_ptr<const routing::Planner> planner, TrackerOptions options = {});

    void setDestination(const std::optional<building::Location>& destination);
    const std::optional<building::Location>& destination() const { return m_destination; }
    Progress update(const localisation::Fix& fix);
    /// For the localiser: regions from the current one on, and where the next access is.
    localisation::RouteContext context() const;

private:
    void follow(const localisation::Fix& fix);
    bool isGuess(const localisation::Fix& fix) const;
    void remember(const localisation::Fix& fix);
    bool isBarelyThere(const localisation::Fix& fix) const;
    bool believed(const localisation::Fix& fix);
    bool onThreshold(const localisation::Fix& fix) const;
    bool waitedLong(const localisation::Fix& fix);
    void watch(const localisation::Fix& fix);
    std::optional<Deviation> straying(const localisation::Fix& fix);
    void plan(const localisation::Fix& fix);
    void refuse(const std::string& reason);
    void settle();
    void describeNext(const localisation::Fix& fix);
    std::optional<std::size_t> onRoute(const RegionId& region) const;
    void assignManoeuvres();
    /// How far along the route the fix is, as Manoeuvre::atM counts; empty without a usable position.
    std::optional<double> walkedM(const localisation::Fix& fix, std::size_t exit) const;
    std::optional<std::size_t> exitOf(std::size_t region) const;
    struct Foot;
    std::optional<Foot> footOf(const localisation::Fix& fix, std::size_t exit) const;

    std::shared_ptr<const building::Building> m_building;
    std::shared_ptr<const routing::Planner> m_planner;
    TrackerOptions m_options;
    std::optional<building::Location> m_destination;
    Progress m_progress;
    std::vector<std::optional<std::size_t>> m_regionOf; ///< of each manoeuvre: index into route->regions
    int m_doubtfulFixes = 0;                            ///< in a row, off the route or jumping along it
    std::optional<double> m_doubtCounted;               ///< evidenceTime of the last of them
    double m_doubtSince = 0.0;                          ///< time of the first of them
    std::optional<double> m_thereSince; ///< taken to be in the destination all the while since
    std::optional<RegionId> m_lately;   ///< where the user is as likely as not, with or without destination
    bool m_latelySure = false;          ///< and was sure to be, once since then
    std::optional<RegionId> m_refusedFrom; ///< planning from there failed

    /// Of the present route: how well the positions follow it.
    struct Trail {
        std::optional<double> spotTime;         ///< of the last position that counted
        std::optional<Point2> last, walkedFrom; ///< walkedFrom: where the user began to stray
        double farthestM = 0.0;
        double gapM = 0.0;
        int astray = 0; ///< observations in a row
    };
    Trail m_trail;
};

} // namespace farol::guidance
