#pragma once
// What is wrong with the map, by rule. Choosing a finding shows its feature on the plan.

#include "ui/map/hit_detector.h"
#include "ui/models/finding_model.h"

#include <QWidget>

#include <memory>
#include <optional>

class QLabel;
class QPlainTextEdit;
class QPushButton;
class QTreeView;

namespace farol::ui {

class ReportPanel : public QWidget {
    Q_OBJECT

public:
    explicit ReportPanel(QWidget* parent = nullptr);

    void setBuilding(const std::shared_ptr<const building::Building>& building);
    /// `stale`: the map was changed since.
    void setFindings(const std::vector<building::Finding>& findings, bool stale);
    void setBusy(bool busy);
    QTreeView& tree() { return *m_tree; }
    QPushButton& again() { return *m_again; }
    QPushButton& next() { return *m_next; }
    QString summary() const;
    QString explanation() const;
    const FindingModel& model() const { return m_model; }
    void showNext(); ///< the next feature of the finding

Q_SIGNALS:
    void featureWanted(const farol::ui::MapHit& hit);
    void checkWanted();

protected:
    void changeEvent(QEvent* event) override;

private:
    std::optional<MapHit> featureOf(const building::Finding& finding, std::size_t which) const;
    void showCurrent();
    void retranslate();

    std::shared_ptr<const building::Building> m_building;
    std::vector<building::Finding> m_findings;
    FindingModel m_model;
    QLabel* m_summary;
    QTreeView* m_tree;
    QPlainTextEdit* m_words;
    QPushButton *m_next, *m_again;
    std::size_t m_which = 0;
    bool m_stale = false;
};

} // namespace farol::ui
