#include "tests/ui/clipped_text.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTableView>
#include <QTextDocument>
#include <QToolBar>
#include <QToolButton>
#include <QTreeView>

#include <algorithm>

namespace farol::ui::test {

namespace {

class Search {
public:
    explicit Search(const QWidget& top) : m_top(top) {}

    QStringList found() {
        for (const QWidget* widget : m_top.findChildren<QWidget*>())
            if (widget->isVisibleTo(&m_top) && !widget->isHidden() && !isOtherWindow(*widget)) look(*widget);
        return m_found;
    }

private:
    bool isOtherWindow(const QWidget& widget) const { return widget.window() != m_top.window(); }

    void note(const QWidget& widget, const QString& text, QSize needs, QSize has) {
        m_found << QStringLiteral("%1 %2 “%3” needs %4x%5, has %6x%7")
                       .arg(QLatin1String(widget.metaObject()->className()), widget.objectName(), text)
                       .arg(needs.width())
                       .arg(needs.height())
                       .arg(has.width())
                       .arg(has.height());
    }

    void compare(const QWidget& widget, const QString& text, QSize needs, QSize has) {
        if (needs.width() > has.width() || needs.height() > has.height()) note(widget, text, needs, has);
    }

    void look(const QWidget& widget) {
        if (const auto* label = qobject_cast<const QLabel*>(&widget)) lookAtLabel(*label);
        if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) lookAtButton(*button);
        if (const auto* bar = qobject_cast<const QTabBar*>(&widget)) lookAtTabs(*bar);
        if (const auto* header = qobject_cast<const QHeaderView*>(&widget)) lookAtHeader(*header);
        if (const auto* table = qobject_cast<const QTableView*>(&widget)) lookAtCells(*table);
        if (const auto* tree = qobject_cast<const QTreeView*>(&widget)) lookAtTree(*tree);
        if (const auto* box = qobject_cast<const QComboBox*>(&widget)) lookAtChoice(*box);
        if (const auto* edit = qobject_cast<const QLineEdit*>(&widget)) lookAtHint(*edit);
        if (const auto* box = qobject_cast<const QGroupBox*>(&widget))
            compare(*box, box->title(),
                    {box->fontMetrics().size(Qt::TextShowMnemonic, box->title()).width(), 0}, box->size());
        if (const auto* bar = qobject_cast<const QMenuBar*>(&widget)) lookAtMenus(*bar);
        const auto* list = qobject_cast<const QListWidget*>(&widget);
        if (list && list->horizontalScrollBar()->isVisibleTo(&m_top))
            note(*list, QStringLiteral("its lines are wider than it is"), {list->sizeHintForColumn(0), 0},
                 list->size());
        lookAtPlace(widget);
    }

    void lookAtLabel(const QLabel& label) {
        const QString text = label.text();
        if (text.isEmpty()) return;
        const QSize room = label.contentsRect().size();
        if (!label.wordWrap()) return compare(label, text, label.minimumSizeHint(), label.size());
        const int needs = label.heightForWidth(label.width());
        if (needs > label.height()) note(label, text, {label.width(), needs}, label.size());
        if (Qt::mightBeRichText(text)) return;
        for (const QString& word : text.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
            const int width = label.fontMetrics().horizontalAdvance(word);
            if (width > room.width() && !word.contains(QLatin1Char('/'))) note(label, word, {width, 0}, room);
        }
    }

    void lookAtButton(const QAbstractButton& button) {
        if (button.text().isEmpty()) return;
        const auto* tool = qobject_cast<const QToolButton*>(&button);
        if (tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull()) return;
        const QSize text = button.fontMetrics().size(Qt::TextShowMnemonic, button.text());
        QSize needs = button.sizeHint();
        needs.setHeight(text.height());
        compare(button, button.text(), needs, button.size());
    }

    void lookAtTabs(const QTabBar& bar) {
        const int space = bar.style()->pixelMetric(QStyle::PM_TabBarTabHSpace, nullptr, &bar);
        for (int tab = 0; tab < bar.count(); ++tab) {
            const QSize text = bar.fontMetrics().size(Qt::TextShowMnemonic, bar.tabText(tab));
            const QRect place = bar.tabRect(tab);
            const int right = std::min(place.right(), bar.width() - 1);
            compare(bar, bar.tabText(tab), {text.width() + space / 2, text.height()},
                    {right - std::max(place.left(), 0) + 1, place.height()});
        }
    }

    void lookAtHeader(const QHeaderView& header) {
        if (!header.model() || header.orientation() != Qt::Horizontal) return;
        for (int section = 0; section < header.count(); ++section) {
            if (header.isSectionHidden(section)) continue;
            const QString text = header.model()->headerData(section, Qt::Horizontal).toString();
            const QFont font = header.font();
            const int margin = header.style()->pixelMetric(QStyle::PM_HeaderMargin, nullptr, &header);
            compare(header, text, {QFontMetrics(font).horizontalAdvance(text) + 2 * margin, 0},
                    {header.sectionSize(section), header.height()});
        }
    }

    void lookAtCells(const QTableView& table) {
        if (!table.model()) return;
        const QRect room = table.viewport()->rect();
        for (int row = table.rowAt(0); row >= 0 && row < table.model()->rowCount(); ++row) {
            for (int column = 0; column < table.model()->columnCount(); ++column) {
                const QModelIndex cell = table.model()->index(row, column);
                const QRect place = table.visualRect(cell);
                if (place.top() >= room.bottom()) return;
                if (place.isEmpty()) continue;
                lookAtCell(table, cell, place, *table.horizontalHeader());
            }
        }
    }

    void lookAtTree(const QTreeView& tree) {
        for (QModelIndex row = tree.indexAt({1, 1}); row.isValid(); row = tree.indexBelow(row))
            for (int column = 0; column < tree.model()->columnCount(row.parent()); ++column) {
                const QModelIndex cell = row.siblingAtColumn(column);
                const QRect place = tree.visualRect(cell);
                if (place.top() >= tree.viewport()->height()) return;
                if (!place.isEmpty()) lookAtCell(tree, cell, place, *tree.header());
            }
    }

    /// A table whose columns the user sets scrolls to what does not fit; the others must have room for all.
    void lookAtCell(const QAbstractItemView& view, const QModelIndex& cell, const QRect& place,
                    const QHeaderView& columns) {
        const QString text = cell.data().toString();
        QSize needs = view.sizeHintForIndex(cell);
        const auto* table = qobject_cast<const QTableView*>(&view);
        if (table && table->wordWrap() && needs.width() > place.width()) {
            const int margin =
                2 * (view.style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, &view) + 1);
            needs = view.fontMetrics()
                        .boundingRect(QRect(0, 0, place.width() - margin, 10000), Qt::TextWordWrap, text)
                        .size();
        }
        compare(view, text, needs, place.size());
        if (columns.sectionResizeMode(cell.column()) != QHeaderView::Interactive &&
            place.right() >= view.viewport()->width())
            note(view, text + QStringLiteral(" (beyond the edge)"), place.size(), view.viewport()->size());
    }

    /// All that can be chosen, not only what is.
    void lookAtChoice(const QComboBox& box) {
        if (box.isEditable()) return;
        QStyleOptionComboBox option;
        option.initFrom(&box);
        option.subControls = QStyle::SC_All;
        const QRect room =
            box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box);
        for (int i = 0; i < box.count(); ++i) {
            const QSize text = box.fontMetrics().size(0, box.itemText(i));
            const int icon = box.itemIcon(i).isNull() ? 0 : box.iconSize().width() + 4;
            compare(box, box.itemText(i), {text.width() + icon, 0}, room.size());
        }
    }

    void lookAtHint(const QLineEdit& edit) {
        if (edit.placeholderText().isEmpty() || !edit.text().isEmpty()) return;
        const int width = edit.fontMetrics().horizontalAdvance(edit.placeholderText());
        const QRect room = edit.contentsRect().marginsRemoved(edit.textMargins());
        compare(edit, edit.placeholderText(), {width + 4, 0}, room.size());
    }

    void lookAtMenus(const QMenuBar& bar) {
        for (const QAction* action : bar.actions()) {
            if (!action->isVisible()) continue;
            const QRect place = bar.actionGeometry(const_cast<QAction*>(action));
            const QSize text = bar.fontMetrics().size(Qt::TextShowMnemonic, action->text());
            if (place.width() < text.width() || place.right() > bar.width())
                note(bar, action->text(), text, place.size());
        }
    }

    /// Cut off by the widget that it stands in; the arrow of a tool bar that is too narrow.
    void lookAtPlace(const QWidget& widget) {
        if (widget.objectName() == QLatin1String("qt_toolbar_ext_button"))
            note(*widget.parentWidget(), QStringLiteral("more buttons than there is room for"), {},
                 widget.size());
        const bool hasWords =
            qobject_cast<const QLabel*>(&widget) || qobject_cast<const QAbstractButton*>(&widget);
        if (!hasWords || !widget.parentWidget() || scrolls(widget)) return;
        const QRect outer = widget.parentWidget()->rect();
        if (!outer.contains(widget.geometry()) && !widget.size().isEmpty())
            note(widget,
                 QStringLiteral("stands beyond the edge of ") +
                     QLatin1String(widget.parentWidget()->metaObject()->className()),
                 widget.geometry().size(), outer.size());
    }

    bool scrolls(const QWidget& widget) const {
        for (const QWidget* up = widget.parentWidget(); up; up = up->parentWidget())
            if (qobject_cast<const QAbstractScrollArea*>(up) || qobject_cast<const QTabBar*>(up) ||
                qobject_cast<const QLineEdit*>(up))
                return true;
        return false;
    }

    const QWidget& m_top;
    QStringList m_found;
};

} // namespace

QStringList clippedTexts(const QWidget& top) {
    return Search(top).found();
}

} // namespace farol::ui::test
