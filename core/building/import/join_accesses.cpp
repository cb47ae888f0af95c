#include "core/building/import/finishing.h"
#include "core/building/level_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace farol::building {

namespace {

/// Door drawn on a shared border, beside it, or in the middle of a thick wall; tried in this order.
constexpr std::array<double, 3> kReachesM{0.3, 0.6, 1.0};
/// A region must hold this part of the strip beside the door to be what one steps into.
constexpr double kLeastShare = 0.2;
/// A second candidate with this part of the best one's share makes the answer a guess.
constexpr double kRivalShare = 0.7;
/// As near as this a door is drawn on a region.
constexpr double kOnBorderM = 0.1;
constexpr int kAlong = 5, kAcross = 6;

struct Candidate {
    std::size_t region = 0;
    double left = 0.0, right = 0.0;
};

struct Joined {
    std::size_t left = 0, right = 0;
    bool ambiguous = false;
};

bool isLine(const Polyline& line) {
    return line.size() > 1 && farol::length(line) > 0.05;
}

/// Points at equal distances along the line, with the unit vector to the left there.
std::vector<std::pair<Point2, Point2>> stations(const Polyline& line) {
    std::vector<std::pair<Point2, Point2>> places;
    double total = farol::length(line);
    for (int k = 0; k < kAlong; ++k) {
        double remaining = total * (k + 0.5) / kAlong;
        for (std::size_t i = 1; i < line.size(); ++i) {
            double step = distance(line[i - 1], line[i]);
            if (step > 0.0 && step >= remaining) {
                Point2 along = (line[i] - line[i - 1]) * (1.0 / step);
                places.emplace_back(line[i - 1] + along * remaining, Point2{-along.y, along.x});
                break;
            }
            remaining -= step;
        }
    }
    return places;
}

class AccessJoiner {
public:
    AccessJoiner(BuildingData& data, FindingList& findings)
        : m_data(data), m_findings(findings), m_index(data.regions) {}

    void run() {
        for (Access& access : m_data.accesses) {
            if (access.line.empty() || (!access.regionA.empty() && !access.regionB.empty())) continue;
            // The other side lies on another level: joinFarSides.
            if (access.changesLevel() && !(access.regionA.empty() && access.regionB.empty())) continue;
            if (access.regionA.empty() && access.regionB.empty()) tellOddOnes(access);
            std::optional<Joined> joined;
            for (double reach : kReachesM) {
                joined = isLine(access.line) ? besideLine(access, reach) : aroundPoint(access, reach);
                if (joined) break;
            }
            if (joined && access.changesLevel() && !staysOnLevel(access, *joined)) continue;
            if (joined)
                fill(access, *joined);
            else if (!access.changesLevel())
                tellUnjoined(access);
        }
    }

private:
    const RegionId& idOf(std::size_t region) const { return m_data.regions[region].id; }

    /// Stairs and lifts between two regions of one level are the way into the stairwell or car, or a few
    /// steps.
    bool staysOnLevel(const Access& access, const Joined& joined) const {
        if (shaftKind(m_data.regions[joined.left]) || shaftKind(m_data.regions[joined.right])) return true;
        return access.kind == AccessKind::Stairs && access.shaft.empty();
    }

    /// Before anything is mended: how many regions does the access lie on as it is drawn?
    void tellOddOnes(const Access& access) {
        std::size_t touched = 0;
        Polyline spots{access.line.front(), access.midpoint(), access.line.back()};
        for (std::size_t region :
             m_index.meeting(access.level, grown(*boundingBox(access.line), kOnBorderM))) {
            const Polygon& polygon = m_data.regions[region].polygon;
            touched +=
                std::any_of(spots.begin(), spots.end(),
                            [&](Point2 spot) { return distanceToPolygon(polygon, spot) <= kOnBorderM; })
                    ? 1U
                    : 0U;
        }
        if (touched >= 2) return; // more than two: told by the checks
        m_findings.add(Severity::Note, "access-touches-two-regions", Sentence::AccessesOnFewRegions,
                       "accesses", access.id.value);
    }

    bool allowed(const Access& access, std::size_t region) const {
        // One side that the source names must be one of the two.
        const RegionId& known = access.regionA.empty() ? access.regionB : access.regionA;
        return known.empty() || known == idOf(region);
    }

    std::optional<Joined> besideLine(const Access& access, double reach) const {
        auto places = stations(access.line);
        std::vector<Candidate> candidates;
        double weight = 1.0 / static_cast<double>(places.size() * kAcross);
        for (std::size_t region : m_index.meeting(access.level, grown(*boundingBox(access.line), reach))) {
            const Polygon& polygon = m_data.regions[region].polygon;
            Candidate candidate{region, 0.0, 0.0};
            for (const auto& [place, left] : places)
                for (int k = 1; k <= kAcross; ++k) {
                    Point2 step = left * (reach * k / kAcross);
                    if (contains(polygon, place + step)) candidate.left += weight;
                    if (contains(polygon, place - step)) candidate.right += weight;
                }
            if (candidate.left > 0.0 || candidate.right > 0.0) candidates.push_back(candidate);
        }
        return bestPair(access, candidates);
    }

    /// The region to the left and the other to the right with the largest shares together.
    std::optional<Joined> bestPair(const Access& access, const std::vector<Candidate>& candidates) const {
        std::optional<Joined> best;
        double most = 0.0;
        for (const Candidate& a : candidates)
            for (const Candidate& b : candidates) {
                if (a.region == b.region || a.left < kLeastShare || b.right < kLeastShare) continue;
                if (!allowed(access, a.region) && !allowed(access, b.region)) continue;
                double share = a.left + b.right;
                if (share <= most + 1e-9) continue;
                most = share;
                best = Joined{a.region, b.region, false};
            }
        if (!best) return best;
        for (const Candidate& rival : candidates) {
            if (rival.region == best->left || rival.region == best->right) continue;
            for (const Candidate& chosen : candidates) {
                bool leftRival = chosen.region == best->left && rival.left > kRivalShare * chosen.left;
                bool rightRival = chosen.region == best->right && rival.right > kRivalShare * chosen.right;
                best->ambiguous = best->ambiguous || leftRival || rightRival;
            }
        }
        return best;
    }

    /// A line between two regions, along neither border: drawn the way one walks, or a gate between two
    /// houses. Which of the two it is cannot be known, and a wrong guess leads against a wall.
    bool endsAtTwo(const Access& access) const {
        Point2 first = access.line.front(), last = access.line.back();
        double size = distance(first, last);
        if (size < kOnBorderM) return false;
        Point2 onwards = (last - first) * (kReachesM.front() / size);
        auto from = m_index.at(access.level, first - onwards), to = m_index.at(access.level, last + onwards);
        return from && to && from != to;
    }

    /// Two regions on opposite sides of the point, by the share of a disc that each holds.
    std::optional<Joined> aroundPoint(const Access& access, double reach) const {
        constexpr int kDirections = 24;
        constexpr double kPi = 3.14159265358979323846;
        Point2 at = access.midpoint();
        std::vector<std::pair<double, std::size_t>> shares;
        std::map<std::size_t, Point2> pulls;
        for (std::size_t region : m_index.meeting(access.level, grown({at, at}, reach))) {
            double share = 0.0;
            for (int d = 0; d < kDirections; ++d)
                for (int k = 1; k <= kAcross; ++k) {
                    Point2 step =
                        Point2{std::cos(2 * kPi * d / kDirections), std::sin(2 * kPi * d / kDirections)} *
                        (reach * k / kAcross);
                    if (!contains(m_data.regions[region].polygon, at + step)) continue;
                    share += 1.0 / (kDirections * kAcross);
                    pulls[region] = pulls[region] + step;
                }
            if (share > 0.08) shares.emplace_back(share, region);
        }
        std::stable_sort(shares.begin(), shares.end(),
                         [](const auto& a, const auto& b) { return a.first > b.first; });
        if (shares.size() < 2 || (!allowed(access, shares[0].second) && !allowed(access, shares[1].second)))
            return std::nullopt;
        Point2 a = pulls[shares[0].second], b = pulls[shares[1].second];
        // Both on one side: the point stands before a wall between them, it does not lead through it.
        if (length(a) > 0.0 && length(b) > 0.0 && dot(a, b) > 0.5 * length(a) * length(b))
            return std::nullopt;
        bool rival = shares.size() > 2 && shares[2].first > kRivalShare * shares[1].first;
        return Joined{shares[0].second, shares[1].second, rival};
    }

    void fill(Access& access, const Joined& joined) {
        if (joined.ambiguous && access.regionA.empty() && access.regionB.empty())
            m_findings.add(Severity::Warning, "access-ambiguous", Sentence::AccessesAmbiguous, "accesses",
                           access.id.value);
        const RegionId &left = idOf(joined.left), &right = idOf(joined.right);
        if (access.regionA.empty() && access.regionB.empty()) {
            access.regionA = left;
            access.regionB = right;
        } else if (access.regionA.empty()) {
            access.regionA = access.regionB == left ? right : left;
        } else {
            access.regionB = access.regionA == left ? right : left;
        }
    }

    void tellUnjoined(Access& access) {
        if (endsAtTwo(access))
            m_findings.add(Severity::Warning, "access-drawn-across", Sentence::AccessesAcross, "accesses",
                           access.id.value);
        // A door to nowhere: the one region it touches is told, so that the curator knows which.
        if (!access.regionA.empty() || !access.regionB.empty()) return;
        if (auto region = m_index.nearest(access.level, access.midpoint(), kReachesM.front()))
            access.regionA = idOf(*region);
    }

    BuildingData& m_data;
    FindingList& m_findings;
    LevelRegions m_index;
};

} // namespace

void joinAccesses(BuildingData& data, FindingList& findings) {
    AccessJoiner(data, findings).run();
}

void placeLandmarks(BuildingData& data, FindingList& findings) {
    LevelRegions index(data.regions);
    for (Landmark& landmark : data.landmarks) {
        if (!landmark.region.empty()) continue;
        if (auto region = index.nearest(landmark.level, landmark.position, 0.5)) {
            landmark.region = data.regions[*region].id;
        } else if ((region = index.nearest(landmark.level, landmark.position, 3.0))) {
            landmark.region = data.regions[*region].id;
            findings.add(Severity::Note, "landmark-placed", Sentence::LandmarksGivenRegion, "landmarks",
                         landmark.id.value);
        }
    }
}

} // namespace farol::building
