#include "core/simulation/walker.h"
#include "tests/support/lobby_map.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>

#include "resources/demo/demo_building.h"

namespace farol::simulation {
namespace {

using guidance::Cue;
using guidance::CueKind;
using routing::Manoeuvre;
using routing::ManoeuvreKind;
using test::AsciiMap;

std::unique_ptr<Walker> walkerIn(const std::shared_ptr<const building::Building>& building,
                                 const building::Location& start, const WalkerOptions& options = {}) {
    auto walker = Walker::create(std::make_shared<const WalkWorld>(building), start, options);
    EXPECT_TRUE(walker.ok());
    return walker ? std::move(walker).value() : nullptr;
}

WalkInstruction find(Feature feature, double turnDegrees = 0.0) {
    WalkInstruction instruction;
    instruction.order = Order::Go;
    instruction.task.feature = feature;
    instruction.task.turn = fromDegrees(turnDegrees);
    return instruction;
}

/// Told something at random every few seconds.
WalkInstruction anything(localisation::Random& random) {
    WalkInstruction instruction =
        find(static_cast<Feature>(1 + static_cast<int>(random.uniformDouble() * 7.0)),
             45.0 * std::floor(random.uniformDouble() * 8.0) - 180.0);
    instruction.now = random.uniformDouble() < 0.5;
    instruction.astray = random.uniformDouble() < 0.1;
    if (random.uniformDouble() < 0.2)
        instruction.turnFirst = fromDegrees(360.0 * random.uniformDouble() - 180.0);
    if (random.uniformDouble() < 0.3) instruction.task.side = routing::Side::Left;
    return instruction;
}

AsciiMap twoRooms(double cellM = 1.0) {
    AsciiMap map(cellM);
    map.floor(R"(
        +-------+
        |A      |
        |       |
        +---/---+
        |B      |
        |       |
        +-------+
    )");
    return map;
}

/// What every walk has to keep to, checked against the map alone.
class WallWatch {
public:
    explicit WallWatch(const building::Building& building) : m_building(building) {}

    void watch(const Walker& walker) {
        std::size_t region = *m_building.regionIndex(walker.region());
        Point2 at = walker.position();
        if (m_before) {
            if (region != *m_before && !joined(*m_before, region, at))
                ADD_FAILURE() << "into another region by no access: " << where(walker);
            if (region == *m_before && passesWall(region, at))
                ADD_FAILURE() << "through a wall: " << where(walker);
        }
        bool inside = contains(m_building.regions()[region].polygon, at);
        if (!inside && gapTo(region, at) > 0.6) ADD_FAILURE() << "outside: " << where(walker);
        m_before = region;
        m_at = at;
    }

private:
    std::string where(const Walker& walker) const {
        return walker.region().value + " at " + std::to_string(walker.time());
    }
    double gap(const building::Access& access, Point2 p) const {
        return distanceToSegment(p, access.line.front(), access.line.back());
    }
    double gapTo(std::size_t region, Point2 p) const {
        double least = 1e9;
        for (std::size_t access : m_building.accessesOf(region))
            least = std::min(least, gap(m_building.accesses()[access], p));
        return least;
    }
    bool joined(std::size_t from, std::size_t into, Point2 at) const {
        for (std::size_t index : m_building.accessesOf(from)) {
            const building::Access& access = m_building.accesses()[index];
            if (m_building.otherSide(access, from) == into && access.passable() && gap(access, at) < 0.6)
                return true;
        }
        return false;
    }
    bool passesWall(std::size_t region, Point2 at) const {
        const Ring& ring = m_building.regions()[region].polygon.outer;
        for (std::size_t i = 0; i < ring.size(); ++i)
            if (segmentsCross(m_at, at, ring[i], ring[(i + 1) % ring.size()]) && gapTo(region, at) > 0.3)
                return true;
        return false;
    }

    const building::Building& m_building;
    std::optional<std::size_t> m_before;
    Point2 m_at;
};

TEST(Walker, NeverPassesAWallNorLeavesALevelButByAnAccess) {
    auto building = std::make_shared<const building::Building>(demo::demoBuilding());
    auto world = std::make_shared<const WalkWorld>(building);
    localisation::Random random(7);
    std::size_t changes = 0;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        WalkerOptions options;
        options.seed = seed;
        options.wilfulness = seed % 2 == 0 ? 0.3 : 0.0;
        const auto& regions = building->regions();
        auto walker = Walker::create(world, {regions[seed % regions.size()].id, {}}, options);
        ASSERT_TRUE(walker.ok());
        WallWatch watch(*building);
        RegionId before = (*walker)->region();
        for (int tick = 0; tick < 1200; ++tick) {
            if (tick % 60 == 5) (*walker)->hear(anything(random));
            (*walker)->walkUntil(0.1 * tick);
            watch.watch(**walker);
            changes += (*walker)->region() == before ? 0U : 1U;
            before = (*walker)->region();
            EXPECT_TRUE((*walker)->pose().check().ok());
        }
        if (HasFailure()) break;
    }
    EXPECT_GT(changes, 1000U) << "they hardly went anywhere";
}

TEST(Walker, ToldNothingStands) {
    auto building = test::asciiMap(R"(
        +-----+
        |A    |
        +--/--+
        |B    |
        +-----+
    )");
    auto walker = walkerIn(building, {RegionId("A"), {}});
    Point2 start = walker->position();
    walker->walkUntil(60.0);
    EXPECT_EQ(walker->position(), start);
    Cue here;
    here.kind = CueKind::Located;
    here.time = 60.0;
    walker->hear(here);
    walker->walkUntil(90.0);
    EXPECT_EQ(walker->position(), start) << "being told the place is no order";
}

TEST(Walker, WhoIsAskedToMoveAFewStepsDoesSoAndNoMore) {
    auto building = test::asciiMap(R"(
        +--------------------+
        |                    |
        |         A          |
        |                    |
        +--------------------+
    )");
    WalkerOptions options;
    options.stopsPerSecond = options.looksPerSecond = 0.0;
    auto walker = walkerIn(building, {RegionId("A"), {}}, options);
    Cue lost;
    lost.kind = CueKind::Unsure;
    lost.sweep = guidance::SweepStep::AskForHelp;
    walker->hear(lost);
    Point2 before = walker->position();
    double gone = 0.0;
    for (int step = 1; step <= 50; ++step) {
        walker->walkUntil(0.2 * step);
        gone += std::hypot(walker->position().x - before.x, walker->position().y - before.y);
        before = walker->position();
    }
    EXPECT_GT(gone, 2.5);
    EXPECT_LT(gone, 5.5);
}

TEST(Walker, FindsTheOnlyDoorOfARoomAndStopsAtTheArrival) {
    AsciiMap map;
    map.floor(R"(
        +-------+
        |A      |
        |       |
        |       |
        +-----/-+
        |B      |
        |       |
        +-------+
    )");
    auto building = map.build();
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        WalkerOptions options;
        options.seed = seed;
        auto walker = walkerIn(building, {RegionId("A"), {}}, options);
        walker->hear(find(Feature::Door));
        for (double t = 0.5; t < 120.0 && walker->region().value == "A"; t += 0.5) walker->walkUntil(t);
        EXPECT_EQ(walker->region().value, "B") << seed;
        Cue arrived;
        arrived.kind = CueKind::Arrived;
        walker->hear(arrived);
        walker->walkUntil(walker->time() + 5.0);
        EXPECT_TRUE(walker->arrived());
        Point2 stood = walker->position();
        walker->walkUntil(walker->time() + 20.0);
        EXPECT_EQ(walker->position(), stood);
    }
}

/// "You have arrived" alone may mean the room behind the door that one is just opening.
TEST(Walker, WhoIsToldToStopGoesThroughNoDoor) {
    auto building = twoRooms(0.8).build();
    const std::vector<Point2>& door = building->accesses().at(0).line;
    Point2 middle = (door.front() + door.back()) * 0.5;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        for (bool stop : {true, false}) {
            WalkerOptions options;
            options.seed = seed;
            options.stopsPerSecond = options.looksPerSecond = 0.0;
            auto walker = walkerIn(building, {RegionId("A"), {}}, options);
            walker->hear(find(Feature::Door));
            // He stands before it, and looks for its handle.
            Point2 before = walker->position();
            for (double t = 0.1, stood = 0.0; t < 120.0 && stood < 1.0; t += 0.1) {
                walker->walkUntil(t);
                bool stands = distance(walker->position(), before) < 1e-9;
                stood = stands && distance(before, middle) < 0.5 ? stood + 0.1 : 0.0;
                before = walker->position();
            }
            ASSERT_EQ(walker->region().value, "A") << seed;
            Cue arrived;
            arrived.kind = CueKind::Arrived;
            arrived.stop = stop;
            walker->hear(arrived);
            walker->walkUntil(walker->time() + 20.0);
            EXPECT_TRUE(walker->arrived());
            EXPECT_EQ(walker->region().value, stop ? "A" : "B") << seed;
        }
    }
}

TEST(Walker, TakesTheDoorOfTheSideThatWasTold) {
    AsciiMap map(0.8);
    map.floor(R"(
        +-----+-----+
        |B    |D    |
        +--/--+--/--+
        |A          |
        |1          |
        |           |
        +-----/-----+
        |C          |
        +-----------+
    )");
    auto building = map.build();
    int right = 0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        WalkerOptions options;
        options.seed = seed;
        options.stopsPerSecond = options.looksPerSecond = 0.0;
        auto walker = walkerIn(building, map.spot('1'), options);
        // Faces the way by a turn, as one who comes through a door does.
        WalkInstruction instruction = find(Feature::Door, -90.0);
        instruction.turnFirst = Radians{-walker->pose().heading.value};
        instruction.task.side = routing::Side::Right;
        instruction.task.number = 1;
        walker->hear(instruction);
        for (double t = 0.5; t < 90.0 && walker->region().value == "A"; t += 0.5) walker->walkUntil(t);
        right += walker->region().value == "C" ? 1 : 0;
    }
    EXPECT_GE(right, 8);
}

TEST(Walker, FindsADoorThatIsDrawnInTheMiddleOfAThickWall) {
    building::BuildingData data = twoRooms().data();
    for (Point2& p : data.accesses.at(0).line) p.y -= 0.2;
    auto building = std::make_shared<const building::Building>(std::move(data));
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        WalkerOptions options;
        options.seed = seed;
        auto walker = walkerIn(building, {RegionId("A"), {}}, options);
        walker->hear(find(Feature::Door));
        for (double t = 0.5; t < 120.0 && walker->region().value == "A"; t += 0.5) walker->walkUntil(t);
        EXPECT_EQ(walker->region().value, "B") << seed;
    }
}

TEST(Walker, FollowsAWallToTheDoorThatWasCounted) {
    AsciiMap map = test::lobbyMap();
    auto building = map.build();
    const std::map<std::pair<routing::Side, int>, std::string> kDoors{{{routing::Side::Right, 1}, "S"},
                                                                      {{routing::Side::Right, 2}, "F"},
                                                                      {{routing::Side::Left, 1}, "N"},
                                                                      {{routing::Side::Left, 2}, "E"}};
    for (const auto& [told, wanted] : kDoors) {
        int right = 0;
        for (std::uint64_t seed = 0; seed < 10; ++seed) {
            WalkerOptions options;
            options.seed = seed;
            auto walker = walkerIn(building, map.spot('1'), options);
            WalkInstruction instruction = find(Feature::Door);
            instruction.then = find(Feature::Door).task;
            instruction.then.turn.reset();
            instruction.then.side = told.first;
            instruction.then.number = told.second;
            instruction.then.alongWall = true;
            walker->hear(instruction);
            for (double t = 0.5; t < 120.0; t += 0.5) {
                walker->walkUntil(t);
                if (walker->region().value != "W" && walker->region().value != "L") break;
            }
            right += walker->region().value == wanted ? 1 : 0;
        }
        EXPECT_GE(right, 8) << wanted;
    }
}

TEST(Walker, TurnsOvershootAsThoseOfBlindWalkersDo) {
    auto building = test::asciiMap(R"(
        +---------------+
        |A              |
        |               |
        |               |
        |               |
        +-------/-------+
        |B              |
        +---------------+
    )");
    WalkerOptions options;
    options.swayDeg = options.stopsPerSecond = options.looksPerSecond = options.veerDegPerM = 0.0;
    double sum = 0.0;
    constexpr int kTurns = 300;
    for (std::uint64_t seed = 0; seed < kTurns; ++seed) {
        options.seed = seed;
        auto walker = walkerIn(building, {RegionId("A"), Point2{8.0, 5.0}}, options);
        Radians before = walker->pose().heading;
        WalkInstruction turn = find(Feature::Turn, 90.0);
        turn.now = true;
        walker->hear(turn);
        walker->walkUntil(2.0);
        sum += toDegrees(wrapped(walker->pose().heading - before)) - 90.0;
    }
    EXPECT_NEAR(sum / kTurns, 16.0, 1.0);
}

TEST(Walker, RidesTheLiftToTheLevelThatWasTold) {
    AsciiMap map;

    map.floor("+---+\n|A  |\n|   |\n+---+", 0.0);
    map.floor("+---+\n|B  |\n|   |\n+---+", 1.0);
    map.floor("+---+\n|C  |\n|   |\n+---+", 2.0);
    map.join(building::AccessKind::Elevator, 'A', 'B', "lift")
        .join(building::AccessKind::Elevator, 'B', 'C', "lift");
    auto walker = walkerIn(map.build(), {RegionId("A"), {}});
    WalkInstruction ride = find(Feature::Elevator);
    ride.task.vertical = routing::Vertical::Up;
    ride.task.level = "2";
    walker->hear(ride);
    bool between = false;
    for (double t = 0.5; t < 60.0; t += 0.5) {
        walker->walkUntil(t);
        between = between || (walker->pose().level > 0.2 && walker->pose().level < 1.8);
    }
    EXPECT_EQ(walker->region().value, "C");
    EXPECT_TRUE(between) << "a ride takes time";
}

/// A room and a lift beside one another.
AsciiMap liftBesideRoom() {
    AsciiMap map(0.8);
    map.floor(R"(
        +-----+----+
        |R    |L   |
        +--/--+-/--+
        |K         |
        |1         |
        +----------+
    )");
    map.floor(R"(
        +-----+----+
        |T    |U   |
        +--/--+-/--+
        |V         |
        |          |
        +----------+
    )",
              1.0);
    map.region('L', {"Lift", building::RegionKind::Elevator});
    map.region('U', {"Lift", building::RegionKind::Elevator});
    map.join(building::AccessKind::Elevator, 'L', 'U', "one");
    return map;
}

TEST(Walker, TakesNoRoomForALift) {
    AsciiMap map = liftBesideRoom();
    auto building = map.build();
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        WalkerOptions options;
        options.seed = seed;
        auto walker = walkerIn(building, map.spot('1'), options);
        WalkInstruction instruction = find(Feature::Door);
        instruction.task.lift = true;
        walker->hear(instruction);
        for (double t = 0.5; t < 120.0 && walker->region().value == "K"; t += 0.5) walker->walkUntil(t);
        EXPECT_NE(walker->region().value, "R") << seed;
    }
}

TEST(Walker, GoesIntoTheLiftThatItIsToTake) {
    AsciiMap map = liftBesideRoom();
    auto building = map.build();
    int upstairs = 0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        WalkerOptions options;
        options.seed = seed;
        auto walker = walkerIn(building, map.spot('1'), options);
        WalkInstruction ride = find(Feature::Elevator);
        ride.task.vertical = routing::Vertical::Up;
        ride.task.level = "1";
        walker->hear(ride);
        for (double t = 0.5; t < 180.0 && walker->region().value != "U"; t += 0.5) walker->walkUntil(t);
        upstairs += walker->region().value == "U" ? 1 : 0;
    }
    EXPECT_GE(upstairs, 8);
}

TEST(Walker, TheSameSeedWalksTheSameWay) {
    auto building = std::make_shared<const building::Building>(demo::demoBuilding());
    std::vector<Point2> ends;
    for (int run = 0; run < 2; ++run) {
        auto walker = walkerIn(building, {RegionId("0-bar"), {}});
        walker->hear(find(Feature::Door));
        walker->walkUntil(30.0);
        ends.push_back(walker->position());
    }
    EXPECT_EQ(ends[0], ends[1]);
}

TEST(Walker, AStartThatIsNotInTheMapIsRefused) {
    auto world = std::make_shared<const WalkWorld>(test::asciiMap("+---+\n|A  |\n+---+"));
    EXPECT_FALSE(Walker::create(world, {RegionId("nowhere"), {}}).ok());
    WalkerOptions wrong;
    wrong.speed = 0.0;
    EXPECT_FALSE(Walker::create(world, {RegionId("A"), {}}, wrong).ok());
}

} // namespace
} // namespace farol::simulation
