#include "ui/main_window/keys_dialog.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QTableWidget>
#include <QVBoxLayout>

namespace farol::ui {

KeysDialog::KeysDialog(const QList<QAction*>& actions, QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Keys"));
    QList<std::pair<QString, QString>> rows;
    for (const QAction* action : actions)
        rows.emplace_back(action->shortcut().toString(QKeySequence::NativeText), action->statusTip());
    rows.emplace_back(tr("Arrows"), tr("In the map: move it"));
    rows.emplace_back(QStringLiteral("+ − 0"), tr("In the map: larger, smaller, whole floor"));
    rows.emplace_back(tr("Page Up, Page Down"), tr("In the map: the floor above, the floor below"));
    rows.emplace_back(tr("Alt + Arrows"), tr("In the plan: move what is chosen by 10 cm, with Shift by 1 m"));
    rows.emplace_back(tr("Tab"), tr("The next button or list"));

    auto* table = new QTableWidget(static_cast<int>(rows.size()), 2, this);
    table->setHorizontalHeaderLabels({tr("Key"), tr("What it does")});
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setTabKeyNavigation(false);
    table->setAccessibleName(tr("Keys"));
    table->verticalHeader()->hide();
    table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents); // long ones take two lines
    table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    table->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
    for (int row = 0; row < rows.size(); ++row) {
        table->setItem(row, 0, new QTableWidgetItem(rows[row].first));
        table->setItem(row, 1, new QTableWidgetItem(rows[row].second));
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(table);
    layout->addWidget(buttons);
    resize(560, 560);
}

} // namespace farol::ui
