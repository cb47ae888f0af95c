#pragma once
// The attribute table of a map: its regions, accesses or landmarks with all that Farol knows of them, one row
// a feature.

#include "core/building/building.h"

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>

#include <memory>
#include <optional>
#include <vector>

namespace farol::ui {

class FeatureModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum class Sort { Region, Access, Landmark };
    /// The level of the row; the whole row as folded text, for searching; a number where the column has one.
    enum Role { LevelRole = Qt::UserRole + 1, SearchRole, OrderRole };

    explicit FeatureModel(QObject* parent = nullptr);

    /// Rows are those of the building's list, in its order. Kept selections survive while the count stays.
    void setBuilding(const std::shared_ptr<const building::Building>& building);
    void setSort(Sort sort);
    Sort sort() const { return m_sort; }
    void retranslate();
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QVariant regionValue(std::size_t row, int column) const;
    QVariant accessValue(std::size_t row, int column) const;
    QVariant landmarkValue(std::size_t row, int column) const;
    QVariant value(int row, int column) const;
    QString text(int row, int column) const;
    double levelOf(int row) const;
    QStringList headings() const;

    std::shared_ptr<const building::Building> m_building;
    Sort m_sort = Sort::Region;
    QStringList m_headings;
};

/// Search and order of the table: every word typed must occur; numbers sort as numbers, texts in natural
/// order.
class FeatureFilter : public QSortFilterProxyModel {
    Q_OBJECT

public:
    explicit FeatureFilter(QObject* parent = nullptr) : QSortFilterProxyModel(parent) {}

    void setTyped(const QString& text);
    void setLevel(const std::optional<double>& ordinal); ///< empty: every level

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
    bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

private:
    QStringList m_words;
    std::optional<double> m_level;
};

} // namespace farol::ui
