#pragma once
// The walker's body: where it really is, how it moves, and what it feels. It walks through nothing solid and
// changes regions only through accesses. The mind (walk_mind.h) knows of it only what is felt.

#include "core/localisation/random.h"
#include "core/routing/route.h"
#include "core/simulation/camera_pose.h"
#include "core/simulation/walk_world.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace farol::simulation {

struct WalkerOptions {
    std::uint64_t seed = 1;
    double speed = 0.75, speedSpread = 0.12;              ///< metres a second, and from walker to walker
    double overshootDeg = 16.0, overshootSpreadDeg = 7.0; ///< of a turn by a right angle or more
    double veerDegPerM = 2.5;                             ///< off a line without a wall beside it
    double caneReachM = 1.1;
    double swayDeg = 24.0, swaySeconds = 8.2; ///< of the camera about the way of walking
    double stopsPerSecond = 0.03, looksPerSecond = 0.018;
    double wilfulness = 0.0; ///< chance, at each door passed, to go through it although nobody said so
    double eyeHeightM = 1.4;

    Result<void> check() const;
};

/// A door, an opening, stairs or a lift within reach. `handle` names it only as long as it is felt.
struct Felt {
    std::size_t handle = 0;
    building::AccessKind kind = building::AccessKind::Door;
    Radians bearing; ///< from the way the body faces, left positive
    double distance = 0.0;
    routing::Vertical vertical = routing::Vertical::None;
    bool cameThrough = false; ///< the last one passed
    bool lift = false;        ///< a door, and one of a lift: it slides, and there is a button beside it
};

/// A wall beside, trailed with the cane: how far, and how it runs to the way one goes.
struct WallFelt {
    double distance = 0.0;
    Radians direction;
};

struct Touch {
    std::optional<double> ahead; ///< empty: free as far as the cane reaches
    std::optional<WallFelt> left, right;
    std::vector<Felt> felt;
};

class WalkBody {
public:
    WalkBody(std::shared_ptr<const WalkWorld> world, std::size_t region, Point2 position, Radians heading,
             const WalkerOptions& options);

    /// One step of `seconds`: walking at that speed and turning at that rate, unless a passage is being
    /// taken.
    void step(double seconds, double speed, Radians turnRate);
    /// Takes what is felt. Of a lift `level` is the button; empty: the next level that way.
    void take(const Felt& felt, const std::string& level);
    /// Leaves a door or opening that is being taken, if it is not passed yet.
    void stop();
    bool busy() const { return !m_legs.empty(); }
    /// What was passed since it was last asked: by `take`, or an opening simply walked through.
    std::optional<building::AccessKind> takePassed() { return std::exchange(m_passed, std::nullopt); }

    Touch touch() const;
    Point2 position() const { return m_position; }
    std::size_t region() const { return m_region; }
    double level() const { return m_level; }
    Radians heading() const { return m_heading; }
    double walkedM() const { return m_walkedM; } ///< on the flat
    double speed() const { return m_speed; }
    Radians turnRate() const { return m_turnRate; }

private:
    /// A part of a passage: to a point, waiting before it, or up and down.
    struct Leg {
        Point2 to;
        double waitS = 0.0;
        double climbS = 0.0, climbFrom = 0.0, climbTo = 0.0;
        std::optional<std::size_t> region{};  ///< one is in at its end
        std::optional<std::size_t> through{}; ///< access passed at its end
        double climbedS = 0.0;
    };

    void followLeg(double seconds);
    void walkFreely(double seconds, double speed);
    void beginPassage(const Passage& passage, Point2 at, double waitS);
    void ride(const Passage& first, const std::string& level);
    bool reaches(const Passage& passage, Felt& felt) const;

    std::shared_ptr<const WalkWorld> m_world;
    WalkerOptions m_options;
    std::size_t m_region;
    Point2 m_position;
    double m_level;
    Radians m_heading, m_turnRate;
    double m_speed = 0.0, m_walkedM = 0.0;
    std::deque<Leg> m_legs;
    std::optional<std::size_t> m_cameThrough; ///< access
    std::optional<building::AccessKind> m_passed;
};

} // namespace farol::simulation
