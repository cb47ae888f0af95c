#include "core/simulation/simulated_camera.h"

#include "core/simulation/camera_shake.h"
#include "core/simulation/door_leaves.h"
#include "core/simulation/frame_truth.h"
#include "core/simulation/motion_blur.h"
#include "core/simulation/parallel.h"
#include "core/simulation/picture_pass.h"
#include "core/simulation/sensor.h"

#include <algorithm>
#include <cmath>

namespace farol::simulation {

namespace {

Sight sightOf(const CameraPose& pose, const SceneData& scene, double footZ) {
    double h = pose.heading.value, p = pose.pitch.value, r = pose.roll.value;
    auto vec = [](double x, double y, double z) {
        return Vec3{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
    };
    Vec3 forward = vec(std::cos(p) * std::cos(h), std::cos(p) * std::sin(h), std::sin(p));
    Vec3 right = vec(std::sin(h), -std::cos(h), 0.0);
    Vec3 down = cross(forward, right);
    auto c = static_cast<float>(std::cos(r)), s = static_cast<float>(std::sin(r));
    Sight sight;
    sight.eye = vecOf(pose.position - scene.plan.origin, footZ + pose.eyeHeightM);
    sight.forward = forward;
    sight.right = right * c + down * s;
    sight.down = down * c - right * s;
    return sight;
}

/// Where the car of a lift is between two floors it hangs before the nearest one with its doors shut: nobody
/// inside can tell.
struct Standing {
    double footZ = 0.0;
    bool inLift = false;
    std::optional<std::size_t> region;
};

Standing standingOf(const World& world, const CameraPose& pose) {
    const SceneData& scene = world.scene();
    const Storey& storey = scene.plan.storeys.at(pose.level);
    Standing standing;
    standing.footZ = world.footZ(pose.level);
    standing.region = world.building()->regionAt(pose.position, storey.ordinal);
    bool lift = standing.region &&
                world.building()->regions()[*standing.region].kind == building::RegionKind::Elevator;
    if (lift && std::abs(pose.level - storey.ordinal) > 1.0e-3) {
        standing.inLift = true;
        standing.footZ = storey.floorZ;
    }
    return standing;
}

} // namespace

Result<void> CameraOptions::check() const {
    auto wrong = [](const std::string& what) {
        return Error{ErrorCode::InvalidArgument, "simulated camera: " + what, ""};
    };
    if (size.width < 16 || size.height < 16 || size.width > 4096 || size.height > 4096)
        return wrong("the picture must measure 16 to 4096 pixels each way");
    if (!(horizontalFovDegrees >= 20.0 && horizontalFovDegrees <= 130.0))
        return wrong("the field of view must be 20 to 130 degrees");
    if (!(std::abs(distortionK1) <= 0.5 && std::abs(distortionK2) <= 0.5))
        return wrong("distortion must lie in -0.5 to 0.5");
    if (raysPerPixel != 1 && raysPerPixel != 4) return wrong("there are 1 or 4 rays a pixel");
    if (!(exposureSeconds >= 0.0 && exposureSeconds <= 0.2))
        return wrong("the exposure must last 0 to 0.2 seconds");
    if (!(noise >= 0.0 && noise <= 20.0)) return wrong("noise must lie in 0 to 20");
    if (jpegQuality < 0 || jpegQuality > 100) return wrong("JPEG quality must lie in 0 to 100");
    if (threads < 0 || threads > 256) return wrong("threads must lie in 0 to 256");
    return {};
}

struct SimulatedCamera::State {
    State(World worldIn, const CameraOptions& optionsIn)
        : world(std::move(worldIn)),
          options(optionsIn),
          lens(optionsIn.size, optionsIn.horizontalFovDegrees, optionsIn.distortionK1,
               optionsIn.distortionK2),
          exposure(optionsIn.adaptExposure) {}

    World world;
    CameraOptions options;
    Lens lens;
    Exposure exposure;
    std::unique_ptr<DoorLeavesNow> leaves;
    PictureBuffers buffers;
    std::uint64_t number = 0; ///< of the next picture
    double lastTime = 0.0;
};

SimulatedCamera::SimulatedCamera(std::unique_ptr<State> state) : m_state(std::move(state)) {}
SimulatedCamera::SimulatedCamera(SimulatedCamera&&) noexcept = default;
SimulatedCamera& SimulatedCamera::operator=(SimulatedCamera&&) noexcept = default;
SimulatedCamera::~SimulatedCamera() = default;

Result<SimulatedCamera> SimulatedCamera::create(World world, const CameraOptions& options) {
    if (Result<void> fine = options.check(); !fine) return fine.error();
    auto state = std::make_unique<State>(std::move(world), options);
    auto leaves = DoorLeavesNow::make(state->world);
    if (!leaves) return leaves.error();
    state->leaves = std::move(*leaves);
    return SimulatedCamera(std::move(state));
}

void SimulatedCamera::restart() {
    m_state->number = 0;
    m_state->lastTime = 0.0;
    m_state->exposure.restart();
}

void SimulatedCamera::setLightsOut(bool out) {
    m_state->options.lightsOut = out;
}

const CameraOptions& SimulatedCamera::options() const {
    return m_state->options;
}

double SimulatedCamera::focalLengthPx() const {
    return m_state->lens.focalPx();
}

const cv::Mat& SimulatedCamera::idPicture() const {
    return m_state->buffers.ids;
}

Result<RenderedFrame> SimulatedCamera::render(const CameraPose& asked) {
    if (Result<void> fine = asked.check(); !fine) return fine.error();
    State& s = *m_state;
    ShakeOffset shake = shakeAt(s.options.shake, asked.time, asked.speed, s.options.seed);
    RenderedFrame frame;
    frame.truth.pose = shaken(asked, shake);
    Standing standing = standingOf(s.world, frame.truth.pose);
    Sight sight = sightOf(frame.truth.pose, s.world.scene(), standing.footZ);
    s.leaves->update(sight.eye, standing.inLift);
    Shader shader(s.world.scene(), s.leaves->mesh(), s.world.tracer().scene(), s.leaves->scene(),
                  s.options.lightsOut);
    drawPicture(shader, s.lens, sight, s.options.raysPerPixel, s.options.threads, s.buffers);

    constexpr double kMoment = 0.004;
    ShakeOffset later = shakeAt(s.options.shake, asked.time + kMoment, asked.speed, s.options.seed);
    double turn = asked.turnRate.value + (later.yaw - shake.yaw) / kMoment;
    Vec3 walk = flatVec(Point2{std::cos(asked.heading.value), std::sin(asked.heading.value)} * asked.speed) +
                kUp * static_cast<float>((later.upM - shake.upM) / kMoment);
    Vec3 spin = kUp * static_cast<float>(turn) +
                sight.right * static_cast<float>((later.pitch - shake.pitch) / kMoment) +
                sight.forward * static_cast<float>((later.roll - shake.roll) / kMoment);
    auto own = [&](Vec3 v) { return Vec3{dot(v, sight.right), dot(v, sight.down), dot(v, sight.forward)}; };
    // The world's axes are right-handed and so are right, down, forward: a turn keeps its sense.
    blurByMotion(s.buffers.light, s.buffers.depth, s.lens, {own(walk), own(spin)}, s.options.exposureSeconds,
                 s.options.threads);

    float gain = s.exposure.next(s.buffers.light, s.number == 0 ? 0.0 : asked.time - s.lastTime);
    try {
        frame.image = developed(s.buffers.light, s.options.size, gain, s.number,
                                {s.options.noise, s.options.jpegQuality, s.options.seed, s.options.threads});
    } catch (const cv::Exception& failure) {
        return Error{ErrorCode::Internal,
                     std::string("the simulated picture could not be compressed: ") + failure.what(), ""};
    }
    if (standing.region) frame.truth.region = s.world.building()->regions()[*standing.region].id;
    frame.truth.things = seenThings(s.world.scene(), shader, s.lens, sight, s.buffers.ids);
    ++s.number;
    s.lastTime = asked.time;
    return frame;
}

} // namespace farol::simulation
