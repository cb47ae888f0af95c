#include "resources/demo/draughtsman.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace farol::demo {

using building::Access;
using building::AccessKind;
using building::Region;

namespace {

constexpr double kStoreyM = 3.4, kCeilingM = 2.8, kDoorTallM = 2.08;
constexpr int kStepsOfAFlight = 20;
// UTM 29N, at sea: the building does not exist.
constexpr double kEastM = 480000.0, kNorthM = 4080000.0;

Point2 onMap(Point2 p) {
    return {kEastM + p.x, kNorthM + p.y};
}

Point2 along(double degrees) {
    Radians direction = fromDegrees(degrees);
    return {std::cos(direction.value), std::sin(direction.value)};
}

using Spans = std::vector<std::pair<double, double>>;

long centimetres(double metres) {
    return std::lround(metres * 100.0);
}

/// Of a side along an axis: its line (as Draughtsman::WallLine), and from where to where on it.
std::pair<std::tuple<double, bool, long>, std::pair<double, double>> spanOf(double level, Point2 a,
                                                                            Point2 b) {
    bool eastWest = centimetres(a.y) == centimetres(b.y);
    auto span = eastWest ? std::minmax(a.x, b.x) : std::minmax(a.y, b.y);
    return {{level, eastWest, centimetres(eastWest ? a.y : a.x)}, {span.first, span.second}};
}

/// Overlapping and touching spans as one, in order.
Spans united(Spans spans) {
    std::sort(spans.begin(), spans.end());
    Spans result;
    for (auto [from, to] : spans) {
        if (!result.empty() && from <= result.back().second + 0.005)
            result.back().second = std::max(result.back().second, to);
        else
            result.emplace_back(from, to);
    }
    return result;
}

} // namespace

std::string Draughtsman::id(const std::string& name) const {
    return std::to_string(static_cast<int>(m_level)) + "-" + name;
}

std::string Draughtsman::ref(int number) const {
    return std::to_string(static_cast<int>(m_level)) + (number < 10 ? ".0" : ".") + std::to_string(number);
}

void Draughtsman::beginLevel(double ordinal, const Names& names) {
    m_level = ordinal;
    building::Level level;
    level.ordinal = ordinal;
    level.name = names.english;
    level.ref = names.ref;
    level.elevationM = kStoreyM * ordinal;
    level.heightM = kCeilingM;
    level.extra["name_pt"] = names.portuguese;
    m_data.levels.push_back(std::move(level));
}

RegionId Draughtsman::region(const std::string& name, building::RegionKind kind, const Names& names,
                             const Box& box) {
    Region region;
    region.id = RegionId(id(name));
    region.level = m_level;
    region.name = names.english;
    region.ref = names.ref;
    region.kind = kind;
    region.polygon.outer = {onMap({box.west, box.south}), onMap({box.east, box.south}),
                            onMap({box.east, box.north}), onMap({box.west, box.north})};
    region.extra["name_pt"] = names.portuguese;
    m_data.regions.push_back(region);
    return region.id;
}

Access& Draughtsman::opening(const RegionId& a, const RegionId& b, Point2 from, Point2 to) {
    Access access;
    access.id = AccessId(a.value + "--" + b.value);
    access.kind = AccessKind::Opening;
    access.level = m_level;
    access.regionA = a;
    access.regionB = b;
    access.line = {onMap(from), onMap(to)};
    access.widthM = distance(from, to);
    m_data.accesses.push_back(std::move(access));
    return m_data.accesses.back();
}

Access& Draughtsman::door(const RegionId& a, const RegionId& b, Point2 at, double facingA, double widthM) {
    Point2 half = along(facingA + 90.0) * (widthM / 2.0);
    Access& access = opening(a, b, at - half, at + half);
    // Two doors of one pair of regions need two names.
    auto same = std::count_if(m_data.accesses.begin(), m_data.accesses.end(),
                              [&](const Access& each) { return each.regionA == a && each.regionB == b; });
    if (same > 1) access.id.value += "-" + std::to_string(same);
    access.kind = AccessKind::Door;
    access.doorType = "hinged";
    Thing leaf{Kind::Door, "", "", kDoorTallM / 2.0, widthM, kDoorTallM};
    landmark(a, leaf, at, facingA);
    landmark(b, leaf, at, facingA + 180.0);
    return access;
}

void Draughtsman::shaft(AccessKind kind, const std::string& shaft, const RegionId& low, const RegionId& high,
                        Point2 from, Point2 to) {
    Access& access = opening(low, high, from, to);
    access.kind = kind;
    access.shaft = ShaftId(shaft);
    if (kind == AccessKind::Stairs) access.steps = kStepsOfAFlight;
}

void Draughtsman::landmark(const RegionId& region, const Thing& thing, Point2 at, double facing) {
    building::Landmark landmark;
    std::string number = std::to_string(++m_things);
    landmark.id = LandmarkId(std::string(kindName(thing.kind)) + "-" +
                             std::string(number.size() < 3 ? 3 - number.size() : 0, '0') + number);
    landmark.kind = thing.kind;
    landmark.templateId = TemplateId(thing.templateId);
    landmark.text = thing.text;
    landmark.region = region;
    landmark.level = m_level;
    landmark.heading = wrapped(fromDegrees(facing));
    landmark.heightM = thing.middleM;
    landmark.widthM = thing.wideM;
    landmark.tallM = thing.tallM;
    landmark.position = onMap(at);
    m_data.landmarks.push_back(std::move(landmark));
}

/// The regions' sides without doors and openings, each shared wall once.
void Draughtsman::drawWalls() {
    std::map<WallLine, Spans> sides, gaps;
    for (const Region& region : m_data.regions) {
        if (region.kind == building::RegionKind::Outside) continue;
        const Ring& ring = region.polygon.outer;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            auto [line, span] = spanOf(region.level, ring[i], ring[(i + 1) % ring.size()]);
            sides[line].push_back(span);
        }
    }
    for (const Access& access : m_data.accesses) {
        if (access.changesLevel()) continue;
        auto [line, span] = spanOf(access.level, access.line.front(), access.line.back());
        gaps[line].push_back(span);
    }
    for (auto& [line, spans] : sides) {
        Spans cuts = united(gaps[line]);
        for (auto [at, end] : united(spans)) {
            for (auto [from, to] : cuts) {
                if (to <= at || from >= end) continue;
                drawWall(line, at, from);
                at = to;
            }
            drawWall(line, at, end);
        }
    }
}

void Draughtsman::drawWall(const WallLine& line, double from, double to) {
    if (to - from < 0.02) return;
    auto [level, eastWest, at] = line;
    double across = static_cast<double>(at) / 100.0;
    auto point = [&](double along) { return eastWest ? Point2{along, across} : Point2{across, along}; };
    m_data.walls.push_back({level, {point(from), point(to)}, {}});
}

building::BuildingData Draughtsman::take() {
    drawWalls();
    return std::move(m_data);
}

} // namespace farol::demo
