#pragma once
// The attribute table beside the plan: search, which features, this level only. A row chosen here is chosen
// on the plan, and the other way round.

#include "ui/map/hit_detector.h"
#include "ui/models/feature_model.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QTableView;

namespace farol::ui {

class FeaturePanel : public QWidget {
    Q_OBJECT

public:
    explicit FeaturePanel(QWidget* parent = nullptr);

    void setBuilding(const std::shared_ptr<const building::Building>& building);
    void setLevel(double ordinal);
    void select(const std::optional<MapHit>& hit); ///< without telling it again
    std::optional<MapHit> selected() const;
    QTableView& table() { return *m_table; }
    QLineEdit& search() { return *m_search; }
    QComboBox& sort() { return *m_sort; }
    QCheckBox& levelOnly() { return *m_levelOnly; }
    const FeatureModel& model() const { return m_model; }
    void focusSearch();

Q_SIGNALS:
    void selectionChanged(const std::optional<farol::ui::MapHit>& hit);
    void activated(const farol::ui::MapHit& hit); ///< Return or double click

protected:
    void changeEvent(QEvent* event) override;

private:
    void showSort(FeatureModel::Sort sort);
    void count();
    void showColumns();
    void fitColumns();
    void retranslate();
    std::optional<MapHit> hitOf(const QModelIndex& index) const;

    FeatureModel m_model;
    FeatureFilter m_filter;
    QComboBox* m_sort;
    QLineEdit* m_search;
    QCheckBox* m_levelOnly;
    QTableView* m_table;
    QLabel* m_count;
    double m_level = 0.0;
    bool m_building = false; ///< is open
    bool m_quiet = false;
};

} // namespace farol::ui
