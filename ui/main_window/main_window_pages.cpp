// The window's pages: which one is shown, and what they ask of each other.

#include "ui/convert/convert.h"
#include "ui/curation/map_actions.h"
#include "ui/curation/plan_panel.h"
#include "ui/demo/demo_bar.h"
#include "ui/live/map_panel.h"
#include "ui/main_window/main_window.h"
#include "ui/parts/banner.h"
#include "ui/training/training_actions.h"

#include <QAction>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QStackedWidget>
#include <QTabBar>
#include <QTimer>

namespace farol::ui {

namespace {

const QString kLibrary = QStringLiteral("library");
const QString kMapChanged = QStringLiteral("map-changed");

} // namespace

void MainWindow::connectPages() {
    const WindowActions& a = *m_actions;
    m_actions->addPageMenu(m_mapPage->actions().menu());
    m_actions->addPageMenu(m_trainingPage->actions().menu());
    m_pageTabs->setDocumentMode(true);
    m_pageTabs->setDrawBase(false);
    m_pageTabs->setExpanding(false);
    for (int tab = 0; tab < m_pages->count(); ++tab) m_pageTabs->addTab(QString());
    m_actions->addBesideMenus(*m_pageTabs);
    connect(m_pageTabs, &QTabBar::currentChanged, this,
            [this](int tab) { showPage(static_cast<Page>(tab)); });
    connect(a.walkPage, &QAction::triggered, this, [this] { showMap(false); });
    connect(a.mapPage, &QAction::triggered, this, [this] { showMap(true); });
    connect(a.landmarksPage, &QAction::triggered, this, [this] { showPage(Page::Landmarks); });
    connect(m_mapPage, &MapPage::walkWanted, this, [this](const QString& path) {
        showMap(false);
        m_walk.loadMap(path);
    });
    connect(m_mapPage, &MapPage::documentChanged, this, &MainWindow::retranslate);
}

Page MainWindow::shownPage() const {
    return static_cast<Page>(m_pages->currentIndex());
}

MapView& MainWindow::shownMap() {
    return showsMap() ? m_mapPage->plan().view() : m_page->mapPanel().view();
}

void MainWindow::showPage(Page page) {
    const bool changed = page != shownPage();
    m_pages->setCurrentIndex(static_cast<int>(page));
    m_pageTabs->setCurrentIndex(static_cast<int>(page));
    m_actions->showPage(page);
    m_demoBar->setPageShown(page == Page::Walk);
    m_mapPage->actions().menu().menuAction()->setVisible(page == Page::Map);
    m_trainingPage->actions().menu().menuAction()->setVisible(page == Page::Landmarks);
    if (page == Page::Map && changed) {
        m_mapPage->firstFocus()->setFocus(Qt::OtherFocusReason);
        const MapDocument& document = m_mapPage->document();
        const bool empty = !document.building() && document.work() == MapDocument::Work::None;
        if (empty && !m_walk.mapName().isEmpty()) m_mapPage->open(m_walk.mapName());
    }
    if (page == Page::Landmarks && changed) {
        const LibraryDocument& document = m_trainingPage->document();
        if (!document.library() && !document.busy() && !m_walk.libraryName().isEmpty())
            m_trainingPage->open(m_walk.libraryName());
        m_trainingPage->firstFocus()->setFocus(Qt::OtherFocusReason);
    }
    retranslate();
}

void MainWindow::connectTraining() {
    connect(m_trainingPage, &TrainingPage::documentChanged, this, &MainWindow::retranslate);
    connect(m_trainingPage, &TrainingPage::placeWanted, this, [this](const recognition::Template& entry) {
        building::Landmark like;
        like.kind = entry.kind;
        like.templateId = entry.id;
        like.widthM = entry.widthM;
        like.tallM = entry.heightM;
        showPage(Page::Map);
        m_mapPage->placeLandmark(like);
    });
    connect(m_trainingPage, &TrainingPage::walkWanted, this, [this](const QString& library) {
        showPage(Page::Walk);
        m_walk.loadLibrary(library);
    });
    connect(m_trainingPage, &TrainingPage::librarySaved, this, [this](const QString& library) {
        if (library != m_walk.libraryName()) return;
        if (!m_walk.active()) return m_walk.loadLibrary(library);
        m_page->banners().show(kLibrary, {BannerKind::Note,
                                          tr("The landmark library was changed on the Landmarks page."),
                                          tr("Start &again with it"),
                                          [this, library] {
                                              m_page->banners().hide(kLibrary);
                                              m_walk.loadLibrary(library);
                                              m_walk.play();
                                          },
                                          true});
    });
}

/// A map that is changed while one walks by it, here on the Map page or by another program: the walk goes on
/// with what it knows until the user says otherwise.
void MainWindow::connectMapWatch() {
    connect(&m_walk, &Walk::mapChanged, this, [this] {
        m_page->banners().hide(kMapChanged);
        const QString file = m_walk.mapName();
        m_mapWatch.follow(file, FileStamp::of(file), m_walk.building());
    });
    connect(&m_mapWatch, &MapWatch::changedBack, this, [this] { m_page->banners().hide(kMapChanged); });
    connect(&m_mapWatch, &MapWatch::changed, this, [this] {
        m_page->banners().show(kMapChanged,
                               {BannerKind::Note, tr("The file of this map was changed."),
                                m_walk.active() ? tr("Start &again with it") : tr("&Load it again"),
                                [this] {
                                    const bool walking = m_walk.active();
                                    const auto idOf = [](const std::optional<RegionId>& region) {
                                        return region ? toQString(region->value) : QString();
                                    };
                                    m_from = idOf(m_walk.start());
                                    m_to = idOf(m_walk.destination());
                                    m_walk.loadMap(m_walk.mapName());
                                    if (walking) m_walk.play();
                                },
                                true});
    });
}

/// What could not be saved must not be lost by a slip of the hand.
bool MainWindow::mayLeave() {
    const LibraryDocument& document = m_trainingPage->document();
    if (!document.unsaved() || !document.settled()) return true; // what is being written is waited for
    showPage(Page::Landmarks);
    auto* box =
        new QMessageBox(QMessageBox::Warning, tr("Changes are not saved"),
                        tr("The landmark library could not be written; its last changes would be lost."),
                        QMessageBox::NoButton, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    auto* leave = box->addButton(tr("&Leave all the same"), QMessageBox::DestructiveRole);
    QPushButton* stay = box->addButton(tr("&Stay"), QMessageBox::RejectRole);
    box->setDefaultButton(stay); // a slip on Enter loses nothing
    connect(box, &QMessageBox::buttonClicked, this, [this, leave](QAbstractButton* button) {
        if (button != leave) return;
        m_leaving = true;
        QTimer::singleShot(0, this, &QWidget::close);
    });
    box->open();
    return false;
}

} // namespace farol::ui
