// The map: coordinates there and back, what lies under the pointer, zoom and pan by hand and by keys.

#include "tests/ui/hand_made.h"
#include "ui/convert/convert.h"
#include "ui/convert/glyphs.h"
#include "ui/convert/kind_style.h"
#include "ui/map/map_colours.h"
#include "ui/map/map_painter.h"
#include "ui/map/map_view.h"

#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include <cmath>

namespace farol::ui {

class MapTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void northIsUp();
    void pointsComeBack_data();
    void pointsComeBack();
    void thePointUnderThePointerStays();
    void theWholeFloorFits();
    void aStrayThingDoesNotShrinkTheFloor();
    void nothingLiesUnderTheLegend();
    void brokenNumbersDoNotBreakTheView();
    void theSmallerThingIsMeant();
    void nothingLiesOutside();
    void stairsStandOnBothLevels();
    void keysMoveAndZoom();
    void aClickSelects();
    void votesTintTheirRegions();
    void noMarkCoversAName();
    void anEmptyMapIsPainted();
    void textIsReadableOnEveryTint_data();
    void textIsReadableOnEveryTint();
    void picturesAreCopied();
};

void MapTest::northIsUp() {
    const ViewTransform view({0, 0}, 10.0, {200, 100});
    QCOMPARE(view.screenFromMap({0, 0}), QPointF(100, 50));
    QCOMPARE(view.screenFromMap({1, 0}), QPointF(110, 50));
    QCOMPARE(view.screenFromMap({0, 1}), QPointF(100, 40));
    QCOMPARE(view.painterTransform().map(QPointF(3, 2)), view.screenFromMap({3, 2}));
}

void MapTest::pointsComeBack_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("scale");
    QTest::newRow("origin") << 0.0 << 0.0 << 20.0;
    QTest::newRow("far, as in a national grid") << 488000.25 << 5470000.75 << 7.5;
    QTest::newRow("negative") << -12.0 << -3.5 << 400.0;
    QTest::newRow("small scale") << 1234.5 << -987.0 << 0.2;
}

void MapTest::pointsComeBack() {
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, scale);
    const ViewTransform view({x + 1.0, y - 2.0}, scale, {801, 599});
    const Point2 back = view.mapFromScreen(view.screenFromMap({x, y}));
    QVERIFY(std::abs(back.x - x) < 1e-6);
    QVERIFY(std::abs(back.y - y) < 1e-6);
}

void MapTest::thePointUnderThePointerStays() {
    const ViewTransform view({5, 5}, 20.0, {400, 300});
    const QPointF pointer(37, 211);
    const Point2 before = view.mapFromScreen(pointer);
    const Point2 after = view.zoomedAt(pointer, 1.7).mapFromScreen(pointer);
    QVERIFY(distance(before, after) < 1e-9);
    const ViewTransform moved = view.panned({10, -4});
    QCOMPARE(moved.screenFromMap(before), pointer + QPointF(10, -4));
    QCOMPARE(view.zoomedAt(pointer, 1e9).pixelsPerMetre(), view.zoomedAt(pointer, 1e12).pixelsPerMetre());
}

void MapTest::theWholeFloorFits() {
    const Box2 box{{-3, 2}, {47, 12}};
    const ViewTransform view = ViewTransform::fitted(box, {640, 480}, 20);
    for (const Point2 corner : {box.low, box.high}) {
        const QPointF at = view.screenFromMap(corner);
        QVERIFY(QRectF(19.9, 19.9, 600.2, 440.2).contains(at));
    }
}

/// One landmark with a wrong figure.
void MapTest::aStrayThingDoesNotShrinkTheFloor() {
    building::BuildingData data = test::handMadeBuilding()->data();
    const Box2 before = MapScene(test::handMadeBuilding()).levels().front().bounds;
    data.landmarks[0].position = {300.0, -100.0};
    const auto stray = std::make_shared<const building::Building>(std::move(data));
    const MapScene scene(stray);
    QCOMPARE(scene.levels().front().bounds.width(), before.width());
    QVERIFY(scene.levels().front().bounds.height() <= before.height());
    QCOMPARE(scene.levels().front().landmarks.size(), std::size_t{2}); // it is there all the same
    MapView map;
    map.resize(600, 400);
    map.setBuilding(stray);
    map.select(MapHit{MapHit::What::Landmark, 0}, true); // and can be looked at, with the floor
    for (const Point2 at : {Point2{300.0, -100.0}, before.low, before.high})
        QVERIFY(QRectF(map.rect()).contains(map.viewTransform().screenFromMap(at)));
}

/// What stands at the lower edge covers nothing of a floor that is shown whole.
void MapTest::nothingLiesUnderTheLegend() {
    MapView map;
    map.resize(600, 400);
    map.setBuilding(test::handMadeBuilding());
    const Box2 floor = map.scene()->levels().front().bounds;
    QVERIFY(map.viewTransform().screenFromMap(floor.low).y() < map.height() - 50.0);
    map.resize(200, 600);
    map.fit();
    QVERIFY(map.viewTransform().screenFromMap(floor.low).y() < map.height() - 50.0);
}

void MapTest::brokenNumbersDoNotBreakTheView() {
    const ViewTransform view({NAN, 0}, INFINITY, {0, -5});
    QVERIFY(isFinite(view.centre()));
    QVERIFY(std::isfinite(view.pixelsPerMetre()));
    const ViewTransform none = ViewTransform::fitted({{4, 4}, {4, 4}}, {100, 100}, 80);
    QVERIFY(isFinite(none.mapFromScreen({50, 50})));
}

void MapTest::theSmallerThingIsMeant() {
    const MapScene scene(test::handMadeBuilding());
    const ViewTransform view = ViewTransform::fitted(scene.levels().front().bounds, {800, 600}, 20);
    const auto at = [&](Point2 p) { return hitAt(view.screenFromMap(p), scene, 0.0, view); };
    QCOMPARE(at({4, 0.25}), (MapHit{MapHit::What::Landmark, 0}));
    QCOMPARE(at({2.5, 2}), (MapHit{MapHit::What::Access, 0}));
    QCOMPARE(at({6, 5}), (MapHit{MapHit::What::Region, 2}));
    QCOMPARE(at({1, 1}), (MapHit{MapHit::What::Region, 0}));
}

void MapTest::nothingLiesOutside() {
    const MapScene scene(test::handMadeBuilding());
    const ViewTransform view = ViewTransform::fitted(scene.levels().front().bounds, {800, 600}, 20);
    QVERIFY(!hitAt(view.screenFromMap({-4, -4}), scene, 0.0, view));
    QVERIFY(!hitAt(view.screenFromMap({1, 1}), scene, 7.0, view)); // no such level
}

void MapTest::stairsStandOnBothLevels() {
    const MapScene scene(test::handMadeBuilding());
    QCOMPARE(scene.levels().size(), 2u);
    for (const LevelScene& level : scene.levels()) {
        bool found = false;
        for (const AccessShape& shape : level.accesses)
            found = found || scene.building().accesses()[shape.index].id == AccessId("st");
        QVERIFY(found);
    }
}

void MapTest::keysMoveAndZoom() {
    MapView map;
    map.resize(600, 400);
    map.setBuilding(test::handMadeBuilding());
    QSignalSpy levels(&map, &MapView::levelChanged);
    const double scale = map.viewTransform().pixelsPerMetre();
    QTest::keyClick(&map, Qt::Key_Plus);
    QVERIFY(map.viewTransform().pixelsPerMetre() > scale);
    const Point2 centre = map.viewTransform().centre();
    QTest::keyClick(&map, Qt::Key_Right);
    QVERIFY(map.viewTransform().centre().x > centre.x); // one looks further to the east
    QTest::keyClick(&map, Qt::Key_Up);
    QVERIFY(map.viewTransform().centre().y > centre.y);
    QTest::keyClick(&map, Qt::Key_0);
    QCOMPARE(map.viewTransform().pixelsPerMetre(), scale);
    QTest::keyClick(&map, Qt::Key_PageUp);
    QCOMPARE(map.level(), 1.0);
    QTest::keyClick(&map, Qt::Key_PageUp); // there is nothing above
    QCOMPARE(map.level(), 1.0);
    QTest::keyClick(&map, Qt::Key_PageDown);
    QCOMPARE(map.level(), 0.0);
    QCOMPARE(levels.count(), 2);
}

void MapTest::aClickSelects() {
    MapView map;
    map.resize(600, 400);
    map.setBuilding(test::handMadeBuilding());
    QSignalSpy selections(&map, &MapView::selectionChanged);
    QSignalSpy activations(&map, &MapView::activated);
    const QPoint cafe = map.viewTransform().screenFromMap({6, 5}).toPoint();
    QTest::mouseClick(&map, Qt::LeftButton, {}, cafe);
    QCOMPARE(map.selected(), (MapHit{MapHit::What::Region, 2}));
    QCOMPARE(selections.count(), 1);
    QTest::keyClick(&map, Qt::Key_Return);
    QCOMPARE(activations.count(), 1);
    QTest::keyClick(&map, Qt::Key_Escape);
    QVERIFY(!map.selected());
    map.select(MapHit{MapHit::What::Region, 5}, true); // on the other floor
    QCOMPARE(map.level(), 1.0);
}

void MapTest::votesTintTheirRegions() {
    MapView map;
    map.resize(600, 400);
    map.setBuilding(test::handMadeBuilding());
    const auto colourAt = [&](Point2 p) {
        return map.grab().toImage().pixelColor(map.viewTransform().screenFromMap(p).toPoint());
    };
    const QColor before = colourAt({0.4, 0.6});
    const QColor other = colourAt({9.6, 5.6});
    MapOverlay overlay;
    overlay.fix = test::handMadeSnapshot()->step.fix;
    overlay.fix->region.reset();
    overlay.fix->position.reset();
    map.setOverlay(overlay);
    QVERIFY(colourAt({0.4, 0.6}) != before);
    QCOMPARE(colourAt({9.6, 5.6}), other);
    QCOMPARE(overlay.heatOf(RegionId("c")), 1.0);
    QCOMPARE(overlay.heatOf(RegionId("r1")), 0.25);
    QCOMPARE(overlay.heatOf(RegionId("lib")), 0.0);
}

void MapTest::noMarkCoversAName() {
    const auto building = test::handMadeBuilding();
    const MapScene scene(building);
    const MapColours colours = MapColours::of(false);
    for (const double metre : {12.0, 30.0}) {
        const ViewTransform view({5.0, 3.0}, metre, {600, 400});
        const MapPainter painter(scene, 0.0, view, colours, QFont());
        const std::vector<PlacedName> names = painter.placedNames();
        QVERIFY(!names.empty());
        QVERIFY(painter.movedAside(names, {}).empty());
        for (const PlacedName& name : names) {
            MapOverlay overlay;
            overlay.fix.emplace();
            overlay.fix->region = building->regions().front().id;
            overlay.fix->level = 0.0;
            overlay.fix->position = view.mapFromScreen(name.box.center());
            const std::vector<PlacedName> moved = painter.movedAside(names, overlay);
            QVERIFY(!moved.empty());
            const QRectF mark(name.box.center() - QPointF(8, 8), QSizeF(16, 16));
            for (const PlacedName& each : moved) {
                QVERIFY2(each.overMark || !each.box.intersects(mark), qPrintable(each.text));
                for (const PlacedName& other : names) // it does not land on another one
                    QVERIFY(other.box == each.home || each.overMark || !other.box.intersects(each.box));
            }
            overlay.fix->position = view.mapFromScreen({-500, -500});
            QVERIFY(painter.movedAside(names, overlay).empty());
            overlay.fix->position = view.mapFromScreen(name.box.center());
            overlay.fix->level = 1.0;
            QVERIFY(painter.movedAside(names, overlay).empty());
        }
        // In a large room there is room beside the mark.
        MapOverlay overlay;
        overlay.fix.emplace();
        overlay.fix->region = RegionId("c");
        const std::vector<PlacedName> moved = painter.movedAside(names, overlay);
        if (metre > 20.0) QVERIFY(!moved.empty() && !moved.front().overMark);
    }
}

void MapTest::anEmptyMapIsPainted() {
    MapView map;
    map.resize(300, 200);
    QVERIFY(!map.grab().isNull());
    map.setBuilding(std::make_shared<const building::Building>(building::BuildingData{}));
    MapOverlay overlay;
    overlay.fix = test::handMadeSnapshot()->step.fix; // of another building
    overlay.destination = RegionId("nowhere");
    map.setOverlay(overlay);
    QVERIFY(!map.grab().isNull());
}

void MapTest::textIsReadableOnEveryTint_data() {
    QTest::addColumn<bool>("dark");
    QTest::newRow("light") << false;
    QTest::newRow("dark") << true;
}

void MapTest::textIsReadableOnEveryTint() {
    QFETCH(bool, dark);
    const MapColours colours = MapColours::of(dark);
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
        QVERIFY(contrast(colours.text, colours.heat(share)) >= 4.5);
    QVERIFY(contrast(colours.text, colours.outside) >= 4.5);
    for (const Kind kind : allKinds()) QVERIFY(contrast(kindColour(kind, dark), colours.floor) >= 4.5);
    QVERIFY(contrast(colours.fix, colours.floor) >= 3.0);
    QVERIFY(contrast(colours.route, colours.floor) >= 3.0);
    for (const Kind kind : allKinds()) QVERIFY(!pathOf(kind).isEmpty());
}

void MapTest::picturesAreCopied() {
    cv::Mat picture(2, 2, CV_8UC3, cv::Scalar(255, 0, 0)); // blue, green, red
    const QImage image = toQImage(picture);
    picture.setTo(cv::Scalar(0, 0, 255));
    QCOMPARE(image.pixelColor(1, 1), QColor(Qt::blue));
    QVERIFY(toQImage(cv::Mat()).isNull());
    QVERIFY(toQImage(cv::Mat(2, 2, CV_32F)).isNull());
    QCOMPARE(clockText(62.44), QStringLiteral("1:02.4"));
    QCOMPARE(clockText(-1), QStringLiteral("0:00.0"));
}

} // namespace farol::ui

QTEST_MAIN(farol::ui::MapTest)
#include "test_map.moc"
