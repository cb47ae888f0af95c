// Another program works on the map that is open here: QGIS's way (SQL in place, a log beside the file), an
// editor's way (another file under the same name), a second Farol. It is noticed, and nothing is lost on
// either side; nor is it where nothing can be written.

#include "core/building/geopackage.h"
#include "tests/ui/hand_made.h"
#include "ui/convert/convert.h"
#include "ui/curation/feature_panel.h"
#include "ui/curation/map_page.h"
#include "ui/curation/plan_panel.h"
#include "ui/main_window/main_window.h"
#include "ui/parts/banner.h"

#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <cstdio>
#include <sys/resource.h>

namespace farol::ui {

namespace {

constexpr int kPatience = 60000;
const QString kBanner = QStringLiteral("outside");

/// Another program, with what it printed.
QString run(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.start(program, arguments);
    if (!process.waitForFinished(kPatience)) return QStringLiteral("%1 does not run").arg(program);
    const QString out = QString::fromUtf8(process.readAllStandardOutput());
    return process.exitCode() == 0 ? out : out + QString::fromUtf8(process.readAllStandardError());
}

QString sql(const QString& file, const char* statement) {
    return run(QStringLiteral("ogrinfo"),
               {QStringLiteral("-q"), file, QStringLiteral("-sql"), QLatin1String(statement)});
}

/// The number of features that ogrinfo counts in a layer.
int counted(const QString& file, const char* layer) {
    const QString out = run(QStringLiteral("ogrinfo"), {QStringLiteral("-so"), file, QLatin1String(layer)});
    const qsizetype at = out.indexOf(QLatin1String("Feature Count: "));
    return at < 0 ? -1 : out.mid(at + 15).section(QLatin1Char('\n'), 0, 0).toInt();
}

} // namespace

class OutsideTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanup();
    void whatIsWrittenInPlaceIsOffered();
    void whatIsWrittenIntoTheLogIsOffered();
    void aFileUnderTheSameNameIsOffered();
    void ownChangesArePutAsideAndBroughtBack();
    void lookingIntoTheFileIsNoChange();
    void anothersWorkIsNotSavedOver();
    void twoFarolsOnOneMap();
    void aFileThatIsGoneIsWrittenAgain();
    void aFileThatIsNoMapAnyMoreIsTold();
    void aMapOfOtherToolsOpens();
    void whatIsSavedHereOpensThere();
    void nothingIsLostWhereNothingCanBeWritten();
    void nothingIsLostOnAFullDisk();
    void closingWhileSaving();
    void theWalkIsOfferedTheChangedMap();

private:
    void open(MapPage& page, const QString& file);
    std::unique_ptr<MapPage> makePage();
    const building::Building& map() const { return *m_page->document().building(); }
    std::string roomName(const QString& file) const;
    std::string roomName() const { return map().region(RegionId("r1"))->name; }
    void pressBanner(BannerStack& banners, const QString& text);
    void changeHere();
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::ControlModifier);
    QMessageBox* question() const { return qobject_cast<QMessageBox*>(QApplication::activeModalWidget()); }
    QString told(MapPage& page) const { return page.banners().text(kBanner); }

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_file;
    std::unique_ptr<Settings> m_settings;
    std::unique_ptr<MapPage> m_page;
};

void OutsideTest::initTestCase() {
    installTranslation(QStringLiteral("en"));
    std::signal(SIGXFSZ, SIG_IGN); // a write beyond the limit then fails as on a full disk
}

std::unique_ptr<MapPage> OutsideTest::makePage() {
    auto page = std::make_unique<MapPage>(*m_settings);
    page->resize(1200, 760);
    page->show();
    page->activateWindow();
    return page;
}

void OutsideTest::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    m_file = m_folder->filePath(QStringLiteral("house.gpkg"));
    QVERIFY(building::saveBuilding(*test::handMadeBuilding(), toUtf8(m_file)).ok());
    m_settings = std::make_unique<Settings>(m_folder->filePath(QStringLiteral("settings.ini")));
    m_page = makePage();
    QVERIFY(QTest::qWaitForWindowActive(m_page.get()));
    open(*m_page, m_file);
}

void OutsideTest::cleanup() {
    m_page.reset();
    m_settings.reset();
    m_folder.reset();
}

void OutsideTest::open(MapPage& page, const QString& file) {
    QSignalSpy opened(&page.document(), &MapDocument::opened);
    page.open(file);
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kPatience);
}

std::string OutsideTest::roomName(const QString& file) const {
    const auto read = building::loadBuilding(toUtf8(file));
    return read && read->building->region(RegionId("r1")) ? read->building->region(RegionId("r1"))->name
                                                          : std::string("unreadable");
}

void OutsideTest::pressBanner(BannerStack& banners, const QString& text) {
    QPushButton* found = nullptr;
    for (QPushButton* button : banners.findChildren<QPushButton*>())
        if (button->isVisible() && button->text() == text) found = button;
    QVERIFY2(found, qPrintable(text));
    QTest::mouseClick(found, Qt::LeftButton);
}

void OutsideTest::key(Qt::Key key, Qt::KeyboardModifiers modifiers) {
    m_page->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_page.get()));
    m_page->plan().view().setFocus();
    QTest::keyClick(&m_page->plan().view(), key, modifiers);
}

/// One landmark less.
void OutsideTest::changeHere() {
    m_page->plan().view().select(MapHit{MapHit::What::Landmark, 0}, true);
    key(Qt::Key_Delete, {});
    QCOMPARE(map().landmarks().size(), 1U);
    QVERIFY(m_page->document().unsaved());
}

void OutsideTest::whatIsWrittenInPlaceIsOffered() {
    sql(m_file, "UPDATE regions SET name = 'Reading room' WHERE region_id = 'r1'");
    QCOMPARE(roomName(m_file), std::string("Reading room"));
    QTRY_VERIFY_WITH_TIMEOUT(told(*m_page).contains(QLatin1String("Another program")), kPatience);
    QCOMPARE(roomName(), std::string("Room 1")); // what is looked at stays
    pressBanner(m_page->banners(), QStringLiteral("&Load it again"));
    QCOMPARE(roomName(), std::string("Reading room"));
    QVERIFY(!m_page->banners().shows(kBanner));
    QVERIFY(!m_page->document().unsaved());
    QTRY_VERIFY_WITH_TIMEOUT(m_page->settled(), kPatience);
    key(Qt::Key_Z);
    QCOMPARE(roomName(), std::string("Room 1"));
    QVERIFY(m_page->document().unsaved());
    key(Qt::Key_Y);
    QCOMPARE(roomName(), std::string("Reading room"));
    QVERIFY(!m_page->document().unsaved());
    sql(m_file, "DELETE FROM landmarks"); // and once more
    QTRY_VERIFY_WITH_TIMEOUT(m_page->banners().shows(kBanner), kPatience);
    pressBanner(m_page->banners(), QStringLiteral("&Load it again"));
    QVERIFY(map().landmarks().empty());
}

/// As QGIS does: it keeps the file open, and its changes stand in the log until it closes.
void OutsideTest::whatIsWrittenIntoTheLogIsOffered() {
    QProcess other;
    other.start(QStringLiteral("python3"),
                {QStringLiteral("-c"),
                 QStringLiteral("import sqlite3, sys\n"
                                "base = sqlite3.connect(sys.argv[1])\n"
                                "for name in ('ST_IsEmpty', 'ST_MinX', 'ST_MaxX', 'ST_MinY', "
                                "'ST_MaxY'): base.create_function(name, 1, lambda shape: 0)\n"
                                "base.execute('PRAGMA journal_mode = WAL')\n"
                                "base.execute(\"UPDATE regions SET name = 'Studio' WHERE region_id = "
                                "'r1'\")\n"
                                "base.commit()\n"
                                "print('written', flush=True)\n"
                                "sys.stdin.read()\n"
                                "base.close()\n"),
                 m_file});
    QVERIFY(other.waitForReadyRead(kPatience));
    QVERIFY(other.readAllStandardOutput().startsWith("written"));
    QTRY_VERIFY_WITH_TIMEOUT(m_page->banners().shows(kBanner), kPatience);
    pressBanner(m_page->banners(), QStringLiteral("&Load it again"));
    QCOMPARE(roomName(), std::string("Studio"));
    // It closes: the log goes into the file, which says the same as before.
    QSignalSpy same(&m_page->document(), &MapDocument::outsideSettled);
    other.closeWriteChannel();
    QVERIFY(other.waitForFinished(kPatience));
    QTRY_VERIFY_WITH_TIMEOUT(same.count() > 0, kPatience);
    QVERIFY(!m_page->banners().shows(kBanner));
}

void OutsideTest::aFileUnderTheSameNameIsOffered() {
    const QString next = m_folder->filePath(QStringLiteral("next.gpkg"));
    run(QStringLiteral("ogr2ogr"), {next, m_file});
    sql(next, "UPDATE regions SET name = 'Workshop' WHERE region_id = 'r1'");
    QCOMPARE(std::rename(toUtf8(next).c_str(), toUtf8(m_file).c_str()), 0);
    QTRY_VERIFY_WITH_TIMEOUT(m_page->banners().shows(kBanner), kPatience);
    pressBanner(m_page->banners(), QStringLiteral("&Load it again"));
    QCOMPARE(roomName(), std::string("Workshop"));
    QCOMPARE(map().accesses().size(), 5U);
    sql(m_file,
        "UPDATE regions SET name = 'Cellar' WHERE region_id = 'r1'"); // the new file is watched as well
    QTRY_VERIFY_WITH_TIMEOUT(m_page->banners().shows(kBanner), kPatience);
}

void OutsideTest::ownChangesArePutAsideAndBroughtBack() {
    changeHere();
    sql(m_file, "UPDATE regions SET name = 'Reading room' WHERE region_id = 'r1'");
    QTRY_VERIFY_WITH_TIMEOUT(told(*m_page).contains(QLatin1String("changes of your own")), kPatience);
    pressBanner(m_page->banners(), QStringLiteral("&Load it again"));
    QCOMPARE(map().landmarks().size(), 2U);
    QCOMPARE(roomName(), std::string("Reading room"));
    QTRY_VERIFY_WITH_TIMEOUT(m_page->settled(), kPatience);
    key(Qt::Key_Z);
    QCOMPARE(map().landmarks().size(), 1U);
    QCOMPARE(roomName(), std::string("Room 1"));
    key(Qt::Key_Z); // and the step before it
    QCOMPARE(map().landmarks().size(), 2U);
}

void OutsideTest::lookingIntoTheFileIsNoChange() {
    QSignalSpy same(&m_page->document(), &MapDocument::outsideSettled);
    sql(m_file, "PRAGMA journal_mode = WAL"); // all that opening it in QGIS writes
    QTRY_VERIFY_WITH_TIMEOUT(same.count() > 0, kPatience);
    QVERIFY(!m_page->banners().shows(kBanner));
    changeHere();
    QSignalSpy saved(&m_page->document(), &MapDocument::saved);
    key(Qt::Key_S);
    QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, kPatience);
    QVERIFY(!question());
}

void OutsideTest::anothersWorkIsNotSavedOver() {
    changeHere();
    sql(m_file, "UPDATE regions SET name = 'Reading room' WHERE region_id = 'r1'");
    key(Qt::Key_S); // at once, before anything was noticed
    QTRY_VERIFY_WITH_TIMEOUT(question(), kPatience);
    QTest::keyClick(question(), Qt::Key_Escape);
    QTRY_VERIFY(!question());
    QCOMPARE(roomName(m_file), std::string("Reading room"));
    QVERIFY(m_page->document().unsaved());
    key(Qt::Key_S);
    QTRY_VERIFY_WITH_TIMEOUT(question(), kPatience);
    for (QAbstractButton* button : question()->buttons())
        if (question()->buttonRole(button) == QMessageBox::DestructiveRole)
            QTest::mouseClick(button, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!m_page->document().unsaved(), kPatience);
    QCOMPARE(roomName(m_file), std::string("Room 1"));
    QCOMPARE(counted(m_file, "landmarks"), 1);
}

void OutsideTest::twoFarolsOnOneMap() {
    const std::unique_ptr<MapPage> second = makePage();
    open(*second, m_file);
    changeHere();
    QSignalSpy saved(&m_page->document(), &MapDocument::saved);
    key(Qt::Key_S);
    QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(told(*second).contains(QLatin1String("Another program")), kPatience);
    QVERIFY(!m_page->banners().shows(kBanner)); // one's own change is none
    pressBanner(second->banners(), QStringLiteral("&Load it again"));
    QCOMPARE(second->document().building()->landmarks().size(), 1U);
}

void OutsideTest::aFileThatIsGoneIsWrittenAgain() {
    QVERIFY(QFile::remove(m_file));
    QTRY_VERIFY_WITH_TIMEOUT(told(*m_page).contains(QLatin1String("no longer there")), kPatience);
    QVERIFY(m_page->document().unsaved()); // leaving asks
    QSignalSpy saved(&m_page->document(), &MapDocument::saved);
    key(Qt::Key_S);
    QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, kPatience);
    QCOMPARE(roomName(m_file), std::string("Room 1"));
    QVERIFY(!m_page->banners().shows(kBanner));
    QVERIFY(!m_page->document().unsaved());
}

void OutsideTest::aFileThatIsNoMapAnyMoreIsTold() {
    QFile file(m_file);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("this is no map");
    file.close();
    QTRY_VERIFY_WITH_TIMEOUT(told(*m_page).contains(QLatin1String("cannot be read")), kPatience);
    QCOMPARE(map().regions().size(), 6U);
    QVERIFY(m_page->document().unsaved());
    key(Qt::Key_S);
    QTRY_VERIFY_WITH_TIMEOUT(question(), kPatience); // not over it, unless one says so
    QTest::keyClick(question(), Qt::Key_Escape);
    QTRY_VERIFY(!question());
    m_page->document().save(m_folder->filePath(QStringLiteral("rescued.gpkg")));
    QTRY_VERIFY_WITH_TIMEOUT(!m_page->document().unsaved(), kPatience);
    QCOMPARE(roomName(m_folder->filePath(QStringLiteral("rescued.gpkg"))), std::string("Room 1"));
}

/// Fields of other kinds and more of them, other numbers of rows, other geometry types, no word on spatial
/// indexes: what tools leave behind.
void OutsideTest::aMapOfOtherToolsOpens() {
    const QString other = m_folder->filePath(QStringLiteral("other.gpkg"));
    run(QStringLiteral("ogr2ogr"),
        {QStringLiteral("-lco"), QStringLiteral("FID=row"), QStringLiteral("-lco"),
         QStringLiteral("GEOMETRY_NAME=shape"), QStringLiteral("-lco"), QStringLiteral("SPATIAL_INDEX=NO"),
         QStringLiteral("-nlt"), QStringLiteral("PROMOTE_TO_MULTI"), QStringLiteral("-mapFieldType"),
         QStringLiteral("Real=String,Integer=String"), QStringLiteral("-dim"), QStringLiteral("XYZ"), other,
         m_file});
    sql(other, "ALTER TABLE regions ADD COLUMN inspected TEXT");
    sql(other, "UPDATE regions SET inspected = 'yes', name = 'Reading room' WHERE region_id = 'r1'");
    sql(other, "UPDATE accesses SET width_m = '1.4' WHERE access_id = 'd1'");
    open(*m_page, other);
    QVERIFY(!m_page->document().imported());
    QCOMPARE(map().regions().size(), 6U);
    QCOMPARE(map().accesses().size(), 5U);
    QCOMPARE(map().landmarks().size(), 2U);
    QCOMPARE(m_page->plan().view().scene()->levels().size(), std::size_t{2});
    QCOMPARE(roomName(), std::string("Reading room"));
    QCOMPARE(map().access(AccessId("d1"))->widthM, std::optional(1.4));
    QVERIFY(map().areNeighbours(*map().regionIndex(RegionId("c")), *map().regionIndex(RegionId("r1"))));
    // The curator changes it, and what others know of it stays.
    changeHere();
    QSignalSpy saved(&m_page->document(), &MapDocument::saved);
    key(Qt::Key_S);
    QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, kPatience);
    QVERIFY(
        sql(other, "SELECT inspected FROM regions WHERE region_id = 'r1'").contains(QLatin1String("= yes")));
    QCOMPARE(counted(other, "landmarks"), 1);
}

void OutsideTest::whatIsSavedHereOpensThere() {
    changeHere();
    QSignalSpy saved(&m_page->document(), &MapDocument::saved);
    key(Qt::Key_S);
    QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, kPatience);
    QCOMPARE(counted(m_file, "regions"), static_cast<int>(map().regions().size()));
    QCOMPARE(counted(m_file, "accesses"), static_cast<int>(map().accesses().size()));
    QCOMPARE(counted(m_file, "landmarks"), static_cast<int>(map().landmarks().size()));
    QCOMPARE(counted(m_file, "levels"), static_cast<int>(map().levels().size()));
    QCOMPARE(counted(m_file, "walls"), static_cast<int>(map().data().walls.size()));
}

void OutsideTest::nothingIsLostWhereNothingCanBeWritten() {
    changeHere();
    QSignalSpy failed(&m_page->document(), &MapDocument::failed);
    m_page->document().save(QStringLiteral("/proc/house.gpkg"));
    QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(
        m_page->banners().text(QStringLiteral("failure")).contains(QLatin1String("/proc")), kPatience);
    QVERIFY(m_page->document().unsaved());
    QCOMPARE(m_page->document().path(), m_file);
    QSignalSpy saved(&m_page->document(), &MapDocument::saved);
    key(Qt::Key_S);
    QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, kPatience);
    QVERIFY(!m_page->banners().shows(QStringLiteral("failure")));
    QCOMPARE(counted(m_file, "landmarks"), 1);
}

void OutsideTest::nothingIsLostOnAFullDisk() {
    changeHere();
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    rlimit small = before;
    small.rlim_cur = 8192;
    setrlimit(RLIMIT_FSIZE, &small);
    QSignalSpy failed(&m_page->document(), &MapDocument::failed);
    key(Qt::Key_S);
    const bool came = QTest::qWaitFor([&] { return failed.count() > 0; }, kPatience);
    setrlimit(RLIMIT_FSIZE, &before);
    QVERIFY(came);
    const QString text = m_page->banners().text(QStringLiteral("failure"));
    QVERIFY2(text.contains(QLatin1String("house.gpkg")), qPrintable(text));
    QVERIFY(m_page->document().unsaved());
    QCOMPARE(counted(m_file, "landmarks"), 2); // the old file is whole
    QSignalSpy saved(&m_page->document(), &MapDocument::saved);
    key(Qt::Key_S);
    QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, kPatience);
    QCOMPARE(counted(m_file, "landmarks"), 1);
}

void OutsideTest::closingWhileSaving() {
    changeHere();
    key(Qt::Key_S);
    QCOMPARE(m_page->document().work(), MapDocument::Work::Saving);
    m_page.reset(); // waits for what is being written
    QCOMPARE(counted(m_file, "landmarks"), 1);
    QCOMPARE(roomName(m_file), std::string("Room 1"));
}

void OutsideTest::theWalkIsOfferedTheChangedMap() {
    m_page.reset();
    m_settings->setLanguage(QStringLiteral("en"));
    const auto grey = [](const std::string&,
                         const capture::SourceOptions&) -> Result<std::unique_ptr<capture::FrameSource>> {
        return std::unique_ptr<capture::FrameSource>(std::make_unique<test::FakeSource>(100000, 0.05));
    };
    MainWindow window(*m_settings, grey,
                      [](const VoiceChoice&) { return std::make_unique<test::FakeVoice>(); });
    window.show();
    StartOptions options;
    options.map = m_file;
    options.source = QStringLiteral("grey");
    options.to = QStringLiteral("Library");
    options.play = true;
    window.begin(options);
    QTRY_COMPARE_WITH_TIMEOUT(window.walk().state(), session::RunState::Running, kPatience);
    sql(m_file, "UPDATE regions SET name = 'Reading room' WHERE region_id = 'r1'");
    BannerStack& banners = window.page().banners();
    QTRY_VERIFY_WITH_TIMEOUT(banners.shows(QStringLiteral("map-changed")), kPatience);
    QCOMPARE(window.walk().building()->region(RegionId("r1"))->name, std::string("Room 1"));
    QCOMPARE(window.walk().state(), session::RunState::Running); // nobody is stopped on the way
    pressBanner(banners, QStringLiteral("Start &again with it"));
    QTRY_COMPARE_WITH_TIMEOUT(window.walk().building()->region(RegionId("r1"))->name,
                              std::string("Reading room"), kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(window.walk().state(), session::RunState::Running, kPatience);
    QCOMPARE(window.walk().destination(), std::optional(RegionId("lib"))); // still the same way
    QVERIFY(!banners.shows(QStringLiteral("map-changed")));
}

} // namespace farol::ui

QTEST_MAIN(farol::ui::OutsideTest)
#include "test_outside.moc"
