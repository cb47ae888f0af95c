#pragma once
// The last observations that the vote rests on, newest first.

#include "core/localisation/observation.h"
#include "ui/models/row_change.h"

#include <QAbstractTableModel>

#include <deque>
#include <vector>

namespace farol::ui {

class HistoryModel : public RowTable<QAbstractTableModel> {
    Q_OBJECT

public:
    enum Column { What, Name, Where, When, ColumnCount };

    using RowTable<QAbstractTableModel>::RowTable;

    void show(const std::deque<localisation::Observation>& history); ///< oldest first, as core keeps them
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    std::vector<localisation::Observation> m_rows;
};

} // namespace farol::ui
