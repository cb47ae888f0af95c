#pragma once
// What a localiser said, against the truth: shares of time, belief in its own confidence, recovery, turns.

#include "app/farol-cli/evaluate/evaluation.h"
#include "app/farol-cli/evaluate/walk_log.h"

#include <array>
#include <vector>

namespace farol::cli {

/// How often something was so among so many.
struct Share {
    std::size_t yes = 0, all = 0;

    void add(bool is) {
        ++all;
        yes += is ? 1 : 0;
    }
    double percent() const {
        return all == 0 ? 0.0 : 100.0 * static_cast<double>(yes) / static_cast<double>(all);
    }
};

/// A stated probability, and whether it was so.
struct Stated {
    double confidence = 0.0;
    bool right = false;
};

class WalkScores {
public:
    static constexpr double kSure = 0.8, kNearSure = 0.9;

    /// `withTurns`: also plans from the true position at every moment (slow).
    void add(const LoggedWalk& walk, const std::vector<Moment>& moments, bool withTurns);

    Share region, near, level, offRoute; ///< of all moments
    Share sure, wrongWhenSure;           ///< confidence >= kSure; not right among those
    Share nearSure, nearRight;           ///< near_confidence >= kNearSure; right among those
    Share firstRight, found60, found120; ///< unknown starts: first sure answer; sure and right in time
    Share kidnap60;
    Share back20, back40;         ///< deviations
    Share turnsGiven, turnsRight; ///< the route's next turn, where it is 45 degrees or more
    Share hoursGiven, hoursRight; ///< body-relative hour of the next access, where it is not 11 to 1
    std::vector<double> sureErrors, errors; ///< of the position, metres
    std::vector<Stated> regionStated, nearStated;

    /// Mean gap between stated and observed in ten bins, weighed by their size.
    static double calibrationError(const std::vector<Stated>& stated);
    static double median(std::vector<double> values);
    std::vector<std::pair<std::string, double>> figures() const;

private:
    void addMoment(const LoggedWalk& walk, const TruthRow& row, const Moment& moment, bool right, bool near);
    void addUnknown(const LoggedWalk& walk, const std::vector<Moment>& moments,
                    const std::vector<bool>& right);
    void addDeviations(const LoggedWalk& walk, const std::vector<bool>& right);
    void addTurns(const LoggedWalk& walk, const std::vector<Moment>& moments);
};

} // namespace farol::cli
