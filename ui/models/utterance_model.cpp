#include "ui/models/utterance_model.h"

#include "ui/convert/convert.h"
#include "ui/models/words.h"

namespace farol::ui {

namespace {

bool unfinished(UtteranceState state) {
    return state == UtteranceState::Waiting || state == UtteranceState::Speaking;
}

} // namespace

void UtteranceModel::note(const Utterance& utterance) {
    for (std::size_t i = m_rows.size(); i-- > 0;) {
        Utterance& row = m_rows[i];
        if (row.cue.id != utterance.cue.id || row.text != utterance.text || !unfinished(row.state)) continue;
        row = utterance;
        const int at = static_cast<int>(i);
        Q_EMIT dataChanged(index(at, 0), index(at, ColumnCount - 1));
        return;
    }
    if (rowCount() >= kMaxRows) {
        beginRemoveRows({}, 0, 0);
        m_rows.erase(m_rows.begin());
        endRemoveRows();
    }
    beginInsertRows({}, rowCount(), rowCount());
    m_rows.push_back(utterance);
    endInsertRows();
}

void UtteranceModel::clear() {
    beginResetModel();
    m_rows.clear();
    endResetModel();
}

int UtteranceModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int UtteranceModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant UtteranceModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const Utterance& utterance = m_rows[static_cast<std::size_t>(index.row())];
    if (role == Qt::ToolTipRole && index.column() == Cause)
        return tr("Caused by picture %1").arg(utterance.cue.frame + 1);
    if (role == Qt::ToolTipRole && index.column() == State && utterance.state == UtteranceState::Shown)
        return tr("Shown as text, not heard");
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
    switch (index.column()) {
    case Time:
        return clockText(utterance.cue.time);
    case Sentence:
        return utterance.text;
    case State:
        return Words::utteranceState(utterance.state);
    case Cause:
        return Words::cause(utterance.cue);
    default:
        return {};
    }
}

QVariant UtteranceModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    switch (section) {
    case Time:
        return tr("Time");
    case Sentence:
        return tr("Sentence");
    case State:
        return tr("State");
    case Cause:
        return tr("Because");
    default:
        return {};
    }
}

} // namespace farol::ui
