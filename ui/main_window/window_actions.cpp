#include "ui/main_window/window_actions.h"

#include "ui/parts/bar_words.h"
#include "ui/parts/naming.h"
#include "ui/speech/phrasebook.h"

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include <array>

namespace farol::ui {

namespace {

constexpr std::array<double, 6> kSpeeds{0.25, 0.5, 1.0, 2.0, 4.0, 8.0};

} // namespace

WindowActions::WindowActions(QMainWindow& window) : QObject(&window), m_window(window) {
    buildMenus();
    buildToolBar();
    m_window.installEventFilter(this);
    refreshIcons();
    retranslate();
}

QAction* WindowActions::add(QMenu* menu, const QList<QKeySequence>& shortcuts, bool checkable) {
    auto* action = new QAction(&m_window);
    action->setShortcuts(shortcuts);
    action->setCheckable(checkable);
    menu->addAction(action);
    return action;
}

void WindowActions::addGlyph(QAction* action, Glyph glyph) {
    m_icons.push_back({action, glyph});
}

void WindowActions::buildMenus() {
    // Side by side in one row: what stands in the corner of a menu bar, screen readers are not told of.
    auto* row = new QWidget(&m_window);
    m_menuBar = new QMenuBar(row);
    m_besideMenus = new QHBoxLayout(row);
    m_besideMenus->setContentsMargins(0, 0, 0, 0);
    m_besideMenus->setSpacing(0);
    m_besideMenus->addWidget(m_menuBar, 1);
    m_window.setMenuWidget(row);
    QMenuBar* bar = m_menuBar;
    m_file = bar->addMenu(QString());
    openMap = add(m_file, {QKeySequence::Open});
    recentMaps = m_file->addMenu(QString());
    openLibrary = add(m_file, {Qt::CTRL | Qt::Key_L});
    recentLibraries = m_file->addMenu(QString());
    closeLibrary = add(m_file);
    openSource = add(m_file, {Qt::CTRL | Qt::Key_P});
    recentSources = m_file->addMenu(QString());
    m_file->addSeparator();
    savePicture = add(m_file, {Qt::CTRL | Qt::SHIFT | Qt::Key_P});
    saveWalk = add(m_file, {Qt::CTRL | Qt::SHIFT | Qt::Key_E});
    m_file->addSeparator();
    settings = add(m_file, {Qt::CTRL | Qt::Key_Comma});
    m_file->addSeparator();
    quit = add(m_file, {Qt::CTRL | Qt::Key_Q});

    m_walk = bar->addMenu(QString());
    play = add(m_walk, {Qt::Key_F5});
    step = add(m_walk, {Qt::Key_F8});
    stop = add(m_walk, {Qt::SHIFT | Qt::Key_F5});
    m_walk->addSeparator();
    faster = add(m_walk, {Qt::CTRL | Qt::Key_Up});
    slower = add(m_walk, {Qt::CTRL | Qt::Key_Down});
    m_walk->addSeparator();
    destination = add(m_walk, {Qt::CTRL | Qt::Key_G});
    noDestination = add(m_walk, {Qt::CTRL | Qt::SHIFT | Qt::Key_G});
    start = add(m_walk, {Qt::CTRL | Qt::Key_B});
    m_walk->addSeparator();
    here = add(m_walk, {Qt::CTRL | Qt::Key_H});
    wrong = add(m_walk, {Qt::CTRL | Qt::Key_W});
    m_walk->addSeparator();
    record = add(m_walk, {Qt::CTRL | Qt::SHIFT | Qt::Key_R}, true);
    revote = add(m_walk);
    figures = add(m_walk, {Qt::CTRL | Qt::SHIFT | Qt::Key_F});

    m_voice = bar->addMenu(QString());
    repeat = add(m_voice, {Qt::CTRL | Qt::Key_R});
    mute = add(m_voice, {Qt::CTRL | Qt::Key_M}, true);
    sayThis = add(m_voice, {Qt::CTRL | Qt::Key_E});
    m_language = m_voice->addMenu(QString());
    auto* oneLanguage = new QActionGroup(this);
    for (const Language& each : farol::ui::languages()) {
        languages << add(m_language, {}, true);
        languages.back()->setData(each.code);
        oneLanguage->addAction(languages.back());
    }

    m_view = bar->addMenu(QString());
    walkPage = add(m_view, {Qt::CTRL | Qt::Key_1}, true);
    mapPage = add(m_view, {Qt::CTRL | Qt::Key_2}, true);
    landmarksPage = add(m_view, {Qt::CTRL | Qt::Key_3}, true);
    auto* pages = new QActionGroup(this);
    pages->addAction(walkPage);
    pages->addAction(mapPage);
    pages->addAction(landmarksPage);
    walkPage->setChecked(true);
    m_view->addSeparator();
    fitMap = add(m_view, {Qt::CTRL | Qt::Key_0});
    zoomIn = add(m_view, {QKeySequence::ZoomIn, Qt::CTRL | Qt::Key_Equal});
    zoomOut = add(m_view, {QKeySequence::ZoomOut});
    follow = add(m_view, {Qt::CTRL | Qt::Key_F}, true);
    m_view->addSeparator();
    grid = add(m_view, {Qt::CTRL | Qt::Key_T}, true);
    rejected = add(m_view, {Qt::CTRL | Qt::Key_J}, true);
    m_view->addSeparator();
    nextPane = add(m_view, {Qt::Key_F6});
    previousPane = add(m_view, {Qt::SHIFT | Qt::Key_F6});

    m_help = bar->addMenu(QString());
    help = add(m_help, {Qt::Key_F1});
    welcome = add(m_help);
    keys = add(m_help, {Qt::SHIFT | Qt::Key_F1});
    about = add(m_help);
    quit->setMenuRole(QAction::QuitRole);
    about->setMenuRole(QAction::AboutRole);
}

void WindowActions::buildToolBar() {
    m_bar = m_window.addToolBar(QString());
    m_bar->setObjectName(QStringLiteral("main"));
    m_bar->setMovable(false);
    m_bar->setContextMenuPolicy(Qt::PreventContextMenu);
    m_bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_bar->setIconSize({20, 20});
    addGlyph(openMap, Glyph::Map);
    addGlyph(openLibrary, Glyph::Library);
    addGlyph(openSource, Glyph::Camera);
    addGlyph(step, Glyph::Step);
    addGlyph(stop, Glyph::Stop);
    addGlyph(repeat, Glyph::Repeat);
    addGlyph(record, Glyph::Record);
    addGlyph(here, Glyph::AddLandmark);
    addGlyph(wrong, Glyph::Clear);
    addGlyph(sayThis, Glyph::Sound);
    addGlyph(savePicture, Glyph::Save);
    addGlyph(fitMap, Glyph::Fit);
    addGlyph(zoomIn, Glyph::ZoomIn);
    addGlyph(zoomOut, Glyph::ZoomOut);
    addGlyph(destination, Glyph::Go);
    speed = new QComboBox(m_bar);
    for (const double factor : kSpeeds)
        speed->addItem(QStringLiteral("%1×").arg(QLocale().toString(factor)), factor);
    speed->setCurrentIndex(speed->findData(1.0));
    m_speedLabel = new QLabel(m_bar);
    m_speedLabel->setBuddy(speed);
    m_speedLabel->setContentsMargins(8, 0, 4, 0);

    m_bar->addActions({play, step, stop});
    m_bar->addWidget(m_speedLabel);
    m_bar->addWidget(speed);
    m_bar->addSeparator();
    m_bar->addActions({repeat, mute, record});
    m_bar->addSeparator();
    m_bar->addActions({here, wrong, sayThis});
    m_bar->addSeparator();
    m_bar->addActions({openMap, openLibrary, openSource});
    for (QToolButton* button : m_bar->findChildren<QToolButton*>()) button->setFocusPolicy(Qt::TabFocus);
    // The signs of these are known from everywhere; what steers the walk itself keeps its words.
    new BarWords(*m_bar,
                 {{repeat, mute, record}, {openMap, openLibrary, openSource}, {here, wrong, sayThis}});
    connect(mute, &QAction::toggled, this, &WindowActions::refreshIcons);
}

void WindowActions::refreshIcons() {
    const QPalette palette = m_window.palette();
    for (const Iconed& iconed : m_icons) iconed.action->setIcon(glyphIcon(iconed.glyph, palette));
    play->setIcon(glyphIcon(m_playing ? Glyph::Pause : Glyph::Play, palette));
    mute->setIcon(glyphIcon(mute->isChecked() ? Glyph::Mute : Glyph::Sound, palette));
}

void WindowActions::setPlaying(bool playing) {
    if (playing == m_playing) return;
    m_playing = playing;
    refreshIcons();
    retranslate();
}

void WindowActions::addPageMenu(QMenu& menu) {
    m_menuBar->insertMenu(m_view->menuAction(), &menu);
}

void WindowActions::addBesideMenus(QWidget& widget) {
    m_besideMenus->addWidget(&widget, 0, Qt::AlignBottom);
}

void WindowActions::addToFileMenu(QMenu& menu) {
    m_file->insertMenu(settings, &menu);
}

void WindowActions::addToWalkMenu(QMenu& menu) {
    m_walk->addMenu(&menu);
}

void WindowActions::showPage(Page page) {
    const bool shown = page == Page::Walk;
    m_bar->setVisible(shown);
    // Their keys belong to the page that is shown.
    for (QAction* action : {follow, grid, rejected, destination, start, noDestination, openSource, here,
                            wrong, savePicture, saveWalk}) {
        action->setEnabled(shown);
    }
    for (QAction* action : {fitMap, zoomIn, zoomOut}) action->setEnabled(page != Page::Landmarks);
    (page == Page::Walk ? walkPage : page == Page::Map ? mapPage : landmarksPage)->setChecked(true);
}

bool WindowActions::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &m_window && event->type() == QEvent::PaletteChange) refreshIcons();
    return QObject::eventFilter(watched, event);
}

QList<QAction*> WindowActions::withKeys() const {
    QList<QAction*> found;
    for (const QMenu* menu : {m_file, m_walk, m_voice, m_view, m_help})
        for (QAction* action : menu->actions())
            if (!action->shortcut().isEmpty()) found << action;
    return found;
}

void WindowActions::retranslate() {
    const auto& name = nameAction;
    m_file->setTitle(tr("&File"));
    m_walk->setTitle(tr("&Walk"));
    m_voice->setTitle(tr("V&oice"));
    m_view->setTitle(tr("&View"));
    m_help->setTitle(tr("&Help"));
    m_language->setTitle(tr("&Language"));
    recentMaps->setTitle(tr("R&ecent maps"));
    recentLibraries->setTitle(tr("Recent landmark li&braries"));
    recentSources->setTitle(tr("Recent pi&ctures"));

    name(openMap, tr("&Open map…"), tr("Map"), tr("Open the map of a building"));
    name(openLibrary, tr("Open landmark &library…"), tr("Landmarks"),
         tr("Open the landmarks that Farol was taught"));
    name(closeLibrary, tr("&Close landmark library"), tr("Close"), tr("Walk without taught landmarks"));
    name(openSource, tr("Open &pictures…"), tr("Pictures"),
         tr("Choose a camera, a video, a folder or an address"));
    name(settings, tr("&Settings…"), tr("Settings"), tr("Language, voice and what is told"));
    name(quit, tr("&Quit"), tr("Quit"), tr("Leave Farol"));

    name(play, m_playing ? tr("&Pause") : tr("&Play"), m_playing ? tr("Pause") : tr("Play"),
         m_playing ? tr("Hold the walk") : tr("Start the walk, or go on"));
    name(step, tr("&One picture"), tr("Step"), tr("Go on by one picture, then hold"));
    name(stop, tr("S&top"), tr("Stop"), tr("End the walk"));
    name(faster, tr("&Faster"), tr("Faster"), tr("Play faster"));
    name(slower, tr("&Slower"), tr("Slower"), tr("Play slower"));
    name(destination, tr("Choose &destination"), tr("Destination"), tr("Choose where to go"));
    name(noDestination, tr("&No destination"), tr("No destination"), tr("Give up the destination"));
    name(start, tr("Choose st&art"), tr("Start"), tr("Say where the walk starts"));
    name(record, tr("&Record the walk"), tr("Record"), tr("Keep the next walk in a folder, to be replayed"));

    name(here, tr("The user is &here"), tr("Here"),
         tr("The user is in the place that is chosen on the map or in the list"));
    name(wrong, tr("That is &wrong"), tr("Wrong"), tr("The place shown is wrong: look for it anew"));
    name(revote, tr("&Work out a recorded walk anew…"), tr("Anew"),
         tr("Compare a recorded walk with the same walk worked out otherwise"));
    name(figures, tr("Fi&gures…"), tr("Figures"),
         tr("Charts of the votes, of the time that pictures took, and of how far landmarks are found"));
    name(sayThis, tr("&Say this…"), tr("Say"), tr("Type a sentence that is spoken to the user"));
    name(savePicture, tr("Sa&ve the picture…"), tr("Picture"),
         tr("Save what the camera sees, with what was recognised"));
    name(saveWalk, tr("Save the walk as &table…"), tr("Table"),
         tr("Save times, places and sentences of this walk for a spreadsheet"));
    name(repeat, tr("&Repeat"), tr("Repeat"), tr("Say the last instruction again"));
    name(mute, tr("Voice o&ff"), tr("Voice off"), tr("Show sentences without speaking them"));
    for (qsizetype i = 0; i < languages.size(); ++i) {
        const QString& own = farol::ui::languages()[i].name;
        name(languages[i], own, own, own);
    }

    name(walkPage, tr("Wal&k page"), tr("Walk"), tr("Watch a walk"));
    name(mapPage, tr("&Map page"), tr("Map"), tr("Look at the map of a building, check it and change it"));
    name(landmarksPage, tr("Landmark&s page"), tr("Landmarks"),
         tr("Teach Farol landmarks, check them and change them"));
    name(fitMap, tr("&Whole floor"), tr("Whole floor"), tr("Show the whole floor"));
    name(zoomIn, tr("&Larger map"), tr("Larger"), tr("Show the map larger"));
    name(zoomOut, tr("&Smaller map"), tr("Smaller"), tr("Show the map smaller"));
    name(follow, tr("&Follow to other floors"), tr("Follow"), tr("Switch to the floor where you are"));
    name(grid, tr("&Grid over the picture"), tr("Grid"), tr("Show the nine parts of the picture"));
    name(rejected, tr("&What was not accepted"), tr("Not accepted"),
         tr("Show what was nearly recognised, and why not"));
    name(nextPane, tr("&Next part of the window"), tr("Next"), tr("Go to the next part of the window"));
    name(previousPane, tr("&Previous part of the window"), tr("Previous"),
         tr("Go to the previous part of the window"));

    name(help, tr("&Help"), tr("Help"), tr("How the page that is shown is used"));
    name(welcome, tr("&Welcome"), tr("Welcome"), tr("The page of the first start"));
    name(keys, tr("&Keys"), tr("Keys"), tr("Every key of this window"));
    name(about, tr("&About Farol"), tr("About"), tr("What Farol is"));

    m_bar->setWindowTitle(tr("Walk"));
    m_bar->setAccessibleName(tr("Walk"));
    m_speedLabel->setText(tr("&Speed:"));
    speed->setAccessibleName(tr("Speed"));
    speed->setToolTip(tr("How fast pictures from files are played"));
}

} // namespace farol::ui
