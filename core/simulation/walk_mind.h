#pragma once
// What the walker makes of what is told and felt. It knows neither map nor route nor where it is.

#include "core/simulation/walk_body.h"
#include "core/simulation/walk_instruction.h"

#include <array>
#include <optional>
#include <set>
#include <vector>

namespace farol::simulation {

/// What the body is to do next.
struct Wish {
    double speed = 0.0;
    Radians turnRate;
    std::optional<Felt> take;
    std::string level; ///< of a lift
};

class WalkMind {
public:
    WalkMind(const WalkerOptions& options, localisation::Random& random);

    void hear(const WalkInstruction& instruction);
    /// For some seconds one goes another way than was told, through the first door at hand, and listens to
    /// nobody.
    void takeWrongTurn();
    /// What was told of an arrival is past: there is a new way to go.
    void forgetArrival() { m_arrived = false; }
    /// The body came through something, wanted or not.
    void passed(building::AccessKind kind);
    Wish decide(double seconds, const Touch& touch);
    /// The same time while the body is busy with a door, stairs or a lift.
    void pass(double seconds);

    bool arrived() const { return m_arrived; }
    bool standing() const { return m_standing; }
    Radians cameraYaw() const { return m_cameraYaw; } ///< of the camera against the body
    Radians cameraPitch() const { return m_cameraPitch; }

private:
    enum class Trail { None, Left, Right };

    void fewSteps();
    void go(const WalkInstruction& instruction);
    void look(double seconds);
    std::optional<Wish> turning(double seconds);
    std::optional<Wish> sweeping(double seconds);
    std::optional<Wish> resting(double seconds);
    Wish seek(double seconds, const Touch& touch);
    Wish walkOn(double seconds, const Touch& touch);
    Wish steer(double seconds, const Touch& touch);
    void meetWall(const Touch& touch);
    void loseWall(double gone);
    std::optional<Wish> stray(const Touch& touch);
    const Felt* wanted(const Touch& touch);
    bool fits(const Felt& felt) const;
    bool isDoorOfMine(const Felt& felt);
    void count(const Touch& touch);
    Wish takeIt(const Felt& felt);
    void turnBy(Radians turn);
    void beginLeg(bool known);
    void done();
    Trail wantedSide() const;
    bool straight() const;
    double normal() { return m_random.normal(); }
    bool chance(double probability) { return m_random.uniformDouble() < probability; }

    WalkerOptions m_options;
    localisation::Random& m_random;
    double m_pace;

    bool m_everTold = false, m_halted = false, m_arrived = false, m_standing = true;
    WalkTask m_task, m_then, m_lastDone;
    double m_sinceDone = 1e9, m_sinceNow = 1e9;
    double m_toldM = 0.0;          ///< walked since the present task was told
    std::optional<double> m_taskM; ///< how far it is, as told
    bool m_astray = false;
    double m_wrongS = 0.0; ///< of a wrong turn, still to come

    bool m_legKnown = false; ///< one walks the way that was told
    /// Doors on the left and on the right of this way, in the order in which they were felt.
    std::array<std::vector<std::size_t>, 2> m_counted;
    std::set<std::size_t> m_considered; ///< by the wilful one
    Trail m_trail = Trail::None;
    double m_trailedM = 0.0; ///< along walls of this way
    double m_lostM = 0.0, m_searchedM = 0.0, m_nextReverseM = 0.0;

    std::optional<Radians> m_afterwards; ///< turn to make behind the passage
    double m_turnLeft = 0.0;             ///< radians still to turn
    double m_veer = 0.0;
    guidance::SweepStep m_sweep = guidance::SweepStep::None;
    double m_sweepTurned = 0.0, m_sweepS = 0.0, m_sweepBack = 0.0;
    double m_restS = 0.0, m_lookS = 0.0, m_swayPhase = 0.0, m_lookPhase = 0.0, m_nod = 0.0;
    double m_silentS = 0.0;
    Radians m_cameraYaw, m_cameraPitch;
};

} // namespace farol::simulation
