#include "tests/bench/film.h"

#include "core/capture/frame_source.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include <cmath>
#include <cstdio>

namespace farol::bench {

namespace {

constexpr double kFramesPerSecond = 30.0;

/// The picture as a camera sees it that has come nearer by a share, swaying as steps make it sway.
cv::Mat viewOf(const cv::Mat& picture, double seconds) {
    constexpr double kNearerPerSecond = 0.12, kSwayShare = 0.012, kStepsPerSecond = 1.8, kFirstZoom = 1.06;
    double zoom = kFirstZoom * (1.0 + kNearerPerSecond * seconds);
    double phase = 2.0 * CV_PI * kStepsPerSecond * seconds;
    double x = 0.5 * picture.cols * (1.0 - zoom) + kSwayShare * picture.cols * std::sin(0.5 * phase);
    double y = 0.5 * picture.rows * (1.0 - zoom) + kSwayShare * picture.rows * std::cos(phase);
    cv::Mat view;
    cv::warpAffine(picture, view, cv::Matx23d(zoom, 0.0, x, 0.0, zoom, y), picture.size(), cv::INTER_LINEAR,
                   cv::BORDER_REFLECT);
    return view;
}

} // namespace

int makeFilm(const FilmOptions& options) {
    auto source = capture::openSource(options.frames);
    if (!source) {
        std::fprintf(stderr, "farol-bench: %s\n", source.error().text().c_str());
        return 1;
    }
    cv::VideoWriter film;
    auto each = static_cast<int>(std::lround(options.secondsEach * kFramesPerSecond));
    int pictures = 0;
    while (auto frame = (*source)->next()) {
        if (options.count > 0 && pictures++ == options.count) break;
        if (!film.isOpened() && !film.open(options.file, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'),
                                           kFramesPerSecond, frame->image.size())) {
            std::fprintf(stderr, "farol-bench: the film %s cannot be written\n", options.file.c_str());
            return 1;
        }
        for (int i = 0; i < each; ++i) film.write(viewOf(frame->image, i / kFramesPerSecond));
    }
    return film.isOpened() ? 0 : 1;
}

} // namespace farol::bench
