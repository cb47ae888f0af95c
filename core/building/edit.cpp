#include "core/building/edit.h"

#include "core/building/access_regions.h"
#include "core/building/box_index.h"
#include "core/building/sentence.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace farol::building {

namespace {

constexpr double kWallReachM = 0.5;
constexpr double kSideReachM = 1.0;
constexpr double kDoorWidthM = 0.9;

/// The list that holds such features, of a building that may be changed or only read.
template <class Value, class Data>
auto& listOf(Data& data) {
    if constexpr (std::is_same_v<Value, Region>)
        return data.regions;
    else if constexpr (std::is_same_v<Value, Access>)
        return data.accesses;
    else
        return data.landmarks;
}

template <class IdType, class Known>
IdType freeId(const std::string& stem, std::size_t from, Known known) {
    for (std::size_t number = from + 1;; ++number) {
        IdType id(stem + std::to_string(number));
        if (!known(id)) return id;
    }
}

bool isPositive(const std::optional<double>& value) {
    return !value || (std::isfinite(*value) && *value > 0.0);
}

Result<void> checked(const Region& region) {
    if (region.polygon.outer.size() < 3)
        return Error{ErrorCode::InvalidArgument, english(Sentence::EditNoOutline), region.id.value};
    return {};
}

Result<void> checked(const Access& access) {
    if (access.line.empty() || !std::all_of(access.line.begin(), access.line.end(), isFinite))
        return Error{ErrorCode::InvalidArgument, english(Sentence::EditAccessNoPlace), access.id.value};
    if (!access.regionA.empty() && access.regionA == access.regionB)
        return Error{ErrorCode::InvalidArgument, english(Sentence::EditSameSides), access.id.value};
    if (!isPositive(access.widthM) || (access.steps && *access.steps < 0))
        return Error{ErrorCode::InvalidArgument, english(Sentence::EditWidthOrSteps), access.id.value};
    return {};
}

Result<void> checked(const Landmark& landmark) {
    if (!isFinite(landmark.position))
        return Error{ErrorCode::InvalidArgument, english(Sentence::EditLandmarkNoPlace), landmark.id.value};
    if (!isPositive(landmark.widthM) || !isPositive(landmark.tallM))
        return Error{ErrorCode::InvalidArgument, english(Sentence::EditLandmarkSize), landmark.id.value};
    return {};
}

bool taken(const Building& building, const Region& region) {
    return building.region(region.id) != nullptr;
}
bool taken(const Building& building, const Access& access) {
    return building.access(access.id) != nullptr;
}
bool taken(const Building& building, const Landmark& landmark) {
    return building.landmark(landmark.id) != nullptr;
}

/// The regions of a level near a spot, with their distance, nearest first.
std::vector<std::pair<double, const Region*>> regionsNear(const Building& building, Point2 at, double level,
                                                          double reach) {
    std::vector<std::pair<double, const Region*>> near;
    const Box2 around = grown({at, at}, reach);
    for (const Region& region : building.regions()) {
        if (region.level != level || region.polygon.outer.size() < 3) continue;
        const auto box = boundingBox(region.polygon.outer);
        if (!box || !meet(*box, around)) continue;
        const double gap = distanceToPolygon(region.polygon, at);
        if (gap <= reach) near.emplace_back(gap, &region);
    }
    std::stable_sort(near.begin(), near.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    return near;
}

/// A door's line along the wall nearest to the spot; the spot alone where there is none.
Polyline doorLine(const std::vector<std::pair<double, const Region*>>& near, Point2 at) {
    double best = kWallReachM;
    Polyline line{at};
    for (const auto& [gap, region] : near) {
        const Ring& ring = region->polygon.outer;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point2 a = ring[i];
            const Point2 b = ring[(i + 1) % ring.size()];
            const double wall = distance(a, b);
            const double away = distanceToSegment(at, a, b);
            if (away >= best || wall < 0.2) continue;
            best = away;
            const Point2 along = (b - a) * (1.0 / wall);
            const double half = std::min(kDoorWidthM, wall) / 2;
            const double middle = std::clamp(dot(at - a, along), half, wall - half);
            line = {a + along * (middle - half), a + along * (middle + half)};
        }
    }
    return line;
}

/// The two sides from where the access lies now.
void findSides(const Building& building, Access& access) {
    const Point2 middle = access.midpoint();
    const auto near = regionsNear(building, middle, access.level, kSideReachM);
    BuildingData close;
    for (const auto& [gap, region] : near) close.regions.push_back(*region);
    access.regionA = RegionId();
    access.regionB = RegionId();
    close.accesses = {access};
    deriveAccessRegions(close);
    access.regionA = close.accesses.front().regionA;
    access.regionB = close.accesses.front().regionB;
    if (!access.regionA.empty() && !access.regionB.empty()) return;
    if (near.size() != 2) return; // of three or more, which are meant is a guess
    access.regionA = near[0].second->id;
    access.regionB = near[1].second->id;
}

} // namespace

Edit reversed(Edit edit) {
    std::swap(edit.before, edit.after);
    return edit;
}

void apply(BuildingData& data, const Edit& edit) {
    const Feature& sort = edit.after ? *edit.after : *edit.before;
    std::visit(
        [&](const auto& tag) {
            using Value = std::decay_t<decltype(tag)>;
            auto& list = listOf<Value>(data);
            const auto place = static_cast<std::ptrdiff_t>(std::min(edit.index, list.size()));
            if (!edit.before)
                list.insert(list.begin() + place, std::get<Value>(*edit.after));
            else if (!edit.after)
                list.erase(list.begin() + place);
            else
                list[static_cast<std::size_t>(place)] = std::get<Value>(*edit.after);
        },
        sort);
}

Result<Edit> insertion(const Building& building, Feature feature) {
    return std::visit(
        [&](auto& value) -> Result<Edit> {
            if (const auto fine = checked(value); !fine) return fine.error();
            if (taken(building, value))
                return Error{ErrorCode::Conflict, english(Sentence::EditNameTaken), value.id.value};
            const auto& list = listOf<std::decay_t<decltype(value)>>(building.data());
            return Edit{list.size(), std::nullopt, Feature(value)};
        },
        feature);
}

Result<Edit> change(const Building& building, std::size_t index, Feature after) {
    return std::visit(
        [&](auto& value) -> Result<Edit> {
            const auto& list = listOf<std::decay_t<decltype(value)>>(building.data());
            if (index >= list.size())
                return Error{ErrorCode::NotFound, english(Sentence::EditGone), value.id.value};
            if (const auto fine = checked(value); !fine) return fine.error();
            if (list[index].id != value.id && taken(building, value))
                return Error{ErrorCode::Conflict, english(Sentence::EditNameTaken), value.id.value};
            return Edit{index, Feature(list[index]), Feature(value)};
        },
        after);
}

Edit removalOfAccess(const Building& building, std::size_t index) {
    return {index, Feature(building.accesses()[index]), std::nullopt};
}

Edit removalOfLandmark(const Building& building, std::size_t index) {
    return {index, Feature(building.landmarks()[index]), std::nullopt};
}

Landmark newLandmark(const Building& building, Kind kind, Point2 at, double level) {
    Landmark landmark;
    landmark.id = freeId<LandmarkId>("L", building.landmarks().size(),
                                     [&](const LandmarkId& id) { return building.landmark(id) != nullptr; });
    landmark.kind = kind;
    landmark.level = level;
    return moved(building, std::move(landmark), at);
}

Access newAccess(const Building& building, AccessKind kind, Point2 at, double level) {
    Access access;
    access.id = freeId<AccessId>("A", building.accesses().size(),
                                 [&](const AccessId& id) { return building.access(id) != nullptr; });
    access.kind = kind;
    access.level = level;
    access.line = doorLine(regionsNear(building, at, level, kSideReachM), at);
    findSides(building, access);
    return access;
}

Landmark moved(const Building& building, Landmark landmark, Point2 to) {
    landmark.position = to;
    const auto home = building.regionAt(to, landmark.level);
    landmark.region = home ? building.regions()[*home].id : RegionId();
    return landmark;
}

Access moved(const Building& building, Access access, Point2 by) {
    for (Point2& point : access.line) point = point + by;
    if (!access.changesLevel()) findSides(building, access);
    return access;
}

} // namespace farol::building
