// Each role's job from its start to its result, by keys and the mouse on the window that is shown, in English
// and in Portuguese. The blind user's is in the tests of the kiosk.

#include "core/building/geopackage.h"
#include "core/recognition/landmark_library.h"
#include "tests/recognition/drawn_pictures.h"
#include "tests/ui/hand_made.h"
#include "tests/ui/role_hands.h"
#include "ui/convert/convert.h"
#include "ui/curation/feature_dialogs.h"
#include "ui/curation/import_dialog.h"
#include "ui/curation/map_actions.h"
#include "ui/curation/plan_panel.h"
#include "ui/curation/report_panel.h"
#include "ui/live/map_panel.h"
#include "ui/live/revote_dialog.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/source_dialog.h"
#include "ui/parts/banner.h"
#include "ui/training/library_panel.h"
#include "ui/training/outline_view.h"
#include "ui/training/teach_try.h"
#include "ui/training/teach_views.h"
#include "ui/training/teach_what.h"

#include <QAction>
#include <QDir>
#include <QFile>
#include <QInputDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolBar>

#include <algorithm>

namespace farol::ui {

namespace {

namespace drawn = recognition::test;
using test::Hands;
using test::kPatience;

/// A wall with the poster of the seed on it; without one where the seed is 0.
cv::Mat wall(std::uint64_t room, std::uint64_t poster, const Quad& at) {
    cv::Mat picture = drawn::room(room);
    if (poster > 0) drawn::hang(picture, drawn::poster(poster), at);
    return picture;
}

bool save(const cv::Mat& picture, const QString& name) {
    QFile file(name);
    const QByteArray bytes = QByteArray::fromStdString(drawn::jpeg(picture));
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
}

/// Two rooms side by side, as they come from elsewhere: no door, no level's name.
const char* const kRooms = R"({"type":"FeatureCollection","features":[
  {"type":"Feature","properties":{"id":"k","name":"Kitchen","level":"0","indoor":"room"},"geometry":
   {"type":"Polygon","coordinates":[[[-7.9,37.0],[-7.8999,37.0],[-7.8999,37.0001],[-7.9,37.0001],[-7.9,37.0]]]}},
  {"type":"Feature","properties":{"id":"p","name":"Pantry","level":"0","indoor":"room"},"geometry":
   {"type":"Polygon","coordinates":[[[-7.8999,37.0],[-7.8998,37.0],[-7.8998,37.0001],[-7.8999,37.0001],[-7.8999,37.0]]]}}]})";

} // namespace

class RolesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();
    void theAssistant_data() { languagesOfTheWindow(); }
    void theAssistant();
    void theMapCurator_data() { languagesOfTheWindow(); }
    void theMapCurator();
    void theLandmarkCurator_data() { languagesOfTheWindow(); }
    void theLandmarkCurator();
    void theDemonstrator_data() { languagesOfTheWindow(); }
    void theDemonstrator();

private:
    static void languagesOfTheWindow();
    void begin();
    QString file(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    std::shared_ptr<const building::Building> map() { return m_window->mapPage().document().building(); }
    Point2 middleOf(std::size_t region);

    void makeWalk();
    void openWalk();
    void correctAndSpeak();
    void exportWalk();
    void workOutAnew();

    void importRooms();
    void nameAndJoinRooms();
    void putUpAndMove();
    void saveAndPrint();

    void makePosters();
    void teachView();
    void teach();
    void tryAndSave();
    void placeOnMap();

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Settings> m_settings;
    std::unique_ptr<MainWindow> m_window;
    std::unique_ptr<Hands> m_hands;
};

/// With a few words that must be seen in the language.
void RolesTest::languagesOfTheWindow() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("corrected");
    QTest::addColumn<QString>("found");
    QTest::newRow("English") << QStringLiteral("en") << QStringLiteral("The user is in Room 1: told by you.")
                             << QStringLiteral("Found, ");
    QTest::newRow("Portuguese") << QStringLiteral("pt")
                                << QStringLiteral("O utilizador está em Room 1: indicado por si.")
                                << QStringLiteral("Encontrado, ");
}

void RolesTest::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    m_settings = std::make_unique<Settings>(file("settings.ini"));
    m_settings->setRecordingFolder(m_folder->path());
}

void RolesTest::cleanup() {
    m_hands.reset();
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
    m_hands = std::make_unique<Hands>(*m_window);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
}

Point2 RolesTest::middleOf(std::size_t region) {
    const auto& ring = map()->regions()[region].polygon.outer;
    return {(ring[0].x + ring[2].x) / 2, (ring[0].y + ring[2].y) / 2};
}

/// The sign of the café is a poster that the library knows; it hangs in the last eight of twelve pictures.
void RolesTest::makeWalk() {
    building::BuildingData house = test::handMadeBuilding()->data();
    house.landmarks[1].kind = Kind::Poster;
    house.landmarks[1].templateId = TemplateId("poster-1");
    QVERIFY(building::saveBuilding(building::Building(house), toUtf8(file("house.gpkg"))).ok());
    recognition::LandmarkLibrary library;
    drawn::trainPoster(library, 1);
    QVERIFY(recognition::saveLibrary(library, toUtf8(file("posters.gpkg"))).ok());
    QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("photos")));
    for (std::uint64_t i = 0; i < 12; ++i) {
        const QString name =
            m_folder->filePath(QStringLiteral("photos/%1.jpg").arg(i, 2, 10, QLatin1Char('0')));
        const double grows = 5.0 * static_cast<double>(i);
        QVERIFY(save(
            wall(i, i < 4 ? 0 : 1, quadOf({200 - grows, 130 - grows, 240 + 2 * grows, 180 + 1.5 * grows})),
            name));
    }
}

void RolesTest::openWalk() {
    Walk& walk = m_window->walk();
    m_hands->answerFile(file("house.gpkg"));
    m_hands->key(Qt::Key_O, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(walk.building(), kPatience);
    m_hands->answerFile(file("posters.gpkg"));
    m_hands->key(Qt::Key_L, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(walk.libraryName(), file("posters.gpkg"), kPatience);
    m_hands->answer<SourceDialog>([this](SourceDialog& ask) {
        auto* folder = ask.findChildren<QRadioButton*>().at(2);
        QTest::mouseClick(folder, Qt::LeftButton, {}, QPoint(10, folder->height() / 2));
        for (QLineEdit* edit : ask.findChildren<QLineEdit*>())
            if (edit->isEnabled() && !qobject_cast<QAbstractSpinBox*>(edit->parentWidget()))
                m_hands->type(edit, file("photos"));
        QTest::keyClick(&ask, Qt::Key_Return);
    });
    m_hands->key(Qt::Key_P, Qt::ControlModifier);
    QTRY_COMPARE(walk.source().name, file("photos"));
    m_hands->choose(m_window->page().destination(), QStringLiteral("Library"));
    QTRY_COMPARE(walk.destination(), std::optional(RegionId("lib")));
}

void RolesTest::correctAndSpeak() {
    QFETCH(QString, corrected);
    LivePage& page = m_window->page();
    MapView& plan = page.mapPanel().view();
    m_hands->key(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier); // recorded
    m_hands->key(Qt::Key_F8);                                         // one picture, then hold
    QTRY_COMPARE_WITH_TIMEOUT(m_window->walk().state(), session::RunState::Paused, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(page.framesShown() > 0, kPatience);
    while (plan.level() > 0.0) QTest::keyClick(&plan, Qt::Key_PageDown); // the ground floor
    m_hands->clickOn(plan, {1.0, 5.0});
    m_hands->key(Qt::Key_H, Qt::ControlModifier);
    QCOMPARE(page.banners().text(QStringLiteral("corrected")), corrected);
    m_hands->answer<QInputDialog>([this](QInputDialog& ask) {
        m_hands->type(ask.findChild<QLineEdit*>(), QStringLiteral("Mind the wet floor."));
        QTest::keyClick(&ask, Qt::Key_Return);
    });
    m_hands->click(m_window->actions().sayThis);
    const auto said = [&page] {
        QStringList all;
        for (int row = 0; row < page.utterances().rowCount(); ++row)
            all << page.utterances().index(row, UtteranceModel::Sentence).data().toString();
        return all;
    };
    QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("Mind the wet floor.")), kPatience);
    m_hands->click(m_window->actions().play);
    QTRY_COMPARE_WITH_TIMEOUT(m_window->walk().state(), session::RunState::Ended, kPatience);
    const auto last = m_window->walk().snapshot();
    QVERIFY(last && !last->step.percept.detections.empty());
    QCOMPARE(last->step.fix.region, std::optional(RegionId("c"))); // where the poster hangs
}

void RolesTest::exportWalk() {
    LivePage& page = m_window->page();
    m_hands->answerFile(file("walk.csv"));
    m_hands->key(Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY_WITH_TIMEOUT(page.banners().text(QStringLiteral("saved")).contains(QLatin1String("walk.csv")),
                             kPatience);
    QFile table(file("walk.csv"));
    QVERIFY(table.open(QIODevice::ReadOnly));
    QVERIFY(table.readAll().contains("Mind the wet floor."));
    m_hands->answerFile(file("seen.png"));
    m_hands->key(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY_WITH_TIMEOUT(page.banners().text(QStringLiteral("saved")).contains(QLatin1String("seen.png")),
                             kPatience);
    QVERIFY(!QImage(file("seen.png")).isNull());
}

void RolesTest::workOutAnew() {
    m_hands->click(m_window->actions().stop); // the recording is whole now
    const QStringList walks = QDir(m_folder->path()).entryList({QStringLiteral("walk-*")}, QDir::Dirs);
    QCOMPARE(walks.size(), 1);
    m_window->actions().revote->trigger();
    QTRY_VERIFY(Hands::open<RevoteDialog>());
    auto* anew = Hands::open<RevoteDialog>();
    m_hands->type(anew->findChild<QLineEdit*>(), m_folder->filePath(walks.first()));
    m_hands->press(anew->startButton());
    QTRY_VERIFY2_WITH_TIMEOUT(anew->summary().contains(QLatin1String("12")), qPrintable(anew->summary()),
                              kPatience);
    QTest::keyClick(anew, Qt::Key_Escape);
}

/// Opens a map, landmarks and pictures, watches, corrects the place, speaks, records, exports, and works the
/// walk out anew.
void RolesTest::theAssistant() {
    makeWalk();
    begin();
    for (const auto step : {&RolesTest::openWalk, &RolesTest::correctAndSpeak, &RolesTest::exportWalk,
                            &RolesTest::workOutAnew}) {
        if (QTest::currentTestFailed()) return;
        (this->*step)();
    }
}

void RolesTest::importRooms() {
    QFile rooms(file("rooms.geojson"));
    QVERIFY(rooms.open(QIODevice::WriteOnly));
    rooms.write(kRooms);
    rooms.close();
    m_hands->key(Qt::Key_2, Qt::ControlModifier);
    MapPage& page = m_window->mapPage();
    m_hands->answer<ImportDialog>([this](ImportDialog& ask) {
        m_hands->type(&ask.path(), file("rooms.geojson"));
        QTest::keyClick(&ask.path(), Qt::Key_Return);
    });
    m_hands->click(page.actions().import);
    QTRY_VERIFY_WITH_TIMEOUT(map() != nullptr && page.settled(), kPatience);
    QCOMPARE(map()->regions().size(), std::size_t{2});
    QCOMPARE(page.tabs().currentWidget(), &page.report());
    QVERIFY(page.report().model().rowCount() > 0); // two rooms without a door
}

/// A room gets another name, and a door joins the two.
void RolesTest::nameAndJoinRooms() {
    MapPage& page = m_window->mapPage();
    MapView& plan = page.plan().view();
    m_hands->clickOn(plan, middleOf(0));
    m_hands->key(Qt::Key_F2);
    QTRY_VERIFY(Hands::open<RegionDialog>());
    m_hands->type(Hands::open<RegionDialog>()->findChild<QLineEdit*>(), QStringLiteral("Canteen"));
    m_hands->key(Qt::Key_Return);
    QTRY_COMPARE(map()->regions()[0].name, std::string("Canteen"));
    m_hands->click(page.actions().addAccess);
    const Point2 a = middleOf(0);
    const Point2 b = middleOf(1);
    m_hands->clickOn(plan, {(a.x + b.x) / 2, (a.y + b.y) / 2});
    QTRY_VERIFY(Hands::open<AccessDialog>());
    m_hands->key(Qt::Key_Return);
    QTRY_COMPARE(map()->accesses().size(), std::size_t{1});
    QVERIFY(map()->areNeighbours(0, 1));
}

/// A landmark is put up, dragged to the other room, taken away, and all that is undone and done again.
void RolesTest::putUpAndMove() {
    MapPage& page = m_window->mapPage();
    MapView& plan = page.plan().view();
    m_hands->click(page.actions().addLandmark);
    m_hands->clickOn(plan, middleOf(1));
    QTRY_VERIFY(Hands::open<LandmarkDialog>());
    m_hands->key(Qt::Key_Return);
    QTRY_COMPARE(map()->landmarks().size(), std::size_t{1});
    m_hands->drag(plan, m_hands->onScreen(plan, map()->landmarks()[0].position),
                  m_hands->onScreen(plan, middleOf(0)));
    QCOMPARE(map()->landmarks()[0].region, map()->regions()[0].id);
    m_hands->key(Qt::Key_Delete);
    QVERIFY(map()->landmarks().empty());
    m_hands->key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(map()->landmarks().size(), std::size_t{1});
    m_hands->key(Qt::Key_Z, Qt::ControlModifier); // the drag was one step
    QCOMPARE(map()->landmarks()[0].region, map()->regions()[1].id);
    m_hands->key(Qt::Key_Y, Qt::ControlModifier);
    QCOMPARE(map()->landmarks()[0].region, map()->regions()[0].id);
}

void RolesTest::saveAndPrint() {
    MapPage& page = m_window->mapPage();
    m_hands->key(Qt::Key_F7);
    QTRY_VERIFY_WITH_TIMEOUT(page.document().findingsHold() && page.settled(), kPatience);
    m_hands->answerFile(file("rooms.gpkg"));
    m_hands->key(Qt::Key_S, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(!page.document().unsaved(), kPatience);
    const auto read = building::loadBuilding(toUtf8(file("rooms.gpkg")));
    QVERIFY(read.ok());
    QCOMPARE(read->building->regions()[0].name, std::string("Canteen"));
    QCOMPARE(read->building->accesses().size(), std::size_t{1});
    QCOMPARE(read->building->landmarks().size(), std::size_t{1});
    m_hands->answerFile(file("rooms.pdf"));
    m_hands->click(page.actions().print);
    QFile paper(file("rooms.pdf"));
    QVERIFY(paper.open(QIODevice::ReadOnly));
    QVERIFY(paper.read(4) == "%PDF");
}

/// From rooms drawn elsewhere to a map of Farol and its plan on paper.
void RolesTest::theMapCurator() {
    begin();
    for (const auto step : {&RolesTest::importRooms, &RolesTest::nameAndJoinRooms, &RolesTest::putUpAndMove,
                            &RolesTest::saveAndPrint}) {
        if (QTest::currentTestFailed()) return;
        (this->*step)();
    }
}

/// A library with one landmark, two photographs of a new one, and a folder to try it on.
void RolesTest::makePosters() {
    QVERIFY(building::saveBuilding(*test::handMadeBuilding(), toUtf8(file("house.gpkg"))).ok());
    recognition::LandmarkLibrary library;
    drawn::trainPoster(library, 1);
    QVERIFY(recognition::saveLibrary(library, toUtf8(file("posters.gpkg"))).ok());
    const Quad near = quadOf({160, 100, 320, 240});
    QVERIFY(save(wall(3, 21, near), file("photo-0.jpg")));
    QVERIFY(save(wall(4, 21, near), file("photo-1.jpg")));
    QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("elsewhere")));
    QVERIFY(save(wall(7, 21, quadOf({260, 140, 240, 180})), file("elsewhere/seen.jpg")));
}

/// Each corner is dragged to where the poster ends, and the view added.
void RolesTest::teachView() {
    TrainingPage& page = m_window->trainingPage();
    TeachViews& views = page.wizard().views();
    OutlineView& outline = views.outline();
    QTRY_VERIFY_WITH_TIMEOUT(page.wizard().reel().current() && page.settled() && outline.outline(),
                             kPatience);
    const Quad poster = quadOf({160, 100, 320, 240});
    for (std::size_t corner = 0; corner < 4; ++corner)
        m_hands->drag(outline, outline.toWidget((*outline.outline())[corner]).toPoint(),
                      outline.toWidget(poster[corner]).toPoint());
    QTRY_VERIFY_WITH_TIMEOUT(page.settled(), kPatience);
    m_hands->press(views.addButton());
}

void RolesTest::teach() {
    m_hands->key(Qt::Key_3, Qt::ControlModifier);
    TrainingPage& page = m_window->trainingPage();
    TeachPanel& wizard = page.wizard();
    m_hands->answerFile(file("posters.gpkg"));
    m_hands->key(Qt::Key_L, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(page.document().library(), kPatience);
    m_hands->key(Qt::Key_T, Qt::ControlModifier);
    QTRY_VERIFY(page.teaching());
    QTest::keyClicks(&wizard.what().name(), QStringLiteral("Corner"));
    m_hands->press(wizard.forward());
    QCOMPARE(wizard.step(), TeachPanel::Views);
    m_hands->answerFiles({file("photo-0.jpg"), file("photo-1.jpg")});
    m_hands->press(wizard.views().filesButton());
    for (int view = 0; view < 2; ++view) {
        QTRY_COMPARE_WITH_TIMEOUT(wizard.reel().index(), view, kPatience);
        teachView();
        QTRY_COMPARE_WITH_TIMEOUT(page.session().draft().views.size(), static_cast<std::size_t>(view + 1),
                                  kPatience);
    }
    QTRY_VERIFY_WITH_TIMEOUT(page.session().health() && page.settled(), kPatience);
    QVERIFY(!wizard.views().healthText().isEmpty());
}

void RolesTest::tryAndSave() {
    QFETCH(QString, found);
    TrainingPage& page = m_window->trainingPage();
    TeachPanel& wizard = page.wizard();
    m_hands->press(wizard.forward());
    m_hands->answerFile(file("elsewhere"));
    m_hands->press(wizard.trial().recordingButton());
    QTRY_COMPARE_WITH_TIMEOUT(wizard.reel().name(), QStringLiteral("seen.jpg"), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(wizard.reel().current() && page.settled(), kPatience);
    QVERIFY2(wizard.trial().verdict().startsWith(found), qPrintable(wizard.trial().verdict()));
    m_hands->press(wizard.forward());
    QTRY_COMPARE_WITH_TIMEOUT(wizard.step(), TeachPanel::End, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(page.document().settled() && !page.document().unsaved(), kPatience);
    const auto read = recognition::loadLibrary(toUtf8(file("posters.gpkg")));
    QVERIFY(read.ok());
    QCOMPARE(read->templates.size(), std::size_t{2});
}

void RolesTest::placeOnMap() {
    MapPage& page = m_window->mapPage();
    m_hands->press(m_window->trainingPage().wizard().place());
    QCOMPARE(m_window->shownPage(), Page::Map);
    m_hands->answerFile(file("house.gpkg"));
    m_hands->key(Qt::Key_O, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(page.document().building() && page.settled(), kPatience);
    MapView& plan = page.plan().view();
    while (plan.level() > 0.0) QTest::keyClick(&plan, Qt::Key_PageDown);
    m_hands->clickOn(plan, {1.0, 3.0});
    QTRY_VERIFY(Hands::open<LandmarkDialog>());
    m_hands->key(Qt::Key_Return);
    m_hands->key(Qt::Key_S, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(!page.document().unsaved(), kPatience);
    const auto read = building::loadBuilding(toUtf8(file("house.gpkg")));
    QVERIFY(read.ok());
    const auto& landmarks = read->building->landmarks();
    QVERIFY(std::any_of(landmarks.begin(), landmarks.end(), [](const building::Landmark& landmark) {
        return landmark.templateId == TemplateId("corner") && landmark.region == RegionId("r1");
    }));
}

/// A landmark is taught from two photographs, found in a third, put on the map, and the library looked
/// through.
void RolesTest::theLandmarkCurator() {
    makePosters();
    begin();
    for (const auto step : {&RolesTest::teach, &RolesTest::tryAndSave, &RolesTest::placeOnMap}) {
        if (QTest::currentTestFailed()) return;
        (this->*step)();
    }
    if (QTest::currentTestFailed()) return;
    TrainingPage& page = m_window->trainingPage();
    m_hands->key(Qt::Key_3, Qt::ControlModifier);
    m_hands->press(page.wizard().forward()); // done
    QTRY_VERIFY(!page.teaching());
    m_hands->key(Qt::Key_F7);
    QTRY_COMPARE_WITH_TIMEOUT(page.panel().confusion().rowCount(), 2, kPatience);
    QVERIFY(!page.panel().reportText().isEmpty());
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
    m_hands->choose(page.destination(), QStringLiteral("Library"));
    QTRY_VERIFY_WITH_TIMEOUT(demo.visit() && demo.visit()->to == RegionId("lib"), kPatience);
    QCOMPARE(demo.visitor(), 1); // the same one goes elsewhere
    auto* bar = m_window->findChild<QToolBar*>(QStringLiteral("demo"));
    const QList<QAction*> actions = bar->actions(); // wrong turn, cover, lights, next visitor
    m_hands->click(actions[0]);
    m_hands->click(actions[1]);
    QVERIFY(demo.covered());
    const int before = page.framesShown();
    QTRY_VERIFY_WITH_TIMEOUT(page.framesShown() > before + 1, kPatience); // it goes on, seeing nothing
    m_hands->click(actions[1]);
    QVERIFY(!demo.covered());
    m_hands->key(Qt::Key_F9);
    QTRY_COMPARE(demo.visitor(), 2);
    QTRY_COMPARE_WITH_TIMEOUT(m_window->walk().state(), session::RunState::Running, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(page.framesShown() > 1, kPatience);
}

} // namespace farol::ui

QTEST_MAIN(farol::ui::RolesTest)
#include "test_roles.moc"
