#pragma once
// What an obedient walker takes from a cue: no more than its sentence says. Neither the route nor any place
// on the map is in it. `Cue`s are reduced to it, and a sentence can be parsed back into it.

#include "core/guidance/cue.h"

#include <optional>
#include <string>

namespace farol::simulation {

/// What is to be found and taken, or done.
enum class Feature { None, Door, Opening, Stairs, Elevator, Escalator, Ramp, Turn };

struct WalkTask {
    Feature feature = Feature::None;
    routing::Vertical vertical = routing::Vertical::None;
    std::optional<Radians>
        turn{}; ///< as a turn word has it: 45, 90, 135 or 180 degrees, left positive; 0: straight on
    std::optional<Radians> behind{}; ///< the turn to make behind it, where that is told apart
    routing::Side side = routing::Side::None;
    bool lift = false;      ///< of a door or opening: a lift's
    bool ahead = false;     ///< of a door or opening: the one in front, not one beside
    int number = 0;         ///< the how-manyeth on that side; 0: not told
    bool alongWall = false; ///< the wall on that side is to be followed, and its doors counted
    bool last = false;      ///< behind it is the destination
    std::string level{};    ///< of a lift: what to choose
    std::string into{};     ///< the place it leads to, by name: tells one order from another
};

enum class Order { Inform, Go, GoOn, Halt, Sweep, Arrived };

struct WalkInstruction {
    Order order = Order::Inform;
    bool now = false;    ///< to be done at once
    bool astray = false; ///< the way was left: what was known of it is void
    bool stop = false;   ///< at once, also with the hand on a door's handle
    guidance::SweepStep sweep = guidance::SweepStep::None;
    std::optional<Radians> turnFirst;
    std::optional<int> hour;
    std::optional<double> distanceM;
    WalkTask task, then;
};

/// Is it the same thing to do, as far as was said?
bool sameTask(const WalkTask& a, const WalkTask& b);

WalkInstruction instructionOf(const guidance::Cue& cue);

} // namespace farol::simulation
