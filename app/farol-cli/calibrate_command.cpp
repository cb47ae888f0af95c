#include "app/farol-cli/commands.h"
#include "app/farol-cli/output.h"
#include "core/capture/sources.h"
#include "core/recognition/camera_calibration.h"

#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace farol::cli {

namespace {

using namespace recognition;

constexpr int kMostBoards = 60;         // more only takes longer
constexpr double kSecondsOfVideo = 0.7; // between two boards: the next frame shows the same once more

struct CalibrateArguments {
    std::string board = "9x6", out;
    std::vector<std::string> pictures;
    bool json = false;
};

std::optional<Chessboard> boardFrom(const std::string& words) {
    Chessboard board;
    const char* end = words.data() + words.size();
    auto columns = std::from_chars(words.data(), end, board.columns);
    if (columns.ec != std::errc() || columns.ptr == end || *columns.ptr != 'x') return std::nullopt;
    auto rows = std::from_chars(columns.ptr + 1, end, board.rows);
    return rows.ec == std::errc() && rows.ptr == end ? std::optional(board) : std::nullopt;
}

/// Adds what the source shows; a picture without the board is told of, a frame of a video is not.
void addAll(capture::FrameSource& source, const std::string& name, CameraCalibration& calibration,
            int& without) {
    double next = -1.0;
    while (auto frame = source.next()) {
        bool video = frame->name.empty();
        if (calibration.pictures() >= kMostBoards) return;
        if (video && frame->capturedAt < next) continue;
        auto added = calibration.add(frame->image, video ? name : frame->name);
        if (added) {
            next = frame->capturedAt + kSecondsOfVideo;
            continue;
        }
        ++without;
        if (!video) warn(added.error().text());
    }
}

void print(const CameraModel& camera, int without, const CalibrateArguments& arguments) {
    if (arguments.json) {
        nlohmann::ordered_json json;
        json["camera"] = arguments.out;
        json["size"] = {camera.size.width, camera.size.height};
        json["focal"] = {camera.focalX, camera.focalY};
        json["centre"] = {camera.centreX, camera.centreY};
        json["distortion"] = camera.distortion;
        json["focal_spread"] = camera.focalSpread;
        json["reprojection_px"] = camera.reprojectionPx;
        json["view_deg"] = camera.horizontalViewDegrees();
        json["pictures"] = camera.pictures;
        json["without_board"] = without;
        printLine(json.dump());
        return;
    }
    std::printf(
        "%s: focal length %.1f px (+-%.1f) of %d x %d, %.1f degrees across; corners fit to %.2f px in %d "
        "pictures, %d show no whole board\n",
        arguments.out.c_str(), camera.focalPx(), camera.focalPx() * camera.focalSpread, camera.size.width,
        camera.size.height, camera.horizontalViewDegrees(), camera.reprojectionPx, camera.pictures, without);
}

int calibrate(const CalibrateArguments& arguments) {
    auto board = boardFrom(arguments.board);
    if (!board)
        return report({ErrorCode::InvalidArgument,
                       "\"" + arguments.board + "\" is no board; give its inner corners, such as 9x6",
                       "--board"});
    if (auto checked = board->check(); !checked)
        return report({ErrorCode::InvalidArgument, checked.error().message, "--board"});
    CameraCalibration calibration(*board);
    int without = 0;
    for (const std::string& name : arguments.pictures) {
        auto source = capture::openSource(name);
        if (!source) {
            report(source.error());
            continue;
        }
        (*source)->onEvent([&](const capture::SourceEvent& event) { warn(event.message); });
        addAll(**source, name, calibration, without);
    }
    auto camera = calibration.solve();
    if (!camera) return report(camera.error());
    if (auto saved = saveCamera(*camera, arguments.out); !saved) return report(saved.error());
    print(*camera, without, arguments);
    return kDone;
}

} // namespace

void addCalibrateCommand(CLI::App& app, int& exitCode) {
    auto arguments = std::make_shared<CalibrateArguments>();
    CLI::App* command = app.add_subcommand(
        "calibrate", "Learn a camera's focal length and bend from photographs of a chessboard");
    command->footer(
        "Example:\n  farol-cli calibrate --board 9x6 --out camera.json boards/\n"
        "Print a chessboard, glue it to something flat, and photograph it 10 to 20 times: from near and "
        "far,\nturned and leaning, in all parts of the picture, with the size of picture that the walk "
        "will have.\nfarol-cli run --camera camera.json then tells distances by it.");
    command->add_option("--board", arguments->board, "Inner corners across and down: one fewer than squares")
        ->capture_default_str();
    command->add_option("--out", arguments->out, "The camera file to write (*.json)")->required();
    command->add_option("pictures", arguments->pictures, "Pictures, folders of pictures, videos")->required();
    command->add_flag("--json", arguments->json, "One JSON document");
    command->callback([arguments, &exitCode] { exitCode = calibrate(*arguments); });
}

} // namespace farol::cli
