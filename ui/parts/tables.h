#pragma once
// The look that all panels and tables of the page share.

#include <QLabel>
#include <QStyledItemDelegate>

class QAbstractItemModel;
class QAbstractItemView;
class QTableView;
class QWidget;

namespace farol::ui {

/// One line that ends in an ellipsis where there is no room for all of it; the tool tip has the whole.
class ElidedLabel : public QLabel {
    Q_OBJECT

public:
    explicit ElidedLabel(QWidget* parent);

protected:
    void paintEvent(QPaintEvent* event) override;
};

/// A panel's heading.
QLabel* panelTitle(QWidget* parent);
/// A read-only table whose rows are chosen as a whole and which Tab leaves. `stretched`: the column that
/// takes what room is left.
QTableView* panelTable(QAbstractItemModel* model, int stretched, QWidget* parent);

/// Lets long texts of the table take more lines. Only the rows that are seen are measured: there may be
/// thousands, and they may change with each picture.
void wrapRows(QTableView* table);

/// What an empty list says instead of nothing: laid over it while it has no rows. Again with another text:
/// that one.
void setEmptyHint(QAbstractItemView* view, const QString& text);

/// A bar behind the figure, as long as the share of the best vote.
class ShareBarDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
};

} // namespace farol::ui
