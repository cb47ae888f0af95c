#pragma once
// Tables that show a new list with every frame: rows are changed in place, so that a selection, the scroll position and
// a screen reader's place survive.

#include <QAbstractItemModel>

#include <algorithm>

namespace farol::ui {

/// Sits between a model and Qt's base class, to reach its protected row functions.
template <class Base>
class RowTable : public Base {
public:
    using Base::Base;

protected:
    /// Assigns through `assign` and tells which rows came, went or changed.
    template <class Assign>
    void replaceRows(int before, int after, int columns, Assign assign) {
        if (after > before) {
            this->beginInsertRows({}, before, after - 1);
            assign();
            this->endInsertRows();
        } else if (after < before) {
            this->beginRemoveRows({}, after, before - 1);
            assign();
            this->endRemoveRows();
        } else {
            assign();
        }
        const int changed = std::min(before, after);
        if (changed > 0) Q_EMIT this->dataChanged(this->index(0, 0), this->index(changed - 1, columns - 1));
    }
};

} // namespace farol::ui
