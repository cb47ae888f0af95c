#include "ui/models/history_model.h"

#include "ui/convert/convert.h"
#include "ui/models/words.h"

namespace farol::ui {

void HistoryModel::show(const std::deque<localisation::Observation>& history) {
    replaceRows(m_rows, {history.rbegin(), history.rend()}, ColumnCount);
}

int HistoryModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int HistoryModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant HistoryModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
    const auto& seen = m_rows[static_cast<std::size_t>(index.row())];
    switch (index.column()) {
    case What:
        return Phrasebook::kindWord(seen.detection.kind);
    case Name:
        return Words::detectionName(seen.detection);
    case Where:
        return Phrasebook::zoneWords(seen.detection.zone());
    case When:
        return clockText(seen.time);
    default:
        return {};
    }
}

QVariant HistoryModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    switch (section) {
    case What:
        return tr("What");
    case Name:
        return tr("Name");
    case Where:
        return tr("Where");
    case When:
        return tr("Time");
    default:
        return {};
    }
}

} // namespace farol::ui
