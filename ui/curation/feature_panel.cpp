#include "ui/curation/feature_panel.h"

#include "ui/parts/place_chooser.h"
#include "ui/parts/tables.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QScopedValueRollback>
#include <QTableView>
#include <QVBoxLayout>

namespace farol::ui {

namespace {

constexpr int kWidestColumn = 220;

} // namespace

FeaturePanel::FeaturePanel(QWidget* parent)
    : QWidget(parent),
      m_sort(new QComboBox(this)),
      m_search(new QLineEdit(this)),
      m_levelOnly(new QCheckBox(this)),
      m_count(new QLabel(this)) {
    m_filter.setSourceModel(&m_model); // before the table: its header wants columns
    m_table = panelTable(&m_filter, 0, this);
    m_filter.setDynamicSortFilter(true);
    for (int i = 0; i < 3; ++i) m_sort->addItem(QString());
    m_search->setClearButtonEnabled(true);
    m_table->setSortingEnabled(true);
    m_table->sortByColumn(-1, Qt::AscendingOrder);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Interactive);
    m_table->horizontalHeader()->setMaximumSectionSize(kWidestColumn);
    m_table->horizontalHeader()->setStretchLastSection(true);
    auto* bar = new QHBoxLayout;
    bar->addWidget(m_sort);
    bar->addWidget(m_search, 1);
    auto* foot = new QHBoxLayout;
    foot->addWidget(m_levelOnly);
    foot->addStretch();
    foot->addWidget(m_count);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 6, 4, 4);
    layout->addLayout(bar);
    layout->addWidget(m_table, 1);
    layout->addLayout(foot);

    connect(m_sort, &QComboBox::currentIndexChanged, this,
            [this](int index) { showSort(static_cast<FeatureModel::Sort>(index)); });
    connect(m_search, &QLineEdit::textChanged, this, [this](const QString& text) {
        m_filter.setTyped(text);
        count();
    });
    connect(m_search, &QLineEdit::returnPressed, this, [this] {
        if (m_filter.rowCount() == 0) return;
        m_table->setFocus();
        m_table->selectRow(0);
    });
    connect(m_levelOnly, &QCheckBox::toggled, this, [this](bool on) {
        m_filter.setLevel(on ? std::optional<double>(m_level) : std::nullopt);
        count();
    });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& current) {
                if (!m_quiet && current.isValid()) Q_EMIT selectionChanged(hitOf(current));
            });
    connect(m_table, &QTableView::activated, this, [this](const QModelIndex& index) {
        if (const auto hit = hitOf(index)) Q_EMIT activated(*hit);
    });
    retranslate();
}

/// Columns in which no row has anything are left out.
void FeaturePanel::showColumns() {
    for (int column = 0; column < m_model.columnCount(); ++column) {
        bool empty = true;
        for (int row = 0; empty && row < m_model.rowCount(); ++row)
            empty = m_model.index(row, column).data().toString().isEmpty();
        m_table->setColumnHidden(column, empty && column > 0);
    }
}

void FeaturePanel::fitColumns() {
    m_table->resizeColumnsToContents();
    m_table->horizontalHeader()->setStretchLastSection(false); // it has forgotten to
    m_table->horizontalHeader()->setStretchLastSection(true);
}

std::optional<MapHit> FeaturePanel::hitOf(const QModelIndex& index) const {
    const QModelIndex source = m_filter.mapToSource(index);
    if (!source.isValid()) return std::nullopt;
    return MapHit{static_cast<MapHit::What>(m_model.sort()), static_cast<std::size_t>(source.row())};
}

std::optional<MapHit> FeaturePanel::selected() const {
    return hitOf(m_table->currentIndex());
}

void FeaturePanel::showSort(FeatureModel::Sort sort) {
    const QScopedValueRollback quiet(m_quiet, true);
    m_model.setSort(sort);
    m_table->sortByColumn(-1, Qt::AscendingOrder);
    showColumns();
    fitColumns();
    count();
}

void FeaturePanel::setBuilding(const std::shared_ptr<const building::Building>& building) {
    const QScopedValueRollback quiet(m_quiet, true);
    const bool fresh = m_model.rowCount() == 0;
    m_building = building != nullptr;
    m_model.setBuilding(building);
    showColumns();
    if (fresh) fitColumns(); // an edit leaves the widths as the user has them
    count();
}

void FeaturePanel::setLevel(double ordinal) {
    m_level = ordinal;
    if (m_levelOnly->isChecked()) m_filter.setLevel(ordinal);
    count();
}

void FeaturePanel::select(const std::optional<MapHit>& hit) {
    const QScopedValueRollback quiet(m_quiet, true);
    if (!hit) {
        m_table->clearSelection();
        m_table->setCurrentIndex({});
        return;
    }
    m_sort->setCurrentIndex(static_cast<int>(hit->what));
    QModelIndex row = m_filter.mapFromSource(m_model.index(static_cast<int>(hit->index), 0));
    if (!row.isValid()) { // what is chosen on the plan is shown, whatever was searched for
        m_search->clear();
        m_levelOnly->setChecked(false);
        row = m_filter.mapFromSource(m_model.index(static_cast<int>(hit->index), 0));
    }
    if (!row.isValid() || row.row() == m_table->currentIndex().row()) {
        if (row.isValid()) m_table->selectRow(row.row());
        return;
    }
    m_table->selectRow(row.row());
    m_table->scrollTo(row, QAbstractItemView::EnsureVisible);
}

void FeaturePanel::focusSearch() {
    m_search->setFocus(Qt::ShortcutFocusReason);
    m_search->selectAll();
}

void FeaturePanel::count() {
    setEmptyHint(m_table, m_model.rowCount() > 0 ? tr("No row has what is looked for.")
                          : m_building           ? tr("The map has none of these.")
                                                 : tr("No map is open."));
    m_count->setText(m_filter.rowCount() == m_model.rowCount()
                         ? tr("%n row(s)", nullptr, m_model.rowCount())
                         : tr("%1 of %n row(s)", nullptr, m_model.rowCount()).arg(m_filter.rowCount()));
}

void FeaturePanel::retranslate() {
    m_sort->setItemText(0, tr("Regions"));
    m_sort->setItemText(1, tr("Doors and passages"));
    m_sort->setItemText(2, tr("Landmarks"));
    m_sort->setAccessibleName(tr("What the table lists"));
    m_sort->setToolTip(tr("What the table lists"));
    PlaceChooser::nameClearButton(*m_search);
    m_search->setPlaceholderText(tr("Search the table"));
    m_search->setAccessibleName(tr("Search the table"));
    m_search->setToolTip(tr("Rows that hold every word typed (Ctrl+F)"));
    m_levelOnly->setText(tr("This level onl&y"));
    m_levelOnly->setAccessibleName(tr("This level only"));
    m_levelOnly->setToolTip(tr("List only what is on the level that the plan shows"));
    m_table->setAccessibleName(tr("Attributes"));
    m_table->setToolTip(tr("Choose a row to see it on the plan; press Enter to change it"));
    m_model.retranslate();
    count();
}

void FeaturePanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

} // namespace farol::ui
