#pragma once
// Everything that was said, or should have been: newest last.

#include "ui/speech/speech_queue.h"

#include <QAbstractTableModel>

#include <vector>

namespace farol::ui {

class UtteranceModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Time, Sentence, State, Cause, ColumnCount };
    static constexpr int kMaxRows = 500; ///< the oldest give way

    using QAbstractTableModel::QAbstractTableModel;

    /// A change of an utterance that is listed and not finished changes its row; everything else is a new
    /// row.
    void note(const Utterance& utterance);
    void clear();
    const Utterance& at(int row) const { return m_rows[static_cast<std::size_t>(row)]; }
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    std::vector<Utterance> m_rows;
};

} // namespace farol::ui
