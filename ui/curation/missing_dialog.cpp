#include "ui/curation/missing_dialog.h"

#include "ui/convert/convert.h"
#include "ui/models/no_route_words.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

namespace farol::ui {

namespace {

enum Column { From, To, Missing, Why, ColumnCount };

} // namespace

MissingDialog::MissingDialog(std::shared_ptr<const building::Building> building,
                             const routing::RouteOptions& options, QWidget* parent)
    : QDialog(parent),
      m_building(std::move(building)),
      m_summary(new QLabel(this)),
      m_busy(new QProgressBar(this)),
      m_table(new QTableWidget(0, ColumnCount, this)),
      m_show(new QPushButton(tr("&Show on the plan"), this)),
      m_background(this) {
    setWindowTitle(tr("Missing routes"));
    build();
    m_background.run([map = m_building, options] { return routing::findMissingRoutes(map, options); },
                     [this](routing::MissingRoutes found) { show(std::move(found)); });
    resize(900, 480);
}

void MissingDialog::build() {
    m_summary->setWordWrap(true);
    m_summary->setTextFormat(Qt::PlainText);
    m_summary->setText(tr("Looking for the way between all places…"));
    m_busy->setRange(0, 0);
    m_busy->setTextVisible(false);
    m_busy->setAccessibleName(m_summary->text());
    m_table->setHorizontalHeaderLabels({tr("From"), tr("To"), tr("Missing"), tr("Why")});
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setTabKeyNavigation(false);
    m_table->setAlternatingRowColors(true);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setSectionResizeMode(
        QHeaderView::ResizeToContents); // long ones take more lines
    for (const Column column : {From, To}) m_table->setColumnWidth(column, 190);
    m_table->horizontalHeader()->setSectionResizeMode(Why, QHeaderView::Stretch);
    m_table->horizontalHeader()->setSectionResizeMode(Missing, QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->setAccessibleName(tr("Missing routes"));
    m_table->setToolTip(tr("Places between which no route leads; Enter shows the chosen one on the plan"));
    m_show->setAccessibleName(tr("Show on the plan"));
    m_show->setToolTip(tr("Choose both places on the Map page, and see them on the plan"));
    m_show->setEnabled(false);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->addButton(m_show, QDialogButtonBox::ActionRole);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_summary);
    layout->addWidget(m_busy);
    layout->addWidget(m_table, 1);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_show, &QPushButton::clicked, this, &MissingDialog::showChosen);
    connect(m_table, &QTableWidget::itemActivated, this, &MissingDialog::showChosen);
    connect(m_table, &QTableWidget::itemSelectionChanged, this,
            [this] { m_show->setEnabled(m_table->currentRow() >= 0); });
}

/// The first of the group by name, and how many more.
QString MissingDialog::nameOf(std::size_t group) const {
    const auto& regions = m_found->groups[group].regions;
    const QString first = regionName(m_building.get(), regions.front());
    if (regions.size() == 1) return first;
    return tr("%1 and %n more place(s)", nullptr, static_cast<int>(regions.size() - 1)).arg(first);
}

void MissingDialog::show(routing::MissingRoutes found) {
    m_found = std::move(found);
    m_busy->hide();
    const QLocale locale;
    const auto number = [&locale](std::size_t count) {
        return locale.toString(static_cast<qulonglong>(count));
    };
    QString text = m_found->missingPairs == 0
                       ? tr("From every place there is a route to every other one (%1 pairs of places).")
                             .arg(number(m_found->pairs))
                       : tr("Of %1 pairs of places, %2 have no route.")
                             .arg(number(m_found->pairs), number(m_found->missingPairs));
    if (m_found->leftOut > 0)
        text += QLatin1Char(' ') + tr("%n more line(s) are not listed: mend these first.", nullptr,
                                      static_cast<int>(m_found->leftOut));
    m_summary->setText(text);
    m_summary->setAccessibleName(text);
    for (const routing::MissingRoute& route : m_found->routes) {
        const int row = m_table->rowCount();
        m_table->insertRow(row);
        const auto set = [this, row](int column, const QString& words) {
            auto* item = new QTableWidgetItem(words);
            item->setToolTip(words);
            m_table->setItem(row, column, item);
        };
        set(From, nameOf(route.from));
        set(To, nameOf(route.to));
        set(Missing, route.bothWays ? tr("both ways") : tr("this way"));
        set(Why, NoRouteWords::sentence(*m_building, route.why));
    }
    if (m_table->rowCount() > 0) m_table->selectRow(0);
}

void MissingDialog::showChosen() {
    const int row = m_table->currentRow();
    if (!m_found || row < 0) return;
    const routing::MissingRoute& route = m_found->routes[static_cast<std::size_t>(row)];
    Q_EMIT routeWanted(m_found->groups[route.from].regions.front(),
                       m_found->groups[route.to].regions.front());
}

QString MissingDialog::summary() const {
    return m_summary->text();
}

} // namespace farol::ui
