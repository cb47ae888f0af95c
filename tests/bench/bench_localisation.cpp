// Tunes, calibrates and times the filter on buildings and walks of our own; nothing here sees data/walks.
//   bench_localisation --buildings 24 --seed 100 --motion both [--set trust=0.9,...] [--each] [--trace]
//     --plain: walkers, eyes and cameras all alike, with the rates of the study; --unknown: no start is told
//   bench_localisation --calibrate core/localisation/confidence_table.inc --buildings 96 --seed 1000
//   bench_localisation --write DIR --buildings 4       maps and walks in the form of data/walks
//   bench_localisation --speed

#include "app/farol-cli/evaluate/walk_scores.h"
#include "core/building/geopackage.h"
#include "core/localisation/bayes_localiser.h"
#include "core/localisation/confidence_table.h"
#include "tests/bench/localisation_fit.h"
#include "tests/support/campus.h"
#include "tests/support/simulated_walk.h"
#include "tests/support/walk_building.h"
#include "tests/support/walk_random.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

namespace {

using namespace farol;
using cli::LoggedWalk;
using cli::Moment;
using cli::WalkScores;
using localisation::BayesOptions;

struct Arguments {
    std::size_t buildings = 24, seed = 100;
    std::string motion = "both", calibrate, write;
    bool speed = false, each = false, trace = false;
    BayesOptions options;
};

std::map<std::string, double*> fieldsOf(BayesOptions& o) {
    auto& s = o.sensors;
    auto& w = o.walking;
    return {{"rate", &s.detectionsPerSecond},
            {"fp", &s.falsePerSecond},
            {"same", &s.sameKind},
            {"fpText", &s.mappedFalseText},
            {"read", &s.textRead},
            {"sigPos", &s.positionSigmaM},
            {"sigBear", &s.bearingSigmaDeg},
            {"speed", &w.speed},
            {"spread", &w.speedSpread},
            {"hurry", &w.hurryShare},
            {"stop", &w.stopRate},
            {"go", &w.goRate},
            {"follow", &w.followShare},
            {"stray", &w.strayRate},
            {"strayNode", &w.strayAtNode},
            {"return", &w.returnRate},
            {"back", &w.straightBack},
            {"sway", &w.swaySigmaDeg},
            {"swayS", &w.swaySeconds},
            {"away", &w.looksAway},
            {"lookGo", &w.lookShareGoing},
            {"lookStand", &w.lookShareStanding},
            {"turn", &w.turnSigmaDeg},
            {"unseen", &w.unknownTurnSigmaDeg},
            {"dist", &w.distanceSigma},
            {"heading", &w.headingTrust},
            {"trust", &o.trust},
            {"trustRep", &o.trustRepeated},
            {"repeat", &o.repeatSeconds},
            {"miss", &o.missTrust},
            {"unmapped", &o.sensors.unmappedShare},
            {"pace", &w.paceTrust},
            {"climb", &o.climbSees},
            {"even", &o.evenness},
            {"lost", &o.lostRate},
            {"blind", &o.blindLostRate},
            {"start", &o.startTrust},
            {"watch", &o.watchSeconds},
            {"resetAt", &o.resetAt},
            {"reset", &o.resetShare}};
}

bool readSettings(const std::string& text, BayesOptions& options) {
    auto fields = fieldsOf(options);
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, ',');) {
        std::size_t at = part.find('=');
        std::string name = part.substr(0, at);
        double value = at == std::string::npos ? 0.0 : std::strtod(part.c_str() + at + 1, nullptr);
        if (name == "walkers") {
            options.walkers = static_cast<std::size_t>(value);
        } else if (fields.count(name) != 0) {
            *fields[name] = value;
        } else {
            std::cerr << "no option " << name << "\n";
            return false;
        }
    }
    return true;
}

bool allUnknown = false; ///< --unknown: no start is told
bool asStudied = false;  ///< --plain: habits and eyes of the localisation study, the same for all walks

test::SimulatedWalk simulated(std::size_t seed, std::size_t which,
                              std::shared_ptr<const building::Building>& building) {
    if (which == 0) building = std::make_shared<building::Building>(test::variedBuildingData(seed));
    test::WalkOptions options = test::variedWalk(seed * 10 + which);
    if (asStudied) {
        options = {};
        options.seed = seed * 10 + which;
    }
    if (allUnknown) options.unknownStart = 1.0;
    return test::simulateWalk(building, options);
}

LoggedWalk madeWalk(std::size_t seed, std::size_t which,
                    std::shared_ptr<const building::Building>& building) {
    test::SimulatedWalk made = simulated(seed, which, building);
    auto walk = cli::parseWalk(building, std::to_string(seed), made.log, made.truth);
    if (!walk) {
        std::cerr << walk.error().text() << "\n";
        std::exit(1);
    }
    return std::move(*walk);
}

class Direct { // straight to the localiser: no route, no cues
public:
    Direct(const LoggedWalk& walk, const BayesOptions& options)
        : m_localiser(localisation::makeBayesLocaliser(walk.building, options)) {}

    void act(const session::LogDetection& line) {
        std::vector<localisation::Observation> seen;
        for (const auto& detection : line.percept.detections)
            seen.push_back({detection, line.percept.time, line.percept.frame, line.percept.scene});
        update(line.percept.time, m_history.add(seen));
    }
    void act(const session::LogStart& line) {
        m_history.clear();
        m_localiser->start(line.time, line.region);
    }
    void act(const session::LogDestination& line) {
        localisation::RouteContext route;
        route.destination = building::Location{RegionId(line.where), std::nullopt};
        m_localiser->setRoute(route);
    }
    void act(const session::LogMotion& line) {
        if (line.motion.turn || line.motion.speed) m_localiser->moved(line.time, line.motion);
        update(line.time, {});
    }
    void act(const session::LogOther&) {}
    localisation::Fix update(double time, const std::vector<localisation::Observation>& fresh) {
        return m_localiser->update(time, fresh, m_history.items());
    }

private:
    std::unique_ptr<localisation::Localiser> m_localiser;
    localisation::NavigationHistory m_history;
};

std::vector<Moment> followed(const LoggedWalk& walk, const BayesOptions& options, bool motion) {
    BayesOptions used = options;
    used.useMotion = motion;
    Direct direct(walk, used);
    std::vector<Moment> moments;
    std::size_t next = 0;
    for (const cli::TruthRow& row : walk.truth) {
        for (; next < walk.lines.size() && cli::timeOf(walk.lines[next]) <= row.time; ++next) {
            if (!motion && std::holds_alternative<session::LogMotion>(walk.lines[next])) continue;
            std::visit([&](const auto& line) { direct.act(line); }, walk.lines[next]);
        }
        moments.push_back({direct.update(row.time, {}), std::nullopt});
    }
    return moments;
}

double logScore(const LoggedWalk& walk, const std::vector<Moment>& moments) {
    constexpr double kLeast = 0.003;
    double sum = 0.0;
    for (std::size_t i = 0; i < moments.size(); ++i) {
        double share = kLeast;
        for (const auto& vote : moments[i].fix.votes)
            if (vote.region == walk.truth[i].region) share = std::max(kLeast, vote.vote);
        sum += std::log(share);
    }
    return sum;
}

void printWalk(const LoggedWalk& walk, const std::vector<Moment>& said) {
    WalkScores one;
    one.add(walk, said, false);
    std::printf("%8s  region %5.1f  near %5.1f  level %5.1f  sure %5.1f  wrong %5.1f  %s\n",
                walk.name.c_str(), one.region.percent(), one.near.percent(), one.level.percent(),
                one.sure.percent(), one.wrongWhenSure.percent(),
                walk.unknownSince.empty() ? "" : "unknown start or carried");
}

/// Second by second: the truth, what was said, and what the truth still weighed.
void traceWalk(const LoggedWalk& walk, const std::vector<Moment>& said) {
    for (std::size_t i = 0; i < said.size(); ++i) {
        const cli::TruthRow& row = walk.truth[i];
        const localisation::Fix& fix = said[i].fix;
        double weight = 0.0;
        for (const auto& vote : fix.votes)
            if (vote.region == row.region) weight = vote.vote;
        double away = fix.position && fix.level == row.level ? distance(*fix.position, row.position) : -1.0;
        std::printf("%6.0f  %-6s %-6s %s  said %-6s  sure %.2f  near %.2f  truth has %.3f  off %5.1f m\n",
                    row.time, row.region.value.c_str(), row.mode.c_str(), row.onRoute ? "  " : "X ",
                    fix.region ? fix.region->value.c_str() : "-", fix.confidence, fix.nearConfidence, weight,
                    away);
    }
}

void measure(const Arguments& arguments) {
    for (bool motion : {false, true}) {
        if (arguments.motion == (motion ? "off" : "on")) continue;
        WalkScores scores;
        double sum = 0.0;
        std::size_t moments = 0;
        for (std::size_t seed = arguments.seed; seed < arguments.seed + arguments.buildings; ++seed) {
            std::shared_ptr<const building::Building> building;
            for (std::size_t which = 0; which < 2; ++which) {
                LoggedWalk walk = madeWalk(seed, which, building);
                std::vector<Moment> said = followed(walk, arguments.options, motion);
                scores.add(walk, said, false);
                if (arguments.each) printWalk(walk, said);
                if (arguments.trace) traceWalk(walk, said);
                sum += logScore(walk, said);
                moments += said.size();
            }
        }
        std::printf("motion %s, %zu moments, mean log share %.4f\n", motion ? "on" : "off", moments,
                    sum / static_cast<double>(moments));
        for (const auto& [name, value] : scores.figures())
            std::printf("  %-45s %8.3f\n", name.c_str(), value);
    }
}

/// The raw shares against what was so, as rising tables.
int calibrate(const Arguments& arguments) {
    std::ostringstream out;
    out << "// Made by bench_localisation --calibrate from walks of our own: do not edit by hand.\n";
    BayesOptions raw = arguments.options;
    raw.rawConfidence = true;
    const char* names[2][2] = {{"kRegion", "kNear"}, {"kRegionByMotion", "kNearByMotion"}};
    for (bool motion : {false, true}) {
        WalkScores scores;
        for (std::size_t seed = arguments.seed; seed < arguments.seed + arguments.buildings; ++seed) {
            std::shared_ptr<const building::Building> building;
            for (std::size_t which = 0; which < 2; ++which) {
                LoggedWalk walk = madeWalk(seed, which, building);
                scores.add(walk, followed(walk, raw, motion), false);
            }
        }
        bench::writeTable(out, names[motion ? 1 : 0][0], bench::risingTable(scores.regionStated));
        bench::writeTable(out, names[motion ? 1 : 0][1], bench::risingTable(scores.nearStated));
    }
    std::ofstream file(arguments.calibrate);
    file << out.str();
    return file.good() ? 0 : 1;
}

int writeWalks(const Arguments& arguments) {
    namespace fs = std::filesystem;
    for (std::size_t seed = arguments.seed; seed < arguments.seed + arguments.buildings; ++seed) {
        fs::path folder = fs::path(arguments.write) / ("b" + std::to_string(seed));
        fs::create_directories(folder);
        std::shared_ptr<const building::Building> building;
        test::SimulatedWalk first = simulated(seed, 0, building);
        if (auto saved = building::saveBuilding(*building, (folder / "map.gpkg").string()); !saved) {
            std::cerr << saved.error().text() << "\n";
            return 1;
        }
        for (std::size_t which = 0; which < 2; ++which) {
            test::SimulatedWalk walk = which == 0 ? first : simulated(seed, which, building);
            std::string name = "w00" + std::to_string(which);
            std::ofstream(folder / (name + ".jsonl")) << walk.log;
            std::ofstream(folder / (name + ".truth.jsonl")) << walk.truth;
        }
    }
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    for (int i = 1; i < argc; ++i) {
        std::string name = argv[i], value = i + 1 < argc ? argv[i + 1] : "";
        std::map<std::string, bool*> flags{{"--speed", &arguments.speed},
                                           {"--each", &arguments.each},
                                           {"--trace", &arguments.trace},
                                           {"--unknown", &allUnknown},
                                           {"--plain", &asStudied}};
        if (auto flag = flags.find(name); flag != flags.end()) {
            *flag->second = true;
            continue;
        }
        ++i;
        if (name == "--buildings")
            arguments.buildings = std::strtoul(value.c_str(), nullptr, 10);
        else if (name == "--seed")
            arguments.seed = std::strtoul(value.c_str(), nullptr, 10);
        else if (name == "--motion")
            arguments.motion = value;
        else if (name == "--calibrate")
            arguments.calibrate = value;
        else if (name == "--write")
            arguments.write = value;
        else if (name != "--set" || !readSettings(value, arguments.options)) {
            std::cerr << "unknown option " << name << "\n";
            return 2;
        }
    }
    if (arguments.speed) return bench::timeLocaliser();
    if (!arguments.calibrate.empty()) return calibrate(arguments);
    if (!arguments.write.empty()) return writeWalks(arguments);
    measure(arguments);
    return 0;
}
