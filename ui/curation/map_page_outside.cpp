// What other programs do to the map's file while it is open here: told, and nothing is lost on either side.

#include "ui/curation/feature_panel.h"
#include "ui/curation/map_actions.h"
#include "ui/curation/map_page.h"
#include "ui/curation/plan_panel.h"
#include "ui/curation/report_panel.h"
#include "ui/curation/route_panel.h"
#include "ui/parts/banner.h"

#include <QAction>
#include <QDir>
#include <QMessageBox>
#include <QPushButton>

namespace farol::ui {

namespace {

const QString kOutside = QStringLiteral("outside");

} // namespace

void MapPage::connectOutside() {
    connect(&m_document, &MapDocument::replaced, this, &MapPage::showReplaced);
    connect(&m_document, &MapDocument::outsideSettled, this, [this] { m_banners->hide(kOutside); });
    connect(&m_document, &MapDocument::changedOutside, this, [this] {
        const QString text =
            m_document.unsaved()
                ? tr("Another program has changed the file of this map. You have changes of your "
                     "own: loading it again puts them aside, and Ctrl+Z brings them back.")
                : tr("Another program has changed the file of this map.");
        m_banners->show(kOutside, {BannerKind::Warning, text, tr("&Load it again"),
                                   [this] { m_document.takeOutside(); }, true});
    });
    connect(&m_document, &MapDocument::fileGone, this, [this] {
        m_banners->show(kOutside,
                        {BannerKind::Warning,
                         tr("The file %1 is no longer there. The map stays open here: save it, or it is "
                            "lost when you leave.")
                             .arg(QDir::toNativeSeparators(m_document.path())),
                         tr("Sa&ve…"), [this] { saveAs(); }, true});
    });
    connect(&m_document, &MapDocument::fileUnreadable, this, [this](const QString& message) {
        m_banners->show(
            kOutside,
            {BannerKind::Warning,
             tr("Another program has changed the file of this map, and it cannot be read any more (%1). "
                "The map stays open here as it was: save it under another name.")
                 .arg(message),
             tr("Sa&ve…"), [this] { saveAs(); }, true});
    });
    connect(&m_document, &MapDocument::overtaken, this, &MapPage::askOvertaken);
}

void MapPage::showReplaced() {
    const auto& building = m_document.building();
    m_plan->view().select(std::nullopt, false); // another feature may stand in its row
    m_plan->setMarks(nullptr);
    m_plan->replaceBuilding(building);
    m_features->setBuilding(building);
    m_features->setLevel(m_plan->view().level());
    m_report->setBuilding(building);
    m_route->setBuilding(building, true);
    showLayers();
    refreshActions();
}

void MapPage::askOvertaken(const QString& path) {
    auto* box =
        new QMessageBox(QMessageBox::Warning, tr("Not saved yet"),
                        tr("Another program has changed the file of this map since it was read here."),
                        QMessageBox::NoButton, this);
    box->setInformativeText(tr("Saving over it would lose what that program wrote."));
    box->setAttribute(Qt::WA_DeleteOnClose);
    auto* elsewhere = box->addButton(tr("Save under &another name…"), QMessageBox::AcceptRole);
    auto* over = box->addButton(tr("Save &over it"), QMessageBox::DestructiveRole);
    box->addButton(QMessageBox::Cancel);
    box->setDefaultButton(elsewhere);
    box->setEscapeButton(QMessageBox::Cancel);
    connect(box, &QMessageBox::finished, this, [this, box, elsewhere, over, path] {
        if (box->clickedButton() == over) return m_document.save(path, true);
        if (box->clickedButton() != elsewhere || !saveAs()) m_afterSave = {};
    });
    box->open();
}

} // namespace farol::ui
