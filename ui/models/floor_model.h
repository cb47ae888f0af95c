#pragma once
// The floor as a list: what the map shows, for those who cannot see it. Places, then ways, then landmarks.

#include "core/building/building.h"

#include <QAbstractTableModel>

#include <memory>
#include <optional>
#include <vector>

namespace farol::ui {

class FloorModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Name, What, Where, ColumnCount };
    enum class Sort { Region, Access, Landmark };
    struct Row {
        Sort sort = Sort::Region;
        std::size_t index = 0; ///< in the building's list of that sort
    };

    using QAbstractTableModel::QAbstractTableModel;

    void setBuilding(std::shared_ptr<const building::Building> building);
    void setLevel(double ordinal);
    /// Marks the place where one is and the one where one goes.
    void setMarks(const std::optional<RegionId>& here, const std::optional<RegionId>& destination);
    const Row& at(int row) const { return m_rows[static_cast<std::size_t>(row)]; }
    int rowOf(Sort sort, std::size_t index) const; ///< -1 when it is not on this level
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    void collect();
    QString regionText(const building::Region& region, int column) const;
    QString accessText(const building::Access& access, int column) const;
    QString landmarkText(const building::Landmark& landmark, int column) const;

    std::shared_ptr<const building::Building> m_building;
    double m_level = 0.0;
    std::optional<RegionId> m_here, m_destination;
    std::vector<Row> m_rows;
};

} // namespace farol::ui
