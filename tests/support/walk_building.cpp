#include "tests/support/walk_building.h"

#include "tests/support/walk_random.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace farol::test {

using building::Access;
using building::AccessKind;
using building::Landmark;
using building::Region;
using building::RegionKind;

namespace {

struct Rect {
    double x0, y0, x1, y1;
    Point2 middle() const { return {(x0 + x1) / 2, (y0 + y1) / 2}; }
};

constexpr double kCorridorM = 2.5;

class Draughtsman {
public:
    explicit Draughtsman(const WalkBuildingOptions& options)
        : m_options(options), m_random(options.seed * 7919U + 17U) {}

    building::BuildingData draw();

private:
    std::size_t addRegion(const Rect& rect, RegionKind kind, const std::string& name);
    void addDoor(std::size_t a, std::size_t b, Point2 at, double towardsBDeg);
    void addOpening(std::size_t a, std::size_t b, Point2 p, Point2 q);
    void addLandmark(std::size_t region, Kind kind, Point2 at, std::optional<double> facingDeg,
                     const std::string& text = {});
    void furnish(std::size_t region);
    void hang(std::size_t region, const Rect& rect);
    /// Corridor pieces from (x, y) on, along x or y; rooms to the sides that are asked for.
    std::vector<std::size_t> corridor(Point2 from, double lengthM, bool alongX, bool roomsLow,
                                      bool roomsHigh);
    void rooms(const std::vector<std::size_t>& pieces, bool alongX, bool low);
    void drawCorridorLevel();
    void drawRingLevel();
    void drawWingsLevel();
    void drawHallLevel();
    void addShaft(std::size_t corridor, Point2 at, double towardsDeg, const Rect& rect, bool lift);
    void joinShafts();
    void turnAll();

    WalkBuildingOptions m_options;
    WalkRandom m_random;
    building::BuildingData m_data;
    std::vector<Rect> m_rects;
    std::vector<std::vector<std::size_t>> m_shafts; ///< [which][level]
    double m_level = 0.0, m_size = 0.0;
    int m_number = 0;
};

std::size_t Draughtsman::addRegion(const Rect& rect, RegionKind kind, const std::string& name) {
    Region region;
    region.id = RegionId("R" + std::to_string(m_data.regions.size()));
    region.level = m_level;
    region.name = name;
    region.ref = kind == RegionKind::Room ? name : "";
    region.kind = kind;
    region.polygon.outer = {{rect.x0, rect.y0}, {rect.x1, rect.y0}, {rect.x1, rect.y1}, {rect.x0, rect.y1}};
    m_data.regions.push_back(region);
    m_rects.push_back(rect);
    return m_data.regions.size() - 1;
}

void Draughtsman::addLandmark(std::size_t region, Kind kind, Point2 at, std::optional<double> facingDeg,
                              const std::string& text) {
    Landmark landmark;
    landmark.id = LandmarkId("L" + std::to_string(m_data.landmarks.size()));
    landmark.kind = kind;
    landmark.text = text;
    landmark.region = m_data.regions[region].id;
    landmark.level = m_level;
    if (facingDeg) landmark.heading = fromDegrees(*facingDeg);
    landmark.position = at;
    m_data.landmarks.push_back(landmark);
}

void Draughtsman::addDoor(std::size_t a, std::size_t b, Point2 at, double towardsBDeg) {
    Access access;
    access.id = AccessId("A" + std::to_string(m_data.accesses.size()));
    access.kind = AccessKind::Door;
    access.level = m_level;
    access.regionA = m_data.regions[a].id;
    access.regionB = m_data.regions[b].id;
    access.line = {at};
    m_data.accesses.push_back(access);
    addLandmark(a, Kind::Door, at, towardsBDeg + 180.0);
    addLandmark(b, Kind::Door, at, towardsBDeg);
    constexpr double kPlates[] = {0.07, 0.15, 0.28};
    bool room = m_data.regions[b].kind == RegionKind::Room;
    if (!room || !m_random.chance(kPlates[m_options.density])) return;
    double side = towardsBDeg * kPi / 180.0 + kPi / 2.0;
    Point2 beside = at + Point2{std::cos(side), std::sin(side)} * 0.7;
    addLandmark(a, Kind::Text, beside, towardsBDeg + 180.0, m_data.regions[b].ref);
}

void Draughtsman::addOpening(std::size_t a, std::size_t b, Point2 p, Point2 q) {
    Access access;
    access.id = AccessId("A" + std::to_string(m_data.accesses.size()));
    access.kind = AccessKind::Opening;
    access.level = m_level;
    access.regionA = m_data.regions[a].id;
    access.regionB = m_data.regions[b].id;
    access.line = {p, q};
    m_data.accesses.push_back(access);
}

/// Things on the walls of a corridor, a hall or a room.
void Draughtsman::hang(std::size_t region, const Rect& rect) {
    constexpr Kind kKinds[] = {Kind::Rectangle, Kind::Poster, Kind::Locker, Kind::Extinguisher,
                               Kind::ExitSign};
    double pick = m_random.uniform();
    Kind kind = kKinds[pick < 0.38 ? 0 : pick < 0.64 ? 1 : pick < 0.78 ? 2 : pick < 0.9 ? 3 : 4];
    double along = m_random.uniform();
    int wall = static_cast<int>(m_random.uniform() * 2.0);
    bool wide = rect.x1 - rect.x0 >= rect.y1 - rect.y0;
    if (kind == Kind::ExitSign)
        return addLandmark(region, kind, {rect.x0 + along * (rect.x1 - rect.x0), rect.middle().y},
                           std::nullopt);
    Point2 at = wide ? Point2{rect.x0 + along * (rect.x1 - rect.x0), wall == 0 ? rect.y0 : rect.y1}
                     : Point2{wall == 0 ? rect.x0 : rect.x1, rect.y0 + along * (rect.y1 - rect.y0)};
    double facing = wide ? (wall == 0 ? 90.0 : -90.0) : (wall == 0 ? 0.0 : 180.0);
    addLandmark(region, kind, at, facing);
}

void Draughtsman::furnish(std::size_t region) {
    const Rect rect = m_rects[region];
    constexpr double kPerMetre[] = {0.16, 0.3, 0.5};
    double run = std::max(rect.x1 - rect.x0, rect.y1 - rect.y0);
    bool room = m_data.regions[region].kind == RegionKind::Room;
    double wanted = kPerMetre[m_options.density] * run * (room ? 0.6 : 1.0);
    for (double left = wanted; left > 0.0; left -= 1.0)
        if (left >= 1.0 || m_random.chance(left)) hang(region, rect);
}

void Draughtsman::rooms(const std::vector<std::size_t>& pieces, bool alongX, bool low) {
    double depth = m_random.between(4.0, 6.0);
    for (std::size_t piece : pieces) {
        Rect c = m_rects[piece];
        double from = alongX ? c.x0 : c.y0, to = alongX ? c.x1 : c.y1;
        int count = std::max(1, static_cast<int>((to - from) / m_random.between(3.5, 6.0)));
        double step = (to - from) / count;
        for (int i = 0; i < count; ++i) {
            double a = from + i * step, b = a + step,
                   edge = alongX ? (low ? c.y0 : c.y1) : (low ? c.x0 : c.x1);
            double far = edge + (low ? -depth : depth);
            Rect r = alongX ? Rect{a, std::min(edge, far), b, std::max(edge, far)}
                            : Rect{std::min(edge, far), a, std::max(edge, far), b};
            std::string number = std::to_string(m_number++ % 100);
            std::string ref = std::to_string(static_cast<int>(m_level)) + "." +
                              std::string(2 - number.size(), '0') + number;
            std::size_t room = addRegion(r, RegionKind::Room, ref);
            double at = m_random.between(a + 0.8, b - 0.8);
            double towards = alongX ? (low ? -90.0 : 90.0) : (low ? 180.0 : 0.0);
            addDoor(piece, room, alongX ? Point2{at, edge} : Point2{edge, at}, towards);
            furnish(room);
        }
    }
}

std::vector<std::size_t> Draughtsman::corridor(Point2 from, double lengthM, bool alongX, bool roomsLow,
                                               bool roomsHigh) {
    std::vector<std::size_t> pieces;
    int count = std::max(1, static_cast<int>(std::round(lengthM / m_random.between(8.0, 15.0))));
    double step = lengthM / count, half = kCorridorM / 2;
    for (int i = 0; i < count; ++i) {
        double a = i * step, b = a + step;
        Rect r = alongX ? Rect{from.x + a, from.y - half, from.x + b, from.y + half}
                        : Rect{from.x - half, from.y + a, from.x + half, from.y + b};
        pieces.push_back(addRegion(r, RegionKind::Corridor, "C" + std::to_string(m_data.regions.size())));
        if (i > 0)
            addOpening(pieces[pieces.size() - 2], pieces.back(),
                       alongX ? Point2{r.x0, r.y0} : Point2{r.x0, r.y0},
                       alongX ? Point2{r.x0, r.y1} : Point2{r.x1, r.y0});
        furnish(pieces.back());
    }
    if (roomsLow) rooms(pieces, alongX, true);
    if (roomsHigh) rooms(pieces, alongX, false);
    return pieces;
}

void Draughtsman::addShaft(std::size_t corridor, Point2 at, double towardsDeg, const Rect& rect, bool lift) {
    std::size_t region = addRegion(rect, lift ? RegionKind::Elevator : RegionKind::Stairwell,
                                   (lift ? "Lift " : "Stairs ") + std::to_string(m_shafts.size()));
    addDoor(corridor, region, at, towardsDeg);
    Point2 inside = rect.middle();
    if (lift)
        addLandmark(corridor, Kind::Text, at + Point2{0.0, 0.0}, towardsDeg + 180.0, "LIFT");
    else
        addLandmark(region, Kind::Stairs, inside, std::nullopt);
    if (m_random.chance(0.5))
        addLandmark(region, Kind::Text, {rect.x0, inside.y}, 0.0,
                    "FLOOR " + std::to_string(static_cast<int>(m_level)));
    std::size_t which = lift ? 1 : 0;
    if (m_shafts.size() <= which) m_shafts.resize(which + 1);
    m_shafts[which].push_back(region);
}

void Draughtsman::drawCorridorLevel() {
    auto pieces = corridor({0, 0}, m_size, true, true, true);
    addShaft(pieces.front(), {0, 0}, 180.0, {-5, -1.5, 0, 1.5}, false);
    if (m_options.seed % 2 == 0)
        addShaft(pieces.back(), {m_rects[pieces.back()].x1, 0}, 0.0,
                 {m_rects[pieces.back()].x1, -1.2, m_rects[pieces.back()].x1 + 2.2, 1.2}, true);
}

void Draughtsman::drawRingLevel() {
    double w = m_size * 0.6, h = m_size * 0.45, half = kCorridorM / 2;
    auto low = corridor({0, 0}, w, true, true, false);
    auto high = corridor({0, h}, w, true, false, true);
    auto left = corridor({-half, half}, h - kCorridorM, false, true, false);
    auto right = corridor({w + half, half}, h - kCorridorM, false, false, true);
    auto corner = [&](double x0, double y0) {
        return addRegion({x0, y0, x0 + kCorridorM, y0 + kCorridorM}, RegionKind::Corridor,
                         "K" + std::to_string(m_data.regions.size()));
    };
    std::size_t a = corner(-kCorridorM, -half), b = corner(w, -half), c = corner(-kCorridorM, h - half),
                d = corner(w, h - half);
    addOpening(a, low.front(), {0, -half}, {0, half});
    addOpening(low.back(), b, {w, -half}, {w, half});
    addOpening(c, high.front(), {0, h - half}, {0, h + half});
    addOpening(high.back(), d, {w, h - half}, {w, h + half});
    addOpening(a, left.front(), {-kCorridorM, half}, {0, half});
    addOpening(left.back(), c, {-kCorridorM, h - half}, {0, h - half});
    addOpening(b, right.front(), {w, half}, {w + kCorridorM, half});
    addOpening(right.back(), d, {w, h - half}, {w + kCorridorM, h - half});
    addShaft(a, {-kCorridorM, 0}, 180.0, {-kCorridorM - 5, -1.5, -kCorridorM, 1.5}, false);
    if (m_options.seed % 2 == 0)
        addShaft(d, {w + kCorridorM, h}, 0.0, {w + kCorridorM, h - 1.2, w + kCorridorM + 2.2, h + 1.2}, true);
}

void Draughtsman::drawWingsLevel() {
    double half = kCorridorM / 2, wing = m_size * 0.5;
    std::size_t hall = addRegion({-6, -5, 6, 5}, RegionKind::Hall, "Atrium");
    addLandmark(hall, Kind::Text, {0, 0}, std::nullopt, "HALL " + std::to_string(static_cast<int>(m_level)));
    furnish(hall);
    furnish(hall);
    auto east = corridor({6, 0}, wing, true, true, true);
    auto west = corridor({-6 - wing, 0}, wing, true, true, true);
    addOpening(hall, east.front(), {6, -half}, {6, half});
    addOpening(west.back(), hall, {-6, -half}, {-6, half});
    addShaft(hall, {0, 5}, 90.0, {-1.5, 5, 1.5, 10}, false);
    if (m_options.seed % 2 == 0) addShaft(hall, {0, -5}, -90.0, {-1.2, -7.2, 1.2, -5}, true);
}

void Draughtsman::drawHallLevel() {
    double w = std::max(10.0, m_size * 0.3), h = std::max(8.0, m_size * 0.22);
    std::size_t a = addRegion({0, 0, w, h}, RegionKind::Hall, "Hall A");
    std::size_t b = addRegion({w, 0, 1.8 * w, h}, RegionKind::Hall, "Hall B");
    addOpening(a, b, {w, 0.2 * h}, {w, 0.8 * h});
    addLandmark(a, Kind::Text, {w / 2, h / 2}, std::nullopt,
                "HALL A" + std::to_string(static_cast<int>(m_level)));
    for (std::size_t hall : {a, b}) {
        furnish(hall);
        furnish(hall);
        rooms({hall}, true, true);
        rooms({hall}, true, false);
    }
    auto tail = corridor({1.8 * w, h / 2}, 0.6 * w + 6.0, true, true, true);
    addOpening(b, tail.front(), {1.8 * w, h / 2 - 1.2}, {1.8 * w, h / 2 + 1.2});
    addShaft(a, {0, h / 2}, 180.0, {-5, h / 2 - 1.5, 0, h / 2 + 1.5}, false);
}

void Draughtsman::joinShafts() {
    for (const auto& shaft : m_shafts)
        for (std::size_t i = 1; i < shaft.size(); ++i) {
            Access access;
            access.id = AccessId("A" + std::to_string(m_data.accesses.size()));
            const Region& lower = m_data.regions[shaft[i - 1]];
            access.kind = lower.kind == RegionKind::Elevator ? AccessKind::Elevator : AccessKind::Stairs;
            access.level = lower.level;
            access.regionA = lower.id;
            access.regionB = m_data.regions[shaft[i]].id;
            access.line = {m_rects[shaft[i]].middle()};
            m_data.accesses.push_back(access);
        }
}

/// No wall along an axis: nothing may depend on that.
void Draughtsman::turnAll() {
    double by = m_random.between(-kPi, kPi), c = std::cos(by), s = std::sin(by);
    auto turn = [&](Point2& p) { p = Point2{1000.0 + c * p.x - s * p.y, 2000.0 + s * p.x + c * p.y}; };
    for (Region& region : m_data.regions)
        for (Point2& p : region.polygon.outer) turn(p);
    for (Access& access : m_data.accesses)
        for (Point2& p : access.line) turn(p);
    for (Landmark& landmark : m_data.landmarks) {
        turn(landmark.position);
        if (landmark.heading) landmark.heading = wrapped(*landmark.heading + Radians{by});
    }
}

building::BuildingData Draughtsman::draw() {
    m_data.title = "walks " + std::to_string(m_options.seed);
    m_size = m_random.between(m_options.leastM, m_options.mostM);
    int levels = 1 + static_cast<int>(m_random.uniform() * 6.0);
    for (int i = 0; i < levels; ++i) {
        m_level = i;
        m_number = 1;
        building::Level level;
        level.ordinal = m_level;
        level.ref = std::to_string(i);
        level.name = "Floor " + level.ref;
        m_data.levels.push_back(level);
        switch (m_options.archetype) {
        case Archetype::Corridor:
            drawCorridorLevel();
            break;
        case Archetype::Ring:
            drawRingLevel();
            break;
        case Archetype::Wings:
            drawWingsLevel();
            break;
        case Archetype::Hall:
            drawHallLevel();
            break;
        }
    }
    joinShafts();
    turnAll();
    return m_data;
}

} // namespace

building::BuildingData walkBuildingData(const WalkBuildingOptions& options) {
    return Draughtsman(options).draw();
}

building::BuildingData variedBuildingData(std::uint64_t seed) {
    constexpr std::size_t kFewest = 35, kMost = 440;
    WalkBuildingOptions options;
    options.archetype = static_cast<Archetype>(seed % 4);
    options.density = static_cast<int>((seed / 4) % 3);
    options.mostM = 130.0;
    for (std::uint64_t i = 0;; ++i) {
        options.seed = seed + 1000003ULL * i;
        building::BuildingData data = walkBuildingData(options);
        if (data.regions.size() >= kFewest && data.regions.size() <= kMost) return data;
    }
}

} // namespace farol::test
