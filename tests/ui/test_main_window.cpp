// The whole window: a walk from beginning to end with made pictures, bad input, languages, keyboard and
// names.

#include "core/building/geopackage.h"
#include "tests/ui/hand_made.h"
#include "ui/convert/convert.h"
#include "ui/curation/map_actions.h"
#include "ui/curation/plan_panel.h"
#include "ui/live/frame_panel.h"
#include "ui/live/map_panel.h"
#include "ui/main_window/help_dialog.h"
#include "ui/main_window/keys_dialog.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/settings_dialog.h"
#include "ui/main_window/source_dialog.h"
#include "ui/main_window/window_actions.h"
#include "ui/parts/banner.h"
#include "ui/parts/place_chooser.h"

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAccessible>
#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSet>
#include <QSignalSpy>
#include <QSplitterHandle>
#include <QTabBar>
#include <QTabWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBrowser>

namespace farol::ui {

class MainWindowTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanup();
    void aWalkRunsToItsEndAndAgain();
    void aWalkIsRecorded();
    void pausingAndStepping();
    void closingWhileAWalkRuns();
    void closingWhileLoading();
    void aMissingMapIsTold();
    void aSourceThatCannotBeOpenedIsTold();
    void anUnpluggedCameraIsTold();
    void anUnknownDestinationIsTold();
    void playWithoutAnythingSaysWhatIsMissing();
    void everyControlHasAName();
    void everyCommandHasWordsInBothLanguages();
    void keysAreNamedInTheUsersLanguage_data();
    void keysAreNamedInTheUsersLanguage();
    void tabGoesRound();
    void dialogsHaveNames();
    void theVoiceIsTurnedOff();
    void theMapPageHasNames();
    void tabGoesRoundTheMapPage();
    void keysBelongToThePageThatIsShown();
    void closingAsksForUnsavedChanges();
    void helpShowsThePages();

private:
    void showMapPage();
    StartOptions options() const;
    QString banner(Problem kind) const;
    void make(std::uint64_t frames = 4, double period = 0.05);

    QTemporaryDir m_folder;
    QString m_map;
    std::unique_ptr<Settings> m_settings;
    std::unique_ptr<MainWindow> m_window;
};

void MainWindowTest::initTestCase() {
    m_map = m_folder.filePath(QStringLiteral("house.gpkg"));
    QVERIFY(building::saveBuilding(*test::handMadeBuilding(), toUtf8(m_map)).ok());
}

void MainWindowTest::init() {
    QFile::remove(m_folder.filePath(QStringLiteral("settings.ini")));
    m_settings = std::make_unique<Settings>(m_folder.filePath(QStringLiteral("settings.ini")));
    m_settings->setLanguage(QStringLiteral("en"));
    MainWindow::applyLanguage(*m_settings);
    make();
}

void MainWindowTest::cleanup() {
    m_window.reset();
    m_settings.reset();
}

void MainWindowTest::make(std::uint64_t frames, double period) {
    m_window.reset();
    const auto open =
        [frames, period](const std::string& name,
                         const capture::SourceOptions&) -> Result<std::unique_ptr<capture::FrameSource>> {
        if (name == "broken") return Error{ErrorCode::Unavailable, "there is no such camera", name};
        return std::unique_ptr<capture::FrameSource>(std::make_unique<test::FakeSource>(frames, period));
    };
    m_window = std::make_unique<MainWindow>(
        *m_settings, open, [](const VoiceChoice&) { return std::make_unique<test::FakeVoice>(); });
}

StartOptions MainWindowTest::options() const {
    StartOptions start;
    start.map = m_map;
    start.source = QStringLiteral("grey");
    start.to = QStringLiteral("Library");
    start.banner = QStringLiteral("Test example");
    start.play = true;
    return start;
}

QString MainWindowTest::banner(Problem kind) const {
    return m_window->page().banners().text(QStringLiteral("problem-%1").arg(static_cast<int>(kind)));
}

void MainWindowTest::aWalkRunsToItsEndAndAgain() {
    Walk& walk = m_window->walk();
    QSignalSpy began(&walk, &Walk::walkBegan);
    m_window->begin(options()); // plays as soon as the map is there
    QTRY_COMPARE_WITH_TIMEOUT(walk.state(), session::RunState::Ended, 60000);
    QVERIFY(m_window->page().framesShown() > 0);
    QCOMPARE(walk.destination(), RegionId("lib"));
    BannerStack& banners = m_window->page().banners();
    QVERIFY(banners.shows(QStringLiteral("ended")));
    QCOMPARE(banners.text(QStringLiteral("example")), QStringLiteral("Test example"));
    QVERIFY(m_window->windowTitle().contains(QLatin1String("Hand-made house")));
    QCOMPARE(m_settings->recent(RecentKind::Map), QStringList{m_map});
    m_window->actions().play->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(began.count(), 2, 60000);
    QVERIFY(!banners.shows(QStringLiteral("ended")));
    QTRY_COMPARE_WITH_TIMEOUT(walk.state(), session::RunState::Ended, 60000);
}

void MainWindowTest::aWalkIsRecorded() {
    const QString folder = m_folder.filePath(QStringLiteral("recordings/deep"));
    m_settings->setRecordingFolder(folder);
    m_window->actions().record->setChecked(true);
    m_window->begin(options());
    QTRY_COMPARE_WITH_TIMEOUT(m_window->walk().state(), session::RunState::Ended, 60000);
    const QStringList walks = QDir(folder).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
    QCOMPARE(walks.size(), 1);
    const auto recording = session::loadRecording(toUtf8(QDir(folder).filePath(walks.first())));
    QVERIFY(recording.ok());
    QVERIFY(!recording->entries.empty());
    m_window->actions().record->setChecked(false);
    m_window->actions().play->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(m_window->walk().state(), session::RunState::Running, 60000);
    QTRY_COMPARE_WITH_TIMEOUT(m_window->walk().state(), session::RunState::Ended, 60000);
    QCOMPARE(QDir(folder).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size(), 1);
}

void MainWindowTest::pausingAndStepping() {
    make(1000, 0.05);
    StartOptions start = options();
    start.play = false;
    m_window->begin(start);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->walk().building() && !m_window->walk().loading(), 60000);
    m_window->actions().step->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(m_window->page().framesShown(), 1, 60000);
    QCOMPARE(m_window->walk().state(), session::RunState::Paused);
    m_window->actions().step->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(m_window->page().framesShown(), 2, 60000);
    m_window->actions().play->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(m_window->walk().state(), session::RunState::Running, 60000);
    m_window->actions().play->trigger(); // it is the pause key now
    QTRY_COMPARE_WITH_TIMEOUT(m_window->walk().state(), session::RunState::Paused, 60000);
    m_window->actions().stop->trigger();
    QCOMPARE(m_window->walk().state(), session::RunState::Idle);
    QVERIFY(!m_window->walk().active());
}

void MainWindowTest::closingWhileAWalkRuns() {
    make(1000, 0.02);
    m_window->show();
    m_window->begin(options());
    QTRY_VERIFY_WITH_TIMEOUT(m_window->page().framesShown() > 0, 60000);
    QVERIFY(m_window->close());
    m_window.reset(); // waits for the session; nothing of it arrives any more
    QCoreApplication::processEvents();
}

void MainWindowTest::closingWhileLoading() {
    for (int i = 0; i < 5; ++i) {
        make();
        m_window->begin(options());
        m_window.reset();
        QCoreApplication::processEvents();
    }
}

void MainWindowTest::aMissingMapIsTold() {
    StartOptions start = options();
    start.map = m_folder.filePath(QStringLiteral("absent.gpkg"));
    m_window->begin(start);
    QTRY_VERIFY_WITH_TIMEOUT(banner(Problem::Map).contains(QLatin1String("absent.gpkg")), 60000);
    QVERIFY(!m_window->walk().active());
    m_window->walk().loadMap(m_map); // the message goes once a map is there
    QTRY_VERIFY_WITH_TIMEOUT(m_window->walk().building() != nullptr, 60000);
    QVERIFY(banner(Problem::Map).isEmpty());
}

void MainWindowTest::aSourceThatCannotBeOpenedIsTold() {
    StartOptions start = options();
    start.source = QStringLiteral("broken");
    m_window->begin(start);
    QTRY_VERIFY_WITH_TIMEOUT(banner(Problem::Source).contains(QLatin1String("no such camera")), 60000);
    QCOMPARE(m_window->walk().state(), session::RunState::Failed);
    m_window->walk().setSource({QStringLiteral("grey"), 0.0});
    QVERIFY(banner(Problem::Source).isEmpty());
}

void MainWindowTest::anUnpluggedCameraIsTold() {
    const auto cable = std::make_shared<test::Cable>();
    m_window = std::make_unique<MainWindow>(
        *m_settings,
        [cable](const std::string&,
                const capture::SourceOptions&) -> Result<std::unique_ptr<capture::FrameSource>> {
            return std::unique_ptr<capture::FrameSource>(std::make_unique<test::CameraOnCable>(cable));
        },
        [](const VoiceChoice&) { return std::make_unique<test::FakeVoice>(); });
    QStringList told;
    connect(&m_window->walk(), &Walk::cueCame, this, [&](const guidance::Cue& cue) {
        if (cue.kind == guidance::CueKind::Warning) told << Phrasebook().sentence(cue);
    });
    m_window->begin(options());
    QTRY_VERIFY_WITH_TIMEOUT(m_window->walk().snapshot() != nullptr, 60000);
    const auto remark = [&] { return m_window->page().banners().text(QStringLiteral("remark")); };
    cable->setPlugged(false);
    QTRY_VERIFY_WITH_TIMEOUT(remark().contains(QLatin1String("gives no more pictures")), 60000);
    QTRY_COMPARE_WITH_TIMEOUT(told.size(), 1, 60000);
    QVERIFY(told.last().contains(QLatin1String("The camera gives no picture")));
    cable->setPlugged(true);
    QTRY_VERIFY_WITH_TIMEOUT(remark().contains(QLatin1String("is back")), 60000);
    QTRY_COMPARE_WITH_TIMEOUT(told.size(), 2, 60000);
    QCOMPARE(m_window->walk().state(), session::RunState::Running);
    cable->pull();
    QTRY_COMPARE_WITH_TIMEOUT(m_window->walk().state(), session::RunState::Failed, 60000);
    QTRY_COMPARE_WITH_TIMEOUT(told.size(), 3, 60000);
    QVERIFY(!remark().isEmpty());
}

void MainWindowTest::anUnknownDestinationIsTold() {
    StartOptions start = options();
    start.to = QStringLiteral("swimming pool");
    start.play = false;
    m_window->begin(start);
    QTRY_VERIFY_WITH_TIMEOUT(banner(Problem::Session).contains(QLatin1String("swimming pool")), 60000);
    QVERIFY(!m_window->walk().destination());
}

void MainWindowTest::playWithoutAnythingSaysWhatIsMissing() {
    m_window->actions().play->trigger();
    QVERIFY(!banner(Problem::Session).isEmpty());
    QVERIFY(!m_window->walk().active());
}

// Parts that Qt makes inside its own widgets and that the outer widget speaks for.
static bool isInner(const QWidget* widget) {
    if (widget->objectName().startsWith(QLatin1String("qt_"))) return true;
    if (qobject_cast<const QScrollBar*>(widget) || qobject_cast<const QSplitterHandle*>(widget)) return true;
    for (const QWidget* up = widget->parentWidget(); up; up = up->parentWidget())
        if (qobject_cast<const QLineEdit*>(up) || qobject_cast<const QComboBox*>(up) ||
            qobject_cast<const QMenuBar*>(up) || qobject_cast<const QTabBar*>(up) ||
            qobject_cast<const QAbstractScrollArea*>(up))
            return true;
    return qobject_cast<const QMenuBar*>(widget);
}

static QStringList nameless(const QWidget& root) {
    QStringList missing;
    for (const QWidget* widget : root.findChildren<QWidget*>()) {
        const bool acts =
            widget->focusPolicy() != Qt::NoFocus || qobject_cast<const QAbstractButton*>(widget);
        if (!acts || isInner(widget) || !widget->isVisibleTo(&root)) continue;
        QAccessibleInterface* accessible =
            QAccessible::queryAccessibleInterface(const_cast<QWidget*>(widget));
        if (!accessible || accessible->text(QAccessible::Name).trimmed().isEmpty())
            missing << QStringLiteral("%1 %2").arg(QLatin1String(widget->metaObject()->className()),
                                                   widget->objectName());
        else if (widget->toolTip().isEmpty() && root.isWindow() && root.inherits("QMainWindow") &&
                 !qobject_cast<const QTabBar*>(widget))
            missing << QStringLiteral("no tool tip: %1").arg(accessible->text(QAccessible::Name));
    }
    return missing;
}

void MainWindowTest::everyControlHasAName() {
    m_window->begin(options());
    QTRY_COMPARE_WITH_TIMEOUT(m_window->walk().state(), session::RunState::Ended,
                              60000); // with all its banners
    QCOMPARE(nameless(*m_window).join(QStringLiteral(", ")), QString());
}

void MainWindowTest::everyCommandHasWordsInBothLanguages() {
    const auto texts = [this] {
        QStringList all;
        for (const QAction* action : m_window->findChildren<QAction*>())
            if (action->parent() == m_window.get() && !action->isSeparator())
                all << action->text() << action->toolTip();
        return all;
    };
    const QStringList english = texts();
    QVERIFY(english.size() > 50);
    for (const QString& text : english) QVERIFY(!text.isEmpty());
    QSet<QString> keys;
    for (const QAction* action : m_window->actions().withKeys()) {
        const QString key = action->shortcut().toString();
        QVERIFY2(!keys.contains(key), qPrintable(key));
        keys << key;
    }
    m_settings->setLanguage(QStringLiteral("pt"));
    QTRY_VERIFY(m_window->actions().quit->text() != english[english.indexOf(QStringLiteral("&Quit"))]);
    const QStringList portuguese = texts();
    QCOMPARE(portuguese.size(), english.size());
    for (const QString& text : portuguese) QVERIFY(!text.isEmpty());
    m_settings->setLanguage(QStringLiteral("en"));
    QTRY_COMPARE(texts(), english);
}

/// As they stand on the keyboard, also where Qt's own translations are not installed.
void MainWindowTest::keysAreNamedInTheUsersLanguage_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("shifted");
    QTest::addColumn<QString>("up");
    QTest::addColumn<QString>("erase");
    const auto row = [](const char* language, const char* shifted, const char* up, const char* erase) {
        QTest::newRow(language) << QString::fromLatin1(language) << QString::fromUtf8(shifted)
                                << QString::fromUtf8(up) << QString::fromUtf8(erase);
    };
    row("en", "Ctrl+Shift+P", "Ctrl+Up", "Del");
    row("pt", "Ctrl+Shift+P", "Ctrl+Seta para cima", "Delete");
    row("es", "Ctrl+Mayús+P", "Ctrl+Flecha arriba", "Supr");
    row("fr", "Ctrl+Maj+P", "Ctrl+Haut", "Suppr");
    row("de", "Strg+Umschalt+P", "Strg+Pfeil hoch", "Entf");
}

void MainWindowTest::keysAreNamedInTheUsersLanguage() {
    QFETCH(QString, language);
    QFETCH(QString, shifted);
    QFETCH(QString, up);
    QFETCH(QString, erase);
    m_settings->setLanguage(language);
    QTRY_COMPARE(installedLanguage(), language);
    const auto told = [](const QKeySequence& keys) { return keys.toString(QKeySequence::NativeText); };
    QCOMPARE(told(Qt::CTRL | Qt::SHIFT | Qt::Key_P), shifted);
    QCOMPARE(told(Qt::CTRL | Qt::Key_Up), up);
    QCOMPARE(told(Qt::Key_Delete), erase);
    const KeysDialog dialog(m_window->actions().withKeys());
    const auto* table = dialog.findChild<QTableWidget*>();
    QStringList keys;
    for (int i = 0; i < table->rowCount(); ++i) keys << table->item(i, 0)->text();
    QVERIFY2(keys.contains(shifted), qPrintable(keys.join(QLatin1Char(' '))));
    if (language == QLatin1String("de"))
        QVERIFY2(keys.filter(QStringLiteral("Ctrl")).isEmpty(), qPrintable(keys.join(QLatin1Char(' '))));
}

void MainWindowTest::tabGoesRound() {
    m_window->begin(options());
    QTRY_COMPARE_WITH_TIMEOUT(m_window->walk().state(), session::RunState::Ended, 60000);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    QWidget* first = &m_window->page().destination().edit();
    first->setFocus();
    QSet<QWidget*> visited;
    for (int i = 0; i < 80; ++i) {
        QWidget* focus = QApplication::focusWidget();
        QVERIFY(focus);
        if (i > 0 && focus == first) break;
        QVERIFY2(!visited.contains(focus),
                 focus->metaObject()->className()); // no circle that leaves others out
        visited << focus;
        QTest::keyClick(focus, Qt::Key_Tab);
    }
    QCOMPARE(QApplication::focusWidget(), first);
    QVERIFY(visited.contains(&m_window->page().startPlace().edit()));
    QVERIFY(visited.contains(&m_window->page().framePanel().view()));
    QVERIFY(visited.contains(&m_window->page().mapPanel().view()));
    for (QWidget* table : m_window->page().tables()) QVERIFY(visited.contains(table));
    QVERIFY(visited.contains(m_window->actions().speed));
    m_window->actions().nextPane->trigger();
    QVERIFY(QApplication::focusWidget() != first);
}

void MainWindowTest::dialogsHaveNames() {
    SettingsDialog settings(*m_settings);
    QCOMPARE(nameless(settings), QStringList());
    SourceDialog source({QStringLiteral("camera:2"), 0.0});
    QCOMPARE(nameless(source), QStringList());
    QCOMPARE(source.source().name, QStringLiteral("camera:2"));
    SourceDialog folder({m_folder.path(), 4.0});
    QCOMPARE(folder.source().name, m_folder.path());
    QCOMPARE(folder.source().framesPerSecond, 4.0);
    SourceDialog address({QStringLiteral("rtsp://camera.example/1"), 0.0});
    QCOMPARE(address.source().name, QStringLiteral("rtsp://camera.example/1"));
}

void MainWindowTest::theVoiceIsTurnedOff() {
    m_window->actions().mute->setChecked(true);
    QVERIFY(m_settings->muted());
    m_settings->setMuted(false);
    QVERIFY(!m_window->actions().mute->isChecked());
}

void MainWindowTest::showMapPage() {
    StartOptions start;
    start.edit = m_map;
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    m_window->begin(start);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->mapPage().document().building() != nullptr, 60000);
    QVERIFY(m_window->showsMap());
}

void MainWindowTest::theMapPageHasNames() {
    showMapPage();
    for (const Language& language : languages()) {
        m_settings->setLanguage(language.code);
        for (int tab = 0; tab < m_window->mapPage().tabs().count(); ++tab) {
            m_window->mapPage().tabs().setCurrentIndex(tab);
            QCOMPARE(nameless(*m_window).join(QStringLiteral(", ")), QString());
        }
        QSet<QString> keys;
        for (const QAction* action : m_window->mapPage().actions().withKeys()) {
            const QString key = action->shortcut().toString();
            QVERIFY2(!keys.contains(key), qPrintable(key));
            keys << key;
            QVERIFY(!action->text().isEmpty() && !action->toolTip().isEmpty());
        }
    }
    m_settings->setLanguage(QStringLiteral("en"));
    QVERIFY(m_window->windowTitle().contains(QLatin1String("Hand-made house")));
}

void MainWindowTest::tabGoesRoundTheMapPage() {
    showMapPage();
    for (int tab = 0; tab < m_window->mapPage().tabs().count(); ++tab) {
        m_window->mapPage().tabs().setCurrentIndex(tab);
        QWidget* first = &m_window->mapPage().plan().view();
        first->setFocus();
        QSet<QWidget*> visited;
        for (int i = 0; i < 80; ++i) {
            QWidget* focus = QApplication::focusWidget();
            QVERIFY(focus);
            if (i > 0 && focus == first) break;
            QVERIFY2(!visited.contains(focus), focus->metaObject()->className());
            visited << focus;
            QTest::keyClick(focus, Qt::Key_Tab);
        }
        QCOMPARE(QApplication::focusWidget(), first);
        QVERIFY(visited.contains(m_window->mapPage().tabs().tabBar()));
        for (QWidget* pane : m_window->mapPage().panes()) QVERIFY(visited.contains(pane));
    }
    m_window->actions().nextPane->trigger();
    QVERIFY(QApplication::focusWidget() != &m_window->mapPage().plan().view());
}

void MainWindowTest::keysBelongToThePageThatIsShown() {
    showMapPage();
    MapView& plan = m_window->mapPage().plan().view();
    plan.setFocus();
    const double before = plan.viewTransform().pixelsPerMetre();
    QTest::keyClick(&plan, Qt::Key_Plus, Qt::ControlModifier);
    QVERIFY(plan.viewTransform().pixelsPerMetre() > before);
    QTest::keyClick(&plan, Qt::Key_F, Qt::ControlModifier); // the table's search, not following
    QVERIFY(qobject_cast<QLineEdit*>(QApplication::focusWidget()));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_1, Qt::ControlModifier);
    QVERIFY(!m_window->showsMap());
    QVERIFY(m_window->actions().follow->isEnabled());
    QTest::keyClick(m_window.get(), Qt::Key_2, Qt::ControlModifier);
    QVERIFY(m_window->showsMap());
    QCOMPARE(QApplication::focusWidget(), &plan);
}

void MainWindowTest::closingAsksForUnsavedChanges() {
    showMapPage();
    MapPage& page = m_window->mapPage();
    page.plan().view().select(MapHit{MapHit::What::Landmark, 0}, true);
    QTest::keyClick(&page.plan().view(), Qt::Key_Delete);
    QVERIFY(m_window->isWindowModified());
    QVERIFY(!m_window->close());
    const auto question = [] { return qobject_cast<QMessageBox*>(QApplication::activeModalWidget()); };
    QTRY_VERIFY(question());
    QTest::keyClick(question(), Qt::Key_Escape);
    QTRY_VERIFY(!question());
    QVERIFY(m_window->isVisible());
    QVERIFY(!m_window->close());
    QTRY_VERIFY(question());
    QTest::mouseClick(question()->button(QMessageBox::Discard), Qt::LeftButton);
    QTRY_VERIFY(!m_window->isVisible());
}

/// Also those that have not been shown yet, each with the numbers and names of its parts.
void MainWindowTest::helpShowsThePages() {
    m_window->actions().help->trigger();
    auto* help = m_window->findChild<HelpDialog*>();
    QVERIFY(help != nullptr);
    const QStringList parts[]{{QStringLiteral("Camera picture"), QStringLiteral("Floor map"),
                               QStringLiteral("What was said"), QStringLiteral("Timeline")},
                              {QStringLiteral("Plan"), QStringLiteral("Attributes")},
                              {QStringLiteral("Landmarks of the library")}};
    for (int chapter = 0; chapter < 3; ++chapter) {
        help->chapters().setCurrentRow(chapter);
        const QString text = help->text().replace(QChar::Nbsp, QLatin1Char(' '));
        for (const QString& part : parts[chapter])
            QVERIFY2(text.contains(QRegularExpression(QStringLiteral("\\d ") + part)),
                     qPrintable(part + text));
        const QVariant picture = help->findChild<QTextBrowser*>()->document()->resource(
            QTextDocument::ImageResource, QUrl(QStringLiteral("page:%1").arg(chapter)));
        QVERIFY(picture.value<QPixmap>().height() > 200);
    }
    help->chapters().setCurrentRow(3);
    QVERIFY(help->text().contains(QRegularExpression(QStringLiteral("Space\\s+say again"))));
    m_settings->setLanguage(QStringLiteral("pt"));
    MainWindow::applyLanguage(*m_settings);
    QTRY_VERIFY(help->text().contains(QRegularExpression(QStringLiteral("Espaço\\s+dizer outra vez"))));
    QCOMPARE(help->chapters().item(0)->text(), QStringLiteral("Página do percurso"));
}

} // namespace farol::ui

QTEST_MAIN(farol::ui::MainWindowTest)
#include "test_main_window.moc"
