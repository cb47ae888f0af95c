#include "app/farol-cli/commands.h"
#include "app/farol-cli/output.h"
#include "core/capture/frame_source.h"
#include "core/capture/picture.h"
#include "core/recognition/door_detector.h"
#include "core/recognition/landmark_recogniser.h"
#include "core/recognition/network_detector.h"
#include "core/recognition/rectangle_detector.h"
#include "core/recognition/sign_detector.h"
#include "core/recognition/stairs_detector.h"
#include "core/recognition/text_reader.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <memory>

namespace farol::cli {

namespace {

using Json = nlohmann::ordered_json;
using namespace recognition;
namespace fs = std::filesystem;

double cpuMilliseconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

double rounded(double value, double steps) {
    return std::round(value * steps) / steps;
}

Json quadJson(const Quad& quad) {
    Json json = Json::array();
    for (const ImagePoint& p : quad) json.push_back(Json::array({rounded(p.x, 100.0), rounded(p.y, 100.0)}));
    return json;
}

/// One picture of an argument: the file's path (the video's for its frames), and the frame itself.
struct Picture {
    std::string file;
    bool ofVideo = false;
    capture::Frame frame;
};

using Look = std::function<DetectorResult(const cv::Mat&)>;
using DetectionJson = std::function<Json(const Detection&)>;

Json pictureJson(const Picture& picture, double milliseconds, const DetectorResult& found,
                 const DetectionJson& one) {
    Json json;
    json["file"] = picture.file;
    if (picture.ofVideo) {
        json["frame"] = picture.frame.index;
        json["t"] = rounded(picture.frame.capturedAt, 1000.0);
    }
    json["size"] = Json::array({picture.frame.image.cols, picture.frame.image.rows});
    json["ms"] = rounded(milliseconds, 100.0);
    json["detections"] = Json::array();
    for (const Detection& detection : found.detections) json["detections"].push_back(one(detection));
    return json;
}

void printForPeople(const Picture& picture, const DetectorResult& found) {
    std::string name =
        picture.file + (picture.ofVideo ? " frame " + std::to_string(picture.frame.index) : "");
    if (found.detections.empty()) printLine(name + ": nothing");
    for (const Detection& d : found.detections) {
        std::string what(kindName(d.kind));
        if (!d.templateId.empty()) what += " " + d.templateId.value;
        if (!d.text.empty()) what += " \"" + d.text + "\"";
        char score[32];
        std::snprintf(score, sizeof score, "%.2f", d.score);
        printLine(name + ": " + what + ", " + std::string(zoneName(d.zone())) + ", score " + score +
                  (d.inliers > 0 ? ", " + std::to_string(d.inliers) + " points" : ""));
    }
}

/// Looks at every picture of the arguments in turn. What cannot be read is told and skipped; only when
/// nothing at all could be read is that a failure.
int lookAtAll(const std::vector<std::string>& sources, bool jsonLines, const Look& look,
              const DetectionJson& one) {
    std::uint64_t seen = 0;
    for (const std::string& name : sources) {
        auto source = capture::openSource(name);
        if (!source) {
            report(source.error());
            continue;
        }
        (*source)->onEvent([&](const capture::SourceEvent& event) { warn(event.message); });
        std::error_code ignored;
        bool folder = fs::is_directory(name, ignored);
        while (auto frame = (*source)->next()) {
            Picture picture{name, frame->name.empty(), std::move(*frame)};
            if (folder) picture.file = (fs::path(name) / picture.frame.name).string();
            double start = cpuMilliseconds();
            DetectorResult found = look(picture.frame.image);
            double spent = cpuMilliseconds() - start;
            ++seen;
            if (jsonLines)
                printLine(pictureJson(picture, spent, found, one)
                              .dump(-1, ' ', false, Json::error_handler_t::replace));
            else
                printForPeople(picture, found);
        }
    }
    if (seen > 0) return kDone;
    std::fprintf(stderr, "farol-cli: none of the pictures could be read\n");
    return kFailed;
}

int recognise(const std::string& path, const std::vector<std::string>& sources, bool jsonLines) {
    auto library = loadLibrary(path);
    if (!library) return reportLibrary(library.error(), path);
    LandmarkRecogniser recogniser(std::make_shared<const LandmarkLibrary>(std::move(*library)));
    return lookAtAll(
        sources, jsonLines, [&](const cv::Mat& image) { return recogniser.recognise(image); },
        [](const Detection& d) {
            Json json;
            json["template"] = d.templateId.value;
            json["kind"] = std::string(kindName(d.kind));
            json["score"] = rounded(d.score, 10000.0);
            json["inliers"] = d.inliers;
            json["quad"] = quadJson(d.quad);
            json["zone"] = std::string(zoneName(d.zone()));
            return json;
        });
}

struct DetectArguments {
    std::vector<std::string> sources;
    std::vector<std::string>
        only; ///< empty: all of ours, or none of them beside a detector of the user's own
    std::string detector;
    bool jsonLines = false;
};

/// Those that keep something from picture to picture, or are slow to begin.
struct Detectors {
    std::unique_ptr<TextReader> reader;
    std::unique_ptr<SignDetector> signs;
    std::unique_ptr<NetworkDetector> own;
};

const std::vector<std::string>& detectorNames() {
    static const std::vector<std::string> kNames{"doors", "stairs", "rectangles", "signs", "text"};
    return kNames;
}

int detect(const DetectArguments& arguments) {
    const auto& known = detectorNames();
    for (const std::string& name : arguments.only)
        if (std::find(known.begin(), known.end(), name) == known.end())
            return report(
                {ErrorCode::InvalidArgument,
                 "there is no detector \"" + name + "\"; there are doors, stairs, rectangles, signs and text",
                 "--only"});
    bool all = arguments.only.empty() && arguments.detector.empty();
    auto wanted = [&](const char* name) {
        return all || std::find(arguments.only.begin(), arguments.only.end(), name) != arguments.only.end();
    };
    Detectors detectors;
    if (wanted("text")) {
        auto made = TextReader::create();
        if (!made) return report(made.error());
        detectors.reader = std::make_unique<TextReader>(std::move(*made));
    }
    if (wanted("signs")) detectors.signs = std::make_unique<SignDetector>();
    if (!arguments.detector.empty()) {
        auto loaded = NetworkDetector::load(arguments.detector);
        if (!loaded) return report(loaded.error());
        detectors.own = std::make_unique<NetworkDetector>(std::move(*loaded));
    }
    auto look = [&](const cv::Mat& image) {
        DetectorResult result;
        if (wanted("doors")) result.append(detectDoors(image));
        if (wanted("stairs")) result.append(detectStairs(image));
        if (wanted("rectangles")) result.append(detectRectangles(image));
        if (detectors.signs) result.append(detectors.signs->detect(image));
        if (detectors.own) result.append(detectors.own->detect(image));
        if (detectors.reader) result.append(detectors.reader->read(image));
        return result;
    };
    return lookAtAll(arguments.sources, arguments.jsonLines, look, [](const Detection& d) {
        Json json;
        json["kind"] = std::string(kindName(d.kind));
        json["quad"] = quadJson(d.quad);
        json["zone"] = std::string(zoneName(d.zone()));
        json["score"] = rounded(d.score, 10000.0);
        if (d.kind == Kind::Text || !d.text.empty()) json["text"] = d.text;
        return json;
    });
}

void addDetect(CLI::App& app, int& exitCode) {
    auto arguments = std::make_shared<DetectArguments>();
    CLI::App* detecting =
        app.add_subcommand("detect", "Find doors, stairs, rectangles, signs and text in pictures");
    detecting->footer("Examples:\n  farol-cli detect --only doors,text corridor.jpg --json-lines\n"
                      "  farol-cli detect --detector signs.json walk/\n"
                      "A detector of your own is an ONNX file and a description of it in JSON: see "
                      "docs/own-detector.md.\n");
    detecting
        ->add_option("--only", arguments->only, "Detectors to run: doors, stairs, rectangles, signs, text")
        ->delimiter(',');
    detecting->add_option("--detector", arguments->detector,
                          "Description (*.json) of a detector of your own; of ours only those of --only run "
                          "beside it");
    detecting->add_option("pictures", arguments->sources, "Pictures, folders of pictures, videos")
        ->required();
    detecting->add_flag("--json-lines", arguments->jsonLines, "One JSON object a picture");
    detecting->callback([arguments, &exitCode] { exitCode = detect(*arguments); });
}

} // namespace

void addRecogniseCommands(CLI::App& app, int& exitCode) {
    struct Arguments {
        std::string library;
        std::vector<std::string> sources;
        bool jsonLines = false;
    };
    auto arguments = std::make_shared<Arguments>();
    CLI::App* recognising = app.add_subcommand("recognise", "Find a library's templates in pictures");
    recognising->footer("Example:\n  farol-cli recognise corridor.gpkg walk/ --json-lines");
    recognising->add_option("library", arguments->library, "Library or map (*.gpkg)")->required();
    recognising->add_option("pictures", arguments->sources, "Pictures, folders of pictures, videos")
        ->required();
    recognising->add_flag("--json-lines", arguments->jsonLines, "One JSON object a picture");
    recognising->callback([arguments, &exitCode] {
        exitCode = recognise(arguments->library, arguments->sources, arguments->jsonLines);
    });
    addDetect(app, exitCode);
}

} // namespace farol::cli
