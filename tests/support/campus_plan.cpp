#include "tests/support/campus_plan.h"

#include <cmath>
#include <utility>

namespace farol::test {

namespace {

constexpr double kHallM = 12.0, kStairsM = 4.0, kLiftM = 2.5;
const std::vector<Slot> kEntrance{
    {SlotKind::Hall, kHallM}, {SlotKind::Stairwell, kStairsM}, {SlotKind::Lift, kLiftM}};
const std::vector<Slot> kSecondStairs{{SlotKind::Stairwell, kStairsM}};
constexpr Point2 kEast{1.0, 0.0}, kNorth{0.0, 1.0}, kWest{-1.0, 0.0}, kSouth{0.0, -1.0};

struct Sizes {
    double width, room, corridor; // of the building, and the depths of rooms and corridors
};

double wholeMetres(CampusRandom& random, double low, double high) {
    return std::floor(random.between(low, high));
}

/// Rooms on both sides of a corridor; a long one is parted in two by a wide opening.
FloorPlan straight(const Sizes& sizes) {
    const auto [width, room, corridor] = sizes;
    double low = room, high = room + corridor;
    FloorPlan plan;
    plan.width = width;
    plan.depth = high + room;
    std::size_t parts = width >= 50.0 ? 2 : 1;
    double part = width / static_cast<double>(parts);
    for (std::size_t i = 0; i < parts; ++i) {
        double west = part * static_cast<double>(i);
        plan.corridors.push_back({rectangle(west, low, west + part, high), {}});
        if (i > 0) plan.joints.push_back({{west, low}, {west, high}});
        plan.rows.push_back(
            {{west, low}, kEast, kSouth, part, room, i, i == 0 ? kEntrance : std::vector<Slot>(), {}});
        plan.rows.push_back({{west, high}, kEast, kNorth, part, room, i, {}, {}});
    }
    if (parts > 1) plan.rows.back().fixed = kSecondStairs;
    plan.sideDoor = Polyline{{width, low + 0.5}, {width, high - 0.5}};
    return plan;
}

/// A wing to the east and one to the north, with one corridor round the bend.
FloorPlan bent(const Sizes& sizes, double depth) {
    const auto [width, room, corridor] = sizes;
    double in = room, out = room + corridor;
    FloorPlan plan;
    plan.width = width;
    plan.depth = depth;
    plan.corridors.push_back(
        {{{in, in}, {width, in}, {width, out}, {out, out}, {out, depth}, {in, depth}}, {}});
    plan.rows.push_back({{in, in}, kEast, kSouth, width - in, room, 0, kEntrance, {}});
    plan.rows.push_back(
        {{in, depth}, kSouth, kWest, depth - in, room, 0, kSecondStairs, rectangle(0, 0, in, in)});
    plan.rows.push_back({{out + room, out}, kEast, kNorth, width - out - room, room, 0, {}, {}});
    plan.rows.push_back({{out, out}, kNorth, kEast, depth - out, room, 0, {}, {}});
    plan.sideDoor = Polyline{{width, in + 0.5}, {width, out - 0.5}};
    return plan;
}

/// A corridor all round, rooms outside and two rows of rooms back to back inside.
FloorPlan ring(const Sizes& sizes) {
    const auto [width, room, corridor] = sizes;
    double in = room, out = room + corridor, depth = 4 * room + 2 * corridor;
    double east = width - in, north = depth - in, core = width - 2 * out;
    FloorPlan plan;
    plan.width = width;
    plan.depth = depth;
    plan.corridors.push_back(
        {rectangle(in, in, east, north), {rectangle(out, out, width - out, depth - out)}});
    plan.rows = {
        {{in, in}, kEast, kSouth, east - in, room, 0, kEntrance, rectangle(east, 0, width, in)},
        {{east, in}, kNorth, kEast, north - in, room, 0, {}, rectangle(east, north, width, depth)},
        {{east, north}, kWest, kNorth, east - in, room, 0, kSecondStairs, rectangle(0, north, in, depth)},
        {{in, north}, kSouth, kWest, north - in, room, 0, {}, rectangle(0, 0, in, in)},
        {{out, out}, kEast, kNorth, core, room, 0, {}, {}},
        {{out, depth - out}, kEast, kSouth, core, room, 0, {{SlotKind::Hall, kHallM}}, {}},
    };
    return plan;
}

} // namespace

Ring rectangle(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

FloorPlan floorPlan(PlanShape shape, bool small, CampusRandom& random) {
    Sizes sizes{};
    sizes.width = small ? wholeMetres(random, 26.0, 31.0) : wholeMetres(random, 40.0, 76.0);
    sizes.room = small ? 5.0 : wholeMetres(random, 5.0, 8.0);
    sizes.corridor = 0.2 * wholeMetres(random, 10.0, 16.0);
    switch (shape) {
    case PlanShape::Straight:
        return straight(sizes);
    case PlanShape::Bent:
        sizes.width += 4.0;
        return bent(sizes, 2 * sizes.room + sizes.corridor + wholeMetres(random, 10.0, small ? 15.0 : 30.0));
    case PlanShape::Ring:
        sizes.width += 10.0;
        return ring(sizes);
    }
    return straight(sizes);
}

} // namespace farol::test
