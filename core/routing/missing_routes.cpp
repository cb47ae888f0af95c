#include "core/routing/missing_routes.h"

#include "core/routing/route_rules.h"

#include <algorithm>
#include <utility>

namespace farol::routing {

namespace {

using Places = std::vector<std::size_t>;

class Reach {
public:
    explicit Reach(const RouteRules& rules)
        : m_rules(rules), m_on(rules.building().regions().size()), m_back(m_on.size()) {
        for (std::size_t region = 0; region < m_on.size(); ++region)
            for (const std::size_t access : rules.building().accessesOf(region)) {
                const auto step = rules.stepThrough(access, region);
                if (!step || !rules.allowed(*step)) continue;
                m_on[region].push_back(step->into);
                m_back[step->into].push_back(region);
            }
    }

    std::size_t size() const { return m_on.size(); }
    std::vector<bool> from(std::size_t start) const { return along(m_on, start); }
    std::vector<bool> to(std::size_t goal) const { return along(m_back, goal); }

private:
    /// By region. What is barred is come to, but not passed.
    std::vector<bool> along(const std::vector<Places>& steps, std::size_t start) const {
        std::vector<bool> seen(steps.size(), false);
        Places next{start};
        seen[start] = true;
        while (!next.empty()) {
            const std::size_t at = next.back();
            next.pop_back();
            if (at != start && m_rules.barred(at)) continue;
            for (const std::size_t into : steps[at])
                if (!seen[into]) {
                    seen[into] = true;
                    next.push_back(into);
                }
        }
        return seen;
    }

    const RouteRules& m_rules;
    std::vector<Places> m_on, m_back;
};

struct Group {
    Places regions;
    std::vector<bool> reach; ///< of each of its regions
};

/// One region stands for all that it comes to and that come back to it. One that is barred stands for itself:
/// no way leads through it.
std::vector<Group> groupsOf(const RouteRules& rules, const Reach& reach) {
    std::vector<Group> groups;
    std::vector<bool> taken(reach.size(), false);
    for (std::size_t region = 0; region < reach.size(); ++region) {
        if (taken[region]) continue;
        Group group{{}, reach.from(region)};
        const std::vector<bool> back = reach.to(region);
        for (std::size_t other = region; other < reach.size(); ++other) {
            const bool alike = other == region || (!taken[other] && group.reach[other] && back[other] &&
                                                   !rules.barred(region) && !rules.barred(other));
            if (!alike) continue;
            taken[other] = true;
            group.regions.push_back(other);
        }
        groups.push_back(std::move(group));
    }
    std::stable_sort(groups.begin(), groups.end(),
                     [](const Group& a, const Group& b) { return a.regions.size() > b.regions.size(); });
    return groups;
}

/// Reaches a group what another one is? One of its regions stands for all.
bool joined(const Group& from, const Group& to) {
    return from.reach[to.regions.front()];
}

std::vector<MissingRoute> missingBetween(const std::vector<Group>& groups) {
    std::vector<MissingRoute> missing;
    for (std::size_t a = 0; a < groups.size(); ++a)
        for (std::size_t b = a + 1; b < groups.size(); ++b) {
            const bool on = joined(groups[a], groups[b]);
            const bool back = joined(groups[b], groups[a]);
            if (on && back) continue;
            MissingRoute route{a, b, !on && !back, groups[a].regions.size() * groups[b].regions.size(), {}};
            if (on) std::swap(route.from, route.to);
            if (route.bothWays) route.pairs *= 2;
            missing.push_back(route);
        }
    std::stable_sort(missing.begin(), missing.end(),
                     [](const MissingRoute& a, const MissingRoute& b) { return a.pairs > b.pairs; });
    return missing;
}

} // namespace

MissingRoutes findMissingRoutes(const std::shared_ptr<const Building>& building, const RouteOptions& options,
                                std::size_t most) {
    const RouteRules rules(building, options);
    const std::vector<Group> groups = groupsOf(rules, Reach(rules));
    MissingRoutes found;
    for (const Group& group : groups) {
        found.groups.emplace_back();
        for (const std::size_t region : group.regions)
            found.groups.back().regions.push_back(building->regions()[region].id);
    }
    const std::size_t count = building->regions().size();
    found.pairs = count > 0 ? count * (count - 1) : 0;
    found.routes = missingBetween(groups);
    for (const MissingRoute& route : found.routes) found.missingPairs += route.pairs;
    if (found.routes.size() > most) {
        found.leftOut = found.routes.size() - most;
        found.routes.resize(most);
    }
    for (MissingRoute& route : found.routes)
        route.why = rules.noRoute(groups[route.from].regions.front(), groups[route.to].regions.front());
    return found;
}

} // namespace farol::routing
