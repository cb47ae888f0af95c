// What lies over and under the plan beside the map itself: places that look alike, what is seen from where,
// images of floor plans; and the report of missing routes.

#include "core/building/ambiguity.h"
#include "ui/curation/floor_pictures.h"
#include "ui/curation/map_actions.h"
#include "ui/curation/map_page.h"
#include "ui/curation/missing_dialog.h"
#include "ui/curation/plan_panel.h"
#include "ui/curation/route_panel.h"
#include "ui/map/coverage.h"
#include "ui/parts/banner.h"

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QTabWidget>

#include <cmath>

namespace farol::ui {

namespace {

/// The marks of the regions, by their index.
std::shared_ptr<const std::vector<RegionMark>> ambiguityMarks(const building::Building& building) {
    const building::Ambiguity found = building::findAmbiguity(building);
    std::vector<RegionMark> marks(building.regions().size(), RegionMark::None);
    const auto mark = [&](const RegionId& id, RegionMark as) {
        if (const auto index = building.regionIndex(id)) marks[*index] = as;
    };
    for (const RegionId& id : found.withoutLandmarks) mark(id, RegionMark::NoLandmark);
    for (const auto& group : found.groups)
        for (const RegionId& id : group) mark(id, RegionMark::LooksAlike);
    for (const auto& suggestion : found.suggestions) mark(suggestion.region, RegionMark::LandmarkHelps);
    return std::make_shared<const std::vector<RegionMark>>(std::move(marks));
}

} // namespace

void MapPage::connectLayers() {
    const MapActions& a = *m_actions;
    connect(a.ambiguity, &QAction::toggled, this, &MapPage::showAmbiguity);
    connect(a.coverage, &QAction::toggled, this, &MapPage::showCoverage);
    connect(a.missing, &QAction::triggered, this, &MapPage::showMissing);
    connect(a.picture, &QAction::triggered, this, &MapPage::choosePicture);
    const QString key = QStringLiteral("picture");
    connect(m_pictures, &FloorPictures::failed, this, [this, key](const QString& message) {
        m_banners->show(key, {BannerKind::Problem, message, {}, {}, true});
    });
    connect(m_pictures, &FloorPictures::loaded, this, [this, key] { m_banners->hide(key); });
}

void MapPage::showLayers() {
    showAmbiguity(m_actions->ambiguity->isChecked());
    showCoverage(m_actions->coverage->isChecked());
}

void MapPage::choosePicture() {
    if (!m_document.building()) return;
    const QString file = QFileDialog::getOpenFileName(
        this, tr("Floor-plan image"), QFileInfo(m_document.source()).path(),
        tr("Pictures (%1);;All files (%2)")
            .arg(QStringLiteral("*.png *.jpg *.jpeg *.tif *.tiff *.bmp *.webp"), QStringLiteral("*")));
    if (!file.isEmpty()) m_pictures->load(file);
}

void MapPage::showAmbiguity(bool on) {
    if (!on || !m_document.building()) return m_plan->setMarks(nullptr);
    ++m_marking;
    m_background.run(
        [building = m_document.building()] { return ambiguityMarks(*building); },
        [this, building = m_document.building()](std::shared_ptr<const std::vector<RegionMark>> marks) {
            --m_marking;
            if (building == m_document.building() && m_actions->ambiguity->isChecked())
                m_plan->setMarks(std::move(marks));
        });
}

void MapPage::showCoverage(bool on) {
    if (!on || !m_document.building()) return m_plan->setCoverage(nullptr);
    ++m_marking;
    m_background.run(
        [building = m_document.building()] {
            return std::make_shared<const CoverageLayer>(drawCoverage(findCoverage(*building)));
        },
        [this, building = m_document.building()](const std::shared_ptr<const CoverageLayer>& layer) {
            --m_marking;
            if (building != m_document.building() || !m_actions->coverage->isChecked()) return;
            m_plan->setCoverage(layer);
            m_plan->tell(tr("No landmark is seen from %1 % of the floors.")
                             .arg(QLocale().toString(100.0 * layer->coverage.unseenShare(), 'f', 0)));
        });
}

void MapPage::showMissing() {
    if (!m_document.building()) return;
    auto* dialog = new MissingDialog(m_document.building(), m_route->options(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &MissingDialog::routeWanted, this,
            [this, dialog](const RegionId& from, const RegionId& to) {
                dialog->accept();
                const auto index = m_document.building()->regionIndex(from);
                if (!index) return;
                m_tabs->setCurrentWidget(m_route);
                m_route->setFrom(from);
                m_route->setTo(to);
                m_plan->view().select(MapHit{MapHit::What::Region, *index}, true);
            });
    dialog->open();
}

} // namespace farol::ui
