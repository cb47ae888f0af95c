#include "ui/live/map_panel.h"

#include "ui/convert/convert.h"
#include "ui/convert/glyphs.h"
#include "ui/models/words.h"
#include "ui/parts/tables.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

namespace farol::ui {

MapPanel::MapPanel(QWidget* parent)
    : QWidget(parent),
      m_view(new MapView(this)),
      m_title(panelTitle(this)),
      m_levelLabel(new QLabel(this)),
      m_levels(new QComboBox(this)),
      m_follow(new QCheckBox(this)),
      m_zoomIn(new QToolButton(this)),
      m_zoomOut(new QToolButton(this)),
      m_fit(new QToolButton(this)),
      m_where(new ElidedLabel(this)) {
    m_levelLabel->setBuddy(m_levels);
    m_levels->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_levels->setMinimumContentsLength(4);
    auto* bar = new QHBoxLayout;
    bar->setSpacing(6);
    bar->addWidget(m_title);
    bar->addStretch();
    for (QWidget* widget :
         std::initializer_list<QWidget*>{m_levelLabel, m_levels, m_follow, m_zoomOut, m_zoomIn, m_fit})
        bar->addWidget(widget);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(bar);
    layout->addWidget(m_view, 1);
    layout->addWidget(m_where);
    for (QToolButton* button : {m_zoomIn, m_zoomOut, m_fit}) {
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
    }

    m_view->setDescriber([this](const MapHit& hit) { return describe(hit); });
    connect(m_levels, &QComboBox::activated, this, &MapPanel::levelPicked);
    connect(m_follow, &QCheckBox::toggled, this, [this](bool on) {
        Q_EMIT followChanged(on);
        show(m_snapshot);
    });
    connect(m_zoomIn, &QToolButton::clicked, this, [this] { m_view->zoom(1.25); });
    connect(m_zoomOut, &QToolButton::clicked, this, [this] { m_view->zoom(0.8); });
    connect(m_fit, &QToolButton::clicked, m_view, &MapView::fit);
    connect(m_view, &MapView::levelChanged, this,
            [this](double ordinal) { m_levels->setCurrentIndex(m_levels->findData(ordinal)); });
    connect(m_view, &MapView::menuWanted, this, &MapPanel::openMenu);
    connect(m_view, &MapView::activated, this, [this](const MapHit& hit) {
        if (const auto region = regionOf(hit)) Q_EMIT destinationWanted(*region);
    });
    m_follow->setChecked(true);
    retranslate();
}

void MapPanel::setBuilding(const std::shared_ptr<const building::Building>& building) {
    m_building = building;
    m_snapshot.reset();
    m_destination.reset();
    m_view->setBuilding(building);
    fillLevels();
    show(nullptr);
}

void MapPanel::fillLevels() {
    const QSignalBlocker quiet(m_levels);
    m_levels->clear();
    const MapScene* scene = m_view->scene();
    if (scene) // the highest floor on top, as in a lift
        for (auto level = scene->levels().rbegin(); level != scene->levels().rend(); ++level)
            m_levels->addItem(levelLabel(*m_building, level->ordinal), level->ordinal);
    m_levels->setCurrentIndex(m_levels->findData(m_view->level()));
    m_levels->setEnabled(m_levels->count() > 1);
}

void MapPanel::levelPicked(int row) {
    if (m_follow->isChecked())
        m_follow->setChecked(false); // a choice by hand must not be undone by the next picture
    m_view->setLevel(m_levels->itemData(row).toDouble());
}

void MapPanel::show(const std::shared_ptr<const session::Snapshot>& snapshot) {
    m_snapshot = snapshot;
    MapOverlay overlay;
    overlay.destination = m_destination;
    overlay.sureConfidence = m_sureConfidence;
    if (snapshot) {
        overlay.truth = m_truth;
        overlay.fix =
            m_told.holds() && m_building ? m_told.shown(snapshot->step.fix, *m_building) : snapshot->step.fix;
        overlay.route = snapshot->step.progress.route;
        overlay.regionsPassed = snapshot->step.progress.regionsPassed;
        if (m_follow->isChecked() && overlay.fix->level) m_view->setLevel(*overlay.fix->level);
    }
    m_view->setOverlay(overlay);
    const QString words = where();
    m_where->setText(words);
    m_where->setToolTip(words);
    if (m_view->accessibleDescription() != words) m_view->setAccessibleDescription(words);
}

QString MapPanel::where() const {
    if (!m_building) return tr("No map is open.");
    if (!m_snapshot)
        return tr("%n place(s) on the map.", nullptr, static_cast<int>(m_building->regions().size()));
    QString words = whereItIs(*m_view->overlay().fix);
    if (m_told.overruled())
        words += QLatin1Char(' ') +
                 tr("The assistant had said: %1.").arg(regionName(m_building.get(), *m_told.region()));
    return words;
}

QString MapPanel::whereItIs(const localisation::Fix& fix) const {
    if (!fix.region) return tr("Where you are is not known yet.");
    const building::Region* region = m_building->region(*fix.region);
    const QString name = regionName(m_building.get(), *fix.region);
    const QString sure =
        m_told.holds() ? tr("said by the assistant") : Words::sureness(fix.confidence, m_sureConfidence);
    if (m_truth && !m_truth->region.empty() && m_truth->region != *fix.region)
        return tr("Taken to be in %1: %2. Really in %3.")
            .arg(name, sure, regionName(m_building.get(), m_truth->region));
    if (region && m_building->levels().size() > 1)
        return tr("You are in %1, %2: %3.").arg(name, Words::level(*m_building, region->level), sure);
    return tr("You are in %1: %2.").arg(name, sure);
}

QString MapPanel::whereText() const {
    return m_where->text();
}

void MapPanel::setDestination(const std::optional<RegionId>& destination) {
    m_destination = destination;
    show(m_snapshot);
}

void MapPanel::setTruth(const std::optional<TruePlace>& truth) {
    m_truth = truth;
    show(m_snapshot);
}

void MapPanel::setFollow(bool follow) {
    m_follow->setChecked(follow);
}
bool MapPanel::follow() const {
    return m_follow->isChecked();
}

std::optional<RegionId> MapPanel::regionOf(const MapHit& hit) const {
    if (!m_building) return std::nullopt;
    if (hit.what == MapHit::What::Region) return m_building->regions()[hit.index].id;
    if (hit.what == MapHit::What::Landmark && m_building->region(m_building->landmarks()[hit.index].region))
        return m_building->landmarks()[hit.index].region;
    return std::nullopt;
}

QString MapPanel::describe(const MapHit& hit) const {
    const building::Building& map = *m_building;
    switch (hit.what) {
    case MapHit::What::Region:
        return Words::about(map.regions()[hit.index]);
    case MapHit::What::Access:
        return Words::about(map, map.accesses()[hit.index]);
    case MapHit::What::Landmark:
        break;
    }
    return Words::about(map, map.landmarks()[hit.index]);
}

void MapPanel::openMenu(const MapHit& hit, const QPoint& at) {
    const std::optional<RegionId> region = regionOf(hit);
    if (!region) return;
    const QString name = regionName(m_building.get(), *region);
    QMenu menu(this);
    const QAction* go = menu.addAction(tr("&Go to %1").arg(name));
    const QAction* start = menu.addAction(tr("&Start at %1").arg(name));
    const QAction* here = menu.addAction(tr("The user &is here, in %1").arg(name));
    const QAction* chosen = menu.exec(at);
    if (chosen == go) Q_EMIT destinationWanted(*region);
    if (chosen == start) Q_EMIT startWanted(*region);
    if (chosen == here) Q_EMIT hereWanted(*region);
}

void MapPanel::retranslate() {
    m_title->setText(tr("Map"));
    m_levelLabel->setText(tr("&Level:"));
    m_levels->setAccessibleName(tr("Level of the map"));
    m_levels->setToolTip(tr("The floor that the map shows (Page Up and Page Down in the map)"));
    m_follow->setText(tr("&Follow"));
    m_follow->setAccessibleName(tr("Follow"));
    m_follow->setToolTip(tr("Switch to the floor where you are whenever it changes"));
    const auto name = [this](QToolButton* button, Glyph glyph, const QString& text) {
        button->setIcon(glyphIcon(glyph, palette()));
        button->setAccessibleName(text);
        button->setToolTip(text);
    };
    name(m_zoomIn, Glyph::ZoomIn, tr("Larger (+)"));
    name(m_zoomOut, Glyph::ZoomOut, tr("Smaller (-)"));
    name(m_fit, Glyph::Fit, tr("Show the whole floor (0)"));
    m_view->setAccessibleName(tr("Floor map"));
    m_view->setToolTip(tr("Drag to move, turn the wheel to zoom, double-click a place to go there"));
    show(m_snapshot);
}

void MapPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange) retranslate();
    QWidget::changeEvent(event);
}

} // namespace farol::ui
