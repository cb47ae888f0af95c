#include "app/farol-cli/evaluate/rendered_signs.h"

#include "core/simulation/lettering.h"

#include <opencv2/calib3d.hpp>
#include <opencv2/freetype.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>

namespace farol::cli {

namespace {

constexpr double kFocalLength = 600.0;
constexpr double kPlateWidthM = 0.30, kPlateHeightM = 0.12;
const cv::Size kPlatePixels(1200, 480);
const cv::Size kPicture(640, 480);

/// Where the plate's corners stand in the picture, clockwise from its top left.
std::array<cv::Point2f, 4> cornersOf(const SignPose& pose) {
    double degree = CV_PI / 180.0;
    cv::Matx31d turn(pose.pitchDegrees * degree, pose.yawDegrees * degree, pose.rollDegrees * degree);
    cv::Matx33d rotation;
    cv::Rodrigues(turn, rotation);
    std::array<cv::Point2f, 4> corners;
    const std::array<cv::Point2d, 4> unit{cv::Point2d(-0.5, -0.5), {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
    for (std::size_t i = 0; i < 4; ++i) {
        cv::Matx31d at = rotation * cv::Matx31d(unit[i].x * kPlateWidthM, unit[i].y * kPlateHeightM, 0.0);
        double scale = kFocalLength / (at(2) + pose.distanceM);
        corners[i] = cv::Point2f(static_cast<float>(kPicture.width / 2.0 + pose.offset.x + at(0) * scale),
                                 static_cast<float>(kPicture.height / 2.0 + pose.offset.y + at(1) * scale));
    }
    return corners;
}

/// White letters on black, cut to their ink.
cv::Mat letters(const SignLook& look) {
    cv::Mat sheet = cv::Mat::zeros(600, 4000, CV_8UC3);
    if (look.font.empty()) {
        cv::putText(sheet, look.text, {100, 400}, cv::FONT_HERSHEY_DUPLEX, 8.0, cv::Scalar::all(255), 18,
                    cv::LINE_AA);
    } else {
        cv::Ptr<cv::freetype::FreeType2> type = cv::freetype::createFreeType2();
        type->loadFontData(look.font, 0);
        type->putText(sheet, look.text, {100, 400}, 240, cv::Scalar::all(255), -1, cv::LINE_AA, true);
    }
    cv::Mat ink;
    cv::extractChannel(sheet, ink, 0);
    cv::Rect box = cv::boundingRect(ink);
    return box.area() > 0 ? ink(box).clone() : cv::Mat();
}

/// In the plate's middle, as large as asked for, or as wide as the plate allows.
void write(cv::Mat& plate, const SignLook& look, const cv::Scalar& colour) {
    cv::Mat ink = letters(look);
    if (ink.empty()) return;
    double scale = std::min(look.letterShare * plate.rows / ink.rows, 0.86 * plate.cols / ink.cols);
    cv::resize(ink, ink, cv::Size(), scale, scale, cv::INTER_AREA);
    cv::Rect at((plate.cols - ink.cols) / 2, (plate.rows - ink.rows) / 2, ink.cols, ink.rows);
    cv::Mat share, painted;
    cv::merge(std::vector<cv::Mat>(3, ink), share);
    cv::Mat target = plate(at);
    cv::Mat full(target.size(), target.type(), colour);
    share.convertTo(share, CV_32FC3, 1.0 / 255.0);
    target.convertTo(painted, CV_32FC3);
    full.convertTo(full, CV_32FC3);
    painted = painted + (full - painted).mul(share);
    painted.convertTo(target, CV_8UC3);
}

} // namespace

std::vector<std::string> signFonts() {
    std::vector<std::string> files;
    for (const char* name :
         {"DejaVu Sans", "DejaVu Sans:bold", "DejaVu Sans Condensed:bold", "DejaVu Serif:bold", "Noto Sans",
          "Noto Sans:bold", "Noto Serif", "Liberation Sans", "Liberation Sans:bold"}) {
        std::string file = simulation::fontFile(name);
        if (!file.empty() && std::find(files.begin(), files.end(), file) == files.end())
            files.push_back(file);
    }
    return files;
}

std::string signText(std::uint64_t seed) {
    static const std::vector<std::string> kWords{
        "Secretaria", "Biblioteca", "SAIDA",   "Sala",       "Library",   "Office",  "Cafetaria", "Bar",
        "Auditório",  "Direção",    "Arquivo", "Laboratory", "Reception", "Kitchen", "Reuniões",  "Museu"};
    cv::RNG random(seed * 2654435761ULL + 97);
    auto digits = [&](int low, int high) { return std::to_string(random.uniform(low, high)); };
    auto two = [&] {
        std::string number = digits(0, 100);
        return number.size() < 2 ? "0" + number : number;
    };
    switch (random.uniform(0, 7)) {
    case 0:
        return digits(0, 10) + "." + two();
    case 1:
        return digits(10, 14) + "." + two();
    case 2:
        return digits(100, 500);
    case 3:
        return std::string(1, "ABCDEFG"[random.uniform(0, 7)]) + digits(100, 400);
    case 4:
        return "Sala " + digits(101, 400);
    case 5:
        return "Lab " + digits(1, 20);
    default:
        return kWords[static_cast<std::size_t>(random.uniform(0, static_cast<int>(kWords.size())))];
    }
}

cv::Mat drawnPlate(const SignLook& look) {
    cv::Scalar ground = cv::Scalar::all(look.lightOnDark ? 55 : 228);
    cv::Scalar ink = cv::Scalar::all(look.lightOnDark ? 235 : 30);
    cv::Mat plate(kPlatePixels, CV_8UC3, ground);
    if (look.frameLine) cv::rectangle(plate, cv::Rect(16, 16, plate.cols - 32, plate.rows - 32), ink, 10);
    write(plate, look, ink);
    return plate;
}

RenderedSign renderSign(const cv::Mat& background, const SignLook& look, const SignPose& pose, double blurPx,
                        double noise, std::uint64_t seed) {
    RenderedSign out;
    out.text = look.text;
    cv::resize(background, out.picture, kPicture, 0.0, 0.0, cv::INTER_AREA);
    std::array<cv::Point2f, 4> to = cornersOf(pose);
    for (std::size_t i = 0; i < 4; ++i) out.plate[i] = {to[i].x, to[i].y};
    // Drawn four times as large and reduced: no stair steps, and every pixel is the mean of what it sees.
    constexpr int kFiner = 4;
    for (cv::Point2f& p : to) p *= static_cast<float>(kFiner);
    std::array<cv::Point2f, 4> from{
        cv::Point2f(0.0F, 0.0F), {1200.0F, 0.0F}, {1200.0F, 480.0F}, {0.0F, 480.0F}};
    cv::Mat plate = drawnPlate(look), warped, mask;
    cv::Mat homography = cv::getPerspectiveTransform(from.data(), to.data());
    cv::warpPerspective(plate, warped, homography, kPicture * kFiner, cv::INTER_AREA);
    cv::warpPerspective(cv::Mat(plate.size(), CV_8U, cv::Scalar(255)), mask, homography, kPicture * kFiner,
                        cv::INTER_NEAREST);
    cv::Mat large;
    cv::resize(out.picture, large, kPicture * kFiner, 0.0, 0.0, cv::INTER_LINEAR);
    warped.copyTo(large, mask);
    cv::resize(large, out.picture, kPicture, 0.0, 0.0, cv::INTER_AREA);
    if (blurPx > 0.0) cv::GaussianBlur(out.picture, out.picture, cv::Size(), blurPx);
    if (noise > 0.0) {
        cv::RNG random(seed * 40503 + 11);
        cv::Mat grain(kPicture, CV_16SC3);
        random.fill(grain, cv::RNG::NORMAL, 0.0, noise);
        cv::add(out.picture, grain, out.picture, cv::noArray(), CV_8U);
    }
    return out;
}

cv::Mat drawnWall(std::uint64_t seed) {
    cv::RNG random(seed * 104729 + 3);
    cv::Mat weak(kPicture.height / 8, kPicture.width / 8, CV_8UC3), wall;
    random.fill(weak, cv::RNG::NORMAL, 150.0, 20.0);
    cv::resize(weak, wall, kPicture, 0.0, 0.0, cv::INTER_CUBIC);
    for (int i = 0; i < 8; ++i) {
        cv::Scalar colour = cv::Scalar::all(random.uniform(20, 240));
        cv::line(wall, {random.uniform(0, kPicture.width), random.uniform(0, kPicture.height)},
                 {random.uniform(0, kPicture.width), random.uniform(0, kPicture.height)}, colour, 2,
                 cv::LINE_AA);
    }
    return wall;
}

RenderedSign randomSign(double distanceM, const cv::Mat& background, std::uint64_t seed) {
    static const std::vector<std::string> kFonts = signFonts();
    cv::RNG random(seed * 7919 + 31);
    SignLook look;
    look.text = signText(seed);
    if (!kFonts.empty())
        look.font = kFonts[static_cast<std::size_t>(random.uniform(0, static_cast<int>(kFonts.size())))];
    look.lightOnDark = random.uniform(0, 3) == 0;
    look.frameLine = random.uniform(0, 3) == 0;
    look.letterShare = random.uniform(0.42, 0.58);
    SignPose pose;
    pose.distanceM = distanceM;
    pose.yawDegrees = random.uniform(-30.0, 30.0);
    pose.pitchDegrees = random.uniform(-8.0, 8.0);
    pose.rollDegrees = random.uniform(-4.0, 4.0);
    pose.offset = {random.uniform(-160.0, 160.0), random.uniform(-120.0, 120.0)};
    double blur = random.uniform(0.0, 0.9);
    double noise = random.uniform(1.0, 6.0);
    return renderSign(background, look, pose, blur, noise, seed);
}

} // namespace farol::cli
