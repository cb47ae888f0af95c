#pragma once
// A route tried out on the map: from where, to where, what is to be avoided, and every sentence of the way.

#include "core/routing/route.h"
#include "ui/convert/background.h"
#include "ui/models/region_model.h"
#include "ui/models/route_model.h"

#include <QWidget>

#include <memory>
#include <optional>

class QCheckBox;
class QGroupBox;
class QLabel;
class QPushButton;
class QTableView;

namespace farol::ui {

class PlaceChooser;

class RoutePanel : public QWidget {
    Q_OBJECT

public:
    explicit RoutePanel(QWidget* parent = nullptr);
    ~RoutePanel() override;

    /// Another building. `sameMap`: after an edit; the places stay and the route is planned anew.
    void setBuilding(const std::shared_ptr<const building::Building>& building, bool sameMap);
    void setFrom(const std::optional<RegionId>& region);
    void setTo(const std::optional<RegionId>& region);
    void setStyle(DirectionStyle style);
    PlaceChooser& from() { return *m_from; }
    PlaceChooser& to() { return *m_to; }
    QTableView& table() { return *m_table; }
    QCheckBox& avoidStairs() { return *m_stairs; }
    const RouteModel& model() const { return m_model; }
    routing::RouteOptions options() const; ///< what is to be avoided
    QString summary() const;
    bool planning() const { return m_planning; }

Q_SIGNALS:
    void routeChanged(); ///< see model().route()
    void placesChanged();
    void manoeuvreChosen(const farol::routing::Manoeuvre& manoeuvre);

protected:
    void changeEvent(QEvent* event) override;

private:
    void plan();
    struct Answer {
        std::shared_ptr<const routing::Planner> planner;
        Result<routing::Route> route;
        std::optional<routing::NoRoute> why; ///< there is none
    };
    void planned(const std::shared_ptr<const building::Building>& building, Answer answer);
    void retranslate();
    void summarise();

    std::shared_ptr<const building::Building> m_building;
    std::shared_ptr<const routing::Planner> m_planner; ///< of m_building and the options ticked
    RegionModel m_regions;
    RouteModel m_model;
    PlaceChooser *m_from, *m_to;
    QPushButton* m_swap;
    QGroupBox* m_avoid;
    QCheckBox *m_stairs, *m_lifts, *m_escalators, *m_restricted;
    QLabel* m_summary;
    QTableView* m_table;
    QString m_reason; ///< why there is no route, where it is nothing about the map
    std::optional<routing::NoRoute> m_noRoute;
    std::uint64_t m_job = 0;
    bool m_planning = false;
    Background m_background; ///< last: its jobs use the rest
};

} // namespace farol::ui
