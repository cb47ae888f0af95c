#include "core/building/checks.h"

#include "core/base/text.h"
#include "core/building/geometry_checks.h"
#include "core/building/sayable.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace farol::building {

namespace {

using Findings = std::vector<Finding>;

bool sameLevel(double a, double b) {
    return std::abs(a - b) < 1e-6;
}

/// What makes a ring no outline, as it is said of an outline and of a hole in one.
struct RingFaults {
    Sentence corners, numbers, area, crosses;
};
constexpr RingFaults kOutline{Sentence::OutlineCorners, Sentence::OutlineNumbers, Sentence::OutlineArea,
                              Sentence::OutlineCrosses};
constexpr RingFaults kHole{Sentence::HoleCorners, Sentence::HoleNumbers, Sentence::HoleArea,
                           Sentence::HoleCrosses};

std::optional<Sentence> ringFault(const Ring& ring, const RingFaults& faults) {
    if (ring.size() < 3) return faults.corners;
    if (!std::all_of(ring.begin(), ring.end(), isFinite)) return faults.numbers;
    if (std::abs(signedArea(ring)) < 1e-6) return faults.area;
    if (ring.size() > 200) // the pairs below would take long
        return crossesItself({ring, {}}) ? std::optional(faults.crosses) : std::nullopt;
    for (std::size_t i = 0; i < ring.size(); ++i)
        for (std::size_t j = i + 2; j < ring.size(); ++j)
            if (segmentsCross(ring[i], ring[i + 1], ring[j], ring[(j + 1) % ring.size()]))
                return faults.crosses;
    return std::nullopt;
}

std::optional<Sentence> polygonFault(const Polygon& polygon) {
    if (auto fault = ringFault(polygon.outer, kOutline)) return fault;
    for (const Ring& hole : polygon.holes) {
        if (auto fault = ringFault(hole, kHole)) return fault;
        Polygon outer{polygon.outer, {}};
        if (!std::all_of(hole.begin(), hole.end(), [&](Point2 p) { return contains(outer, p); }))
            return Sentence::HoleOutside;
    }
    return std::nullopt;
}

template <class Items>
void checkUnique(const Items& items, const std::string& layer, const std::string& word, Findings& findings) {
    std::map<std::string, std::size_t> counts;
    for (const auto& item : items) ++counts[item.id.value];
    for (const auto& [id, count] : counts) {
        if (id.empty()) {
            findings.push_back(
                {Severity::Error, word + "-id-unique", counted(Sentence::IdMissing, count), layer, {}});
        } else if (count > 1) {
            findings.push_back(
                {Severity::Error, word + "-id-unique", counted(Sentence::IdShared, count, id), layer, {id}});
        }
    }
}

void checkRegions(const Building& building, Findings& findings) {
    std::vector<std::string> unnamed, unsayable;
    std::string example;
    for (const Region& region : building.regions()) {
        if (auto fault = polygonFault(region.polygon))
            findings.push_back({Severity::Error,
                                "region-polygon-valid",
                                said(*fault, region.id.value),
                                "regions",
                                {region.id.value}});
        if (region.name.empty() && region.ref.empty()) unnamed.push_back(region.id.value);
        if (!region.name.empty() && !isSayable(region.name)) {
            if (unsayable.empty()) example = region.name;
            unsayable.push_back(region.id.value);
        }
    }
    if (!unnamed.empty())
        findings.push_back({Severity::Note, "region-named", counted(Sentence::RegionsUnnamed, unnamed.size()),
                            "regions", unnamed});
    if (!unsayable.empty())
        findings.push_back({Severity::Note, "region-name-sayable",
                            counted(Sentence::RegionsUnsayable, unsayable.size(), example), "regions",
                            unsayable});
}

void checkLevels(const Building& building, Findings& findings) {
    std::map<std::string, std::pair<double, std::vector<std::string>>> missing;
    for (const Region& region : building.regions()) {
        if (building.level(region.level) != nullptr) continue;
        auto& [level, ids] = missing[formatNumber(region.level)];
        level = region.level;
        ids.push_back(region.id.value);
    }
    for (const auto& [text, used] : missing)
        findings.push_back({Severity::Warning, "level-listed",
                            counted(Sentence::LevelUnlisted, used.second.size(), used.first), "levels",
                            used.second});
}

/// How far the access lies from a region it names, on the region's level.
bool touches(const Access& access, const Region& region) {
    if (access.line.empty() || region.polygon.outer.size() < 3) return true; // told by other rules
    return distanceToPolygon(region.polygon, access.midpoint()) <= 1.0;
}

void checkAccess(const Building& building, const Access& access, Findings& findings) {
    const std::string& id = access.id.value;
    std::vector<std::string> ids{id};
    bool complete = true;
    for (const RegionId* side : {&access.regionA, &access.regionB}) {
        complete = complete && !side->empty();
        const Region* region = building.region(*side);
        if (side->empty()) continue;
        if (region == nullptr)
            findings.push_back({Severity::Error, "access-regions-exist",
                                said(Sentence::AccessRegionMissing, id, side->value), "accesses", ids});
        else if (!touches(access, *region))
            findings.push_back({Severity::Warning, "access-touches-regions",
                                said(Sentence::AccessFarFromRegion, id, side->value), "accesses", ids});
    }
    if (!complete || access.regionA == access.regionB)
        findings.push_back(
            {Severity::Warning, "access-joins-two-regions",
             said(access.regionA == access.regionB && !access.regionA.empty() ? Sentence::AccessSameSides
                                                                              : Sentence::AccessJoinsNone,
                  id),
             "accesses", ids});
    const Region* a = building.region(access.regionA);
    const Region* b = building.region(access.regionB);
    if (a != nullptr && b != nullptr && !access.changesLevel() && access.kind != AccessKind::Ramp &&
        !sameLevel(a->level, b->level))
        findings.push_back({Severity::Error, "access-level-change",
                            said(Sentence::AccessChangesLevel, id, a->level, b->level), "accesses", ids});
}

void checkLandmarks(const Building& building, Findings& findings) {
    for (const Landmark& landmark : building.landmarks()) {
        const std::string& id = landmark.id.value;
        std::vector<std::string> ids{id};
        const Region* region = building.region(landmark.region);
        if (region == nullptr) {
            findings.push_back({Severity::Error, "landmark-region-exists",
                                landmark.region.empty()
                                    ? said(Sentence::LandmarkNoRegion, id)
                                    : said(Sentence::LandmarkRegionMissing, id, landmark.region.value),
                                "landmarks", ids});
        } else if (!sameLevel(region->level, landmark.level)) {
            findings.push_back(
                {Severity::Warning, "landmark-inside-region",
                 said(Sentence::LandmarkOtherLevel, id, landmark.level, region->id.value, region->level),
                 "landmarks", ids});
        } else if (region->polygon.outer.size() >= 3 &&
                   distanceToPolygon(region->polygon, landmark.position) > 0.5) {
            findings.push_back({Severity::Warning, "landmark-inside-region",
                                said(Sentence::LandmarkOutside, id, region->id.value), "landmarks", ids});
        }
    }
}

template <class Items, class KindType>
void checkKinds(const Items& items, KindType other, const std::string& layer, Argument::Is known,
                Findings& findings) {
    Sentence sentence =
        known == Argument::Is::AccessKinds ? Sentence::AccessKindUnknown : Sentence::KindUnknown;
    std::map<std::string, std::vector<std::string>> unknown;
    for (const auto& item : items)
        if (item.kind == other && !item.kindText.empty()) unknown[item.kindText].push_back(item.id.value);
    for (const auto& [kind, ids] : unknown)
        findings.push_back(
            {Severity::Warning, "kind-known", counted(sentence, ids.size(), kind, known), layer, ids});
}

void checkConnected(const Building& building, Findings& findings) {
    auto parts = components(building);
    if (parts.size() < 2) return;
    std::vector<std::string> apart;
    for (std::size_t i = 1; i < parts.size(); ++i)
        for (std::size_t region : parts[i]) apart.push_back(building.regions()[region].id.value);
    findings.push_back({Severity::Warning, "regions-connected",
                        counted(Sentence::BuildingInParts, apart.size(), static_cast<double>(parts.size()),
                                counted(Sentence::CountedRegions, parts.front().size())),
                        "regions", apart});
}

} // namespace

std::string severityName(Severity severity) {
    return severity == Severity::Error ? "error" : severity == Severity::Warning ? "warning" : "note";
}

std::vector<Finding> checkBuilding(const Building& building) {
    Findings findings;
    checkUnique(building.regions(), "regions", "region", findings);
    checkUnique(building.accesses(), "accesses", "access", findings);
    checkUnique(building.landmarks(), "landmarks", "landmark", findings);
    checkRegions(building, findings);
    checkOutlines(building, findings);
    checkTables(building, findings);
    checkLevels(building, findings);
    for (const Access& access : building.accesses()) checkAccess(building, access, findings);
    checkLandmarks(building, findings);
    checkKinds(building.regions(), RegionKind::Other, "regions", Argument::Is::RegionKinds, findings);
    checkKinds(building.accesses(), AccessKind::Other, "accesses", Argument::Is::AccessKinds, findings);
    checkKinds(building.landmarks(), Kind::Other, "landmarks", Argument::Is::LandmarkKinds, findings);
    checkConnected(building, findings);
    std::stable_sort(findings.begin(), findings.end(),
                     [](const Finding& a, const Finding& b) { return a.severity < b.severity; });
    return findings;
}

std::vector<std::vector<std::size_t>> components(const Building& building) {
    std::vector<std::vector<std::size_t>> parts;
    std::vector<bool> seen(building.regions().size(), false);
    for (std::size_t start = 0; start < seen.size(); ++start) {
        if (seen[start]) continue;
        std::vector<std::size_t> part{start};
        seen[start] = true;
        for (std::size_t next = 0; next < part.size(); ++next) {
            for (std::size_t neighbour : building.neighboursOf(part[next])) {
                if (seen[neighbour]) continue;
                seen[neighbour] = true;
                part.push_back(neighbour);
            }
        }
        std::sort(part.begin(), part.end());
        parts.push_back(std::move(part));
    }
    std::stable_sort(parts.begin(), parts.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    return parts;
}

} // namespace farol::building
