#include "ui/models/region_filter.h"

#include "core/base/text.h"
#include "ui/convert/convert.h"
#include "ui/models/region_model.h"

#include <algorithm>

namespace farol::ui {

RegionFilter::RegionFilter(QObject* parent) : QSortFilterProxyModel(parent) {
    sort(0);
}

void RegionFilter::setTyped(const QString& text) {
    const QString folded = toQString(foldedForMatching(toUtf8(text)));
    if (folded == m_folded) return; // a campus has many rows to sort
    m_folded = folded;
    m_words = m_folded.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    invalidate();
}

bool RegionFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
    if (m_words.isEmpty()) return true;
    const QModelIndex index = sourceModel()->index(row, 0, parent);
    const QString words = index.data(RegionModel::SearchRole).toString();
    if (!std::all_of(m_words.begin(), m_words.end(),
                     [&](const QString& word) { return words.contains(word); }))
        return false;
    const auto at = static_cast<std::size_t>(row);
    if (m_ranks.size() <= at) m_ranks.resize(static_cast<std::size_t>(sourceModel()->rowCount(parent)));
    m_ranks[at] = rank(words, index);
    return true;
}

int RegionFilter::rank(const QString& words, const QModelIndex& index) const {
    const QString id = toQString(foldedForMatching(toUtf8(index.data(RegionModel::IdRole).toString())));
    if (id == m_folded || words == m_folded) return 0;
    if (words.startsWith(m_folded)) return 1;
    return words.contains(QLatin1Char(' ') + m_folded) ? 2 : 3;
}

bool RegionFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
    if (m_words.isEmpty()) return left.row() < right.row();
    const int first = m_ranks[static_cast<std::size_t>(left.row())];
    const int second = m_ranks[static_cast<std::size_t>(right.row())];
    return first != second ? first < second : left.row() < right.row();
}

} // namespace farol::ui
