#pragma once
// The places that got votes, best first, with what the votes are made of.

#include "core/building/building.h"
#include "core/localisation/localiser.h"
#include "ui/models/row_change.h"

#include <QAbstractTableModel>

#include <memory>
#include <vector>

namespace farol::ui {

class VoteModel : public RowTable<QAbstractTableModel> {
    Q_OBJECT

public:
    enum Column { Place, Vote, Why, ColumnCount };
    /// Share of the best vote, 0 to 1; the region's id as text.
    enum Role { ShareRole = Qt::UserRole + 1, RegionRole };

    using RowTable<QAbstractTableModel>::RowTable;

    void setBuilding(std::shared_ptr<const building::Building> building);
    void show(const std::vector<localisation::RegionVote>& votes);
    const localisation::RegionVote* vote(int row) const; ///< null: there is no such row
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QString why(const localisation::RegionVote& vote, const QString& separator) const;

    std::shared_ptr<const building::Building> m_building;
    std::vector<localisation::RegionVote> m_votes;
};

} // namespace farol::ui
