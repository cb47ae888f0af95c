// farol-train FOLDER_OF_DATA OUT.trees: trains the door classifier and prints how it does on pictures it has
// not been trained on (five parts held out in turn, all of the development halves). The other halves are
// never opened here: `farol-cli evaluate doors` shows them.

#include "core/recognition/door_cues.h"
#include "tests/recognition/drawn_scenes.h"
#include "tests/training/boosting.h"
#include "tests/training/training_pictures.h"

#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>

namespace farol::training {
namespace {

using recognition::BoostedTrees;
using recognition::DoorCandidate;

constexpr int kParts = 5, kVariants = 6, kDrawnScenes = 400;

struct View {
    int picture = 0;
    bool plain = true;
    std::string set;
    std::vector<ImageBox> boxes;
    std::vector<DoorCandidate> candidates;
    double weight = 1.0;
};

std::vector<View> viewsOf(const std::vector<TrainingPicture>& pictures) {
    std::vector<View> views;
    cv::RNG random(7);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        cv::Mat picture = cv::imread(pictures[i].file.string());
        for (int variant = 0; variant < (pictures[i].boxes.empty() ? kVariants / 2 : kVariants); ++variant) {
            View view{static_cast<int>(i), variant == 0, pictures[i].set,
                      pictures[i].boxes,   {},           pictures[i].weight};
            view.candidates = recognition::doorCandidates(varied(picture, variant, view.boxes, random));
            views.push_back(std::move(view));
        }
    }
    return views;
}

void addDrawnScenes(std::vector<View>& views) {
    int picture = views.back().picture;
    for (int i = 0; i < kDrawnScenes; ++i) {
        auto scene = recognition::test::randomDoorScene(100000U + static_cast<std::uint64_t>(i));
        View view{++picture, true, "drawn", {}, {}, 0.5};
        for (const Quad& quad : scene.doors) {
            ImageBox box = boundingBox(quad);
            double x0 = std::max(0.0, box.x), y0 = std::max(0.0, box.y);
            double x1 = std::min<double>(scene.picture.cols, box.x + box.width);
            double y1 = std::min<double>(scene.picture.rows, box.y + box.height);
            if (x1 - x0 > 0.8 * box.width) view.boxes.push_back({x0, y0, x1 - x0, y1 - y0});
        }
        view.candidates = recognition::doorCandidates(scene.picture);
        views.push_back(std::move(view));
    }
}

double bestOverlap(const View& view, const DoorCandidate& candidate) {
    double best = 0.0;
    for (const ImageBox& box : view.boxes) best = std::max(best, overlap(boundingBox(candidate.quad), box));
    return best;
}

std::vector<Sample> samplesOf(const std::vector<View>& views, int heldOut) {
    std::vector<Sample> samples;
    for (const View& view : views) {
        if (view.picture % kParts == heldOut) continue;
        double yes = 0.0, no = 0.0;
        std::size_t from = samples.size();
        for (const DoorCandidate& candidate : view.candidates) {
            double shared = bestOverlap(view, candidate);
            if (shared >= 0.45 && shared < 0.62) continue; // neither door nor not
            Sample sample{{candidate.cues.begin(), candidate.cues.end()}, shared >= 0.62, 1.0, view.picture};
            (sample.positive ? yes : no) += 1.0;
            samples.push_back(std::move(sample));
        }
        // A picture full of lines counts no more than one with few.
        for (std::size_t i = from; i < samples.size(); ++i)
            samples[i].weight =
                view.weight * (samples[i].positive ? std::min(1.0, 8.0 / yes) : std::min(1.0, 20.0 / no));
    }
    return samples;
}

struct Tally {
    int truths = 0, found = 0, wrong = 0, pictures = 0;
};

void book(const View& view, const BoostedTrees& trees, double least, Tally& tally) {
    std::vector<std::pair<double, const DoorCandidate*>> order;
    for (const DoorCandidate& c : view.candidates) order.emplace_back(trees.probability(c.cues), &c);
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<const DoorCandidate*> kept;
    for (auto [score, candidate] : order) {
        if (score < least) break;
        bool copy = std::any_of(kept.begin(), kept.end(), [&](const DoorCandidate* k) {
            return overlap(boundingBox(k->quad), boundingBox(candidate->quad)) > 0.3;
        });
        if (copy) continue;
        kept.push_back(candidate);
        (bestOverlap(view, *candidate) >= 0.5 ? tally.found : tally.wrong) += 1;
    }
    tally.truths += static_cast<int>(view.boxes.size());
    ++tally.pictures;
}

void crossValidate(const std::vector<View>& views) {
    std::vector<BoostedTrees> parts;
    for (int part = 0; part < kParts; ++part) parts.push_back(boost(samplesOf(views, part), {}));
    for (double least : {0.5, 0.6, 0.7, 0.8, 0.9}) {
        std::map<std::string, Tally> tallies;
        for (const View& view : views)
            if (view.plain)
                book(view, parts[static_cast<std::size_t>(view.picture % kParts)], least, tallies[view.set]);
        for (const auto& [set, t] : tallies)
            std::printf("%.2f %-12s %3d pictures %3d doors %3d found %3d wrong\n", least, set.c_str(),
                        t.pictures, t.truths, t.found, t.wrong);
    }
}

int train(const std::filesystem::path& data, const std::filesystem::path& out) {
    auto pictures = doorPictures(data, std::filesystem::path(FAROL_SOURCE_DIR) / "tests" / "training");
    if (!pictures) {
        std::fprintf(stderr, "farol-train: %s\n", pictures.error().text().c_str());
        return 1;
    }
    std::vector<View> views = viewsOf(*pictures);
    addDrawnScenes(views);
    crossValidate(views);
    BoostedTrees trees = boost(samplesOf(views, -1), {});
    std::ofstream file(out);
    file << trees.text(recognition::kDoorCueCount);
    return file.good() ? 0 : 1;
}

} // namespace
} // namespace farol::training

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "farol-train FOLDER_OF_DATA OUT.trees\n");
        return 2;
    }
    return farol::training::train(argv[1], argv[2]);
}
