#include "ui/live/revote_dialog.h"

#include "ui/convert/convert.h"
#include "ui/models/core_words.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <cmath>

namespace farol::ui {

RevoteDialog::RevoteDialog(const QString& folder, const QList<std::pair<QString, QString>>& names,
                           QWidget* parent)
    : QDialog(parent),
      m_names(names),
      m_folder(new QLineEdit(this)),
      m_localiser(new QComboBox(this)),
      m_start(new QPushButton(tr("&Compare"), this)),
      m_busy(new QProgressBar(this)),
      m_summary(new QLabel(this)),
      m_table(new QTableWidget(0, 4, this)),
      m_background(this) {
    setWindowTitle(tr("Work out a recorded walk anew"));
    build(folder);
    connect(m_start, &QPushButton::clicked, this, &RevoteDialog::start);
    resize(760, 520);
}

void RevoteDialog::build(const QString& folder) {
    m_folder->setText(folder);
    m_folder->setAccessibleName(tr("Folder of the recorded walk"));
    m_folder->setToolTip(tr("Where the recorded walk is kept"));
    auto* browse = new QPushButton(tr("&Browse…"), this);
    browse->setAccessibleName(tr("Browse for the recorded walk"));
    connect(browse, &QPushButton::clicked, this, [this] {
        const QString chosen =
            QFileDialog::getExistingDirectory(this, tr("Folder of a recorded walk"), m_folder->text());
        if (!chosen.isEmpty()) m_folder->setText(chosen);
    });
    for (const auto& [name, text] : m_names) m_localiser->addItem(text, name);
    m_localiser->setAccessibleName(tr("How the place is worked out now"));
    m_localiser->setToolTip(tr("What the recorded walk is worked out with the second time"));
    m_start->setAccessibleName(tr("Compare"));
    m_start->setToolTip(tr("Work the walk out as it was, and once more with the other choice"));
    m_start->setDefault(true);
    m_busy->setRange(0, 0);
    m_busy->setTextVisible(false);
    m_busy->hide();
    m_summary->setWordWrap(true);
    m_summary->setTextFormat(Qt::PlainText);
    m_summary->setText(tr("The pictures are not looked at again: what was recognised then is taken, and the "
                          "place is worked out anew."));
    m_table->setHorizontalHeaderLabels({tr("From"), tr("Pictures"), tr("Before"), tr("Now")});
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setTabKeyNavigation(false);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(2, QHeaderView::Stretch);
    m_table->horizontalHeader()->setSectionResizeMode(3, QHeaderView::Stretch);
    m_table->setAccessibleName(tr("Where the two differ"));
    auto* row = new QHBoxLayout;
    row->addWidget(m_folder, 1);
    row->addWidget(browse);
    auto* label = new QLabel(tr("&Recorded walk:"), this);
    label->setBuddy(m_folder);
    auto* form = new QFormLayout;
    form->addRow(label, row);
    form->addRow(tr("&Worked out by:"), m_localiser);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(m_start, 0, Qt::AlignLeft);
    layout->addWidget(m_busy);
    layout->addWidget(m_summary);
    layout->addWidget(m_table, 1);
    layout->addWidget(buttons);
}

QString RevoteDialog::nameOf(const std::string& localiser) const {
    for (const auto& [name, text] : m_names)
        if (toUtf8(name) == localiser) return text;
    return toQString(localiser);
}

void RevoteDialog::start() {
    m_start->setEnabled(false);
    m_busy->show();
    m_summary->setText(tr("Working…"));
    m_background.run([folder = toUtf8(m_folder->text().trimmed()),
                      name = toUtf8(m_localiser->currentData().toString())] { return revote(folder, name); },
                     [this](Result<Revote> result) {
                         m_start->setEnabled(true);
                         m_busy->hide();
                         showResult(result);
                     });
}

void RevoteDialog::showResult(const Result<Revote>& result) {
    m_table->setRowCount(0);
    if (!result) return m_summary->setText(CoreWords::problem(result.error()));
    const int share =
        result->pictures > 0 ? static_cast<int>(std::lround(100.0 * result->same / result->pictures)) : 100;
    m_summary->setText(
        tr("%1 before, %2 now. The same place on %3 of %4 pictures (%5 %). Sentences: %6 before, %7 now.")
            .arg(nameOf(result->localiserBefore), nameOf(result->localiserNow))
            .arg(result->same)
            .arg(result->pictures)
            .arg(share)
            .arg(result->cuesBefore)
            .arg(result->cuesNow));
    const auto place = [&](const std::optional<RegionId>& region, double confidence) {
        const QString name = region ? regionName(result->building.get(), *region) : tr("not known");
        return tr("%1 (%2)").arg(name, QLocale().toString(confidence, 'f', 2));
    };
    for (const RevoteRow& row : result->rows) {
        const int at = m_table->rowCount();
        m_table->insertRow(at);
        m_table->setItem(at, 0, new QTableWidgetItem(clockText(row.time)));
        m_table->setItem(at, 1, new QTableWidgetItem(QString::number(row.pictures)));
        m_table->setItem(at, 2, new QTableWidgetItem(place(row.before, row.confidenceBefore)));
        m_table->setItem(at, 3, new QTableWidgetItem(place(row.now, row.confidenceNow)));
    }
}

QString RevoteDialog::summary() const {
    return m_summary->text();
}

} // namespace farol::ui
