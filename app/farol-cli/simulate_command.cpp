#include "app/farol-cli/commands.h"
#include "app/farol-cli/evaluate/guidance.h"
#include "app/farol-cli/interrupt.h"
#include "app/farol-cli/loop_words.h"
#include "app/farol-cli/output.h"
#include "app/farol-cli/simulated_frames.h"
#include "app/farol-cli/walk_inputs.h"
#include "app/farol-cli/words_application.h"
#include "core/session/closed_loop_picture.h"
#include "core/session/json_fields.h"
#include "core/simulation/sparse_landmarks.h"
#include "core/simulation/walk_route.h"

#include <atomic>
#include <cmath>
#include <utility>

namespace farol::cli {

namespace {

struct SimulateOptions {
    std::string map, library, from, to, out, localiser, truePlace, eyes = "study";
    std::uint64_t seed = 1;
    bool sparseLandmarks = false, obey = false, noVision = false, json = false, unknownStart = false,
         photographs = false, sentences = false, transcript = false;
    double wilfulness = 0.0, framesPerSecond = 5.0, clutter = 0.3;
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
    loop.navigator =
        session::NavigatorOptions::with(!options.localiser.empty()                    ? options.localiser
                                        : options.noVision && options.eyes == "study" ? "bayes-guided-sparse"
                                                                                      : "bayes-guided");
    if (!options.truePlace.empty())
        loop.truePlace = options.truePlace == "spot" ? session::TruePlace::Spot : session::TruePlace::Region;
    loop.knownStart = !options.unknownStart;
    loop.walker.seed = options.seed;
    loop.walker.wilfulness = options.wilfulness;
    loop.framesPerSecond = options.framesPerSecond;
    return loop;
}

/// What a walk with pictures needs, opened once for all walks.
class Studio {
public:
    static std::optional<Studio> open(const SimulateOptions& options,
                                      const std::shared_ptr<const building::Building>& building,
                                      int& exitCode) {
        Studio studio;
        if (!openLibrary(options.library, options.map, studio.m_library, exitCode)) return std::nullopt;
        simulation::SceneOptions scene;
        scene.clutter = options.clutter;
        auto world =
            simulation::buildWorld(building, scene, options.photographs ? studio.m_library.get() : nullptr);
        if (!world) {
            exitCode = report(world.error());
            return std::nullopt;
        }
        studio.m_world.emplace(std::move(world).value());
        return studio;
    }

    const simulation::World& world() const { return *m_world; }
    Result<session::ClosedLoop::Eye> eye(std::uint64_t seed, session::PictureWatcher watcher = {}) {
        simulation::CameraOptions camera;
        camera.seed = seed;
        camera.shake = simulation::Shake::Chest;
        std::vector<std::string> warnings;
        auto made = session::pictureEye(*m_world, camera, m_library, {}, std::move(watcher), warnings);
        if (!std::exchange(m_warned, true)) warnAll(warnings);
        return made;
    }

private:
    std::shared_ptr<const recognition::LandmarkLibrary> m_library;
    std::optional<simulation::World> m_world;
    bool m_warned = false;
};

simulation::TruthDetectionOptions drawnDetections(const SimulateOptions& options, std::uint64_t seed) {
    simulation::TruthDetectionOptions detections;
    if (options.eyes == "camera") detections = simulation::TruthDetectionOptions::ofCamera();
    detections.seed = seed;
    return detections;
}

Result<session::ClosedLoop::Eye> eyeOf(const SimulateOptions& options, std::optional<Studio>& studio,
                                       const std::shared_ptr<const simulation::WalkWorld>& world,
                                       const std::shared_ptr<SimulatedFrames>& frames) {
    if (!studio) {
        return session::truthEye(world, drawnDetections(options, options.seed));
    }
    session::PictureWatcher watcher;
    if (frames)
        watcher = [frames](std::uint64_t index, const simulation::RenderedFrame& picture) {
            return frames->write(index, picture);
        };
    return studio->eye(options.seed, std::move(watcher));
}

int obey(const SimulateOptions& options, const std::shared_ptr<const simulation::WalkWorld>& world,
         const building::Location& from, const building::Location& to, std::optional<Studio>& studio,
         const std::shared_ptr<SimulatedFrames>& frames) {
    auto eye = eyeOf(options, studio, world, frames);
    if (!eye) return report(eye.error());
    auto loop = session::ClosedLoop::create(world, from, to, loopOptions(options), std::move(eye).value());
    if (!loop) return report(loop.error());
    if (options.sentences) (*loop)->setEar(sentenceEar());
    LoopTranscript transcript(world->building());
    if (options.transcript)
        (*loop)->onMoment([&](const session::ClosedLoopMoment& moment) { transcript.moment(moment); });
    auto result = (*loop)->run();
    if (!result) return report(result.error());
    if (options.json) {
        printLine(session::dumped(jsonOf(*result)));
    } else {
        std::printf("%s: %.1f s, %.1f m (shortest %.1f m), %d cues, %d wrong places told\n",
                    result->reason.c_str(), result->seconds, result->metres, result->shortestM, result->cues,
                    result->wrongRegionSaid);
    }
    return kDone;
}

/// Somebody who knows the way walks it: frames and truth, and nobody is guided.
int walkTheRoute(const SimulateOptions& options, const building::Location& from, const building::Location& to,
                 const Studio& studio, const std::shared_ptr<SimulatedFrames>& frames) {
    auto planner = routing::makeOptimalPlanner(studio.world().building());
    auto route = planner->plan(from, to);
    if (!route) return report(route.error());
    simulation::WalkerOptions walker;
    walker.seed = options.seed;
    simulation::CameraOptions lens;
    lens.seed = options.seed;
    lens.shake = simulation::Shake::Chest;
    auto camera = simulation::SimulatedCamera::create(studio.world(), lens);
    if (!camera) return report(camera.error());
    auto poses = simulation::posesAlong(*route, walker, options.framesPerSecond);
    std::atomic<bool> stopped{false};
    Interrupt interrupt([&] { stopped = true; });
    std::uint64_t index = 0;
    for (const simulation::CameraPose& pose : poses) {
        if (stopped) return kFailed;
        auto picture = camera->render(pose);
        if (!picture) return report(picture.error());
        if (frames)
            if (auto written = frames->write(index, *picture); !written) return report(written.error());
        ++index;
    }
    if (options.json) {
        session::Json json;
        json["frames"] = index;
        json["seconds"] = rounded(poses.back().time);
        json["shortest_m"] = rounded(route->lengthM);
        printLine(session::dumped(json));
    } else {
        std::printf("%llu frames of %.1f m\n", static_cast<unsigned long long>(index), route->lengthM);
    }
    return kDone;
}

int walkOne(const SimulateOptions& options, const std::shared_ptr<const simulation::WalkWorld>& world,
            std::optional<Studio>& studio) {
    int exitCode = kDone;
    std::optional<building::Location> from, to;
    if (!findPlace(world->building(), "--from", options.from, from, exitCode)) return exitCode;
    if (!findPlace(world->building(), "--to", options.to, to, exitCode)) return exitCode;
    if (!from || !to)
        return report(
            {ErrorCode::InvalidArgument, "tell where the walk begins and where it leads", "--from, --to"});
    std::shared_ptr<SimulatedFrames> frames;
    if (!options.out.empty()) {
        auto made = SimulatedFrames::create(options.out);
        if (!made) return report(made.error());
        frames = std::move(made).value();
    }
    return options.obey ? obey(options, world, *from, *to, studio, frames)
                        : walkTheRoute(options, *from, *to, *studio, frames);
}

int walkMany(const SimulateOptions& options, const std::shared_ptr<const simulation::WalkWorld>& world,
             std::optional<Studio>& studio) {
    PairsOptions pairs;
    pairs.walks = options.walks;
    pairs.seed = options.seed;
    pairs.loop = loopOptions(options);
    if (options.sentences) pairs.ear = sentenceEar();
    if (studio) pairs.eye = [&](std::uint64_t seed) { return studio->eye(seed); };
    if (!studio && options.eyes == "camera")
        pairs.eye = [&](std::uint64_t seed) -> Result<session::ClosedLoop::Eye> {
            return session::truthEye(world, drawnDetections(options, seed));
        };
    auto figures = walkPairs(world, pairs);
    if (!figures) return report(figures.error());
    session::Json all = session::Json::array();
    for (const WalkedPair& walk : figures->walks) {
        session::Json json = jsonOf(walk.result);
        json["from"] = walk.from;
        json["to"] = walk.to;
        json["seed"] = walk.seed;
        json["end"] = session::walkEndName(walk.result.end);
        all.push_back(std::move(json));
    }
    if (options.json) {
        session::Json json;
        json["walks"] = std::move(all);
        for (const auto& [name, value] : figures->figures()) json["figures"][name] = value;
        for (const auto& [end, count] : figures->failures()) json["failures"][end] = count;
        printLine(session::dumped(json));
        return kDone;
    }
    for (const auto& [name, value] : figures->figures()) std::printf("%-48s %g\n", name.c_str(), value);
    for (const auto& [end, count] : figures->failures()) std::printf("  %-46s %d\n", end.c_str(), count);
    return kDone;
}

int simulate(const SimulateOptions& options) {
    if (options.noVision && (!options.out.empty() || !options.obey))
        return report(
            {ErrorCode::InvalidArgument,
             "without pictures there is nothing to write and nobody to see the way: --no-vision goes with "
             "--obey and without --out",
             "--no-vision"});
    if (!options.noVision && options.eyes != "study")
        return report({ErrorCode::InvalidArgument,
                       "pictures are looked at by the program itself: --eyes goes with --no-vision",
                       "--eyes"});
    if (options.walks > 0 && (!options.obey || !options.out.empty()))
        return report({ErrorCode::InvalidArgument, "many walks go with --obey and without --out", "--walks"});
    int exitCode = kDone;
    auto building = openMap(options.map, exitCode);
    if (!building) return exitCode;
    if (options.sparseLandmarks) {
        building = simulation::withSparseLandmarks(*building);
        if (!options.json)
            warn(std::to_string(building->landmarks().size()) + " landmarks, those added by rule included");
    }
    std::optional<Studio> studio;
    if (!options.noVision) {
        studio = Studio::open(options, building, exitCode);
        if (!studio) return exitCode;
    }
    auto world = std::make_shared<const simulation::WalkWorld>(building);
    // English has plurals of its own: "1 metre", "2 metres".
    std::optional<WordsApplication> words;
    if (options.sentences || options.transcript) words.emplace("en");
    return options.walks > 0 ? walkMany(options, world, studio) : walkOne(options, world, studio);
}

constexpr char kExamples[] =
    "Examples:\n"
    "  farol-cli simulate office.gpkg --from Bar --to 2.14 --out walk/\n"
    "  farol-cli simulate office.gpkg --from Bar --to 2.14 --obey --library office-library.gpkg --json\n"
    "  farol-cli simulate office.gpkg --from Bar --to 2.14 --obey --no-vision --seed 7 --json\n"
    "  farol-cli simulate office.gpkg --obey --no-vision --walks 100\n"
    "WHERE: a region id, a unique name or ref, or x,y,level. --out writes frames/ and truth.jsonl.\n";

} // namespace

void addSimulateCommand(CLI::App& app, int& exitCode) {
    auto options = std::make_shared<SimulateOptions>();
    CLI::App* command =
        app.add_subcommand("simulate", "A person with a camera walks through a map: frames and truth");
    command->footer(kExamples);
    command->add_option("MAP", options->map, "Building file or connection string")->required();
    command->add_option("--from", options->from, "Where the walk starts (WHERE)");
    command->add_option("--to", options->to, "Destination (WHERE)");
    command->add_option("--library", options->library,
                        "Trained landmarks; without it the map's own file is looked into");
    command->add_option("--seed", options->seed, "Of everything that is drawn by chance")
        ->capture_default_str();
    command->add_flag("--obey", options->obey,
                      "The walker hears the cues, and nothing else: the closed loop");
    command->add_flag("--sentences", options->sentences,
                      "The walker hears nothing but the English sentences, without what they were made of");
    command->add_flag("--transcript", options->transcript,
                      "Print where the walker of one walk really is, what is recognised and what is said");
    command->add_flag("--no-vision", options->noVision,
                      "Detections drawn from the truth instead of pictures");
    command
        ->add_option("--eyes", options->eyes,
                     "Without pictures: as poor as those of the localisation study, or as this program's own")
        ->check(CLI::IsMember({"study", "camera"}))
        ->capture_default_str();
    command->add_option("--out", options->out, "New folder for the frames and their truth");
    command->add_flag("--unknown-start", options->unknownStart, "Nobody tells where the walk starts");
    command->add_option("--wilful", options->wilfulness, "Chance, at each door, to take it unasked")
        ->check(CLI::Range(0.0, 1.0));
    command->add_option("--localiser", options->localiser,
                        "One of farol-cli run's (bayes-guided; without pictures bayes-guided-sparse)");
    command
        ->add_option("--true-place", options->truePlace,
                     "Tell the navigator the true place instead: region, or spot (with position and heading)")
        ->check(CLI::IsMember({"region", "spot"}));
    command->add_option("--fps", options->framesPerSecond, "Frames a second")
        ->capture_default_str()
        ->check(CLI::Range(0.2, 100.0));
    command->add_option("--clutter", options->clutter, "Things that are not in the map: 0 none, 1 crowded")
        ->capture_default_str()
        ->check(CLI::Range(0.0, 1.0));
    command
        ->add_option("--walks", options->walks, "So many walks between pairs drawn by chance instead of one")
        ->check(CLI::Range(0, 100000));
    command->add_flag("--sparse-landmarks", options->sparseLandmarks,
                      "Add extinguishers, exit signs and door plates by rule where the map has none");
    command->add_flag("--json", options->json, "One JSON document");
    command->callback([options, &exitCode] { exitCode = simulate(*options); });
}

} // namespace farol::cli
