#pragma once
// What is in the picture now: the accepted first, then, when wanted, what was nearly found and why not.

#include "core/recognition/detection.h"
#include "ui/models/row_change.h"

#include <QAbstractTableModel>

#include <variant>
#include <vector>

namespace farol::ui {

class DetectionModel : public RowTable<QAbstractTableModel> {
    Q_OBJECT

public:
    enum Column { What, Name, Where, Score, ColumnCount };

    using RowTable<QAbstractTableModel>::RowTable;

    void show(const std::vector<recognition::Detection>& detections,
              const std::vector<recognition::Rejection>& rejections);
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QVariant detectionText(const recognition::Detection& detection, int column) const;
    QVariant rejectionText(const recognition::Rejection& rejection, int column) const;

    std::vector<std::variant<recognition::Detection, recognition::Rejection>> m_rows;
};

} // namespace farol::ui
