#include "core/building/import/indoorgml_builder.h"

#include "core/base/ogr.h"
#include "core/base/text.h"
#include "core/building/import/height_levels.h"
#include "core/building/import/level_parser.h"
#include "core/building/import/tagged_feature.h"

#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace farol::building {

namespace {

constexpr std::size_t kMaxCells = 50000;

std::string withoutReverse(std::string reference) {
    reference.erase(0, reference.find('#') == std::string::npos ? 0 : reference.find('#') + 1);
    const std::string suffix = "-REVERSE";
    std::size_t start =
        reference.size() >= suffix.size() ? reference.size() - suffix.size() : std::string::npos;
    if (start != std::string::npos && foldedForMatching(reference.substr(start)) == suffix)
        reference.erase(start);
    return reference;
}

/// The value of `storey="1":indoor="room":` or `level=2;desc=;`.
std::string describedValue(const std::string& description, const std::string& key) {
    std::string folded = foldedForMatching(description), wanted = foldedForMatching(key);
    for (std::size_t at = folded.find(wanted); at != std::string::npos; at = folded.find(wanted, at + 1)) {
        bool word = at == 0 || std::isalnum(static_cast<unsigned char>(folded[at - 1])) == 0;
        std::size_t end = folded.find_first_not_of(' ', at + wanted.size());
        if (!word || end == std::string::npos || folded[end] != '=') continue;
        std::string value = folded.substr(end + 1);
        value.erase(0, std::min(value.find_first_not_of(" \"'"), value.size()));
        value.erase(std::min(value.find_first_of("\"';:"), value.size()));
        value.erase(value.find_last_not_of(' ') + 1);
        return value;
    }
    return {};
}

bool hasWord(const std::string& text, std::initializer_list<const char*> words) {
    return std::any_of(words.begin(), words.end(),
                       [&text](const char* word) { return text.find(word) != std::string::npos; });
}

/// By the code list of the standard's annex where it is known, else by words.
RegionKind kindOf(const XmlNode& cell) {
    std::string words = foldedForMatching(describedValue(cell.childText("description"), "indoor") + " " +
                                          describedValue(cell.childText("description"), "usage"));
    for (const char* field : {"function", "usage", "class"}) {
        std::string value = cell.childText(field);
        if (value == "1120") return RegionKind::Stairwell;
        if (value == "1110") return RegionKind::Elevator;
        if (value == "1000") return RegionKind::Corridor;
        if (value == "1020") return RegionKind::Room;
        words += " " + foldedForMatching(value);
    }
    if (hasWord(words, {"STAIR"})) return RegionKind::Stairwell;
    if (hasWord(words, {"ELEVATOR", "LIFT"})) return RegionKind::Elevator;
    if (hasWord(words, {"TOILET", "RESTROOM", "WASHROOM"})) return RegionKind::Toilet;
    if (hasWord(words, {"CORRIDOR", "HALLWAY"})) return RegionKind::Corridor;
    if (hasWord(words, {"HALL", "LOBBY"})) return RegionKind::Hall;
    if (hasWord(words, {"ROOM", "OFFICE"}) || cell.name == "generalspace") return RegionKind::Room;
    if (cell.name == "transitionspace") return RegionKind::Corridor;
    return RegionKind::Other;
}

/// Such as "002" or "B1.14": a number on the door.
bool looksLikeRef(const std::string& name) {
    bool digit = std::any_of(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
    return digit && name.size() <= 10 && name.find(' ') == std::string::npos;
}

Polyline flatLine(const Line3& line) {
    Polyline points;
    for (const Point3& point : line) points.push_back({point.x, point.y});
    return points;
}

std::string roundedKey(const Polyline& line, bool backwards) {
    std::string key;
    for (std::size_t i = 0; i < line.size(); ++i) {
        Point2 point = backwards ? line[line.size() - 1 - i] : line[i];
        key += formatNumber(std::round(point.x * 100)) + "," + formatNumber(std::round(point.y * 100)) + " ";
    }
    return key;
}

/// Where the segment leaves or enters the ring, as shares of the segment.
std::vector<double> crossings(Point2 from, Point2 to, const Ring& ring) {
    std::vector<double> shares;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        Point2 a = ring[i], b = ring[(i + 1) % ring.size()];
        double across = cross(to - from, b - a);
        if (across == 0.0) continue;
        double t = cross(a - from, b - a) / across, u = cross(a - from, to - from) / across;
        if (t >= 0.0 && t <= 1.0 && u >= 0.0 && u <= 1.0) shares.push_back(t);
    }
    return shares;
}

} // namespace

IndoorGmlBuilder::IndoorGmlBuilder(const XmlNode& root, const ImportOptions& options, std::string context)
    : m_root(root), m_options(options), m_context(std::move(context)) {}

void IndoorGmlBuilder::note(Severity severity, const std::string& rule, const Message& message,
                            const std::string& id) {
    Finding& finding = m_notes[rule];
    if (finding.rule.empty()) finding = {severity, rule, message, m_context, {}};
    finding.ids.push_back(id);
}

Result<RawMap> IndoorGmlBuilder::build() {
    if (m_root.name != "indoorfeatures")
        return Error{ErrorCode::UnsupportedFormat, english(Sentence::GmlOtherXml), m_context};
    indexIds(m_root);
    findCrs(m_root);
    m_geometry.emplace(m_ids, m_swapped);
    readCells(m_root);
    if (m_cells.size() >= kMaxCells)
        return Error{ErrorCode::Corrupt, english(Sentence::GmlTooManyCells), m_context};
    if (m_cells.empty()) return Error{ErrorCode::UnsupportedFormat, english(Sentence::GmlNoCells), m_context};
    readStates(m_root);
    readTransitions(m_root);
    setLevels();
    addAccesses();
    addRegions();
    if (m_map.data.regions.empty())
        return Error{ErrorCode::UnsupportedFormat, english(Sentence::GmlDoorsAlone), m_context};
    m_map.explicitGraph = !m_links.empty();
    if (m_map.coordinates == RawCoordinates::Unknown)
        m_map.coordinates = RawCoordinates::Metric; // plain numbers: metres
    for (auto& [rule, finding] : m_notes) m_map.findings.push_back(std::move(finding));
    return std::move(m_map);
}

void IndoorGmlBuilder::indexIds(const XmlNode& node) {
    if (std::string id = node.attribute("id"); !id.empty()) m_ids.emplace(id, &node);
    for (const XmlNode& child : node.children) indexIds(child);
}

void IndoorGmlBuilder::findCrs(const XmlNode& node) {
    if (m_map.coordinates != RawCoordinates::Unknown) return;
    if (std::string name = node.attribute("srsname"); !name.empty() && name.size() < 200) {
        GdalMessages quiet;
        OGRSpatialReference reference;
        const char* const options[] = {"ALLOW_NETWORK_ACCESS=NO", "ALLOW_FILE_ACCESS=NO", nullptr};
        if (reference.SetFromUserInput(name.c_str(), options) == OGRERR_NONE) {
            bool formal =
                name.rfind("urn:", 0) == 0 || name.rfind("http", 0) == 0; // these keep the authority's axes
            m_swapped = formal && (reference.EPSGTreatsAsLatLong() != 0 ||
                                   reference.EPSGTreatsAsNorthingEasting() != 0);
            m_map.coordinates =
                reference.IsGeographic() != 0 ? RawCoordinates::Geographic : RawCoordinates::Metric;
            char* wkt = nullptr;
            const char* const format[] = {"FORMAT=WKT2_2019", nullptr};
            if (reference.exportToWkt(&wkt, format) == OGRERR_NONE && wkt != nullptr) m_map.data.crs = wkt;
            CPLFree(wkt);
            return;
        }
        note(Severity::Warning, "indoorgml-crs", Sentence::GmlCrs, name);
        m_map.coordinates = RawCoordinates::Metric;
    }
    for (const XmlNode& child : node.children) findCrs(child);
}

void IndoorGmlBuilder::readCells(const XmlNode& node) {
    bool cell = node.name == "cellspace" || node.name == "generalspace" || node.name == "transitionspace" ||
                node.name == "connectionspace" || node.name == "anchorspace" || node.name == "navigablespace";
    if (cell && m_cells.size() < kMaxCells) return readCell(node);
    for (const XmlNode& child : node.children) readCells(child);
}

std::string IndoorGmlBuilder::storeyOf(const XmlNode& node) const {
    std::string description = node.childText("description");
    const std::string& from = m_options.levelFrom;
    if (from == "z") return {};
    if (!from.empty() && from != "storey") {
        std::string own;
        for (const XmlNode& child : node.children)
            if (foldedForMatching(child.name) == foldedForMatching(from)) own = child.text;
        return own.empty() ? describedValue(description, from) : own;
    }
    for (const char* key : {"storey", "storeyname", "level", "floor"})
        for (const std::string& value : {node.childText(key), describedValue(description, key)})
            if (!value.empty()) return value;
    return {};
}

void IndoorGmlBuilder::readCell(const XmlNode& node) {
    Cell cell;
    std::string id = node.attribute("id");
    const XmlNode* geometry = node.child("cellspacegeometry");
    auto seen = geometry == nullptr ? std::nullopt : m_geometry->footprint(*geometry);
    if (id.empty() || m_cellOf.count(id) != 0 || !seen) {
        note(Severity::Warning, "indoorgml-cell", Sentence::GmlCell, id);
        return;
    }
    Region& region = cell.region;
    region.id = RegionId(id);
    region.name = node.childText("name");
    if (looksLikeRef(region.name)) region.ref = region.name;
    region.kind = kindOf(node);
    if (node.name == "anchorspace") region.kindText = "entrance", region.kind = RegionKind::Other;
    region.polygon = std::move(seen->polygon);
    for (const char* field : {"description", "class", "function", "usage"})
        if (std::string value = node.childText(field); !value.empty()) region.extra[field] = value;
    cell.door = node.name == "connectionspace";
    cell.z = seen->z;
    cell.storey = storeyOf(node);
    if (const XmlNode* dual = node.child("duality")) cell.stateId = withoutReverse(dual->attribute("href"));
    m_cellOf[id] = m_cells.size();
    if (!cell.stateId.empty()) m_cellOf.emplace(cell.stateId, m_cells.size());
    m_cells.push_back(std::move(cell));
}

void IndoorGmlBuilder::readStates(const XmlNode& node) {
    if (node.name == "state") return readState(node);
    for (const XmlNode& child : node.children) readStates(child);
}

void IndoorGmlBuilder::readState(const XmlNode& node) {
    std::string id = node.attribute("id");
    const XmlNode* dual = node.child("duality");
    auto found = m_cellOf.find(id);
    if (found == m_cellOf.end() && dual != nullptr)
        found = m_cellOf.find(withoutReverse(dual->attribute("href")));
    if (found == m_cellOf.end()) return; // of another layer, such as sensors, or of a cell left out
    m_cellOf.emplace(id, found->second);
    Cell& cell = m_cells[found->second];
    if (cell.storey.empty()) cell.storey = storeyOf(node);
    const XmlNode* geometry = node.child("geometry");
    Line3 at = geometry == nullptr ? Line3() : m_geometry->line(*geometry);
    if (at.empty()) return;
    cell.state = Point2{at.front().x, at.front().y};
    if (!cell.z) cell.z = at.front().z;
}

void IndoorGmlBuilder::readTransitions(const XmlNode& node) {
    if (node.name == "transition") return readTransition(node);
    for (const XmlNode& child : node.children) readTransitions(child);
}

void IndoorGmlBuilder::readTransition(const XmlNode& node) {
    Link link{node.attribute("id"), 0, 0, {}, nullptr};
    std::vector<std::size_t> ends;
    for (const XmlNode& child : node.children) {
        if (child.name == "connects") {
            auto found = m_cellOf.find(withoutReverse(child.attribute("href")));
            if (found != m_cellOf.end()) ends.push_back(found->second);
        } else if (child.name == "duality") {
            auto found = m_ids.find(withoutReverse(child.attribute("href")));
            if (found != m_ids.end()) link.boundary = found->second;
        } else if (child.name == "geometry")
            link.line = flatLine(m_geometry->line(child));
    }
    if (ends.size() != 2 || ends[0] == ends[1]) {
        note(Severity::Warning, "indoorgml-transition", Sentence::GmlTransition, link.id);
        return;
    }
    link.a = ends[0];
    link.b = ends[1];
    // The way back is often written as a transition of its own.
    std::string pair =
        std::to_string(std::min(link.a, link.b)) + " " + std::to_string(std::max(link.a, link.b)) + " ";
    if (m_linkKeys.count(pair + roundedKey(link.line, true)) != 0) return;
    if (m_linkKeys.insert(pair + roundedKey(link.line, false)).second) m_links.push_back(std::move(link));
}

void IndoorGmlBuilder::setLevels() {
    bool byHeight = m_options.levelFrom == "z";
    if (byHeight || !setLevelsByStorey()) setLevelsByHeight();
}

/// Storeys that are numbers count as they are; other names are put in order of height, from the ground up.
bool IndoorGmlBuilder::setLevelsByStorey() {
    std::map<std::string, double> ordinals;
    std::map<double, std::string> named;
    for (const Cell& cell : m_cells) {
        if (cell.storey.empty() || ordinals.count(cell.storey) != 0) continue;
        std::string number = cell.storey[0] == 'B' ? "-" + cell.storey.substr(1) : cell.storey;
        ParsedLevels parsed = parseLevels(number);
        if (parsed.understood && parsed.levels.size() == 1) {
            ordinals[cell.storey] = parsed.levels.front();
            named.emplace(parsed.levels.front(), cell.storey);
        } else
            note(Severity::Warning, "indoorgml-storey", Sentence::GmlStorey, cell.storey);
    }
    bool all = std::all_of(m_cells.begin(), m_cells.end(),
                           [&](const Cell& cell) { return ordinals.count(cell.storey) != 0; });
    if (!all || ordinals.empty()) return false;
    for (Cell& cell : m_cells) cell.region.level = ordinals[cell.storey];
    for (const auto& [ordinal, name] : named) {
        Level level;
        level.ordinal = ordinal;
        level.ref = name;
        m_map.data.levels.push_back(std::move(level));
    }
    return true;
}

void IndoorGmlBuilder::setLevelsByHeight() {
    std::vector<double> heights;
    for (const Cell& cell : m_cells)
        if (cell.z) heights.push_back(*cell.z);
    HeightLevels levels(std::move(heights));
    if (levels.empty()) {
        m_map.data.levels.push_back(Level());
        if (m_cells.size() > 1) note(Severity::Warning, "indoorgml-level", Sentence::GmlLevel, "");
        return;
    }
    for (std::size_t i = 0; i < levels.floors().size(); ++i) {
        Level level;
        level.ordinal = levels.ordinalAt(i);
        level.elevationM = levels.floors()[i];
        m_map.data.levels.push_back(std::move(level));
    }
    for (Cell& cell : m_cells) cell.region.level = levels.ordinalOf(cell.z.value_or(levels.ground()));
    note(Severity::Note, "indoorgml-level-by-height", Sentence::GmlLevelByHeight,
         formatNumber(levels.floors().front()));
}

void IndoorGmlBuilder::addRegions() {
    for (std::size_t i = 0; i < m_cells.size(); ++i)
        if (m_collapsed.count(i) == 0) m_map.data.regions.push_back(std::move(m_cells[i].region));
}

void IndoorGmlBuilder::addAccesses() {
    std::map<std::size_t, std::vector<std::size_t>> doorLinks;
    for (std::size_t i = 0; i < m_links.size(); ++i)
        for (std::size_t end : {m_links[i].a, m_links[i].b})
            if (m_cells[end].door) doorLinks[end].push_back(i);
    std::set<std::size_t> used;
    for (const auto& [door, links] : doorLinks) {
        std::vector<std::size_t> sides;
        for (std::size_t i : links) {
            std::size_t other = m_links[i].a == door ? m_links[i].b : m_links[i].a;
            if (std::find(sides.begin(), sides.end(), other) == sides.end()) sides.push_back(other);
        }
        if (sides.size() != 2 || m_cells[sides[0]].door || m_cells[sides[1]].door) {
            note(Severity::Note, "indoorgml-door-cell", Sentence::GmlDoorCell, m_cells[door].region.id.value);
            continue;
        }
        const Cell& cell = m_cells[door];
        addAccess(cell.region.id.value, sides[0], sides[1], {pointInside(cell.region.polygon)}, nullptr,
                  &cell);
        m_collapsed.insert(door);
        used.insert(links.begin(), links.end());
    }
    for (std::size_t i = 0; i < m_links.size(); ++i)
        if (used.count(i) == 0)
            addAccess(m_links[i].id, m_links[i].a, m_links[i].b, m_links[i].line, m_links[i].boundary,
                      nullptr);
}

AccessKind IndoorGmlBuilder::kindBetween(const Cell& a, const Cell& b, bool door) const {
    auto either = [&](RegionKind kind) { return a.region.kind == kind || b.region.kind == kind; };
    if (a.region.level != b.region.level)
        return either(RegionKind::Elevator) ? AccessKind::Elevator : AccessKind::Stairs;
    bool both = a.region.kind == RegionKind::Corridor && b.region.kind == RegionKind::Corridor;
    return door || !both ? AccessKind::Door : AccessKind::Opening;
}

/// Half-way between leaving A and entering B along the line; its middle where outlines do not tell.
Point2 IndoorGmlBuilder::passage(const Cell& a, const Cell& b, const Polyline& line) const {
    std::optional<Point2> leaves, enters;
    for (std::size_t i = 1; i < line.size(); ++i) {
        auto at = [&](double share) { return line[i - 1] + (line[i] - line[i - 1]) * share; };
        std::vector<double> out = crossings(line[i - 1], line[i], a.region.polygon.outer);
        std::vector<double> in = crossings(line[i - 1], line[i], b.region.polygon.outer);
        if (!out.empty()) leaves = at(*std::max_element(out.begin(), out.end()));
        if (!in.empty() && !enters) enters = at(*std::min_element(in.begin(), in.end()));
    }
    if (leaves && enters) return (*leaves + *enters) * 0.5;
    if (leaves || enters) return leaves ? *leaves : *enters;
    if (line.size() % 2 == 1) return line[line.size() / 2];
    if (!line.empty()) return (line[line.size() / 2 - 1] + line[line.size() / 2]) * 0.5;
    return (a.state.value_or(centroid(a.region.polygon)) + b.state.value_or(centroid(b.region.polygon))) *
           0.5;
}

void IndoorGmlBuilder::addAccess(const std::string& id, std::size_t a, std::size_t b, const Polyline& line,
                                 const XmlNode* boundary, const Cell* door) {
    const Cell& from = m_cells[a];
    const Cell& to = m_cells[b];
    Access access;
    access.id = AccessId(id.empty() ? "T" + std::to_string(m_map.data.accesses.size()) : id);
    access.kind = kindBetween(from, to, boundary != nullptr || door != nullptr);
    access.level = from.region.level;
    access.regionA = from.region.id;
    access.regionB = to.region.id;
    if (door != nullptr) access.extra["cell_name"] = door->region.name;
    bool forward = line.size() < 2 || distanceToPolygon(from.region.polygon, line.front()) <=
                                          distanceToPolygon(to.region.polygon, line.front());
    access.line = {passage(forward ? from : to, forward ? to : from, line)};
    // A thin-wall door is as wide as its boundary.
    if (const XmlNode* wall = boundary == nullptr ? nullptr : boundary->child("cellspaceboundarygeometry")) {
        Polyline points = flatLine(m_geometry->line(*wall));
        if (points.size() >= 2) {
            auto farthest = std::max_element(points.begin(), points.end(), [&](Point2 p, Point2 q) {
                return distance(points[0], p) < distance(points[0], q);
            });
            if (distance(points[0], *farthest) > 0.0) access.line = {points[0], *farthest};
        }
    }
    m_map.data.accesses.push_back(std::move(access));
}

} // namespace farol::building
