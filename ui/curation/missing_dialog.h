#pragma once
// The report over all pairs of places: from where to where no route leads, and why.

#include "core/routing/missing_routes.h"
#include "ui/convert/background.h"

#include <QDialog>

#include <memory>
#include <optional>

class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace farol::ui {

class MissingDialog : public QDialog {
    Q_OBJECT

public:
    MissingDialog(std::shared_ptr<const building::Building> building, const routing::RouteOptions& options,
                  QWidget* parent = nullptr);

    QString summary() const;
    QTableWidget& table() { return *m_table; }
    QPushButton& showButton() { return *m_show; }
    bool done() const { return m_found.has_value(); }

Q_SIGNALS:
    /// The chosen route that is missing shall be looked at.
    void routeWanted(const farol::RegionId& from, const farol::RegionId& to);

private:
    void build();
    void show(routing::MissingRoutes found);
    QString nameOf(std::size_t group) const;
    void showChosen();

    std::shared_ptr<const building::Building> m_building;
    std::optional<routing::MissingRoutes> m_found;
    QLabel* m_summary;
    QProgressBar* m_busy;
    QTableWidget* m_table;
    QPushButton* m_show;
    Background m_background; ///< last: its jobs use the rest
};

} // namespace farol::ui
