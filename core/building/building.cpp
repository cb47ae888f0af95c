#include "core/building/building.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace farol::building {

namespace {

template <class Kind, std::size_t N>
using Names = std::array<std::pair<Kind, const char*>, N>;

constexpr Names<RegionKind, 8> kRegionKinds{{{RegionKind::Room, "room"},
                                             {RegionKind::Corridor, "corridor"},
                                             {RegionKind::Hall, "hall"},
                                             {RegionKind::Stairwell, "stairwell"},
                                             {RegionKind::Elevator, "elevator"},
                                             {RegionKind::Toilet, "toilet"},
                                             {RegionKind::Outside, "outside"},
                                             {RegionKind::Other, "other"}}};

constexpr Names<AccessKind, 8> kAccessKinds{{{AccessKind::Door, "door"},
                                             {AccessKind::Opening, "opening"},
                                             {AccessKind::Stairs, "stairs"},
                                             {AccessKind::Elevator, "elevator"},
                                             {AccessKind::Escalator, "escalator"},
                                             {AccessKind::Ramp, "ramp"},
                                             {AccessKind::Window, "window"},
                                             {AccessKind::Other, "other"}}};

template <class Kind, std::size_t N>
std::string nameIn(const Names<Kind, N>& names, Kind kind) {
    for (const auto& [value, name] : names)
        if (value == kind) return name;
    return "other";
}

template <class Kind, std::size_t N>
std::optional<Kind> kindIn(const Names<Kind, N>& names, const std::string& wanted) {
    for (const auto& [value, name] : names)
        if (wanted == name) return value;
    return std::nullopt;
}

/// "name_pt", as in tables, or "name:pt", as in OpenStreetMap.
std::optional<std::string> nameFrom(const Attributes& extra, const std::string& language) {
    if (language.empty()) return std::nullopt;
    for (const char* between : {"_", ":"}) {
        auto found = extra.find(std::string("name") + between + language);
        if (found == extra.end()) continue;
        const auto* name = std::get_if<std::string>(&found->second);
        if (name != nullptr && !name->empty()) return *name;
    }
    return std::nullopt;
}

template <class Key>
std::optional<std::size_t> find(const std::unordered_map<Key, std::size_t>& index, const Key& key) {
    auto it = index.find(key);
    if (it == index.end()) return std::nullopt;
    return it->second;
}

bool sameLevel(double a, double b) {
    return std::abs(a - b) < 1e-6;
}

bool holds(const Box2& box, Point2 p) {
    return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y;
}

} // namespace

Point2 Access::midpoint() const {
    if (line.empty()) return {};
    double remaining = farol::length(line) / 2.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        double step = distance(line[i - 1], line[i]);
        if (step > 0.0 && step >= remaining)
            return line[i - 1] + (line[i] - line[i - 1]) * (remaining / step);
        remaining -= step;
    }
    return line.back();
}

std::span<const std::size_t> Building::Lists::of(std::size_t i) const {
    if (i + 1 >= starts.size()) return {};
    return {items.data() + starts[i], starts[i + 1] - starts[i]};
}

Building::Lists Building::listsOf(std::vector<std::vector<std::size_t>> rows, bool sortedOnce) {
    Lists lists;
    lists.starts.push_back(0);
    for (std::vector<std::size_t>& row : rows) {
        if (sortedOnce) {
            std::sort(row.begin(), row.end());
            row.erase(std::unique(row.begin(), row.end()), row.end());
        }
        lists.items.insert(lists.items.end(), row.begin(), row.end());
        lists.starts.push_back(lists.items.size());
    }
    return lists;
}

Building::Building(BuildingData data) : m_data(std::move(data)) {
    std::stable_sort(m_data.levels.begin(), m_data.levels.end(),
                     [](const Level& a, const Level& b) { return a.ordinal < b.ordinal; });
    // emplace keeps the first of several with one id; checkBuilding names the others.
    for (std::size_t i = 0; i < regions().size(); ++i) m_regionIndex.emplace(regions()[i].id, i);
    for (std::size_t i = 0; i < accesses().size(); ++i) m_accessIndex.emplace(accesses()[i].id, i);
    std::vector<std::vector<std::size_t>> landmarkRows(regions().size());
    for (std::size_t i = 0; i < landmarks().size(); ++i) {
        m_landmarkIndex.emplace(landmarks()[i].id, i);
        if (auto region = regionIndex(landmarks()[i].region)) landmarkRows[*region].push_back(i);
    }
    m_landmarks = listsOf(std::move(landmarkRows), false);
    for (const Region& each : regions()) m_boxes.push_back(boundingBox(each.polygon.outer));
    indexNeighbours();
}

void Building::indexNeighbours() {
    std::vector<std::vector<std::size_t>> accessRows(regions().size());
    std::vector<std::vector<std::size_t>> neighbourRows(regions().size());
    std::vector<bool> changesLevel(regions().size(), false);
    for (std::size_t i = 0; i < regions().size(); ++i)
        changesLevel[i] =
            regions()[i].kind == RegionKind::Stairwell || regions()[i].kind == RegionKind::Elevator;
    for (std::size_t i = 0; i < accesses().size(); ++i) {
        const Access& each = accesses()[i];
        auto a = regionIndex(each.regionA);
        auto b = regionIndex(each.regionB);
        if (a) accessRows[*a].push_back(i);
        if (b && b != a) accessRows[*b].push_back(i);
        for (auto side : {a, b})
            if (side && each.changesLevel()) changesLevel[*side] = true;
        if (!a || !b || a == b || !each.passable()) continue;
        neighbourRows[*a].push_back(*b);
        neighbourRows[*b].push_back(*a);
    }
    m_accesses = listsOf(std::move(accessRows), false);
    m_neighbours = listsOf(std::move(neighbourRows), true);
    m_nearLevelChange = changesLevel;
    for (std::size_t i = 0; i < regions().size(); ++i)
        for (std::size_t neighbour : m_neighbours.of(i))
            if (changesLevel[neighbour]) m_nearLevelChange[i] = true;
}

std::optional<std::size_t> Building::regionIndex(const RegionId& id) const {
    return find(m_regionIndex, id);
}

const Region* Building::region(const RegionId& id) const {
    auto index = regionIndex(id);
    return index ? &regions()[*index] : nullptr;
}

const Access* Building::access(const AccessId& id) const {
    auto index = find(m_accessIndex, id);
    return index ? &accesses()[*index] : nullptr;
}

const Landmark* Building::landmark(const LandmarkId& id) const {
    auto index = find(m_landmarkIndex, id);
    return index ? &landmarks()[*index] : nullptr;
}

const Level* Building::level(double ordinal) const {
    auto it = std::find_if(levels().begin(), levels().end(),
                           [&](const Level& each) { return sameLevel(each.ordinal, ordinal); });
    return it == levels().end() ? nullptr : &*it;
}

std::span<const std::size_t> Building::accessesOf(std::size_t regionIndex) const {
    return m_accesses.of(regionIndex);
}

std::span<const std::size_t> Building::neighboursOf(std::size_t regionIndex) const {
    return m_neighbours.of(regionIndex);
}

std::span<const std::size_t> Building::landmarksOf(std::size_t regionIndex) const {
    return m_landmarks.of(regionIndex);
}

bool Building::areNeighbours(std::size_t a, std::size_t b) const {
    auto row = m_neighbours.of(a);
    return std::binary_search(row.begin(), row.end(), b);
}

std::optional<std::size_t> Building::otherSide(const Access& access, std::size_t regionIndex) const {
    auto a = this->regionIndex(access.regionA);
    auto b = this->regionIndex(access.regionB);
    if (!a || !b || a == b) return std::nullopt;
    if (*a == regionIndex) return b;
    if (*b == regionIndex) return a;
    return std::nullopt;
}

std::optional<std::size_t> Building::regionAt(Point2 point, double level) const {
    std::optional<std::size_t> best;
    double bestArea = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < regions().size(); ++i) {
        const Region& each = regions()[i];
        if (!sameLevel(each.level, level) || !m_boxes[i] || !holds(*m_boxes[i], point)) continue;
        if (!contains(each.polygon, point)) continue;
        double size = area(each.polygon);
        if (size < bestArea) {
            bestArea = size;
            best = i;
        }
    }
    return best;
}

bool Building::nearLevelChange(std::size_t regionIndex) const {
    return regionIndex < m_nearLevelChange.size() && m_nearLevelChange[regionIndex];
}

std::string nameIn(const Region& region, const std::string& language) {
    return nameFrom(region.extra, language).value_or(region.name);
}

std::string nameIn(const Level& level, const std::string& language) {
    return nameFrom(level.extra, language).value_or(level.name);
}

std::string spokenName(const Region& region, const std::string& language) {
    std::string name = nameIn(region, language);
    if (!name.empty()) return name;
    return region.ref.empty() ? region.id.value : region.ref;
}

std::string regionKindName(RegionKind kind) {
    return nameIn(kRegionKinds, kind);
}
std::optional<RegionKind> regionKindFromName(const std::string& name) {
    return kindIn(kRegionKinds, name);
}
std::string accessKindName(AccessKind kind) {
    return nameIn(kAccessKinds, kind);
}
std::optional<AccessKind> accessKindFromName(const std::string& name) {
    return kindIn(kAccessKinds, name);
}

} // namespace farol::building
