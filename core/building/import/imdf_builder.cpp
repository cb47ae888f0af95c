#include "core/building/import/imdf_builder.h"

#include "core/building/import/imdf_categories.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace farol::building {

namespace {

using Json = nlohmann::json;

/// Text of a tag that holds an array or object; null when it is none.
Json parsed(const std::string& text) {
    return Json::parse(text, nullptr, false);
}

std::vector<std::string> idsIn(const std::string& text) {
    std::vector<std::string> ids;
    Json json = parsed(text);
    if (json.is_array())
        for (const Json& each : json)
            if (each.is_string()) ids.push_back(each.get<std::string>());
    return ids;
}

/// {"id": "...", "feature_type": "unit"}
std::string referenceIn(const Json& json) {
    auto id = json.is_object() ? json.find("id") : json.end();
    return json.is_object() && id != json.end() && id->is_string() ? id->get<std::string>() : std::string();
}

std::string partId(const std::string& id, std::size_t part) {
    return part == 0 ? id : id + "/" + std::to_string(part + 1);
}

bool onePoint(const TaggedFeature& feature, Point2& at) {
    if (!feature.points.empty())
        at = feature.points.front();
    else if (!feature.polygons.empty())
        at = pointInside(feature.polygons.front());
    else if (!feature.lines.empty() && !feature.lines.front().empty())
        at = feature.lines.front().front();
    else
        return false;
    return true;
}

} // namespace

RawMap ImdfBuilder::build() {
    m_map.coordinates = RawCoordinates::Geographic;
    readTitle();
    readLevels();
    readUnits();
    readOccupants();
    readOpenings();
    readAmenities();
    readFixtures();
    readDetails();
    readRelationships();
    for (const char* type : {"section", "geofence"})
        for (const TaggedFeature& feature : files(type))
            tell(Severity::Note, "imdf-not-used", said(Sentence::ImdfNotUsed, type), type, feature.id);
    m_map.findings = m_findings.take();
    return std::move(m_map);
}

const std::vector<TaggedFeature>& ImdfBuilder::files(const std::string& type) const {
    static const std::vector<TaggedFeature> none;
    auto found = m_files.find(type);
    return found == m_files.end() ? none : found->second;
}

void ImdfBuilder::tell(Severity severity, const std::string& rule, const Message& message,
                       const std::string& layer, const std::string& id) {
    m_findings.add(severity, rule, message, layer, id);
}

/// LABELS: an object by language. The wanted one, "pt" also for "pt-PT"; else the first.
std::string ImdfBuilder::label(const TaggedFeature& feature, const std::string& key) const {
    const std::string& text = feature.tag(key);
    if (text.empty() || text.front() != '{') return text;
    Json labels = parsed(text);
    std::string first;
    for (const auto& [language, value] : labels.items()) {
        if (!value.is_string()) continue;
        if (language == m_language) return value.get<std::string>();
        bool related = !m_language.empty() && language.substr(0, 2) == m_language.substr(0, 2);
        if (first.empty() || related) first = value.get<std::string>();
    }
    return first;
}

void ImdfBuilder::readTitle() {
    for (const char* type : {"venue", "building"})
        for (const TaggedFeature& feature : files(type)) {
            if (m_map.data.title.empty()) m_map.data.title = label(feature, "name");
            for (const auto& [key, value] : feature.tags)
                m_map.data.properties.emplace(std::string("imdf_") + type + "_" + key, value);
        }
    if (!m_language.empty()) m_map.data.languages = {m_language};
}

void ImdfBuilder::readLevels() {
    for (const TaggedFeature& feature : files("level")) {
        auto ordinal = plainNumber(feature.tag("ordinal"));
        if (!ordinal || std::abs(*ordinal) > 1000.0)
            tell(Severity::Warning, "imdf-level-ordinal", Sentence::ImdfLevelOrdinal, "levels", feature.id);
        if (!ordinal || std::abs(*ordinal) > 1000.0) ordinal = 0.0;
        m_levels.emplace(feature.id, *ordinal);
        auto same = std::find_if(m_map.data.levels.begin(), m_map.data.levels.end(),
                                 [&](const Level& level) { return level.ordinal == *ordinal; });
        // Inside and outside of a ticket gate are two levels of one floor.
        std::string name = label(feature, "name"), ref = label(feature, "short_name");
        if (same != m_map.data.levels.end()) {
            if (!name.empty() && same->name.find(name) == std::string::npos && same->name.size() < 200)
                same->name += (same->name.empty() ? "" : " / ") + name;
            if (same->ref.empty()) same->ref = ref;
            continue;
        }
        Level level;
        level.ordinal = *ordinal;
        level.name = name;
        level.ref = ref;
        level.extra = attributesOf(feature.tags);
        m_map.data.levels.push_back(std::move(level));
    }
}

double ImdfBuilder::levelOf(const TaggedFeature& feature, const std::string& layer) {
    auto found = m_levels.find(feature.tag("level_id"));
    if (found != m_levels.end()) return found->second;
    tell(Severity::Warning, "imdf-level-id", Sentence::ImdfLevelMissing, layer, feature.id);
    return 0.0;
}

void ImdfBuilder::readUnits() {
    for (const TaggedFeature& unit : files("unit")) readUnit(unit);
}

void ImdfBuilder::readUnit(const TaggedFeature& unit) {
    UnitRole role = imdfUnitRole(unit.tag("category"));
    double level = levelOf(unit, "regions");
    if (!role.known) tell(Severity::Note, "imdf-category", Sentence::ImdfCategory, "regions", unit.id);
    if (!role.walkable) {
        tell(Severity::Note, "imdf-not-walkable", Sentence::ImdfNotWalkable, "walls", unit.id);
        addWalls(unit, level);
        return;
    }
    if (unit.polygons.empty()) {
        tell(Severity::Warning, "imdf-unit-outline", Sentence::ImdfUnitOutline, "regions", unit.id);
        return;
    }
    if (unit.polygons.size() > 1)
        tell(Severity::Warning, "region-split", Sentence::RegionsSplit, "regions", unit.id);
    m_units.emplace(unit.id, m_map.data.regions.size());
    for (std::size_t part = 0; part < unit.polygons.size(); ++part) {
        Region region;
        region.id = RegionId(partId(unit.id, part));
        region.level = level;
        region.name = label(unit, "name");
        region.kind = role.kind;
        region.restricted = role.restricted || !unit.tag("restriction").empty();
        region.polygon = unit.polygons[part];
        region.extra = attributesOf(unit.tags);
        m_map.data.regions.push_back(std::move(region));
    }
}

void ImdfBuilder::addWalls(const TaggedFeature& feature, double level) {
    auto add = [&](Polyline line) {
        m_map.data.walls.push_back({level, std::move(line), attributesOf(feature.tags)});
    };
    for (const Polygon& polygon : feature.polygons) {
        std::vector<Ring> rings = polygon.holes;
        rings.insert(rings.begin(), polygon.outer);
        for (Ring& ring : rings) {
            if (ring.empty()) continue;
            ring.push_back(ring.front());
            add(std::move(ring));
        }
    }
    for (const Polyline& line : feature.lines) add(line);
}

void ImdfBuilder::readOccupants() {
    std::map<std::string, std::string> unitOfAnchor;
    for (const TaggedFeature& anchor : files("anchor"))
        unitOfAnchor.emplace(anchor.id, anchor.tag("unit_id"));
    for (const TaggedFeature& occupant : files("occupant")) {
        auto anchor = unitOfAnchor.find(occupant.tag("anchor_id"));
        auto unit = anchor == unitOfAnchor.end() ? m_units.end() : m_units.find(anchor->second);
        if (unit == m_units.end()) {
            tell(Severity::Warning, "imdf-occupant-anchor", Sentence::ImdfOccupantAnchor, "regions",
                 occupant.id);
            continue;
        }
        Region& region = m_map.data.regions[unit->second];
        std::string name = label(occupant, "name");
        if (region.name.empty()) region.name = name;
        AttributeValue& kept = region.extra["occupant"];
        const auto* before = std::get_if<std::string>(&kept);
        kept = before == nullptr ? name : *before + "; " + name;
        AttributeValue& category = region.extra["occupant_category"];
        if (std::holds_alternative<std::monostate>(category)) category = occupant.tag("category");
    }
}

void ImdfBuilder::readOpenings() {
    for (const TaggedFeature& opening : files("opening")) readOpening(opening);
}

void ImdfBuilder::readOpening(const TaggedFeature& opening) {
    Json door = parsed(opening.tag("door"));
    auto member = [&](const char* key) {
        return door.is_object() && door.contains(key) ? door[key] : Json();
    };
    Access access;
    // A door that is not described may still be there: it is announced as one.
    access.kind = member("type") == "open" ? AccessKind::Opening : AccessKind::Door;
    if (member("type").is_string()) access.doorType = member("type").get<std::string>();
    access.automatic = member("automatic") == true;
    access.level = levelOf(opening, "accesses");
    access.extra = attributesOf(opening.tags);
    const std::string& category = opening.tag("category");
    if (category == "emergencyexit" || category == "automobile" || category == "bicycle" ||
        opening.tag("access_control").find("outofservice") != std::string::npos) {
        access.closed = true;
        tell(Severity::Note, "imdf-opening-closed", Sentence::ImdfOpeningClosed, "accesses", opening.id);
    }
    if (opening.lines.empty()) {
        tell(Severity::Warning, "imdf-opening-line", Sentence::ImdfOpeningLine, "accesses", opening.id);
        return;
    }
    m_openings.emplace(opening.id, m_map.data.accesses.size());
    for (std::size_t part = 0; part < opening.lines.size(); ++part) {
        access.id = AccessId(partId(opening.id, part));
        access.line = opening.lines[part];
        m_map.data.accesses.push_back(access);
    }
}

void ImdfBuilder::readAmenities() {
    for (const TaggedFeature& amenity : files("amenity")) readAmenity(amenity);
}

void ImdfBuilder::readAmenity(const TaggedFeature& amenity) {
    Landmark landmark;
    landmark.id = LandmarkId(amenity.id);
    landmark.kind = imdfAmenityKind(amenity.tag("category"));
    if (landmark.kind == Kind::Other) landmark.kindText = amenity.tag("category");
    landmark.text = label(amenity, "name");
    landmark.extra = attributesOf(amenity.tags);
    if (!onePoint(amenity, landmark.position)) {
        tell(Severity::Warning, "imdf-amenity-point", Sentence::ImdfAmenityPoint, "landmarks", amenity.id);
        return;
    }
    std::set<double> levels;
    for (const std::string& id : idsIn(amenity.tag("unit_ids"))) {
        auto unit = m_units.find(id);
        if (unit == m_units.end()) continue;
        const Region& region = m_map.data.regions[unit->second];
        levels.insert(region.level);
        if (landmark.region.empty() && contains(region.polygon, landmark.position))
            landmark.region = region.id;
    }
    for (const auto& [id, ordinal] : m_levels)
        if (levels.empty() || m_levels.size() == 1) levels.insert(ordinal);
    if (levels.size() != 1) {
        std::set<double> over;
        for (const Region& region : m_map.data.regions)
            if (levels.count(region.level) != 0 && contains(region.polygon, landmark.position))
                over.insert(region.level);
        if (over.size() == 1) levels = over;
    }
    if (levels.size() != 1)
        tell(Severity::Warning, "imdf-amenity-level", Sentence::ImdfAmenityLevel, "landmarks", amenity.id);
    if (levels.size() != 1) return;
    landmark.level = *levels.begin();
    m_map.data.landmarks.push_back(std::move(landmark));
}

void ImdfBuilder::readFixtures() {
    for (const char* type : {"fixture", "kiosk"})
        for (const TaggedFeature& fixture : files(type)) {
            Landmark landmark;
            landmark.id = LandmarkId(fixture.id);
            landmark.kind = Kind::Furniture;
            landmark.text = label(fixture, "name");
            landmark.level = levelOf(fixture, "landmarks");
            landmark.extra = attributesOf(fixture.tags);
            if (onePoint(fixture, landmark.position)) m_map.data.landmarks.push_back(std::move(landmark));
        }
}

void ImdfBuilder::readDetails() {
    for (const TaggedFeature& detail : files("detail")) addWalls(detail, levelOf(detail, "walls"));
}

void ImdfBuilder::readRelationships() {
    for (const TaggedFeature& relationship : files("relationship")) readRelationship(relationship);
}

void ImdfBuilder::readRelationship(const TaggedFeature& relationship) {
    std::vector<std::string> steps{referenceIn(parsed(relationship.tag("origin")))};
    Json between = parsed(relationship.tag("intermediary"));
    if (between.is_array())
        for (const Json& each : between) steps.push_back(referenceIn(each));
    steps.push_back(referenceIn(parsed(relationship.tag("destination"))));
    bool directed = relationship.is("direction", "directed");
    auto change = imdfLevelChange(relationship.tag("category"));
    if (!change) {
        if (directed) directOpening(steps);
        return;
    }
    std::erase_if(steps, [this](const std::string& id) { return m_units.count(id) == 0; });
    if (steps.size() < 2)
        tell(Severity::Warning, "imdf-relationship", Sentence::ImdfRelationship, "accesses", relationship.id);
    for (std::size_t i = 1; i < steps.size(); ++i) {
        RawMap::VerticalLink link;
        link.from = RegionId(steps[i - 1]);
        link.to = RegionId(steps[i]);
        link.kind = *change;
        link.oneWay = directed ? OneWay::AToB : OneWay::No;
        link.shaft = ShaftId(relationship.id);
        m_map.verticalLinks.push_back(std::move(link));
    }
}

/// A directed traversal from a unit through an opening to a unit: the opening is one way.
void ImdfBuilder::directOpening(const std::vector<std::string>& steps) {
    if (steps.size() != 3 || m_units.count(steps[0]) == 0 || m_units.count(steps[2]) == 0) return;
    auto opening = m_openings.find(steps[1]);
    if (opening == m_openings.end()) return;
    Access& access = m_map.data.accesses[opening->second];
    access.regionA = RegionId(steps[0]);
    access.regionB = RegionId(steps[2]);
    access.oneWay = OneWay::AToB;
}

} // namespace farol::building
