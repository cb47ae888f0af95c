#include "core/building/info.h"

#include "core/base/ogr.h"
#include "core/base/text.h"
#include "core/building/checks.h"
#include "core/building/sentence.h"

#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace farol::building {

namespace {

/// "EPSG:32629" where the CRS has a code, else its name, else nothing.
std::string shortCrs(const std::string& wkt) {
    if (wkt.empty()) return {};
    GdalMessages quiet;
    OGRSpatialReference reference;
    if (reference.SetFromUserInput(wkt.c_str(), OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()) !=
        OGRERR_NONE)
        return wkt;
    const char* authority = reference.GetAuthorityName(nullptr);
    const char* code = reference.GetAuthorityCode(nullptr);
    if (authority != nullptr && code != nullptr) return std::string(authority) + ":" + code;
    const char* name = reference.GetName();
    return name != nullptr ? name : wkt;
}

LevelInfo& levelInfo(std::vector<LevelInfo>& levels, double ordinal) {
    auto it = std::find_if(levels.begin(), levels.end(),
                           [&](const LevelInfo& each) { return std::abs(each.level - ordinal) < 1e-6; });
    if (it != levels.end()) return *it;
    LevelInfo info;
    info.level = ordinal;
    return levels.emplace_back(info);
}

std::optional<std::array<double, 3>> threeNumbers(const std::string& text) {
    std::array<double, 3> numbers{};
    const char* at = text.data();
    const char* end = at + text.size();
    for (std::size_t i = 0; i < 3; ++i) {
        while (at != end && *at == ' ') ++at;
        auto [rest, failure] = std::from_chars(at, end, numbers[i]);
        if (failure != std::errc() || !std::isfinite(numbers[i])) return std::nullopt;
        at = rest;
        while (at != end && *at == ' ') ++at;
        if (i < 2 && (at == end || *at++ != ',')) return std::nullopt;
    }
    if (at != end) return std::nullopt;
    return numbers;
}

Result<Location> locationAt(const Building& building, const std::string& where, Point2 point, double level) {
    std::optional<std::size_t> found = building.regionAt(point, level);
    double nearest = 0.5; // a point in the thickness of a wall belongs to the nearest room
    for (std::size_t i = 0; i < building.regions().size() && nearest > 0.0; ++i) {
        const Region& region = building.regions()[i];
        if (std::abs(region.level - level) > 1e-6) continue;
        double gap = distanceToPolygon(region.polygon, point);
        if (gap >= nearest) continue;
        nearest = gap;
        if (gap > 0.0) found = i;
    }
    if (!found) return Error{ErrorCode::NotFound, english(Sentence::WhereInNoRegion, level), where};
    return Location{building.regions()[*found].id, point};
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

/// Up to five names, refs or ids that are spelt nearly like it.
std::vector<std::string> nearSpellings(const Building& building, const std::string& folded) {
    std::vector<std::pair<int, std::string>> ranked;
    for (const Region& region : building.regions()) {
        for (const std::string& name : {region.name, region.ref, region.id.value}) {
            std::string other = foldedForMatching(name);
            if (other.empty()) continue;
            bool part = folded.size() >= 2 && other.find(folded) != std::string::npos;
            int gap = part ? 1 : editDistance(folded, other);
            if (gap <= std::max(2, static_cast<int>(folded.size()) / 3)) ranked.emplace_back(gap, name);
        }
    }
    std::sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) {
        return a.first != b.first ? a.first < b.first : naturalLess(a.second, b.second);
    });
    std::vector<std::string> names;
    for (const auto& entry : ranked) {
        if (std::find(names.begin(), names.end(), entry.second) == names.end()) names.push_back(entry.second);
        if (names.size() == 5) break;
    }
    return names;
}

} // namespace

BuildingInfo describe(const Building& building) {
    BuildingInfo info;
    info.regions = building.regions().size();
    info.accesses = building.accesses().size();
    info.landmarks = building.landmarks().size();
    info.crs = shortCrs(building.data().crs);
    for (const Level& level : building.levels()) levelInfo(info.levels, level.ordinal).ref = level.ref;
    Ring corners;
    for (const Region& region : building.regions()) {
        ++levelInfo(info.levels, region.level).regions;
        if (region.name.empty() && region.ref.empty()) ++info.unnamedRegions;
        corners.insert(corners.end(), region.polygon.outer.begin(), region.polygon.outer.end());
    }
    for (const Access& access : building.accesses()) {
        ++levelInfo(info.levels, access.level).accesses;
        auto a = building.regionIndex(access.regionA);
        if (a && building.otherSide(access, *a)) ++info.accessesJoined;
    }
    for (const Landmark& landmark : building.landmarks()) {
        ++levelInfo(info.levels, landmark.level).landmarks;
        bool foreign = landmark.kind == Kind::Other && !landmark.kindText.empty();
        ++info.landmarkKinds[foreign ? landmark.kindText : std::string(kindName(landmark.kind))];
    }
    std::sort(info.levels.begin(), info.levels.end(),
              [](const LevelInfo& a, const LevelInfo& b) { return a.level < b.level; });
    auto parts = components(building);
    info.components = parts.size();
    info.largestComponent = parts.empty() ? 0 : parts.front().size();
    if (auto box = boundingBox(corners)) {
        info.widthM = box->width();
        info.heightM = box->height();
    }
    return info;
}

Result<Location> resolveWhere(const Building& building, const std::string& where) {
    if (const Region* exact = building.region(RegionId(where))) return Location{exact->id, std::nullopt};
    std::string folded = foldedForMatching(where);
    if (folded.empty()) return Error{ErrorCode::InvalidArgument, english(Sentence::WhereEmpty), ""};
    std::vector<const Region*> matches;
    for (const Region& region : building.regions())
        if (foldedForMatching(region.name) == folded || foldedForMatching(region.ref) == folded)
            matches.push_back(&region);
    for (const Region& region : building.regions())
        if (matches.empty() && foldedForMatching(region.id.value) == folded)
            return Location{region.id, std::nullopt};
    if (matches.size() == 1) return Location{matches.front()->id, std::nullopt};
    if (matches.size() > 1) {
        std::vector<std::string> names;
        for (const Region* region : matches)
            names.push_back(english(Sentence::RegionOnLevel, region->id.value, region->level));
        return Error{ErrorCode::Conflict, english(Sentence::WhereShared, listed(names)), where};
    }
    if (auto numbers = threeNumbers(where))
        return locationAt(building, where, {(*numbers)[0], (*numbers)[1]}, (*numbers)[2]);
    std::vector<std::string> near = nearSpellings(building, folded);
    return Error{
        ErrorCode::NotFound,
        near.empty() ? english(Sentence::WhereUnknown) : english(Sentence::WhereNearly, listed(near)), where};
}

} // namespace farol::building
