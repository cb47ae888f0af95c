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
    m_folded = toQString(foldedForMatching(toUtf8(text)));
    m_words = m_folded.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    invalidate();
}

bool RegionFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
    const QString words = sourceModel()->index(row, 0, parent).data(RegionModel::SearchRole).toString();
    return std::all_of(m_words.begin(), m_words.end(),
                       [&](const QString& word) { return words.contains(word); });
}

int RegionFilter::rank(const QModelIndex& index) const {
    if (m_folded.isEmpty()) return 0;
    const QString id = toQString(foldedForMatching(toUtf8(index.data(RegionModel::IdRole).toString())));
    const QString words = index.data(RegionModel::SearchRole).toString();
    if (id == m_folded || words == m_folded) return 0;
    if (words.startsWith(m_folded)) return 1;
    return words.contains(QLatin1Char(' ') + m_folded) ? 2 : 3;
}

bool RegionFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
    const int first = rank(left);
    const int second = rank(right);
    return first != second ? first < second : left.row() < right.row();
}

} // namespace farol::ui
