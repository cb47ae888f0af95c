#include "core/base/text.h"
#include "core/building/import/finishing.h"
#include "core/building/level_regions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>

namespace farol::building {

namespace {

/// The two ends of one flight are drawn this near to each other on their levels; a region this near is meant.
constexpr double kSameFlightM = 3.0, kReachM = 1.0;

bool sameLevel(double a, double b) {
    return std::abs(a - b) < 1e-6;
}

class FarSides {
public:
    FarSides(RawMap& raw, FindingList& findings)
        : m_data(raw.data), m_findings(findings), m_index(raw.data.regions) {
        for (const Region& region : m_data.regions) m_levelOf.emplace(region.id.value, region.level);
        for (const RawMap::LevelChange& change : raw.levelChanges)
            m_changes.emplace(change.access.value, &change);
    }

    void run() {
        for (std::size_t i = 0; i < m_data.accesses.size(); ++i) {
            const Access& access = m_data.accesses[i];
            bool half = access.regionA.empty() || access.regionB.empty();
            if (access.changesLevel() && half && !access.line.empty() && setNearSide(i)) m_half.push_back(i);
        }
        std::vector<std::size_t> rest;
        for (std::size_t i : m_half)
            if (!byNamedLevel(i)) rest.push_back(i);
        std::map<std::string, std::vector<std::size_t>> flights;
        for (std::size_t i : rest) flights[flightOf(i)].push_back(i);
        for (auto& [name, ends] : flights) joinFlight(ends);
        direct();
        removeMerged();
    }

private:
    double levelOf(const RegionId& id) const {
        auto found = m_levelOf.find(id.value);
        return found == m_levelOf.end() ? std::nan("") : found->second;
    }
    const RegionId& nearSide(std::size_t i) const { return m_data.accesses[i].regionA; }
    double levelOf(std::size_t i) const { return levelOf(nearSide(i)); }

    std::optional<RegionId> regionAt(double level, Point2 at, double reach) const {
        std::optional<std::size_t> best;
        // A stairwell or car within reach is what stairs or a lift lead to, also where a corridor is nearer.
        for (std::size_t region : m_index.meeting(level, grown({at, at}, reach)))
            if (shaftKind(m_data.regions[region]) &&
                distanceToPolygon(m_data.regions[region].polygon, at) <= std::min(reach, kReachM))
                best = region;
        if (!best) best = m_index.nearest(level, at, reach);
        return best ? std::optional(m_data.regions[*best].id) : std::nullopt;
    }

    /// Region A becomes the known side. False when none is known, or when the missing one was found by place.
    bool setNearSide(std::size_t i) {
        Access& access = m_data.accesses[i];
        if (access.regionA.empty() && !access.regionB.empty()) {
            std::swap(access.regionA, access.regionB);
            if (access.oneWay != OneWay::No)
                access.oneWay = access.oneWay == OneWay::AToB ? OneWay::BToA : OneWay::AToB;
        }
        auto here = regionAt(access.level, access.midpoint(), kReachM);
        if (access.regionA.empty() && here) {
            access.regionA = *here;
            return true;
        }
        if (access.regionA.empty() || std::isnan(levelOf(access.regionA))) return false; // told by the checks
        if (sameLevel(levelOf(access.regionA), access.level)) return true;
        if (here) access.regionB = *here; // drawn on the other level than the side it names
        return !here;
    }

    bool byNamedLevel(std::size_t i) {
        Access& access = m_data.accesses[i];
        auto change = m_changes.find(access.id.value);
        if (change == m_changes.end() || !change->second->toLevel) return false;
        auto there = regionAt(*change->second->toLevel, access.midpoint(), kSameFlightM);
        if (!there || *there == access.regionA) return false;
        access.regionB = *there;
        return true;
    }

    /// What the ends of one flight or shaft have in common: the shaft's name, else the first end drawn there.
    std::string flightOf(std::size_t i) {
        const Access& access = m_data.accesses[i];
        std::string kind = accessKindName(access.kind) + " ";
        if (!access.shaft.empty()) return kind + access.shaft.value;
        Point2 at = access.midpoint();
        auto column = std::llround(at.x / kSameFlightM), row = std::llround(at.y / kSameFlightM);
        for (auto x = column - 1; x <= column + 1; ++x)
            for (auto y = row - 1; y <= row + 1; ++y)
                for (std::size_t first : m_firstEnds[{access.kind, x, y}])
                    if (distance(m_data.accesses[first].midpoint(), at) <= kSameFlightM)
                        return kind + "\n" + std::to_string(first);
        m_firstEnds[{access.kind, column, row}].push_back(i);
        return kind + "\n" + std::to_string(i);
    }

    void joinFlight(const std::vector<std::size_t>& ends) {
        std::map<double, std::vector<std::size_t>> byLevel;
        for (std::size_t i : ends) byLevel[levelOf(i)].push_back(i);
        std::set<std::size_t> stoodFor;
        for (auto level = byLevel.begin(); level != byLevel.end(); ++level) {
            auto above = std::next(level);
            for (std::size_t i : level->second) {
                if (above != byLevel.end() && mayJoin(i, *above)) {
                    std::size_t end = nearestOf(above->second, m_data.accesses[i].midpoint());
                    m_data.accesses[i].regionB = nearSide(end);
                    if (m_data.accesses[i].oneWay == OneWay::No) m_partner[i] = end;
                    stoodFor.insert(end);
                } else if (stoodFor.count(i) != 0) {
                    merge(i);
                } else if (level != byLevel.begin() && mayJoin(i, *std::prev(level))) {
                    const auto& below = std::prev(level)->second;
                    m_data.accesses[i].regionB = nearSide(nearestOf(below, m_data.accesses[i].midpoint()));
                } else {
                    m_findings.add(Severity::Warning, "access-far-level", Sentence::FarLevelUnknown,
                                   "accesses", m_data.accesses[i].id.value);
                }
            }
        }
    }

    /// Without a common shaft only the next floor is believed; a lift may pass one.
    bool mayJoin(std::size_t i, const std::pair<const double, std::vector<std::size_t>>& other) const {
        const Access& access = m_data.accesses[i];
        if (!access.shaft.empty() || access.kind == AccessKind::Elevator) return true;
        return std::abs(other.first - levelOf(i)) <= 1.0 + 1e-6;
    }

    std::size_t nearestOf(const std::vector<std::size_t>& ends, Point2 at) const {
        return *std::min_element(ends.begin(), ends.end(), [&](std::size_t a, std::size_t b) {
            return distance(m_data.accesses[a].midpoint(), at) < distance(m_data.accesses[b].midpoint(), at);
        });
    }

    void merge(std::size_t i) {
        m_merged.insert(i);
        m_findings.add(Severity::Note, "access-merged", Sentence::UpperEndsLeftOut, "accesses",
                       m_data.accesses[i].id.value);
    }

    /// "Up" and "down" become directions between the two regions; the upper end may be the one that tells.
    void direct() {
        auto told = [this](std::size_t i) -> std::optional<bool> {
            auto change = m_changes.find(m_data.accesses[i].id.value);
            return change == m_changes.end() ? std::nullopt : change->second->up;
        };
        for (std::size_t i = 0; i < m_data.accesses.size(); ++i) {
            Access& access = m_data.accesses[i];
            auto up = told(i);
            if (auto partner = m_partner.find(i); partner != m_partner.end() && !up) {
                const Access& end = m_data.accesses[partner->second];
                up = told(partner->second);
                // The upper end's own sides are the other way round.
                if (!up && m_merged.count(partner->second) != 0 && end.oneWay != OneWay::No)
                    up = end.oneWay == OneWay::BToA;
            }
            double a = levelOf(access.regionA), b = levelOf(access.regionB);
            if (!up || !(a != b) || std::isnan(a) || std::isnan(b)) continue;
            access.oneWay = *up == (a < b) ? OneWay::AToB : OneWay::BToA;
        }
    }

    void removeMerged() {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < m_data.accesses.size(); ++i) {
            if (m_merged.count(i) != 0) continue;
            if (kept != i) m_data.accesses[kept] = std::move(m_data.accesses[i]);
            ++kept;
        }
        m_data.accesses.resize(kept);
    }

    BuildingData& m_data;
    FindingList& m_findings;
    LevelRegions m_index;
    std::unordered_map<std::string, double> m_levelOf;
    std::unordered_map<std::string, const RawMap::LevelChange*> m_changes;
    std::vector<std::size_t> m_half;
    std::map<std::tuple<AccessKind, long long, long long>, std::vector<std::size_t>>
        m_firstEnds;                              ///< by place
    std::map<std::size_t, std::size_t> m_partner; ///< the end above that an access stands for
    std::set<std::size_t> m_merged;
};

} // namespace

std::optional<bool> climbDirection(const std::string& word) {
    static const std::set<std::string> up{"UP",     "UPWARD",  "UPWARDS", "ASCENDING", "SUBIR",
                                          "SUBIDA", "A SUBIR", "SOBE",    "ASCENDENTE"};
    static const std::set<std::string> down{"DOWN",    "DOWNWARD", "DOWNWARDS", "DESCENDING", "DESCER",
                                            "DESCIDA", "A DESCER", "DESCE",     "DESCENDENTE"};
    std::string folded = foldedForMatching(word);
    if (up.count(folded) != 0) return true;
    if (down.count(folded) != 0) return false;
    return std::nullopt;
}

void joinFarSides(RawMap& raw, FindingList& findings) {
    FarSides(raw, findings).run();
}

} // namespace farol::building
