#include "core/building/edit.h"
#include "ui/convert/convert.h"
#include "ui/curation/feature_dialogs.h"
#include "ui/curation/feature_panel.h"
#include "ui/curation/floor_pictures.h"
#include "ui/curation/map_actions.h"
#include "ui/curation/map_page.h"
#include "ui/curation/plan_panel.h"
#include "ui/curation/plan_print.h"
#include "ui/curation/report_panel.h"
#include "ui/curation/route_panel.h"
#include "ui/parts/banner.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QMenu>

namespace farol::ui {

namespace {

MapHit::What whatOf(const building::Feature& feature) {
    return static_cast<MapHit::What>(feature.index()); // regions, accesses, landmarks in both
}

} // namespace

/// Plan, table, report and route follow a change; what was changed is chosen.
void MapPage::showEdited(const building::Edit& edit) {
    const auto& building = m_document.building();
    const MapHit hit{whatOf(edit.after ? *edit.after : *edit.before), edit.index};
    const bool same = edit.before && edit.after;
    if (!same) m_plan->view().select(std::nullopt, false); // the rows behind it have moved
    m_plan->replaceBuilding(building);
    m_features->setBuilding(building);
    m_report->setBuilding(building);
    m_route->setBuilding(building, true);
    if (edit.after) {
        m_plan->view().select(hit, true);
        m_features->select(hit);
    }
    showLayers();
    refreshActions();
}

void MapPage::placeLandmark(const building::Landmark& like) {
    m_like = like;
    m_placeWhenOpen = m_document.building() == nullptr;
    if (!m_placeWhenOpen) return startPlacing(true);
    m_banners->show(QStringLiteral("place"),
                    {BannerKind::Note, tr("Open the map on which the landmark shall stand."),
                     tr("&Open map…"), [this] { chooseMap(); }, true});
}

void MapPage::startPlacing(bool landmark) {
    m_pictures->endPlacing();
    m_placeLandmark = landmark;
    MapView& view = m_plan->view();
    view.setTool(MapView::Tool::Place);
    view.setFocus(Qt::ShortcutFocusReason);
    m_plan->tell(landmark ? tr("Click where the landmark stands, or move the plan under the cross with the "
                               "arrows and press Enter. Escape gives up.")
                          : tr("Click where the door is, or move the plan under the cross with the arrows "
                               "and press Enter. Escape gives up."));
}

void MapPage::placed(Point2 at) {
    if (m_pictures->placing()) return m_pictures->placed(at);
    MapView& view = m_plan->view();
    view.setTool(MapView::Tool::Move);
    m_plan->tell({});
    const auto& building = m_document.building();
    if (m_placeLandmark) return landmarkPlaced(at);
    auto* form = new AccessDialog(
        building, building::newAccess(*building, building::AccessKind::Door, at, view.level()), this);
    form->setAttribute(Qt::WA_DeleteOnClose);
    connect(form, &QDialog::accepted, this, [this, form] {
        m_document.push(building::insertion(*m_document.building(), form->access()), tr("Add a door"));
    });
    form->open();
}

void MapPage::landmarkPlaced(Point2 at) {
    const auto& building = m_document.building();
    building::Landmark fresh =
        building::newLandmark(*building, m_like ? m_like->kind : m_lastKind, at, m_plan->view().level());
    if (m_like) {
        fresh.templateId = m_like->templateId;
        fresh.widthM = m_like->widthM;
        fresh.tallM = m_like->tallM;
    }
    m_like.reset();
    auto* form = new LandmarkDialog(building, fresh, this);
    form->setAttribute(Qt::WA_DeleteOnClose);
    connect(form, &QDialog::accepted, this, [this, form] {
        const building::Landmark landmark = form->landmark();
        m_lastKind = landmark.kind;
        m_document.push(building::insertion(*m_document.building(), landmark), tr("Add a landmark"));
    });
    form->open();
}

void MapPage::editSelected() {
    if (m_plan->view().selected()) openForm(*m_plan->view().selected());
}

void MapPage::openForm(const MapHit& hit) {
    const auto& building = m_document.building();
    const auto show = [this, hit](auto* form, auto value) {
        form->setAttribute(Qt::WA_DeleteOnClose);
        connect(form, &QDialog::accepted, this, [this, form, hit, value] {
            m_document.push(building::change(*m_document.building(), hit.index, (form->*value)()),
                            tr("Change %1").arg(m_plan->describe(hit)));
        });
        form->open();
    };
    switch (hit.what) {
    case MapHit::What::Region:
        return show(new RegionDialog(building->regions()[hit.index], this), &RegionDialog::region);
    case MapHit::What::Access:
        return show(new AccessDialog(building, building->accesses()[hit.index], this), &AccessDialog::access);
    case MapHit::What::Landmark:
        return show(new LandmarkDialog(building, building->landmarks()[hit.index], this),
                    &LandmarkDialog::landmark);
    }
}

void MapPage::removeSelected() {
    const std::optional<MapHit> hit = m_plan->view().selected();
    if (!hit || hit->what == MapHit::What::Region) return;
    const building::Building& building = *m_document.building();
    const QString what = m_plan->describe(*hit);
    m_document.push(hit->what == MapHit::What::Access ? building::removalOfAccess(building, hit->index)
                                                      : building::removalOfLandmark(building, hit->index),
                    tr("Delete %1").arg(what));
    m_plan->tell(tr("Deleted: %1. Ctrl+Z brings it back.").arg(what));
}

void MapPage::moveSelected(const MapHit& hit, Point2 by, bool byKey) {
    const building::Building& building = *m_document.building();
    const QString text = tr("Move %1").arg(m_plan->describe(hit));
    if (hit.what == MapHit::What::Access) {
        const building::Access moved = building::moved(building, building.accesses()[hit.index], by);
        m_document.push(building::change(building, hit.index, moved), text, byKey);
    } else if (hit.what == MapHit::What::Landmark) {
        const building::Landmark& landmark = building.landmarks()[hit.index];
        const building::Landmark moved = building::moved(building, landmark, landmark.position + by);
        m_document.push(building::change(building, hit.index, moved), text, byKey);
    }
}

std::optional<RegionId> MapPage::regionOf(const MapHit& hit) const {
    const building::Building& building = *m_document.building();
    if (hit.what == MapHit::What::Region) return building.regions()[hit.index].id;
    if (hit.what == MapHit::What::Landmark && building.region(building.landmarks()[hit.index].region))
        return building.landmarks()[hit.index].region;
    return std::nullopt;
}

void MapPage::openMenu(const MapHit& /*hit*/, const QPoint& at) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addActions({m_actions->edit, m_actions->remove});
    menu->addSeparator();
    menu->addActions({m_actions->routeFrom, m_actions->routeTo});
    menu->popup(at);
}

void MapPage::print() {
    if (!m_document.building()) return;
    const QString source = m_document.path().isEmpty() ? m_document.source() : m_document.path();
    const QFileInfo info(source);
    const QString name = QDir(info.path()).filePath(info.completeBaseName() + QStringLiteral(".pdf"));
    const QString file = QFileDialog::getSaveFileName(this, tr("Print the plan"), name,
                                                      tr("PDF (%1)").arg(QStringLiteral("*.pdf")));
    if (file.isEmpty()) return;
    if (printPlan(m_document.building(), m_plan->view().overlay(), file))
        m_plan->tell(tr("Printed in %1").arg(QDir::toNativeSeparators(file)));
    else
        showFailure(tr("%1 cannot be written. Choose another folder.").arg(QDir::toNativeSeparators(file)));
}

} // namespace farol::ui
