#include "core/base/ogr.h"
#include "core/base/text.h"
#include "core/building/import/finishing.h"
#include "core/building/import/local_plane.h"
#include "core/building/level_regions.h"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>
#include <unordered_set>

namespace farol::building {

namespace {

constexpr double kLeastOverlap = 0.5; ///< of the smaller of two regions above each other

bool isEscalator(const Region& region) {
    if (region.kindText == "moving_walkway") return false; // it stays on its level
    for (const char* key : {"category", "conveying", "highway"}) {
        auto found = region.extra.find(key);
        const auto* text = found == region.extra.end() ? nullptr : std::get_if<std::string>(&found->second);
        if (text != nullptr && (text->find("escalator") != std::string::npos ||
                                (std::string(key) == "conveying" && *text != "no" && !text->empty())))
            return true;
    }
    return region.kindText == "escalator";
}

/// The way an escalator drawn as an area runs, where an attribute tells.
std::optional<bool> directionOf(const Region& region) {
    for (const auto& [key, value] : region.extra) {
        const auto* text = std::get_if<std::string>(&value);
        bool told = key == "direction" || key == "oneway" || key == "conveying" || key == "sentido";
        if (text == nullptr || !told) continue;
        if (auto up = climbDirection(*text)) return up;
    }
    return std::nullopt;
}

/// Area of both, and a point inside what they share.
std::pair<double, Point2> sharedArea(const Region& a, const Region& b) {
    GdalMessages quiet;
    GeometryPtr first = ogrPolygon(a.polygon), second = ogrPolygon(b.polygon);
    GeometryPtr both(first != nullptr && second != nullptr ? first->Intersection(second.get()) : nullptr);
    double sum = 0.0, largest = 0.0;
    Point2 inside = pointInside(a.polygon);
    for (const Polygon& part : polygonsOf(both.get(), 1e-4)) {
        double size = area(part);
        sum += size;
        if (size <= largest) continue;
        largest = size;
        inside = pointInside(part);
    }
    return {sum, inside};
}

class LevelJoiner {
public:
    LevelJoiner(RawMap& raw, FindingList& findings)
        : m_raw(raw), m_findings(findings), m_index(raw.data.regions) {
        for (std::size_t i = 0; i < raw.data.regions.size(); ++i)
            m_position.emplace(raw.data.regions[i].id.value, i);
        for (const Access& access : raw.data.accesses) m_accessIds.insert(access.id.value);
        m_parent.resize(raw.data.regions.size());
        for (std::size_t i = 0; i < m_parent.size(); ++i) m_parent[i] = i;
    }

    void run(bool byOverlap) {
        rememberKnown();
        for (const RawMap::VerticalLink& link : m_raw.verticalLinks) addLink(link);
        if (byOverlap) stack();
        nameShafts();
    }

private:
    void rememberKnown() {
        for (const Access& access : m_raw.data.accesses) {
            auto a = m_position.find(access.regionA.value), b = m_position.find(access.regionB.value);
            if (a == m_position.end() || b == m_position.end() || !access.changesLevel()) continue;
            // A few steps, or the way into a stairwell, lead to no other level.
            if (m_raw.data.regions[a->second].level == m_raw.data.regions[b->second].level) continue;
            (void)isNew(a->second, b->second, access.oneWay);
            m_climbing.insert(a->second);
            m_climbing.insert(b->second);
        }
    }

    /// Two escalators side by side join the same regions, one upwards and one downwards.
    bool isNew(std::size_t from, std::size_t to, OneWay way) {
        if (way == OneWay::BToA) std::swap(from, to);
        bool both = way == OneWay::No;
        bool forth = m_joined.insert({from, to}).second;
        bool back = both && m_joined.insert({to, from}).second;
        return forth || back;
    }

    void addLink(const RawMap::VerticalLink& link) {
        auto from = m_position.find(link.from.value), to = m_position.find(link.to.value);
        if (from == m_position.end() || to == m_position.end()) {
            m_findings.add(Severity::Warning, "level-link-regions", Sentence::LevelLinksNowhere, "accesses",
                           link.from.value + " - " + link.to.value);
            return;
        }
        join(from->second, to->second, link);
    }

    void join(std::size_t from, std::size_t to, const RawMap::VerticalLink& link) {
        if (from == to || !isNew(from, to, link.oneWay)) return;
        const Region &low = m_raw.data.regions[from], &high = m_raw.data.regions[to];
        Access access;
        access.kind = link.kind;
        access.level = low.level;
        access.regionA = low.id;
        access.regionB = high.id;
        access.oneWay = link.oneWay;
        access.shaft = link.shaft;
        access.steps = link.steps;
        access.line = {sharedArea(low, high).second};
        std::string id = low.id.value + "-" + high.id.value;
        while (!m_accessIds.insert(id).second) id += "'";
        access.id = AccessId(id);
        m_climbing.insert(from);
        m_climbing.insert(to);
        m_parent[rootOf(from)] = rootOf(to);
        m_added.emplace_back(m_raw.data.accesses.size(), from);
        m_raw.data.accesses.push_back(std::move(access));
    }

    std::size_t rootOf(std::size_t region) {
        while (m_parent[region] != region) region = m_parent[region] = m_parent[m_parent[region]];
        return region;
    }

    void stack() {
        std::set<std::size_t> told = m_climbing; // what the source itself joins is left as it says
        std::vector<double> levels = m_index.levels();
        for (std::size_t i = 0; i < m_raw.data.regions.size(); ++i) {
            const Region& region = m_raw.data.regions[i];
            auto kind = shaftKind(region);
            if (!kind || told.count(i) != 0) continue;
            for (double level : levels) {
                if (level <= region.level + 1e-6) continue;
                // A lift may pass a floor; stairs lead to the next one.
                if (*kind != AccessKind::Elevator && level > region.level + 1.0 + 1e-6) break;
                if (joinAbove(i, level, *kind, told)) break;
            }
        }
    }

    bool joinAbove(std::size_t low, double level, AccessKind kind, const std::set<std::size_t>& told) {
        const Region& region = m_raw.data.regions[low];
        std::optional<std::size_t> best;
        double most = 0.0;
        for (std::size_t high : m_index.meeting(level, *boundingBox(region.polygon.outer))) {
            const Region& above = m_raw.data.regions[high];
            if (shaftKind(above) != kind || told.count(high) != 0) continue;
            double smaller = std::min(area(region.polygon), area(above.polygon));
            double share = smaller > 0.0 ? sharedArea(region, above).first / smaller : 0.0;
            if (share < kLeastOverlap || share <= most) continue;
            most = share;
            best = high;
        }
        if (!best) return false;
        RawMap::VerticalLink link;
        link.kind = kind;
        for (std::size_t each : {low, *best})
            if (auto up = directionOf(m_raw.data.regions[each]); up && kind == AccessKind::Escalator)
                link.oneWay = *up ? OneWay::AToB : OneWay::BToA;
        join(low, *best, link);
        m_findings.add(Severity::Note, "level-link-overlap", Sentence::LevelsJoined, "accesses",
                       m_raw.data.accesses.back().id.value);
        return true;
    }

    void nameShafts() {
        std::map<std::size_t, std::string> names; // root -> first name in order of ids
        for (const auto& [access, region] : m_added) {
            std::string& name = names[rootOf(region)];
            const std::string& own = m_raw.data.accesses[access].shaft.value;
            std::string wish = own.empty() ? m_raw.data.regions[region].id.value : own;
            if (name.empty() || naturalLess(wish, name)) name = wish;
        }
        for (const auto& [access, region] : m_added)
            if (m_raw.data.accesses[access].shaft.empty())
                m_raw.data.accesses[access].shaft = ShaftId(names[rootOf(region)]);
    }

    RawMap& m_raw;
    FindingList& m_findings;
    LevelRegions m_index;
    std::unordered_map<std::string, std::size_t> m_position;
    std::unordered_set<std::string> m_accessIds;
    std::set<std::pair<std::size_t, std::size_t>> m_joined; ///< that one can get from the first to the second
    std::set<std::size_t> m_climbing;
    std::vector<std::size_t> m_parent;
    std::vector<std::pair<std::size_t, std::size_t>> m_added; ///< access and its lower region
};

const char* kindWord(RegionKind kind) {
    switch (kind) {
    case RegionKind::Room:
        return "Room";
    case RegionKind::Corridor:
        return "Corridor";
    case RegionKind::Hall:
        return "Hall";
    case RegionKind::Stairwell:
        return "Stairs";
    case RegionKind::Elevator:
        return "Lift";
    case RegionKind::Toilet:
        return "Toilet";
    case RegionKind::Outside:
        return "Outside";
    case RegionKind::Other:
        break;
    }
    return "Area";
}

} // namespace

std::optional<AccessKind> shaftKind(const Region& region) {
    if (region.kind == RegionKind::Elevator) return AccessKind::Elevator;
    if (isEscalator(region)) return AccessKind::Escalator;
    if (region.kind == RegionKind::Stairwell) return AccessKind::Stairs;
    return std::nullopt;
}

void joinLevels(RawMap& raw, bool byOverlap, FindingList& findings) {
    LevelJoiner(raw, findings).run(byOverlap);
}

void nameRegions(BuildingData& data, FindingList& findings) {
    std::set<std::string> used;
    std::vector<Region*> unnamed;
    for (Region& region : data.regions) {
        if (region.name.empty() && region.ref.empty())
            unnamed.push_back(&region);
        else
            used.insert(formatNumber(region.level) + "|" + foldedForMatching(region.name));
    }
    std::stable_sort(unnamed.begin(), unnamed.end(),
                     [](const Region* a, const Region* b) { return naturalLess(a->id.value, b->id.value); });
    std::map<std::string, int> numbers;
    for (Region* region : unnamed) {
        std::string level = formatNumber(region->level), word = kindWord(region->kind), name;
        int& number = numbers[level + "|" + word];
        do name = word + " " + std::to_string(++number);
        while (!used.insert(level + "|" + foldedForMatching(name)).second);
        region->name = name;
        findings.add(Severity::Note, "region-named", Sentence::RegionsGivenNames, "regions",
                     region->id.value);
    }
}

} // namespace farol::building
