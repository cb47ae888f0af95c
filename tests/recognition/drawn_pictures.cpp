#include "drawn_pictures.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <gtest/gtest.h>

namespace farol::recognition::test {

namespace {

cv::Scalar colour(cv::RNG& random) {
    return cv::Scalar(random.uniform(0, 256), random.uniform(0, 256), random.uniform(0, 256));
}

std::vector<cv::Point2f> points(const Quad& quad) {
    std::vector<cv::Point2f> out;
    for (const ImagePoint& p : quad) out.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y));
    return out;
}

} // namespace

cv::Mat poster(std::uint64_t seed) {
    cv::RNG random(seed * 7919 + 17);
    cv::Mat picture(300, 400, CV_8UC3, colour(random));
    for (int i = 0; i < 60; ++i) {
        cv::Point a(random.uniform(0, 400), random.uniform(0, 300));
        int size = random.uniform(6, 50);
        switch (random.uniform(0, 4)) {
        case 0:
            cv::circle(picture, a, size / 2 + 2, colour(random), cv::FILLED, cv::LINE_AA);
            break;
        case 1:
            cv::rectangle(picture, cv::Rect(a.x, a.y, size, random.uniform(6, 50)), colour(random),
                          cv::FILLED);
            break;
        case 2:
            cv::line(picture, a, {random.uniform(0, 400), random.uniform(0, 300)}, colour(random), 3,
                     cv::LINE_AA);
            break;
        default:
            cv::putText(picture, std::string(1, static_cast<char>(random.uniform('A', 'Z' + 1))), a,
                        cv::FONT_HERSHEY_DUPLEX, size / 20.0, colour(random), 2, cv::LINE_AA);
        }
    }
    return picture;
}

cv::Mat room(std::uint64_t seed, cv::Size size) {
    cv::RNG random(seed * 104729 + 3);
    cv::Mat noise(size.height / 8, size.width / 8, CV_8UC3);
    random.fill(noise, cv::RNG::NORMAL, 150.0, 25.0);
    cv::Mat picture;
    cv::resize(noise, picture, size, 0.0, 0.0, cv::INTER_CUBIC);
    for (int i = 0; i < 12; ++i)
        cv::line(picture, {random.uniform(0, size.width), random.uniform(0, size.height)},
                 {random.uniform(0, size.width), random.uniform(0, size.height)}, colour(random), 2,
                 cv::LINE_AA);
    return picture;
}

void hang(cv::Mat& picture, const cv::Mat& poster, const Quad& quad) {
    auto w = static_cast<float>(poster.cols);
    auto h = static_cast<float>(poster.rows);
    std::vector<cv::Point2f> from{{0, 0}, {w, 0}, {w, h}, {0, h}};
    cv::Mat homography = cv::getPerspectiveTransform(from, points(quad));
    cv::Mat soft, warped, mask;
    cv::GaussianBlur(poster, soft, cv::Size(), 0.6);
    cv::warpPerspective(soft, warped, homography, picture.size(), cv::INTER_LINEAR);
    cv::warpPerspective(cv::Mat(poster.size(), CV_8U, cv::Scalar(255)), mask, homography, picture.size(),
                        cv::INTER_NEAREST);
    warped.copyTo(picture, mask);
}

std::string jpeg(const cv::Mat& picture, int quality) {
    std::vector<unsigned char> bytes;
    cv::imencode(".jpg", picture, bytes, {cv::IMWRITE_JPEG_QUALITY, quality});
    return {bytes.begin(), bytes.end()};
}

std::string png(const cv::Mat& picture) {
    std::vector<unsigned char> bytes;
    cv::imencode(".png", picture, bytes);
    return {bytes.begin(), bytes.end()};
}

double sharedArea(const Quad& a, const Quad& b) {
    std::vector<cv::Point2f> common;
    double both = cv::intersectConvexConvex(points(a), points(b), common);
    return both / (cv::contourArea(points(a)) + cv::contourArea(points(b)) - both);
}

void trainPoster(LandmarkLibrary& library, std::uint64_t seed, Kind kind) {
    cv::Mat photo(360, 480, CV_8UC3, cv::Scalar::all(170));
    Quad outline = quadOf({40, 30, 400, 300});
    hang(photo, poster(seed), outline);
    TrainingRequest request;
    request.id = TemplateId("poster-" + std::to_string(seed));
    request.kind = kind;
    auto trained = addView(library, request, jpeg(photo), outline);
    ASSERT_TRUE(trained) << trained.error().text();
}

} // namespace farol::recognition::test
