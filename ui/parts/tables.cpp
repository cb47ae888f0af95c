#include "ui/parts/tables.h"

#include "ui/convert/kind_style.h"
#include "ui/map/map_colours.h"
#include "ui/models/vote_model.h"

#include <QHeaderView>
#include <QPainter>
#include <QScrollBar>
#include <QTableView>
#include <QTimer>
#include <QVBoxLayout>

namespace farol::ui {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
    setTextFormat(Qt::PlainText);
    setMinimumWidth(10); // a long text must not widen the window
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

void ElidedLabel::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(contentsRect(), static_cast<int>(alignment()) | Qt::TextSingleLine,
                     fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width()));
}

QLabel* panelTitle(QWidget* parent) {
    auto* label = new QLabel(parent);
    QFont font = label->font();
    font.setBold(true);
    label->setFont(font);
    label->setTextFormat(Qt::PlainText);
    label->setMinimumHeight(label->fontMetrics().height() +
                            10); // level with headings that stand beside buttons
    return label;
}

QTableView* panelTable(QAbstractItemModel* model, int stretched, QWidget* parent) {
    auto* table = new QTableView(parent);
    table->setModel(model);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setTabKeyNavigation(false);
    table->setShowGrid(false);
    table->setAlternatingRowColors(true);
    table->setWordWrap(false);
    table->setTextElideMode(Qt::ElideRight);
    table->setCornerButtonEnabled(false);
    table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    table->verticalHeader()->hide();
    table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().height() + 8);
    QHeaderView* header = table->horizontalHeader();
    header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    header->setHighlightSections(false);
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setSectionResizeMode(stretched, QHeaderView::Stretch);
    table->setMinimumSize(180, 90);
    return table;
}

void wrapRows(QTableView* table) {
    table->setWordWrap(true);
    auto* later = new QTimer(table); // once for all that changes at a time
    later->setSingleShot(true);
    later->setInterval(0);
    QObject::connect(later, &QTimer::timeout, table, [table] {
        const int height = table->viewport()->height();
        int row = table->rowAt(0);
        for (; row >= 0 && row < table->model()->rowCount() && table->rowViewportPosition(row) < height;
             ++row)
            table->resizeRowToContents(row);
    });
    const auto measure = [later] { later->start(); };
    const QAbstractItemModel* model = table->model();
    QObject::connect(model, &QAbstractItemModel::dataChanged, later, measure);
    QObject::connect(model, &QAbstractItemModel::rowsInserted, later, measure);
    QObject::connect(model, &QAbstractItemModel::rowsRemoved, later, measure);
    QObject::connect(model, &QAbstractItemModel::modelReset, later, measure);
    QObject::connect(table->horizontalHeader(), &QHeaderView::sectionResized, later, measure);
    QObject::connect(table->horizontalHeader(), &QHeaderView::geometriesChanged, later, measure);
    QObject::connect(table->verticalScrollBar(), &QScrollBar::valueChanged, later, measure);
    QObject::connect(table->verticalScrollBar(), &QScrollBar::rangeChanged, later, measure);
}

void setEmptyHint(QAbstractItemView* view, const QString& text) {
    const QString name = QStringLiteral("empty-hint");
    auto* hint = view->viewport()->findChild<QLabel*>(name, Qt::FindDirectChildrenOnly);
    if (!hint) {
        hint = new QLabel(view->viewport());
        hint->setObjectName(name);
        hint->setWordWrap(true);
        hint->setAlignment(Qt::AlignCenter);
        hint->setTextFormat(Qt::PlainText);
        hint->setAttribute(Qt::WA_TransparentForMouseEvents);
        hint->setContentsMargins(10, 6, 10, 6);
        hint->setForegroundRole(QPalette::PlaceholderText);
        auto* layout = new QVBoxLayout(view->viewport());
        layout->setContentsMargins(0, 0, 0, 0);
        layout->addWidget(hint);
        const QAbstractItemModel* model = view->model();
        const auto refresh = [hint, model] { hint->setVisible(model->rowCount() == 0); };
        for (const auto& signal : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
            QObject::connect(model, signal, hint, refresh);
        QObject::connect(model, &QAbstractItemModel::modelReset, hint, refresh);
        refresh();
    }
    hint->setText(text);
}

void ShareBarDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                             const QModelIndex& index) const {
    const double share = index.data(VoteModel::ShareRole).toDouble();
    if (!(option.state & QStyle::State_Selected) && share > 0.0) {
        QRectF bar = QRectF(option.rect).adjusted(2, 3, -2, -3);
        bar.setLeft(bar.right() - bar.width() * share);
        painter->save();
        painter->setPen(Qt::NoPen);
        painter->setBrush(MapColours::of(isDark(option.palette)).heat(0.25 + 0.75 * share));
        painter->drawRoundedRect(bar, 2, 2);
        painter->restore();
    }
    QStyledItemDelegate::paint(painter, option, index);
}

} // namespace farol::ui
