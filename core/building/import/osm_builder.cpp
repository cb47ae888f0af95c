#include "core/building/import/osm_builder.h"

#include "core/base/ogr.h"
#include "core/base/text.h"
#include "core/building/import/level_parser.h"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>

namespace farol::building {

namespace {

constexpr std::size_t kMaxRegions = 20000, kMaxMeetings = 200000;
constexpr double kWalkWidthM = 2.0;
constexpr double kLeastAreaM2 = 0.5;
constexpr double kLiftSideM = 1.6;
constexpr double kLandmarkReachM = 3.0;

Point2 centreOf(const std::vector<TaggedFeature>& features) {
    for (const TaggedFeature& feature : features) {
        bool inside = feature.has("indoor") || feature.has("level");
        if (inside && !feature.polygons.empty()) return feature.polygons.front().outer.front();
        if (inside && !feature.lines.empty()) return feature.lines.front().front();
        if (inside && !feature.points.empty()) return feature.points.front();
    }
    return {};
}

Ring square(Point2 at, double side) {
    double h = side / 2;
    return {{at.x - h, at.y - h}, {at.x + h, at.y - h}, {at.x + h, at.y + h}, {at.x - h, at.y + h}};
}

} // namespace

OsmBuilder::OsmBuilder(std::vector<TaggedFeature> features, const ImportOptions& options, std::string context)
    : m_features(std::move(features)),
      m_language(options.language),
      m_context(std::move(context)),
      m_plane(centreOf(m_features)) {}

OsmBuilder::NodeKey OsmBuilder::keyOf(Point2 degrees) {
    return {std::llround(degrees.x * 1e7), std::llround(degrees.y * 1e7)};
}

Error OsmBuilder::tooMuch() const {
    return {ErrorCode::Corrupt, english(Sentence::OsmTooMuch), m_context};
}

Result<RawMap> OsmBuilder::build() {
    m_map.coordinates = RawCoordinates::Geographic;
    m_map.openBoundaries = true;
    addAreas();
    addLifts();
    collectWalkLines();
    addWalkRegions();
    if (m_tooMuch) return tooMuch();
    if (m_map.data.regions.empty())
        return Error{ErrorCode::UnsupportedFormat, english(Sentence::OsmNoIndoor), m_context};
    addDoors();
    addRoomOpenings();
    if (m_tooMuch) return tooMuch();
    joinLonelyLifts();
    addSteps();
    addWalkways();
    if (m_tooMuch) return tooMuch();
    addWalls();
    addLandmarks();
    addLevelRows();
    m_plane.toDegrees(m_map.data);
    for (auto& [key, finding] : m_notes) m_map.findings.push_back(std::move(finding));
    return std::move(m_map);
}

void OsmBuilder::note(Severity severity, const std::string& rule, const Message& message,
                      const std::string& id) {
    Finding& finding = m_notes[rule];
    if (finding.rule.empty()) finding = {severity, rule, message, m_context, {}};
    if (finding.ids.empty() || finding.ids.back() != id) finding.ids.push_back(id);
}

std::vector<double> OsmBuilder::levelsOf(const TaggedFeature& feature) {
    ParsedLevels levels = parseLevels(feature.tag("level"));
    ParsedLevels repeated = parseLevels(feature.tag("repeat_on"));
    if (!levels.understood || !repeated.understood)
        note(Severity::Warning, "osm-level-unreadable", Sentence::OsmLevelUnreadable, feature.id);
    levels.levels.insert(levels.levels.end(), repeated.levels.begin(), repeated.levels.end());
    std::sort(levels.levels.begin(), levels.levels.end());
    levels.levels.erase(std::unique(levels.levels.begin(), levels.levels.end()), levels.levels.end());
    return levels.levels;
}

std::vector<double> OsmBuilder::levelsOrGround(const TaggedFeature& feature) {
    std::vector<double> levels = levelsOf(feature);
    if (!levels.empty()) return levels;
    note(Severity::Warning, "osm-level-missing", Sentence::OsmLevelMissing, feature.id);
    return {0.0};
}

std::size_t OsmBuilder::addRegion(Region region, bool walled) {
    std::size_t index = m_map.data.regions.size();
    m_boxes.push_back(boundingBox(region.polygon.outer).value_or(Box2{}));
    m_walled.push_back(walled);
    m_onLevel[region.level].push_back(index);
    m_map.data.regions.push_back(std::move(region));
    m_tooMuch = m_tooMuch || index >= kMaxRegions;
    return index;
}

void OsmBuilder::addAreas() {
    std::set<std::string> seen;
    for (const TaggedFeature& feature : m_features) {
        auto role = feature.polygons.empty() ? std::nullopt : osmRegionRole(feature);
        if (role && !m_tooMuch && seen.insert(feature.id).second) addArea(feature, *role);
    }
}

void OsmBuilder::addArea(const TaggedFeature& feature, const RegionRole& role) {
    std::vector<double> levels = levelsOrGround(feature);
    for (std::size_t part = 0; part < feature.polygons.size(); ++part) {
        const Polygon& source = feature.polygons[part];
        std::vector<RegionId> stack;
        Region region;
        region.kind = role.kind;
        region.kindText = role.kindText;
        region.name = nameOf(feature, m_language);
        region.ref = feature.tag("ref");
        region.restricted = isOsmRestricted(feature);
        region.extra = attributesOf(feature.tags);
        for (Point2 p : source.outer) region.polygon.outer.push_back(m_plane.toMetres(p));
        for (const Ring& hole : source.holes) {
            region.polygon.holes.emplace_back();
            for (Point2 p : hole) region.polygon.holes.back().push_back(m_plane.toMetres(p));
        }
        for (double level : levels) {
            if (m_tooMuch) return;
            std::string id = feature.id + (feature.polygons.size() > 1 ? "#" + std::to_string(part + 1) : "");
            region.id = RegionId(levels.size() > 1 ? id + "@" + formatNumber(level) : id);
            region.level = level;
            stack.push_back(region.id);
            std::size_t index = addRegion(region, role.walled);
            const Ring& metres = region.polygon.outer;
            for (std::size_t i = 0; i < metres.size(); ++i)
                m_corners.insert(
                    {keyOf(source.outer[i]), Corner{index, metres[(i + metres.size() - 1) % metres.size()],
                                                    metres[(i + 1) % metres.size()]}});
        }
        if (role.kind == RegionKind::Elevator) linkLevels(stack, AccessKind::Elevator, feature.id);
        if (role.kind == RegionKind::Stairwell) linkLevels(stack, AccessKind::Stairs, feature.id);
    }
}

void OsmBuilder::linkLevels(const std::vector<RegionId>& stack, AccessKind kind, const std::string& shaft) {
    for (std::size_t i = 1; i < stack.size(); ++i) {
        if (!m_linked.insert({stack[i - 1], stack[i]}).second) continue;
        RawMap::VerticalLink link;
        link.from = stack[i - 1];
        link.to = stack[i];
        link.kind = kind;
        link.shaft = ShaftId(shaft);
        m_map.verticalLinks.push_back(std::move(link));
    }
}

void OsmBuilder::addLifts() {
    for (const TaggedFeature& feature : m_features)
        if (isOsmLift(feature) && !m_tooMuch)
            for (Point2 at : feature.points) addLift(feature, m_plane.toMetres(at));
}

void OsmBuilder::addLift(const TaggedFeature& feature, Point2 at) {
    std::vector<double> levels = levelsOrGround(feature);
    std::vector<RegionId> stack;
    for (double level : levels) {
        auto car = regionAt(at, level, 0.5);
        Region* known = car ? &m_map.data.regions[*car] : nullptr;
        if (known != nullptr && known->kind == RegionKind::Elevator) {
            if (known->name.empty()) known->name = nameOf(feature, m_language);
            if (known->ref.empty()) known->ref = feature.tag("ref");
            stack.push_back(known->id);
            continue;
        }
        Region region;
        region.id = RegionId(feature.id + (levels.size() > 1 ? "@" + formatNumber(level) : ""));
        region.kind = RegionKind::Elevator;
        region.level = level;
        region.name = nameOf(feature, m_language);
        region.ref = feature.tag("ref");
        region.restricted = isOsmRestricted(feature);
        region.extra = attributesOf(feature.tags);
        region.polygon.outer = square(at, kLiftSideM);
        stack.push_back(region.id);
        addRegion(std::move(region), true);
        note(Severity::Note, "osm-lift-size", Sentence::OsmLiftPoint, feature.id);
    }
    linkLevels(stack, AccessKind::Elevator, feature.id);
}

void OsmBuilder::collectWalkLines() {
    for (const TaggedFeature& feature : m_features) {
        bool oneLevelSteps = isOsmSteps(feature) && levelsOf(feature).size() == 1;
        auto role = oneLevelSteps ? RegionRole{RegionKind::Stairwell, "", false} : osmWalkRole(feature);
        if (!role || (!feature.polygons.empty() && osmRegionRole(feature)) || isOsmMovingWalkway(feature))
            continue;
        std::vector<Polyline> lines = feature.lines;
        for (const Polygon& ring : feature.polygons) {
            lines.push_back(ring.outer);
            lines.back().push_back(ring.outer.front());
        }
        for (Polyline& line : lines) {
            for (Point2& point : line) point = m_plane.toMetres(point);
            for (double level : levelsOrGround(feature))
                if (m_walks.size() < kMaxRegions) m_walks.push_back({&feature, *role, level, line});
        }
    }
    m_tooMuch = m_tooMuch || m_walks.size() >= kMaxRegions;
}

void OsmBuilder::addWalkRegions() {
    std::set<double> levels;
    for (const WalkLine& walk : m_walks) levels.insert(walk.level);
    for (double level : levels)
        if (!m_tooMuch) addWalkRegionsOf(level);
}

/// The areas in whose boxes the line runs, as one; null when there are none.
GeometryPtr OsmBuilder::areasNear(const Polyline& line, const std::vector<std::size_t>& areas, double reach) {
    std::vector<GeometryPtr> parts;
    Box2 box = boundingBox(line).value_or(Box2{});
    for (std::size_t index : areas) {
        const Box2& area = m_boxes[index];
        bool meet = box.low.x - reach <= area.high.x && area.low.x <= box.high.x + reach &&
                    box.low.y - reach <= area.high.y && area.low.y <= box.high.y + reach;
        if (!meet) continue;
        if (!mayMeet()) return nullptr;
        if (auto polygon = ogrPolygon(m_map.data.regions[index].polygon)) parts.push_back(std::move(polygon));
    }
    return unionOf(parts);
}

/// Counts what lines and areas have to do with each other: a real building is far below the limit.
bool OsmBuilder::mayMeet() {
    m_tooMuch = m_tooMuch || ++m_meetings > kMaxMeetings;
    return !m_tooMuch;
}

// The part of a walked line outside every area becomes a strip of the line's width; strips that meet are one
// corridor.
void OsmBuilder::addWalkRegionsOf(double level) {
    GdalMessages quiet;
    const std::vector<std::size_t> areas = m_onLevel[level];
    std::map<std::string, std::vector<GeometryPtr>> strips;
    for (const WalkLine& walk : m_walks) {
        if (walk.level != level) continue;
        double width = std::clamp(plainNumber(walk.feature->tag("width")).value_or(kWalkWidthM), 0.5, 10.0);
        GeometryPtr covered = areasNear(walk.line, areas, width);
        if (m_tooMuch) return;
        GeometryPtr line = ogrLine(walk.line);
        if (covered != nullptr && line != nullptr) line.reset(line->Difference(covered.get()));
        if (line == nullptr || line->IsEmpty() != FALSE) continue;
        GeometryPtr strip(line->Buffer(width / 2, 2));
        if (covered != nullptr && strip != nullptr) strip.reset(strip->Difference(covered.get()));
        bool plain = walk.role.kind == RegionKind::Corridor;
        if (strip != nullptr) strips[plain ? "" : walk.feature->id].push_back(std::move(strip));
    }
    for (const auto& [id, parts] : strips) {
        GeometryPtr joined = unionOf(parts);
        std::size_t number = 0;
        for (Polygon& polygon : polygonsOf(joined.get(), kLeastAreaM2)) {
            Region region;
            ++number;
            region.id = RegionId((id.empty() ? "corridor" : id) + "@" + formatNumber(level) + "#" +
                                 std::to_string(number));
            region.level = level;
            region.kind = RegionKind::Corridor;
            auto walk = std::find_if(m_walks.begin(), m_walks.end(),
                                     [&id = id](const WalkLine& w) { return w.feature->id == id; });
            if (walk != m_walks.end()) {
                region.kind = walk->role.kind;
                region.kindText = walk->role.kindText;
                region.name = nameOf(*walk->feature, m_language);
                region.extra = attributesOf(walk->feature->tags);
            }
            region.polygon = std::move(polygon);
            addRegion(std::move(region), false);
        }
    }
}

void OsmBuilder::addWalls() {
    auto add = [this](double level, Polyline line) {
        m_map.data.walls.push_back({level, std::move(line), {}});
    };
    for (std::size_t i = 0; i < m_map.data.regions.size(); ++i) {
        if (!m_walled[i]) continue;
        Polyline line = m_map.data.regions[i].polygon.outer;
        line.push_back(line.front());
        add(m_map.data.regions[i].level, std::move(line));
    }
    for (const TaggedFeature& feature : m_features) {
        if (!isOsmWall(feature)) continue;
        std::vector<Polyline> lines = feature.lines;
        for (const Polygon& polygon : feature.polygons) {
            lines.push_back(polygon.outer);
            lines.back().push_back(polygon.outer.front());
        }
        for (Polyline& line : lines) {
            for (Point2& point : line) point = m_plane.toMetres(point);
            for (double level : levelsOrGround(feature))
                if (m_map.data.walls.size() < kMaxRegions) add(level, line);
        }
    }
}

void OsmBuilder::addLandmarks() {
    for (const TaggedFeature& feature : m_features) {
        auto role = feature.points.empty() ? std::nullopt : osmLandmarkRole(feature);
        if (!role || m_map.data.landmarks.size() >= kMaxRegions) continue;
        Point2 at = m_plane.toMetres(feature.points.front());
        std::vector<double> levels = levelsOf(feature);
        if (levels.empty())
            for (const auto& [level, regions] : m_onLevel)
                if (regionAt(at, level, 0.0)) levels.push_back(level);
        if (levels.size() != 1 && !feature.has("level")) {
            note(Severity::Warning, "osm-landmark-level", Sentence::OsmLandmarkLevel, feature.id);
            continue;
        }
        for (double level : levels) {
            if (!regionAt(at, level, kLandmarkReachM)) {
                note(Severity::Warning, "osm-landmark-outside", Sentence::OsmLandmarkOutside, feature.id);
                continue;
            }
            Landmark landmark;
            landmark.id = LandmarkId(feature.id + (levels.size() > 1 ? "@" + formatNumber(level) : ""));
            landmark.kind = role->kind;
            landmark.kindText = role->kindText;
            landmark.text = nameOf(feature, m_language);
            landmark.level = level;
            landmark.position = at;
            if (auto region = regionAt(at, level, 0.5)) landmark.region = m_map.data.regions[*region].id;
            landmark.extra = attributesOf(feature.tags);
            m_map.data.landmarks.push_back(std::move(landmark));
        }
    }
}

void OsmBuilder::addLevelRows() {
    std::map<double, Level> rows;
    for (const auto& [level, regions] : m_onLevel) rows[level].ordinal = level;
    std::map<double, std::map<std::string, int>> refs;
    for (const TaggedFeature& feature : m_features) {
        std::vector<double> levels = parseLevels(feature.tag("level")).levels;
        if (levels.size() != 1 || rows.count(levels.front()) == 0) continue;
        if (feature.has("level:ref")) ++refs[levels.front()][feature.tag("level:ref")];
        if (feature.is("indoor", "level")) {
            rows[levels.front()].name = nameOf(feature, m_language);
            rows[levels.front()].heightM = plainNumber(feature.tag("height"));
        }
    }
    for (auto& [ordinal, row] : rows) {
        int most = 0; // what most features call the floor
        for (const auto& [ref, count] : refs[ordinal])
            if (count > most) row.ref = ref, most = count;
        m_map.data.levels.push_back(std::move(row));
    }
}

} // namespace farol::building
