// Simulated visitors in the window: they come by themselves, obey, and do what the keys say.

#include "core/building/geopackage.h"
#include "tests/ui/hand_made.h"
#include "ui/convert/convert.h"
#include "ui/demo/demo_bar.h"
#include "ui/live/map_panel.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/window_actions.h"
#include "ui/parts/banner.h"
#include "ui/parts/place_chooser.h"

#include <QAction>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QToolBar>

namespace farol::ui {

class DemoTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanup();
    void aVisitorComesAndAnotherAfterwards();
    void anotherDestinationIsGoneTo();
    void theKeysAreThereOnlyForSimulatedWalks();
    void aStartThatIsNotInTheMapIsTold();

private:
    void begin(const QString& source);
    QTemporaryDir m_folder;
    QString m_map;
    std::unique_ptr<Settings> m_settings;
    std::unique_ptr<MainWindow> m_window;
};

void DemoTest::initTestCase() {
    m_map = m_folder.filePath(QStringLiteral("house.gpkg"));
    QVERIFY(building::saveBuilding(*test::handMadeBuilding(), toUtf8(m_map)).ok());
}

void DemoTest::init() {
    m_settings = std::make_unique<Settings>(m_folder.filePath(QStringLiteral("settings.ini")));
    m_settings->setLanguage(QStringLiteral("en"));
    MainWindow::applyLanguage(*m_settings);
    m_window = std::make_unique<MainWindow>(*m_settings, Walk::OpenSource(), [](const VoiceChoice&) {
        return std::make_unique<test::FakeVoice>();
    });
}

void DemoTest::cleanup() {
    m_window.reset();
    m_settings.reset();
}

void DemoTest::begin(const QString& source) {
    StartOptions start;
    start.map = m_map;
    start.source = source;
    start.play = true;
    m_window->begin(start);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get())); // else keys are nobody's
}

void DemoTest::aVisitorComesAndAnotherAfterwards() {
    begin(QStringLiteral("sim:"));
    const Demo& demo = m_window->demo();
    QTRY_VERIFY_WITH_TIMEOUT(m_window->page().framesShown() > 3, 60000);
    QCOMPARE(m_window->walk().localiser(), QStringLiteral("bayes-guided"));
    QVERIFY(demo.visit());
    QCOMPARE(m_window->walk().start(), std::optional(demo.visit()->from));
    QCOMPARE(m_window->walk().destination(), std::optional(demo.visit()->to));
    QVERIFY(!m_window->page().destination().edit().text().isEmpty());
    QVERIFY(demo.truth());
    QVERIFY(m_window->page().mapPanel().view().overlay().truth);
    const QString first = m_window->page().banners().text(QStringLiteral("demo"));
    QVERIFY2(first.contains(QStringLiteral("Visitor 1")), qPrintable(first));
    QTest::keyClick(m_window.get(), Qt::Key_F9);
    QCOMPARE(demo.visitor(), 2);
    QTRY_COMPARE_WITH_TIMEOUT(m_window->walk().state(), session::RunState::Running, 60000);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->page().framesShown() > 1, 60000);
    QVERIFY(m_window->page().banners().text(QStringLiteral("demo")).contains(QStringLiteral("Visitor 2")));
    // The simulation is no camera that one would open again some day.
    QVERIFY(m_settings->recent(RecentKind::Source).isEmpty());
}

void DemoTest::anotherDestinationIsGoneTo() {
    begin(QStringLiteral("sim:Café"));
    QTRY_VERIFY_WITH_TIMEOUT(m_window->page().framesShown() > 1, 60000);
    const Demo& demo = m_window->demo();
    QVERIFY(demo.visit());
    const RegionId cafe = demo.visit()->from;
    const RegionId other = demo.visit()->to == RegionId("r1") ? RegionId("lib") : RegionId("r1");
    m_window->walk().setDestination(other);
    QCOMPARE(demo.visit()->to, other);
    QCOMPARE(demo.visit()->from, cafe);
    QCOMPARE(demo.visitor(), 1);
    QCOMPARE(m_window->walk().state(), session::RunState::Running);
    // Elsewhere one can only start anew.
    m_window->walk().setStart(demo.visit()->to);
    QTRY_VERIFY_WITH_TIMEOUT(demo.truth() && demo.truth()->region == other, 60000);
}

void DemoTest::theKeysAreThereOnlyForSimulatedWalks() {
    auto* bar = m_window->findChild<QToolBar*>(QStringLiteral("demo"));
    QVERIFY(bar);
    const QList<QAction*> keys = bar->actions();
    QCOMPARE(keys.size(), 4);
    QVERIFY(bar->isHidden());
    for (const QAction* key : keys) QVERIFY(!key->isEnabled());
    begin(QStringLiteral("sim:Café"));
    QTRY_VERIFY_WITH_TIMEOUT(m_window->page().framesShown() > 1, 60000);
    QVERIFY(!bar->isHidden());
    for (const QAction* key : keys) {
        QVERIFY(key->isEnabled());
        QVERIFY(!key->shortcut().isEmpty());
        QVERIFY(!key->toolTip().isEmpty());
    }
    QTest::keyClick(m_window.get(), Qt::Key_F3);
    QVERIFY(m_window->demo().covered());
    QTest::keyClick(m_window.get(), Qt::Key_F4);
    QVERIFY(m_window->demo().lightsOut());
    QTest::keyClick(m_window.get(), Qt::Key_F2);
    QTest::keyClick(m_window.get(), Qt::Key_F3);
    QVERIFY(!m_window->demo().covered());
    m_window->showMap(true);
    QVERIFY(bar->isHidden());
    for (const QAction* key : keys) QVERIFY(!key->isEnabled());
    m_window->showMap(false);
    m_window->walk().setSource({QStringLiteral("camera:63"), 0.0});
    QVERIFY(bar->isHidden());
    QVERIFY(!m_window->page().banners().shows(QStringLiteral("demo")));
}

void DemoTest::aStartThatIsNotInTheMapIsTold() {
    begin(QStringLiteral("sim:Nowhere"));
    QTRY_COMPARE_WITH_TIMEOUT(m_window->walk().state(), session::RunState::Failed, 60000);
    const QString told =
        m_window->page().banners().text(QStringLiteral("problem-%1").arg(static_cast<int>(Problem::Source)));
    QVERIFY2(told.contains(QStringLiteral("could start")), qPrintable(told));
}

} // namespace farol::ui

QTEST_MAIN(farol::ui::DemoTest)
#include "test_demo.moc"
