#pragma once
// A person with a camera who walks through a building on what is told and felt, and on nothing else. The same
// options, times and words give the same walk.

#include "core/building/info.h"
#include "core/simulation/walk_mind.h"

#include <memory>

namespace farol::simulation {

class Walker {
public:
    /// NotFound for a start that is not in the map. Without a position one is drawn; the way the walker
    /// faces is drawn always.
    static Result<std::unique_ptr<Walker>> create(std::shared_ptr<const WalkWorld> world,
                                                  const building::Location& start,
                                                  const WalkerOptions& options = {});

    void hear(const guidance::Cue& cue) { hear(instructionOf(cue)); }
    void hear(const WalkInstruction& instruction);
    void takeWrongTurn() { m_mind.takeWrongTurn(); }
    void forgetArrival() { m_mind.forgetArrival(); }
    /// On to that time, in steps of at most a tenth of a second.
    void walkUntil(double time);

    /// Told of arrival, and come to a stand.
    bool arrived() const { return m_mind.arrived() && !m_body.busy(); }
    CameraPose pose() const;
    // The truth; nobody who guides may look at it.
    Point2 position() const { return m_body.position(); }
    const RegionId& region() const;
    double walkedM() const { return m_body.walkedM(); }
    double time() const { return m_time; }

private:
    Walker(std::shared_ptr<const WalkWorld> world, std::size_t region, const building::Location& start,
           const WalkerOptions& options);

    std::shared_ptr<const WalkWorld> m_world;
    WalkerOptions m_options;
    localisation::Random m_random;
    WalkMind m_mind;
    WalkBody m_body;
    double m_time = 0.0;
    double m_cameraTurnRate = 0.0;
};

} // namespace farol::simulation
