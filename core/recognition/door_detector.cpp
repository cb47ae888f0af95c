#include "core/recognition/door_detector.h"

#include "core/recognition/boosted_trees.h"
#include "core/recognition/door_cues.h"
#include "core/recognition/models.h"

#include <algorithm>
#include <cmath>

namespace farol::recognition {

namespace {

constexpr std::size_t kMostRejections = 20; // the best few tell enough

/// Compiled in and tested: a damaged one would answer "no door" everywhere.
const BoostedTrees& classifier() {
    static const BoostedTrees trees = [] {
        auto parsed = BoostedTrees::parse(doorTrees(), kDoorCueCount);
        return parsed ? std::move(*parsed) : BoostedTrees({}, -20.0);
    }();
    return trees;
}

struct Judged {
    const DoorCandidate* candidate = nullptr;
    double score = 0.0;
};

/// The plainest of what speaks against a candidate, for those who look at rejections.
std::pair<const char*, double> doubtOf(const DoorCandidate& candidate, double score) {
    const DoorCues& cues = candidate.cues;
    double bottom = cues[3], lintel = cues[14], above = cues[16], lineAcross = cues[46], lineUp = cues[48];
    double edges = static_cast<double>(cues[44]) + cues[45];
    if (candidate.footSeen && bottom < 0.6) return {"above_the_floor", bottom};
    if (candidate.topSeen && lintel < 0.6) return {"weak_lintel", lintel};
    if (above > 0.8) return {"jambs_go_on_above", above};
    if (lineAcross > 0.9) return {"line_across", lineAcross};
    if (lineUp > 0.9) return {"line_up_the_middle", lineUp};
    if (edges > 16.0) return {"busy_leaf", edges};
    return {"low_score", score};
}

/// The leaf, its frame and the frame's shadow are one door; and no door is inside another.
bool sameDoor(const Quad& kept, const Quad& other) {
    ImageBox a = boundingBox(kept), b = boundingBox(other);
    double width = std::min(a.x + a.width, b.x + b.width) - std::max(a.x, b.x);
    double height = std::min(a.y + a.height, b.y + b.height) - std::max(a.y, b.y);
    if (width <= 0.0 || height <= 0.0) return false;
    return width * height > 0.5 * std::min(a.width * a.height, b.width * b.height);
}

Detection detectionOf(const Judged& judged, const cv::Mat& image, const DoorDetectorOptions& options) {
    Detection detection;
    detection.kind = Kind::Door;
    detection.quad = judged.candidate->quad;
    detection.image = {image.cols, image.rows};
    detection.score = judged.score;
    if (options.focalPx > 0.0) {
        ImagePoint centre = boundingBox(detection.quad).centre();
        detection.bearing = Radians{std::atan2(image.cols / 2.0 - centre.x, options.focalPx)};
        if (judged.candidate->topSeen && judged.candidate->footSeen)
            if (RangeEstimate range = doorRange(detection.quad, options); range.metres > 0.0) {
                detection.rangeM = range.metres;
                detection.rangeSpread = range.spread / range.metres;
            }
    }
    return detection;
}

} // namespace

Result<void> DoorDetectorOptions::check() const {
    auto wrong = [](const std::string& message, const char* option) {
        return Error{ErrorCode::InvalidArgument, message, option};
    };
    if (!(minHeightShare > 0.0 && minHeightShare <= 1.0))
        return wrong("a share lies between 0 and 1", "minHeightShare");
    if (!(maxTiltDegrees > 0.0 && maxTiltDegrees < 45.0))
        return wrong("a tilt lies between 0 and 45 degrees", "maxTiltDegrees");
    if (!(minAspect > 0.0 && maxAspect > minAspect))
        return wrong("the greatest aspect must be above the least", "maxAspect");
    if (!(minScore >= 0.0 && minScore <= 1.0)) return wrong("a score lies between 0 and 1", "minScore");
    if (!(focalPx >= 0.0)) return wrong("a focal length is positive, or 0 where it is unknown", "focalPx");
    if (!(focalSpread >= 0.0 && focalSpread < 1.0))
        return wrong("the spread is a share of the focal length", "focalSpread");
    if (!(leafHeightM > 0.5 && leafHeightM < 5.0)) return wrong("a door is 0.5 to 5 m high", "leafHeightM");
    if (!(leafSpreadM >= 0.0 && leafSpreadM < leafHeightM))
        return wrong("doors differ by less than their height", "leafSpreadM");
    return {};
}

RangeEstimate doorRange(const Quad& quad, const DoorDetectorOptions& options) {
    double left = std::hypot(quad[3].x - quad[0].x, quad[3].y - quad[0].y);
    double right = std::hypot(quad[2].x - quad[1].x, quad[2].y - quad[1].y);
    if (!(left > 0.0 && right > 0.0 && options.focalPx > 0.0)) return {};
    // Each jamb is as far as it is short; the outline is good to about two pixels at either end.
    double pixels = 2.0 / (1.0 / left + 1.0 / right);
    RangeEstimate range;
    range.metres = options.focalPx * options.leafHeightM / pixels;
    range.spread = range.metres *
                   std::hypot(options.leafSpreadM / options.leafHeightM, 3.0 / pixels, options.focalSpread);
    return range;
}

DetectorResult detectDoors(const cv::Mat& image, const DoorDetectorOptions& options) {
    DetectorResult result;
    DoorCueOptions look;
    look.minHeightShare = options.minHeightShare;
    look.maxTiltDegrees = options.maxTiltDegrees;
    look.minAspect = options.minAspect;
    look.maxAspect = options.maxAspect;
    std::vector<DoorCandidate> candidates = doorCandidates(image, look);
    std::vector<Judged> judged;
    for (const DoorCandidate& candidate : candidates)
        judged.push_back({&candidate, classifier().probability(candidate.cues)});
    std::stable_sort(judged.begin(), judged.end(),
                     [](const Judged& a, const Judged& b) { return a.score > b.score; });
    for (const Judged& one : judged) {
        const Quad& quad = one.candidate->quad;
        auto taken = [&](const auto& other) { return sameDoor(other.quad, quad); };
        if (std::any_of(result.detections.begin(), result.detections.end(), taken)) continue;
        if (one.score >= options.minScore) {
            result.detections.push_back(detectionOf(one, image, options));
        } else if (result.rejections.size() < kMostRejections &&
                   std::none_of(result.rejections.begin(), result.rejections.end(), taken)) {
            auto [reason, value] = doubtOf(*one.candidate, one.score);
            result.rejections.push_back({"doors", Kind::Door, {}, quad, reason, value});
        }
    }
    return result;
}

} // namespace farol::recognition
