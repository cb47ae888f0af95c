#include "ui/main_window/figures_dialog.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>

namespace farol::ui {

FiguresDialog::FiguresDialog(std::vector<Chart> charts, QWidget* parent)
    : QDialog(parent),
      m_charts(std::move(charts)),
      m_list(new QListWidget(this)),
      m_view(new ChartView(this)) {
    setWindowTitle(tr("Figures"));
    for (const Chart& chart : m_charts) m_list->addItem(chart.title);
    const int widest = m_list->sizeHintForColumn(0) + 2 * m_list->frameWidth() + 4;
    m_list->setMinimumWidth(std::min(widest, 400));
    m_list->setAccessibleName(tr("Charts"));
    m_list->setToolTip(tr("Which chart is shown"));
    auto* halves = new QSplitter(Qt::Horizontal, this);
    halves->addWidget(m_list);
    halves->addWidget(m_view);
    halves->setStretchFactor(1, 1);
    halves->setSizes({220, 620});
    halves->setChildrenCollapsible(false);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    QPushButton* keep = buttons->addButton(tr("&Save as PNG or SVG…"), QDialogButtonBox::ActionRole);
    keep->setAccessibleName(tr("Save the chart"));
    keep->setToolTip(tr("Save the chart as a picture, or as a drawing that stays sharp"));
    connect(keep, &QPushButton::clicked, this, &FiguresDialog::save);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_list, &QListWidget::currentRowChanged, this, [this, keep](int row) {
        if (row < 0) return;
        m_view->setChart(m_charts[static_cast<std::size_t>(row)]);
        keep->setEnabled(!m_view->chart().empty());
    });
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(halves, 1);
    layout->addWidget(buttons);
    m_list->setCurrentRow(0);
    resize(880, 560);
}

void FiguresDialog::save() {
    auto* ask = new QFileDialog(this, tr("Save the chart"), QString(),
                                tr("Charts (%1)").arg(QStringLiteral("*.png *.svg")));
    ask->setAttribute(Qt::WA_DeleteOnClose);
    ask->setAcceptMode(QFileDialog::AcceptSave);
    ask->setDefaultSuffix(QStringLiteral("png"));
    connect(ask, &QFileDialog::fileSelected, this, [this](const QString& file) {
        if (m_view->save(file)) return;
        auto* box = new QMessageBox(
            QMessageBox::Warning, tr("Figures"),
            tr("%1 cannot be written. Choose another folder.").arg(QDir::toNativeSeparators(file)),
            QMessageBox::Ok, this);
        box->setAttribute(Qt::WA_DeleteOnClose);
        box->open();
    });
    ask->open();
}

} // namespace farol::ui
