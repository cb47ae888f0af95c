#include "ui/training/library_panel.h"

#include "ui/convert/convert.h"
#include "ui/parts/tables.h"
#include "ui/training/training_words.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QTabBar>
#include <QTabWidget>
#include <QTableView>
#include <QTimer>
#include <QVBoxLayout>

namespace farol::ui {

using recognition::Template;

LibraryPanel::LibraryPanel(QWidget* parent)
    : QWidget(parent),
      m_stop(std::make_shared<std::atomic<bool>>(false)),
      m_done(std::make_shared<std::atomic<int>>(0)),
      m_all(std::make_shared<std::atomic<int>>(0)),
      m_background(this) {
    build();
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this] {
        if (m_settingUp) return;
        showChosen();
        Q_EMIT chosenChanged();
    });
    connect(m_table, &QTableView::activated, this, &LibraryPanel::teachWanted);
    connect(m_views, &QListWidget::itemSelectionChanged, this, &LibraryPanel::chosenChanged);
    connect(m_checkAll, &QPushButton::clicked, this, &LibraryPanel::checkWanted);
    connect(m_csv, &QPushButton::clicked, this, &LibraryPanel::csvWanted);
    connect(m_matrix, &QTableView::activated, this, [this](const QModelIndex& index) {
        select(m_confusion.checks()[static_cast<std::size_t>(index.row())].id);
    });
    auto* tick = new QTimer(this);
    tick->setInterval(100);
    connect(tick, &QTimer::timeout, this, [this] {
        m_progress->setMaximum(*m_all);
        m_progress->setValue(*m_done);
    });
    tick->start();
    retranslate();
    setLibrary(nullptr);
}

LibraryPanel::~LibraryPanel() {
    m_stop->store(true);
}

void LibraryPanel::build() {
    m_halves = new QSplitter(Qt::Horizontal, this);
    auto* left = new QWidget(m_halves);
    m_title = panelTitle(left);
    m_table = panelTable(&m_model, LibraryModel::Name, left);
    m_table->verticalHeader()->setDefaultSectionSize(44);
    m_table->setIconSize({72, 36});
    m_title->setBuddy(m_table);
    auto* leftLayout = new QVBoxLayout(left);
    leftLayout->setContentsMargins(0, 0, 0, 0);
    leftLayout->addWidget(m_title);
    leftLayout->addWidget(m_table, 1);
    m_tabs = new QTabWidget(m_halves);
    m_tabs->setDocumentMode(true);
    auto* detail = new QWidget(m_tabs);
    m_detailTitle = panelTitle(detail);
    m_health = new QLabel(detail);
    m_health->setWordWrap(true);
    m_health->setTextFormat(Qt::PlainText);
    m_viewsTitle = new QLabel(detail);
    m_views = new QListWidget(detail);
    m_views->setViewMode(QListView::IconMode);
    m_views->setIconSize({160, 120});
    m_views->setResizeMode(QListView::Adjust);
    m_views->setMovement(QListView::Static);
    m_views->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_views->setSpacing(6);
    m_viewsTitle->setBuddy(m_views);
    auto* layout = new QVBoxLayout(detail);
    layout->addWidget(m_detailTitle);
    layout->addWidget(m_health);
    layout->addWidget(m_viewsTitle);
    layout->addWidget(m_views, 1);
    m_tabs->addTab(detail, QString());
    m_tabs->addTab(buildReport(), QString());
    m_halves->addWidget(left);
    m_halves->addWidget(m_tabs);
    m_halves->setStretchFactor(0, 3);
    m_halves->setStretchFactor(1, 2);
    m_halves->setChildrenCollapsible(false);
    m_halves->setHandleWidth(8);
    m_halves->setSizes({720, 540});
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(m_halves);
}

QWidget* LibraryPanel::buildReport() {
    auto* box = new QWidget(m_tabs);
    m_checkAll = new QPushButton(box);
    m_csv = new QPushButton(box);
    m_progress = new QProgressBar(box);
    m_report = new QLabel(box);
    m_report->setWordWrap(true);
    m_report->setTextFormat(Qt::PlainText);
    m_matrix = new QTableView(box);
    m_matrix->setModel(&m_confusion);
    m_matrix->setTabKeyNavigation(false);
    m_matrix->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_matrix->setSelectionMode(QAbstractItemView::SingleSelection);
    m_matrix->setCornerButtonEnabled(false);
    m_matrix->horizontalHeader()->setDefaultSectionSize(34);
    m_matrix->horizontalHeader()->setMinimumSectionSize(24);
    m_matrix->horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_matrix->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_matrix->verticalHeader()->setDefaultSectionSize(26);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_checkAll);
    buttons->addWidget(m_csv);
    buttons->addWidget(m_progress, 1);
    buttons->addStretch(0);
    auto* layout = new QVBoxLayout(box);
    layout->addLayout(buttons);
    layout->addWidget(m_report);
    layout->addWidget(m_matrix, 1);
    return box;
}

void LibraryPanel::setLibrary(const LibraryModel::Library& library) {
    const auto before = chosen();
    const TemplateId was = before ? m_model.library()->templates[*before].id : TemplateId();
    m_settingUp = true;
    m_model.setLibrary(library);
    if (!library) m_checks.clear();
    m_settingUp = false;
    const int rows = m_model.rowCount();
    if (rows > 0) {
        const int again = m_model.rowOf(was);
        const int row = again >= 0 ? again : before ? std::min(static_cast<int>(*before), rows - 1) : 0;
        m_table->selectRow(row);
    }
    retranslate();
    showChosen();
    Q_EMIT chosenChanged();
}

void LibraryPanel::select(const TemplateId& id) {
    const int row = m_model.rowOf(id);
    if (row < 0) return;
    m_table->selectRow(row);
    m_table->scrollTo(m_model.index(row, 0));
}

std::optional<std::size_t> LibraryPanel::chosen() const {
    const QModelIndex index = m_table->currentIndex();
    if (!index.isValid() || index.row() >= m_model.rowCount()) return std::nullopt;
    return static_cast<std::size_t>(index.row());
}

std::vector<std::size_t> LibraryPanel::chosenViews() const {
    std::vector<std::size_t> rows;
    for (int row = 0; row < m_views->count(); ++row)
        if (m_views->item(row)->isSelected()) rows.push_back(static_cast<std::size_t>(row));
    return rows;
}

void LibraryPanel::showChosen() {
    const auto index = chosen();
    if (!index) {
        m_detailTitle->setText(tr("Nothing is chosen"));
        m_health->clear();
        m_views->clear();
        return;
    }
    const Template& entry = m_model.library()->templates[*index];
    m_detailTitle->setText(toQString(entry.name.empty() ? entry.id.value : entry.name));
    const recognition::TemplateCheck* check = m_model.check(entry.id);
    m_health->setText(check ? TrainingWords::health(*check, entry.kind).join(QLatin1Char('\n'))
                            : tr("Not checked yet. “Check all” looks how well each landmark is found."));
    fillViews();
}

void LibraryPanel::fillViews() {
    const Template& entry = m_model.library()->templates[*chosen()];
    m_views->clear();
    for (std::size_t i = 0; i < entry.views.size(); ++i)
        m_views->addItem(new QListWidgetItem(tr("View %1").arg(static_cast<int>(i + 1))));
    const std::uint64_t job = ++m_pictureJob;
    m_background.run(
        [library = m_model.library(), at = *chosen()] {
            std::vector<QImage> pictures;
            for (const recognition::View& view : library->templates[at].views)
                pictures.push_back(
                    QImage::fromData(
                        QByteArray::fromRawData(view.jpeg.data(), static_cast<qsizetype>(view.jpeg.size())))
                        .scaled(160, 120, Qt::KeepAspectRatio, Qt::SmoothTransformation));
            return pictures;
        },
        [this, job](std::vector<QImage> pictures) {
            if (job != m_pictureJob) return;
            for (std::size_t i = 0; i < pictures.size() && static_cast<int>(i) < m_views->count(); ++i)
                m_views->item(static_cast<int>(i))->setIcon(QPixmap::fromImage(pictures[i]));
            m_views->doItemsLayout(); // they were laid out without pictures
        });
}

void LibraryPanel::check() {
    const LibraryModel::Library library = m_model.library();
    if (!library || library->templates.empty() || m_checking) return;
    m_checking = true;
    m_stop = std::make_shared<std::atomic<bool>>(false);
    const std::uint64_t job = ++m_job;
    *m_done = 0;
    *m_all = 0;
    refreshReport();
    m_background.run(
        [library, stop = m_stop, done = m_done, all = m_all] {
            return recognition::checkLibrary(
                *library, {},
                [&](std::size_t now, std::size_t of) {
                    *done = static_cast<int>(now);
                    *all = static_cast<int>(of);
                },
                stop.get());
        },
        [this, job, library](std::vector<recognition::TemplateCheck> checks) {
            if (job != m_job) return;
            m_checking = false;
            m_checked = library;
            m_checks = checks;
            m_model.setChecks(checks);
            m_confusion.setChecks(std::move(checks));
            m_matrix->verticalHeader()->setMinimumWidth(120);
            refreshReport();
            showChosen();
        });
}

void LibraryPanel::showReport() {
    m_tabs->setCurrentIndex(1);
}

QString LibraryPanel::reportText() const {
    return m_report->text();
}

QString LibraryPanel::healthText() const {
    return m_health->text();
}

/// What could not be tried is not said to be found.
QStringList LibraryPanel::foundWords() const {
    int worrying = 0;
    int untried = 0;
    for (const recognition::TemplateCheck& check : m_checks) {
        if (check.tested == 0) ++untried;
        if (TrainingWords::worrying(check)) ++worrying;
    }
    QStringList lines;
    if (worrying > 0)
        lines << tr("%n landmark(s) need care.", nullptr, worrying);
    else if (untried == 0)
        lines << tr("All landmarks are found well.");
    else if (untried < static_cast<int>(m_checks.size()))
        lines << tr("All that have several views are found well.");
    if (untried > 0)
        lines << tr("%n landmark(s) cannot be tried: there is only one view. Add another.", nullptr, untried);
    return lines;
}

void LibraryPanel::refreshReport() {
    m_progress->setVisible(m_checking);
    m_checkAll->setEnabled(!m_checking && m_model.rowCount() > 0);
    m_csv->setEnabled(!m_checking && m_confusion.rowCount() > 0);
    m_matrix->setVisible(m_confusion.rowCount() > 0);
    QStringList lines;
    if (m_checking) {
        lines << tr("Each view is held back once and looked for with the others; then each landmark is shown "
                    "smaller and turned.");
    } else if (m_confusion.rowCount() == 0) {
        lines << tr("Not checked yet. “Check all” looks how well each landmark is found, and which are taken "
                    "for each other.");
    } else {
        lines << foundWords();
        const int pairs = m_confusion.confusions();
        lines << (pairs == 0 ? tr("None is taken for another.")
                             : tr("%n pair(s) are taken for each other.", nullptr, pairs));
        lines << tr("Rows: whose picture was shown. Columns: what was seen in it. On the diagonal: views "
                    "found again.");
        if (m_checked != m_model.library()) lines << tr("The library was changed since: check again.");
    }
    m_report->setText(lines.join(QLatin1Char('\n')));
}

void LibraryPanel::retranslate() {
    const int rows = m_model.rowCount();
    m_title->setText(m_model.library() ? tr("%n landmark(s)", nullptr, rows) : tr("Landmarks"));
    setEmptyHint(
        m_table,
        m_model.library()
            ? tr("This library is empty. “Teach” begins with the first landmark.")
            : tr("Open a landmark library, or make a new one, to teach Farol what it shall know again."));
    m_table->setAccessibleName(tr("Landmarks of the library"));
    m_table->setToolTip(tr("The landmarks that Farol was taught; press Enter to add views to one"));
    m_views->setAccessibleName(tr("Views of the landmark"));
    m_views->setToolTip(
        tr("The photographs it is learnt from; choose some of them to split or to delete them"));
    setEmptyHint(m_views, tr("The photographs of the chosen landmark are shown here."));
    m_viewsTitle->setText(tr("&Views:"));
    m_tabs->setTabText(0, tr("Landmark"));
    m_tabs->setTabText(1, tr("Report"));
    m_tabs->setAccessibleName(tr("Details"));
    m_tabs->tabBar()->setAccessibleName(tr("Details"));
    m_checkAll->setText(tr("C&heck all"));
    m_checkAll->setAccessibleName(tr("Check all landmarks"));
    m_checkAll->setToolTip(tr("Look how well each landmark is found and which are taken for each other"));
    m_csv->setText(tr("Save as CS&V…"));
    m_csv->setAccessibleName(tr("Save the report as CSV"));
    m_csv->setToolTip(tr("Save the report for a spreadsheet"));
    m_progress->setAccessibleName(tr("Progress of the check"));
    m_matrix->setAccessibleName(tr("Who is taken for whom"));
    m_matrix->setToolTip(tr("Rows: whose picture was shown. Columns: what was seen in it."));
    refreshReport();
}

void LibraryPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        showChosen();
    }
    QWidget::changeEvent(event);
}

} // namespace farol::ui
