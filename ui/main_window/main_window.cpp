#include "ui/main_window/main_window.h"

#include "core/building/info.h"
#include "ui/convert/convert.h"
#include "ui/curation/map_actions.h"
#include "ui/curation/plan_panel.h"
#include "ui/demo/demo_bar.h"
#include "ui/live/frame_panel.h"
#include "ui/live/map_panel.h"
#include "ui/main_window/keys_dialog.h"
#include "ui/main_window/localiser_menu.h"
#include "ui/main_window/profile_menu.h"
#include "ui/main_window/settings_dialog.h"
#include "ui/main_window/source_dialog.h"
#include "ui/main_window/window_actions.h"
#include "ui/models/core_words.h"
#include "ui/parts/banner.h"
#include "ui/parts/place_chooser.h"
#include "ui/training/training_actions.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTabBar>
#include <QTimer>

namespace farol::ui {

namespace {

QString keyOf(Problem kind) {
    return QStringLiteral("problem-%1").arg(static_cast<int>(kind));
}

const QString kExample = QStringLiteral("example");
const QString kEnded = QStringLiteral("ended");
const QString kRemark = QStringLiteral("remark");
const QString kRecording = QStringLiteral("recording");
const QString kDemo = QStringLiteral("demo");

} // namespace

MainWindow::MainWindow(Settings& settings, Walk::OpenSource open, SpeechDesk::MakeOutput makeOutput,
                       QWidget* parent)
    : QMainWindow(parent),
      m_settings(settings),
      m_simulated(std::make_shared<SimulatedWalks>()),
      m_walk(Demo::opener(m_simulated, std::move(open))),
      m_speech(settings, std::move(makeOutput)),
      m_actions(new WindowActions(*this)),
      m_page(new LivePage(m_walk, m_speech, settings, this)),
      m_mapPage(new MapPage(settings, this)),
      m_demo(new Demo(m_walk, m_simulated, this)),
      m_demoBar(new DemoBar(*this, *m_demo)),
      m_localisers(new LocaliserMenu(m_walk, settings, this)),
      m_profiles(new ProfileMenu(settings, this)),
      m_trainingPage(new TrainingPage(
          settings, QDir(settings.workFolder()).filePath(QStringLiteral("teaching")), m_walk.opener(), this)),
      m_pages(new QStackedWidget(this)),
      m_pageTabs(new QTabBar(this)),
      m_status(new QLabel(this)),
      m_busy(new QProgressBar(this)) {
    m_pages->addWidget(m_page);
    m_pages->addWidget(m_mapPage);
    m_pages->addWidget(m_trainingPage);
    setCentralWidget(m_pages);
    m_status->setTextFormat(Qt::PlainText);
    m_busy->setRange(0, 0);
    m_busy->setMaximumWidth(120);
    m_busy->setTextVisible(false);
    m_busy->hide();
    statusBar()->addWidget(m_status, 1);
    statusBar()->addPermanentWidget(m_busy);
    statusBar()->setSizeGripEnabled(false);
    statusBar()->setContentsMargins(6, 0, 6, 0);
    setMinimumSize(900, 620);
    resize(1280, 800);
    restoreGeometry(settings.windowGeometry());
    connectFile();
    connectWalk();
    connectVoice();
    connectView();
    connectNews();
    connectPages();
    connectDemo();
    connectTraining();
    connectMapWatch();
    connectSupervision();
    connectSettings();
    showPage(Page::Walk);
    m_walk.setVerbosity(settings.verbosity());
    m_walk.setRecordFolder([this] { return nextRecording(); });
    const int speed = m_actions->speed->findData(settings.speed());
    m_actions->speed->setCurrentIndex(speed >= 0 ? speed : m_actions->speed->findData(1.0));
    m_walk.setSpeed(m_actions->speed->currentData().toDouble());
    fillRecent();
    showState(session::RunState::Idle);
    retranslate();
}

MainWindow::~MainWindow() = default;

void MainWindow::applyLanguage(const Settings& settings) {
    const QString chosen = settings.language();
    if (!installTranslation(chosen.isEmpty() ? QLocale::system().name() : chosen))
        installTranslation(QStringLiteral("en"));
}

void MainWindow::connectFile() {
    const WindowActions& a = *m_actions;
    connect(a.openMap, &QAction::triggered, this, &MainWindow::chooseMap);
    connect(a.openLibrary, &QAction::triggered, this, &MainWindow::chooseLibrary);
    connect(a.closeLibrary, &QAction::triggered, &m_walk, &Walk::dropLibrary);
    connect(a.openSource, &QAction::triggered, this, &MainWindow::chooseSource);
    connect(a.quit, &QAction::triggered, this, &QWidget::close);
    connect(a.settings, &QAction::triggered, this, [this] { SettingsDialog(m_settings, this).exec(); });
    connect(a.keys, &QAction::triggered, this, [this] {
        KeysDialog(m_actions->withKeys() + m_demoBar->withKeys() + m_mapPage->actions().withKeys() +
                       m_trainingPage->actions().withKeys(),
                   this)
            .exec();
    });
    connect(a.about, &QAction::triggered, this, [this] {
        QMessageBox::about(
            this, tr("About Farol"),
            tr("Farol %1\n\nGuides a blind person through a building with one ordinary camera: it "
               "recognises what it was taught, works out the place, and speaks the way.")
                .arg(QApplication::applicationVersion()));
    });
    connect(&m_settings, &Settings::recentChanged, this, &MainWindow::fillRecent);
}

void MainWindow::connectWalk() {
    const WindowActions& a = *m_actions;
    connect(a.play, &QAction::triggered, this, [this] {
        if (m_walk.state() == session::RunState::Running)
            m_walk.pause();
        else
            m_walk.play();
    });
    connect(a.step, &QAction::triggered, &m_walk, &Walk::step);
    connect(a.stop, &QAction::triggered, &m_walk, &Walk::stop);
    connect(a.faster, &QAction::triggered, this, [this] { changeSpeed(1); });
    connect(a.slower, &QAction::triggered, this, [this] { changeSpeed(-1); });
    connect(a.speed, &QComboBox::currentIndexChanged, this, [this] {
        const double factor = m_actions->speed->currentData().toDouble();
        m_settings.setSpeed(factor);
        m_walk.setSpeed(factor);
    });
    connect(a.destination, &QAction::triggered, this, [this] { m_page->destination().focusAndOpen(); });
    connect(a.start, &QAction::triggered, this, [this] { m_page->startPlace().focusAndOpen(); });
    connect(a.noDestination, &QAction::triggered, this, [this] { m_walk.setDestination(std::nullopt); });
    connect(a.record, &QAction::toggled, this, &MainWindow::toggleRecording);
    connect(&m_settings, &Settings::guidanceChanged, this,
            [this] { m_walk.setVerbosity(m_settings.verbosity()); });
}

void MainWindow::connectVoice() {
    const WindowActions& a = *m_actions;
    connect(a.repeat, &QAction::triggered, &m_speech, &SpeechDesk::repeatLast);
    connect(a.mute, &QAction::toggled, &m_settings, &Settings::setMuted);
    connect(&m_settings, &Settings::mutedChanged, a.mute, &QAction::setChecked);
    a.mute->setChecked(m_settings.muted());
    for (QAction* language : a.languages)
        connect(language, &QAction::triggered, this,
                [this, language] { m_settings.setLanguage(language->data().toString()); });
    connect(&m_settings, &Settings::languageChanged, this, [this] { applyLanguage(m_settings); });
}

void MainWindow::connectView() {
    const WindowActions& a = *m_actions;
    connect(a.fitMap, &QAction::triggered, this, [this] { shownMap().fit(); });
    connect(a.zoomIn, &QAction::triggered, this, [this] { shownMap().zoom(1.25); });
    connect(a.zoomOut, &QAction::triggered, this, [this] { shownMap().zoom(0.8); });
    connect(a.follow, &QAction::toggled, &m_settings, &Settings::setFollowLevel);
    connect(a.grid, &QAction::toggled, &m_settings, &Settings::setShowGrid);
    connect(a.rejected, &QAction::toggled, &m_settings, &Settings::setShowRejected);
    const auto refresh = [this] {
        m_actions->follow->setChecked(m_settings.followLevel());
        m_actions->grid->setChecked(m_settings.showGrid());
        m_actions->rejected->setChecked(m_settings.showRejected());
    };
    connect(&m_settings, &Settings::displayChanged, this, refresh);
    refresh();
    connect(a.nextPane, &QAction::triggered, this, [this] { movePane(1); });
    connect(a.previousPane, &QAction::triggered, this, [this] { movePane(-1); });
}

void MainWindow::connectDemo() {
    m_actions->addPageMenu(m_demoBar->menu());
    m_actions->addToWalkMenu(*m_localisers);
    const auto tell = [this] {
        const QString news = m_demoBar->news();
        if (news.isEmpty()) return m_page->banners().hide(kDemo);
        const bool over = m_demo->over();
        m_page->banners().show(kDemo, {BannerKind::Note, news, over ? tr("&Next visitor now") : QString(),
                                       [this] { m_demo->nextVisitor(); }, true});
    };
    connect(m_demo, &Demo::changed, this, tell);
    connect(&m_walk, &Walk::snapshotChanged, this, [this] {
        std::optional<TruePlace> place;
        if (const auto truth = m_demo->truth()) {
            place = TruePlace{truth->pose.position, truth->pose.level, truth->pose.heading, truth->region};
            const localisation::Fix& fix = m_walk.snapshot()->step.fix;
            if (fix.region) m_calibration.note(fix.confidence, *fix.region == truth->region);
        }
        m_page->mapPanel().setTruth(place);
    });
    connect(&m_settings, &Settings::languageChanged, this, tell);
}

void MainWindow::connectNews() {
    connect(&m_walk, &Walk::stateChanged, this, &MainWindow::showState);
    connect(&m_walk, &Walk::problem, this, &MainWindow::showProblem);
    connect(&m_walk, &Walk::problemSolved, this,
            [this](Problem kind) { m_page->banners().hide(keyOf(kind)); });
    connect(&m_walk, &Walk::remark, this, [this](const QString& message) {
        m_page->banners().show(kRemark, {BannerKind::Warning, message, {}, {}, true});
    });
    connect(&m_walk, &Walk::walkBegan, this, [this] {
        m_page->banners().hide(kEnded);
        m_page->banners().hide(kRecording);
        m_page->banners().hide(kRemark);
    });
    connect(&m_walk, &Walk::busyChanged, this, [this](const QString& what) {
        m_busy->setVisible(!what.isEmpty());
        m_busy->setAccessibleName(what);
        showState(m_walk.state());
    });
    connect(&m_walk, &Walk::mapChanged, this, [this] {
        m_settings.addRecent(RecentKind::Map, m_walk.mapName());
        resolvePlaces();
        retranslate();
    });
    connect(&m_walk, &Walk::libraryChanged, this, [this] {
        m_settings.addRecent(RecentKind::Library, m_walk.libraryName());
        retranslate();
    });
    connect(&m_walk, &Walk::sourceChanged, this, [this] {
        if (!m_demo->on()) m_settings.addRecent(RecentKind::Source, m_walk.source().name);
        retranslate();
    });
}

void MainWindow::begin(const StartOptions& options) {
    if (!options.banner.isEmpty())
        m_page->banners().show(kExample, {BannerKind::Note, options.banner, {}, {}, true});
    if (!options.localiser.isEmpty()) m_localisers->choose(options.localiser);
    m_from = options.from;
    m_to = options.to;
    if (!options.source.isEmpty()) m_walk.setSource({options.source, options.framesPerSecond});
    if (!options.library.isEmpty()) m_walk.loadLibrary(options.library);
    if (!options.map.isEmpty()) m_walk.loadMap(options.map);
    if (options.play) m_walk.play();
    if (options.edit.isEmpty()) return;
    showMap(true);
    if (!options.from.isEmpty() || !options.to.isEmpty())
        connect(&m_mapPage->document(), &MapDocument::opened, this,
                [this, options] { m_mapPage->showRoute(options.from, options.to); });
    m_mapPage->open(options.edit);
}

void MainWindow::resolvePlaces() {
    const auto look = [this](QString& where, auto use) {
        if (where.isEmpty()) return;
        const auto found = building::resolveWhere(*m_walk.building(), toUtf8(where));
        where.clear(); // of this map only
        if (found)
            use(found->region);
        else
            showProblem(Problem::Session, CoreWords::problem(found.error()));
    };
    look(m_from, [this](const RegionId& region) { m_walk.setStart(region); });
    look(m_to, [this](const RegionId& region) { m_walk.setDestination(region); });
}

void MainWindow::showState(session::RunState state) {
    m_actions->setPlaying(state == session::RunState::Running);
    m_actions->stop->setEnabled(m_walk.active());
    m_actions->step->setEnabled(!m_walk.loading());
    QString text;
    switch (state) {
    case session::RunState::Idle:
        text = tr("Ready");
        break;
    case session::RunState::Running:
        text = tr("Walking");
        break;
    case session::RunState::Paused:
        text = tr("Paused");
        break;
    case session::RunState::Ended:
        text = tr("The walk has ended");
        break;
    case session::RunState::Failed:
        text = tr("The walk could not go on");
        break;
    }
    if (m_walk.loading()) text = tr("Loading…");
    if (!m_walk.recording().isEmpty() && state != session::RunState::Idle)
        text +=
            QStringLiteral(" · ") + tr("recorded in %1").arg(QDir::toNativeSeparators(m_walk.recording()));
    m_status->setText(text);
    if (state == session::RunState::Ended && !m_demo->on())
        m_page->banners().show(kEnded,
                               {BannerKind::Note, tr("The walk has ended: there are no more pictures."),
                                tr("Play &again"), [this] { m_walk.play(); }, true});
    else
        m_page->banners().hide(kEnded);
}

void MainWindow::showProblem(Problem kind, const QString& message) {
    BannerText text{BannerKind::Problem, message, {}, {}, true};
    switch (kind) {
    case Problem::Map:
        text.action = tr("Open another &map…");
        text.act = [this] { chooseMap(); };
        break;
    case Problem::Library:
        text.action = tr("Open another &library…");
        text.act = [this] { chooseLibrary(); };
        break;
    case Problem::Source:
        text.action = tr("Open other &pictures…");
        text.act = [this] { chooseSource(); };
        break;
    case Problem::Session:
    case Problem::Recording:
        break;
    }
    m_page->banners().show(keyOf(kind), text);
}

void MainWindow::toggleRecording(bool on) {
    if (!m_walk.active()) return m_page->banners().hide(kRecording);
    const QString text = on ? tr("The walk will be recorded from its next start.")
                            : tr("This walk is recorded to its end; the next one is not.");
    m_page->banners().show(kRecording, {BannerKind::Note, text, on ? tr("Start &again now") : QString(),
                                        [this] {
                                            m_walk.stop();
                                            m_walk.play();
                                        },
                                        true});
}

std::optional<QString> MainWindow::nextRecording() const {
    if (!m_actions->record->isChecked()) return std::nullopt;
    const QString name = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd-HHmmss-zzz"));
    return QDir(m_settings.recordingFolder()).filePath(QStringLiteral("walk-") + name);
}

void MainWindow::changeSpeed(int by) {
    const int next = m_actions->speed->currentIndex() + by;
    if (next >= 0 && next < m_actions->speed->count()) m_actions->speed->setCurrentIndex(next);
}

void MainWindow::movePane(int by) {
    std::vector<QWidget*> panes{&m_page->destination().edit(), &m_page->startPlace().edit(),
                                &m_page->framePanel().view(), &m_page->mapPanel().view()};
    for (QWidget* table : m_page->tables()) panes.push_back(table);
    if (showsMap()) panes = m_mapPage->panes();
    if (shownPage() == Page::Landmarks) panes = m_trainingPage->panes();
    int at = by > 0 ? -1 : 0;
    for (std::size_t i = 0; i < panes.size(); ++i)
        if (panes[i]->hasFocus()) at = static_cast<int>(i);
    const int count = static_cast<int>(panes.size());
    panes[static_cast<std::size_t>((at + by + count) % count)]->setFocus(Qt::ShortcutFocusReason);
}

void MainWindow::fillRecent() {
    const auto fill = [this](QMenu* menu, RecentKind kind, auto open) {
        menu->clear();
        for (const QString& item : m_settings.recent(kind)) {
            QString text = item;
            menu->addAction(text.replace(QLatin1Char('&'), QLatin1String("&&")), this,
                            [item, open] { open(item); });
        }
        menu->setEnabled(!menu->isEmpty());
    };
    fill(m_actions->recentMaps, RecentKind::Map, [this](const QString& item) {
        if (showsMap())
            m_mapPage->open(item);
        else
            m_walk.loadMap(item);
    });
    fill(m_actions->recentLibraries, RecentKind::Library, [this](const QString& item) {
        if (shownPage() == Page::Landmarks)
            m_trainingPage->open(item);
        else
            m_walk.loadLibrary(item);
    });
    fill(m_actions->recentSources, RecentKind::Source, [this](const QString& item) {
        m_walk.setSource({item, 0.0});
    });
}

void MainWindow::chooseMap() {
    if (showsMap()) return m_mapPage->chooseMap();
    const QString file = QFileDialog::getOpenFileName(
        this, tr("Open a map"), QFileInfo(m_walk.mapName()).path(),
        tr("Maps (%1);;All files (%2)").arg(QStringLiteral("*.gpkg"), QStringLiteral("*")));
    if (!file.isEmpty()) m_walk.loadMap(file);
}

void MainWindow::chooseLibrary() {
    if (shownPage() == Page::Landmarks) return m_trainingPage->chooseLibrary();
    const QString file = QFileDialog::getOpenFileName(
        this, tr("Open a landmark library"), QFileInfo(m_walk.libraryName()).path(),
        tr("Landmark libraries (%1);;All files (%2)").arg(QStringLiteral("*.gpkg"), QStringLiteral("*")));
    if (!file.isEmpty()) m_walk.loadLibrary(file);
}

void MainWindow::chooseSource() {
    SourceDialog dialog(m_walk.source(), this);
    if (dialog.exec() == QDialog::Accepted) m_walk.setSource(dialog.source());
}

QString MainWindow::title() const {
    const auto of = [this](const auto& building, const QString& file) {
        if (!building) return tr("Farol");
        const QString name = toQString(building->data().title);
        return tr("%1 – Farol").arg(name.isEmpty() ? QFileInfo(file).fileName() : name);
    };
    if (shownPage() == Page::Walk) return of(m_walk.building(), m_walk.mapName());
    if (shownPage() == Page::Landmarks) {
        const QString file = QFileInfo(m_trainingPage->document().path()).fileName();
        return file.isEmpty() ? tr("Farol") : tr("%1 – Farol").arg(file);
    }
    const MapDocument& document = m_mapPage->document();
    // The mark of unsaved changes that every desktop uses.
    return of(document.building(), document.source()) + QStringLiteral("[*]");
}

void MainWindow::retranslate() {
    setWindowTitle(title());
    setWindowModified(showsMap() && m_mapPage->document().unsaved());
    m_pageTabs->setTabText(0, tr("Walk"));
    m_pageTabs->setTabText(1, tr("Map"));
    m_pageTabs->setTabText(2, tr("Landmarks"));
    m_pageTabs->setAccessibleName(tr("Pages"));
    m_pageTabs->setToolTip(tr("Watch a walk, work on a map, or teach landmarks (Ctrl+1 to Ctrl+3)"));
    m_actions->closeLibrary->setEnabled(!m_walk.libraryName().isEmpty());
    for (QAction* language : m_actions->languages)
        language->setChecked(language->data().toString() == installedLanguage());
    statusBar()->setAccessibleName(tr("State of the walk"));
    m_busy->setToolTip(tr("Something is being loaded"));
}

void MainWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        m_walk.followLanguage();
        m_actions->retranslate();
        m_demoBar->retranslate();
        m_localisers->retranslate();
        m_profiles->retranslate();
        retranslate();
        showState(m_walk.state());
    }
    QMainWindow::changeEvent(event);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (m_mapPage->document().unsaved() && !m_leaving) {
        event->ignore();
        showMap(true);
        m_mapPage->whenSaved([this] {
            m_leaving = true;
            QTimer::singleShot(0, this, &QWidget::close); // when the question's own window is gone
        });
        return;
    }
    if (!m_leaving && !mayLeave()) return event->ignore();
    m_leaving = false;
    m_settings.setWindowGeometry(saveGeometry());
    m_page->saveLayout();
    m_mapPage->saveLayout();
    m_trainingPage->saveLayout();
    m_settings.sync();
    m_walk.stop();
    QMainWindow::closeEvent(event);
}

} // namespace farol::ui
