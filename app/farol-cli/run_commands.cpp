#include "app/farol-cli/commands.h"
#include "app/farol-cli/interrupt.h"
#include "app/farol-cli/output.h"
#include "app/farol-cli/walk_inputs.h"
#include "app/farol-cli/walk_printer.h"
#include "app/farol-cli/walk_speech.h"
#include "app/farol-cli/words_application.h"
#include "core/building/geopackage.h"
#include "core/session/navigation_session.h"
#include "core/session/recorder.h"
#include "core/simulation/walk_source.h"
#include "ui/speech/phrasebook.h"

#include <cstring>
#include <map>
#include <utility>

namespace farol::cli {

namespace {

struct RunOptions {
    std::string map, library, source, from, to, localiser = "voting", verbosity = "objects", record, detector,
                                                camera, language = "en";
    double framesPerSecond = 0.0, viewDegrees = 0.0;
    std::uint64_t seed = 1;
    bool realTime = false, speak = false, jsonLines = false;
};

struct ReplayOptions {
    std::string folder, localiser, language = "en";
    bool jsonLines = false;
};

constexpr char kSimulated[] = "sim:";

constexpr char kRunExamples[] =
    "Examples:\n"
    "  farol-cli run --map office.gpkg --library office-library.gpkg --source pictures/ --fps 1 --to \"Room "
    "2.14\"\n"
    "  farol-cli run --map office.gpkg --source camera:0 --to cafe --speak --lang pt --record monday/\n"
    "  farol-cli run --map office.gpkg --source walk.mp4 --json-lines > walk.jsonl\n"
    "  farol-cli run --map office.gpkg --library office-library.gpkg --source \"sim:Bar\" --to 2.14\n"
    "SOURCE: camera:0, a video file, a folder of pictures in natural order, an http or rtsp address, or\n"
    "sim:WHERE, a simulated walker who starts there and hears what is said.\n"
    "WHERE: a region id, a unique name or ref, or x,y,level. Ctrl-C ends the walk.\n";
constexpr char kReplayExamples[] = "Examples:\n"
                                   "  farol-cli replay monday/\n"
                                   "  farol-cli replay monday/ --localiser voting-literal --json-lines\n";

const std::map<std::string, guidance::Verbosity>& verbosities() {
    static const std::map<std::string, guidance::Verbosity> kNames{
        {"directions", guidance::Verbosity::Directions},
        {"objects", guidance::Verbosity::Objects},
        {"texts", guidance::Verbosity::ObjectsAndTexts}};
    return kNames;
}

session::SessionOptions sessionOptions(const RunOptions& options) {
    session::SessionOptions session;
    session.navigator = session::NavigatorOptions::with(options.localiser);
    session.navigator.guidance.verbosity = verbosities().at(options.verbosity);
    session.navigator.guidance.language = ui::installedLanguage().toStdString();
    session.pace =
        options.realTime || options.speak ? session::Pace::RealTime : session::Pace::AsFastAsPossible;
    if (!options.record.empty()) session.recordFolder = options.record;
    session.mapName = options.map;
    session.libraryName = options.library;
    session.sourceName = options.source;
    return session;
}

/// The simulated walker of sim:WHERE; null for all other sources, and where `exitCode` tells of a failure.
std::unique_ptr<simulation::WalkSource>
openSimulation(const RunOptions& options, const std::shared_ptr<const building::Building>& building,
               int& exitCode) {
    std::optional<building::Location> start;
    std::string where = options.source.substr(std::strlen(kSimulated));
    if (where.empty()) {
        exitCode = report(
            {ErrorCode::InvalidArgument, "tell where the simulated walk starts: sim:WHERE", "--source"});
        return nullptr;
    }
    if (!findPlace(*building, "--source", where, start, exitCode)) return nullptr;
    auto world = simulation::buildWorld(building);
    if (!world) {
        exitCode = report(world.error());
        return nullptr;
    }
    simulation::WalkSourceOptions walk;
    walk.walker.seed = walk.camera.seed = options.seed;
    walk.camera.shake = simulation::Shake::Chest;
    if (options.framesPerSecond > 0.0) walk.framesPerSecond = options.framesPerSecond;
    auto source = simulation::WalkSource::create(*world, *start, walk);
    if (source) return std::move(source).value();
    exitCode = report(source.error());
    return nullptr;
}

session::SessionHandlers handlersFor(WalkPrinter& printer, WalkSpeech* speech, simulation::WalkSource* walk) {
    session::SessionHandlers handlers;
    handlers.step = [&printer, speech, walk](const session::NavigationStep& step, const session::HopTimes&) {
        printer.step(step);
        if (speech != nullptr) speech->step(step);
        if (walk != nullptr) walk->answer(step.percept.frame, step.cues);
    };
    handlers.warning = [&printer, speech](const guidance::Cue& cue) {
        printer.warning(cue);
        if (speech != nullptr) speech->warning(cue);
    };
    handlers.message = [&printer](double time, std::uint64_t frame, const std::string& text) {
        printer.message(time, frame, text);
    };
    handlers.state = [speech](session::RunState state) {
        bool over = state == session::RunState::Ended || state == session::RunState::Failed;
        if (over && speech != nullptr) speech->finish();
    };
    return handlers;
}

int walk(session::NavigationSession& session, WalkSpeech* speech) {
    {
        Interrupt interrupt([&] {
            session.stop();
            if (speech != nullptr) speech->abort();
        });
        session.start();
        if (speech != nullptr) speech->run();
        session.wait();
    }
    session.stop();
    auto last = session.snapshot();
    if (last && last->framesDropped > 0)
        warn(std::to_string(last->framesDropped) + " frames came too fast and were dropped");
    if (last && last->framesSkipped > 0)
        warn(std::to_string(last->framesSkipped) + " frames could not be read");
    return session.state() == session::RunState::Failed ? kFailed : kDone;
}

/// The camera's file and the user's own detector.
Result<void> loadEyes(const RunOptions& options, session::PerceptionOptions& perception) {
    if (!options.camera.empty()) {
        auto camera = recognition::loadCamera(options.camera);
        if (!camera) return camera.error();
        perception.useCamera(*camera);
    } else if (options.viewDegrees > 0.0) {
        perception.useView(options.viewDegrees);
    }
    if (options.detector.empty()) return {};
    auto own = recognition::NetworkDetector::load(options.detector);
    if (!own) return own.error();
    perception.ownDetector = std::make_shared<recognition::NetworkDetector>(std::move(own).value());
    return {};
}

int run(const RunOptions& options) {
    int exitCode = kDone;
    WordsApplication application(options.language);
    auto building = openMap(options.map, exitCode);
    if (!building) return exitCode;
    std::optional<building::Location> start, destination;
    if (!findPlace(*building, "--from", options.from, start, exitCode)) return exitCode;
    if (!findPlace(*building, "--to", options.to, destination, exitCode)) return exitCode;
    std::shared_ptr<const recognition::LandmarkLibrary> library;
    if (!openLibrary(options.library, options.map, library, exitCode)) return exitCode;
    simulation::WalkSource* walker = nullptr;
    std::unique_ptr<capture::FrameSource> source;
    if (options.source.rfind(kSimulated, 0) == 0) {
        auto simulated = openSimulation(options, building, exitCode);
        if (!simulated) return exitCode;
        walker = simulated.get();
        source = std::move(simulated);
    } else {
        capture::SourceOptions sourceOptions;
        sourceOptions.framesPerSecond = options.framesPerSecond;
        auto opened = capture::openSource(options.source, sourceOptions);
        if (!opened) return report(opened.error());
        source = std::move(opened).value();
    }

    session::SessionOptions sessions = sessionOptions(options);
    if (auto loaded = loadEyes(options, sessions.perception); !loaded) return report(loaded.error());
    // A simulated walker hears every cue; people hear what is spoken.
    sessions.navigator.heardIsReported = options.speak && walker == nullptr;
    WalkPrinter printer(options.jsonLines, building);
    std::optional<WalkSpeech> speech;
    if (options.speak) speech.emplace(options.language);
    auto session =
        session::NavigationSession::create(building, library, std::move(source), sessions,
                                           handlersFor(printer, speech ? &*speech : nullptr, walker));
    if (!session) return report(session.error());
    if (start) (*session)->setStart(start->region);
    if (destination) (*session)->setDestination(destination);
    if (speech) speech->setHeard([&](const guidance::Cue& cue) { (*session)->heard(cue.id); });
    return walk(**session, speech ? &*speech : nullptr);
}

int replayRecording(const ReplayOptions& options) {
    int exitCode = kDone;
    WordsApplication application(options.language);
    auto recording = session::loadRecording(options.folder);
    if (!recording) return report(recording.error());
    warnAll(recording->warnings);
    auto building = openMap((recording->folder / "map.gpkg").string(), exitCode);
    if (!building) return exitCode;
    session::NavigatorOptions navigator = recording->header.options;
    if (!options.localiser.empty()) navigator.localiser = options.localiser;
    WalkPrinter printer(options.jsonLines, building);
    session::ReplayHandlers handlers;
    handlers.step = [&](const session::NavigationStep& step) { printer.step(step); };
    handlers.warning = [&](const guidance::Cue& cue) { printer.warning(cue); };
    handlers.message = [&](double time, std::uint64_t frame, const std::string& text) {
        printer.message(time, frame, text);
    };
    if (auto replayed = session::replay(*recording, building, navigator, handlers); !replayed)
        return report(replayed.error());
    return kDone;
}

void addRun(CLI::App& app, int& exitCode) {
    auto options = std::make_shared<RunOptions>();
    CLI::App* command = app.add_subcommand("run", "Walks: frames in, the way out as words or as JSON lines");
    command->footer(kRunExamples);
    command->add_option("--map", options->map, "Building file or connection string")->required();
    command->add_option("--library", options->library,
                        "Trained landmarks; without it the map's own file is looked into");
    command->add_option("--source", options->source, "Where the pictures come from")->required();
    command->add_option("--detector", options->detector,
                        "Description (*.json) of a detector of your own that looks too");
    CLI::Option* camera =
        command->add_option("--camera", options->camera, "Camera file of farol-cli calibrate: for distances");
    command
        ->add_option("--view", options->viewDegrees,
                     "Degrees that the longer side of an uncalibrated camera's picture spans (usual: 60)")
        ->check(CLI::Range(20.0, 140.0))
        ->excludes(camera);
    command->add_option("--fps", options->framesPerSecond, "Pictures a second of a folder (default 1)")
        ->check(CLI::Range(0.01, 1000.0));
    command->add_option("--seed", options->seed, "Of a simulated walk")->capture_default_str();
    command->add_option("--from", options->from, "Where the walk starts, if that is known (WHERE)");
    command->add_option("--to", options->to, "Destination (WHERE)");
    command
        ->add_option("--localiser", options->localiser,
                     "voting, voting-literal, bayes, bayes-guided or bayes-guided-sparse")
        ->capture_default_str();
    command
        ->add_option("--verbosity", options->verbosity,
                     "What is told: directions, objects (too), texts (too)")
        ->capture_default_str()
        ->check(CLI::IsMember({"directions", "objects", "texts"}));
    command->add_flag("--realtime", options->realTime,
                      "At the pictures' own pace; what comes too late is dropped");
    command->add_flag("--speak", options->speak, "Speak the utterances (implies --realtime)");
    command->add_option("--record", options->record, "New folder for a recording of the walk");
    command->add_flag("--json-lines", options->jsonLines, "One JSON object a line instead of a transcript");
    command->add_option("--lang", options->language, "Language of the words: en, pt, es, fr, de")
        ->capture_default_str();
    command->callback([options, &exitCode] { exitCode = run(*options); });
}

void addReplay(CLI::App& app, int& exitCode) {
    auto options = std::make_shared<ReplayOptions>();
    CLI::App* command = app.add_subcommand("replay", "The same lines again from a recording");
    command->footer(kReplayExamples);
    command->add_option("DIR", options->folder, "The recording")->required();
    command->add_option("--localiser", options->localiser,
                        "Vote again with this one instead of the recorded one");
    command->add_flag("--json-lines", options->jsonLines, "One JSON object a line instead of a transcript");
    command->add_option("--lang", options->language, "Language of the words: en, pt, es, fr, de")
        ->capture_default_str();
    command->callback([options, &exitCode] { exitCode = replayRecording(*options); });
}

} // namespace

void addRunCommands(CLI::App& app, int& exitCode) {
    addRun(app, exitCode);
    addReplay(app, exitCode);
}

} // namespace farol::cli
