#include "core/building/checks.h"

#include "core/base/text.h"
#include "core/building/geometry_checks.h"
#include "core/building/sayable.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace farol::building {

namespace {

using Findings = std::vector<Finding>;

std::string quoted(const std::string& id) {
    return "\"" + id + "\"";
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

bool sameLevel(double a, double b) {
    return std::abs(a - b) < 1e-6;
}

/// What makes the ring no outline, or nothing.
std::string ringFault(const Ring& ring) {
    if (ring.size() < 3) return "has fewer than three corners";
    if (!std::all_of(ring.begin(), ring.end(), isFinite)) return "has a coordinate that is no number";
    if (std::abs(signedArea(ring)) < 1e-6) return "has no area";
    if (ring.size() > 200)
        return crossesItself({ring, {}}) ? "crosses itself" : ""; // the pairs below would take long
    for (std::size_t i = 0; i < ring.size(); ++i)
        for (std::size_t j = i + 2; j < ring.size(); ++j)
            if (segmentsCross(ring[i], ring[i + 1], ring[j], ring[(j + 1) % ring.size()]))
                return "crosses itself";
    return {};
}

std::string polygonFault(const Polygon& polygon) {
    std::string fault = ringFault(polygon.outer);
    if (!fault.empty()) return fault;
    for (const Ring& hole : polygon.holes) {
        std::string inner = ringFault(hole);
        if (!inner.empty()) return "has a hole that " + inner;
        Polygon outer{polygon.outer, {}};
        if (!std::all_of(hole.begin(), hole.end(), [&](Point2 p) { return contains(outer, p); }))
            return "has a hole that lies outside it";
    }
    return {};
}

template <class Items>
void checkUnique(const Items& items, const std::string& layer, const std::string& word, Findings& findings) {
    std::map<std::string, std::size_t> counts;
    for (const auto& item : items) ++counts[item.id.value];
    for (const auto& [id, count] : counts) {
        if (id.empty()) {
            findings.push_back({Severity::Error,
                                word + "-id-unique",
                                counted(count, "feature has", "features have") + " no id; give each its own",
                                layer,
                                {}});
        } else if (count > 1) {
            findings.push_back(
                {Severity::Error,
                 word + "-id-unique",
                 std::to_string(count) + " features" + " share the id " + quoted(id) + "; give each its own",
                 layer,
                 {id}});
        }
    }
}

void checkRegions(const Building& building, Findings& findings) {
    std::vector<std::string> unnamed, unsayable;
    std::string example;
    for (const Region& region : building.regions()) {
        std::string fault = polygonFault(region.polygon);
        if (!fault.empty())
            findings.push_back(
                {Severity::Error,
                 "region-polygon-valid",
                 "the outline of region " + quoted(region.id.value) + " " + fault + "; draw it again",
                 "regions",
                 {region.id.value}});
        if (region.name.empty() && region.ref.empty()) unnamed.push_back(region.id.value);
        if (!region.name.empty() && !isSayable(region.name)) {
            if (unsayable.empty()) example = quoted(region.name);
            unsayable.push_back(region.id.value);
        }
    }
    if (!unnamed.empty())
        findings.push_back({Severity::Note, "region-named",
                            counted(unnamed.size(), "region has", "regions have") +
                                " neither name nor ref: only its kind is spoken",
                            "regions", unnamed});
    if (!unsayable.empty())
        findings.push_back({Severity::Note, "region-name-sayable",
                            counted(unsayable.size(), "region is", "regions are") + " called " + example +
                                (unsayable.size() > 1 ? " or the like" : "") +
                                ", which is never spoken; give it the name that people use",
                            "regions", unsayable});
}

void checkLevels(const Building& building, Findings& findings) {
    std::map<std::string, std::vector<std::string>> missing;
    for (const Region& region : building.regions())
        if (building.level(region.level) == nullptr)
            missing[formatNumber(region.level)].push_back(region.id.value);
    for (const auto& [level, ids] : missing)
        findings.push_back({Severity::Warning, "level-listed",
                            "level " + level + " is used by " + counted(ids.size(), "region", "regions") +
                                " but is not in the layer levels: its name cannot be spoken; add it",
                            "levels", ids});
}

/// How far the access lies from a region it names, on the region's level.
bool touches(const Access& access, const Region& region) {
    if (access.line.empty() || region.polygon.outer.size() < 3) return true; // told by other rules
    return distanceToPolygon(region.polygon, access.midpoint()) <= 1.0;
}

void checkAccess(const Building& building, const Access& access, Findings& findings) {
    std::string name = "access " + quoted(access.id.value);
    std::vector<std::string> ids{access.id.value};
    bool complete = true;
    for (const RegionId* side : {&access.regionA, &access.regionB}) {
        complete = complete && !side->empty();
        const Region* region = building.region(*side);
        if (side->empty()) continue;
        if (region == nullptr)
            findings.push_back(
                {Severity::Error, "access-regions-exist",
                 name + " names the region " + quoted(side->value) + ", which does not exist; correct it",
                 "accesses", ids});
        else if (!touches(access, *region))
            findings.push_back(
                {Severity::Warning, "access-touches-regions",
                 name + " lies more than 1 m from region " + quoted(side->value) + "; move it to the border",
                 "accesses", ids});
    }
    if (!complete || access.regionA == access.regionB)
        findings.push_back({Severity::Warning, "access-joins-two-regions",
                            name +
                                (access.regionA == access.regionB && !access.regionA.empty()
                                     ? " has the same region on both sides"
                                     : " does not join two regions") +
                                ": no route passes it; set region_a and region_b, or move it to a border",
                            "accesses", ids});
    const Region* a = building.region(access.regionA);
    const Region* b = building.region(access.regionB);
    if (a != nullptr && b != nullptr && !access.changesLevel() && access.kind != AccessKind::Ramp &&
        !sameLevel(a->level, b->level))
        findings.push_back({Severity::Error, "access-level-change",
                            name + " is no stairs, lift, escalator or ramp but joins regions of levels " +
                                formatNumber(a->level) + " and " + formatNumber(b->level) +
                                "; correct its kind or regions",
                            "accesses", ids});
}

void checkLandmarks(const Building& building, Findings& findings) {
    for (const Landmark& landmark : building.landmarks()) {
        std::string name = "landmark " + quoted(landmark.id.value);
        std::vector<std::string> ids{landmark.id.value};
        const Region* region = building.region(landmark.region);
        if (region == nullptr) {
            findings.push_back({Severity::Error, "landmark-region-exists",
                                landmark.region.empty()
                                    ? name + " belongs to no region; set region_id"
                                    : name + " names the region " + quoted(landmark.region.value) +
                                          ", which does not exist; correct it",
                                "landmarks", ids});
        } else if (!sameLevel(region->level, landmark.level)) {
            findings.push_back({Severity::Warning, "landmark-inside-region",
                                name + " is on level " + formatNumber(landmark.level) + ", its region " +
                                    quoted(region->id.value) + " on level " + formatNumber(region->level),
                                "landmarks", ids});
        } else if (region->polygon.outer.size() >= 3 &&
                   distanceToPolygon(region->polygon, landmark.position) > 0.5) {
            findings.push_back({Severity::Warning, "landmark-inside-region",
                                name + " lies more than 0.5 m outside its region " +
                                    quoted(region->id.value) + "; move it or correct region_id",
                                "landmarks", ids});
        }
    }
}

template <class Items, class KindType>
void checkKinds(const Items& items, KindType other, const std::string& layer, const std::string& words,
                Findings& findings) {
    std::map<std::string, std::vector<std::string>> unknown;
    for (const auto& item : items)
        if (item.kind == other && !item.kindText.empty()) unknown[item.kindText].push_back(item.id.value);
    for (const auto& [kind, ids] : unknown)
        findings.push_back({Severity::Warning, "kind-known",
                            counted(ids.size(), "feature has", "features have") + " the unknown kind " +
                                quoted(kind) + "; known are " + words,
                            layer, ids});
}

std::string landmarkKindWords() {
    std::string words;
    for (Kind kind : allKinds()) words += (words.empty() ? "" : ", ") + std::string(kindName(kind));
    return words;
}

void checkConnected(const Building& building, Findings& findings) {
    auto parts = components(building);
    if (parts.size() < 2) return;
    std::vector<std::string> apart;
    for (std::size_t i = 1; i < parts.size(); ++i)
        for (std::size_t region : parts[i]) apart.push_back(building.regions()[region].id.value);
    findings.push_back(
        {Severity::Warning, "regions-connected",
         "the building falls into " + std::to_string(parts.size()) + " parts; " +
             counted(apart.size(), "region cannot", "regions cannot") + " be reached from the largest (" +
             counted(parts.front().size(), "region", "regions") + "): accesses are missing or closed",
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
    checkKinds(building.regions(), RegionKind::Other, "regions",
               "room, corridor, hall, stairwell, elevator, toilet, outside, other", findings);
    checkKinds(
        building.accesses(), AccessKind::Other, "accesses",
        "door, opening, stairs, elevator, escalator, ramp, window, other (nobody is led through other)",
        findings);
    checkKinds(building.landmarks(), Kind::Other, "landmarks", landmarkKindWords(), findings);
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
