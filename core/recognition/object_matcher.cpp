#include "core/recognition/object_matcher.h"

#include "core/recognition/object_patch.h"
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

constexpr std::size_t kFewestVotes = 3;
constexpr std::size_t kMostCandidates = 16;
constexpr int kMostOfOneObject = 3; // two extinguishers side by side are two

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

std::vector<cv::Point2f> borderOf(const Quad& quad) {
    std::vector<cv::Point2f> border;
    for (const ImagePoint& p : quad) border.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y));
    return border;
}

/// Two of one kind hang side by side; what lies across a found one is a likeness within it.
bool liesAcross(const Quad& quad, const Quad& known) {
    constexpr double kMostShared = 0.2; // of the smaller
    std::vector<cv::Point2f> a = borderOf(quad), b = borderOf(known), common;
    double shared = cv::intersectConvexConvex(a, b, common);
    return shared > kMostShared * std::min(cv::contourArea(a), cv::contourArea(b));
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

} // namespace

/// The frame's keypoints by where they lie.
class ObjectMatcher::FrameGrid {
public:
    explicit FrameGrid(const Features& frame, cv::Size size)
        : m_columns(size.width / kCell + 1),
          m_rows(size.height / kCell + 1),
          m_cells(static_cast<std::size_t>(m_columns * m_rows)) {
        for (std::size_t i = 0; i < frame.keypoints.size(); ++i) {
            const cv::Point2f& at = frame.keypoints[i].pt;
            m_cells[static_cast<std::size_t>(row(at.y) * m_columns + column(at.x))].push_back(
                static_cast<int>(i));
        }
    }

    template <class Visit>
    void near(const cv::Point2f& at, float reach, Visit visit) const {
        for (int y = row(at.y - reach); y <= row(at.y + reach); ++y)
            for (int x = column(at.x - reach); x <= column(at.x + reach); ++x)
                for (int i : m_cells[static_cast<std::size_t>(y * m_columns + x)]) visit(i);
    }

private:
    static constexpr int kCell = 16;

    int column(float x) const { return std::clamp(static_cast<int>(x) / kCell, 0, m_columns - 1); }
    int row(float y) const { return std::clamp(static_cast<int>(y) / kCell, 0, m_rows - 1); }

    int m_columns, m_rows;
    std::vector<std::vector<int>> m_cells;
};

ObjectMatcher::ObjectMatcher(const LandmarkLibrary& library, const RecogniserOptions& options)
    : m_options(options),
      m_extractor(library.extractor.name),
      m_likeEnough(likeEnough(library.extractor.name)) {
    std::vector<cv::Mat> descriptors;
    for (const Template& entry : library.templates)
        if (entry.kind != Kind::Place && !entry.views.empty()) addObject(entry, descriptors);
    if (m_rows.empty()) return;
    cv::Mat all;
    cv::vconcat(descriptors, all);
    m_index.add(all);
}

ObjectMatcher::ObjectMatcher(const ObjectMatcher& before, const LandmarkLibrary& library)
    : ObjectMatcher(before) {
    std::map<std::string, const Template*> wanted;
    for (const Template& entry : library.templates)
        if (entry.kind != Kind::Place && !entry.views.empty()) wanted.emplace(entry.id.value, &entry);
    for (Object& object : m_objects) {
        if (object.entry == nullptr) continue;
        auto found = wanted.find(object.entry->id.value);
        if (found != wanted.end() && sameLook(*object.entry, *found->second)) {
            object.entry = found->second;
            wanted.erase(found);
        } else {
            object.entry = nullptr;
            m_index.remove(object.firstRow, object.rowCount);
        }
    }
    std::vector<cv::Mat> descriptors;
    for (const Template& entry : library.templates)
        if (auto found = wanted.find(entry.id.value); found != wanted.end() && found->second == &entry)
            addObject(entry, descriptors);
    if (descriptors.empty()) return;
    cv::Mat all;
    cv::vconcat(descriptors, all);
    m_index.add(all);
}

void ObjectMatcher::addObject(const Template& entry, std::vector<cv::Mat>& descriptors) {
    const View& best = *bestView(entry);
    Plane plane = planeOf(best.outline, entry.widthM, entry.heightM);
    Object object{&entry, cv::Point2f(static_cast<float>(plane.width), static_cast<float>(plane.height)),
                  patchOf(best, plane), static_cast<int>(m_rows.size()), 0};
    for (const View& view : entry.views) {
        addView(view, static_cast<int>(m_objects.size()), plane);
        if (view.features.descriptors.rows > 0)
            descriptors.push_back(comparable(m_extractor, view.features.descriptors));
    }
    object.rowCount = static_cast<int>(m_rows.size()) - object.firstRow;
    m_objects.push_back(std::move(object));
}

void ObjectMatcher::addView(const View& view, int object, const Plane& plane) {
    cv::Matx33d planeToPhoto = planeToQuad(plane, view.outline);
    cv::Matx33d photoToPlane = planeToPhoto.inv();
    Plane posePlane = planeOf(view.outline, {}, {}); // as at training
    cv::Matx33d photoToPosePlane = planeToQuad(posePlane, view.outline).inv();
    auto firstLook = static_cast<int>(m_looks.size());
    std::array<cv::Matx33d, kPoseCount + 1> photoToPicture;
    for (int pose = 0; pose <= kPoseCount; ++pose) {
        auto at = static_cast<std::size_t>(pose);
        auto posed = pose > 0 ? posedView(posePlane, pose, posedLongSide(view.outline)) : std::nullopt;
        photoToPicture[at] = posed ? posed->planeToPicture * photoToPosePlane : cv::Matx33d::eye();
        Look look{photoToPicture[at] * planeToPhoto, {}, 1.0F};
        auto quad = mapped(look.planeToPicture, plane.corners());
        look.centre = centreOf(quad);
        look.extent = std::max(extentOf(quad), 1.0F);
        m_looks.push_back(look);
    }
    for (const cv::KeyPoint& point : view.features.keypoints) {
        int pose = std::clamp(point.class_id, 0, kPoseCount);
        cv::Point2f seen = mapped(photoToPicture[static_cast<std::size_t>(pose)], cv::Point2d(point.pt));
        Row row;
        row.object = object;
        row.look = firstLook + pose;
        row.onPlane = mapped(photoToPlane, cv::Point2d(point.pt));
        row.toCentre = m_looks[static_cast<std::size_t>(row.look)].centre - seen;
        row.size = std::max(point.size, 1e-3F);
        row.angle = point.angle;
        m_rows.push_back(row);
    }
}

std::vector<std::vector<ObjectMatcher::Pair>> ObjectMatcher::pairsByObject(const Features& frame) const {
    Neighbours near = m_index.search(frame.descriptors, m_options.neighbours, m_options.searchChecks);
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

ObjectMatcher::Vote ObjectMatcher::voteOf(const Pair& pair, const Features& frame) const {
    const cv::KeyPoint& seen = frame.keypoints[static_cast<std::size_t>(pair.query)];
    const Row& row = m_rows[static_cast<std::size_t>(pair.row)];
    float scale = seen.size / row.size;
    float angle = (seen.angle - row.angle) * static_cast<float>(kPi / 180.0);
    cv::Point2f t = row.toCentre;
    cv::Point2f turned(t.x * std::cos(angle) - t.y * std::sin(angle),
                       t.x * std::sin(angle) + t.y * std::cos(angle));
    return {seen.pt + turned * scale, std::log2(scale * m_looks[static_cast<std::size_t>(row.look)].extent),
            angle};
}

std::optional<ObjectMatcher::Candidate>
ObjectMatcher::largestCluster(int object, const std::vector<Pair>& pairs, const Features& frame) const {
    std::vector<Vote> votes;
    for (const Pair& pair : pairs) votes.push_back(voteOf(pair, frame));
    auto agree = [](const Vote& a, const Vote& b, float reach, float logScale, float cosine) {
        return cv::norm(a.centre - b.centre) < reach * std::exp2(a.logExtent) &&
               std::abs(a.logExtent - b.logExtent) < logScale && std::cos(a.angle - b.angle) > cosine;
    };
    std::size_t most = 0;
    std::size_t seed = 0;
    for (std::size_t i = 0; i < votes.size(); ++i) {
        auto count =
            static_cast<std::size_t>(std::count_if(votes.begin(), votes.end(), [&](const Vote& other) {
                return agree(votes[i], other, 0.35F, 0.8F, 0.8F);
            }));
        if (count > most) {
            most = count;
            seed = i;
        }
    }
    if (most < kFewestVotes) return std::nullopt;
    Candidate candidate;
    candidate.object = object;
    candidate.look = m_rows[static_cast<std::size_t>(pairs[seed].row)].look;
    float count = 0.0F, sine = 0.0F, cosine = 0.0F;
    for (std::size_t i = 0; i < votes.size(); ++i) {
        if (!agree(votes[seed], votes[i], 0.6F, 1.2F, 0.5F)) continue;
        candidate.pairs.push_back(pairs[i]);
        candidate.weight += 1.05 - static_cast<double>(pairs[i].ratio);
        if (!agree(votes[seed], votes[i], 0.35F, 0.8F, 0.8F)) continue;
        count += 1.0F;
        candidate.where.centre += votes[i].centre;
        candidate.where.logExtent += votes[i].logExtent;
        sine += std::sin(votes[i].angle);
        cosine += std::cos(votes[i].angle);
    }
    candidate.where.centre *= 1.0F / count;
    candidate.where.logExtent /= count;
    candidate.where.angle = std::atan2(sine, cosine);
    candidate.logScale =
        candidate.where.logExtent - std::log2(m_looks[static_cast<std::size_t>(candidate.look)].extent);
    return candidate;
}

/// The look's picture of the plane, turned and grown as the votes say.
cv::Matx33d ObjectMatcher::placed(const Candidate& candidate) const {
    const Look& look = m_looks[static_cast<std::size_t>(candidate.look)];
    double scale = std::exp2(static_cast<double>(candidate.logScale));
    double c = scale * std::cos(candidate.where.angle), s = scale * std::sin(candidate.where.angle);
    cv::Matx33d from(1, 0, -look.centre.x, 0, 1, -look.centre.y, 0, 0, 1);
    cv::Matx33d to(c, -s, candidate.where.centre.x, s, c, candidate.where.centre.y, 0, 0, 1);
    return to * from * look.planeToPicture;
}

/// With a foretold place a match needs no ratio test: each keypoint near a row's place that is about as large
/// and as turned as it should be, and alike enough.
std::vector<ObjectMatcher::Pair> ObjectMatcher::guided(const Candidate& candidate,
                                                       const cv::Matx33d& planeToFrame, double reach,
                                                       const Features& frame, const FrameGrid& grid) const {
    const Object& object = m_objects[static_cast<std::size_t>(candidate.object)];
    auto radius = static_cast<float>(reach);
    float turn = candidate.where.angle * static_cast<float>(180.0 / kPi);
    float extent = std::exp2(candidate.where.logExtent);
    struct Nearest {
        int row = -1, distance = 0;
    };
    std::map<int, Nearest> best;
    for (int number = object.firstRow; number < object.firstRow + object.rowCount; ++number) {
        const Row& row = m_rows[static_cast<std::size_t>(number)];
        cv::Point2f at = mapped(planeToFrame, cv::Point2d(row.onPlane));
        float size = row.size * extent / m_looks[static_cast<std::size_t>(row.look)].extent;
        grid.near(at, radius, [&](int query) {
            const cv::KeyPoint& seen = frame.keypoints[static_cast<std::size_t>(query)];
            cv::Point2f off = seen.pt - at;
            if (off.dot(off) > radius * radius || seen.size > 1.8F * size || size > 1.8F * seen.size) return;
            float angle = std::abs(std::remainder(seen.angle - row.angle - turn, 360.0F));
            if (angle > 40.0F) return;
            int distance = m_index.distance(frame.descriptors.ptr(query), number);
            if (distance >= m_likeEnough) return;
            Nearest& nearest = best[query];
            if (nearest.row < 0 || distance < nearest.distance) nearest = {number, distance};
        });
    }
    std::vector<Pair> pairs;
    for (const auto& [query, nearest] : best)
        if (nearest.row >= 0) pairs.push_back({query, nearest.row, static_cast<float>(nearest.distance)});
    return pairs;
}

ObjectMatcher::Fit ObjectMatcher::fitAt(const cv::Matx33d& planeToFrame, const std::vector<Pair>& pairs,
                                        const Features& frame, double reach) const {
    Fit fit{planeToFrame, {}};
    for (const Pair& pair : pairs) {
        cv::Point2d at =
            mapped(planeToFrame, cv::Point2d(m_rows[static_cast<std::size_t>(pair.row)].onPlane));
        cv::Point2d seen(frame.keypoints[static_cast<std::size_t>(pair.query)].pt);
        if (cv::norm(at - seen) < reach) fit.inliers.push_back(pair);
    }
    return fit;
}

std::vector<ObjectMatcher::Fit> ObjectMatcher::fitted(const Candidate& candidate, const cv::Mat& grey,
                                                      const Features& frame, const FrameGrid& grid) const {
    // Pixels of a picture 640 wide, whatever the camera gives.
    double reach = m_options.reprojectionPx * std::max(grey.cols, grey.rows) / 640.0;
    double extent = std::exp2(static_cast<double>(candidate.where.logExtent));
    auto points = [&](const std::vector<Pair>& pairs, const cv::Matx33d* through) {
        std::pair<std::vector<cv::Point2f>, std::vector<cv::Point2f>> both;
        for (const Pair& pair : pairs) {
            cv::Point2d plane(m_rows[static_cast<std::size_t>(pair.row)].onPlane);
            both.first.push_back(through != nullptr ? mapped(*through, plane) : plane);
            both.second.push_back(frame.keypoints[static_cast<std::size_t>(pair.query)].pt);
        }
        return both;
    };
    // What the votes foretell is corrected by an affinity, which few matches determine well.
    cv::Matx33d place = placed(candidate);
    std::vector<Pair> pairs = guided(candidate, place, std::max(2.0 * reach, 0.15 * extent), frame, grid);
    for (double within : {2.0, 1.0}) {
        if (pairs.size() < 4) return {};
        auto [foretold, seen] = points(pairs, &place);
        cv::Mat affinity =
            cv::estimateAffine2D(foretold, seen, cv::noArray(), cv::RANSAC, within * reach, 500);
        if (affinity.empty()) return {};
        const auto* a = affinity.ptr<double>();
        place = cv::Matx33d(a[0], a[1], a[2], a[3], a[4], a[5], 0, 0, 1) * place;
        pairs = guided(candidate, place, 2.5 * reach, frame, grid);
    }
    std::vector<Fit> fits{fitAt(place, pairs, frame, reach)};
    if (pairs.size() < 8) return fits;
    auto [plane, seen] = points(pairs, nullptr);
    cv::Mat estimate =
        cv::findHomography(plane, seen, cv::USAC_MAGSAC, 0.75 * reach, cv::noArray(), 500, 0.999);
    if (estimate.empty()) return fits;
    cv::Matx33d full(estimate);
    fits.push_back(fitAt(full, guided(candidate, full, 1.5 * reach, frame, grid), frame, reach));
    return fits;
}

FitEvidence ObjectMatcher::geometryOf(const Candidate& candidate, const Fit& fit, const cv::Mat& grey,
                                      const Features& frame) const {
    const Object& object = m_objects[static_cast<std::size_t>(candidate.object)];
    FitEvidence evidence;
    evidence.inliers = static_cast<int>(fit.inliers.size());
    evidence.strain = strainOf(fit.planeToFrame, grey.size());
    std::vector<cv::Point2f> places;
    for (const Pair& pair : fit.inliers) places.push_back(m_rows[static_cast<std::size_t>(pair.row)].onPlane);
    evidence.spread = hullShare(places, object.planeSize);
    double reach = 1.5 * m_options.reprojectionPx * std::max(grey.cols, grey.rows) / 640.0;
    for (const Pair& pair : candidate.pairs) {
        cv::Point2d at =
            mapped(fit.planeToFrame, cv::Point2d(m_rows[static_cast<std::size_t>(pair.row)].onPlane));
        if (cv::norm(at - cv::Point2d(frame.keypoints[static_cast<std::size_t>(pair.query)].pt)) > reach)
            continue;
        ++evidence.unguided;
        evidence.uniqueness += 1.0 - static_cast<double>(pair.ratio);
    }
    const cv::Rect2d plane(0, 0, object.planeSize.x, object.planeSize.y);
    cv::Matx33d frameToPlane = fit.planeToFrame.inv();
    for (const cv::KeyPoint& point : frame.keypoints)
        if (plane.contains(mapped(frameToPlane, cv::Point2d(point.pt)))) ++evidence.seen;
    return evidence;
}

ObjectMatcher::Judged ObjectMatcher::judged(const Candidate& candidate, const Fit& fit, const cv::Mat& grey,
                                            const Features& frame) const {
    const Object& object = m_objects[static_cast<std::size_t>(candidate.object)];
    Judged judged;
    Plane shape{object.planeSize.x, object.planeSize.y};
    auto corners = mapped(fit.planeToFrame, shape.corners());
    judged.quad = quadFrom(corners);
    judged.value = static_cast<double>(fit.inliers.size());
    judged.reason = insaneQuad(corners, grey.size());
    if (judged.reason == nullptr && static_cast<int>(fit.inliers.size()) < m_options.minInliers)
        judged.reason = "few_inliers";
    if (judged.reason != nullptr) return judged;
    judged.evidence = geometryOf(candidate, fit, grey, frame);
    // The grey values cost most, and where even perfect ones would not suffice they need no look.
    judged.evidence.correlation = 1.0;
    judged.odds = logOdds(judged.evidence);
    if (judged.odds < m_options.minLogOdds || judged.evidence.unguided < m_options.minMatches) {
        judged.reason = "few_inliers";
        judged.value = judged.evidence.unguided;
        return judged;
    }
    judged.evidence.correlation = judged.value =
        patchCorrelation(object.patch, object.planeSize, grey, fit.planeToFrame);
    judged.odds = logOdds(judged.evidence);
    if (judged.odds < m_options.minLogOdds) judged.reason = "low_patch_correlation";
    return judged;
}

/// Could it be believed if everything else spoke for it?
bool ObjectMatcher::worthFitting(const Candidate& candidate) const {
    FitEvidence best;
    best.inliers = best.seen = best.unguided = static_cast<int>(candidate.pairs.size());
    for (const Pair& pair : candidate.pairs) best.uniqueness += 1.0 - static_cast<double>(pair.ratio);
    best.spread = best.correlation = 1.0;
    return logOdds(best) >= m_options.minLogOdds;
}

bool ObjectMatcher::verify(const Candidate& candidate, const cv::Mat& grey, const Features& frame,
                           const FrameGrid& grid, DetectorResult& result,
                           std::vector<ObjectTrial>* trials) const {
    const Object& object = m_objects[static_cast<std::size_t>(candidate.object)];
    Judged best;
    best.reason = "no_homography";
    best.value = static_cast<double>(candidate.pairs.size());
    auto reject = [&](const Judged& judged) {
        result.rejections.push_back(
            {"landmarks", object.entry->kind, object.entry->id, judged.quad, judged.reason, judged.value});
        return false;
    };
    if (!worthFitting(candidate)) return reject(best);
    try {
        bool first = true;
        for (const Fit& fit : fitted(candidate, grey, frame, grid)) {
            Judged one = judged(candidate, fit, grey, frame);
            if (first || one.odds > best.odds) best = one;
            first = false;
        }
    } catch (const cv::Exception&) { // all points on one line, for example
    }
    if (trials != nullptr && best.evidence.inliers > 0)
        trials->push_back({object.entry->id, best.quad, best.evidence});
    if (best.reason == nullptr)
        for (const Detection& known : result.detections)
            if (known.templateId == object.entry->id && liesAcross(best.quad, known.quad))
                best.reason = "lies_across_itself";
    if (best.reason != nullptr) return reject(best);
    Detection detection;
    detection.kind = object.entry->kind;
    detection.templateId = object.entry->id;
    detection.quad = best.quad;
    detection.image = {grey.cols, grey.rows};
    detection.inliers = best.evidence.inliers;
    detection.strength = std::max(0.0, best.odds);
    detection.score = std::clamp(
        0.5 * detection.inliers / (detection.inliers + 8.0) + 0.5 * best.evidence.correlation, 0.0, 1.0);
    result.detections.push_back(std::move(detection));
    return true;
}

std::vector<ObjectMatcher::Candidate> ObjectMatcher::candidates(const Features& frame) const {
    std::vector<Candidate> found;
    auto pairs = pairsByObject(frame);
    for (std::size_t object = 0; object < pairs.size(); ++object) {
        std::vector<Pair> left = std::move(pairs[object]);
        for (int nth = 0; nth < kMostOfOneObject && left.size() >= kFewestVotes; ++nth) {
            auto candidate = largestCluster(static_cast<int>(object), left, frame);
            if (!candidate) break;
            std::erase_if(left, [&](const Pair& pair) {
                return std::any_of(candidate->pairs.begin(), candidate->pairs.end(),
                                   [&](const Pair& used) { return used.query == pair.query; });
            });
            found.push_back(std::move(*candidate));
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Candidate& a, const Candidate& b) { return a.weight > b.weight; });
    if (found.size() > kMostCandidates) found.resize(kMostCandidates);
    return found;
}

DetectorResult ObjectMatcher::match(const cv::Mat& grey, const Features& seen,
                                    std::vector<ObjectTrial>* trials) const {
    DetectorResult result;
    if (empty() || seen.keypoints.empty()) return result;
    Features frame{seen.keypoints, comparable(m_extractor, seen.descriptors)};
    FrameGrid grid(frame, grey.size());
    for (const Candidate& candidate : candidates(frame)) {
        // What lies inside an object already found is not found once more.
        bool taken =
            std::any_of(result.detections.begin(), result.detections.end(), [&](const Detection& known) {
                return cv::pointPolygonTest(borderOf(known.quad), candidate.where.centre, false) >= 0.0;
            });
        if (!taken) verify(candidate, grey, frame, grid, result, trials);
    }
    std::stable_sort(result.detections.begin(), result.detections.end(),
                     [](const Detection& a, const Detection& b) { return a.score > b.score; });
    return result;
}

} // namespace farol::recognition
