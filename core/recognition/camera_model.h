#pragma once
// How a camera sees: focal length, middle and bend of its pictures, from a calibration or assumed; and from
// that how far away a thing of known size is.

#include "core/base/angle.h"
#include "core/base/error.h"
#include "core/base/geometry.h"
#include "core/recognition/detection.h"

#include <opencv2/core.hpp>

#include <array>
#include <filesystem>
#include <optional>

namespace farol::recognition {

/// In pixels of pictures of `size`, pixel centres at +0.5. `distortion` as OpenCV has it: k1, k2, p1, p2, k3.
struct CameraModel {
    ImageSize size;
    double focalX = 0.0, focalY = 0.0;
    double centreX = 0.0, centreY = 0.0;
    std::array<double, 5> distortion{};
    double focalSpread = 0.0;    ///< one standard deviation, as a share of the focal length
    double reprojectionPx = 0.0; ///< root mean square of the calibration; 0: none was made
    int pictures = 0;            ///< of the calibration

    /// A camera that nobody calibrated: most phones and webcams see 50 to 75 degrees across.
    static CameraModel assumed(ImageSize picture, double horizontalViewDegrees = 60.0);
    bool calibrated() const { return pictures > 0; }

    /// The same camera with pictures of another size. Conflict when their shape differs: they show another
    /// part of the world then.
    Result<CameraModel> forPictures(ImageSize picture) const;
    Result<void> check() const;

    double focalPx() const { return (focalX + focalY) / 2.0; }
    double horizontalViewDegrees() const;
    /// Without the lens's bend, as a ray with z = 1.
    cv::Point2d rayOf(ImagePoint pixel) const;
    Radians bearingOf(ImagePoint pixel) const; ///< from the optical axis, left positive
};

/// A camera file is JSON (see `farol-cli calibrate`). NotFound, Corrupt, UnsupportedFormat.
Result<CameraModel> loadCamera(const std::filesystem::path& file);
Result<void> saveCamera(const CameraModel& camera, const std::filesystem::path& file);

/// How far the middle of a flat thing of known real size is whose corners are `quad`, clockwise from its top
/// left. Both sides: from the whole pose. One side: from that one's length alone, which a turned thing makes
/// uncertain. Empty when no size is known or the outline leaves the picture.
struct MeasuredRange {
    double metres = 0.0;
    double spread = 0.0; ///< one standard deviation, as a share of the range
};
std::optional<MeasuredRange> rangeOf(const Quad& quad, const CameraModel& camera,
                                     const std::optional<double>& widthM,
                                     const std::optional<double>& heightM);

/// Gives the detection its range, and its bearing where the camera was calibrated (an assumed one knows it no
/// better than the zone does).
void place(Detection& detection, const CameraModel& camera, const std::optional<double>& widthM,
           const std::optional<double>& heightM);

} // namespace farol::recognition
