#pragma once
// A building without people and a camera without a lens: simulated visitors come one after the other, hear
// what is said, and walk. For exhibitions and for those who want to see what Farol does.

#include "core/simulation/visits.h"
#include "ui/demo/simulated_walks.h"
#include "ui/live/walk.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>

namespace farol::ui {

/// Needs a walk that outlives it, and whose sources were opened by `walks`.
class Demo : public QObject {
    Q_OBJECT

public:
    Demo(Walk& walk, std::shared_ptr<SimulatedWalks> walks, QObject* parent = nullptr);
    /// Opens simulated walks, and leaves all other sources to `other` (empty: camera, file, folder,
    /// address).
    static Walk::OpenSource opener(std::shared_ptr<SimulatedWalks> walks, Walk::OpenSource other);

    bool on() const; ///< the source is a simulated walk
    const building::Building* building() const { return m_building.get(); }
    int visitor() const { return m_visitor; }
    const std::optional<simulation::Visit>& visit() const { return m_visit; }
    bool covered() const { return m_covered; }
    bool lightsOut() const { return m_lightsOut; }
    bool over() const { return m_over; }       ///< this visitor's walk
    bool arrived() const { return m_arrived; } ///< and came where it led
    double seconds() const { return m_seconds; }
    /// Where the visitor really is in the picture that is shown.
    std::optional<simulation::FrameTruth> truth() const;

    void wrongTurn();
    void setCovered(bool covered);
    void setLightsOut(bool out);
    void nextVisitor();

Q_SIGNALS:
    void changed();

private:
    void sourceOrMapChanged();
    void placesChanged();
    void walkBegan();
    void walkEnded();
    void welcome(const std::optional<simulation::Visit>& visit);
    std::optional<simulation::Visit> firstVisit() const;
    void plan();

    Walk& m_walk;
    std::shared_ptr<SimulatedWalks> m_walks;
    std::unique_ptr<simulation::Visits> m_visits; ///< of the open map
    std::shared_ptr<const building::Building> m_building;
    std::optional<simulation::Visit> m_visit;
    std::shared_ptr<simulation::WalkSource> m_source; ///< of the running walk
    int m_visitor = 0;
    bool m_covered = false, m_lightsOut = false, m_over = false, m_arrived = false;
    bool m_welcoming = false; ///< places are set here, not chosen by somebody
    double m_seconds = 0.0;
    QTimer m_next;
};

} // namespace farol::ui
