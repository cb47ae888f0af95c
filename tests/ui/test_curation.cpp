// The Map page, driven by keys and the pointer: open, import, look, choose, route, change, undo, save,
// reopen.

#include "core/building/geopackage.h"
#include "tests/ui/hand_made.h"
#include "ui/convert/convert.h"
#include "ui/curation/feature_dialogs.h"
#include "ui/curation/feature_panel.h"
#include "ui/curation/import_dialog.h"
#include "ui/curation/map_actions.h"
#include "ui/curation/map_page.h"
#include "ui/curation/plan_panel.h"
#include "ui/curation/plan_print.h"
#include "ui/curation/report_panel.h"
#include "ui/curation/route_panel.h"
#include "ui/models/rule_words.h"
#include "ui/parts/banner.h"
#include "ui/parts/place_chooser.h"

#include <QAbstractItemModelTester>
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QCompleter>
#include <QDir>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>

#include <set>

namespace farol::ui {

class CurationTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanup();
    void aMapIsOpened();
    void keysSwitchTheLevel();
    void planAndTableChooseTheSame();
    void theTableIsSearched();
    void aRouteIsChosenByTyping();
    void aRouteThatDoesNotExistIsToldWhy();
    void aLandmarkIsAddedByKeys();
    void aLandmarkIsDraggedInOneStep();
    void keysMoveInOneStep();
    void aDoorIsAddedByTheMouse();
    void aDragIsGivenUp();
    void deletingIsUndone();
    void aNameIsChangedSavedAndReopened();
    void senselessChangesAreRefused();
    void unsavedChangesAreAskedFor();
    void aMapIsImportedAndItsReportShown();
    void importingIsCancelled();
    void whatIsNoMapIsTold();
    void findingsLeadToTheirFeatures();
    void placesThatLookAlikeAreMarked();
    void thePlanIsPrinted();
    void everyRuleHasWords();
    void anEmptyPageStandsStill();
    void largeFloorsAreDrawnAside();

private:
    void open(const QString& path);
    const building::Building& map() const { return *m_page->document().building(); }
    QPoint onScreen(Point2 at) const;
    void choosePlace(PlaceChooser& chooser, const QString& typed);
    template <class Dialog>
    Dialog* dialog() const {
        return qobject_cast<Dialog*>(QApplication::activeModalWidget());
    }
    QString house(const char* name);

    QTemporaryDir m_folder;
    QString m_file;
    std::unique_ptr<Settings> m_settings;
    std::unique_ptr<MapPage> m_page;
};

QString CurationTest::house(const char* name) {
    const QString path = m_folder.filePath(QLatin1String(name));
    if (!building::saveBuilding(*test::handMadeBuilding(), toUtf8(path)).ok()) return {};
    return path;
}

void CurationTest::initTestCase() {
    QVERIFY(m_folder.isValid());
    // A house in words, as any editor may write it.
    QFile file(m_folder.filePath(QStringLiteral("rooms.geojson")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(R"({"type":"FeatureCollection","features":[
      {"type":"Feature","properties":{"id":"k","name":"Kitchen","level":"0","indoor":"room"},
       "geometry":{"type":"Polygon","coordinates":[[[-7.9,37.0],[-7.8999,37.0],[-7.8999,37.0001],[-7.9,37.0001],[-7.9,37.0]]]}},
      {"type":"Feature","properties":{"id":"p","name":"Pantry","level":"0","indoor":"room"},
       "geometry":{"type":"Polygon","coordinates":[[[-7.8999,37.0],[-7.8998,37.0],[-7.8998,37.0001],[-7.8999,37.0001],[-7.8999,37.0]]]}}]})");
}

void CurationTest::init() {
    m_settings = std::make_unique<Settings>(m_folder.filePath(QStringLiteral("settings.ini")));
    m_page = std::make_unique<MapPage>(*m_settings);
    m_page->resize(1200, 760);
    m_page->show();
    m_page->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_page.get()));
    m_file = house("house.gpkg");
    QVERIFY(!m_file.isEmpty());
}

void CurationTest::cleanup() {
    m_page.reset();
    m_settings.reset();
}

void CurationTest::open(const QString& path) {
    QSignalSpy opened(&m_page->document(), &MapDocument::opened);
    m_page->open(path);
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, 60000);
}

QPoint CurationTest::onScreen(Point2 at) const {
    return m_page->plan().view().viewTransform().screenFromMap(at).toPoint();
}

void CurationTest::choosePlace(PlaceChooser& chooser, const QString& typed) {
    QLineEdit& edit = chooser.edit();
    edit.setFocus();
    edit.clear();
    QTest::keyClicks(&edit, typed);
    edit.completer()->popup()->hide(); // whose grab of the keyboard this platform lacks
    QTest::keyClick(&edit, Qt::Key_Return);
}

void CurationTest::aMapIsOpened() {
    open(m_file);
    QCOMPARE(map().regions().size(), 6U);
    QCOMPARE(m_page->features().model().rowCount(), 6);
    QCOMPARE(m_page->plan().levels().count(), 2);
    QVERIFY(!m_page->document().unsaved());
    QVERIFY(m_page->plan().whatText().contains(QLatin1String("4")));
    QCOMPARE(m_settings->recent(RecentKind::Map).first(), m_file);
    QVERIFY(!m_page->plan().view().grab().isNull());
}

void CurationTest::keysSwitchTheLevel() {
    open(m_file);
    MapView& view = m_page->plan().view();
    QCOMPARE(view.level(), 0.0);
    QTest::keyClick(&view, Qt::Key_PageUp);
    QCOMPARE(view.level(), 1.0);
    QCOMPARE(m_page->plan().levels().currentData().toDouble(), 1.0);
    QTest::keyClick(&view, Qt::Key_PageUp); // there is no higher one
    QCOMPARE(view.level(), 1.0);
    m_page->features().levelOnly().setChecked(true);
    QCOMPARE(m_page->features().table().model()->rowCount(), 2);
    QTest::keyClick(&view, Qt::Key_PageDown);
    QCOMPARE(m_page->features().table().model()->rowCount(), 4);
}

void CurationTest::planAndTableChooseTheSame() {
    open(m_file);
    MapView& view = m_page->plan().view();
    QTest::mouseClick(&view, Qt::LeftButton, {}, onScreen({1.0, 5.0})); // Room 1
    QVERIFY(view.selected());
    QCOMPARE(map().regions()[view.selected()->index].id, RegionId("r1"));
    QCOMPARE(m_page->features().selected(), view.selected());
    QTest::mouseClick(&view, Qt::LeftButton, {}, onScreen({4.0, 0.2})); // the extinguisher
    QCOMPARE(view.selected()->what, MapHit::What::Landmark);
    QCOMPARE(m_page->features().sort().currentIndex(), 2);
    QCOMPARE(m_page->features().selected(), view.selected());
    m_page->features().sort().setCurrentIndex(0);
    QTableView& table = m_page->features().table();
    table.setFocus();
    for (int row = 0; row < table.model()->rowCount(); ++row) { // the library is upstairs: the plan follows
        table.selectRow(row);
        QCOMPARE(view.selected(), m_page->features().selected());
        QCOMPARE(view.level(), map().regions()[view.selected()->index].level);
    }
}

void CurationTest::theTableIsSearched() {
    open(m_file);
    m_page->plan().view().setFocus();
    QTest::keyClick(&m_page->plan().view(), Qt::Key_F, Qt::ControlModifier);
    QLineEdit& search = m_page->features().search();
    QCOMPARE(QApplication::focusWidget(), &search);
    QTest::keyClicks(&search, QStringLiteral("cafe")); // without its accent
    QCOMPARE(m_page->features().table().model()->rowCount(), 1);
    QTest::keyClick(&search, Qt::Key_Return);
    QCOMPARE(QApplication::focusWidget(), &m_page->features().table());
    QCOMPARE(map().regions()[m_page->plan().view().selected()->index].id, RegionId("r2"));
}

void CurationTest::aRouteIsChosenByTyping() {
    open(m_file);
    m_page->tabs().setCurrentWidget(&m_page->route());
    RoutePanel& route = m_page->route();
    QSignalSpy changed(&route, &RoutePanel::routeChanged);
    choosePlace(route.from(), QStringLiteral("Room 1"));
    choosePlace(route.to(), QStringLiteral("Library"));
    QTRY_VERIFY_WITH_TIMEOUT(route.model().route() != nullptr, 60000);
    QVERIFY(route.model().rowCount() >= 4);
    QStringList sentences;
    for (int row = 0; row < route.model().rowCount(); ++row)
        sentences << route.model().index(row, RouteModel::Sentence).data().toString();
    QVERIFY2(sentences.join(QLatin1Char('|')).contains(QLatin1String("stairs")),
             qPrintable(sentences.join(QLatin1Char('|'))));
    for (const QString& sentence : sentences) QVERIFY(!sentence.isEmpty());
    QVERIFY(m_page->plan().view().overlay().route != nullptr);
    route.table().selectRow(route.model().rowCount() - 1); // where it ends: upstairs
    QCOMPARE(m_page->plan().view().level(), 1.0);
}

void CurationTest::aRouteThatDoesNotExistIsToldWhy() {
    open(m_file);
    RoutePanel& route = m_page->route();
    m_page->tabs().setCurrentWidget(&route);
    route.setFrom(RegionId("r1"));
    route.avoidStairs().setChecked(true);
    route.setTo(RegionId("lib"));
    QTRY_VERIFY_WITH_TIMEOUT(!route.planning(), 60000);
    QVERIFY(!route.model().route());
    QVERIFY2(route.summary().contains(QLatin1String("stairs")), qPrintable(route.summary()));
}

void CurationTest::aLandmarkIsAddedByKeys() {
    open(m_file);
    MapView& view = m_page->plan().view();
    view.setFocus();
    QTest::keyClick(&view, Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(view.tool(), MapView::Tool::Place);
    QTest::keyClick(&view, Qt::Key_Return); // under the cross, in the middle of the plan
    QTRY_VERIFY(dialog<LandmarkDialog>());
    auto* form = dialog<LandmarkDialog>();
    QVERIFY(form->findChild<QLineEdit*>());
    form->findChild<QLineEdit*>()->setFocus();
    QTest::keyClicks(form->findChild<QLineEdit*>(), QStringLiteral("EXIT"));
    QTest::keyClick(form, Qt::Key_Return);
    QTRY_COMPARE(map().landmarks().size(), 3U);
    const building::Landmark& landmark = map().landmarks().back();
    QCOMPARE(landmark.text, std::string("EXIT"));
    QVERIFY(map().region(landmark.region) != nullptr);
    QCOMPARE(view.selected(), (MapHit{MapHit::What::Landmark, 2}));
    QVERIFY(m_page->document().unsaved());
    QTest::keyClick(&view, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(map().landmarks().size(), 2U);
    QVERIFY(!m_page->document().unsaved());
    QTest::keyClick(&view, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(map().landmarks().size(), 3U);
}

void CurationTest::aLandmarkIsDraggedInOneStep() {
    open(m_file);
    MapView& view = m_page->plan().view();
    const QPoint from = onScreen({4.0, 0.2});
    const QPoint to = onScreen({2.0, 4.0}); // into Room 1
    QTest::mouseClick(&view, Qt::LeftButton, {}, from);
    QTest::mousePress(&view, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 10; ++i) QTest::mouseMove(&view, from + (to - from) * i / 10);
    QTest::mouseRelease(&view, Qt::LeftButton, {}, to);
    QCOMPARE(m_page->document().undoStack().count(), 1);
    const building::Landmark& landmark = map().landmarks()[0];
    QCOMPARE(landmark.region, RegionId("r1"));
    QVERIFY(distance(landmark.position, {2.0, 4.0}) < 0.2);
    m_page->actions().undo->trigger();
    QCOMPARE(map().landmarks()[0].position, (Point2{4.0, 0.2}));
    QCOMPARE(map().landmarks()[0].region, RegionId("c"));
}

void CurationTest::keysMoveInOneStep() {
    open(m_file);
    MapView& view = m_page->plan().view();
    view.select(MapHit{MapHit::What::Landmark, 0}, true);
    view.setFocus();
    for (int i = 0; i < 3; ++i) QTest::keyClick(&view, Qt::Key_Right, Qt::AltModifier);
    QVERIFY(distance(map().landmarks()[0].position, {4.3, 0.2}) < 1e-9);
    QTest::keyClick(&view, Qt::Key_Up, Qt::AltModifier | Qt::ShiftModifier);
    QVERIFY(distance(map().landmarks()[0].position, {4.3, 1.2}) < 1e-9);
    QCOMPARE(m_page->document().undoStack().count(), 1);
    m_page->actions().undo->trigger();
    QCOMPARE(map().landmarks()[0].position, (Point2{4.0, 0.2}));
}

void CurationTest::aDoorIsAddedByTheMouse() {
    open(m_file);
    MapView& view = m_page->plan().view();
    m_page->actions().addAccess->trigger();
    QTest::mouseClick(&view, Qt::LeftButton, {},
                      onScreen({5.0, 4.0})); // the wall between Room 1 and the Café
    QTRY_VERIFY(dialog<AccessDialog>());
    QTest::keyClick(dialog<AccessDialog>(), Qt::Key_Return);
    QTRY_COMPARE(map().accesses().size(), 6U);
    const building::Access& door = map().accesses().back();
    QCOMPARE(std::set({door.regionA, door.regionB}), std::set({RegionId("r1"), RegionId("r2")}));
    m_page->actions().addAccess->trigger();
    QTest::keyClick(&view, Qt::Key_Escape); // given up
    QCOMPARE(view.tool(), MapView::Tool::Move);
    QCOMPARE(map().accesses().size(), 6U);
}

void CurationTest::aDragIsGivenUp() {
    open(m_file);
    MapView& view = m_page->plan().view();
    const QPoint from = onScreen({4.0, 0.2});
    QTest::mouseClick(&view, Qt::LeftButton, {}, from);
    QTest::mousePress(&view, Qt::LeftButton, {}, from);
    QTest::mouseMove(&view, from + QPoint(60, -60));
    QTest::keyClick(&view, Qt::Key_Escape);
    QTest::mouseRelease(&view, Qt::LeftButton, {}, from + QPoint(60, -60));
    QVERIFY(!m_page->document().unsaved());
    QCOMPARE(map().landmarks()[0].position, (Point2{4.0, 0.2}));
}

void CurationTest::deletingIsUndone() {
    open(m_file);
    MapView& view = m_page->plan().view();
    QTest::mouseClick(&view, Qt::LeftButton, {}, onScreen({2.5, 2.0})); // the door of Room 1
    QCOMPARE(view.selected()->what, MapHit::What::Access);
    QTest::keyClick(&view, Qt::Key_Delete);
    QCOMPARE(map().accesses().size(), 4U);
    QVERIFY(!view.selected());
    QVERIFY(m_page->plan().whatText().contains(QLatin1String("Room 1")));
    QTest::keyClick(&view, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(map().accesses().size(), 5U);
    QCOMPARE(map().accesses()[view.selected()->index].id, AccessId("d1"));
    view.select(MapHit{MapHit::What::Region, 0}, false);
    QVERIFY(!m_page->actions().remove->isEnabled()); // regions are not deleted here
}

void CurationTest::aNameIsChangedSavedAndReopened() {
    open(m_file);
    QTableView& table = m_page->features().table();
    table.setFocus();
    m_page->plan().view().select(MapHit{MapHit::What::Region, *map().regionIndex(RegionId("r1"))}, true);
    QTest::keyClick(&m_page->plan().view(), Qt::Key_F2);
    QTRY_VERIFY(dialog<RegionDialog>());
    auto* name = dialog<RegionDialog>()->findChild<QLineEdit*>();
    name->setFocus();
    name->selectAll();
    QTest::keyClicks(name, QStringLiteral("Reading room"));
    QTest::keyClick(dialog<RegionDialog>(), Qt::Key_Return);
    QTRY_COMPARE(map().region(RegionId("r1"))->name, std::string("Reading room"));
    QSignalSpy saved(&m_page->document(), &MapDocument::saved);
    QTest::keyClick(&m_page->plan().view(), Qt::Key_S, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, 60000);
    QVERIFY(!m_page->document().unsaved());
    const auto read = building::loadBuilding(toUtf8(m_file));
    QVERIFY(read.ok());
    QCOMPARE(read->building->region(RegionId("r1"))->name, std::string("Reading room"));
    open(m_file);
    QCOMPARE(map().region(RegionId("r1"))->name, std::string("Reading room"));
}

void CurationTest::senselessChangesAreRefused() {
    open(m_file);
    building::Access door = map().accesses()[0];
    door.regionB = door.regionA;
    QVERIFY(!m_page->document().push(building::change(map(), 0, door), QStringLiteral("x")));
    QVERIFY(m_page->banners().text(QStringLiteral("refused")).contains(QLatin1String("same region")));
    QVERIFY(!m_page->document().unsaved());
}

void CurationTest::unsavedChangesAreAskedFor() {
    open(m_file);
    MapView& view = m_page->plan().view();
    view.select(MapHit{MapHit::What::Landmark, 0}, true);
    QTest::keyClick(&view, Qt::Key_Delete);
    bool left = false;
    m_page->whenSaved([&] { left = true; });
    QTRY_VERIFY(dialog<QMessageBox>());
    QTest::keyClick(dialog<QMessageBox>(), Qt::Key_Escape); // stays
    QTRY_VERIFY(!dialog<QMessageBox>());
    QVERIFY(!left);
    QVERIFY(m_page->document().unsaved());
    m_page->whenSaved([&] { left = true; });
    QTRY_VERIFY(dialog<QMessageBox>());
    QTest::keyClick(dialog<QMessageBox>()->button(QMessageBox::Save), Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(left, 60000);
    QVERIFY(!m_page->document().unsaved());
    QCOMPARE(building::loadBuilding(toUtf8(m_file))->building->landmarks().size(), 1U);
    left = false;
    m_page->whenSaved([&] { left = true; }); // nothing to ask
    QVERIFY(left);
}

void CurationTest::aMapIsImportedAndItsReportShown() {
    m_page->actions().import->trigger();
    QTRY_VERIFY(dialog<ImportDialog>());
    auto* form = dialog<ImportDialog>();
    QTest::keyClicks(&form->path(), m_folder.filePath(QStringLiteral("rooms.geojson")));
    QSignalSpy opened(&m_page->document(), &MapDocument::opened);
    QTest::keyClick(&form->path(), Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, 60000);
    QCOMPARE(map().regions().size(), 2U);
    QVERIFY(m_page->document().imported());
    QVERIFY(m_page->document().unsaved()); // nothing was written yet
    QCOMPARE(m_page->tabs().currentWidget(), &m_page->report());
    QVERIFY(m_page->report().model().rowCount() > 0);
    QVERIFY(m_page->banners().shows(QStringLiteral("imported")));
    const QString file = m_folder.filePath(QStringLiteral("rooms.gpkg"));
    QSignalSpy saved(&m_page->document(), &MapDocument::saved);
    m_page->document().save(file);
    QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, 60000);
    QCOMPARE(building::loadBuilding(toUtf8(file))->building->regions().size(), 2U);
    QVERIFY(!m_page->banners().shows(QStringLiteral("imported")));
}

void CurationTest::importingIsCancelled() {
    open(m_file);
    QSignalSpy opened(&m_page->document(), &MapDocument::opened);
    m_page->open(m_folder.filePath(QStringLiteral("rooms.geojson")));
    QVERIFY(m_page->cancel().isVisible());
    QTest::mouseClick(&m_page->cancel(), Qt::LeftButton);
    QCOMPARE(m_page->document().work(), MapDocument::Work::None);
    open(m_file); // comes after the one given up, on the same threads
    QCOMPARE(opened.count(), 1);
    QCOMPARE(map().regions().size(), 6U);
}

void CurationTest::whatIsNoMapIsTold() {
    open(m_file);
    QFile junk(m_folder.filePath(QStringLiteral("junk.gpkg")));
    QVERIFY(junk.open(QIODevice::WriteOnly));
    junk.write("this is no map");
    junk.close();
    QSignalSpy failed(&m_page->document(), &MapDocument::failed);
    m_page->open(junk.fileName());
    QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, 60000);
    QVERIFY(m_page->banners().text(QStringLiteral("failure")).contains(QLatin1String("junk.gpkg")));
    QCOMPARE(map().regions().size(), 6U); // what was open stays
    m_page->open(m_folder.filePath(QStringLiteral("absent.gpkg")));
    QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 2, 60000);
}

void CurationTest::findingsLeadToTheirFeatures() {
    building::BuildingData data = test::handMadeBuilding()->data();
    data.landmarks[0].position = {30.0, 30.0}; // outside its region
    const QString file = m_folder.filePath(QStringLiteral("wrong.gpkg"));
    QVERIFY(building::saveBuilding(building::Building(std::move(data)), toUtf8(file)).ok());
    open(file);
    ReportPanel& report = m_page->report();
    m_page->tabs().setCurrentWidget(&report);
    QAbstractItemModelTester tester(const_cast<FindingModel*>(&report.model()));
    const FindingModel& model = report.model();
    QModelIndex found;
    for (int branch = 0; branch < model.rowCount(); ++branch) {
        const QModelIndex index = model.index(0, 0, model.index(branch, 0));
        if (model.findingAt(index)->rule == "landmark-inside-region") found = index;
    }
    QVERIFY(found.isValid());
    report.tree().setCurrentIndex(found);
    QCOMPARE(m_page->plan().view().selected(), (MapHit{MapHit::What::Landmark, 0}));
    QVERIFY(report.explanation().contains(QLatin1String("Move the landmark")));
    const int before = model.rowCount();
    m_page->plan().view().setFocus();
    QTest::keyClick(&m_page->plan().view(), Qt::Key_Delete); // that mends it
    QVERIFY(report.summary().contains(QLatin1String("changed")));
    QTest::keyClick(&m_page->plan().view(), Qt::Key_F7);
    QTRY_VERIFY_WITH_TIMEOUT(m_page->document().findingsHold(), 60000);
    QCOMPARE(model.rowCount(), before - 1);
}

void CurationTest::placesThatLookAlikeAreMarked() {
    open(m_file);
    m_page->plan().view().setFocus();
    QTest::keyClick(&m_page->plan().view(), Qt::Key_U, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(m_page->plan().view().overlay().marks != nullptr, 60000);
    const auto& marks = *m_page->plan().view().overlay().marks;
    QCOMPARE(marks.size(), map().regions().size());
    QVERIFY(marks[*map().regionIndex(RegionId("r1"))] != RegionMark::None); // it has no landmark
    QCOMPARE(marks[*map().regionIndex(RegionId("c"))], RegionMark::None);
    m_page->actions().ambiguity->trigger();
    QVERIFY(!m_page->plan().view().overlay().marks);
}

void CurationTest::thePlanIsPrinted() {
    const QString file = m_folder.filePath(QStringLiteral("plan.pdf"));
    QVERIFY(printPlan(test::handMadeBuilding(), {}, file));
    QFile pdf(file);
    QVERIFY(pdf.open(QIODevice::ReadOnly));
    const QByteArray bytes = pdf.readAll();
    QVERIFY(bytes.startsWith("%PDF"));
    static const QRegularExpression page(QStringLiteral("/Type\\s*/Page\\b(?!s)"));
    QCOMPARE(QString::fromLatin1(bytes).count(page), 2); // one for each level
    QVERIFY(!printPlan(test::handMadeBuilding(), {}, m_folder.filePath(QStringLiteral("no/such/plan.pdf"))));
}

void CurationTest::everyRuleHasWords() {
    // The rules that core tells of stand in its sources, as the word behind the severity.
    static const QRegularExpression rule(
        QStringLiteral("Severity::(?:Error|Warning|Note),\\s*\"([a-z0-9]+(?:-[a-z0-9]+)+)\""));
    QDir core(QStringLiteral(FAROL_SOURCE_DIR "/core/building"));
    int count = 0;
    for (const QString& folder : {core.path(), core.filePath(QStringLiteral("import"))})
        for (const QFileInfo& info : QDir(folder).entryInfoList({QStringLiteral("*.cpp")})) {
            QFile source(info.filePath());
            QVERIFY(source.open(QIODevice::ReadOnly));
            auto matches = rule.globalMatch(QString::fromUtf8(source.readAll()));
            while (matches.hasNext()) {
                const QString name = matches.next().captured(1);
                QVERIFY2(RuleWords::knows(toUtf8(name)), qPrintable(name));
                ++count;
            }
        }
    QVERIFY(count > 50);
    QVERIFY(!RuleWords::title("a-rule-of-tomorrow").isEmpty());
}

void CurationTest::anEmptyPageStandsStill() {
    QVERIFY(!m_page->grab().isNull());
    QTest::keyClick(&m_page->plan().view(), Qt::Key_PageUp);
    QTest::keyClick(&m_page->plan().view(), Qt::Key_Delete);
    QTest::keyClick(&m_page->plan().view(), Qt::Key_F7);
    QTest::mouseClick(&m_page->plan().view(), Qt::LeftButton);
    m_page->report().showNext();
    QVERIFY(!m_page->document().building());
    QVERIFY(!m_page->document().unsaved());
}

void CurationTest::largeFloorsAreDrawnAside() {
    building::BuildingData data;
    data.levels = {{0.0, "Ground", "0", {}, {}, {}}};
    for (int i = 0; i < 10000; ++i) {
        building::Region region;
        region.id = RegionId("r" + std::to_string(i));
        region.name = "Room " + std::to_string(i);
        const double x = (i % 100) * 5.0;
        const double y = (i / 100) * 5.0;
        region.polygon.outer = {{x, y}, {x + 5, y}, {x + 5, y + 5}, {x, y + 5}};
        data.regions.push_back(std::move(region));
    }
    MapView view;
    view.resize(900, 700);
    view.show();
    view.setBuilding(std::make_shared<const building::Building>(std::move(data)));
    QTRY_VERIFY_WITH_TIMEOUT(view.settled(), 60000);
    const QImage whole = view.grab().toImage();
    QTest::keyClick(&view, Qt::Key_Right);
    QVERIFY(!view.settled()); // the old picture is shown moved meanwhile
    QVERIFY(!view.grab().isNull());
    QTRY_VERIFY_WITH_TIMEOUT(view.settled(), 60000);
    QVERIFY(view.grab().toImage() != whole);
    const auto hit =
        hitAt(view.viewTransform().screenFromMap({2.5, 2.5}), *view.scene(), 0.0, view.viewTransform());
    QCOMPARE(hit, (MapHit{MapHit::What::Region, 0}));
}

} // namespace farol::ui

QTEST_MAIN(farol::ui::CurationTest)
#include "test_curation.moc"
