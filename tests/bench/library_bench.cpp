#include "tests/bench/library_bench.h"

#include "core/recognition/landmark_recogniser.h"
#include "core/recognition/training.h"

#include <opencv2/imgcodecs.hpp>

#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <unistd.h>

namespace farol::bench {

namespace {

namespace fs = std::filesystem;
using namespace recognition;

constexpr int kFeatures = 300, kSide = 400;

/// Wall and processor time of what is done.
template <class Work>
std::string timed(Work work) {
    auto wall = std::chrono::steady_clock::now();
    std::clock_t busy = std::clock();
    work();
    char text[64];
    std::snprintf(text, sizeof text, "%.2f (%.2f)",
                  std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count(),
                  static_cast<double>(std::clock() - busy) / CLOCKS_PER_SEC);
    return text;
}

/// Features strewn as those of a poster are, their descriptors as long as real ones.
Template madeUp(int number, const std::string& jpeg) {
    cv::RNG draw(static_cast<std::uint64_t>(number) * 7919U + 1U);
    View view;
    view.jpeg = jpeg;
    view.size = {kSide, kSide};
    view.outline = quadOf({0, 0, kSide, kSide});
    view.features.descriptors = cv::Mat(kFeatures, descriptorBytes("rootsift"), CV_8U);
    for (int row = 0; row < kFeatures; ++row) {
        view.features.keypoints.emplace_back(draw.uniform(5.0F, kSide - 5.0F),
                                             draw.uniform(5.0F, kSide - 5.0F), draw.uniform(3.0F, 20.0F),
                                             draw.uniform(0.0F, 360.0F), 0.02F);
        view.features.keypoints.back().class_id = 0;
        auto* bytes = view.features.descriptors.ptr(row);
        for (int i = 0; i < view.features.descriptors.cols; ++i) {
            double share = draw.uniform(0.0, 1.0);
            bytes[i] = static_cast<unsigned char>(150.0 * share * share);
        }
    }
    Template entry;
    entry.id = TemplateId("made-up-" + std::to_string(number));
    entry.kind = Kind::Poster;
    entry.views.push_back(std::move(view));
    return entry;
}

double megabytesInUse() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.rfind("VmRSS:", 0) == 0) return std::stod(line.substr(6)) / 1024.0;
    return 0.0;
}

int row(int count, const fs::path& file) {
    std::vector<unsigned char> bytes;
    cv::imencode(".jpg", cv::Mat(8, 8, CV_8U, cv::Scalar(90)), bytes);
    const std::string jpeg(bytes.begin(), bytes.end());
    {
        LandmarkLibrary made;
        for (int number = 0; number < count; ++number) made.templates.push_back(madeUp(number, jpeg));
        if (auto saved = saveLibrary(made, file.string()); !saved) {
            std::fprintf(stderr, "%s\n", saved.error().text().c_str());
            return 1;
        }
    }
    std::shared_ptr<const LandmarkLibrary> library;
    std::string reading = timed([&] {
        if (auto loaded = loadLibrary(file.string()))
            library = std::make_shared<const LandmarkLibrary>(*loaded);
    });
    if (!library) return 1;
    std::optional<LandmarkRecogniser> recogniser, larger, smaller;
    std::string indexing = timed([&] { recogniser.emplace(library); });
    double indexed = megabytesInUse();
    auto more = std::make_shared<LandmarkLibrary>(*library);
    more->templates.push_back(madeUp(count, jpeg));
    std::string adding = timed([&] { larger.emplace(more, *recogniser); });
    larger.reset();
    auto less = std::make_shared<LandmarkLibrary>(*library);
    removeTemplate(*less, TemplateId("made-up-" + std::to_string(count / 2)));
    std::string removing = timed([&] { smaller.emplace(less, *recogniser); });
    std::printf("| %d | %.0f | %s | %s | %.0f | %s | %s |\n", count,
                static_cast<double>(fs::file_size(file)) / 1048576.0, reading.c_str(), indexing.c_str(),
                indexed, adding.c_str(), removing.c_str());
    std::fflush(stdout);
    return 0;
}

} // namespace

int benchLibraries(const std::vector<int>& templates) {
    cv::setNumThreads(1);
    std::printf("| templates of %d features | file MB | read s (of the processor) | index s | MB of memory | "
                "follow one added s | one removed s |\n|---:|---:|---:|---:|---:|---:|---:|\n",
                kFeatures);
    fs::path file = fs::temp_directory_path() / ("library-bench-" + std::to_string(::getpid()) + ".gpkg");
    int failed = 0;
    for (int count : templates) {
        failed |= row(count, file);
        std::error_code ignored;
        fs::remove(file, ignored);
    }
    return failed;
}

} // namespace farol::bench
