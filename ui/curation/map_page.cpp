#include "ui/curation/map_page.h"

#include "core/building/info.h"
#include "ui/convert/convert.h"
#include "ui/curation/feature_panel.h"
#include "ui/curation/floor_pictures.h"
#include "ui/curation/import_dialog.h"
#include "ui/curation/map_actions.h"
#include "ui/curation/plan_panel.h"
#include "ui/curation/report_panel.h"
#include "ui/curation/route_panel.h"
#include "ui/models/core_words.h"
#include "ui/parts/banner.h"
#include "ui/parts/place_chooser.h"

#include <QAction>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSplitter>
#include <QTabBar>
#include <QTabWidget>
#include <QTableView>
#include <QToolBar>
#include <QTreeView>
#include <QUrl>
#include <QVBoxLayout>

#include <utility>

namespace farol::ui {

namespace {

const QString kFailure = QStringLiteral("failure");
const QString kImported = QStringLiteral("imported");
const QString kRefused = QStringLiteral("refused");

} // namespace

MapPage::MapPage(Settings& settings, QWidget* parent)
    : QWidget(parent),
      m_settings(settings),
      m_actions(new MapActions(*this, m_document.undoStack())),
      m_background(this) {
    build();
    connectDocument();
    connectFiles();
    connectEdits();
    connectViews();
    connectOutside();
    connectLayers();
    setAcceptDrops(true);
    m_halves->setSizes({780, 480});
    m_halves->restoreState(settings.splitter(QStringLiteral("map-halves")));
    m_route->setStyle(settings.directionStyle());
    connect(&settings, &Settings::guidanceChanged, this,
            [this] { m_route->setStyle(m_settings.directionStyle()); });
    retranslate();
    showWork();
    m_route->setBuilding(nullptr, false);
}

MapPage::~MapPage() = default;

void MapPage::build() {
    m_banners = new BannerStack(this);
    m_work = new QFrame(this);
    m_work->setFrameShape(QFrame::StyledPanel);
    m_workText = new QLabel(m_work);
    m_workText->setTextFormat(Qt::PlainText);
    m_workBar = new QProgressBar(m_work);
    m_workBar->setRange(0, 0);
    m_workBar->setTextVisible(false);
    m_workBar->setMaximumWidth(220);
    m_cancel = new QPushButton(m_work);
    auto* work = new QHBoxLayout(m_work);
    work->setContentsMargins(10, 4, 10, 4);
    work->addWidget(m_workText, 1);
    work->addWidget(m_workBar);
    work->addWidget(m_cancel);
    m_halves = new QSplitter(Qt::Horizontal, this);
    m_plan = new PlanPanel(m_halves);
    m_pictures = new FloorPictures(*m_plan, m_settings, this);
    m_tabs = new QTabWidget(m_halves);
    m_tabs->setDocumentMode(true);
    m_features = new FeaturePanel(m_tabs);
    m_report = new ReportPanel(m_tabs);
    m_route = new RoutePanel(m_tabs);
    for (QWidget* panel : std::initializer_list<QWidget*>{m_features, m_report, m_route})
        m_tabs->addTab(panel, QString());
    m_halves->addWidget(m_plan);
    m_halves->addWidget(m_tabs);
    m_halves->setStretchFactor(0, 1);
    m_halves->setStretchFactor(1, 1);
    m_halves->setChildrenCollapsible(false);
    m_halves->setHandleWidth(8);
    auto* content = new QVBoxLayout;
    content->setContentsMargins(8, 4, 8, 4);
    content->addWidget(m_halves, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(&m_actions->bar());
    layout->addWidget(m_banners);
    layout->addWidget(m_work);
    layout->addLayout(content, 1);
}

void MapPage::connectDocument() {
    connect(&m_document, &MapDocument::opened, this, &MapPage::showOpened);
    connect(&m_document, &MapDocument::edited, this, &MapPage::showEdited);
    connect(&m_document, &MapDocument::workChanged, this, &MapPage::showWork);
    connect(&m_document, &MapDocument::failed, this, &MapPage::showFailure);
    connect(&m_document, &MapDocument::findingsChanged, this,
            [this] { m_report->setFindings(m_document.findings(), !m_document.findingsHold()); });
    connect(&m_document, &MapDocument::refused, this, [this](const QString& message) {
        m_banners->show(kRefused, {BannerKind::Warning, message, {}, {}, true});
    });
    connect(&m_document, &MapDocument::stateChanged, this, [this] {
        refreshActions();
        Q_EMIT documentChanged();
    });
    connect(&m_document, &MapDocument::saved, this, [this](const QString& path) {
        m_settings.addRecent(RecentKind::Map, path);
        m_pictures->setName(path);
        m_banners->hide(kFailure);
        m_banners->hide(kImported);
        m_plan->tell(tr("Saved in %1").arg(QDir::toNativeSeparators(path)));
        if (const auto then = std::exchange(m_afterSave, {}); then && !m_document.unsaved()) then();
    });
}

void MapPage::connectFiles() {
    const MapActions& a = *m_actions;
    connect(a.open, &QAction::triggered, this, &MapPage::chooseMap);
    connect(a.import, &QAction::triggered, this, &MapPage::importMap);
    connect(a.save, &QAction::triggered, this, &MapPage::save);
    connect(a.saveAs, &QAction::triggered, this, &MapPage::saveAs);
    connect(a.print, &QAction::triggered, this, &MapPage::print);
    connect(a.walkHere, &QAction::triggered, this, [this] {
        whenSaved([this] {
            if (!m_document.path().isEmpty()) Q_EMIT walkWanted(m_document.path());
        });
    });
    connect(m_cancel, &QPushButton::clicked, &m_document, &MapDocument::cancel);
}

void MapPage::connectEdits() {
    const MapActions& a = *m_actions;
    connect(a.addLandmark, &QAction::triggered, this, [this] {
        m_like.reset();
        startPlacing(true);
    });
    connect(a.addAccess, &QAction::triggered, this, [this] { startPlacing(false); });
    connect(a.edit, &QAction::triggered, this, &MapPage::editSelected);
    connect(a.remove, &QAction::triggered, this, &MapPage::removeSelected);
    MapView& view = m_plan->view();
    connect(&view, &MapView::placeWanted, this, &MapPage::placed);
    connect(&view, &MapView::placeGivenUp, this, [this] {
        m_pictures->endPlacing();
        m_plan->view().setTool(MapView::Tool::Move);
        m_plan->tell({});
    });
    connect(&view, &MapView::moveWanted, this, &MapPage::moveSelected);
    connect(&view, &MapView::activated, this, &MapPage::openForm);
    connect(&view, &MapView::menuWanted, this, &MapPage::openMenu);
    connect(m_features, &FeaturePanel::activated, this, &MapPage::openForm);
}

void MapPage::connectViews() {
    const MapActions& a = *m_actions;
    MapView& view = m_plan->view();
    connect(&view, &MapView::levelChanged, m_features, &FeaturePanel::setLevel);
    connect(&view, &MapView::selectionChanged, this, [this](const std::optional<MapHit>& hit) {
        refreshActions();
        if (m_linking) return;
        const QScopedValueRollback linking(m_linking, true);
        m_features->select(hit);
    });
    connect(m_features, &FeaturePanel::selectionChanged, this, [this](const std::optional<MapHit>& hit) {
        if (m_linking) return;
        const QScopedValueRollback linking(m_linking, true);
        m_plan->view().select(hit, true);
    });
    connect(m_report, &ReportPanel::featureWanted, this,
            [this](const MapHit& hit) { m_plan->view().select(hit, true); });
    connect(m_report, &ReportPanel::checkWanted, &m_document, &MapDocument::check);
    connect(a.check, &QAction::triggered, this, [this] {
        m_tabs->setCurrentWidget(m_report);
        m_document.check();
    });
    connect(a.nextFeature, &QAction::triggered, m_report, &ReportPanel::showNext);
    connect(a.find, &QAction::triggered, this, [this] {
        m_tabs->setCurrentWidget(m_features);
        m_features->focusSearch();
    });
    const auto routeAt = [this](void (RoutePanel::*set)(const std::optional<RegionId>&)) {
        const auto& hit = m_plan->view().selected();
        const auto region = hit ? regionOf(*hit) : std::nullopt;
        if (!region) return;
        m_tabs->setCurrentWidget(m_route);
        (m_route->*set)(region);
    };
    connect(a.routeFrom, &QAction::triggered, this, [routeAt] { routeAt(&RoutePanel::setFrom); });
    connect(a.routeTo, &QAction::triggered, this, [routeAt] { routeAt(&RoutePanel::setTo); });
    const auto drawRoute = [this] {
        MapOverlay overlay = m_plan->view().overlay();
        overlay.route = m_route->model().route();
        overlay.destination = overlay.route && !overlay.route->regions.empty()
                                  ? std::optional<RegionId>(overlay.route->regions.back())
                                  : std::nullopt;
        m_plan->view().setOverlay(overlay);
    };
    connect(m_route, &RoutePanel::routeChanged, this, drawRoute);
    connect(m_route, &RoutePanel::manoeuvreChosen, this, [this](const routing::Manoeuvre& manoeuvre) {
        MapView& plan = m_plan->view();
        plan.setLevel(manoeuvre.level);
        plan.setViewTransform(plan.viewTransform().centredOn(manoeuvre.position));
    });
}

void MapPage::open(const QString& source) {
    whenSaved([this, source] { m_document.open(source); });
}

void MapPage::chooseMap() {
    const QString folder = QFileInfo(m_document.source()).path();
    const QString file = QFileDialog::getOpenFileName(
        this, tr("Open a map"), folder,
        tr("Maps (%1);;All files (%2)").arg(QStringLiteral("*.gpkg"), QStringLiteral("*")));
    if (!file.isEmpty()) open(file);
}

void MapPage::importMap() {
    auto* dialog = new ImportDialog(QFileInfo(m_document.source()).path(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        whenSaved([this, source = dialog->source(), options = dialog->options()] {
            m_document.importFrom(source, options);
        });
    });
    dialog->open();
}

bool MapPage::save() {
    if (m_document.path().isEmpty()) return saveAs();
    m_document.save(m_document.path());
    return true;
}

bool MapPage::saveAs() {
    if (!m_document.building()) return false;
    QString name = m_document.path();
    if (name.isEmpty()) { // beside what was imported
        const QFileInfo source(m_document.source());
        name = QDir(source.path()).filePath(source.completeBaseName() + QStringLiteral(".gpkg"));
    }
    QString file = QFileDialog::getSaveFileName(this, tr("Save the map"), name,
                                                tr("Maps (%1)").arg(QStringLiteral("*.gpkg")));
    if (file.isEmpty()) return false;
    if (QFileInfo(file).suffix().isEmpty()) file += QStringLiteral(".gpkg");
    m_document.save(file);
    return true;
}

void MapPage::whenSaved(std::function<void()> then) {
    if (!m_document.unsaved()) return then();
    auto* box = new QMessageBox(QMessageBox::Question, tr("Unsaved changes"),
                                tr("The map has changes that are not saved."),
                                QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
    box->setInformativeText(tr("Save them first?"));
    box->setDefaultButton(QMessageBox::Save);
    box->setAttribute(Qt::WA_DeleteOnClose);
    connect(box, &QMessageBox::finished, this, [this, then = std::move(then)](int answer) {
        if (answer == QMessageBox::Discard) return then();
        if (answer != QMessageBox::Save) return;
        m_afterSave = then;
        if (!save()) m_afterSave = {};
    });
    box->open();
}

void MapPage::showOpened() {
    const auto& building = m_document.building();
    m_banners->hide(kFailure);
    m_banners->hide(kRefused);
    m_banners->hide(QStringLiteral("place"));
    m_features->setBuilding(building);
    m_report->setBuilding(building);
    m_plan->setBuilding(building);
    m_features->setLevel(m_plan->view().level());
    m_route->setBuilding(building, false);
    if (m_document.imported()) {
        m_tabs->setCurrentWidget(m_report);
        m_banners->show(kImported,
                        {BannerKind::Note,
                         tr("Imported from %1. Look at what was found, then save it as a map of Farol.")
                             .arg(QDir::toNativeSeparators(m_document.source())),
                         tr("Sa&ve…"), [this] { saveAs(); }, true});
    } else {
        m_banners->hide(kImported);
        m_settings.addRecent(RecentKind::Map, m_document.source());
    }
    m_report->setBusy(false);
    m_pictures->setMap(building, m_document.path().isEmpty() ? m_document.source() : m_document.path());
    showLayers();
    refreshActions();
    if (std::exchange(m_placeWhenOpen, false)) startPlacing(true);
}

void MapPage::showFailure(const QString& message) {
    m_afterSave = {};
    m_banners->show(kFailure, {BannerKind::Problem, message, {}, {}, true});
}

void MapPage::showWork() {
    const MapDocument::Work work = m_document.work();
    const bool loading = work == MapDocument::Work::Opening || work == MapDocument::Work::Importing;
    m_work->setVisible(work != MapDocument::Work::None);
    m_cancel->setVisible(loading);
    QString text;
    if (work == MapDocument::Work::Opening) text = tr("The map is being opened…");
    if (work == MapDocument::Work::Importing) text = tr("The map is being imported and checked…");
    if (work == MapDocument::Work::Saving) text = tr("The map is being saved…");
    if (work == MapDocument::Work::Checking) text = tr("The map is being checked…");
    m_workText->setText(text);
    m_workBar->setAccessibleName(text);
    m_report->setBusy(work != MapDocument::Work::None);
    refreshActions();
}

void MapPage::refreshActions() {
    const bool open = m_document.building() != nullptr;
    const bool idle = m_document.work() == MapDocument::Work::None;
    const std::optional<MapHit>& hit = m_plan->view().selected();
    const MapActions& a = *m_actions;
    a.save->setEnabled(open && idle && m_document.unsaved());
    a.saveAs->setEnabled(open && idle);
    a.print->setEnabled(open);
    a.addLandmark->setEnabled(open);
    a.addAccess->setEnabled(open);
    a.edit->setEnabled(open && hit);
    a.remove->setEnabled(open && hit && hit->what != MapHit::What::Region);
    a.routeFrom->setEnabled(open && hit && regionOf(*hit));
    a.routeTo->setEnabled(open && hit && regionOf(*hit));
    a.check->setEnabled(open && idle);
    a.nextFeature->setEnabled(open);
    a.find->setEnabled(open);
    a.ambiguity->setEnabled(open);
    a.coverage->setEnabled(open);
    a.missing->setEnabled(open);
    a.picture->setEnabled(open);
    a.walkHere->setEnabled(open);
}

bool MapPage::settled() const {
    return m_document.work() == MapDocument::Work::None && !m_route->planning() && m_marking == 0 &&
           !m_pictures->busy();
}

void MapPage::showRoute(const QString& from, const QString& to) {
    const auto region = [this](const QString& where) -> std::optional<RegionId> {
        const auto found = building::resolveWhere(*m_document.building(), toUtf8(where));
        if (!found) showFailure(CoreWords::problem(found.error()));
        return found ? std::optional<RegionId>(found->region) : std::nullopt;
    };
    if (!m_document.building()) return;
    m_tabs->setCurrentWidget(m_route);
    if (!from.isEmpty()) m_route->setFrom(region(from));
    if (!to.isEmpty()) m_route->setTo(region(to));
}

QWidget* MapPage::firstFocus() const {
    return &m_plan->view();
}

std::vector<QWidget*> MapPage::panes() const {
    const QWidget* tab = m_tabs->currentWidget();
    QWidget* list = tab == m_features ? static_cast<QWidget*>(&m_features->table())
                    : tab == m_report ? static_cast<QWidget*>(&m_report->tree())
                                      : &m_route->from();
    return {&m_plan->view(), m_tabs->tabBar(), list->focusProxy() ? list->focusProxy() : list};
}

void MapPage::saveLayout() {
    m_settings.setSplitter(QStringLiteral("map-halves"), m_halves->saveState());
}

void MapPage::retranslate() {
    m_actions->retranslate();
    m_tabs->setTabText(0, tr("Table"));
    m_tabs->setTabText(1, tr("Check"));
    m_tabs->setTabText(2, tr("Route"));
    m_tabs->setAccessibleName(tr("Parts of the map"));
    m_tabs->setToolTip(tr("Parts of the map"));
    m_tabs->tabBar()->setAccessibleName(tr("Parts of the map"));
    m_tabs->tabBar()->setToolTip(tr("Parts of the map"));
    m_pictures->retranslate();
    m_cancel->setText(tr("Ca&ncel"));
    m_cancel->setToolTip(tr("Give up; the map that was open stays"));
    showWork();
}

void MapPage::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    if (event->type() == QEvent::PaletteChange) m_actions->refreshIcons();
    QWidget::changeEvent(event);
}

void MapPage::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls() && event->mimeData()->urls().first().isLocalFile())
        event->acceptProposedAction();
}

/// A picture is laid under the floor that is shown; everything else is opened as a map.
void MapPage::dropEvent(QDropEvent* event) {
    event->acceptProposedAction();
    const QString file = event->mimeData()->urls().first().toLocalFile();
    if (m_document.building() && FloorPictures::isPicture(file)) return m_pictures->load(file);
    open(file);
}

} // namespace farol::ui
