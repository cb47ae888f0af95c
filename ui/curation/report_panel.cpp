#include "ui/curation/report_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSplitter>
#include <QTreeView>
#include <QVBoxLayout>

namespace farol::ui {

ReportPanel::ReportPanel(QWidget* parent)
    : QWidget(parent),
      m_summary(new QLabel(this)),
      m_tree(new QTreeView(this)),
      m_words(new QPlainTextEdit(this)),
      m_next(new QPushButton(this)),
      m_again(new QPushButton(this)) {
    m_summary->setWordWrap(true);
    m_summary->setTextFormat(Qt::PlainText);
    m_tree->setModel(&m_model);
    m_tree->setUniformRowHeights(true);
    m_tree->setAlternatingRowColors(true);
    m_tree->setTextElideMode(Qt::ElideRight);
    m_tree->header()->setStretchLastSection(false);
    m_tree->header()->setSectionResizeMode(FindingModel::What, QHeaderView::Stretch);
    m_tree->header()->setSectionResizeMode(FindingModel::Features, QHeaderView::Interactive);
    m_tree->header()->resizeSection(FindingModel::Features, 110);
    m_tree->setMinimumHeight(120);
    m_words->setReadOnly(true);
    m_words->setTabChangesFocus(true);
    m_words->setMinimumHeight(80);
    auto* halves = new QSplitter(Qt::Vertical, this);
    halves->addWidget(m_tree);
    halves->addWidget(m_words);
    halves->setStretchFactor(0, 3);
    halves->setStretchFactor(1, 1);
    halves->setChildrenCollapsible(false);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_next);
    buttons->addStretch();
    buttons->addWidget(m_again);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 6, 4, 4);
    layout->addWidget(m_summary);
    layout->addWidget(halves, 1);
    layout->addLayout(buttons);

    connect(m_tree->selectionModel(), &QItemSelectionModel::currentChanged, this, [this] {
        m_which = 0;
        showCurrent();
    });
    connect(m_next, &QPushButton::clicked, this, &ReportPanel::showNext);
    connect(m_again, &QPushButton::clicked, this, &ReportPanel::checkWanted);
    retranslate();
    showCurrent();
}

void ReportPanel::setBuilding(const std::shared_ptr<const building::Building>& building) {
    m_building = building;
    retranslate();
}

void ReportPanel::setFindings(const std::vector<building::Finding>& findings, bool stale) {
    m_stale = stale;
    if (!stale || findings.size() != m_findings.size()) { // else only that they are old now: the place stays
        m_findings = findings;
        m_model.setFindings(findings);
    }
    retranslate();
    showCurrent();
}

void ReportPanel::setBusy(bool busy) {
    m_again->setEnabled(!busy && m_building);
}

QString ReportPanel::summary() const {
    return m_summary->text();
}
QString ReportPanel::explanation() const {
    return m_words->toPlainText();
}

std::optional<MapHit> ReportPanel::featureOf(const building::Finding& finding, std::size_t which) const {
    if (!m_building || which >= finding.ids.size()) return std::nullopt;
    const std::string& id = finding.ids[which];
    if (const auto region = m_building->regionIndex(RegionId(id)); region && finding.layer != "accesses")
        return MapHit{MapHit::What::Region, *region};
    if (const building::Access* access = m_building->access(AccessId(id)); access && !access->line.empty())
        return MapHit{MapHit::What::Access, static_cast<std::size_t>(access - m_building->accesses().data())};
    if (const building::Landmark* landmark = m_building->landmark(LandmarkId(id)))
        return MapHit{MapHit::What::Landmark,
                      static_cast<std::size_t>(landmark - m_building->landmarks().data())};
    return std::nullopt;
}

void ReportPanel::showCurrent() {
    const QModelIndex current = m_tree->currentIndex();
    m_words->setPlainText(m_model.explained(current));
    const building::Finding* finding = m_model.findingAt(current);
    m_next->setEnabled(finding && finding->ids.size() > 1);
    if (!finding) return;
    if (const auto hit = featureOf(*finding, m_which)) Q_EMIT featureWanted(*hit);
}

void ReportPanel::showNext() {
    if (!m_tree->currentIndex().isValid() && m_model.rowCount() > 0) { // the first, with its words
        const QModelIndex group = m_model.index(0, 0);
        m_tree->expand(group);
        return m_tree->setCurrentIndex(m_model.rowCount(group) > 0 ? m_model.index(0, 0, group) : group);
    }
    const building::Finding* finding = m_model.findingAt(m_tree->currentIndex());
    if (!finding || finding->ids.empty()) return;
    for (std::size_t tried = 0; tried < finding->ids.size(); ++tried) {
        m_which = (m_which + 1) % finding->ids.size();
        const auto hit = featureOf(*finding, m_which);
        if (hit) return void(Q_EMIT featureWanted(*hit));
    }
}

void ReportPanel::retranslate() {
    using building::Severity;
    const auto number = [this](Severity severity) { return static_cast<int>(m_model.count(severity)); };
    const QString counts = tr("%1, %2, %3")
                               .arg(tr("%n error(s)", nullptr, number(Severity::Error)),
                                    tr("%n warning(s)", nullptr, number(Severity::Warning)),
                                    tr("%n note(s)", nullptr, number(Severity::Note)));
    if (!m_building)
        m_summary->setText(tr("No map is open."));
    else if (m_stale)
        m_summary->setText(tr("The map was changed after this check: %1.").arg(counts));
    else
        m_summary->setText(m_findings.empty() ? tr("Nothing is wrong with this map.") : counts);
    m_tree->setAccessibleName(tr("Findings"));
    m_tree->setToolTip(tr("What is wrong with the map; choose a finding to see its place on the plan"));
    m_words->setPlaceholderText(tr("Choose a finding to read what it means and what to do."));
    m_words->setAccessibleName(tr("The finding in words"));
    m_words->setToolTip(tr("The finding in words, and what to do"));
    m_next->setText(tr("Ne&xt place"));
    m_next->setToolTip(tr("Show the next place of this finding (F4)"));
    m_again->setText(tr("Chec&k again"));
    m_again->setToolTip(tr("Look for what is wrong with the map as it is now (F7)"));
    m_model.retranslate();
}

void ReportPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        m_words->setPlainText(m_model.explained(m_tree->currentIndex()));
    }
    QWidget::changeEvent(event);
}

} // namespace farol::ui
