// The sighted assistant's job on the whole window: see why a place was chosen, correct it, say something,
// look back, save what was seen, and work a recorded walk out anew.

#include "core/building/geopackage.h"
#include "tests/ui/hand_made.h"
#include "ui/convert/convert.h"
#include "ui/live/frame_panel.h"
#include "ui/live/map_panel.h"
#include "ui/live/revote_dialog.h"
#include "ui/live/timeline_bar.h"
#include "ui/main_window/figures_dialog.h"
#include "ui/main_window/main_window.h"
#include "ui/parts/banner.h"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QInputDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTableView>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

namespace farol::ui {

namespace {

constexpr int kPatience = 60000;

std::shared_ptr<const session::Snapshot> at(double time, const char* region, double confidence) {
    auto snapshot = std::make_shared<session::Snapshot>(*test::handMadeSnapshot());
    snapshot->step.percept.time = time;
    snapshot->step.fix.time = time;
    snapshot->step.fix.region = RegionId(region);
    snapshot->step.fix.confidence = confidence;
    return snapshot;
}

} // namespace

class SuperviseTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanup();
    void theVoteIsExplained();
    void aWrongPlaceIsCorrected();
    void aWrongPlaceIsCorrectedAtOnce();
    void theAssistantsWordAndThePictures();
    void aTypedSentenceIsSaid();
    void theTimelineLooksBack();
    void aLongWalkTakesNoMoreMemory();
    void pictureAndTableAreSaved();
    void figuresAreDrawnAndSaved();
    void figuresWithoutMaterialSayWhatToDo();
    void aRecordedWalkIsWorkedOutAnew();
    void aFolderThatIsNoRecordingIsTold();
    void testsLeaveTheirUserAlone();

private:
    void key(int key, Qt::KeyboardModifiers modifiers = Qt::ControlModifier);
    void begin(int frames);

    QTemporaryDir m_folder;
    QString m_map;
    std::unique_ptr<Settings> m_settings;
    std::unique_ptr<MainWindow> m_window;
};

void SuperviseTest::initTestCase() {
    m_map = m_folder.filePath(QStringLiteral("house.gpkg"));
    QVERIFY(building::saveBuilding(*test::handMadeBuilding(), toUtf8(m_map)).ok());
}

void SuperviseTest::init() {
    QFile::remove(m_folder.filePath(QStringLiteral("settings.ini")));
    m_settings = std::make_unique<Settings>(m_folder.filePath(QStringLiteral("settings.ini")));
    m_settings->setLanguage(QStringLiteral("en"));
    m_settings->setRecordingFolder(m_folder.path());
    MainWindow::applyLanguage(*m_settings);
}

void SuperviseTest::cleanup() {
    m_window.reset();
    m_settings.reset();
}

void SuperviseTest::begin(int frames) {
    const auto open =
        [frames](const std::string&,
                 const capture::SourceOptions&) -> Result<std::unique_ptr<capture::FrameSource>> {
        return std::unique_ptr<capture::FrameSource>(
            std::make_unique<test::FakeSource>(static_cast<std::uint64_t>(frames), 0.3));
    };
    m_window = std::make_unique<MainWindow>(
        *m_settings, open, [](const VoiceChoice&) { return std::make_unique<test::FakeVoice>(); });
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    StartOptions options;
    options.map = m_map;
    options.source = QStringLiteral("grey");
    m_window->begin(options);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->walk().building(), kPatience);
}

void SuperviseTest::key(int key, Qt::KeyboardModifiers modifiers) {
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    QTest::keyClick(m_window.get(), static_cast<Qt::Key>(key), modifiers);
}

void SuperviseTest::theVoteIsExplained() {
    begin(1);
    LivePage& page = m_window->page();
    page.show(test::handMadeSnapshot());
    const VoteDetailModel& detail = page.voteDetail();
    const auto column = [&](int which) {
        QStringList texts;
        for (int row = 0; row < detail.rowCount(); ++row) texts << detail.index(row, which).data().toString();
        return texts;
    };
    QVERIFY(column(VoteDetailModel::What).contains(QStringLiteral("Pmaxobj")));
    QVERIFY(column(VoteDetailModel::Figure).contains(QStringLiteral("3.00")));
    QVERIFY(column(VoteDetailModel::What).contains(QStringLiteral("speaks for it")));
    // Another place of the list, by key: its own terms, also when the next picture comes.
    auto* votes = qobject_cast<QTableView*>(page.tables()[1]);
    QVERIFY(votes);
    votes->setFocus();
    votes->selectRow(0);
    QTest::keyClick(votes, Qt::Key_Down);
    QVERIFY(column(VoteDetailModel::What).contains(QStringLiteral("Ppos")));
    page.show(test::handMadeSnapshot());
    QVERIFY(column(VoteDetailModel::What).contains(QStringLiteral("Ppos")));
    QVERIFY(column(VoteDetailModel::Meaning)
                .contains(QStringLiteral("none of the objects last seen stands there")));
    QCOMPARE(page.chosenRegion(), RegionId("r1"));
}

void SuperviseTest::aWrongPlaceIsCorrected() {
    begin(400);
    LivePage& page = m_window->page();
    key(Qt::Key_H);
    QVERIFY(page.banners().text(QStringLiteral("corrected")).contains(QLatin1String("no walk")));
    key(Qt::Key_F5, {});
    QTRY_VERIFY_WITH_TIMEOUT(m_window->walk().snapshot() && page.framesShown() > 0, kPatience);
    key(Qt::Key_H);
    QVERIFY(page.banners().text(QStringLiteral("corrected")).contains(QLatin1String("Choose a place")));
    const auto& regions = m_window->walk().building()->regions();
    for (std::size_t i = 0; i < regions.size(); ++i)
        if (regions[i].id == RegionId("r1"))
            page.mapPanel().view().select(MapHit{MapHit::What::Region, i}, true);
    key(Qt::Key_H);
    QVERIFY(page.banners().text(QStringLiteral("corrected")).contains(QLatin1String("Room 1")));
    QTRY_COMPARE_WITH_TIMEOUT(m_window->walk().snapshot()->step.fix.region, std::optional(RegionId("r1")),
                              kPatience);
    QVERIFY(page.mapPanel().whereText().contains(QLatin1String("Room 1")));
    QVERIFY(!m_window->walk().start()); // the next walk begins as before
    key(Qt::Key_W);
    QTRY_VERIFY_WITH_TIMEOUT(!m_window->walk().snapshot()->step.fix.region, kPatience);
}

/// However seldom pictures come: here none comes any more.
void SuperviseTest::aWrongPlaceIsCorrectedAtOnce() {
    begin(400);
    LivePage& page = m_window->page();
    key(Qt::Key_F5, {});
    QTRY_VERIFY_WITH_TIMEOUT(m_window->walk().snapshot() && page.framesShown() > 0, kPatience);
    key(Qt::Key_F5, {});
    QTRY_COMPARE_WITH_TIMEOUT(m_window->walk().state(), session::RunState::Paused, kPatience);
    m_window->walk().correct(RegionId("lib")); // on the other floor
    QCOMPARE(page.mapPanel().whereText(),
             QStringLiteral("You are in Library, level 1: said by the assistant."));
    QCOMPARE(page.mapPanel().view().overlay().fix->region, std::optional(RegionId("lib")));
    QCOMPARE(page.mapPanel().view().level(), 1.0);
    m_window->walk().correct(std::nullopt);
    QCOMPARE(page.mapPanel().whereText(), QStringLiteral("Where you are is not known yet."));
}

void SuperviseTest::theAssistantsWordAndThePictures() {
    const auto fix = [](const char* region, double time, double evidence) {
        localisation::Fix made;
        made.region = RegionId(region);
        made.time = time;
        made.evidenceTime = evidence;
        return made;
    };
    const RegionId here("r1");
    ToldPlace told;
    told.heard(fix("c", 1.0, 1.0));
    QVERIFY(!told.holds());
    told.tell(here);
    told.heard(fix("c", 2.0, 2.0)); // was on its way
    QVERIFY(told.holds());
    QCOMPARE(told.shown(fix("c", 2.0, 2.0), *test::handMadeBuilding()).region, std::optional(here));
    told.heard(fix("r1", 2.5, 2.0));
    QVERIFY(told.holds());
    told.heard(fix("c", 3.0, 3.0)); // it was believed, and what is seen speaks against it
    QVERIFY(!told.holds());
    QVERIFY(told.overruled());
    told.heard(fix("c", 20.0, 20.0)); // old news
    QVERIFY(!told.overruled());

    told.tell(here);
    for (int i = 0; i < 4; ++i) told.heard(fix("c", 30.0 + i, 30.0)); // never believed
    QVERIFY(told.overruled());

    told.tell(here);
    told.heard(fix("r1", 40.0, 40.0));
    told.heard(fix("r1", 60.0, 40.0)); // nothing new was seen
    QVERIFY(told.holds());
    told.heard(fix("c", 61.0, 61.0)); // the user has walked on
    QVERIFY(!told.holds() && !told.overruled());

    told.tell(here);
    told.heard(fix("r1", 70.0, 70.0));
    told.heard(fix("r1", 71.0, 71.0)); // borne out: now the walk says how sure it is
    QVERIFY(!told.holds() && !told.overruled());

    told.tell(std::nullopt);
    for (int i = 0; i < 4; ++i) told.heard(fix("c", 80.0 + i, 80.0));
    QVERIFY(!told.holds() && !told.overruled());
}

void SuperviseTest::aTypedSentenceIsSaid() {
    begin(1);
    key(Qt::Key_E);
    auto* ask = m_window->findChild<QInputDialog*>();
    QVERIFY(ask);
    auto* edit = ask->findChild<QLineEdit*>();
    QTest::keyClicks(edit, QStringLiteral("Mind the wet floor."));
    QTest::keyClick(edit, Qt::Key_Return);
    UtteranceModel& said = m_window->page().utterances();
    QTRY_VERIFY_WITH_TIMEOUT(said.rowCount() == 1, kPatience);
    QCOMPARE(said.index(0, UtteranceModel::Sentence).data().toString(),
             QStringLiteral("Mind the wet floor."));
}

void SuperviseTest::theTimelineLooksBack() {
    begin(1);
    LivePage& page = m_window->page();
    page.timeline().add(*at(1.0, "c", 0.9));
    page.timeline().noteSaid(QStringLiteral("Turn left."));
    page.timeline().add(*at(1.05, "c", 0.9)); // too soon after the one before
    page.timeline().add(*at(2.0, "r1", 0.4));
    page.timeline().add(*at(3.0, "lib", 0.7));
    QCOMPARE(page.timeline().moments().size(), std::size_t{3});
    QCOMPARE(page.timeline().moments()[1].said, QStringList{QStringLiteral("Turn left.")});
    TimelineSlider& slider = page.timelineBar().slider();
    slider.setFocus();
    QTest::keyClick(&slider, Qt::Key_Left);
    QVERIFY(page.timelineBar().looksBack());
    QVERIFY2(page.mapPanel().whereText().contains(QLatin1String("Room 1")),
             qPrintable(page.mapPanel().whereText()));
    QVERIFY(!page.framePanel().view().pictureRect().isEmpty());
    page.timeline().add(*at(4.0, "lib", 0.7)); // the walk goes on, what is looked at stays
    QVERIFY(page.timelineBar().looksBack());
    QVERIFY(page.mapPanel().whereText().contains(QLatin1String("Room 1")));
    QTest::mouseClick(&slider, Qt::LeftButton, {}, QPoint(10, slider.height() / 2));
    QVERIFY(page.mapPanel().whereText().contains(QLatin1String("Main corridor")));
    QTest::keyClick(&slider, Qt::Key_End);
    QVERIFY(!page.timelineBar().looksBack());
    QCOMPARE(slider.accessibleDescription(), QStringLiteral("Now"));
}

void SuperviseTest::aLongWalkTakesNoMoreMemory() {
    WalkTimeline timeline;
    auto snapshot = std::make_shared<session::Snapshot>(*at(0.0, "c", 0.5));
    snapshot->frame.image = cv::Mat();
    for (int i = 0; i < 20000; ++i) {
        snapshot->step.percept.time = i * 0.25;
        if (i % 100 == 0) timeline.noteSaid(QString::number(i));
        timeline.add(*snapshot);
    }
    QVERIFY(timeline.moments().size() <= WalkTimeline::kMost);
    QCOMPARE(timeline.moments().front().time, 0.0);
    QVERIFY(timeline.moments().back().time > 4900.0);
    int said = 0;
    for (const Moment& moment : timeline.moments()) said += static_cast<int>(moment.said.size());
    QVERIFY(said >= 199); // nothing that was said is lost
}

void SuperviseTest::pictureAndTableAreSaved() {
    begin(1);
    m_window->page().show(test::handMadeSnapshot());
    m_window->page().timeline().add(*at(1.0, "c", 0.9));
    const auto save = [&](int shortcut, const QString& file) {
        key(shortcut, Qt::ControlModifier | Qt::ShiftModifier);
        auto* ask = m_window->findChild<QFileDialog*>();
        QVERIFY(ask);
        ask->setOption(QFileDialog::DontConfirmOverwrite);
        Q_EMIT ask->fileSelected(file);
        ask->close();
        QTRY_VERIFY(!m_window->findChild<QFileDialog*>());
    };
    const QString picture = m_folder.filePath(QStringLiteral("seen.png"));
    save(Qt::Key_P, picture);
    QVERIFY(!QImage(picture).isNull());
    const QString table = m_folder.filePath(QStringLiteral("walk.csv"));
    save(Qt::Key_E, table);
    QFile file(table);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray text = file.readAll();
    QVERIFY(text.startsWith("seconds,picture,region,name,confidence"));
    QVERIFY(text.contains("\"c\",\"Main corridor\",0.900"));
    save(Qt::Key_E, m_folder.filePath(QStringLiteral("no/such/walk.csv")));
    QVERIFY(m_window->page()
                .banners()
                .text(QStringLiteral("saved"))
                .contains(QLatin1String("cannot be written")));
}

void SuperviseTest::figuresAreDrawnAndSaved() {
    begin(1);
    WalkTimeline& timeline = m_window->page().timeline();
    for (int i = 0; i < 10; ++i) timeline.add(*at(1.0 + i, "c", 0.1 * i));
    key(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
    auto* dialog = m_window->findChild<FiguresDialog*>();
    QVERIFY(dialog);
    QCOMPARE(dialog->list().count(), 4);
    const ChartSeries& first = dialog->view().chart().lines.at(0);
    QCOMPARE(first.name, QStringLiteral("Main corridor"));
    QCOMPARE(first.points.size(), std::size_t{10});
    QCOMPARE(first.points.front(), QPointF(1.0, 6.0));
    const QString picture = m_folder.filePath(QStringLiteral("votes.png"));
    QVERIFY(dialog->view().save(picture));
    QCOMPARE(QImage(picture).size(), QSize(1280, 800));
    const QString drawing = m_folder.filePath(QStringLiteral("votes.svg"));
    QVERIFY(dialog->view().save(drawing));
    QFile file(drawing);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().contains("Main corridor"));
    QVERIFY(!dialog->view().save(m_folder.filePath(QStringLiteral("no/such/votes.svg"))));
    dialog->list().setFocus();
    QTest::keyClick(&dialog->list(), Qt::Key_Down);
    double pictures = 0.0;
    for (const double bar : dialog->view().chart().bars) pictures += bar;
    QCOMPARE(pictures, 10.0);
    const QString folder = qEnvironmentVariable("FAROL_SHOTS");
    if (!folder.isEmpty()) QFile::copy(picture, QDir(folder).filePath(QStringLiteral("votes.png")));
}

void SuperviseTest::figuresWithoutMaterialSayWhatToDo() {
    const WalkTimeline timeline;
    Calibration calibration;
    for (const Chart& chart : {Figures::votes(timeline, nullptr), Figures::latency(timeline),
                               Figures::calibration(calibration), Figures::ranges({})}) {
        QVERIFY(chart.empty());
        QVERIFY(!chart.missing.isEmpty());
        ChartView view;
        view.setChart(chart);
        QCOMPARE(view.accessibleDescription(), chart.missing);
        QVERIFY(!view.grab().isNull());
    }
    for (int i = 0; i < 4; ++i) calibration.note(0.85, i != 0);
    calibration.note(1.0, true);
    const Chart chart = Figures::calibration(calibration);
    QCOMPARE(chart.lines.at(0).points, (std::vector<QPointF>{{0.85, 0.75}, {0.95, 1.0}}));
    QCOMPARE(niceTicks(10.0, 5), (std::vector<double>{0.0, 2.0, 4.0, 6.0, 8.0, 10.0}));
    QCOMPARE(niceTicks(0.0, 5), std::vector<double>{0.0});
    recognition::TemplateCheck check;
    check.id = TemplateId("poster-1");
    check.farthestM = 7.5;
    const Chart ranges = Figures::ranges({check});
    QCOMPARE(ranges.bars, std::vector<double>{7.5});
    QCOMPARE(ranges.barNames, QStringList{QStringLiteral("poster-1")});
    ChartView view;
    view.resize(640, 400);
    view.setChart(ranges);
    QVERIFY(view.accessibleDescription().contains(QLatin1String("7.5")));
    const QString folder = qEnvironmentVariable("FAROL_SHOTS");
    if (!folder.isEmpty()) view.grab().save(QDir(folder).filePath(QStringLiteral("ranges.png")));
}

void SuperviseTest::aRecordedWalkIsWorkedOutAnew() {
    begin(6);
    key(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
    m_window->walk().setStart(RegionId("r1"));
    key(Qt::Key_F5, {});
    QTRY_COMPARE_WITH_TIMEOUT(m_window->walk().state(), session::RunState::Ended, kPatience);
    m_window->walk().stop();
    const QStringList walks = QDir(m_folder.path()).entryList({QStringLiteral("walk-*")}, QDir::Dirs);
    QCOMPARE(walks.size(), 1);
    RevoteDialog dialog(m_folder.filePath(walks.first()),
                        {{QStringLiteral("voting"), QStringLiteral("Voting")},
                         {QStringLiteral("bayes"), QStringLiteral("Filter")}});
    dialog.show();
    QTest::keyClick(&dialog.startButton(), Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(dialog.summary().contains(QLatin1String("pictures (")), kPatience);
    QVERIFY2(dialog.summary().contains(QLatin1String("of 6 pictures")), qPrintable(dialog.summary()));
}

void SuperviseTest::aFolderThatIsNoRecordingIsTold() {
    RevoteDialog dialog(m_folder.path(), {{QStringLiteral("voting"), QStringLiteral("Voting")}});
    dialog.show();
    QTest::keyClick(&dialog.startButton(), Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(dialog.summary().contains(QLatin1String("recording.json")), kPatience);
    QCOMPARE(dialog.table().rowCount(), 0);
}

/// Qt's own dialogs keep where they were.
void SuperviseTest::testsLeaveTheirUserAlone() {
    {
        QFileDialog ask;
        ask.setOption(QFileDialog::DontUseNativeDialog);
        ask.setDirectory(m_folder.path());
        ask.show();
        ask.selectFile(m_map);
        static_cast<QDialog&>(ask).accept();
    }
    const QSettings kept(QSettings::UserScope, QStringLiteral("QtProject"));
    QVERIFY2(kept.fileName().startsWith(QDir::tempPath() + QLatin1Char('/')), qPrintable(kept.fileName()));
    QVERIFY(kept.contains(QStringLiteral("FileDialog/lastVisited")));
    for (const auto where : {QStandardPaths::GenericConfigLocation, QStandardPaths::GenericDataLocation,
                             QStandardPaths::GenericCacheLocation})
        QVERIFY(QStandardPaths::writableLocation(where).startsWith(QDir::tempPath() + QLatin1Char('/')));
}

} // namespace farol::ui

QTEST_MAIN(farol::ui::SuperviseTest)
#include "test_supervise.moc"
