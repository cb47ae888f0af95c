#include "app/farol-cli/evaluate/walk_scores.h"

#include "core/guidance/clock.h"

#include <algorithm>
#include <cmath>

namespace farol::cli {

namespace {

constexpr double kOtherLevelM = 30.0; // an error across levels counts as that many metres

bool isNeighbour(const building::Building& building, const RegionId& a, const RegionId& b) {
    auto ia = building.regionIndex(a), ib = building.regionIndex(b);
    return ia && ib && building.areNeighbours(*ia, *ib);
}

bool withinOneHour(Radians said, Radians truth) {
    int apart = std::abs(guidance::clockHour(said) - guidance::clockHour(truth)) % 12;
    return std::min(apart, 12 - apart) <= 1;
}

} // namespace

void WalkScores::addMoment(const LoggedWalk& walk, const TruthRow& row, const Moment& moment, bool right,
                           bool isNear) {
    const localisation::Fix& fix = moment.fix;
    region.add(right);
    near.add(isNear);
    level.add(fix.level && *fix.level == row.level);
    if (!row.onRoute) offRoute.add(right);
    bool isSure = fix.region && fix.confidence >= kSure;
    sure.add(isSure);
    if (isSure) wrongWhenSure.add(!right);
    double error = kOtherLevelM;
    if (fix.position && fix.level && *fix.level == row.level)
        error = std::min(kOtherLevelM, distance(*fix.position, row.position));
    if (fix.position) errors.push_back(error);
    if (fix.position && isSure) sureErrors.push_back(error);
    bool isNearSure = fix.region && fix.nearConfidence >= kNearSure;
    nearSure.add(isNearSure);
    bool listed = std::find(fix.near.begin(), fix.near.end(), row.region) != fix.near.end();
    if (isNearSure) nearRight.add(listed || right);
    regionStated.push_back({fix.confidence, right});
    nearStated.push_back({fix.nearConfidence, listed || right});
    (void)walk;
}

/// After an unknown start, and after having been carried elsewhere unseen.
void WalkScores::addUnknown(const LoggedWalk& walk, const std::vector<Moment>& moments,
                            const std::vector<bool>& right) {
    for (std::size_t k = 0; k < walk.unknownSince.size(); ++k) {
        double since = walk.unknownSince[k], foundAt = 1e9;
        double until = k + 1 < walk.unknownSince.size() ? walk.unknownSince[k + 1] : 1e9;
        bool answered = false, atStart = since <= 0.0;
        for (std::size_t i = 0; i < moments.size(); ++i) {
            double time = walk.truth[i].time;
            if (time < since || time >= until || moments[i].fix.confidence < kSure) continue;
            if (!answered && atStart) firstRight.add(right[i]);
            answered = true;
            if (!right[i]) continue;
            foundAt = time - since;
            break;
        }
        if (atStart) {
            found60.add(foundAt <= 60.0);
            found120.add(foundAt <= 120.0);
        } else {
            kidnap60.add(foundAt <= 60.0);
        }
    }
}

/// Right again for two seconds.
void WalkScores::addDeviations(const LoggedWalk& walk, const std::vector<bool>& right) {
    constexpr double kForS = 2.0;
    for (std::size_t i = 1; i < walk.truth.size(); ++i) {
        if (walk.truth[i].onRoute || !walk.truth[i - 1].onRoute) continue;
        double begun = walk.truth[i].time, found = 1e9;
        for (std::size_t j = i, from = i; j < walk.truth.size() && found > 1e8; ++j) {
            if (!right[j]) from = j + 1;
            if (right[j] && walk.truth[j].time - walk.truth[from].time >= kForS)
                found = walk.truth[from].time - begun;
        }
        back20.add(found <= 20.0);
        back40.add(found <= 40.0);
    }
}

void WalkScores::addTurns(const LoggedWalk& walk, const std::vector<Moment>& moments) {
    constexpr double kTurn = 45.0 * kPi / 180.0, kFarM = 1.5;
    auto planner = routing::makeOptimalPlanner(walk.building);
    for (std::size_t i = 0; i < moments.size(); ++i) {
        const TruthRow& row = walk.truth[i];
        bool underWay = row.mode == "walk" || row.mode == "pause";
        if (!underWay || row.destination.empty() || row.region == row.destination) continue;
        auto route = planner->plan({row.region, row.position}, {row.destination, std::nullopt});
        if (!route || route->manoeuvres.size() < 2) continue;
        const localisation::Fix& fix = moments[i].fix;
        bool isSure = fix.region && fix.confidence >= kSure;
        const routing::Manoeuvre& next = route->manoeuvres[1];
        if (std::abs(next.turn.value) >= kTurn) {
            bool given = isSure && moments[i].next;
            turnsGiven.add(given);
            if (given) turnsRight.add(withinOneHour(moments[i].next->turn, next.turn));
        }
        if (distance(row.position, next.position) < kFarM || next.level != row.level) continue;
        Radians truth = wrapped(directionOf(next.position - row.position) - row.heading);
        if (std::abs(truth.value) < kTurn) continue;
        bool given = isSure && fix.position && fix.heading && moments[i].next;
        hoursGiven.add(given);
        if (!given) continue;
        Radians said = directionOf(moments[i].next->position - *fix.position) - *fix.heading;
        hoursRight.add(withinOneHour(said, truth));
    }
}

void WalkScores::add(const LoggedWalk& walk, const std::vector<Moment>& moments, bool withTurns) {
    std::vector<bool> right(moments.size(), false);
    for (std::size_t i = 0; i < moments.size(); ++i) {
        const auto& said = moments[i].fix.region;
        right[i] = said && *said == walk.truth[i].region;
        bool isNear = right[i] || (said && isNeighbour(*walk.building, *said, walk.truth[i].region));
        addMoment(walk, walk.truth[i], moments[i], right[i], isNear);
    }
    addUnknown(walk, moments, right);
    addDeviations(walk, right);
    if (withTurns) addTurns(walk, moments);
}

double WalkScores::calibrationError(const std::vector<Stated>& stated) {
    struct Bin {
        double sum = 0.0, right = 0.0, count = 0.0;
    };
    std::array<Bin, 10> bins;
    for (const Stated& each : stated) {
        Bin& bin = bins[static_cast<std::size_t>(std::clamp(each.confidence * 10.0, 0.0, 9.0))];
        bin.sum += each.confidence;
        bin.right += each.right ? 1.0 : 0.0;
        bin.count += 1.0;
    }
    double error = 0.0;
    for (const Bin& bin : bins) error += std::abs(bin.sum - bin.right);
    return stated.empty() ? 0.0 : error / static_cast<double>(stated.size());
}

double WalkScores::median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

std::vector<std::pair<std::string, double>> WalkScores::figures() const {
    return {{"region %", region.percent()},
            {"region or neighbour %", near.percent()},
            {"level %", level.percent()},
            {"off route: region %", offRoute.percent()},
            {"position error when sure, median m", median(sureErrors)},
            {"position error always, median m", median(errors)},
            {"sure (>= .8) % of time", sure.percent()},
            {"wrong when sure %", wrongWhenSure.percent()},
            {"in or next to (>= .9) % of time", nearSure.percent()},
            {"right when in or next to %", nearRight.percent()},
            {"calibration error, region", calibrationError(regionStated)},
            {"calibration error, in or next to", calibrationError(nearStated)},
            {"unknown start: first answer right %", firstRight.percent()},
            {"unknown start: answers", static_cast<double>(firstRight.all)},
            {"unknown start: sure and right in 60 s %", found60.percent()},
            {"unknown start: sure and right in 120 s %", found120.percent()},
            {"kidnap: sure and right in 60 s %", kidnap60.percent()},
            {"deviations", static_cast<double>(back20.all)},
            {"deviation: right again in 20 s %", back20.percent()},
            {"deviation: right again in 40 s %", back40.percent()},
            {"next turn >= 45: given %", turnsGiven.percent()},
            {"next turn >= 45: right when given %", turnsRight.percent()},
            {"hour of next access not 11 to 1: given %", hoursGiven.percent()},
            {"hour of next access not 11 to 1: right %", hoursRight.percent()}};
}

} // namespace farol::cli
