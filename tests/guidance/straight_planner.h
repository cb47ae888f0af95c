#pragma once
// A planner of the tests' own, so that what is told does not depend on how routes are found: fewest regions,
// straight lines from access to access.

#include "core/routing/route.h"

#include <cmath>
#include <deque>
#include <map>
#include <memory>
#include <optional>

namespace farol::test {

class StraightPlanner final : public routing::Planner {
public:
    explicit StraightPlanner(std::shared_ptr<const building::Building> building)
        : m_building(std::move(building)) {}

    Result<routing::Route> plan(const building::Location& from, const building::Location& to) const override {
        ++plans;
        routing::Route route;
        if (!search(from.region, to.region, route)) {
            return Error{ErrorCode::NotFound, "there is no way to " + to.region.value, {}};
        }
        Point2 goal = to.position.value_or(pointInside(m_building->region(to.region)->polygon));
        Point2 start = from.position.value_or(pointInside(m_building->region(from.region)->polygon));
        layOut(route, start, goal);
        return route;
    }

    mutable int plans = 0;

private:
    bool search(const RegionId& from, const RegionId& to, routing::Route& route) const {
        std::size_t start = *m_building->regionIndex(from), goal = *m_building->regionIndex(to);
        std::map<std::size_t, std::optional<std::size_t>> cameBy{{start, std::nullopt}}; // region -> access
        std::deque<std::size_t> open{start};
        while (!open.empty() && !cameBy.contains(goal)) {
            std::size_t region = open.front();
            open.pop_front();
            for (std::size_t index : m_building->accessesOf(region)) {
                const building::Access& access = m_building->accesses()[index];
                auto other = m_building->otherSide(access, region);
                if (!other || !access.passable() || cameBy.contains(*other)) continue;
                cameBy[*other] = index;
                open.push_back(*other);
            }
        }
        if (!cameBy.contains(goal)) return false;
        route.regions = {to};
        for (std::size_t region = goal; cameBy[region];) {
            const building::Access& access = m_building->accesses()[*cameBy[region]];
            region = *m_building->otherSide(access, region);
            route.accesses.insert(route.accesses.begin(), access.id);
            route.regions.insert(route.regions.begin(), m_building->regions()[region].id);
        }
        return true;
    }

    void layOut(routing::Route& route, Point2 start, Point2 goal) const {
        auto levelOf = [&](std::size_t i) { return m_building->region(route.regions[i])->level; };
        route.planner = "straight";
        route.path = {{start, levelOf(0)}};
        routing::Manoeuvre begin;
        begin.from = begin.into = route.regions.front();
        begin.position = start;
        begin.level = begin.targetLevel = levelOf(0);
        route.manoeuvres = {begin};
        for (std::size_t i = 0; i < route.accesses.size(); ++i) {
            const building::Access& access = *m_building->access(route.accesses[i]);
            routing::Manoeuvre manoeuvre;
            manoeuvre.kind = access.kind == building::AccessKind::Stairs ? routing::ManoeuvreKind::Stairs
                             : access.kind == building::AccessKind::Elevator
                                 ? routing::ManoeuvreKind::Elevator
                             : access.kind == building::AccessKind::Opening ? routing::ManoeuvreKind::Opening
                                                                            : routing::ManoeuvreKind::Door;
            manoeuvre.access = access.id;
            manoeuvre.from = route.regions[i];
            manoeuvre.into = route.regions[i + 1];
            manoeuvre.position = access.midpoint();
            manoeuvre.level = levelOf(i);
            manoeuvre.targetLevel = levelOf(i + 1);
            manoeuvre.steps = access.steps;
            if (manoeuvre.targetLevel > manoeuvre.level) manoeuvre.vertical = routing::Vertical::Up;
            if (manoeuvre.targetLevel < manoeuvre.level) manoeuvre.vertical = routing::Vertical::Down;
            append(route, manoeuvre.position, manoeuvre.level);
            manoeuvre.atM = route.lengthM;
            if (manoeuvre.targetLevel != manoeuvre.level)
                append(route, manoeuvre.position, manoeuvre.targetLevel);
            route.manoeuvres.push_back(manoeuvre);
        }
        append(route, goal, levelOf(route.regions.size() - 1));
        addTurns(route);
        routing::Manoeuvre arrive;
        arrive.kind = routing::ManoeuvreKind::Arrive;
        arrive.from = arrive.into = route.regions.back();
        arrive.position = goal;
        arrive.level = arrive.targetLevel = route.path.back().level;
        arrive.atM = route.lengthM;
        route.manoeuvres.push_back(arrive);
    }

    static void append(routing::Route& route, Point2 to, double level) {
        route.lengthM += distance(route.path.back().position, to);
        route.path.push_back({to, level});
    }

    static void addTurns(routing::Route& route) {
        for (std::size_t i = 1; i < route.manoeuvres.size(); ++i) {
            if (i + 1 >= route.path.size()) break;
            Point2 in = route.path[i].position - route.path[i - 1].position;
            Point2 out = route.path[i + 1].position - route.path[i].position;
            if (length(in) > 0 && length(out) > 0) {
                route.manoeuvres[i].turn = wrapped(directionOf(out) - directionOf(in));
            }
        }
    }

    std::shared_ptr<const building::Building> m_building;
};

} // namespace farol::test
