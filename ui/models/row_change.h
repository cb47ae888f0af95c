#pragma once
// Tables that show a new list with every frame: rows are changed in place, so that a selection, the scroll
// position and a screen reader's place survive.

#include <QAbstractItemModel>

#include <algorithm>
#include <utility>

namespace farol::ui {

/// Sits between a model and Qt's base class, to reach its protected row functions.
template <class Base>
class RowTable : public Base {
public:
    using Base::Base;

protected:
    /// Makes `rows` equal to `now` and tells which rows came, went or changed.
    template <class Rows>
    void replaceRows(Rows& rows, Rows now, int columns) {
        const auto before = static_cast<int>(rows.size());
        const auto after = static_cast<int>(now.size());
        if (after > before) {
            this->beginInsertRows({}, before, after - 1);
            rows.insert(rows.end(), now.begin() + before, now.end());
            this->endInsertRows();
        } else if (after < before) {
            this->beginRemoveRows({}, after, before - 1);
            rows.erase(rows.begin() + after, rows.end());
            this->endRemoveRows();
        }
        rows = std::move(now);
        const int changed = std::min(before, after);
        if (changed > 0) Q_EMIT this->dataChanged(this->index(0, 0), this->index(changed - 1, columns - 1));
    }
};

} // namespace farol::ui
