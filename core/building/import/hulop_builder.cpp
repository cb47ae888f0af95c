#include "core/building/import/hulop_builder.h"

#include "core/base/ogr.h"
#include "core/base/text.h"
#include "core/building/import/strips.h"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace farol::building {

namespace {

constexpr std::size_t kMaxNodes = 20000, kMaxLinks = 50000, kMaxFacilities = 20000, kMaxStrips = 600;
constexpr double kFacilitySideM = 2.0, kFarM = 20.0;

Point2 centreOf(const HulopRecords& records) {
    for (const HulopNode& node : records.nodes)
        if (node.at) return *node.at;
    return {};
}

} // namespace

HulopBuilder::HulopBuilder(HulopRecords records, const ImportOptions& options, std::string context)
    : m_records(std::move(records)),
      m_options(options),
      m_context(std::move(context)),
      m_plane(centreOf(m_records)) {}

void HulopBuilder::note(Severity severity, const std::string& rule, const Message& message,
                        const std::string& id) {
    Finding& finding = m_notes[rule];
    if (finding.rule.empty()) finding = {severity, rule, message, m_context, {}};
    finding.ids.push_back(id);
}

std::string HulopBuilder::freeId(const std::string& wish) {
    int number = ++m_ids[wish];
    return number == 1 ? wish : freeId(wish + "#" + std::to_string(number));
}

Result<RawMap> HulopBuilder::build() {
    if (m_records.nodes.size() > kMaxNodes || m_records.links.size() > kMaxLinks ||
        m_records.facilities.size() > kMaxFacilities)
        return Error{ErrorCode::Corrupt, english(Sentence::HulopTooMuch), m_context};
    GdalMessages quiet;
    chooseFloors();
    placeNodes();
    if (m_places.empty())
        return Error{ErrorCode::UnsupportedFormat, english(Sentence::HulopNoNodes), m_context};
    addLinks();
    nameShafts();
    shapeRegions();
    addFacilities();
    for (const std::string& id : m_records.unknown)
        note(Severity::Note, "hulop-unknown", Sentence::HulopUnknown, id);
    note(Severity::Note, "hulop-shapes", Sentence::HulopShapes, m_context);
    m_map.coordinates = RawCoordinates::Geographic;
    m_map.explicitGraph = true;
    std::map<double, Level> levels;
    for (const Region& region : m_map.data.regions) levels[region.level].ordinal = region.level;
    for (auto& [ordinal, level] : levels) {
        level.ref =
            formatNumber(!m_zeroBased && ordinal >= 0.0 ? ordinal + 1.0 : ordinal); // as the source calls it
        m_map.data.levels.push_back(std::move(level));
    }
    m_plane.toDegrees(m_map.data);
    for (auto& [rule, finding] : m_notes) m_map.findings.push_back(std::move(finding));
    return std::move(m_map);
}

/// HULOP's own data count as people do in Japan: 1 is the ground floor, -1 the first below. A file that has a
/// floor 0 counts from 0. --level-from 0 or 1 decides for the user.
void HulopBuilder::chooseFloors() {
    m_zeroBased = std::any_of(m_records.nodes.begin(), m_records.nodes.end(),
                              [](const HulopNode& node) { return node.floorKnown && node.floor == 0.0; });
    bool asked = m_options.levelFrom == "0" || m_options.levelFrom == "1";
    if (asked)
        m_zeroBased = m_options.levelFrom == "0";
    else
        note(Severity::Warning, "hulop-floors",
             m_zeroBased ? Sentence::HulopFloorZero : Sentence::HulopFloorOne, m_context);
}

double HulopBuilder::levelOf(double floor) const {
    return !m_zeroBased && floor > 0.0 ? floor - 1.0 : floor;
}

void HulopBuilder::placeNodes() {
    for (const HulopNode& node : m_records.nodes) {
        if (!node.at || node.id.empty() || m_places.count(node.id) != 0) {
            note(Severity::Warning, "hulop-node", Sentence::HulopNode, node.id);
            continue;
        }
        if (!node.floorKnown) note(Severity::Warning, "hulop-node-floor", Sentence::HulopNodeFloor, node.id);
        Place place;
        place.at = m_plane.toMetres(*node.at);
        place.level = node.floorKnown ? levelOf(node.floor) : 0.0;
        place.region = m_map.data.regions.size();
        Region region;
        region.id = RegionId(freeId(node.id));
        region.level = place.level;
        region.kind = RegionKind::Corridor;
        region.extra = attributesOf(node.tags);
        m_map.data.regions.push_back(std::move(region));
        m_places.emplace(node.id, std::move(place));
    }
}

void HulopBuilder::addLinks() {
    std::set<std::string> seen;
    for (const HulopLink& link : m_records.links)
        if (link.id.empty() || seen.insert(link.id).second) addLink(link);
}

void HulopBuilder::addLink(const HulopLink& link) {
    auto from = m_places.find(link.from), to = m_places.find(link.to);
    if (from == m_places.end() || to == m_places.end() || from == to) {
        note(Severity::Warning, "hulop-link", Sentence::HulopLink, link.id);
        return;
    }
    Place &a = from->second, &b = to->second;
    Polyline line{a.at};
    for (std::size_t i = 1; i + 1 < link.line.size(); ++i) line.push_back(m_plane.toMetres(link.line[i]));
    line.push_back(b.at);
    bool backwards = link.line.size() > 2 && distance(m_plane.toMetres(link.line.front()), a.at) >
                                                 distance(m_plane.toMetres(link.line.front()), b.at);
    if (backwards) std::reverse(line.begin() + 1, line.end() - 1);
    Access access;
    access.id = AccessId(freeId(link.id.empty() ? link.from + "-" + link.to : link.id));
    access.kind = link.kind;
    if (a.level != b.level && !access.changesLevel())
        access.kind = AccessKind::Ramp; // walked, so it must slope
    access.level = a.level;
    access.regionA = m_map.data.regions[a.region].id;
    access.regionB = m_map.data.regions[b.region].id;
    access.oneWay = link.oneWay;
    access.extra = attributesOf(link.tags);
    ++a.links;
    ++b.links;
    if (a.level == b.level && length(line) > 0.0) {
        addStrips(link, line, a, b);
        auto [half, along] = firstHalf(line);
        Point2 side = Point2{-along.y, along.x} * (link.widthM / 2);
        access.line = {half.back() - side, half.back() + side};
        access.widthM = link.widthM;
    } else
        access.line = length(line) < 0.5 ? Polyline{a.at} : line;
    if (access.kind == AccessKind::Elevator)
        for (const Place* place : {&a, &b}) m_map.data.regions[place->region].kind = RegionKind::Elevator;
    m_map.data.accesses.push_back(std::move(access));
}

void HulopBuilder::addStrips(const HulopLink& link, const Polyline& line, Place& from, Place& to) {
    // No place in a building has hundreds of ways: more only cost time.
    if (std::max({line.size(), from.strips.size(), to.strips.size()}) > kMaxStrips) return;
    Polyline back(line.rbegin(), line.rend());
    appendStrip(firstHalf(line).first, link.widthM / 2, from.strips);
    appendStrip(firstHalf(back).first, link.widthM / 2, to.strips);
    from.reachM = std::max(from.reachM, link.widthM / 2);
    to.reachM = std::max(to.reachM, link.widthM / 2);
}

/// Lift links that hang together are one shaft.
void HulopBuilder::nameShafts() {
    std::map<RegionId, RegionId> parent;
    auto root = [&parent](RegionId id) {
        RegionId top = id;
        while (parent.count(top) != 0 && parent[top] != top) top = parent[top];
        while (id != top) id = std::exchange(parent[id], top);
        return top;
    };
    for (const Access& access : m_map.data.accesses) {
        if (access.kind != AccessKind::Elevator) continue;
        RegionId a = root(access.regionA), b = root(access.regionB);
        parent[std::max(a, b)] = parent[std::min(a, b)] = std::min(a, b);
    }
    for (Access& access : m_map.data.accesses)
        if (access.kind == AccessKind::Elevator) access.shaft = ShaftId(root(access.regionA).value);
}

void HulopBuilder::shapeRegions() {
    for (auto& [id, place] : m_places) {
        place.strips.push_back(octagon(place.at, place.reachM));
        m_map.data.regions[place.region].polygon =
            joinedStrips(place.strips).value_or(octagon(place.at, 1.0));
        if (place.links == 0) note(Severity::Warning, "hulop-node-alone", Sentence::HulopNodeAlone, id);
    }
}

void HulopBuilder::addFacilities() {
    std::map<std::string, std::vector<const HulopEntrance*>> entrances;
    for (const HulopEntrance& entrance : m_records.entrances)
        entrances[entrance.facility].push_back(&entrance);
    std::set<std::string> known;
    for (const HulopFacility& facility : m_records.facilities) {
        known.insert(facility.id);
        std::size_t entered = 0;
        if (!facility.pointOfInterest)
            for (const HulopEntrance* entrance : entrances[facility.id]) {
                auto place = m_places.find(entrance->node);
                if (place == m_places.end()) continue;
                addFacilityAt(facility, *entrance, place->second);
                ++entered;
            }
        if (entered > 0) continue;
        addLandmark(facility);
        if (!facility.pointOfInterest)
            note(Severity::Warning, "hulop-facility", Sentence::HulopFacility, facility.id);
    }
    for (const HulopEntrance& entrance : m_records.entrances)
        if (known.count(entrance.facility) == 0)
            note(Severity::Warning, "hulop-entrance", Sentence::HulopEntrance, entrance.id);
}

void HulopBuilder::addFacilityAt(const HulopFacility& facility, const HulopEntrance& entrance,
                                 const Place& place) {
    Point2 towards{0.0, 1.0};
    if (facility.at && distance(m_plane.toMetres(*facility.at), place.at) > 0.1)
        towards = unitVector(m_plane.toMetres(*facility.at) - place.at);
    Point2 side{-towards.y, towards.x};
    // From where the node's own region ends in that direction, so that the two meet and do not overlap much.
    Point2 near = place.at + towards * place.reachM, far = near + towards * kFacilitySideM;
    Point2 half = side * (kFacilitySideM / 2);
    Region region;
    region.id = RegionId(freeId(facility.id));
    region.name = facility.name;
    region.level = place.level;
    region.kind = facility.toilet ? RegionKind::Toilet : RegionKind::Room;
    region.polygon.outer = {near - half, near + half, far + half, far - half};
    region.extra = attributesOf(facility.tags);
    if (signedArea(region.polygon.outer) < 0.0)
        std::reverse(region.polygon.outer.begin(), region.polygon.outer.end());
    Access access;
    access.id = AccessId(freeId(entrance.id.empty() ? "entrance:" + facility.id : entrance.id));
    access.kind = entrance.kind;
    access.doorType = entrance.doorType;
    access.automatic = entrance.automatic;
    access.level = place.level;
    access.regionA = m_map.data.regions[place.region].id;
    access.regionB = region.id;
    access.line = {near - half * 0.5, near + half * 0.5};
    access.extra = attributesOf(entrance.tags);
    if (!entrance.name.empty()) access.extra["name"] = entrance.name;
    m_map.data.regions.push_back(std::move(region));
    m_map.data.accesses.push_back(std::move(access));
}

const HulopBuilder::Place* HulopBuilder::nearestPlace(Point2 at, std::optional<double> level) const {
    const Place* best = nullptr;
    for (const auto& [id, place] : m_places)
        if ((!level || place.level == *level) &&
            (best == nullptr || distance(place.at, at) < distance(best->at, at)))
            best = &place;
    return best;
}

void HulopBuilder::addLandmark(const HulopFacility& facility) {
    if (!facility.at) return;
    Point2 at = m_plane.toMetres(*facility.at);
    std::optional<double> level;
    if (facility.floor) level = levelOf(*facility.floor);
    const Place* near = nearestPlace(at, level);
    if (near == nullptr) near = nearestPlace(at, std::nullopt);
    if (distance(at, near->at) > kFarM) {
        note(Severity::Warning, "hulop-landmark-far", Sentence::HulopLandmarkFar, facility.id);
        return;
    }
    Landmark landmark;
    landmark.id = LandmarkId(freeId(facility.id));
    landmark.kind = facility.kind;
    landmark.kindText =
        facility.kind == Kind::Other ? (facility.kindText.empty() ? "facility" : facility.kindText) : "";
    landmark.text = facility.name;
    landmark.level = near->level;
    landmark.heading = facility.heading;
    landmark.position = at;
    landmark.region = m_map.data.regions[near->region].id;
    landmark.extra = attributesOf(facility.tags);
    m_map.data.landmarks.push_back(std::move(landmark));
}

} // namespace farol::building
