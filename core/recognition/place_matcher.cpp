#include "core/recognition/place_matcher.h"

#include <opencv2/calib3d.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace farol::recognition {

namespace {

constexpr int kColumns = 8, kRows = 6; // of the grid that measures how far the inliers spread
// Identical cabinets, doors and boards fit in a corner of the picture; a place fits all over it.
constexpr int kFewestCells = 5;
constexpr double kLeastSpread = 0.035;
constexpr double kLeastStrength = 9.0;
constexpr double kRivalShare = 0.6;
/// Places beyond the candidates that are looked at as well once one is told: which others does it fit?
constexpr std::size_t kMoreRivals = 7;
constexpr int kFewestAlike = 8;     // inliers
constexpr double kAlikeShare = 0.4; // of the told place's strength; weaker ones are chance

float angleBetween(float a, float b) {
    float difference = std::fmod(a - b + 540.0F, 360.0F);
    if (difference < 0.0F) difference += 360.0F;
    return difference - 180.0F;
}

/// Each row of the view once, with its best query.
std::vector<RowMatch> oneToOne(std::vector<RowMatch> matches) {
    std::map<int, RowMatch> best;
    for (const RowMatch& match : matches) {
        auto [at, fresh] = best.emplace(match.row, match);
        if (!fresh && match.ratio < at->second.ratio) at->second = match;
    }
    matches.clear();
    for (const auto& [row, match] : best) matches.push_back(match);
    std::stable_sort(matches.begin(), matches.end(),
                     [](const RowMatch& a, const RowMatch& b) { return a.ratio < b.ratio; });
    return matches;
}

/// A camera that a person wears rolls as a whole: true matches turn by the same angle and grow within bounds,
/// chance ones by any. This alone removes nine of ten chance matches.
std::vector<RowMatch> sameRoll(const std::vector<RowMatch>& matches, const Features& frame,
                               const Features& view) {
    constexpr float kReach = 20.0F; // degrees
    auto turn = [&](const RowMatch& m) {
        return angleBetween(frame.keypoints[static_cast<std::size_t>(m.query)].angle,
                            view.keypoints[static_cast<std::size_t>(m.row)].angle);
    };
    auto growth = [&](const RowMatch& m) {
        return std::log2(frame.keypoints[static_cast<std::size_t>(m.query)].size /
                         view.keypoints[static_cast<std::size_t>(m.row)].size);
    };
    // Nobody walks with the camera on its side: rolls beyond 45 degrees are not tried.
    float bestRoll = 0.0F;
    std::ptrdiff_t most = -1;
    for (int roll = -45; roll <= 45; roll += 5) {
        auto r = static_cast<float>(roll);
        auto count = std::count_if(matches.begin(), matches.end(), [&](const RowMatch& m) {
            return std::abs(angleBetween(turn(m), r)) < kReach;
        });
        if (count > most || (count == most && std::abs(r) < std::abs(bestRoll))) {
            most = count;
            bestRoll = r;
        }
    }
    std::vector<RowMatch> kept;
    std::copy_if(matches.begin(), matches.end(), std::back_inserter(kept), [&](const RowMatch& m) {
        return std::abs(angleBetween(turn(m), bestRoll)) < kReach && std::abs(growth(m)) < 1.6F;
    });
    return kept;
}

int occupiedCells(const std::vector<cv::Point2f>& points, ImageSize size) {
    std::set<int> cells;
    for (const cv::Point2f& p : points) {
        int x =
            std::clamp(static_cast<int>(p.x * kColumns / static_cast<float>(size.width)), 0, kColumns - 1);
        int y = std::clamp(static_cast<int>(p.y * kRows / static_cast<float>(size.height)), 0, kRows - 1);
        cells.insert(y * kColumns + x);
    }
    return static_cast<int>(cells.size());
}

/// Without the outer eighth on each side, so that a few chance matches do not widen a cluster.
double spreadOf(const std::vector<cv::Point2f>& points, ImageSize size) {
    if (points.empty()) return 0.0;
    std::vector<float> x, y;
    for (const cv::Point2f& p : points) {
        x.push_back(p.x);
        y.push_back(p.y);
    }
    std::sort(x.begin(), x.end());
    std::sort(y.begin(), y.end());
    std::size_t low = points.size() / 8;
    std::size_t high = points.size() - 1 - low;
    return static_cast<double>(x[high] - x[low]) / size.width * (y[high] - y[low]) / size.height;
}

} // namespace

double PlaceSupport::strength() const {
    return std::sqrt(static_cast<double>(inliers) * cells);
}

PlaceMatcher::PlaceMatcher(const LandmarkLibrary& library, const RecogniserOptions& options)
    : m_options(options), m_extractor(library.extractor.name) {
    std::vector<cv::Mat> descriptors;
    for (const Template& entry : library.templates)
        if (entry.kind == Kind::Place) add(entry, descriptors);
    if (descriptors.empty()) return;
    cv::Mat all;
    cv::vconcat(descriptors, all);
    m_index.add(all);
}

PlaceMatcher::PlaceMatcher(const PlaceMatcher& before, const LandmarkLibrary& library)
    : PlaceMatcher(before) {
    std::map<std::string, const Template*> wanted, kept;
    for (const Template& entry : library.templates)
        if (entry.kind == Kind::Place) wanted.emplace(entry.id.value, &entry);
    for (PlaceView& one : m_views) {
        if (one.entry == nullptr) continue;
        auto found = wanted.find(one.entry->id.value);
        if (found != wanted.end() && sameLook(*one.entry, *found->second)) {
            auto ordinal = static_cast<std::size_t>(one.view - one.entry->views.data());
            one.view = &found->second->views[ordinal];
            one.entry = found->second;
            kept.insert(*found);
        } else {
            m_index.remove(one.firstRow, one.descriptors.rows);
            one = {};
        }
    }
    std::vector<cv::Mat> descriptors;
    for (const Template& entry : library.templates)
        if (entry.kind == Kind::Place && kept.count(entry.id.value) == 0) add(entry, descriptors);
    if (descriptors.empty()) return;
    cv::Mat all;
    cv::vconcat(descriptors, all);
    m_index.add(all);
}

void PlaceMatcher::add(const Template& entry, std::vector<cv::Mat>& descriptors) {
    for (const View& view : entry.views) {
        if (view.features.descriptors.rows == 0) continue;
        auto firstRow = static_cast<int>(m_viewOfRow.size());
        m_viewOfRow.insert(m_viewOfRow.end(), static_cast<std::size_t>(view.features.descriptors.rows),
                           static_cast<int>(m_views.size()));
        m_views.push_back({&entry, &view, comparable(m_extractor, view.features.descriptors), firstRow});
        descriptors.push_back(m_views.back().descriptors);
    }
}

std::vector<int> PlaceMatcher::candidates(const Features& frame, std::size_t most) const {
    Neighbours near = m_index.search(comparable(m_extractor, frame.descriptors), m_options.neighbours,
                                     m_options.searchChecks);
    std::vector<double> votes(m_views.size(), 0.0);
    for (int query = 0; query < frame.descriptors.rows; ++query) {
        std::size_t first = static_cast<std::size_t>(query) * static_cast<std::size_t>(near.each);
        std::size_t last = first;
        while (last + 1 < first + static_cast<std::size_t>(near.each) && near.rows[last + 1] >= 0) ++last;
        // The farthest of them says how far chance alone would be; neighbouring places share what they see,
        // so a ratio to the next place would silence exactly the best points.
        float noise = std::max(near.distances[last], 1.0F);
        std::set<int> voted;
        for (std::size_t i = first; i < last; ++i) {
            int view = m_viewOfRow[static_cast<std::size_t>(near.rows[i])];
            if (voted.insert(view).second)
                votes[static_cast<std::size_t>(view)] += 1.0 - near.distances[i] / noise;
        }
    }
    std::vector<int> order(m_views.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return votes[static_cast<std::size_t>(a)] > votes[static_cast<std::size_t>(b)];
    });
    order.resize(std::min(order.size(), most));
    return order;
}

PlaceSupport PlaceMatcher::verified(ImageSize frameSize, const Features& frame, int view) const {
    const View& trained = *m_views[static_cast<std::size_t>(view)].view;
    PlaceSupport support;
    support.view = view;
    auto matches = sameRoll(
        oneToOne(ratioMatches(comparable(m_extractor, frame.descriptors),
                              m_views[static_cast<std::size_t>(view)].descriptors, m_options.placeRatio)),
        frame, trained.features);
    support.matches = static_cast<int>(matches.size());
    if (matches.size() < 8) return support;
    std::vector<cv::Point2f> here, there;
    for (const RowMatch& m : matches) {
        here.push_back(frame.keypoints[static_cast<std::size_t>(m.query)].pt);
        there.push_back(trained.features.keypoints[static_cast<std::size_t>(m.row)].pt);
    }
    // Pixels of a picture 640 wide, whatever the camera gives.
    double reach = m_options.reprojectionPx / 2.0 * std::max(frameSize.width, frameSize.height) / 640.0;
    cv::Mat mask;
    try {
        cv::findFundamentalMat(there, here, cv::USAC_MAGSAC, reach, 0.999, 1000, mask);
    } catch (const cv::Exception&) { // degenerate points
        return support;
    }
    std::vector<cv::Point2f> inliers;
    for (int i = 0; i < static_cast<int>(mask.total()); ++i) {
        if (mask.at<unsigned char>(i) == 0) continue;
        inliers.push_back(here[static_cast<std::size_t>(i)]);
    }
    support.inliers = static_cast<int>(inliers.size());
    support.cells = occupiedCells(inliers, frameSize);
    support.spread = spreadOf(inliers, frameSize);
    return support;
}

std::vector<PlaceSupport> PlaceMatcher::ranked(ImageSize frameSize, const Features& frame,
                                               std::span<const int> views) const {
    std::vector<PlaceSupport> supports;
    for (int view : views) supports.push_back(verified(frameSize, frame, view));
    std::stable_sort(supports.begin(), supports.end(), [](const PlaceSupport& a, const PlaceSupport& b) {
        return a.strength() > b.strength();
    });
    return supports;
}

bool PlaceMatcher::sameSpot(int a, int b) const {
    if (a == b || &placeOf(a) == &placeOf(b)) return true;
    const View& view = *m_views[static_cast<std::size_t>(a)].view;
    PlaceSupport support = verified(view.size, view.features, b);
    return support.inliers >= m_options.minPlaceInliers && support.strength() >= m_options.minPlaceInliers;
}

/// Each other place once, with its best view. Whether it is a neighbour or a look-alike elsewhere only the
/// map knows.
void PlaceMatcher::addLookAlikes(Detection& told, const std::vector<PlaceSupport>& fits) const {
    std::map<TemplateId, double> strongest;
    for (const PlaceSupport& support : fits) {
        const TemplateId& id = placeOf(support.view).id;
        bool alike = support.inliers >= kFewestAlike && support.strength() >= kAlikeShare * told.strength;
        if (alike && id != told.templateId) strongest[id] = std::max(strongest[id], support.strength());
    }
    for (const auto& [id, strength] : strongest) told.lookAlikes.push_back({id, strength});
    std::stable_sort(told.lookAlikes.begin(), told.lookAlikes.end(),
                     [](const LookAlike& a, const LookAlike& b) { return a.strength > b.strength; });
}

DetectorResult PlaceMatcher::match(ImageSize frameSize, const Features& frame) const {
    DetectorResult result;
    if (empty() || frame.descriptors.rows < 8) return result;
    auto asked = static_cast<std::size_t>(m_options.placeCandidates);
    std::vector<int> order = candidates(frame, asked + kMoreRivals);
    std::span<const int> views = order;
    std::vector<PlaceSupport> fits = ranked(frameSize, frame, views.first(std::min(asked, views.size())));
    if (fits.empty()) return result;
    Quad whole =
        quadOf({0.0, 0.0, static_cast<double>(frameSize.width), static_cast<double>(frameSize.height)});
    const PlaceSupport best = fits.front();
    auto reject = [&](const PlaceSupport& support, const char* reason, double value) {
        result.rejections.push_back(
            {"landmarks", Kind::Place, placeOf(support.view).id, whole, reason, value});
    };
    if (best.inliers < m_options.minPlaceInliers) {
        reject(best, "few_inliers", best.inliers);
        return result;
    }
    if (best.cells < kFewestCells || best.spread < kLeastSpread || best.strength() < kLeastStrength) {
        reject(best, "narrow_support", best.spread);
        return result;
    }
    for (std::size_t i = 1; i < fits.size(); ++i) {
        const PlaceSupport& rival = fits[i];
        if (rival.strength() < kRivalShare * best.strength()) break;
        if (sameSpot(best.view, rival.view)) continue;
        reject(best, "ambiguous_place", rival.strength() / best.strength());
        reject(rival, "ambiguous_place", 1.0);
        return result;
    }
    Detection detection;
    detection.kind = Kind::Place;
    detection.templateId = placeOf(best.view).id;
    detection.quad = whole;
    detection.image = frameSize;
    detection.inliers = best.inliers;
    // The support itself, not its lead: a neighbouring place that fits as well is no reason to doubt the
    // spot.
    detection.score = best.strength() / (best.strength() + kLeastStrength);
    detection.strength = best.strength();
    for (int view : views.subspan(std::min(asked, views.size())))
        fits.push_back(verified(frameSize, frame, view));
    addLookAlikes(detection, fits);
    result.detections.push_back(std::move(detection));
    return result;
}

} // namespace farol::recognition
