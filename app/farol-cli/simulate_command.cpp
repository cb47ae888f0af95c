#include "app/farol-cli/commands.h"
#include "app/farol-cli/evaluate/guidance.h"
#include "app/farol-cli/output.h"
#include "app/farol-cli/walk_inputs.h"
#include "core/session/closed_loop.h"
#include "core/session/json_fields.h"

#include <cmath>

namespace farol::cli {

namespace {

struct SimulateOptions {
    std::string map, from, to, localiser = "bayes";
    std::uint64_t seed = 1;
    bool obey = false, noVision = false, json = false, unknownStart = false;
    double wilfulness = 0.0;
    int walks = 0;
};

double rounded(double value) {
    return std::round(value * 1000.0) / 1000.0;
}

session::Json jsonOf(const session::ClosedLoopResult& result) {
    session::Json json;
    json["arrived"] = result.arrived;
    json["announced_arrival"] = result.announcedArrival;
    json["seconds"] = rounded(result.seconds);
    json["metres"] = rounded(result.metres);
    json["shortest_m"] = rounded(result.shortestM);
    json["shortest_s"] = rounded(result.shortestS);
    json["wrong_region_said"] = result.wrongRegionSaid;
    json["cues"] = result.cues;
    json["reason"] = result.reason;
    return json;
}

session::ClosedLoopOptions loopOptions(const SimulateOptions& options) {
    session::ClosedLoopOptions loop;
    loop.navigator.localiser = options.localiser;
    loop.knownStart = !options.unknownStart;
    loop.walker.seed = options.seed;
    loop.walker.wilfulness = options.wilfulness;
    return loop;
}

int walkOne(const SimulateOptions& options, const std::shared_ptr<const simulation::WalkWorld>& world) {
    int exitCode = kDone;
    std::optional<building::Location> from, to;
    if (!findPlace(world->building(), "--from", options.from, from, exitCode)) return exitCode;
    if (!findPlace(world->building(), "--to", options.to, to, exitCode)) return exitCode;
    if (!from || !to)
        return report(
            {ErrorCode::InvalidArgument, "tell where the walk begins and where it leads", "--from, --to"});
    simulation::TruthDetectionOptions detections;
    detections.seed = options.seed;
    auto loop = session::ClosedLoop::create(world, *from, *to, loopOptions(options),
                                            session::truthEye(world, detections));
    if (!loop) return report(loop.error());
    auto result = (*loop)->run();
    if (!result) return report(result.error());
    printLine(session::dumped(jsonOf(*result)));
    return kDone;
}

int walkMany(const SimulateOptions& options, const std::shared_ptr<const simulation::WalkWorld>& world) {
    PairsOptions pairs;
    pairs.walks = options.walks;
    pairs.seed = options.seed;
    pairs.loop = loopOptions(options);
    auto figures = walkPairs(world, pairs);
    if (!figures) return report(figures.error());
    for (const WalkedPair& walk : figures->walks) {
        session::Json json = jsonOf(walk.result);
        json["from"] = walk.from;
        json["to"] = walk.to;
        json["seed"] = walk.seed;
        json["end"] = session::walkEndName(walk.result.end);
        printLine(session::dumped(json));
    }
    for (const auto& [name, value] : figures->figures()) printLine(name + ": " + std::to_string(value));
    for (const auto& [end, count] : figures->failures()) printLine("  " + end + ": " + std::to_string(count));
    return kDone;
}

int simulate(const SimulateOptions& options) {
    int exitCode = kDone;
    auto building = openMap(options.map, exitCode);
    if (!building) return exitCode;
    if (!options.obey || !options.noVision)
        return report(
            {ErrorCode::InvalidArgument,
             "a walk is simulated for a walker who obeys, without pictures: give --obey and --no-vision",
             "simulate"});
    auto world = std::make_shared<const simulation::WalkWorld>(building);
    return options.walks > 0 ? walkMany(options, world) : walkOne(options, world);
}

} // namespace

void addSimulateCommand(CLI::App& app, int& exitCode) {
    auto options = std::make_shared<SimulateOptions>();
    CLI::App* command = app.add_subcommand("simulate", "Walks a simulated person through a map");
    command->footer(
        "Example:\n  farol-cli simulate office.gpkg --from Bar --to 2.14 --obey --no-vision --json\n");
    command->add_option("MAP", options->map, "Building file or connection string")->required();
    command->add_option("--from", options->from, "Where the walk starts (WHERE)");
    command->add_option("--to", options->to, "Destination (WHERE)");
    command->add_option("--seed", options->seed, "Of everything that is drawn by chance")
        ->capture_default_str();
    command->add_flag("--obey", options->obey, "The walker hears the cues, and nothing else");
    command->add_flag("--no-vision", options->noVision,
                      "Detections drawn from the truth instead of pictures");
    command->add_flag("--unknown-start", options->unknownStart, "Nobody tells where the walk starts");
    command->add_option("--wilful", options->wilfulness, "Chance to take a door that nobody spoke of")
        ->check(CLI::Range(0.0, 1.0));
    command->add_option("--localiser", options->localiser, "voting, voting-literal or bayes")
        ->capture_default_str();
    command
        ->add_option("--walks", options->walks, "So many walks between pairs drawn by chance instead of one")
        ->check(CLI::Range(0, 100000));
    command->add_flag("--json", options->json, "One JSON document");
    command->callback([options, &exitCode] { exitCode = simulate(*options); });
}

} // namespace farol::cli
