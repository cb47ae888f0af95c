#pragma once
// All places of the building, for choosing one.

#include "core/building/building.h"

#include <QAbstractListModel>

#include <memory>
#include <optional>
#include <vector>

namespace farol::ui {

/// Rows in the order people look for them: named before unnamed, then by level, then by name in natural
/// order.
class RegionModel : public QAbstractListModel {
    Q_OBJECT

public:
    /// The id as text; the text to match what was typed against, already folded; the level.
    enum Role { IdRole = Qt::UserRole + 1, SearchRole, LevelRole };

    using QAbstractListModel::QAbstractListModel;

    void setBuilding(std::shared_ptr<const building::Building> building);
    std::optional<RegionId> idAt(int row) const;
    int rowOf(const RegionId& id) const;       ///< -1 when unknown
    QString labelOf(const RegionId& id) const; ///< "Room 2.14 – level 2"
    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

private:
    QString label(const building::Region& region) const;
    const QString& searchWords(std::size_t row, const building::Region& region) const;

    std::shared_ptr<const building::Building> m_building;
    std::vector<std::size_t> m_order;
    mutable std::vector<QString>
        m_search;                     ///< folded, of each row that was asked for: a key typed asks for all
    mutable QString m_searchLanguage; ///< in which the levels are named there
};

} // namespace farol::ui
