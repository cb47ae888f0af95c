#include "ui/models/region_model.h"

#include "core/base/text.h"
#include "ui/convert/convert.h"
#include "ui/models/words.h"
#include "ui/speech/phrasebook.h"

#include <algorithm>

namespace farol::ui {

void RegionModel::setBuilding(std::shared_ptr<const building::Building> building) {
    beginResetModel();
    m_building = std::move(building);
    m_order.clear();
    m_search.clear();
    if (m_building) {
        const auto& regions = m_building->regions();
        const std::string language = toUtf8(installedLanguage());
        std::vector<std::string> names; // made once, not for each of the comparisons
        for (std::size_t i = 0; i < regions.size(); ++i) {
            m_order.push_back(i);
            names.push_back(spokenName(regions[i], language));
        }
        std::stable_sort(m_order.begin(), m_order.end(), [&](std::size_t a, std::size_t b) {
            const building::Region& first = regions[a];
            const building::Region& second = regions[b];
            if (first.name.empty() != second.name.empty()) return second.name.empty();
            if (first.level != second.level) return first.level < second.level;
            return naturalLess(names[a], names[b]);
        });
    }
    endResetModel();
}

std::optional<RegionId> RegionModel::idAt(int row) const {
    if (row < 0 || row >= rowCount()) return std::nullopt;
    return m_building->regions()[m_order[static_cast<std::size_t>(row)]].id;
}

int RegionModel::rowOf(const RegionId& id) const {
    for (std::size_t row = 0; row < m_order.size(); ++row)
        if (m_building->regions()[m_order[row]].id == id) return static_cast<int>(row);
    return -1;
}

QString RegionModel::label(const building::Region& region) const {
    if (m_building->levels().size() < 2) return regionLabel(region);
    return QStringLiteral("%1 – %2").arg(regionLabel(region), Words::level(*m_building, region.level));
}

QString RegionModel::labelOf(const RegionId& id) const {
    const building::Region* region = m_building ? m_building->region(id) : nullptr;
    return region ? label(*region) : toQString(id.value);
}

const QString& RegionModel::searchWords(std::size_t row, const building::Region& region) const {
    if (m_search.size() != m_order.size() || m_searchLanguage != installedLanguage()) {
        m_search.assign(m_order.size(), QString());
        m_searchLanguage = installedLanguage();
    }
    QString& folded = m_search[row];
    if (folded.isNull()) {
        const QString words = QStringLiteral("%1 %2 %3 %4")
                                  .arg(label(region), toQString(region.ref), toQString(region.id.value),
                                       toQString(region.name));
        folded = toQString(foldedForMatching(toUtf8(words)));
    }
    return folded;
}

int RegionModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_order.size());
}

QVariant RegionModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const building::Region& region = m_building->regions()[m_order[static_cast<std::size_t>(index.row())]];
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
        return label(region);
    case Qt::ToolTipRole:
        return QStringLiteral("%1 (%2)").arg(label(region), Words::regionKind(region.kind));
    case IdRole:
        return toQString(region.id.value);
    case LevelRole:
        return region.level;
    case SearchRole:
        return searchWords(static_cast<std::size_t>(index.row()), region);
    default:
        return {};
    }
}

} // namespace farol::ui
