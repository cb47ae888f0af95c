// Fits the weights by which ObjectMatcher believes a fit (core/recognition/object_evidence.cpp) on composed
// frames and on photographs that show no template:
//   bench_planes_fit gather DATA SEED FRAMES DRAWN > trials.tsv   DRAWN posters beside the hundred templates
//   bench_planes_fit gather DATA SEED -1 DRAWN > rooms.tsv        photographs only
//   bench_planes_fit write DATA SEED FRAMES FOLDER                a set of files: farol-cli evaluate
//                                                                  recognition --data FOLDER, or the peer
//   bench_planes_fit measure DATA SEED FRAMES EXTRACTOR           a row of a table, once fitted
//   bench_planes_fit fit trials.tsv...                            the weights
// Seeds from 1000 on make the poor material of composed_planes.h.

#include "app/farol-cli/evaluate/data_set.h"
#include "app/farol-cli/evaluate/posters.h"
#include "core/recognition/grey.h"
#include "core/recognition/object_matcher.h"
#include "core/recognition/sharpness.h"
#include "core/recognition/training.h"
#include "tests/bench/composed_planes.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>

namespace farol::bench {

namespace {

using namespace recognition;
constexpr std::size_t kColumns = kEvidenceTerms + 1; // with the bias

/// One line of a file: the fit's figures, its answer, and where it stood.
struct Trial {
    int frame = 0, difficulty = 0;
    bool right = false;
    std::array<double, kColumns> terms{};
};

double overlap(const Quad& a, const Quad& b) {
    auto outline = [](const Quad& quad) {
        std::vector<cv::Point2f> points;
        for (const ImagePoint& p : quad)
            points.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y));
        return points;
    };
    std::vector<cv::Point2f> pa = outline(a), pb = outline(b), common;
    double both = cv::intersectConvexConvex(pa, pb, common);
    return both / (cv::contourArea(pa) + cv::contourArea(pb) - both);
}

/// So that a seed alone names what it made.
PlaneComposer::Material materialOf(std::uint64_t seed) {
    return seed >= 1000 ? PlaneComposer::Material::Poor : PlaneComposer::Material::Usual;
}

LandmarkLibrary trained(const PlaneComposer& composer, int drawn, const ExtractorOptions& extractor = {}) {
    LandmarkLibrary library;
    library.extractor = extractor;
    for (int number = 0; number < composer.templateCount(); ++number) {
        ComposedTemplate entry = composer.templateAt(number);
        for (const ComposedView& view : entry.views) {
            std::vector<unsigned char> bytes;
            cv::imencode(".jpg", view.image, bytes, {cv::IMWRITE_JPEG_QUALITY, 92});
            TrainingRequest request{TemplateId(entry.name), Kind::Poster, "", entry.widthM, entry.heightM};
            (void)addView(library, request, {bytes.begin(), bytes.end()}, view.outline);
        }
    }
    for (int number = 0; number < drawn; ++number) {
        std::vector<unsigned char> bytes;
        cv::imencode(".jpg", cli::drawnPoster(number), bytes);
        TrainingRequest request{TemplateId("drawn-" + std::to_string(number)), Kind::Poster, "", {}, {}};
        (void)addView(library, request, {bytes.begin(), bytes.end()}, {});
    }
    return library;
}

void look(const ObjectMatcher& matcher, const FeatureExtractor& extractor, const ComposedFrame& frame,
          int number) {
    cv::Mat grey = greyOf(frame.image);
    std::vector<ObjectTrial> trials;
    (void)matcher.match(grey, extractor.extract(grey), &trials);
    std::string shown;
    for (const auto& one : frame.shown) shown += one.name + " ";
    std::printf("F\t%d\t%d\t%zu\t%.2f\t%s\n", number, frame.difficulty, frame.shown.size(), sharpness(grey),
                shown.c_str());
    for (const ObjectTrial& trial : trials) {
        double best = 0.0;
        for (const auto& one : frame.shown)
            if (one.name == trial.id.value) best = std::max(best, overlap(one.quad, trial.quad));
        std::printf("T\t%d\t%d\t%d", number, frame.difficulty, best > 0.5 ? 1 : 0);
        for (double term : termsOf(trial.evidence)) std::printf("\t%.5f", term);
        std::printf("\t%d\t%s\t%s\n", trial.evidence.inliers, trial.id.value.c_str(), shown.c_str());
    }
}

std::vector<std::filesystem::path> roomFolders(const std::filesystem::path& data) {
    std::vector<std::filesystem::path> folders{data / "images/vpr_corridor_fisheye/query",
                                               data / "images/vpr_corridor_fisheye/ref"};
    std::error_code ignored;
    for (const auto& clip : std::filesystem::directory_iterator(data / "images/tower/frames", ignored))
        if (clip.is_directory()) folders.push_back(clip.path());
    std::sort(folders.begin(), folders.end());
    return folders;
}

int gather(const std::string& data, std::uint64_t seed, int frames, int drawn) {
    auto composer = PlaneComposer::open(data, seed, materialOf(seed));
    if (!composer) {
        std::fprintf(stderr, "%s\n", composer.error().message.c_str());
        return 1;
    }
    LandmarkLibrary library = trained(*composer, drawn);
    FeatureExtractor extractor(library.extractor);
    RecogniserOptions everything; // is tried and told
    everything.minInliers = 4;
    everything.minMatches = 0;
    everything.minLogOdds = -50.0;
    ObjectMatcher matcher(library, everything);
    for (int number = 0; number < frames; ++number)
        look(matcher, extractor, composer->frameAt(number), number);
    if (frames >= 0) return 0;
    int number = 0;
    for (const std::filesystem::path& folder : roomFolders(data))
        for (const auto& file : cli::picturesOf(folder)) {
            cv::Mat picture = cv::imread(file.string());
            if (!picture.empty()) look(matcher, extractor, {asFrame(picture), 3, {}}, number++);
        }
    return 0;
}

std::string cornersOf(const Quad& quad) {
    std::ostringstream out;
    for (std::size_t i = 0; i < 4; ++i)
        out << (i > 0 ? ", [" : "[[") << quad[i].x << ", " << quad[i].y << "]";
    out << "]";
    return out.str();
}

int write(const std::string& data, std::uint64_t seed, int frames, std::filesystem::path folder) {
    folder = folder / "images" / "planar_landmarks";
    auto composer = PlaneComposer::open(data, seed, materialOf(seed));
    if (!composer) {
        std::fprintf(stderr, "%s\n", composer.error().message.c_str());
        return 1;
    }
    std::filesystem::create_directories(folder / "train");
    std::filesystem::create_directories(folder / "frames");
    std::ofstream train(folder / "train.jsonl"), shown(folder / "frames.jsonl");
    for (int number = 0; number < composer->templateCount(); ++number) {
        ComposedTemplate entry = composer->templateAt(number);
        for (std::size_t view = 0; view < entry.views.size(); ++view) {
            std::string file = "train/" + entry.name + "_" + std::to_string(view) + ".jpg";
            cv::imwrite((folder / file).string(), entry.views[view].image, {cv::IMWRITE_JPEG_QUALITY, 92});
            train << "{\"template\": \"" << entry.name << "\", \"view\": " << view << ", \"file\": \"" << file
                  << "\", \"width_m\": " << entry.widthM << ", \"tall_m\": " << entry.heightM
                  << ", \"outline\": " << cornersOf(entry.views[view].outline) << "}\n";
        }
    }
    const std::array<const char*, 3> names{"easy", "medium", "hard"};
    for (int number = 0; number < frames; ++number) {
        ComposedFrame frame = composer->frameAt(number);
        std::string file = "frames/" + std::to_string(number) + ".png";
        cv::imwrite((folder / file).string(), frame.image);
        shown << "{\"file\": \"" << file << "\", \"difficulty\": \""
              << names[static_cast<std::size_t>(frame.difficulty)] << "\", \"landmarks\": [";
        for (std::size_t i = 0; i < frame.shown.size(); ++i)
            shown << (i > 0 ? ", " : "") << "{\"template\": \"" << frame.shown[i].name
                  << "\", \"quad\": " << cornersOf(frame.shown[i].quad) << "}";
        shown << "]}\n";
    }
    return 0;
}

/// One row of a table: recall easy, medium, hard; precision; false in frames without a template; such frames;
/// median milliseconds of the processor.
int measure(const std::string& data, std::uint64_t seed, int frames, const std::string& extractor) {
    auto composer = PlaneComposer::open(data, seed, materialOf(seed));
    auto options = ExtractorOptions::named(extractor);
    if (!composer || !options) {
        std::fprintf(stderr, "%s\n", (composer ? options.error() : composer.error()).message.c_str());
        return 1;
    }
    LandmarkRecogniser recogniser(std::make_shared<const LandmarkLibrary>(trained(*composer, 0, *options)));
    std::array<int, 3> shown{}, found{};
    int wrong = 0, wrongInEmpty = 0, empty = 0, right = 0;
    std::vector<double> times;
    for (int number = 0; number < frames; ++number) {
        ComposedFrame frame = composer->frameAt(number);
        double start = cli::cpuMilliseconds();
        auto detections = recogniser.recognise(frame.image).detections;
        times.push_back(cli::cpuMilliseconds() - start);
        auto difficulty = static_cast<std::size_t>(frame.difficulty);
        shown[difficulty] += static_cast<int>(frame.shown.size());
        empty += frame.shown.empty() ? 1 : 0;
        for (const Detection& detection : detections) {
            bool hit = std::any_of(frame.shown.begin(), frame.shown.end(), [&](const auto& one) {
                return one.name == detection.templateId.value && overlap(one.quad, detection.quad) > 0.5;
            });
            (hit ? right : wrong) += 1;
            found[difficulty] += hit ? 1 : 0;
            wrongInEmpty += frame.shown.empty() ? 1 : 0;
        }
    }
    std::sort(times.begin(), times.end());
    std::printf("| %s |", extractor.c_str());
    for (std::size_t i = 0; i < 3; ++i)
        std::printf(" %.3f |", static_cast<double>(found[i]) / std::max(1, shown[i]));
    std::printf(" %.4f | %d | %d | %.1f |\n", static_cast<double>(right) / std::max(1, right + wrong),
                wrongInEmpty, empty, times.empty() ? 0.0 : times[times.size() / 2]);
    return 0;
}

struct Material {
    std::vector<Trial> trials;
    std::array<int, 4> shown{};
};

Material read(const std::vector<std::string>& files) {
    Material material;
    for (const std::string& file : files) {
        std::ifstream in(file);
        for (std::string line; std::getline(in, line);) {
            std::istringstream words(line);
            std::string mark;
            Trial trial;
            words >> mark >> trial.frame >> trial.difficulty;
            if (mark == "F") {
                int count = 0;
                words >> count;
                material.shown[static_cast<std::size_t>(trial.difficulty)] += count;
                continue;
            }
            words >> trial.right;
            trial.terms[0] = 1.0;
            for (std::size_t i = 1; i < kColumns; ++i) words >> trial.terms[i];
            if (words) material.trials.push_back(trial);
        }
    }
    return material;
}

double dot(const std::array<double, kColumns>& a, const cv::Mat& weights) {
    double sum = 0.0;
    for (std::size_t i = 0; i < kColumns; ++i) sum += a[i] * weights.at<double>(static_cast<int>(i));
    return sum;
}

std::array<double, kColumns> variances(const std::vector<Trial>& trials) {
    std::array<double, kColumns> result{};
    auto count = static_cast<double>(trials.size());
    for (std::size_t i = 0; i < kColumns; ++i) {
        double sum = 0.0, squares = 0.0;
        for (const Trial& trial : trials) sum += trial.terms[i];
        for (const Trial& trial : trials) squares += std::pow(trial.terms[i] - sum / count, 2);
        result[i] = squares / count;
    }
    return result;
}

/// Logistic regression by Newton's method. The ridge is slight, weighs each term by its own spread, and
/// spares the bias.
cv::Mat fitted(const std::vector<Trial>& trials) {
    constexpr int kRounds = 40;
    constexpr double kRidge = 1e-3;
    constexpr int kSide = static_cast<int>(kColumns);
    cv::Mat weights = cv::Mat::zeros(kSide, 1, CV_64F);
    const auto spread = variances(trials);
    for (int round = 0; round < kRounds; ++round) {
        cv::Mat curvature = cv::Mat::zeros(kSide, kSide, CV_64F), slope = cv::Mat::zeros(kSide, 1, CV_64F);
        for (const Trial& trial : trials) {
            double p = 1.0 / (1.0 + std::exp(-dot(trial.terms, weights)));
            cv::Mat row(kSide, 1, CV_64F, const_cast<double*>(trial.terms.data()));
            curvature += p * (1 - p) * row * row.t();
            slope += ((trial.right ? 1.0 : 0.0) - p) * row;
        }
        for (int i = 0; i < kSide; ++i) {
            double ridge = (i > 0 ? kRidge * spread[static_cast<std::size_t>(i)] : 1e-9) *
                           static_cast<double>(trials.size());
            curvature.at<double>(i, i) += ridge;
            slope.at<double>(i) -= ridge * weights.at<double>(i);
        }
        cv::Mat step;
        cv::solve(curvature, slope, step, cv::DECOMP_CHOLESKY);
        weights += step;
    }
    return weights;
}

int fit(const std::vector<std::string>& files) {
    Material material = read(files);
    cv::Mat weights = fitted(material.trials);
    std::printf("bias %.3f, weights", weights.at<double>(0));
    for (int i = 1; i < weights.rows; ++i) std::printf(" %.3f", weights.at<double>(i));
    std::printf("\n| log-odds | easy | medium | hard | false |\n|---:|---:|---:|---:|---:|\n");
    for (double least = -1.0; least <= 6.0; least += 0.5) {
        std::array<int, 4> found{};
        int wrong = 0;
        for (const Trial& trial : material.trials) {
            if (dot(trial.terms, weights) < least) continue;
            if (trial.right)
                ++found[static_cast<std::size_t>(trial.difficulty)];
            else
                ++wrong;
        }
        std::printf("| %.1f |", least);
        for (std::size_t i = 0; i < 3; ++i)
            std::printf(" %.4f |", static_cast<double>(found[i]) / std::max(1, material.shown[i]));
        std::printf(" %d |\n", wrong);
    }
    return 0;
}

} // namespace

} // namespace farol::bench

int main(int argc, char** argv) {
    using namespace farol::bench;
    cv::setNumThreads(1);
    auto number = [&](int at) { return std::atoi(argv[at]); };
    if (argc == 6 && std::strcmp(argv[1], "gather") == 0)
        return gather(argv[2], std::strtoull(argv[3], nullptr, 10), number(4), number(5));
    if (argc == 6 && std::strcmp(argv[1], "write") == 0)
        return write(argv[2], std::strtoull(argv[3], nullptr, 10), number(4), argv[5]);
    if (argc == 6 && std::strcmp(argv[1], "measure") == 0)
        return measure(argv[2], std::strtoull(argv[3], nullptr, 10), number(4), argv[5]);
    if (argc > 2 && std::strcmp(argv[1], "fit") == 0)
        return fit(std::vector<std::string>(argv + 2, argv + argc));
    return 2;
}
