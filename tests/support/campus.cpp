#include "tests/support/campus.h"

#include "core/base/text.h"
#include "tests/support/campus_plan.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>

namespace farol::test {

using building::Access;
using building::AccessKind;
using building::BuildingData;
using building::OneWay;
using building::Region;
using building::RegionKind;

namespace {

constexpr double kStoreyM = 3.5, kWalkM = 6.0, kAvenueM = 5.0, kGapM = 8.0;
constexpr std::size_t kNearly = 10; ///< so few regions missing are no reason for another building

Point2 between(Point2 a, Point2 b, double share) {
    return a + (b - a) * share;
}

/// The middle part of a line, `width` long.
Polyline middleOf(Point2 a, Point2 b, double width) {
    double half = std::min(0.5, width / 2.0 / distance(a, b));
    return {between(a, b, 0.5 - half), between(a, b, 0.5 + half)};
}

/// What buildings and walks are added to.
class Site {
public:
    std::size_t addRegion(const std::string& id, RegionKind kind, double level, const std::string& name,
                          Polygon polygon) {
        Region region;
        region.id = RegionId(id);
        region.kind = kind;
        region.level = level;
        region.name = name + " " + id;
        region.ref = id;
        if (signedArea(polygon.outer) < 0.0) std::reverse(polygon.outer.begin(), polygon.outer.end());
        for (Ring& hole : polygon.holes)
            if (signedArea(hole) > 0.0) std::reverse(hole.begin(), hole.end());
        region.polygon = std::move(polygon);
        data.regions.push_back(std::move(region));
        return data.regions.size() - 1;
    }
    Access& join(AccessKind kind, std::size_t a, std::size_t b, Polyline line) {
        Access access;
        access.id = AccessId("a" + std::to_string(data.accesses.size() + 1));
        access.kind = kind;
        access.level = data.regions[a].level;
        access.regionA = data.regions[a].id;
        access.regionB = data.regions[b].id;
        if (line.size() > 1) access.widthM = length(line);
        access.line = std::move(line);
        data.accesses.push_back(std::move(access));
        return data.accesses.back();
    }
    void mark(Kind kind, std::size_t region, Point2 position) {
        building::Landmark landmark;
        landmark.id = LandmarkId("l" + std::to_string(data.landmarks.size() + 1));
        landmark.kind = kind;
        landmark.region = data.regions[region].id;
        landmark.level = data.regions[region].level;
        landmark.position = position;
        data.landmarks.push_back(std::move(landmark));
    }

    BuildingData data;
};

/// One building, floor upon floor.
class BuildingDrawer {
public:
    BuildingDrawer(Site& site, CampusRandom& random, FloorPlan plan, std::string name, Point2 corner)
        : m_site(site),
          m_random(random),
          m_plan(std::move(plan)),
          m_name(std::move(name)),
          m_corner(corner) {}

    void drawFloor(int level) {
        m_level = level;
        m_rooms = 0;
        m_corridors.clear();
        m_shafts.clear();
        drawCorridors();
        for (const RoomRow& row : m_plan.rows) drawRow(row);
        if (!m_below.empty()) joinFloors();
        m_below = m_shafts;
    }

    // Of the floor drawn last.
    std::size_t entranceHall() const { return m_shafts.front().region; }
    std::size_t lastCorridor() const { return m_corridors.back(); }

private:
    /// What stands at the same place on every floor.
    struct Shaft {
        SlotKind kind;
        std::size_t region;
        Point2 middle;
    };

    Point2 placed(Point2 p) const { return p + m_corner; }
    Polygon placed(Polygon polygon) const {
        for (Point2& p : polygon.outer) p = placed(p);
        for (Ring& hole : polygon.holes)
            for (Point2& p : hole) p = placed(p);
        return polygon;
    }
    std::string nextId() { return m_name + "." + std::to_string(m_level) + "." + std::to_string(++m_rooms); }

    void drawCorridors() {
        for (const Polygon& corridor : m_plan.corridors) {
            m_corridors.push_back(
                m_site.addRegion(nextId(), RegionKind::Corridor, m_level, "Corridor", placed(corridor)));
            m_site.mark(Kind::Extinguisher, m_corridors.back(), placed(corridor.outer[0] + Point2{0.2, 0.2}));
        }
        for (std::size_t i = 0; i < m_plan.joints.size(); ++i)
            m_site.join(AccessKind::Opening, m_corridors[i], m_corridors[i + 1],
                        {placed(m_plan.joints[i][0]), placed(m_plan.joints[i][1])});
    }

    /// The fixed slots, then rooms of random widths until the row is full.
    std::vector<Slot> slotsOf(const RoomRow& row) {
        std::vector<Slot> slots = row.fixed;
        double left = row.length;
        for (const Slot& slot : slots) left -= slot.width;
        while (left > 0.0) {
            double width = 0.1 * m_random.whole(28, 65);
            if (left - width < 2.8) width = left;
            slots.push_back({m_random.chance(0.06) ? SlotKind::Toilet : SlotKind::Room, width});
            left -= width;
        }
        return slots;
    }

    void drawRow(const RoomRow& row) {
        double along = 0.0;
        std::optional<std::size_t> previous;
        for (const Slot& slot : slotsOf(row)) {
            Ring ring{placed(row.at(along, 0)), placed(row.at(along + slot.width, 0)),
                      placed(row.at(along + slot.width, row.depth)), placed(row.at(along, row.depth))};
            std::size_t region = drawSlot(slot, ring, m_corridors[row.corridor]);
            bool room = slot.kind == SlotKind::Room;
            if (room && previous && m_random.chance(0.12)) drawInnerDoor(*previous, region, ring[0], ring[3]);
            previous = room ? std::optional(region) : std::nullopt;
            along += slot.width;
            if (slot.kind == SlotKind::Hall || slot.kind == SlotKind::Stairwell ||
                slot.kind == SlotKind::Lift)
                m_shafts.push_back({slot.kind, region, between(ring[0], ring[2], 0.5)});
        }
        if (!row.corner) return;
        std::size_t last = m_site.data.regions.size() - 1;
        std::size_t corner =
            m_site.addRegion(nextId(), RegionKind::Room, m_level, "Room", placed(Polygon{*row.corner, {}}));
        m_site.join(AccessKind::Door, last, corner,
                    middleOf(placed(row.at(row.length, 0)), placed(row.at(row.length, row.depth)), 0.9));
    }

    /// A way besides the corridor's: it may be shut or go one way only.
    void drawInnerDoor(std::size_t a, std::size_t b, Point2 from, Point2 to) {
        Access& door = m_site.join(AccessKind::Door, a, b, middleOf(from, to, 0.8));
        door.closed = m_random.chance(0.1);
        if (m_random.chance(0.2)) door.oneWay = m_random.chance(0.5) ? OneWay::AToB : OneWay::BToA;
    }

    /// `ring`: first the two ends of the side along the corridor.
    std::size_t drawSlot(const Slot& slot, const Ring& ring, std::size_t corridor) {
        std::size_t region = addSlot(slot, ring);
        if (slot.kind == SlotKind::Hall) {
            m_site.join(AccessKind::Opening, corridor, region,
                        middleOf(ring[0], ring[1], 0.5 * m_random.whole(4, 18)));
            m_site.mark(Kind::ExitSign, region, between(ring[0], ring[1], 0.1));
            return region;
        }
        double width = slot.kind == SlotKind::Stairwell ? 1.4 : slot.kind == SlotKind::Lift ? 1.1 : 0.9;
        double room = distance(ring[0], ring[1]);
        double from = m_random.between(0.3, room - width - 0.3);
        Polyline line{between(ring[0], ring[1], from / room),
                      between(ring[0], ring[1], (from + width) / room)};
        Access& door = m_site.join(AccessKind::Door, corridor, region, line);
        door.automatic = slot.kind == SlotKind::Lift;
        if (slot.kind == SlotKind::Room) m_site.data.regions[region].restricted = m_random.chance(0.02);
        if (slot.kind == SlotKind::Room && from > 1.8)
            m_site.join(AccessKind::Door, corridor, region,
                        {between(ring[0], ring[1], 0.4 / room), between(ring[0], ring[1], 1.3 / room)});
        return region;
    }

    std::size_t addSlot(const Slot& slot, const Ring& ring) {
        switch (slot.kind) {
        case SlotKind::Room:
            return m_site.addRegion(nextId(), RegionKind::Room, m_level, "Room", {ring, {}});
        case SlotKind::Toilet:
            return m_site.addRegion(nextId(), RegionKind::Toilet, m_level, "Toilet", {ring, {}});
        case SlotKind::Stairwell:
            return m_site.addRegion(nextId(), RegionKind::Stairwell, m_level, "Stairs", {ring, {}});
        case SlotKind::Lift:
            return m_site.addRegion(nextId(), RegionKind::Elevator, m_level, "Lift", {ring, {}});
        case SlotKind::Hall:
            break;
        }
        Polygon hall{ring, {}};
        for (int column = 1; column <= 4; ++column) {
            // Square ones in turn with ones set on the corner.
            Point2 middle = between(between(ring[0], ring[1], column / 5.0),
                                    between(ring[3], ring[2], column / 5.0), column % 2 == 0 ? 0.35 : 0.6);
            double half = column % 2 == 0 ? 0.3 : 0.4;
            hall.holes.push_back(column % 2 == 0 ? rectangle(middle.x - half, middle.y - half,
                                                             middle.x + half, middle.y + half)
                                                 : Ring{{middle.x - half, middle.y},
                                                        {middle.x, middle.y - half},
                                                        {middle.x + half, middle.y},
                                                        {middle.x, middle.y + half}});
        }
        return m_site.addRegion(nextId(), RegionKind::Hall, m_level, "Hall", std::move(hall));
    }

    /// Stairs, the lift, and escalators between the entrance halls of the first floors.
    void joinFloors() {
        for (std::size_t i = 0; i < m_shafts.size(); ++i) {
            const Shaft &up = m_shafts[i], &down = m_below[i];
            std::string shaft = m_name + "-" + std::to_string(i + 1);
            if (up.kind == SlotKind::Stairwell) {
                Access& stairs = m_site.join(AccessKind::Stairs, down.region, up.region, {up.middle});
                stairs.shaft = ShaftId(shaft);
                stairs.steps = 20;
            } else if (up.kind == SlotKind::Lift) {
                m_site.join(AccessKind::Elevator, down.region, up.region, {up.middle}).shaft = ShaftId(shaft);
            } else if (i == 0 && m_level <= 2) {
                m_site.join(AccessKind::Escalator, down.region, up.region, {up.middle + Point2{0.3, 0.0}})
                    .oneWay = OneWay::AToB;
                m_site.join(AccessKind::Escalator, down.region, up.region, {up.middle - Point2{0.3, 0.0}})
                    .oneWay = OneWay::BToA;
            }
        }
    }

    Site& m_site;
    CampusRandom& m_random;
    FloorPlan m_plan;
    std::string m_name;
    Point2 m_corner;
    int m_level = 0;
    int m_rooms = 0;
    std::vector<std::size_t> m_corridors;
    std::vector<Shaft> m_shafts, m_below;
};

/// Buildings in rows, a walk along the front of each row, and avenues from row to row.
class CampusDrawer {
public:
    explicit CampusDrawer(const CampusOptions& options)
        : m_wanted(options.regions), m_small(options.regions < 400), m_random(options.seed) {}

    BuildingData draw() {
        // About 25 regions on a floor of a small building and 45 of a large one.
        double buildings = static_cast<double>(m_wanted) / (m_small ? 45.0 : 200.0);
        m_columns = std::max<std::size_t>(2, static_cast<std::size_t>(std::sqrt(buildings)));
        do drawCell();
        while (m_site.data.regions.size() + kNearly < m_wanted);
        for (int level = *m_levels.begin(); level <= *m_levels.rbegin(); ++level)
            m_site.data.levels.push_back({double(level),
                                          "Level " + std::to_string(level),
                                          std::to_string(level),
                                          kStoreyM * level,
                                          kStoreyM,
                                          {}});
        m_site.data.title = "Campus of " + std::to_string(m_site.data.regions.size()) + " regions";
        m_site.data.languages = {"en"};
        return std::move(m_site.data);
    }

private:
    struct Cell {
        std::size_t walk;
        std::optional<std::size_t> corridor; ///< that ends towards the avenue, by a door
        Polyline sideDoor;
    };

    double cellWidth() const { return (m_small ? 41.0 : 86.0) + kGapM + kAvenueM; }
    double cellDepth() const { return (m_small ? 34.0 : 66.0) + kWalkM; }
    static std::string number(std::size_t cell) { return std::to_string(cell + 1); }

    void drawCell() {
        std::size_t cell = m_cells.size(), row = cell / m_columns;
        Point2 corner{static_cast<double>(cell % m_columns) * cellWidth(),
                      static_cast<double>(row) * cellDepth()};
        Ring ground = rectangle(corner.x, corner.y - kWalkM, corner.x + cellWidth(), corner.y);
        std::size_t walk =
            m_site.addRegion("w" + number(cell), RegionKind::Outside, 0.0, "Walk", {ground, {}});
        if (cell % m_columns > 0)
            m_site.join(AccessKind::Opening, m_cells.back().walk, walk, {ground[0], ground[3]});
        m_cells.push_back({walk, {}, {}});
        if (row > 0 && (cell % m_columns == 0 || m_random.chance(0.4))) drawAvenue(cell - m_columns, walk);
        drawBuilding(cell, corner);
    }

    /// From the walk in front of a building, past its side, to the walk behind it.
    void drawAvenue(std::size_t cell, std::size_t behind) {
        const Cell from = m_cells[cell];
        Point2 start = m_site.data.regions[from.walk].polygon.outer[2]; // by the next cell's corner
        double west = start.x - kAvenueM, end = start.y + cellDepth() - kWalkM;
        Ring ground = rectangle(west, start.y, start.x, end);
        std::size_t avenue =
            m_site.addRegion("v" + number(cell), RegionKind::Outside, 0.0, "Avenue", {ground, {}});
        m_site.join(AccessKind::Opening, from.walk, avenue, {ground[0], ground[1]});
        m_site.join(AccessKind::Opening, avenue, behind, {ground[3], ground[2]});
        if (!from.corridor) return;
        Point2 low = from.sideDoor[0], high = from.sideDoor[1];
        std::size_t path = m_site.addRegion("p" + number(cell), RegionKind::Outside, 0.0, "Path",
                                            {rectangle(low.x, low.y, west, high.y), {}});
        m_site.join(AccessKind::Door, *from.corridor, path, middleOf(low, high, 1.0));
        m_site.join(AccessKind::Opening, path, avenue, {{west, low.y}, {west, high.y}});
    }

    void drawBuilding(std::size_t cell, Point2 corner) {
        bool last = m_site.data.regions.size() + 60 > m_wanted; // no room for a ring of rooms
        auto shape = last ? PlanShape::Straight : static_cast<PlanShape>(cell % 3);
        FloorPlan plan = floorPlan(shape, m_small, m_random);
        BuildingDrawer drawer(m_site, m_random, plan, "b" + number(cell), corner);
        int lowest = m_random.chance(0.3) ? -1 : 0;
        int highest = m_random.whole(1, m_small ? 1 : 6);
        std::size_t floor = 0;
        for (int level = lowest; level <= highest; ++level) {
            std::size_t before = m_site.data.regions.size();
            // Once the campus is nearly full, no more floors; but every building has one at the ground.
            if (level > 0 && before + floor / 2 > m_wanted) break;
            m_levels.insert(level);
            drawer.drawFloor(level);
            floor = m_site.data.regions.size() - before;
            if (level == 0) joinGround(cell, plan, corner, drawer);
        }
    }

    void joinGround(std::size_t cell, const FloorPlan& plan, Point2 corner, const BuildingDrawer& drawer) {
        const RoomRow& front = plan.rows.front();
        double middle = corner.x + front.start.x + front.fixed.front().width / 2.0;
        m_site
            .join(AccessKind::Door, m_cells[cell].walk, drawer.entranceHall(),
                  {{middle - 1.0, corner.y}, {middle + 1.0, corner.y}})
            .automatic = true;
        if (!plan.sideDoor) return;
        m_cells[cell].corridor = drawer.lastCorridor();
        for (Point2 p : *plan.sideDoor) m_cells[cell].sideDoor.push_back(p + corner);
    }

    std::size_t m_wanted;
    bool m_small;
    CampusRandom m_random;
    std::size_t m_columns = 1;
    Site m_site;
    std::vector<Cell> m_cells;
    std::set<int> m_levels;
};

/// Turned round the origin, then moved.
struct Placing {
    double cosine, sine;
    Point2 origin;

    void operator()(std::vector<Point2>& points) const {
        for (Point2& p : points) (*this)(p);
    }
    void operator()(Point2& p) const {
        p = Point2{cosine * p.x - sine * p.y, sine * p.x + cosine * p.y} + origin;
    }
};

} // namespace

std::ostream& operator<<(std::ostream& out, const CampusOptions& options) {
    return out << options.regions << " regions, seed " << options.seed << ", turned " << options.turnDegrees;
}

BuildingData campusData(const CampusOptions& options) {
    BuildingData data = CampusDrawer(options).draw();
    double angle = options.turnDegrees * std::acos(-1.0) / 180.0;
    Placing place{angle == 0.0 ? 1.0 : std::cos(angle), angle == 0.0 ? 0.0 : std::sin(angle), options.origin};
    for (Region& region : data.regions) {
        place(region.polygon.outer);
        for (Ring& hole : region.polygon.holes) place(hole);
    }
    for (Access& access : data.accesses) place(access.line);
    for (building::Landmark& landmark : data.landmarks) place(landmark.position);
    data.crs = options.crs;
    return data;
}

std::shared_ptr<const building::Building> makeCampus(const CampusOptions& options) {
    return std::make_shared<const building::Building>(campusData(options));
}

std::vector<std::pair<building::Location, building::Location>>
campusPairs(const building::Building& building, std::size_t count, std::uint32_t seed) {
    CampusRandom random(seed);
    auto spot = [&] {
        auto last = static_cast<int>(building.regions().size()) - 1;
        const Region& region = building.regions()[static_cast<std::size_t>(random.whole(0, last))];
        Box2 box = *boundingBox(region.polygon.outer);
        Point2 point{};
        do point = {random.between(box.low.x, box.high.x), random.between(box.low.y, box.high.y)};
        while (!contains(region.polygon, point));
        return building::Location{region.id, point};
    };
    std::vector<std::pair<building::Location, building::Location>> pairs;
    for (std::size_t i = 0; i < count; ++i) {
        building::Location from = spot();
        pairs.emplace_back(std::move(from), spot());
    }
    return pairs;
}

} // namespace farol::test
