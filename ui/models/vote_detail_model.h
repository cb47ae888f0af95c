#pragma once
// One place's vote, explained: each term of the paper (4.2) or of the filter with its figure, then the
// observations that speak for it.

#include "core/building/building.h"
#include "core/localisation/localiser.h"
#include "ui/models/row_change.h"

#include <QAbstractTableModel>
#include <QString>

#include <deque>
#include <memory>
#include <vector>

namespace farol::ui {

class VoteDetailModel : public RowTable<QAbstractTableModel> {
    Q_OBJECT

public:
    enum Column { What, Figure, Meaning, ColumnCount };

    using RowTable<QAbstractTableModel>::RowTable;

    void setBuilding(std::shared_ptr<const building::Building> building);
    /// Null: nothing to explain.
    void show(const localisation::RegionVote* vote, const std::deque<localisation::Observation>& history);
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    struct Row {
        QString what, figure, meaning;
    };

    QString seen(const building::Landmark& landmark,
                 const std::deque<localisation::Observation>& history) const;

    std::shared_ptr<const building::Building> m_building;
    std::vector<Row> m_rows;
};

} // namespace farol::ui
