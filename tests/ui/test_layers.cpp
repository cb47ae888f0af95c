// What lies over and under the plan, and the report of missing routes: where landmarks are seen, an image of
// the floor that is placed by clicked points or by its own file, and files that are dropped on the window.

#include "core/base/ogr.h"
#include "core/building/geopackage.h"
#include "core/building/plan_picture.h"
#include "tests/ui/hand_made.h"
#include "tests/ui/role_hands.h"
#include "ui/convert/convert.h"
#include "ui/curation/floor_pictures.h"
#include "ui/curation/map_actions.h"
#include "ui/curation/missing_dialog.h"
#include "ui/curation/plan_panel.h"
#include "ui/curation/plan_print.h"
#include "ui/curation/route_panel.h"
#include "ui/main_window/main_window.h"
#include "ui/map/coverage.h"
#include "ui/map/floor_picture.h"
#include "ui/parts/banner.h"

#include <QAction>
#include <QDir>
#include <QDropEvent>
#include <QMenu>
#include <QMimeData>
#include <QPainter>
#include <QPushButton>
#include <QSlider>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <cmath>

namespace farol::ui {

namespace {

using test::Hands;
using test::kPatience;

constexpr std::uint8_t kOutside = LevelCoverage::kOutside;

building::Building changed(const std::function<void(building::BuildingData&)>& change) {
    building::BuildingData data = test::handMadeBuilding()->data();
    change(data);
    return building::Building(data);
}

} // namespace

class LayersTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();
    void landmarksAreSeenInTheirRegionAndThroughDoors();
    void fromFarAwayOrBehindALandmarkIsNotSeen();
    void theMapShowsWhereNothingIsSeen();
    void missingRoutesAreListedWithTheirReason();
    void whereAllIsJoinedTheReportSaysSo();
    void aOneWayDoorMissesOneWayOnly();
    void whatIsAvoidedMayBeMissing();
    void threePointsStraightenAnImage();
    void anImageIsPlacedByTwoClickedPairsAndKept();
    void anImageWithAPlaceOfItsOwnLiesThere();
    void anImageThatIsNoneIsTold();
    void filesDroppedOnTheWalk();
    void filesDroppedOnTheMap();
    void aRecentMapIsOpenedAgain();
    void whatIsShownIsPrinted();

private:
    void make();
    void openMap();
    void drop(QWidget& on, const QString& path);
    QString file(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    QString plan(); ///< 130 x 60 pixels, white, a red square in its lower left corner

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Settings> m_settings;
    std::unique_ptr<MainWindow> m_window;
    std::unique_ptr<Hands> m_hands;
};

void LayersTest::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    m_settings = std::make_unique<Settings>(file("settings.ini"));
    m_settings->setLanguage(QStringLiteral("en"));
    MainWindow::applyLanguage(*m_settings);
    QVERIFY(building::saveBuilding(*test::handMadeBuilding(), toUtf8(file("house.gpkg"))).ok());
}

void LayersTest::cleanup() {
    m_hands.reset();
    m_window.reset();
    m_settings.reset();
    m_folder.reset();
}

void LayersTest::make() {
    m_hands.reset();
    m_window = std::make_unique<MainWindow>(*m_settings, Walk::OpenSource(), [](const VoiceChoice&) {
        return std::make_unique<test::FakeVoice>();
    });
    m_hands = std::make_unique<Hands>(*m_window);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
}

void LayersTest::openMap() {
    make();
    m_window->showPage(Page::Map);
    MapPage& page = m_window->mapPage();
    page.open(file("house.gpkg"));
    QTRY_VERIFY_WITH_TIMEOUT(page.document().building() && page.settled(), kPatience);
}

/// As a file manager does it.
void LayersTest::drop(QWidget& on, const QString& path) {
    QMimeData files;
    files.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enters(QPoint(200, 200), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&on, &enters);
    QVERIFY(enters.isAccepted());
    QDropEvent drops(QPointF(200, 200), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&on, &drops);
    QVERIFY(drops.isAccepted());
}

QString LayersTest::plan() {
    QImage image(130, 60, QImage::Format_RGB32);
    image.fill(Qt::white);
    for (int x = 0; x < 20; ++x)
        for (int y = 40; y < 60; ++y) image.setPixelColor(x, y, Qt::red);
    const QString name = file("plan.png");
    return image.save(name) ? name : QString();
}

void LayersTest::landmarksAreSeenInTheirRegionAndThroughDoors() {
    const Coverage seen = findCoverage(*test::handMadeBuilding());
    const LevelCoverage* ground = seen.level(0.0);
    QVERIFY(ground);
    QVERIFY(ground->at(Point2{5.0, 1.0}) >= 2);              // in the corridor, both
    QVERIFY(ground->at(Point2{1.5, 4.0}) >= 1);              // in the room, through the open door
    QCOMPARE(ground->at(Point2{4.5, 5.5}), std::uint8_t{0}); // in its corner
    QCOMPARE(ground->at(Point2{-3.0, -3.0}), kOutside);
    const LevelCoverage* upstairs = seen.level(1.0);
    QVERIFY(upstairs && upstairs->inside > 0);
    QCOMPARE(upstairs->unseen, upstairs->inside); // not one landmark there
    QVERIFY(seen.unseenShare() > 0.5 && seen.unseenShare() < 1.0);
    // A closed door hides it.
    const building::Building closed = changed([](auto& data) { data.accesses[0].closed = true; });
    QCOMPARE(findCoverage(closed).level(0.0)->at(Point2{1.5, 4.0}), std::uint8_t{0});
    QCOMPARE(findCoverage(building::Building(building::BuildingData{})).unseenShare(), 0.0);
}

void LayersTest::fromFarAwayOrBehindALandmarkIsNotSeen() {
    const building::Building one = changed([](auto& data) {
        data.landmarks.resize(1);
        data.landmarks[0].widthM = 0.2; // 4 m away at most
    });
    QVERIFY(findCoverage(one).level(0.0)->at(Point2{7.0, 1.0}) == 1);
    QCOMPARE(findCoverage(one).level(0.0)->at(Point2{9.5, 1.0}), std::uint8_t{0});
    const building::Building facing = changed([](auto& data) {
        data.landmarks.resize(1);
        data.landmarks[0].position = {5.0, 1.0};
        data.landmarks[0].heading = Radians{0.0}; // to the east
    });
    QVERIFY(findCoverage(facing).level(0.0)->at(Point2{8.0, 1.0}) == 1);
    QCOMPARE(findCoverage(facing).level(0.0)->at(Point2{2.0, 1.0}), std::uint8_t{0});
}

void LayersTest::theMapShowsWhereNothingIsSeen() {
    openMap();
    MapPage& page = m_window->mapPage();
    MapView& view = page.plan().view();
    const QImage before = view.grab().toImage();
    m_hands->key(Qt::Key_U, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY_WITH_TIMEOUT(page.settled() && view.overlay().coverage, kPatience);
    QVERIFY(page.plan().whatText().contains(QLatin1Char('%')));
    const auto pixel = [&](const QImage& image, Point2 at) {
        return image.pixel(m_hands->onScreen(view, at));
    };
    const QImage after = view.grab().toImage();
    QVERIFY(pixel(after, {4.3, 5.3}) != pixel(before, {4.3, 5.3}));
    // It follows an edit: without its landmarks nothing is seen in the corridor.
    for (int i = 0; i < 2; ++i) {
        view.select(MapHit{MapHit::What::Landmark, 0}, false);
        m_hands->key(Qt::Key_Delete);
    }
    const auto alone = [&] {
        const auto& layer = view.overlay().coverage;
        return page.settled() && layer && layer->coverage.unseenShare() == 1.0;
    };
    QTRY_VERIFY_WITH_TIMEOUT(alone(), kPatience);
    m_hands->key(Qt::Key_U, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(!view.overlay().coverage);
}

void LayersTest::missingRoutesAreListedWithTheirReason() {
    const building::Building house =
        changed([](auto& data) { data.accesses[1].closed = true; }); // the café's
    QVERIFY(building::saveBuilding(house, toUtf8(file("house.gpkg"))).ok());
    openMap();
    MapPage& page = m_window->mapPage();
    m_hands->key(Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY(Hands::open<MissingDialog>());
    auto* dialog = Hands::open<MissingDialog>();
    QTRY_VERIFY_WITH_TIMEOUT(dialog->done(), kPatience);
    QCOMPARE(dialog->summary(), QStringLiteral("Of 30 pairs of places, 10 have no route."));
    QCOMPARE(dialog->table().rowCount(), 1);
    QCOMPARE(dialog->table().item(0, 0)->text(), QStringLiteral("Main corridor and 4 more places"));
    QCOMPARE(dialog->table().item(0, 1)->text(), QStringLiteral("Café"));
    QCOMPARE(dialog->table().item(0, 2)->text(), QStringLiteral("both ways"));
    QVERIFY(dialog->table().item(0, 3)->text().contains(QLatin1String("closed")));
    m_hands->press(dialog->showButton());
    QTRY_VERIFY_WITH_TIMEOUT(page.settled() && page.route().summary().contains(QLatin1String("closed")),
                             kPatience);
    QVERIFY(page.plan().view().selected());
}

void LayersTest::whereAllIsJoinedTheReportSaysSo() {
    MissingDialog dialog(test::handMadeBuilding(), {});
    QTRY_VERIFY_WITH_TIMEOUT(dialog.done(), kPatience);
    QVERIFY(dialog.summary().contains(QLatin1String("30")));
    QCOMPARE(dialog.table().rowCount(), 0);
    QVERIFY(!dialog.showButton().isEnabled());
}

void LayersTest::aOneWayDoorMissesOneWayOnly() {
    const auto house = std::make_shared<const building::Building>(
        changed([](auto& data) { data.accesses[1].oneWay = building::OneWay::AToB; })); // into the café
    const routing::MissingRoutes found = routing::findMissingRoutes(house, {});
    QCOMPARE(found.missingPairs, std::size_t{5});
    QCOMPARE(found.routes.size(), std::size_t{1});
    QVERIFY(!found.routes[0].bothWays);
    QCOMPARE(found.groups[found.routes[0].from].regions.front(), RegionId("r2"));
    QCOMPARE(found.routes[0].why.past.size(), std::size_t{1});
    QVERIFY(found.routes[0].why.past[0].obstacle == routing::Obstacle::OneWay);
    // More than are wanted are counted, not listed.
    const auto apart =
        std::make_shared<const building::Building>(changed([](auto& data) { data.accesses.clear(); }));
    const routing::MissingRoutes all = routing::findMissingRoutes(apart, {}, 4);
    QCOMPARE(all.missingPairs, std::size_t{30});
    QCOMPARE(all.routes.size() + all.leftOut, std::size_t{15});
    QCOMPARE(all.routes.size(), std::size_t{4});
    const auto empty = std::make_shared<const building::Building>(building::BuildingData{});
    QCOMPARE(routing::findMissingRoutes(empty, {}).pairs, std::size_t{0});
}

/// What the report calls missing is what the planner refuses, pair by pair.
void LayersTest::whatIsAvoidedMayBeMissing() {
    const auto house = std::make_shared<const building::Building>(changed([](auto& data) {
        data.regions[0].restricted = true; // the corridor: nobody passes, but one may begin or end there
    }));
    routing::RouteOptions options;
    options.avoidRestricted = true;
    options.avoidStairs = true;
    const routing::MissingRoutes found = routing::findMissingRoutes(house, options);
    const auto planner = routing::makeOptimalPlanner(house, options);
    std::size_t refused = 0;
    for (const auto& from : house->regions())
        for (const auto& to : house->regions())
            if (from.id != to.id)
                refused += !planner->plan({from.id, std::nullopt}, {to.id, std::nullopt}).ok();
    QVERIFY(refused > 0);
    QCOMPARE(found.missingPairs, refused);
}

void LayersTest::threePointsStraightenAnImage() {
    const auto near = [](const QTransform& t, QPointF pixel, Point2 metres) {
        const QPointF at = t.map(pixel);
        return std::hypot(at.x() - metres.x, at.y() - metres.y) < 1e-9;
    };
    // A quarter turn, ten pixels a metre.
    const auto turned = placedBy({{{0, 0}, {3, 4}}, {{100, 0}, {3, 14}}});
    QVERIFY(turned && near(*turned, {100, 0}, {3, 14}) && near(*turned, {0, 50}, {8, 4}));
    const auto skewed = placedBy({{{0, 0}, {0, 0}}, {{100, 0}, {10, 1}}, {{0, 100}, {2, -9}}});
    QVERIFY(skewed && near(*skewed, {0, 0}, {0, 0}) && near(*skewed, {100, 0}, {10, 1}) &&
            near(*skewed, {0, 100}, {2, -9}));
    QVERIFY(!placedBy({{{0, 0}, {3, 4}}, {{2, 0}, {3, 14}}}));                      // the same pixel
    QVERIFY(!placedBy({{{0, 0}, {3, 4}}, {{100, 0}, {3, 4}}}));                     // the same place
    QVERIFY(!placedBy({{{0, 0}, {0, 0}}, {{50, 0}, {5, 0}}, {{100, 0}, {10, 3}}})); // on one line
    QVERIFY(!placedBy({{{0, 0}, {0, 0}}}));
}

void LayersTest::anImageIsPlacedByTwoClickedPairsAndKept() {
    openMap();
    MapPage& page = m_window->mapPage();
    MapView& view = page.plan().view();
    FloorPictures& pictures = page.pictures();
    QVERIFY(!plan().isEmpty());
    m_hands->answerFile(file("plan.png"));
    m_hands->key(Qt::Key_I, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY_WITH_TIMEOUT(pictures.placing(), kPatience);
    const auto pixelAt = [&](QPointF pixel) { // where it is seen now
        const QPointF at = pictures.current()->toMap.map(pixel);
        return Point2{at.x(), at.y()};
    };
    // Its lower left and its upper right corner belong on those of the house, which is 13 by 6 metres.
    m_hands->clickOn(view, pixelAt({0.5, 59.5}));
    QVERIFY(page.plan().whatText().contains(QLatin1String("belongs on the map")));
    m_hands->clickOn(view, {0, 0});
    m_hands->clickOn(view, pixelAt({129.5, 0.5}));
    m_hands->clickOn(view, {13, 6});
    const Point2 corner = pixelAt({0, 60});
    const Point2 far = pixelAt({130, 0});
    QVERIFY2(distance(corner, {0, 0}) < 0.3 && distance(far, {13, 6}) < 0.3, "two pixels of the screen");
    m_hands->key(Qt::Key_Escape); // no third point
    QVERIFY(!pictures.placing());
    QCOMPARE(view.tool(), MapView::Tool::Move);
    const QColor red = view.grab().toImage().pixelColor(m_hands->onScreen(view, {0.6, 1.5}));
    QVERIFY2(red.red() > red.green() + 60, qPrintable(red.name())); // it shines through the corridor's floor
    pictures.opacity().setFocus();
    QTest::keyClick(&pictures.opacity(), Qt::Key_Home);
    QCOMPARE(pictures.current()->opacity, 0.1);
    QTest::keyClick(&view, Qt::Key_PageUp); // another floor has none
    QVERIFY(!pictures.current() && !pictures.bar().isVisible());

    const QTransform placed = view.overlay().pictures.front()->toMap;
    openMap(); // another day
    FloorPictures& again = m_window->mapPage().pictures();
    QTRY_VERIFY_WITH_TIMEOUT(again.current(), kPatience);
    QCOMPARE(again.current()->toMap, placed);
    QCOMPARE(again.current()->opacity, 0.1);
    m_hands->press(again.removeButton());
    QVERIFY(!again.current());
    openMap();
    QVERIFY(!m_window->mapPage().pictures().current());
}

void LayersTest::anImageWithAPlaceOfItsOwnLiesThere() {
    QVERIFY(!plan().isEmpty());
    QFile world(file("plan.pgw")); // a world file: metres of the map, of the middle of the first pixel
    QVERIFY(world.open(QIODevice::WriteOnly));
    world.write("0.1\n0\n0\n-0.1\n0.05\n5.95\n");
    world.close();
    openMap();
    FloorPictures& pictures = m_window->mapPage().pictures();
    pictures.load(file("plan.png"));
    QTRY_VERIFY_WITH_TIMEOUT(pictures.current(), kPatience);
    QVERIFY(!pictures.placing());
    const QPointF corner = pictures.current()->toMap.map(QPointF(130, 60));
    QVERIFY(std::hypot(corner.x() - 13.0, corner.y()) < 1e-6);

    // A GeoTIFF in degrees, on a map in metres.
    GDALAllRegister();
    OGRSpatialReference utm;
    utm.importFromEPSG(32629);
    char* text = nullptr;
    utm.exportToWkt(&text);
    const std::string crs = text;
    CPLFree(text);
    const std::string tiff = toUtf8(file("plan.tif"));
    {
        const DatasetPtr made(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(tiff.c_str(), 100, 100,
                                                                                       3, GDT_Byte, nullptr));
        double place[6] = {-7.9, 1e-5, 0.0, 37.0, 0.0, -1e-5};
        made->SetGeoTransform(place);
        OGRSpatialReference degrees;
        degrees.importFromEPSG(4326);
        made->SetSpatialRef(&degrees);
    }
    const auto read = building::loadPlanPicture(tiff, crs);
    QVERIFY(read.ok() && read->toMap);
    // 37.0 N, 7.9 W is 597887 E, 4095463 N in zone 29; 1e-5 degrees of latitude are 1.11 metres.
    QVERIFY2(std::abs((*read->toMap)[0] - 597880.0) < 200.0, qPrintable(QString::number((*read->toMap)[0])));
    QVERIFY(std::abs(std::hypot((*read->toMap)[2], (*read->toMap)[5]) - 1.11) < 0.01);
    const auto smaller = building::loadPlanPicture(tiff, crs, 50);
    QVERIFY(smaller.ok() && smaller->width == 50);
    QVERIFY(std::abs((*smaller->toMap)[5] - 2.0 * (*read->toMap)[5]) < 1e-9);
    QVERIFY(!building::loadPlanPicture(tiff, std::string())->toMap); // a plan without a place on earth
}

void LayersTest::anImageThatIsNoneIsTold() {
    QFile none(file("none.png"));
    QVERIFY(none.open(QIODevice::WriteOnly));
    none.write("not a picture");
    none.close();
    openMap();
    MapPage& page = m_window->mapPage();
    for (const char* name : {"none.png", "nowhere.png"}) {
        page.banners().hide(QStringLiteral("picture"));
        page.pictures().load(file(name));
        QTRY_VERIFY_WITH_TIMEOUT(page.banners().text(QStringLiteral("picture")).contains(QLatin1String(name)),
                                 kPatience);
    }
    QVERIFY(!page.pictures().current());
}

void LayersTest::filesDroppedOnTheWalk() {
    make();
    QVERIFY(!plan().isEmpty());
    drop(*m_window, file("plan.png"));
    QCOMPARE(m_window->walk().source().name, file("plan.png"));
    QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("walk/frames"))); // as a recording is kept
    drop(*m_window, file("walk"));
    QCOMPARE(m_window->walk().source().name, file("walk/frames"));
    // Map or library? The user is asked.
    drop(*m_window, file("house.gpkg"));
    QTRY_VERIFY(QApplication::activePopupWidget());
    QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_Down);
    QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(m_window->walk().mapName(), file("house.gpkg"), kPatience);
}

void LayersTest::filesDroppedOnTheMap() {
    make();
    m_window->showPage(Page::Map);
    MapPage& page = m_window->mapPage();
    drop(page, file("house.gpkg"));
    QTRY_VERIFY_WITH_TIMEOUT(page.document().building() && page.settled(), kPatience);
    QVERIFY(!plan().isEmpty());
    drop(page, file("plan.png"));
    QTRY_VERIFY_WITH_TIMEOUT(page.pictures().current(), kPatience);
    QCOMPARE(page.document().source(), file("house.gpkg")); // the map stays
}

void LayersTest::aRecentMapIsOpenedAgain() {
    openMap();
    make(); // the next start
    QMenu* recent = m_window->actions().recentMaps;
    QVERIFY(recent->isEnabled());
    QCOMPARE(recent->actions().first()->text(), file("house.gpkg"));
    recent->actions().first()->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(m_window->walk().mapName(), file("house.gpkg"), kPatience);
}

/// The image of the floor, what is seen from where, the marks, and what their colours mean.
void LayersTest::whatIsShownIsPrinted() {
    const MapScene scene(test::handMadeBuilding());
    const LevelScene& level = scene.levels().front();
    const auto page = [&](const MapOverlay& overlay) {
        QImage image(800, 600, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        paintPlanPage(painter, scene, level, overlay, image.size());
        painter.end();
        return image;
    };
    const auto differ = [](const QImage& a, const QImage& b, const QRect& where) {
        int count = 0;
        for (int y = where.top(); y <= where.bottom(); ++y)
            for (int x = where.left(); x <= where.right(); ++x)
                count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
        return count;
    };
    const QRect map(0, 40, 800, 500);
    const QRect legend(0, 575, 800, 25);
    page({}); // the letters are drawn from a cache from the second time on, a shade otherwise
    const QImage plain = page({});
    QCOMPARE(differ(plain, page({}), plain.rect()), 0);

    MapOverlay withPicture;
    auto picture = std::make_shared<FloorPicture>();
    picture->image = QImage(40, 20, QImage::Format_RGB32);
    picture->image.fill(QColor(120, 160, 90));
    picture->toMap = placedIn(level.bounds, picture->image.size());
    picture->opacity = 1.0;
    picture->level = level.ordinal;
    withPicture.pictures = {picture};
    QVERIFY(differ(plain, page(withPicture), map) > 20000);
    picture->level = 7.0; // of another floor
    QCOMPARE(differ(plain, page(withPicture), map), 0);

    MapOverlay withCoverage;
    withCoverage.coverage =
        std::make_shared<const CoverageLayer>(drawCoverage(findCoverage(*test::handMadeBuilding())));
    QVERIFY(differ(plain, page(withCoverage), map) > 20000);
    QVERIFY(differ(plain, page(withCoverage), legend) > 200);

    MapOverlay withMarks;
    withMarks.marks = std::make_shared<const std::vector<RegionMark>>(scene.building().regions().size(),
                                                                      RegionMark::LooksAlike);
    QVERIFY(differ(plain, page(withMarks), map) > 5000);
    QVERIFY(differ(plain, page(withMarks), legend) > 200);

    picture->level = level.ordinal;
    const QString paper = file("image.pdf");
    QVERIFY(printPlan(test::handMadeBuilding(), withPicture, paper));
    QFile pdf(paper);
    QVERIFY(pdf.open(QIODevice::ReadOnly));
    QVERIFY(pdf.readAll().contains("/Subtype /Image"));
}

} // namespace farol::ui

QTEST_MAIN(farol::ui::LayersTest)
#include "test_layers.moc"
