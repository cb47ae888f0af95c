#include "core/recognition/stairs_detector.h"

#include "core/recognition/stairs_cues.h"

#include <algorithm>
#include <cmath>

namespace farol::recognition {

namespace {

/// The cues by name: see cuesOf.
struct Row {
    double edges, growth, roughness, width, height, bottom, contrastSpread, breadth, widening, uprights, step;

    explicit Row(const StairsCues& c)
        : edges(c[0]),
          growth(c[1]),
          roughness(c[2]),
          width(c[4]),
          height(c[6]),
          bottom(c[7]),
          contrastSpread(c[10]),
          breadth(c[11]),
          widening(c[13]),
          uprights(c[16]),
          step(c[19]) {}
};

struct Judgement {
    double score = 0.0;
    const char* reason = nullptr;
    double value = 0.0;
};

/// Few or narrow steps must be the more regular to be believed.
double roughnessAllowed(const Row& row) {
    double most = 0.21;
    if (row.edges < 7.0) most = row.edges < 6.0 ? 0.06 : 0.11;
    if (row.width < 0.22) most = std::min(most, row.edges < 7.0 ? 0.03 : 0.06);
    return most;
}

Judgement judge(const Row& row, const StairsDetectorOptions& options) {
    Judgement judgement;
    auto because = [&](const char* reason, double value) {
        judgement.reason = reason;
        judgement.value = value;
        return judgement;
    };
    if (row.edges < options.minEdges) return because("few_edges", row.edges);
    if (row.width < options.minWidthShare) return because("narrow", row.width);
    if (row.bottom < 0.58) return because("above_the_floor", row.bottom); // lamps, blinds, shelves
    if (row.height < 0.15 || (row.edges < 7.0 && row.height < 0.25)) return because("low_row", row.height);
    if (row.growth < 0.03)
        return because("even_spacing", row.growth); // shelves, lockers, blinds face the camera
    if (row.growth > 0.30) return because("floor_spacing", row.growth); // tiles shrink with the square
    if (row.breadth < 2.4)
        return because("high_steps", row.breadth); // drawers: a step is far wider than high
    if (row.widening < -0.25) return because("wider_above", row.widening);
    if (row.uprights > 0.75) return because("grid", row.uprights); // tiles and windows have joints both ways
    if (row.step < 4.0) return because("flat_lines", row.step);    // a joint's two sides look alike
    if (row.contrastSpread > 0.75) return because("uneven_contrast", row.contrastSpread);
    double most = roughnessAllowed(row);
    if (row.roughness > most) return because("uneven_spacing", row.roughness);
    judgement.score =
        std::min(1.0, 0.5 + 0.04 * std::min(row.edges - 5.0, 5.0) + 0.15 * (1.0 - row.roughness / most) +
                          0.15 * std::clamp((row.height - 0.15) / 0.4, 0.0, 1.0));
    if (judgement.score < options.minScore) return because("low_score", judgement.score);
    return judgement;
}

} // namespace

Result<void> StairsDetectorOptions::check() const {
    auto wrong = [](const std::string& message, const char* option) {
        return Error{ErrorCode::InvalidArgument, message, option};
    };
    if (minEdges < 4 || minEdges > 50) return wrong("a flight shows 4 to 50 edges", "minEdges");
    if (!(minWidthShare > 0.0 && minWidthShare < 1.0))
        return wrong("a share lies between 0 and 1", "minWidthShare");
    if (!(minScore >= 0.0 && minScore <= 1.0)) return wrong("a score lies between 0 and 1", "minScore");
    return {};
}

DetectorResult detectStairs(const cv::Mat& image, const StairsDetectorOptions& options) {
    DetectorResult result;
    Detection best;
    for (const StairsCandidate& candidate : stairsCandidates(image)) {
        Judgement judgement = judge(Row(candidate.cues), options);
        if (judgement.reason != nullptr) {
            result.rejections.push_back(
                {"stairs", Kind::Stairs, {}, candidate.quad, judgement.reason, judgement.value});
        } else if (judgement.score > best.score) {
            best.kind = Kind::Stairs;
            best.quad = candidate.quad;
            best.image = {image.cols, image.rows};
            best.score = judgement.score;
        }
    }
    // Nosings and the feet of the risers are two rows of one flight: the doubt of one is the other's no more.
    if (best.score > 0.0) {
        result.rejections.clear();
        result.detections.push_back(best);
    }
    return result;
}

} // namespace farol::recognition
