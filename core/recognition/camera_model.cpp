#include "core/recognition/camera_model.h"

#include "core/base/file.h"

#include <nlohmann/json.hpp>
#include <opencv2/calib3d.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace farol::recognition {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;
constexpr double kAssumedSpread = 0.2;
constexpr double kCornerPx = 1.5; ///< how well a corner is known, in pixels of a picture 640 wide
constexpr double kTurnSpread = 0.15;
constexpr double kFarthestM = 100.0;

cv::Matx33d matrixOf(const CameraModel& camera) {
    return {camera.focalX, 0, camera.centreX, 0, camera.focalY, camera.centreY, 0, 0, 1};
}

std::vector<cv::Point2d> raysOf(const Quad& quad, const CameraModel& camera) {
    std::vector<cv::Point2d> rays;
    for (const ImagePoint& corner : quad) rays.push_back(camera.rayOf(corner));
    return rays;
}

/// From the two opposite sides of known length; each is as far as it is short.
double rangeBySides(const std::vector<cv::Point2d>& rays, std::size_t first, double lengthM) {
    double a = cv::norm(rays[first] - rays[first + 1]);
    double b = cv::norm(rays[first + 2] - rays[(first + 3) % 4]);
    return a > 0.0 && b > 0.0 ? lengthM * 0.5 * (1.0 / a + 1.0 / b) : 0.0;
}

double rangeByPose(const std::vector<cv::Point2d>& rays, double widthM, double heightM) {
    double x = widthM / 2.0, y = heightM / 2.0;
    const std::vector<cv::Point3d> corners{{-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0}};
    cv::Vec3d turn, shift;
    if (!cv::solvePnP(corners, rays, cv::Matx33d::eye(), cv::noArray(), turn, shift, false,
                      cv::SOLVEPNP_IPPE) ||
        shift[2] <= 0.0)
        return 0.0;
    return cv::norm(shift);
}

bool insidePicture(const Quad& quad, ImageSize size) {
    return std::all_of(quad.begin(), quad.end(), [size](const ImagePoint& p) {
        return p.x >= 0.0 && p.y >= 0.0 && p.x <= size.width && p.y <= size.height;
    });
}

Error damaged(const std::string& what, const std::string& context) {
    return {ErrorCode::Corrupt, what + "; calibrate the camera again", context};
}

/// Numbers of a list of just that many; empty where it is anything else.
std::vector<double> numbers(const Json& json, const char* name, std::size_t count) {
    auto at = json.find(name);
    if (at == json.end() || !at->is_array() || at->size() != count) return {};
    std::vector<double> values;
    for (const Json& one : *at) {
        if (!one.is_number()) return {};
        values.push_back(one.get<double>());
    }
    return values;
}

double number(const Json& json, const char* name) {
    auto at = json.find(name);
    return at != json.end() && at->is_number() ? at->get<double>() : std::nan("");
}

} // namespace

CameraModel CameraModel::assumed(ImageSize picture, double horizontalViewDegrees) {
    CameraModel camera;
    camera.size = picture;
    // A phone held upright has its wide side upright too.
    int longer = std::max(picture.width, picture.height);
    camera.focalX = camera.focalY = 0.5 * longer / std::tan(fromDegrees(horizontalViewDegrees).value / 2.0);
    camera.centreX = picture.width / 2.0;
    camera.centreY = picture.height / 2.0;
    camera.focalSpread = kAssumedSpread;
    return camera;
}

Result<CameraModel> CameraModel::forPictures(ImageSize picture) const {
    if (picture.width == size.width && picture.height == size.height) return *this;
    double across = static_cast<double>(picture.width) / std::max(size.width, 1);
    double down = static_cast<double>(picture.height) / std::max(size.height, 1);
    auto text = [](ImageSize one) { return std::to_string(one.width) + " x " + std::to_string(one.height); };
    if (!(std::abs(across - down) < 0.01 * std::max(across, down)))
        return Error{ErrorCode::Conflict,
                     "the camera was calibrated with pictures of " + text(size) +
                         ", which have another shape "
                         "than these of " +
                         text(picture) + "; calibrate it in the mode it is used in",
                     ""};
    CameraModel scaled = *this;
    scaled.size = picture;
    scaled.focalX *= across;
    scaled.centreX *= across;
    scaled.focalY *= down;
    scaled.centreY *= down;
    return scaled;
}

Result<void> CameraModel::check() const {
    auto wrong = [](const std::string& message, const char* what) {
        return Error{ErrorCode::InvalidArgument, message, what};
    };
    if (size.width < 16 || size.height < 16 || size.width > 65536 || size.height > 65536)
        return wrong("pictures are 16 to 65536 pixels wide and high", "size");
    double longer = std::max(size.width, size.height);
    for (double focal : {focalX, focalY})
        if (!(focal > 0.1 * longer && focal < 20.0 * longer))
            return wrong("no camera has such a focal length", "focal");
    if (!(centreX > 0.0 && centreX < size.width && centreY > 0.0 && centreY < size.height))
        return wrong("the middle of the lens lies outside the picture", "centre");
    if (!std::all_of(distortion.begin(), distortion.end(), [](double k) { return std::abs(k) < 100.0; }))
        return wrong("no lens bends the picture so much", "distortion");
    if (!(focalSpread >= 0.0 && focalSpread < 1.0))
        return wrong("a share lies between 0 and 1", "focal_spread");
    if (!(reprojectionPx >= 0.0 && reprojectionPx < 1000.0))
        return wrong("an error in pixels is positive", "reprojection_px");
    return {};
}

double CameraModel::horizontalViewDegrees() const {
    return toDegrees(Radians{std::atan(centreX / focalX) + std::atan((size.width - centreX) / focalX)});
}

cv::Point2d CameraModel::rayOf(ImagePoint pixel) const {
    std::vector<cv::Point2d> from{{pixel.x, pixel.y}}, to;
    cv::undistortPoints(from, to, matrixOf(*this), distortion);
    return to.front();
}

Radians CameraModel::bearingOf(ImagePoint pixel) const {
    return Radians{-std::atan(rayOf(pixel).x)};
}

Result<CameraModel> loadCamera(const std::filesystem::path& file) {
    auto bytes = readFile(file);
    if (!bytes) return bytes.error();
    Json json = Json::parse(*bytes, nullptr, false);
    const std::string where = file.string();
    if (!json.is_object() || !json.contains("camera_version"))
        return Error{ErrorCode::Corrupt, "is no camera file; one is made by calibrating the camera", where};
    double version = number(json, "camera_version");
    if (version > kVersion)
        return Error{ErrorCode::UnsupportedFormat,
                     "is of a later version than this program knows; update Farol", where};
    auto size = numbers(json, "size", 2), focal = numbers(json, "focal", 2),
         centre = numbers(json, "centre", 2), bend = numbers(json, "distortion", 5);
    if (size.empty() || focal.empty() || centre.empty() || bend.empty())
        return damaged("size, focal, centre (two numbers each) and distortion (five) must be there", where);
    auto whole = [](double value) { return static_cast<int>(std::clamp(value, 0.0, 1e6)); };
    CameraModel camera;
    camera.size = {whole(size[0]), whole(size[1])};
    camera.focalX = focal[0];
    camera.focalY = focal[1];
    camera.centreX = centre[0];
    camera.centreY = centre[1];
    std::copy(bend.begin(), bend.end(), camera.distortion.begin());
    camera.focalSpread = number(json, "focal_spread");
    camera.reprojectionPx = number(json, "reprojection_px");
    double pictures = number(json, "pictures");
    if (!(pictures >= 0.0)) return damaged("\"pictures\" is missing or no number", where);
    camera.pictures = whole(pictures);
    if (auto checked = camera.check(); !checked)
        return damaged("\"" + checked.error().context + "\": " + checked.error().message, where);
    return camera;
}

Result<void> saveCamera(const CameraModel& camera, const std::filesystem::path& file) {
    if (auto checked = camera.check(); !checked) return checked;
    Json json;
    json["camera_version"] = kVersion;
    json["size"] = {camera.size.width, camera.size.height};
    json["focal"] = {camera.focalX, camera.focalY};
    json["centre"] = {camera.centreX, camera.centreY};
    json["distortion"] = camera.distortion;
    json["focal_spread"] = camera.focalSpread;
    json["reprojection_px"] = camera.reprojectionPx;
    json["pictures"] = camera.pictures;
    return replaceFile(file, false, [&](const std::filesystem::path& temporary) -> Result<void> {
        std::ofstream out(temporary, std::ios::binary);
        out << json.dump(2) << '\n';
        out.close();
        if (!out) return Error{ErrorCode::Io, "cannot be written", file.string()};
        return {};
    });
}

std::optional<MeasuredRange> rangeOf(const Quad& quad, const CameraModel& camera,
                                     const std::optional<double>& widthM,
                                     const std::optional<double>& heightM) {
    if ((!widthM && !heightM) || !insidePicture(quad, camera.size)) return std::nullopt;
    MeasuredRange range;
    double side = 0.0; ///< of the thing in the picture, pixels
    double turned = kTurnSpread;
    try {
        auto rays = raysOf(quad, camera);
        double across = 0.5 * (cv::norm(rays[0] - rays[1]) + cv::norm(rays[2] - rays[3])) * camera.focalX;
        double down = 0.5 * (cv::norm(rays[1] - rays[2]) + cv::norm(rays[3] - rays[0])) * camera.focalY;
        if (widthM && heightM) {
            range.metres = rangeByPose(rays, *widthM, *heightM);
            side = std::hypot(across, down);
            turned = 0.0;
        } else {
            range.metres = widthM ? rangeBySides(rays, 0, *widthM) : rangeBySides(rays, 1, *heightM);
            side = widthM ? across : down;
        }
    } catch (const cv::Exception&) { // an outline that is no quadrilateral
        return std::nullopt;
    }
    if (!(range.metres > 0.0 && range.metres < kFarthestM && side > 0.0)) return std::nullopt;
    double corner = kCornerPx * std::max(camera.size.width, camera.size.height) / 640.0;
    range.spread = std::sqrt(camera.focalSpread * camera.focalSpread + turned * turned +
                             2.0 * (corner / side) * (corner / side));
    return range;
}

void place(Detection& detection, const CameraModel& camera, const std::optional<double>& widthM,
           const std::optional<double>& heightM) {
    if (camera.calibrated()) detection.bearing = camera.bearingOf(boundingBox(detection.quad).centre());
    if (detection.rangeM) return;
    if (auto range = rangeOf(detection.quad, camera, widthM, heightM)) {
        detection.rangeM = range->metres;
        detection.rangeSpread = range->spread;
    }
}

} // namespace farol::recognition
