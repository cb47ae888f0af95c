#pragma once
// What a camera sees in the simulated world, as bytes of a picture, and the truth about it. The same world,
// options and poses give the same bytes, with any number of threads.

#include "core/base/error.h"
#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/base/kind.h"
#include "core/simulation/camera_pose.h"
#include "core/simulation/world.h"

#include <opencv2/core.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace farol::simulation {

enum class Shake { None, Chest, Hand };

struct CameraOptions {
    ImageSize size{640, 480};
    double horizontalFovDegrees = 63.0;
    double distortionK1 = -0.04; ///< radial, as OpenCV counts it; 0: none
    double distortionK2 = 0.01;
    int raysPerPixel = 4;           ///< where a pixel holds an edge: 1 or 4
    double exposureSeconds = 0.012; ///< how long motion smears; 0: not at all
    bool adaptExposure = true;      ///< brightness follows the light with some delay
    double noise = 1.0;             ///< of the sensor, 1 as a small webcam; 0: none
    int jpegQuality = 92;           ///< 0: no compression
    Shake shake = Shake::None;      ///< on top of what the pose says
    bool lightsOut = false;         ///< three hundredths of the light are left, indoors and out
    std::uint64_t seed = 1;
    int threads = 0; ///< 0: one for each core

    Result<void> check() const;
};

/// A landmark, or the door of an access, as it stands in the picture.
struct SeenThing {
    LandmarkId landmark; ///< empty for a door without a landmark
    AccessId access;     ///< of doors
    Kind kind = Kind::Other;
    double visibleShare =
        0.0;     ///< of all its pixels, those hidden or beyond the picture's edge counted as not seen
    Quad quad{}; ///< in pixels of the picture, also beyond its edges; clockwise from its own top left
    double rangeM = 0.0;
    Radians bearing{0.0}; ///< from the optical axis, left positive
    Radians angle{0.0};   ///< between the way it faces and the way to the camera; 0 head on
};

struct FrameTruth {
    CameraPose pose;               ///< with the shake
    RegionId region;               ///< empty outside all regions
    std::vector<SeenThing> things; ///< with a share above zero, nearest first
};

struct RenderedFrame {
    cv::Mat image; ///< 8-bit BGR
    FrameTruth truth;
};

class SimulatedCamera {
public:
    static Result<SimulatedCamera> create(World world, const CameraOptions& options = {});
    SimulatedCamera(SimulatedCamera&&) noexcept;
    SimulatedCamera& operator=(SimulatedCamera&&) noexcept;
    ~SimulatedCamera();

    /// One picture. Noise, exposure and shake go on from the picture before. InvalidArgument for a pose that
    /// is none.
    Result<RenderedFrame> render(const CameraPose& pose);
    /// As after create().
    void restart();
    void setLightsOut(bool out);

    const CameraOptions& options() const;
    double focalLengthPx() const;
    /// What lies at each pixel's centre in the last picture: 0 nothing in particular, else 1 + index into the
    /// world's things. 16-bit.
    const cv::Mat& idPicture() const;

private:
    struct State;
    explicit SimulatedCamera(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

} // namespace farol::simulation
