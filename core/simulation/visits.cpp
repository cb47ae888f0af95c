#include "core/simulation/visits.h"

#include "core/building/sayable.h"
#include "core/simulation/hash.h"

#include <cmath>
#include <map>
#include <string>

namespace farol::simulation {

namespace {

constexpr double kShortestM = 15.0, kLongestM = 60.0;
constexpr int kDraws = 60;

double beside(double metres) {
    return metres < kShortestM ? kShortestM - metres : metres > kLongestM ? metres - kLongestM : 0.0;
}

} // namespace

Visits::Visits(const std::shared_ptr<const building::Building>& building)
    : m_planner(routing::makeOptimalPlanner(building)) {
    std::map<std::string, int> named;
    for (const building::Region& region : building->regions()) ++named[building::sayableName(region)];
    for (const building::Region& region : building->regions()) {
        bool passed =
            region.kind == building::RegionKind::Stairwell || region.kind == building::RegionKind::Elevator;
        std::string name = building::sayableName(region);
        if (!passed && !region.restricted && region.polygon.outer.size() > 2 && !name.empty() &&
            named[name] == 1)
            m_places.push_back(region.id);
    }
}

std::optional<Visit> Visits::between(const RegionId& from, const RegionId& to) const {
    auto route = m_planner->plan({from, {}}, {to, {}});
    if (!route) return std::nullopt;
    return Visit{from, to, route->lengthM, route->seconds};
}

std::optional<Visit> Visits::visit(std::uint64_t number, const std::optional<RegionId>& from) const {
    Draw draw(hashOf(number, "visit"));
    std::optional<Visit> best;
    auto count = static_cast<int>(m_places.size());
    for (int i = 0; i < kDraws && count > 1; ++i) {
        RegionId start = from.value_or(m_places[static_cast<std::size_t>(draw.below(count))]);
        const RegionId& goal = m_places[static_cast<std::size_t>(draw.below(count))];
        if (start == goal) continue;
        auto visit = between(start, goal);
        if (!visit || (best && beside(visit->metres) >= beside(best->metres))) continue;
        best = visit;
        if (beside(best->metres) == 0.0) break;
    }
    return best;
}

} // namespace farol::simulation
