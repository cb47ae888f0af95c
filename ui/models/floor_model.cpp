#include "ui/models/floor_model.h"

#include "ui/convert/convert.h"
#include "ui/models/words.h"

namespace farol::ui {

void FloorModel::setBuilding(std::shared_ptr<const building::Building> building) {
    beginResetModel();
    m_building = std::move(building);
    m_here.reset();
    m_destination.reset();
    collect();
    endResetModel();
}

void FloorModel::setLevel(double ordinal) {
    if (ordinal == m_level) return;
    beginResetModel();
    m_level = ordinal;
    collect();
    endResetModel();
}

void FloorModel::setMarks(const std::optional<RegionId>& here, const std::optional<RegionId>& destination) {
    if (here == m_here && destination == m_destination) return;
    m_here = here;
    m_destination = destination;
    if (!m_rows.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

void FloorModel::collect() {
    m_rows.clear();
    if (!m_building) return;
    for (std::size_t i = 0; i < m_building->regions().size(); ++i)
        if (m_building->regions()[i].level == m_level) m_rows.push_back({Sort::Region, i});
    for (std::size_t i = 0; i < m_building->accesses().size(); ++i)
        if (m_building->accesses()[i].level == m_level) m_rows.push_back({Sort::Access, i});
    for (std::size_t i = 0; i < m_building->landmarks().size(); ++i)
        if (m_building->landmarks()[i].level == m_level) m_rows.push_back({Sort::Landmark, i});
}

int FloorModel::rowOf(Sort sort, std::size_t index) const {
    for (std::size_t row = 0; row < m_rows.size(); ++row)
        if (m_rows[row].sort == sort && m_rows[row].index == index) return static_cast<int>(row);
    return -1;
}

int FloorModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int FloorModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString FloorModel::regionText(const building::Region& region, int column) const {
    if (column == Name) return regionLabel(region);
    if (column == What) return Words::regionKind(region.kind);
    if (m_here == region.id) return tr("you are here");
    if (m_destination == region.id) return tr("destination");
    return {};
}

QString FloorModel::accessText(const building::Access& access, int column) const {
    if (column == Name)
        return tr("%1 – %2").arg(regionName(m_building.get(), access.regionA),
                                 regionName(m_building.get(), access.regionB));
    if (column == What) return Words::accessKind(access.kind);
    return access.closed ? tr("closed") : QString();
}

QString FloorModel::landmarkText(const building::Landmark& landmark, int column) const {
    if (column == Name) return toQString(landmark.text.empty() ? landmark.id.value : landmark.text);
    if (column == What) return Phrasebook::kindWord(landmark.kind);
    return regionName(m_building.get(), landmark.region);
}

QVariant FloorModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
    const Row& row = m_rows[static_cast<std::size_t>(index.row())];
    switch (row.sort) {
    case Sort::Region:
        return regionText(m_building->regions()[row.index], index.column());
    case Sort::Access:
        return accessText(m_building->accesses()[row.index], index.column());
    case Sort::Landmark:
        return landmarkText(m_building->landmarks()[row.index], index.column());
    }
    return {};
}

QVariant FloorModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    switch (section) {
    case Name:
        return tr("Name");
    case What:
        return tr("What");
    case Where:
        return tr("Where");
    default:
        return {};
    }
}

} // namespace farol::ui
