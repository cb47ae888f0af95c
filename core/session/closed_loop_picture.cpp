#include "core/session/closed_loop_picture.h"

#include <utility>

namespace farol::session {

namespace {

/// As its calibration would find it.
recognition::CameraModel knownCamera(const simulation::CameraOptions& camera, double focalPx) {
    recognition::CameraModel model =
        recognition::CameraModel::assumed(camera.size, camera.horizontalFovDegrees);
    model.focalX = model.focalY = focalPx;
    model.distortion = {camera.distortionK1, camera.distortionK2, 0.0, 0.0, 0.0};
    model.focalSpread = 0.01;
    model.reprojectionPx = 0.3;
    model.pictures = 12;
    return model;
}

} // namespace

Result<ClosedLoop::Eye> pictureEye(const simulation::World& world, const simulation::CameraOptions& camera,
                                   std::shared_ptr<const recognition::LandmarkLibrary> library,
                                   const PerceptionOptions& perception, PictureWatcher watcher,
                                   std::vector<std::string>& warnings) {
    auto made = simulation::SimulatedCamera::create(world, camera);
    if (!made) return made.error();
    PerceptionOptions options = perception;
    if (!options.camera) options.useCamera(knownCamera(camera, made->focalLengthPx()));
    if (auto checked = options.check(); !checked) return checked.error();
    struct Eyes {
        simulation::SimulatedCamera camera;
        Perception perception;
        PictureWatcher watcher;
    };
    auto eyes = std::make_shared<Eyes>(
        Eyes{std::move(made).value(), Perception(std::move(library), options, warnings), std::move(watcher)});
    ClosedLoop::Eye eye = [eyes](const simulation::CameraPose& pose, std::size_t,
                                 std::uint64_t index) -> Result<Percept> {
        auto picture = eyes->camera.render(pose);
        if (!picture) return picture.error();
        if (eyes->watcher)
            if (auto watched = eyes->watcher(index, *picture); !watched) return watched.error();
        capture::Frame frame;
        frame.index = index;
        frame.capturedAt = pose.time;
        frame.image = picture->image;
        return eyes->perception.look(frame);
    };
    return eye;
}

} // namespace farol::session
