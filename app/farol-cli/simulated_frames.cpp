#include "app/farol-cli/simulated_frames.h"

#include "core/session/json_fields.h"

#include <opencv2/imgcodecs.hpp>

#include <cmath>
#include <cstdio>
#include <system_error>
#include <vector>

namespace farol::cli {

namespace {

using session::Json;

double rounded(double value) {
    return std::round(value * 1000.0) / 1000.0;
}

Json thingJson(const simulation::SeenThing& thing) {
    Json json;
    json["landmark"] = thing.landmark.empty() ? Json(nullptr) : Json(thing.landmark.value);
    json["access"] = thing.access.empty() ? Json(nullptr) : Json(thing.access.value);
    json["kind"] = std::string(kindName(thing.kind));
    json["visible_share"] = rounded(thing.visibleShare);
    json["quad"] = Json::array();
    for (const ImagePoint& corner : thing.quad)
        json["quad"].push_back({rounded(corner.x), rounded(corner.y)});
    json["range_m"] = rounded(thing.rangeM);
    json["bearing_deg"] = rounded(toDegrees(thing.bearing));
    json["angle_deg"] = rounded(toDegrees(thing.angle));
    return json;
}

Json truthJson(std::uint64_t index, const std::string& file, const simulation::FrameTruth& truth) {
    Json json;
    json["t"] = rounded(truth.pose.time);
    json["frame"] = index;
    json["file"] = file;
    json["region"] = truth.region.empty() ? Json(nullptr) : Json(truth.region.value);
    json["level"] = rounded(truth.pose.level);
    json["position"] = {rounded(truth.pose.position.x), rounded(truth.pose.position.y)};
    json["heading_deg"] = rounded(toDegrees(truth.pose.heading));
    json["pitch_deg"] = rounded(toDegrees(truth.pose.pitch));
    json["roll_deg"] = rounded(toDegrees(truth.pose.roll));
    json["eye_height_m"] = rounded(truth.pose.eyeHeightM);
    json["speed"] = rounded(truth.pose.speed);
    json["things"] = Json::array();
    for (const simulation::SeenThing& thing : truth.things) json["things"].push_back(thingJson(thing));
    return json;
}

} // namespace

SimulatedFrames::SimulatedFrames(std::filesystem::path folder)
    : m_folder(std::move(folder)), m_truth(m_folder / "truth.jsonl") {}

Result<std::shared_ptr<SimulatedFrames>> SimulatedFrames::create(const std::filesystem::path& folder) {
    std::error_code trouble;
    if (std::filesystem::exists(folder, trouble) && !std::filesystem::is_empty(folder, trouble))
        return Error{ErrorCode::Conflict, "there is something in the folder already; name a new one",
                     folder.string()};
    std::filesystem::create_directories(folder / "frames", trouble);
    if (trouble)
        return Error{ErrorCode::Io, "the folder cannot be made: " + trouble.message(), folder.string()};
    std::shared_ptr<SimulatedFrames> frames(new SimulatedFrames(folder));
    if (!frames->m_truth)
        return Error{ErrorCode::Io, "the truth cannot be written", (folder / "truth.jsonl").string()};
    return frames;
}

Result<void> SimulatedFrames::write(std::uint64_t index, const simulation::RenderedFrame& picture) {
    char name[40];
    std::snprintf(name, sizeof name, "frames/%06llu.jpg", static_cast<unsigned long long>(index));
    std::filesystem::path file = m_folder / name;
    bool written = false;
    try {
        // The picture went through a camera's own compression already.
        written = cv::imwrite(file.string(), picture.image, {cv::IMWRITE_JPEG_QUALITY, 95});
    } catch (const cv::Exception&) {
        written = false;
    }
    m_truth << session::dumped(truthJson(index, name, picture.truth)) << '\n' << std::flush;
    if (written && m_truth) return {};
    return Error{ErrorCode::Io, "a frame or its truth cannot be written; is the disk full?", file.string()};
}

} // namespace farol::cli
