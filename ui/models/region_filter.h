#pragma once
// Narrows the places down while one types: every word must occur, whatever its case and accents.

#include <QSortFilterProxyModel>
#include <QStringList>

#include <vector>

namespace farol::ui {

/// Best first: the whole name, then names that begin with the text, then the rest in the model's order.
class RegionFilter : public QSortFilterProxyModel {
    Q_OBJECT

public:
    explicit RegionFilter(QObject* parent = nullptr);

    void setTyped(const QString& text);

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
    bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

private:
    int rank(const QString& words, const QModelIndex& index) const;

    QString m_folded;
    QStringList m_words;
    mutable std::vector<int> m_ranks; ///< of the rows that were accepted: sorting asks for each many times
};

} // namespace farol::ui
