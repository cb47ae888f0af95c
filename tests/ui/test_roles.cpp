// The demonstrator's job from its start to its end, by keys and the mouse on the window that is shown, in
// English and in Portuguese.

#include "core/building/geopackage.h"
#include "tests/ui/hand_made.h"
#include "ui/convert/convert.h"
#include "ui/main_window/main_window.h"
#include "ui/parts/place_chooser.h"

#include <QAbstractItemView>
#include <QAction>
#include <QCompleter>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>
#include <QToolBar>
#include <QToolButton>

namespace farol::ui {

namespace {

constexpr int kPatience = 60000;

} // namespace

class RolesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();
    void theDemonstrator_data() { languagesOfTheWindow(); }
    void theDemonstrator();

private:
    static void languagesOfTheWindow();
    void begin();
    void key(int key, Qt::KeyboardModifiers modifiers = {});
    void click(QAction* action);
    void press(QAbstractButton* button);
    void typeInto(QWidget* field, const QString& text);
    void choosePlace(PlaceChooser& chooser, const QString& name);
    QString file(const char* name) const { return m_folder->filePath(QLatin1String(name)); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Settings> m_settings;
    std::unique_ptr<MainWindow> m_window;
};

void RolesTest::languagesOfTheWindow() {
    QTest::addColumn<QString>("language");
    QTest::newRow("English") << QStringLiteral("en");
    QTest::newRow("Portuguese") << QStringLiteral("pt");
}

void RolesTest::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    m_settings = std::make_unique<Settings>(file("settings.ini"));
    m_settings->setRecordingFolder(m_folder->path());
}

void RolesTest::cleanup() {
    m_window.reset();
    m_settings.reset();
    m_folder.reset();
}

void RolesTest::begin() {
    QFETCH(QString, language);
    m_settings->setLanguage(language);
    MainWindow::applyLanguage(*m_settings);
    m_window = std::make_unique<MainWindow>(*m_settings, Walk::OpenSource(), [](const VoiceChoice&) {
        return std::make_unique<test::FakeVoice>();
    });
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
}

void RolesTest::key(int key, Qt::KeyboardModifiers modifiers) {
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    QTest::keyClick(m_window->focusWidget() ? m_window->focusWidget() : m_window.get(),
                    static_cast<Qt::Key>(key), modifiers);
}

/// With the mouse, on the button of a tool bar.
void RolesTest::click(QAction* action) {
    for (QToolButton* button : m_window->findChildren<QToolButton*>())
        if (button->defaultAction() == action && button->isVisible()) return press(button);
    QFAIL(qPrintable(action->text()));
}

void RolesTest::press(QAbstractButton* button) {
    QTRY_VERIFY2_WITH_TIMEOUT(button->isVisible() && button->isEnabled(), qPrintable(button->text()),
                              kPatience);
    QTest::mouseClick(button, Qt::LeftButton);
}

void RolesTest::typeInto(QWidget* field, const QString& text) {
    QVERIFY(field);
    QTest::mouseClick(field, Qt::LeftButton);
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, text);
}

void RolesTest::choosePlace(PlaceChooser& chooser, const QString& name) {
    typeInto(&chooser.edit(), name);
    chooser.edit().completer()->popup()->hide();
    QTest::keyClick(&chooser.edit(), Qt::Key_Return);
}

/// The simulated visitor comes; another destination, a wrong turn, a covered camera, the next visitor.
void RolesTest::theDemonstrator() {
    QVERIFY(building::saveBuilding(*test::handMadeBuilding(), toUtf8(file("house.gpkg"))).ok());
    begin();
    StartOptions start; // as the demonstration's icon starts it
    start.map = file("house.gpkg");
    start.source = QStringLiteral("sim:Café");
    start.play = true;
    m_window->begin(start);
    LivePage& page = m_window->page();
    const Demo& demo = m_window->demo();
    QTRY_VERIFY_WITH_TIMEOUT(page.framesShown() > 1, kPatience);
    QCOMPARE(demo.visitor(), 1);
    choosePlace(page.destination(), QStringLiteral("Library"));
    QTRY_VERIFY_WITH_TIMEOUT(demo.visit() && demo.visit()->to == RegionId("lib"), kPatience);
    QCOMPARE(demo.visitor(), 1); // the same one goes elsewhere
    auto* bar = m_window->findChild<QToolBar*>(QStringLiteral("demo"));
    const QList<QAction*> actions = bar->actions(); // wrong turn, cover, lights, next visitor
    click(actions[0]);
    click(actions[1]);
    QVERIFY(demo.covered());
    const int before = page.framesShown();
    QTRY_VERIFY_WITH_TIMEOUT(page.framesShown() > before + 1, kPatience); // it goes on, seeing nothing
    click(actions[1]);
    QVERIFY(!demo.covered());
    key(Qt::Key_F9);
    QTRY_COMPARE(demo.visitor(), 2);
    QTRY_COMPARE_WITH_TIMEOUT(m_window->walk().state(), session::RunState::Running, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(page.framesShown() > 1, kPatience);
}

} // namespace farol::ui

QTEST_MAIN(farol::ui::RolesTest)
#include "test_roles.moc"
