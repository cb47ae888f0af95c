#include "core/base/ogr.h"
#include "core/building/import/finishing.h"
#include "core/building/import/local_plane.h"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace farol::building {

namespace {

constexpr std::size_t kMostCorners = 200000;
constexpr double kSameCornerM = 1e-6, kLeastPartM2 = 0.01;

/// No building lies further from the origin of a metric CRS, and no building file may say so.
constexpr double kFurthestM = 1e8;

bool isPlace(Point2 p) {
    return isFinite(p) && std::abs(p.x) <= kFurthestM && std::abs(p.y) <= kFurthestM;
}

/// Without repeats and without what is no number; true when something of the latter kind went.
bool clean(std::vector<Point2>& points, bool ring) {
    auto bad = std::remove_if(points.begin(), points.end(), [](Point2 p) { return !isPlace(p); });
    bool cleaned = bad != points.end();
    points.erase(bad, points.end());
    auto same = [](Point2 a, Point2 b) { return distance(a, b) < kSameCornerM; };
    points.erase(std::unique(points.begin(), points.end(), same), points.end());
    while (ring && points.size() > 1 && same(points.front(), points.back())) points.pop_back();
    return cleaned;
}

class RegionMender {
public:
    RegionMender(RawMap& raw, FindingList& findings) : m_raw(raw), m_findings(findings) {}

    Result<void> run() {
        std::vector<Region> source = std::exchange(m_raw.data.regions, {});
        for (const Region& region : source) m_ids.emplace(region.id.value, region.id.value);
        for (Region& region : source) mendOne(std::move(region));
        dropRepeats();
        if (m_raw.data.regions.empty())
            return Error{ErrorCode::Corrupt, english(Sentence::NothingToWalk), ""};
        for (Access& access : m_raw.data.accesses) {
            follow(access.regionA);
            follow(access.regionB);
        }
        for (Landmark& landmark : m_raw.data.landmarks) follow(landmark.region);
        for (RawMap::VerticalLink& link : m_raw.verticalLinks) {
            follow(link.from);
            follow(link.to);
        }
        mendLines();
        mendLandmarks();
        return {};
    }

private:
    void tell(Severity severity, const std::string& rule, const Message& message, const std::string& id) {
        m_findings.add(severity, rule, message, "regions", id);
    }

    void drop(const Region& region, const std::string& rule, const Message& message) {
        tell(Severity::Warning, rule, message, region.id.value);
        m_ids[region.id.value].clear();
    }

    void mendOne(Region region) {
        bool notFinite = clean(region.polygon.outer, true);
        std::size_t corners = region.polygon.outer.size();
        for (Ring& hole : region.polygon.holes) {
            notFinite = clean(hole, true) || notFinite;
            corners += hole.size();
        }
        std::erase_if(region.polygon.holes, [](const Ring& hole) { return hole.size() < 3; });
        if (notFinite)
            tell(Severity::Warning, "coordinates-finite", Sentence::CornersNoPlaces, region.id.value);
        if (region.polygon.outer.size() < 3)
            return drop(region, "region-polygon-valid", Sentence::RegionsOfFewCorners);
        if (corners > kMostCorners)
            return drop(region, "region-polygon-valid", Sentence::RegionsOfManyCorners);
        std::vector<Polygon> parts = validParts(region);
        if (parts.empty()) return drop(region, "region-polygon-valid", Sentence::RegionsOfNoArea);
        addParts(std::move(region), std::move(parts));
    }

    std::vector<Polygon> validParts(const Region& region) {
        GdalMessages messages;
        GeometryPtr geometry = ogrPolygon(region.polygon);
        std::vector<Polygon> parts = polygonsOf(geometry.get(), kLeastPartM2);
        if (!messages.text().empty() || parts.size() != 1 ||
            parts.front().outer.size() != region.polygon.outer.size() ||
            std::abs(area(parts.front()) - area(region.polygon)) >
                1e-6 * std::max(1.0, area(region.polygon))) {
            if (!parts.empty())
                tell(Severity::Warning, "region-polygon-valid", Sentence::OutlinesMended, region.id.value);
        }
        return parts;
    }

    void addParts(Region region, std::vector<Polygon> parts) {
        std::stable_sort(parts.begin(), parts.end(),
                         [](const Polygon& a, const Polygon& b) { return area(a) > area(b); });
        std::string id = region.id.value;
        if (parts.size() > 1) tell(Severity::Warning, "region-split", Sentence::RegionsSplit, id);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            Region part = region;
            part.polygon = std::move(parts[i]);
            for (std::size_t number = i + 1; i > 0; ++number) {
                part.id.value = id + "/" + std::to_string(number);
                if (m_ids.emplace(part.id.value, part.id.value).second) break;
            }
            m_raw.data.regions.push_back(std::move(part));
        }
    }

    void dropRepeats() {
        std::map<std::array<long long, 6>, std::size_t> seen;
        std::vector<Region> kept;
        for (Region& region : m_raw.data.regions) {
            Box2 box = *boundingBox(region.polygon.outer);
            auto centimetres = [](double metres) {
                return std::llround(std::clamp(metres, -1e12, 1e12) * 100.0);
            };
            std::array<long long, 6> key{centimetres(region.level * 10.0), centimetres(box.low.x),
                                         centimetres(box.low.y),           centimetres(box.high.x),
                                         centimetres(box.high.y),          centimetres(area(region.polygon))};
            auto [place, fresh] = seen.emplace(key, kept.size());
            Region* first = fresh ? nullptr : &kept[place->second];
            bool differ = first != nullptr && !first->name.empty() && !region.name.empty() &&
                          first->name != region.name;
            if (first != nullptr && !differ) {
                if (first->name.empty()) first->name = region.name;
                if (first->ref.empty()) first->ref = region.ref;
                first->restricted = first->restricted || region.restricted;
                tell(Severity::Warning, "region-duplicate", Sentence::RegionsMerged, region.id.value);
                m_ids[region.id.value] = first->id.value;
                continue;
            }
            kept.push_back(std::move(region));
        }
        m_raw.data.regions = std::move(kept);
    }

    /// Names of regions that were dropped or merged; an unknown name stays, for the checks to tell.
    void follow(RegionId& id) const {
        auto found = m_ids.find(id.value);
        if (found != m_ids.end()) id.value = found->second;
    }

    void mendLines() {
        std::unordered_map<std::string, const Region*> regions;
        for (const Region& region : m_raw.data.regions) regions.emplace(region.id.value, &region);
        std::erase_if(m_raw.data.accesses, [&](Access& access) {
            if (clean(access.line, false))
                m_findings.add(Severity::Warning, "coordinates-finite", Sentence::AccessPointsNoPlaces,
                               "accesses", access.id.value);
            auto side = regions.find(access.regionA.value);
            if (side == regions.end()) side = regions.find(access.regionB.value);
            if (access.line.empty() && side != regions.end())
                access.line = {pointInside(side->second->polygon)};
            if (!access.line.empty()) return false;
            m_findings.add(Severity::Warning, "access-geometry", Sentence::AccessesNoPlace, "accesses",
                           access.id.value);
            return true;
        });
        std::erase_if(m_raw.data.walls, [](Wall& wall) {
            clean(wall.line, false);
            return wall.line.size() < 2;
        });
    }

    void mendLandmarks() {
        std::erase_if(m_raw.data.landmarks, [&](const Landmark& landmark) {
            if (isPlace(landmark.position)) return false;
            m_findings.add(Severity::Warning, "coordinates-finite", Sentence::LandmarksNoPlace, "landmarks",
                           landmark.id.value);
            return true;
        });
    }

    RawMap& m_raw;
    FindingList& m_findings;
    std::unordered_map<std::string, std::string> m_ids; ///< of the source -> of the map; empty: dropped
};

} // namespace

Result<void> mendRegions(RawMap& raw, FindingList& findings) {
    return RegionMender(raw, findings).run();
}

} // namespace farol::building
