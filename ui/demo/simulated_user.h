#pragma once
// Somebody who uses the kiosk of a building without people: stands where "sim:WHERE" says, hears what is
// spoken and walks on it, also to a second and a third destination. It never leaves by itself.

#include "ui/demo/simulated_walks.h"
#include "ui/live/walk.h"

#include <QObject>

#include <memory>
#include <vector>

namespace farol::ui {

/// Needs a walk that outlives it, and whose sources were opened by `walks`. Does nothing for other sources.
class SimulatedUser : public QObject {
    Q_OBJECT

public:
    SimulatedUser(Walk& walk, std::shared_ptr<SimulatedWalks> walks, QObject* parent = nullptr);

    void hear(const guidance::Cue& cue); ///< it is being spoken now
    void setOut();                       ///< to a new destination, on what will be spoken
    void stand();                        ///< there is no destination any more

Q_SIGNALS:
    void movedTo(const farol::RegionId& region); ///< the truth, for those who check the guidance

private:
    void plan();
    void listen(const session::NavigationStep& step);

    Walk& m_walk;
    std::shared_ptr<SimulatedWalks> m_walks;
    std::shared_ptr<simulation::WalkSource> m_source; ///< of the running walk
    std::vector<guidance::Cue> m_heard;               ///< since the last picture
    RegionId m_region;
};

} // namespace farol::ui
