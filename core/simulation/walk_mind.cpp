#include "core/simulation/walk_mind.h"

#include <algorithm>
#include <cmath>

namespace farol::simulation {

using building::AccessKind;
using guidance::SweepStep;
using routing::Side;
using routing::Vertical;

namespace {

constexpr Radians kTurnRate = fromDegrees(75.0), kSweepRate = fromDegrees(18.0);
constexpr double kBeside = 35.0 * kPi / 180.0;  ///< what is further round than this is beside, not ahead
constexpr double kBehind = 120.0 * kPi / 180.0; ///< and what is further round than this is passed
constexpr double kRealTurn = 40.0 * kPi / 180.0;
/// From a wall that is trailed, and how straight after it one walks.
constexpr double kTrailM = 0.55, kTrailGain = 1.2, kTrailMostTurn = 0.6;
/// Nearer than this a wall ahead is turned away from.
constexpr double kWallAheadM = 0.6;
/// Past the end of a wall one walks on this far before one turns after it.
constexpr double kTrailedM = 1.5, kWallEndedM = 0.5, kLostWallM = 3.2, kRoundCornerM = 0.4;
/// An order to act now is still that one so much later.
constexpr double kNowS = 7.0;
/// The same order within this time after it was done is late, not new.
constexpr double kLateOrderS = 25.0, kLateUnnamedS = 4.0;
/// Told nothing more, one walks on so far and stands; the long silence after which one tries a little
/// further.
constexpr double kWalkOnM = 6.0, kPatienceS = 12.0;
constexpr double kFewStepsM = 4.0;
/// Behind the last door one is there.
constexpr double kInsideM = 1.5;
/// A distance that was told is trusted this far.
constexpr double kDistanceTrustM = 2.5, kDistanceDoubt = 0.2;
/// Doors may be missed in counting; an order to act is believed over a count that is this much short.
constexpr int kCountDoubt = 1;
/// So far a door that is said to be ahead is looked for in front only.
constexpr double kAheadM = 8.0;
constexpr double kLookDeg = 100.0, kLookSeconds = 6.0;
/// A wrong turn, and the door that is taken meanwhile, if there is one.
constexpr double kWrongS = 9.0;

int signOf(double value) {
    return value > 0.0 ? 1 : -1;
}

} // namespace

WalkMind::WalkMind(const WalkerOptions& options, localisation::Random& random)
    : m_options(options), m_random(random), m_pace(options.speed + options.speedSpread * random.normal()) {
    m_pace = std::clamp(m_pace, 0.5 * options.speed, 1.5 * options.speed);
    m_swayPhase = 2.0 * kPi * random.uniformDouble();
}

void WalkMind::hear(const WalkInstruction& instruction) {
    if (instruction.stop) m_afterwards.reset(); // of a door that is not gone through now
    if (m_arrived || m_wrongS > 0.0 || instruction.order == Order::Inform) return;
    m_everTold = true;
    m_silentS = 0.0;
    switch (instruction.order) {
    case Order::Inform:
        break;
    case Order::Arrived:
        m_arrived = true;
        break;
    case Order::Halt:
        m_halted = true;
        m_task = m_then = {};
        break;
    case Order::GoOn:
        m_halted = false;
        m_toldM = 0.0;
        break;
    case Order::Sweep:
        m_sweep = instruction.sweep;
        m_sweepS = m_sweepTurned = 0.0;
        if (m_sweep == SweepStep::Done) {
            m_turnLeft = -m_sweepBack + 0.15 * normal();
            m_sweepBack = 0.0;
            m_sweep = SweepStep::None;
        }
        if (m_sweep == SweepStep::AskForHelp) fewSteps();
        break;
    case Order::Go:
        go(instruction);
        break;
    }
}

/// "Move a few steps along a wall": also who was not told of any way yet.
void WalkMind::fewSteps() {
    if (m_task.feature != Feature::None) return;
    m_halted = false;
    m_legKnown = true;
    m_toldM = kWalkOnM - kFewStepsM;
}

void WalkMind::go(const WalkInstruction& instruction) {
    m_halted = false;
    if (m_sweep != SweepStep::None) m_sweep = SweepStep::None;
    // An order without the name of a place may be the next one of its kind.
    bool named = !instruction.task.into.empty() && !m_lastDone.into.empty();
    bool late = !instruction.turnFirst && m_sinceDone < (named ? kLateOrderS : kLateUnnamedS) &&
                sameTask(instruction.task, m_lastDone) && !instruction.astray;
    if (late) return;
    if (!sameTask(instruction.task, m_task)) {
        m_searchedM = 0.0;
        m_nextReverseM = 0.0;
    }
    m_task = instruction.task;
    m_then = instruction.then;
    m_taskM = instruction.distanceM;
    m_toldM = 0.0;
    m_counted = {}; // "the second door" counts from where it is heard
    if (instruction.now) m_sinceNow = 0.0;
    if (instruction.astray) {
        m_astray = true;
        beginLeg(false);
    }
    if (instruction.turnFirst) {
        turnBy(*instruction.turnFirst);
        beginLeg(true);
    } else if (instruction.hour) {
        Radians towards = wrapped(fromDegrees(-30.0 * *instruction.hour));
        bool wayAlong = m_legKnown && std::abs(towards.value) < kPi / 2.0;
        if (!wayAlong && std::abs(towards.value) > kRealTurn) turnBy(towards);
    }
    if (m_task.feature == Feature::Turn && instruction.now && m_task.turn) {
        turnBy(*m_task.turn);
        beginLeg(true);
        done();
    }
}

void WalkMind::takeWrongTurn() {
    if (m_arrived) return;
    m_wrongS = kWrongS;
    m_everTold = true;
    m_halted = false;
    m_sweep = SweepStep::None;
    m_restS = m_lookS = 0.0;
    m_task = m_then = {};
    m_afterwards.reset();
    turnBy(Radians{(chance(0.5) ? 1.0 : -1.0) * kPi * (0.5 + 0.4 * m_random.uniformDouble())});
    beginLeg(true);
    m_toldM = 0.0;
}

void WalkMind::beginLeg(bool known) {
    m_legKnown = known;
    m_counted = {};
    m_considered.clear();
    m_lostM = m_searchedM = m_trailedM = 0.0;
    m_nextReverseM = 0.0;
}

void WalkMind::done() {
    m_lastDone = m_task;
    m_sinceDone = 0.0;
    m_task = m_then;
    m_then = {};
    m_taskM.reset();
    m_toldM = 0.0;
    m_sinceNow = 1e9;
    m_astray = false;
}

void WalkMind::turnBy(Radians turn) {
    double size = std::abs(turn.value);
    double over = (m_options.overshootDeg + m_options.overshootSpreadDeg * normal()) *
                  std::min(1.0, size / (kPi / 2.0));
    m_turnLeft = turn.value + signOf(turn.value) * fromDegrees(over).value;
    m_trail = Trail::None;
    m_lostM = 0.0;
}

void WalkMind::passed(AccessKind kind) {
    bool mine = (m_task.feature == Feature::Door && kind == AccessKind::Door) ||
                (m_task.feature == Feature::Opening && kind == AccessKind::Opening) ||
                (m_task.feature == Feature::Stairs && kind == AccessKind::Stairs) ||
                (m_task.feature == Feature::Elevator && kind == AccessKind::Elevator) ||
                (m_task.feature == Feature::Escalator && kind == AccessKind::Escalator) ||
                (m_task.feature == Feature::Ramp && kind == AccessKind::Ramp);
    bool levels = kind == AccessKind::Stairs || kind == AccessKind::Elevator || kind == AccessKind::Escalator;
    beginLeg(!levels && (mine || (m_legKnown && kind == AccessKind::Opening)));
    if (kind != AccessKind::Opening) m_trail = Trail::None;
    if (mine) done();
}

/// Where the camera looks: swaying about the way, nodding a little, and now and then all around.
void WalkMind::look(double seconds) {
    m_swayPhase += 2.0 * kPi * seconds / m_options.swaySeconds * (1.0 + 0.3 * normal());
    m_nod += seconds * (-m_nod / 2.0) + 0.02 * std::sqrt(seconds) * normal();
    double yaw = fromDegrees(m_options.swayDeg).value * std::sin(m_swayPhase);
    if (m_lookS > 0.0) {
        m_lookS -= seconds;
        m_lookPhase += 2.0 * kPi * seconds / kLookSeconds;
        yaw = fromDegrees(kLookDeg).value * std::sin(m_lookPhase);
    }
    double pitch = m_nod;
    if (m_sweep == SweepStep::Up) pitch += fromDegrees(25.0).value * std::min(1.0, m_sweepS / 3.0);
    if (m_sweep == SweepStep::Down) pitch -= fromDegrees(20.0).value * std::min(1.0, m_sweepS / 3.0);
    m_cameraYaw = Radians{yaw};
    m_cameraPitch = Radians{pitch};
}

std::optional<Wish> WalkMind::turning(double seconds) {
    if (m_turnLeft == 0.0) return std::nullopt;
    double step = std::min(std::abs(m_turnLeft), kTurnRate.value * seconds) * signOf(m_turnLeft);
    m_turnLeft -= step;
    if (std::abs(m_turnLeft) < 1e-6) m_turnLeft = 0.0;
    return Wish{0.0, Radians{step / seconds}, {}, {}};
}

std::optional<Wish> WalkMind::sweeping(double seconds) {
    if (m_sweep == SweepStep::None) return std::nullopt;
    m_sweepS += seconds;
    double limit = m_sweep == SweepStep::Right ? kPi / 2.0 : m_sweep == SweepStep::Left ? kPi : 0.0;
    if (m_sweep == SweepStep::AskForHelp) {
        if (m_sweepS < 20.0) return std::nullopt; // a few steps along a wall, as told
        m_sweep = SweepStep::None;
        return std::nullopt;
    }
    if (m_sweepS > 20.0) m_sweep = SweepStep::None;
    if (m_sweepTurned >= limit) return Wish{};
    double step = kSweepRate.value * seconds;
    m_sweepTurned += step;
    int sign = m_sweep == SweepStep::Left ? 1 : -1;
    m_sweepBack = wrapped(Radians{m_sweepBack + sign * step}).value;
    return Wish{0.0, Radians{sign * step / seconds}, {}, {}};
}

std::optional<Wish> WalkMind::resting(double seconds) {
    if (m_restS > 0.0) {
        m_restS -= seconds;
        return Wish{};
    }
    if (chance(m_options.stopsPerSecond * seconds)) m_restS = 1.0 + 4.0 * m_random.uniformDouble();
    if (chance(m_options.looksPerSecond * seconds)) {
        m_restS = m_lookS = kLookSeconds;
        m_lookPhase = 0.0;
    }
    return std::nullopt;
}

void WalkMind::pass(double seconds) {
    m_wrongS = std::max(0.0, m_wrongS - seconds);
    m_sinceDone += seconds;
    m_sinceNow += seconds;
    look(seconds);
}

Wish WalkMind::decide(double seconds, const Touch& touch) {
    pass(seconds);
    count(touch);
    m_standing = true;
    if (m_arrived || !m_everTold) return {};
    if (m_afterwards) {
        if (std::abs(m_afterwards->value) > 0.1) turnBy(*m_afterwards);
        m_afterwards.reset();
    }
    if (auto wish = turning(seconds)) return *wish;
    if (auto wish = sweeping(seconds)) return *wish;
    if (m_halted) return {};
    if (auto wish = resting(seconds)) return *wish;
    if (auto wish = stray(touch)) return *wish;
    Wish wish = m_task.feature == Feature::None ? walkOn(seconds, touch) : seek(seconds, touch);
    m_standing = wish.speed <= 0.0 && !wish.take;
    return wish;
}

/// Doors beside, each once, as somebody counts who walks along a wall.
void WalkMind::count(const Touch& touch) {
    for (const Felt& felt : touch.felt) {
        bool counted =
            felt.kind == (m_task.feature == Feature::Opening ? AccessKind::Opening : AccessKind::Door);
        double off = std::abs(felt.bearing.value);
        if (!counted || felt.cameThrough || off < kBeside || (m_task.alongWall && off > kBehind)) continue;
        auto& doors = m_counted[felt.bearing.value > 0.0 ? 0 : 1];
        if (std::find(doors.begin(), doors.end(), felt.handle) == doors.end()) doors.push_back(felt.handle);
    }
}

bool WalkMind::straight() const {
    return m_task.turn && std::abs(m_task.turn->value) < kRealTurn && m_task.side == Side::None;
}

WalkMind::Trail WalkMind::wantedSide() const {
    if (m_task.side != Side::None) return m_task.side == Side::Left ? Trail::Left : Trail::Right;
    if (m_legKnown && m_task.turn && std::abs(m_task.turn->value) > kRealTurn &&
        std::abs(m_task.turn->value) < 2.8)
        return m_task.turn->value > 0.0 ? Trail::Left : Trail::Right;
    return Trail::None;
}

/// Is that what was told to be taken?
bool WalkMind::fits(const Felt& felt) const {
    switch (m_task.feature) {
    case Feature::Stairs:
    case Feature::Escalator: {
        bool kind =
            felt.kind == (m_task.feature == Feature::Stairs ? AccessKind::Stairs : AccessKind::Escalator);
        return kind && (m_task.vertical == Vertical::None || felt.vertical == m_task.vertical);
    }
    case Feature::Elevator:
        // Told before its door, one goes in first.
        if (felt.lift) return !felt.cameThrough;
        return felt.kind == AccessKind::Elevator &&
               (m_task.vertical == Vertical::None || felt.vertical == m_task.vertical);
    case Feature::Ramp:
        return felt.kind == AccessKind::Ramp;
    case Feature::Door:
        return felt.kind == AccessKind::Door && (felt.lift || !m_task.lift);
    case Feature::Opening:
        return felt.kind == AccessKind::Opening && (felt.lift || !m_task.lift);
    case Feature::Turn:
    case Feature::None:
        break;
    }
    return false;
}

/// Of a door or opening within reach: is it the one, going by its side, its number and what was told of when?
bool WalkMind::isDoorOfMine(const Felt& felt) {
    bool now = m_sinceNow < kNowS;
    if (m_task.alongWall) {
        const auto& doors = m_counted[m_task.side == Side::Left ? 0 : 1];
        auto nth = static_cast<std::size_t>(m_task.number);
        return nth >= 1 && nth <= doors.size() && doors[nth - 1] == felt.handle;
    }
    if (felt.cameThrough && !m_astray && m_searchedM < 15.0) return false;
    Trail side = wantedSide();
    bool ahead = std::abs(felt.bearing.value) < kBeside;
    bool left = felt.bearing.value > 0.0;
    // What is said to be far off is not the door at hand, and what is ahead is not the one beside.
    double togo = m_taskM ? *m_taskM - m_toldM : 0.0;
    if (m_taskM && togo > kDistanceTrustM + kDistanceDoubt * *m_taskM) return false;
    if (m_task.ahead && m_legKnown && !ahead && m_searchedM < kAheadM + m_taskM.value_or(0.0)) return false;
    if (!m_legKnown) {
        // Along a wall whose doors are counted, but which way? Only an order to act settles it.
        return m_task.side == Side::None || now;
    }
    if (side == Trail::None) return ahead || now || m_searchedM > 4.0 || m_task.feature == Feature::Door;
    if (!ahead && left != (side == Trail::Left)) return false;
    if (now) return true;
    if (m_task.number > 0)
        return static_cast<int>(m_counted[side == Trail::Left ? 0 : 1].size()) >= m_task.number;
    return !m_taskM || m_toldM >= *m_taskM - kDistanceTrustM;
}

const Felt* WalkMind::wanted(const Touch& touch) {
    for (const Felt& felt : touch.felt) {
        if (!fits(felt)) continue;
        bool door = m_task.feature == Feature::Door || m_task.feature == Feature::Opening;
        if (!door || isDoorOfMine(felt)) return &felt;
    }
    return nullptr;
}

Wish WalkMind::takeIt(const Felt& felt) {
    double turn = m_task.turn.value_or(Radians{}).value;
    bool beside = std::abs(felt.bearing.value) > kBeside;
    // A door in the wall that is walked along is itself the turn; behind one that lies ahead the turn
    // follows.
    bool turned = m_task.side != Side::None || (m_legKnown && beside && std::abs(turn) > kRealTurn);
    m_afterwards = m_task.behind ? *m_task.behind : turned ? Radians{} : Radians{turn};
    Wish wish;
    wish.take = felt;
    wish.level = m_task.level;
    return wish;
}

std::optional<Wish> WalkMind::stray(const Touch& touch) {
    bool wrong = m_wrongS > 0.0;
    if (m_options.wilfulness <= 0.0 && !wrong) return std::nullopt;
    for (const Felt& felt : touch.felt) {
        if (felt.kind != AccessKind::Door || felt.cameThrough || !m_considered.insert(felt.handle).second)
            continue;
        if (!wrong && !chance(m_options.wilfulness)) continue;
        m_wrongS = std::min(m_wrongS, 3.0);
        m_afterwards = Radians{};
        Wish wish;
        wish.take = felt;
        return wish;
    }
    return std::nullopt;
}

Wish WalkMind::seek(double seconds, const Touch& touch) {
    if (const Felt* felt = wanted(touch)) return takeIt(*felt);
    Wish wish = steer(seconds, touch);
    double gone = wish.speed * seconds;
    m_toldM += gone;
    m_searchedM += gone;
    // Told to act, and it is not here: back the way one came, then further.
    bool overdue = m_legKnown && wantedSide() != Trail::None && m_sinceNow > kNowS && m_sinceNow < 60.0;
    if (overdue && m_nextReverseM == 0.0) m_nextReverseM = m_searchedM + 3.0;
    return wish;
}

/// Nothing to look for: on along the way a little, then one stands and waits for a word.
Wish WalkMind::walkOn(double seconds, const Touch& touch) {
    double onM = m_lastDone.last ? kInsideM : kWalkOnM;
    bool enough = m_toldM >= onM || (!m_legKnown && m_toldM >= 1.0);
    if (enough) {
        m_silentS += seconds;
        if (m_silentS > 3.0 && m_lookS <= 0.0 && chance(0.2 * seconds)) {
            m_lookS = kLookSeconds;
            m_lookPhase = 0.0;
        }
        if (m_silentS > kPatienceS) {
            m_silentS = 0.0;
            m_toldM = std::max(0.0, onM - 4.0);
            m_legKnown = true;
        }
        return {};
    }
    Wish wish = steer(seconds, touch);
    m_toldM += wish.speed * seconds;
    return wish;
}

/// A wall ahead: round along it, to the side that was told if one was.
void WalkMind::meetWall(const Touch& touch) {
    bool toLeft = false;
    // Where the wall at hand has just ended the way goes round its corner.
    bool rounds = m_trailedM > kTrailedM && m_lostM > kWallEndedM;
    if (m_trail != Trail::None)
        toLeft = (m_trail == Trail::Right) != rounds;
    else if (m_task.feature == Feature::Turn && m_task.turn)
        toLeft = m_task.turn->value > 0.0;
    else if (touch.left.has_value() != touch.right.has_value())
        toLeft = touch.right.has_value();
    else
        toLeft = chance(0.5);
    if (m_task.feature == Feature::Turn && m_task.turn && (m_task.turn->value > 0.0) == toLeft &&
        m_legKnown) {
        done();
        beginLeg(true);
    }
    m_trail = toLeft ? Trail::Right : Trail::Left;
    m_turnLeft = (toLeft ? 1.0 : -1.0) * (0.5 + 0.1 * normal());
    m_lostM = 0.0;
}

/// The wall that was trailed has ended: straight on for a while, then after it, round its corner.
void WalkMind::loseWall(double gone) {
    m_lostM += gone;
    bool turnsHere = m_task.feature == Feature::Turn && m_task.turn && m_legKnown &&
                     (m_task.turn->value > 0.0) == (m_trail == Trail::Left);
    if (turnsHere && m_lostM > 0.5) {
        Radians turn = *m_task.turn;
        done();
        turnBy(turn);
        beginLeg(true);
        return;
    }
    // The hand that follows a wall goes round its corner.
    if (straight() || m_lostM < (m_task.alongWall ? kRoundCornerM : kLostWallM)) return;
    m_turnLeft = (m_trail == Trail::Left ? 1.0 : -1.0) * kPi / 2.0;
    m_lostM = -1.0;
}

Wish WalkMind::steer(double seconds, const Touch& touch) {
    Wish wish;
    wish.speed = m_pace * (1.0 + 0.08 * normal());
    double gone = wish.speed * seconds;
    if (touch.ahead && *touch.ahead < kWallAheadM) {
        meetWall(touch);
        return {};
    }
    if (m_nextReverseM > 0.0 && m_searchedM > m_nextReverseM) {
        m_turnLeft = kPi;
        m_trail = m_trail == Trail::Left ? Trail::Right : m_trail == Trail::Right ? Trail::Left : Trail::None;
        m_nextReverseM = m_searchedM + 1e6;
        m_legKnown = false;
        return {};
    }
    Trail side = wantedSide();
    if (side != Trail::None && side != m_trail && m_legKnown) {
        m_trail = side;
        m_lostM = 0.0;
        // Across to the other wall.
        bool there = side == Trail::Left ? touch.left.has_value() : touch.right.has_value();
        double across = side == Trail::Left ? 1.0 : -1.0;
        if (!there && m_task.alongWall) {
            // It begins with the wall of the door that was come through.
            m_turnLeft = across * kPi / 2.0;
            return {};
        }
        if (!there) m_veer = across * 0.35;
    }
    if (m_trail == Trail::None && touch.left.has_value() != touch.right.has_value())
        m_trail = touch.left ? Trail::Left : Trail::Right;
    if (m_trail == Trail::None && touch.left) m_trail = chance(0.5) ? Trail::Left : Trail::Right;
    const std::optional<WallFelt>& wall = m_trail == Trail::Left ? touch.left : touch.right;
    m_veer += fromDegrees(m_options.veerDegPerM).value * std::sqrt(gone) * normal();
    if (m_trail != Trail::None && wall) {
        double off = (wall->distance - kTrailM) * (m_trail == Trail::Left ? 1.0 : -1.0) * kTrailGain;
        double turn =
            std::clamp(wall->direction.value + std::clamp(off, -kTrailMostTurn, kTrailMostTurn), -1.0, 1.0);
        wish.turnRate = Radians{turn / std::max(seconds, 0.5)};
        m_veer = 0.0;
        m_lostM = 0.0;
        m_trailedM += gone;
        return wish;
    }
    wish.turnRate = Radians{std::clamp(m_veer, -0.5, 0.5) * (m_trail == Trail::None ? 0.3 : 1.0)};
    m_veer *= 1.0 - std::min(1.0, 0.7 * seconds);
    if (m_trail != Trail::None) loseWall(gone);
    return wish;
}

} // namespace farol::simulation
