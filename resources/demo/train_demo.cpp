// Trains the demo building's landmark library from pictures of the simulated camera: each template from the
// front and from the sides. For maintainers; everything is the same at every run.

#include "core/building/geopackage.h"
#include "core/recognition/landmark_library.h"
#include "core/recognition/training.h"
#include "core/simulation/simulated_camera.h"

#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace farol {
namespace {

struct Stand {
    double distanceM, asideDegrees;
};

constexpr Stand kFlat[] = {{2.0, 0.0}, {2.0, 35.0}};
constexpr Stand kSolid[] = {{2.0, 0.0}, {2.0, 35.0}, {2.0, -35.0}};
constexpr double kEyeM = 1.45, kLeastVisible = 0.9;
constexpr int kQuality = 82;
/// About the outline, so that the photograph shows its surroundings, too.
constexpr double kMargin = 0.12;

/// What stands out from its wall looks different from its other side.
std::vector<Stand> standsFor(Kind kind) {
    bool flat = kind == Kind::Poster || kind == Kind::Picture;
    return flat ? std::vector<Stand>(std::begin(kFlat), std::end(kFlat))
                : std::vector<Stand>(std::begin(kSolid), std::end(kSolid));
}

simulation::CameraPose poseBefore(const building::Landmark& landmark, Stand stand) {
    // What is tall has to be whole in the picture.
    stand.distanceM = std::max(stand.distanceM, 1.5 * landmark.tallM.value_or(1.0));
    Radians from = *landmark.heading + fromDegrees(stand.asideDegrees);
    simulation::CameraPose pose;
    pose.position = landmark.position + Point2{std::cos(from.value), std::sin(from.value)} * stand.distanceM;
    pose.level = landmark.level;
    pose.heading = wrapped(from + Radians{kPi});
    pose.eyeHeightM = kEyeM;
    pose.pitch = Radians{std::atan2(landmark.heightM.value_or(kEyeM) - kEyeM, stand.distanceM)};
    return pose;
}

/// The part of the picture that shows the landmark, as JPEG, and the outline in it. False when it is not
/// whole.
bool photograph(const simulation::RenderedFrame& frame, const LandmarkId& id, std::string& bytes,
                Quad& outline) {
    auto seen = std::find_if(frame.truth.things.begin(), frame.truth.things.end(),
                             [&](const simulation::SeenThing& thing) { return thing.landmark == id; });
    if (seen == frame.truth.things.end() || seen->visibleShare < kLeastVisible) return false;
    ImageBox box = boundingBox(seen->quad);
    double margin = kMargin * std::max(box.width, box.height) + 4.0;
    cv::Rect whole(0, 0, frame.image.cols, frame.image.rows);
    cv::Rect part(static_cast<int>(box.x - margin), static_cast<int>(box.y - margin),
                  static_cast<int>(box.width + 2.0 * margin), static_cast<int>(box.height + 2.0 * margin));
    part &= whole;
    outline = seen->quad;
    for (ImagePoint& corner : outline) {
        corner.x = std::clamp(corner.x - part.x, 0.5, part.width - 0.5);
        corner.y = std::clamp(corner.y - part.y, 0.5, part.height - 0.5);
    }
    std::vector<uchar> encoded;
    cv::imencode(".jpg", frame.image(part), encoded, {cv::IMWRITE_JPEG_QUALITY, kQuality});
    bytes.assign(encoded.begin(), encoded.end());
    return true;
}

int train(const std::string& mapPath, const std::string& libraryPath) {
    auto loaded = building::loadBuilding(mapPath);
    if (!loaded) return std::fprintf(stderr, "%s\n", loaded.error().text().c_str()), 1;
    simulation::SceneOptions scene;
    scene.clutter = 0.0;
    auto world = simulation::buildWorld(loaded->building, scene);
    if (!world) return std::fprintf(stderr, "%s\n", world.error().text().c_str()), 1;
    simulation::CameraOptions lens;
    lens.size = {448, 336}; // half the features of 640x480: the file stays small
    lens.exposureSeconds = 0.0;
    lens.noise = 0.5;
    lens.distortionK1 = lens.distortionK2 = 0.0;
    auto camera = simulation::SimulatedCamera::create(*world, lens);
    if (!camera) return std::fprintf(stderr, "%s\n", camera.error().text().c_str()), 1;
    std::map<std::string, std::vector<const building::Landmark*>> places;
    for (const building::Landmark& landmark : loaded->building->landmarks())
        if (!landmark.templateId.empty() && landmark.heading)
            places[landmark.templateId.value].push_back(&landmark);
    recognition::LandmarkLibrary library;
    for (const auto& [name, landmarks] : places) {
        const building::Landmark& landmark = *landmarks.front();
        recognition::TrainingRequest request{landmark.templateId, landmark.kind, name, landmark.widthM,
                                             landmark.tallM};
        int views = 0;
        std::string why;
        for (const Stand& stand : standsFor(landmark.kind)) {
            simulation::CameraPose pose = poseBefore(landmark, stand);
            if (!loaded->building->regionAt(pose.position, pose.level)) continue;
            camera->restart();
            auto frame = camera->render(pose);
            std::string bytes;
            Quad outline{};
            if (!frame || !photograph(*frame, landmark.id, bytes, outline)) continue;
            auto added = recognition::addView(library, request, bytes, outline);
            if (added)
                ++views;
            else
                why = added.error().message;
        }
        if (views < 2) std::fprintf(stderr, "%s: %d views. %s\n", name.c_str(), views, why.c_str());
    }
    std::error_code ignored;
    std::filesystem::remove(libraryPath, ignored);
    auto saved = recognition::saveLibrary(library, libraryPath);
    if (!saved) return std::fprintf(stderr, "%s\n", saved.error().text().c_str()), 1;
    std::printf("%zu templates, %zu views\n", library.templates.size(), library.viewCount());
    return 0;
}

} // namespace
} // namespace farol

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: farol-demo-library MAP.gpkg OUT.gpkg\n");
        return 2;
    }
    return farol::train(argv[1], argv[2]);
}
