#pragma once
// Recorded walks with their truth (data/walks), and what a localiser made of them, moment by moment.

#include "core/session/json_lines.h"
#include "core/session/navigator.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace farol::cli {

/// Where the user really was.
struct TruthRow {
    double time = 0.0;
    RegionId region;
    double level = 0.0;
    Point2 position;
    Radians heading; ///< of the body
    std::string mode;
    bool onRoute = true;
    RegionId destination;
};

struct LoggedWalk {
    std::string name;
    std::shared_ptr<const building::Building> building;
    std::vector<session::LogLine> lines;
    std::vector<double> unknownSince; ///< times of unknown starts and of silent kidnaps
    std::vector<TruthRow> truth;
};

/// Of the text of a log and of its truth; an error names the line.
Result<LoggedWalk> parseWalk(std::shared_ptr<const building::Building> building, const std::string& name,
                             const std::string& log, const std::string& truth);
/// All walks below `folder`/bNNNN, in natural order; NotFound when there is none.
Result<std::vector<LoggedWalk>> readWalks(const std::filesystem::path& folder);

/// What was said at a moment of the truth.
struct Moment {
    localisation::Fix fix;
    std::optional<routing::Manoeuvre> next; ///< the next thing to do, as far as the tracker knows
};

/// The lines of the log up to each row of the truth, as `locate --every` would read them.
Result<std::vector<Moment>> follow(const LoggedWalk& walk, const std::string& localiser, bool withMotion);

double timeOf(const session::LogLine& line);

} // namespace farol::cli
