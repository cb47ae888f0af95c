#include "core/recognition/object_matcher.h"

#include "core/capture/picture.h"
#include "core/recognition/grey.h"
#include "core/recognition/view_poses.h"

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace farol::recognition {

namespace {

constexpr int kPatch = 64;             // side of the compared patch
constexpr int kBlock = 16;             // compared block by block, so that a hidden part spoils only its own
constexpr std::size_t kBestBlocks = 8; // of 16: the other half may be hidden
constexpr std::size_t kFewestVotes = 4;
constexpr std::size_t kMostCandidates = 8;

Quad quadFrom(const std::array<cv::Point2f, 4>& corners) {
    Quad quad;
    for (std::size_t i = 0; i < 4; ++i) quad[i] = {corners[i].x, corners[i].y};
    return quad;
}

/// Could a camera see a rectangle so? Empty when it could, else the reason.
const char* insaneQuad(const std::array<cv::Point2f, 4>& quad, cv::Size frame) {
    std::vector<cv::Point2f> corners(quad.begin(), quad.end());
    if (!cv::isContourConvex(corners)) return "folded_quad";
    double area = cv::contourArea(corners, true);
    double whole = static_cast<double>(frame.area());
    if (area < 0.0) return "mirrored_quad";
    if (area < 0.0016 * whole || area > 4.0 * whole) return "impossible_size";
    std::array<double, 4> side{};
    for (std::size_t i = 0; i < 4; ++i) side[i] = cv::norm(quad[i] - quad[(i + 1) % 4]);
    auto uneven = [](double a, double b) { return std::max(a, b) > 3.0 * std::min(a, b); };
    if (uneven(side[0], side[2]) || uneven(side[1], side[3])) return "folded_quad";
    double width = (side[0] + side[2]) / 2.0;
    double height = (side[1] + side[3]) / 2.0;
    if (std::max(width, height) > 8.0 * std::min(width, height)) return "sliver_quad";
    for (const cv::Point2f& p : quad)
        if (p.x < -0.65 * frame.width || p.y < -0.8 * frame.height || p.x > 1.65 * frame.width ||
            p.y > 1.8 * frame.height)
            return "outside_frame";
    return nullptr;
}

float extentOf(const std::array<cv::Point2f, 4>& quad) {
    return static_cast<float>(std::sqrt(cv::contourArea(std::vector<cv::Point2f>(quad.begin(), quad.end()))));
}

cv::Point2f centreOf(const std::array<cv::Point2f, 4>& quad) {
    return (quad[0] + quad[1] + quad[2] + quad[3]) * 0.25F;
}

/// The object as the photograph shows it, on a small square.
cv::Mat patchOf(const View& view, const Plane& plane) {
    auto image = capture::decodePicture(view.jpeg, "");
    if (!image) return {};
    cv::Mat grey = greyOf(*image);
    ImageBox box = boundingBox(view.outline);
    double reduction = std::max(box.width, box.height) / kPatch;
    cv::GaussianBlur(grey, grey, cv::Size(), std::max(0.5, reduction * 0.225));
    cv::Matx33d half(1, 0, -0.5, 0, 1, -0.5, 0, 0, 1);
    cv::Matx33d toPlane(plane.width / kPatch, 0, 0, 0, plane.height / kPatch, 0, 0, 0, 1);
    cv::Mat patch;
    cv::warpPerspective(grey, patch, half * planeToQuad(plane, view.outline) * toPlane * half.inv(),
                        cv::Size(kPatch, kPatch), cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                        cv::BORDER_REPLICATE);
    return patch;
}

/// The view that shows most of the object, frontal ones first.
const View* bestView(const Template& entry) {
    const View* best = nullptr;
    double most = -1.0;
    for (const View& view : entry.views) {
        double worth = boundingBox(view.outline).area() * (nearlyFrontal(view.outline) ? 100.0 : 1.0);
        if (worth > most) {
            most = worth;
            best = &view;
        }
    }
    return best;
}

double blockCorrelation(const cv::Mat& a, const cv::Mat& b) {
    cv::Scalar meanA, meanB, deviationA, deviationB;
    cv::meanStdDev(a, meanA, deviationA);
    cv::meanStdDev(b, meanB, deviationB);
    double sum = 0.0;
    for (int y = 0; y < a.rows; ++y)
        for (int x = 0; x < a.cols; ++x)
            sum += (a.at<unsigned char>(y, x) - meanA[0]) * (b.at<unsigned char>(y, x) - meanB[0]);
    // The 3 grey levels keep two flat blocks from agreeing by their noise.
    return sum / static_cast<double>(a.total()) / ((deviationA[0] + 3.0) * (deviationB[0] + 3.0));
}

} // namespace

ObjectMatcher::ObjectMatcher(const LandmarkLibrary& library, const RecogniserOptions& options)
    : m_options(options) {
    std::vector<cv::Mat> descriptors;
    for (const Template& entry : library.templates)
        if (entry.kind != Kind::Place && !entry.views.empty()) addObject(entry, descriptors);
    if (m_rows.empty()) return;
    cv::Mat all;
    cv::vconcat(descriptors, all);
    m_index = std::make_unique<ByteIndex>(all);
}

void ObjectMatcher::addObject(const Template& entry, std::vector<cv::Mat>& descriptors) {
    const View& best = *bestView(entry);
    Plane plane = planeOf(best.outline, entry.widthM, entry.heightM);
    Object object{&entry, cv::Point2f(static_cast<float>(plane.width), static_cast<float>(plane.height)),
                  patchOf(best, plane)};
    int number = static_cast<int>(m_objects.size());
    for (const View& view : entry.views) {
        cv::Matx33d photoToPlane = planeToQuad(plane, view.outline).inv();
        Plane posePlane = planeOf(view.outline, {}, {}); // as at training
        cv::Matx33d photoToPosePlane = planeToQuad(posePlane, view.outline).inv();
        std::array<cv::Matx33d, kPoseCount + 1> photoToPicture;
        std::array<std::array<cv::Point2f, 4>, kPoseCount + 1> quads;
        for (int pose = 0; pose <= kPoseCount; ++pose) {
            auto at = static_cast<std::size_t>(pose);
            auto posed = pose > 0 ? posedView(posePlane, pose, posedLongSide(view.outline)) : std::nullopt;
            photoToPicture[at] = posed ? posed->planeToPicture * photoToPosePlane : cv::Matx33d::eye();
            quads[at] = mapped(photoToPicture[at] * planeToQuad(plane, view.outline), plane.corners());
        }
        for (const cv::KeyPoint& point : view.features.keypoints) {
            auto pose = static_cast<std::size_t>(std::clamp(point.class_id, 0, kPoseCount));
            cv::Point2f seen = mapped(photoToPicture[pose], cv::Point2d(point.pt));
            Row row;
            row.object = number;
            row.onPlane = mapped(photoToPlane, cv::Point2d(point.pt));
            row.toCentre = centreOf(quads[pose]) - seen;
            row.size = std::max(point.size, 1e-3F);
            row.angle = point.angle;
            row.extent = std::max(extentOf(quads[pose]), 1.0F);
            m_rows.push_back(row);
        }
        if (view.features.descriptors.rows > 0) descriptors.push_back(view.features.descriptors);
    }
    m_objects.push_back(std::move(object));
}

std::vector<std::vector<ObjectMatcher::Pair>> ObjectMatcher::pairsByObject(const Features& frame) const {
    Neighbours near = m_index->search(frame.descriptors, m_options.neighbours, m_options.searchChecks);
    std::vector<std::vector<Pair>> pairs(m_objects.size());
    for (int query = 0; query < frame.descriptors.rows; ++query) {
        std::size_t first = static_cast<std::size_t>(query) * static_cast<std::size_t>(near.each);
        if (near.rows[first] < 0) continue;
        int object = m_rows[static_cast<std::size_t>(near.rows[first])].object;
        // The views of one template show the same points: only another template's neighbour says how unusual
        // this one is. Where all are of one template, the farthest of them stands in.
        float rival = 0.0F;
        for (std::size_t i = first + 1; i < first + static_cast<std::size_t>(near.each) && near.rows[i] >= 0;
             ++i) {
            rival = near.distances[i];
            if (m_rows[static_cast<std::size_t>(near.rows[i])].object != object) break;
        }
        float ratio = rival > 0.0F ? std::sqrt(near.distances[first] / rival) : 0.0F;
        if (ratio < m_options.ratio)
            pairs[static_cast<std::size_t>(object)].push_back({query, near.rows[first], ratio});
    }
    return pairs;
}

ObjectMatcher::Candidate ObjectMatcher::largestCluster(int object, const std::vector<Pair>& pairs,
                                                       const Features& frame) const {
    struct Vote {
        cv::Point2f centre;
        float logExtent, angle;
    };
    std::vector<Vote> votes;
    for (const Pair& pair : pairs) {
        const cv::KeyPoint& seen = frame.keypoints[static_cast<std::size_t>(pair.query)];
        const Row& row = m_rows[static_cast<std::size_t>(pair.row)];
        float scale = seen.size / row.size;
        float angle = (seen.angle - row.angle) * static_cast<float>(kPi / 180.0);
        cv::Point2f t = row.toCentre;
        cv::Point2f turned(t.x * std::cos(angle) - t.y * std::sin(angle),
                           t.x * std::sin(angle) + t.y * std::cos(angle));
        votes.push_back({seen.pt + turned * scale, std::log2(scale * row.extent), angle});
    }
    auto agree = [&](const Vote& a, const Vote& b, float reach, float logScale, float cosine) {
        return cv::norm(a.centre - b.centre) < reach * std::exp2(a.logExtent) &&
               std::abs(a.logExtent - b.logExtent) < logScale && std::cos(a.angle - b.angle) > cosine;
    };
    std::size_t most = 0;
    const Vote* seed = nullptr;
    for (const Vote& vote : votes) {
        auto count =
            static_cast<std::size_t>(std::count_if(votes.begin(), votes.end(), [&](const Vote& other) {
                return agree(vote, other, 0.35F, 0.8F, 0.8F);
            }));
        if (count > most) {
            most = count;
            seed = &vote;
        }
    }
    Candidate candidate;
    candidate.object = object;
    if (most < kFewestVotes) return candidate;
    for (std::size_t i = 0; i < votes.size(); ++i)
        if (agree(*seed, votes[i], 0.6F, 1.2F, 0.5F)) candidate.pairs.push_back(pairs[i]);
    std::stable_sort(candidate.pairs.begin(), candidate.pairs.end(),
                     [](const Pair& a, const Pair& b) { return a.ratio < b.ratio; });
    return candidate;
}

double ObjectMatcher::patchCorrelation(const Object& object, const cv::Mat& grey,
                                       const cv::Matx33d& planeToFrame) const {
    if (object.patch.empty()) return 1.0; // the photograph is gone: geometry alone decides
    cv::Matx33d half(1, 0, -0.5, 0, 1, -0.5, 0, 0, 1);
    cv::Matx33d toPlane(object.planeSize.x / kPatch, 0, 0, 0, object.planeSize.y / kPatch, 0, 0, 0, 1);
    cv::Mat seen;
    cv::warpPerspective(grey, seen, half * planeToFrame * toPlane * half.inv(), cv::Size(kPatch, kPatch),
                        cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_REPLICATE);
    std::vector<double> blocks;
    for (int y = 0; y < kPatch; y += kBlock)
        for (int x = 0; x < kPatch; x += kBlock) {
            cv::Rect block(x, y, kBlock, kBlock);
            blocks.push_back(blockCorrelation(seen(block), object.patch(block)));
        }
    std::sort(blocks.begin(), blocks.end(), std::greater<>());
    return std::accumulate(blocks.begin(), blocks.begin() + kBestBlocks, 0.0) /
           static_cast<double>(kBestBlocks);
}

void ObjectMatcher::verify(const Candidate& candidate, const cv::Mat& grey, const Features& frame,
                           DetectorResult& result) const {
    const Object& object = m_objects[static_cast<std::size_t>(candidate.object)];
    Rejection rejection{"landmarks", object.entry->kind, object.entry->id, {}, "", 0.0};
    auto reject = [&](const char* reason, double value) {
        rejection.reason = reason;
        rejection.value = value;
        result.rejections.push_back(rejection);
    };
    std::vector<cv::Point2f> plane, seen;
    for (const Pair& pair : candidate.pairs) {
        plane.push_back(m_rows[static_cast<std::size_t>(pair.row)].onPlane);
        seen.push_back(frame.keypoints[static_cast<std::size_t>(pair.query)].pt);
    }
    // Pixels of a picture 640 wide, whatever the camera gives.
    double reach = m_options.reprojectionPx * std::max(grey.cols, grey.rows) / 640.0;
    cv::Mat estimate;
    try {
        estimate = cv::findHomography(plane, seen, cv::USAC_MAGSAC, 0.75 * reach, cv::noArray(), 500, 0.999);
    } catch (const cv::Exception&) { // all points on one line, for example
    }
    if (estimate.empty()) return reject("no_homography", static_cast<double>(candidate.pairs.size()));
    cv::Matx33d planeToFrame(estimate);
    Plane shape{object.planeSize.x, object.planeSize.y};
    auto corners = mapped(planeToFrame, shape.corners());
    rejection.quad = quadFrom(corners);
    if (const char* reason = insaneQuad(corners, grey.size()))
        return reject(reason, static_cast<double>(candidate.pairs.size()));
    int inliers = 0;
    for (std::size_t i = 0; i < plane.size(); ++i)
        if (cv::norm(mapped(planeToFrame, cv::Point2d(plane[i])) - cv::Point2d(seen[i])) < reach) ++inliers;
    if (inliers < m_options.minInliers) return reject("few_inliers", inliers);
    double correlation = patchCorrelation(object, grey, planeToFrame);
    if (correlation < m_options.minPatchCorrelation) return reject("low_patch_correlation", correlation);
    Detection detection;
    detection.kind = object.entry->kind;
    detection.templateId = object.entry->id;
    detection.quad = rejection.quad;
    detection.image = {grey.cols, grey.rows};
    detection.inliers = inliers;
    detection.score = std::clamp(0.5 * inliers / (inliers + 8.0) + 0.5 * correlation, 0.0, 1.0);
    result.detections.push_back(std::move(detection));
}

DetectorResult ObjectMatcher::match(const cv::Mat& grey, const Features& frame) const {
    DetectorResult result;
    if (empty() || frame.keypoints.empty()) return result;
    auto pairs = pairsByObject(frame);
    std::vector<Candidate> candidates;
    for (std::size_t object = 0; object < pairs.size(); ++object) {
        if (pairs[object].size() < kFewestVotes) continue;
        Candidate candidate = largestCluster(static_cast<int>(object), pairs[object], frame);
        if (candidate.pairs.size() >= kFewestVotes) candidates.push_back(std::move(candidate));
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.pairs.size() > b.pairs.size(); });
    if (candidates.size() > kMostCandidates) candidates.resize(kMostCandidates);
    for (const Candidate& candidate : candidates) verify(candidate, grey, frame, result);
    std::stable_sort(result.detections.begin(), result.detections.end(),
                     [](const Detection& a, const Detection& b) { return a.score > b.score; });
    return result;
}

} // namespace farol::recognition
