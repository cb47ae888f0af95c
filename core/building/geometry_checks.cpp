#include "core/building/geometry_checks.h"

#include "core/base/ogr.h"
#include "core/base/text.h"
#include "core/building/import/local_plane.h"
#include "core/building/level_regions.h"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>

namespace farol::building {

namespace {

using Findings = std::vector<Finding>;

constexpr double kSliverWidthM = 0.25, kLeastAreaM2 = 0.1;
/// Shared borders drawn by hand overlap by less than this part of the smaller region.
constexpr double kOverlapShare = 0.05, kInsideShare = 0.95;
/// Overlaps looked at per region on average; a map in which everything overlaps is told soon enough.
constexpr std::size_t kMostPairsEach = 20;
/// As near as this a door is drawn on a region.
constexpr double kOnBorderM = 0.1;

double perimeter(const Ring& ring) {
    double sum = ring.empty() ? 0.0 : distance(ring.back(), ring.front());
    return sum + length(Polyline(ring));
}

/// Of a long thin shape, nearly its width.
double meanWidth(const Polygon& polygon) {
    double around = perimeter(polygon.outer);
    for (const Ring& hole : polygon.holes) around += perimeter(hole);
    return around > 0.0 ? 2.0 * area(polygon) / around : 0.0;
}

class OverlapCheck {
public:
    OverlapCheck(const Building& building, Findings& findings)
        : m_building(building), m_findings(findings), m_index(building.regions()) {}

    void run() {
        std::size_t left = 1000 + kMostPairsEach * m_building.regions().size();
        for (std::size_t a = 0; a < m_building.regions().size() && left > 0; ++a) {
            const Region& region = m_building.regions()[a];
            auto box = boundingBox(region.polygon.outer);
            if (!box || region.polygon.outer.size() < 3) continue;
            for (std::size_t b : m_index.meeting(region.level, *box)) {
                if (b <= a || m_building.regions()[b].polygon.outer.size() < 3) continue;
                if (left == 0 || --left == 0) break;
                compare(region, m_building.regions()[b]);
            }
        }
        if (left == 0)
            m_findings.push_back(
                {Severity::Warning, "region-overlap", Sentence::OverlapsTooMany, "regions", {}});
    }

private:
    void compare(const Region& a, const Region& b) {
        Box2 one = *boundingBox(a.polygon.outer), other = *boundingBox(b.polygon.outer);
        double width = std::min(one.high.x, other.high.x) - std::max(one.low.x, other.low.x);
        double height = std::min(one.high.y, other.high.y) - std::max(one.low.y, other.low.y);
        double smaller = std::min(area(a.polygon), area(b.polygon)),
               larger = std::max(area(a.polygon), area(b.polygon));
        double least = std::max(kLeastAreaM2, kOverlapShare * smaller);
        if (width * height < least || smaller <= 0.0) return; // borders only
        GdalMessages quiet;
        GeometryPtr first = ogrPolygon(a.polygon), second = ogrPolygon(b.polygon);
        GeometryPtr both(first != nullptr && second != nullptr ? first->Intersection(second.get()) : nullptr);
        double shared = 0.0;
        for (const Polygon& part : polygonsOf(both.get(), 0.0)) shared += area(part);
        if (shared >= least) tell(a, b, shared / smaller, smaller / larger);
    }

    void tell(const Region& a, const Region& b, double share, double ratio) {
        std::vector<std::string> ids{a.id.value, b.id.value};
        if (share > kInsideShare && ratio > kInsideShare)
            m_findings.push_back({Severity::Warning, "region-duplicate",
                                  said(Sentence::RegionsAlike, a.id.value, b.id.value), "regions", ids});
        else if (share > kInsideShare)
            m_findings.push_back({Severity::Note, "region-inside",
                                  said(Sentence::RegionInside, a.id.value, b.id.value), "regions", ids});
        else
            m_findings.push_back(
                {Severity::Warning, "region-overlap",
                 said(Sentence::RegionsOverlap, a.id.value, b.id.value, std::round(share * 100.0)), "regions",
                 ids});
    }

    const Building& m_building;
    Findings& m_findings;
    LevelRegions m_index;
};

void checkShafts(const Building& building, Findings& findings) {
    std::map<ShaftId, std::set<double>> served;
    for (const Access& access : building.accesses()) {
        if (access.shaft.empty()) continue;
        for (const RegionId* side : {&access.regionA, &access.regionB})
            if (const Region* region = building.region(*side)) served[access.shaft].insert(region->level);
    }
    for (const auto& [shaft, levels] : served) {
        std::vector<double> missing;
        for (const Level& level : building.levels())
            if (level.ordinal == std::floor(level.ordinal) && level.ordinal > *levels.begin() &&
                level.ordinal < *levels.rbegin() && levels.count(level.ordinal) == 0)
                missing.push_back(level.ordinal);
        if (!missing.empty())
            findings.push_back({Severity::Warning,
                                "shaft-misses-level",
                                said(Sentence::ShaftMissesLevel, shaft.value, missing),
                                "accesses",
                                {shaft.value}});
    }
}

void checkRefs(const Building& building, Findings& findings) {
    std::map<std::pair<double, std::string>, std::vector<std::string>> regions;
    for (const Region& region : building.regions())
        if (!region.ref.empty())
            regions[{region.level, foldedForMatching(region.ref)}].push_back(region.id.value);
    for (const auto& [ref, ids] : regions)
        if (ids.size() > 1)
            findings.push_back({Severity::Warning, "region-ref-unique",
                                counted(Sentence::RefShared, ids.size(), ref.first, ref.second), "regions",
                                ids});
}

void checkSize(const Building& building, Findings& findings) {
    std::optional<Box2> all;
    for (const Region& region : building.regions())
        for (Point2 p : region.polygon.outer) {
            if (!isFinite(p)) return;
            if (!all) all = Box2{p, p};
            all = Box2{{std::min(all->low.x, p.x), std::min(all->low.y, p.y)},
                       {std::max(all->high.x, p.x), std::max(all->high.y, p.y)}};
        }
    if (all && building.regions().size() > 1 && std::max(all->width(), all->height()) < 0.3)
        findings.push_back(
            {Severity::Error, "crs-degrees-for-metres", Sentence::BuildingTiny, "regions", {}});
}

/// The regions on which a door is drawn: one of its ends or its middle lies on their outline or within.
class DrawnDoors {
public:
    explicit DrawnDoors(const Building& building) : m_building(building), m_index(building.regions()) {}

    std::vector<std::size_t> regionsOf(const Access& access) const {
        std::vector<std::size_t> touched;
        auto box = boundingBox(access.line);
        if (!box) return touched;
        Polyline spots{access.line.front(), access.midpoint(), access.line.back()};
        for (std::size_t region : m_index.meeting(access.level, grown(*box, kOnBorderM))) {
            const Polygon& polygon = m_building.regions()[region].polygon;
            if (polygon.outer.size() < 3) continue;
            if (std::any_of(spots.begin(), spots.end(),
                            [&](Point2 spot) { return distanceToPolygon(polygon, spot) <= kOnBorderM; }))
                touched.push_back(region);
        }
        return touched;
    }

private:
    const Building& m_building;
    LevelRegions m_index;
};

void checkDoors(const Building& building, Findings& findings) {
    DrawnDoors drawn(building);
    std::vector<std::string> several, without, besides;
    std::vector<bool> touched(building.regions().size(), false); // by a door that one can pass
    for (const Access& access : building.accesses()) {
        bool joins = access.passable() && building.region(access.regionA) != nullptr &&
                     building.region(access.regionB) != nullptr;
        if (access.changesLevel() || access.kind == AccessKind::Window) continue;
        std::vector<std::size_t> regions = drawn.regionsOf(access);
        for (std::size_t region : regions) touched[region] = touched[region] || joins;
        if (regions.size() > 2 && access.kind == AccessKind::Door) several.push_back(access.id.value);
    }
    for (std::size_t i = 0; i < building.regions().size() && building.regions().size() > 1; ++i)
        if (building.neighboursOf(i).empty())
            (touched[i] ? besides : without).push_back(building.regions()[i].id.value);
    if (!several.empty())
        findings.push_back({Severity::Note, "access-touches-two-regions",
                            counted(Sentence::AccessesOnManyRegions, several.size()), "accesses", several});
    if (!without.empty())
        findings.push_back({Severity::Warning, "region-has-access",
                            counted(Sentence::RegionsWithoutAccess, without.size()), "regions", without});
    if (!besides.empty())
        findings.push_back({Severity::Warning, "region-door-joins-others",
                            counted(Sentence::RegionsBesideDoors, besides.size()), "regions", besides});
}

void checkEscalators(const Building& building, Findings& findings) {
    std::vector<std::string> undirected;
    for (const Access& access : building.accesses())
        if (access.kind == AccessKind::Escalator && access.oneWay == OneWay::No && !access.closed)
            undirected.push_back(access.id.value);
    if (!undirected.empty())
        findings.push_back({Severity::Warning, "escalator-direction",
                            counted(Sentence::EscalatorsUndirected, undirected.size()), "accesses",
                            undirected});
}

} // namespace

bool crossesItself(const Polygon& polygon) {
    GdalMessages quiet;
    OGRPolygon shape;
    auto add = [&](const Ring& points) {
        OGRLinearRing ring;
        for (Point2 p : points) ring.addPoint(p.x, p.y);
        ring.closeRings();
        shape.addRing(&ring);
    };
    add(polygon.outer);
    for (const Ring& hole : polygon.holes) add(hole);
    return shape.IsValid() == FALSE;
}

void checkOutlines(const Building& building, Findings& findings) {
    for (const Region& region : building.regions()) {
        if (region.polygon.outer.size() < 3 || std::abs(signedArea(region.polygon.outer)) < 1e-6)
            continue; // told otherwise
        double width = meanWidth(region.polygon);
        if (width < kSliverWidthM)
            findings.push_back(
                {Severity::Warning,
                 "region-sliver",
                 said(Sentence::RegionSliver, region.id.value, std::round(width * 100.0) / 100.0),
                 "regions",
                 {region.id.value}});
    }
    OverlapCheck(building, findings).run();
}

void checkTables(const Building& building, Findings& findings) {
    checkSize(building, findings);
    checkRefs(building, findings);
    checkShafts(building, findings);
    checkDoors(building, findings);
    checkEscalators(building, findings);
}

} // namespace farol::building
