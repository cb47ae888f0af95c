// The landmark curator's whole job, by real keys and mouse on the shown page: a library is made, a landmark
// is taught from photographs, tried, saved; what was unfinished is found again; merge, split and delete can
// be taken back.

#include "core/recognition/training.h"
#include "tests/recognition/drawn_pictures.h"
#include "tests/ui/hand_made.h"
#include "ui/convert/convert.h"
#include "ui/parts/banner.h"
#include "ui/training/library_panel.h"
#include "ui/training/outline_view.h"
#include "ui/training/teach_try.h"
#include "ui/training/teach_views.h"
#include "ui/training/teach_what.h"
#include "ui/training/training_actions.h"
#include "ui/training/training_page.h"
#include "ui/training/training_words.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QInputDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QMimeData>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QSysInfo>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace farol::ui {

namespace {

constexpr int kPatience = 60000;

} // namespace

class TrainingTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanup();
    void aLandmarkIsTaughtByKeys();
    void cornersAreDraggedAndMovedByKeys();
    void unfinishedWorkSurvivesAKill();
    void aPictureWithoutDetailIsRefusedInWords();
    void mergeSplitAndDeleteAreTakenBack();
    void theReportNamesWhatIsConfused();
    void aFileChangedByAnotherProgramIsNotOverwritten();
    void twoProgramsAtOneLibrary();
    void twoProgramsAtOneLandmark();
    void givingUpIsNotASlip();
    void whatAnotherProgramMakesIsLoadedAgain();
    void unfinishedWorkOfTwoPrograms();
    void whatCannotBeWrittenIsTold();
    void aMissingLibraryIsTold();
    void adviceHasWords();
    void namesBecomeIds();

private:
    void make();
    void openLibrary();
    void type(QWidget& field, const QString& text);
    void press(QPushButton& button);
    void focusTable();
    void shot(const char* name) const;
    QStringList photographs() const { return m_photographs; }

    QTemporaryDir m_folder;
    QString m_library;
    QStringList m_photographs;
    std::unique_ptr<Settings> m_settings;
    std::unique_ptr<TrainingPage> m_page;
};

void TrainingTest::initTestCase() {
    namespace test = recognition::test;
    // The same poster from the front, from the left and from farther away.
    const std::vector<Quad> quads{quadOf({160, 100, 320, 240}),
                                  Quad{ImagePoint{170, 80}, {430, 120}, {430, 360}, {170, 400}},
                                  quadOf({240, 160, 160, 120})};
    for (std::size_t i = 0; i < quads.size(); ++i) {
        cv::Mat picture = test::room(i + 3);
        test::hang(picture, test::poster(21), quads[i]);
        const QString name = m_folder.filePath(QStringLiteral("photo-%1.jpg").arg(i));
        QFile file(name);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::fromStdString(test::jpeg(picture)));
        m_photographs << name;
    }
}

void TrainingTest::init() {
    namespace test = recognition::test;
    m_library = m_folder.filePath(QStringLiteral("posters.gpkg"));
    QFile::remove(m_library);
    QFile::remove(m_folder.filePath(QStringLiteral("settings.ini")));
    QDir(m_folder.filePath(QStringLiteral("teaching"))).removeRecursively();
    recognition::LandmarkLibrary library;
    for (const std::uint64_t seed : {1U, 2U, 1U}) test::trainPoster(library, seed);
    QVERIFY(recognition::saveLibrary(library, toUtf8(m_library)).ok());
    m_settings = std::make_unique<Settings>(m_folder.filePath(QStringLiteral("settings.ini")));
    installTranslation(QStringLiteral("en"));
    make();
}

void TrainingTest::cleanup() {
    m_page.reset();
    m_settings.reset();
}

void TrainingTest::make() {
    m_page.reset();
    m_page = std::make_unique<TrainingPage>(*m_settings, m_folder.filePath(QStringLiteral("teaching")));
    m_page->resize(1200, 760);
    m_page->show();
    m_page->activateWindow();
    QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
}

void TrainingTest::openLibrary() {
    QSignalSpy opened(&m_page->document(), &LibraryDocument::opened);
    m_page->open(m_library);
    QVERIFY(opened.wait(kPatience));
}

void TrainingTest::type(QWidget& field, const QString& text) {
    field.setFocus();
    QTest::keyClick(&field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&field, text);
}

/// A dialog that was closed leaves no window active.
void TrainingTest::focusTable() {
    m_page->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_page.get()));
    m_page->panel().table().setFocus();
}

/// A picture to look at, where FAROL_SHOTS names a folder.
void TrainingTest::shot(const char* name) const {
    const QString folder = qEnvironmentVariable("FAROL_SHOTS");
    if (!folder.isEmpty())
        m_page->grab().save(QDir(folder).filePath(QString::fromLatin1(name) + QStringLiteral(".png")));
}

void TrainingTest::press(QPushButton& button) {
    QVERIFY2(button.isEnabled(), qPrintable(button.text()));
    button.setFocus();
    QTest::keyClick(&button, Qt::Key_Space);
}

void TrainingTest::aLandmarkIsTaughtByKeys() {
    openLibrary();
    QTest::keyClick(&m_page->panel().table(), Qt::Key_T, Qt::ControlModifier);
    QVERIFY(m_page->teaching());
    TeachPanel& wizard = m_page->wizard();
    QVERIFY(!wizard.forward().isEnabled());
    QCOMPARE(wizard.why(), QStringLiteral("Give it a name first."));
    QVERIFY(wizard.what().name().hasFocus());
    QTest::keyClicks(&wizard.what().name(), QStringLiteral("Poster 1"));
    QVERIFY2(!wizard.forward().isEnabled(), "the library has a poster-1");
    type(wizard.what().name(), QStringLiteral("Corner cafe"));
    QCOMPARE(m_page->session().draft().id, QStringLiteral("corner-cafe"));
    QTest::keyClicks(&wizard.what().kind(), QStringLiteral("poster"));
    QCOMPARE(m_page->session().draft().kind, Kind::Poster);
    shot("teach-what");
    press(wizard.forward());

    QCOMPARE(wizard.step(), TeachPanel::Views);
    QVERIFY(wizard.views().coachText().contains(QLatin1String("straight from the front")));
    wizard.reel().openFiles(photographs());
    QTRY_VERIFY_WITH_TIMEOUT(wizard.reel().current(), kPatience);
    wizard.views().outline().setOutline(quadOf({160, 100, 320, 240}));
    QTest::keyClick(&wizard.views().outline(), Qt::Key_Left); // judged again after a change
    QTest::keyClick(&wizard.views().outline(), Qt::Key_Right);
    QTRY_VERIFY_WITH_TIMEOUT(wizard.views().coachText().contains(QLatin1String("picture is good")),
                             kPatience);
    press(wizard.views().addButton());
    QTRY_COMPARE_WITH_TIMEOUT(m_page->session().draft().views.size(), std::size_t{1}, kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(wizard.reel().index(), 1, kPatience); // the next picture comes by itself
    QTRY_VERIFY_WITH_TIMEOUT(m_page->settled() && !wizard.reel().busy(), kPatience);
    QVERIFY(wizard.views().coachText().contains(QLatin1String("from the left")));
    QVERIFY(wizard.views().healthText().contains(QLatin1String("only one view")));

    // The second one is found again by the first.
    for (QPushButton* button : wizard.views().findChildren<QPushButton*>())
        if (button->accessibleName() == QLatin1String("Find the outline")) press(*button);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs((*wizard.views().outline().outline())[0].x - 170.0) < 12.0, kPatience);
    press(wizard.views().addButton());
    QTRY_COMPARE_WITH_TIMEOUT(m_page->session().draft().views.size(), std::size_t{2}, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(m_page->session().health(), kPatience);
    QVERIFY2(wizard.views().healthText().contains(QLatin1String("Found in 2 of its 2 views")),
             qPrintable(wizard.views().healthText()));
    QVERIFY(wizard.views().healthText().contains(QLatin1String("Confused with none")));
    QTRY_VERIFY_WITH_TIMEOUT(!wizard.reel().busy(), kPatience);

    shot("teach-views");
    press(wizard.forward());
    QCOMPARE(wizard.step(), TeachPanel::Try);
    QTRY_VERIFY_WITH_TIMEOUT(wizard.trial().verdict().startsWith(QLatin1String("Found, ")), kPatience);
    shot("teach-try");
    press(wizard.forward()); // save it
    QTRY_COMPARE_WITH_TIMEOUT(wizard.step(), TeachPanel::End, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(m_page->document().settled() && !m_page->document().unsaved(), kPatience);
    const auto stored = recognition::loadLibrary(toUtf8(m_library));
    QVERIFY(stored.ok());
    QCOMPARE(stored->templates.size(), std::size_t{3});
    QCOMPARE(stored->templates.back().name, toUtf8(QStringLiteral("Corner cafe")));
    QCOMPARE(stored->templates.back().views.size(), std::size_t{2});
    QVERIFY(!m_page->session().unfinished());

    shot("teach-end");
    QSignalSpy place(m_page.get(), &TrainingPage::placeWanted);
    QVERIFY(wizard.place().hasFocus());
    QTest::keyClick(&wizard.place(), Qt::Key_Space);
    QCOMPARE(place.count(), 1);
    QCOMPARE(place.first().first().value<recognition::Template>().id.value, std::string("corner-cafe"));
}

void TrainingTest::cornersAreDraggedAndMovedByKeys() {
    OutlineView view;
    view.resize(640, 480);
    view.setPicture(QImage(320, 240, QImage::Format_RGB32));
    view.setOutline(quadOf({80, 60, 160, 120}));
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    QSignalSpy changed(&view, &OutlineView::outlineChanged);
    const QPoint corner = view.toWidget({240, 60}).toPoint();
    QTest::mousePress(&view, Qt::LeftButton, {}, corner);
    QTest::mouseMove(&view, corner + QPoint(40, -20));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, corner + QPoint(40, -20));
    QVERIFY(changed.count() > 0);
    QCOMPARE(view.corner(), 1);
    QCOMPARE(std::lround((*view.outline())[1].x), 260L);
    QCOMPARE(std::lround((*view.outline())[1].y), 50L);
    QTest::keyClick(&view, Qt::Key_3);
    QTest::keyClick(&view, Qt::Key_Down, Qt::ShiftModifier);
    QCOMPARE((*view.outline())[2].y, 181.0);
    QVERIFY(view.accessibleDescription().contains(QLatin1String("bottom right")));
    for (int i = 0; i < 60; ++i) QTest::keyClick(&view, Qt::Key_Right);
    QCOMPARE((*view.outline())[2].x, 320.0); // not out of the picture
}

void TrainingTest::unfinishedWorkSurvivesAKill() {
    openLibrary();
    m_page->teach();
    type(m_page->wizard().what().name(), QStringLiteral("Notice"));
    press(m_page->wizard().forward());
    m_page->wizard().reel().openFiles(photographs());
    QTRY_VERIFY_WITH_TIMEOUT(m_page->wizard().reel().current(), kPatience);
    m_page->wizard().views().outline().setOutline(quadOf({160, 100, 320, 240}));
    press(m_page->wizard().views().addButton());
    QTRY_COMPARE_WITH_TIMEOUT(m_page->session().draft().views.size(), std::size_t{1}, kPatience);
    // Nobody says goodbye to a killed program: what is on disk must do. A damaged photograph is left out.
    make();
    const QString banner = m_page->banners().text(QStringLiteral("unfinished"));
    QVERIFY2(banner.contains(QLatin1String("Notice")), qPrintable(banner));
    openLibrary();
    m_page->teach(); // asks first instead of forgetting it
    QVERIFY(!m_page->teaching());
    for (QPushButton* button : m_page->banners().findChildren<QPushButton*>())
        if (button->text() == QLatin1String("Go &on with it")) press(*button);
    QVERIFY(m_page->teaching());
    QCOMPARE(m_page->wizard().step(), TeachPanel::Views);
    QTRY_VERIFY_WITH_TIMEOUT(m_page->session().trained(), kPatience);
    QCOMPARE(m_page->session().draft().name, QStringLiteral("Notice"));
    QCOMPARE(m_page->session().draft().views.size(), std::size_t{1});
    QCOMPARE(m_page->wizard().views().views().count(), 1);
}

void TrainingTest::aPictureWithoutDetailIsRefusedInWords() {
    const QString blank = m_folder.filePath(QStringLiteral("blank.png"));
    QImage wall(640, 480, QImage::Format_RGB32);
    wall.fill(QColor(128, 128, 128));
    QVERIFY(wall.save(blank));
    openLibrary();
    m_page->teach();
    type(m_page->wizard().what().name(), QStringLiteral("Wall"));
    press(m_page->wizard().forward());
    TeachViews& views = m_page->wizard().views();
    m_page->wizard().reel().openFiles({blank});
    QTRY_VERIFY_WITH_TIMEOUT(views.coachText().contains(QLatin1String("Too little detail")), kPatience);
    press(views.addButton());
    QTRY_VERIFY_WITH_TIMEOUT(views.coachText().contains(QLatin1String("features were found")), kPatience);
    QVERIFY(m_page->session().draft().views.empty());
    QVERIFY(!m_page->wizard().forward().isEnabled());
    m_page->wizard().reel().openFiles({m_folder.filePath(QStringLiteral("none.jpg"))});
    QTRY_VERIFY_WITH_TIMEOUT(views.coachText().contains(QLatin1String("none.jpg")), kPatience);
}

void TrainingTest::mergeSplitAndDeleteAreTakenBack() {
    openLibrary();
    LibraryDocument& document = m_page->document();
    const auto settled = [&] { return document.settled() && !document.unsaved(); };
    const auto inFile = [&] {
        QStringList found;
        const auto stored = recognition::loadLibrary(toUtf8(m_library));
        if (stored)
            for (const recognition::Template& entry : stored->templates)
                found << QStringLiteral("%1/%2").arg(toQString(entry.id.value)).arg(entry.views.size());
        return found;
    };
    const QStringList before = inFile();
    QCOMPARE(before, (QStringList{QStringLiteral("poster-1/2"), QStringLiteral("poster-2/1")}));
    QTableView& table = m_page->panel().table();
    table.selectRow(0);
    focusTable();

    m_page->panel().views().setCurrentRow(1);
    m_page->actions().split->trigger();
    auto* ask = m_page->findChild<QInputDialog*>();
    QVERIFY(ask);
    ask->setTextValue(QStringLiteral("Other side"));
    ask->accept();
    QTRY_COMPARE_WITH_TIMEOUT(document.library()->templates.size(), std::size_t{3}, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(settled(), kPatience);
    QCOMPARE(inFile(), (QStringList{QStringLiteral("poster-1/1"), QStringLiteral("poster-2/1"),
                                    QStringLiteral("other-side/1")}));
    focusTable();
    QTest::keyClick(&table, Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(settled(), kPatience);
    QCOMPARE(inFile(), before);

    table.selectRow(1);
    m_page->actions().merge->trigger();
    QTRY_VERIFY(m_page->findChild<QInputDialog*>());
    m_page->findChild<QInputDialog*>()->accept();
    QTRY_COMPARE_WITH_TIMEOUT(document.library()->templates.size(), std::size_t{1}, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(settled(), kPatience);
    QCOMPARE(inFile(), QStringList{QStringLiteral("poster-2/3")});
    focusTable();
    QTest::keyClick(&table, Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(settled(), kPatience);
    QCOMPARE(inFile(), before);

    table.selectRow(0);
    QTest::keyClick(&table, Qt::Key_Delete);
    QTRY_COMPARE_WITH_TIMEOUT(document.library()->templates.size(), std::size_t{1}, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(settled(), kPatience);
    QCOMPARE(inFile(), QStringList{QStringLiteral("poster-2/1")});
    QTest::keyClick(&table, Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(settled(), kPatience);
    QCOMPARE(inFile(), before);
    QTest::keyClick(&table, Qt::Key_Y, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(settled(), kPatience);
    QCOMPARE(inFile(), QStringList{QStringLiteral("poster-2/1")});
}

void TrainingTest::theReportNamesWhatIsConfused() {
    openLibrary();
    QTest::keyClick(&m_page->panel().table(), Qt::Key_F7);
    QTRY_COMPARE_WITH_TIMEOUT(m_page->panel().confusion().rowCount(), 2, kPatience);
    QVERIFY(m_page->panel().reportText().contains(QLatin1String("None is taken for another")));
    shot("library-report");
    const ConfusionModel& matrix = m_page->panel().confusion();
    QCOMPARE(matrix.index(0, 0).data().toString(), QStringLiteral("2/2"));
    QCOMPARE(matrix.index(0, 1).data().toString(), QString());
    QVERIFY(matrix.csv().startsWith("template,views,tested,found"));
    QCOMPARE(matrix.csv().count('\n'), 3);
    const LibraryModel& model = m_page->panel().model();
    QCOMPARE(model.index(0, LibraryModel::Health).data().toString(), QStringLiteral("good"));

    // Of its one view nobody knows whether it is found.
    QVERIFY(
        m_page->panel().reportText().contains(QLatin1String("All that have several views are found well")));
    QVERIFY(m_page->panel().reportText().contains(QLatin1String("1 landmark cannot be tried")));
    QVERIFY(matrix.index(1, 1).data(Qt::BackgroundRole) != matrix.index(0, 0).data(Qt::BackgroundRole));

    std::vector<recognition::TemplateCheck> checks = matrix.checks();
    checks[1].confusedWith["poster-1"] = 3;
    ConfusionModel confused;
    confused.setChecks(checks);
    QCOMPARE(confused.index(1, 0).data().toString(), QStringLiteral("3"));
    QVERIFY(confused.index(1, 0).data(Qt::AccessibleTextRole).toString().contains(QLatin1String("3 times")));
    QVERIFY(TrainingWords::verdict(checks[1]).contains(QLatin1String("poster-1")));
    checks[0].shown = 0; // only aslant views: nothing could be shown smaller or turned
    const auto told = [&](Kind kind) {
        return TrainingWords::health(checks[0], kind).join(QLatin1Char(' '));
    };
    QVERIFY(told(Kind::Poster).contains(QLatin1String("straight from the front")));
    QVERIFY(!told(Kind::Place).contains(QLatin1String("straight from the front")));
}

void TrainingTest::aFileChangedByAnotherProgramIsNotOverwritten() {
    openLibrary();
    recognition::LandmarkLibrary other;
    recognition::test::trainPoster(other, 5);
    QVERIFY(recognition::saveLibrary(other, toUtf8(m_library)).ok());
    m_page->panel().table().selectRow(0);
    m_page->actions().remove->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(m_page->banners().shows(QStringLiteral("unsaved")), kPatience);
    QVERIFY(m_page->document().unsaved());
    const auto stored = recognition::loadLibrary(toUtf8(m_library));
    QVERIFY(stored.ok());
    QCOMPARE(stored->templates.front().id.value, std::string("poster-5"));
}

/// Two programs, each with its own picture of one file: what both make of it is in it in the end.
void TrainingTest::twoProgramsAtOneLibrary() {
    LibraryDocument one, other;
    for (LibraryDocument* document : {&one, &other}) {
        document->open(m_library);
        QTRY_VERIFY_WITH_TIMEOUT(document->library() && document->settled(), kPatience);
    }
    QSignalSpy joined(&other, &LibraryDocument::joined);
    QSignalSpy overtaken(&other, &LibraryDocument::overtaken);
    const auto named = [](const char* name) {
        return [name](const recognition::LandmarkLibrary& library) {
            recognition::Template changed = library.templates[0];
            changed.name = name;
            return recognition::change(library, 0, changed);
        };
    };
    const auto taught = [](const recognition::LandmarkLibrary& library) {
        recognition::LandmarkLibrary fresh;
        recognition::test::trainPoster(fresh, 9);
        return recognition::insertion(library, fresh.templates[0]);
    };
    // Both at once, neither having seen what the other does.
    QVERIFY(one.change(QStringLiteral("name"), named("At the door")));
    QVERIFY(other.change(QStringLiteral("teach"), taught));
    const auto rest = [&] { return one.settled() && other.settled() && !one.unsaved() && !other.unsaved(); };
    QTRY_VERIFY_WITH_TIMEOUT(rest(), kPatience);
    const auto stored = recognition::loadLibrary(toUtf8(m_library));
    QVERIFY(stored.ok());
    QCOMPARE(stored->templates.size(), std::size_t{3});
    QCOMPARE(stored->templates[0].name, std::string("At the door"));
    QVERIFY(stored->find(TemplateId("poster-9")) != nullptr);
    QCOMPARE(overtaken.count(), 0);
    QVERIFY(!QFile::exists(m_library + QStringLiteral(".lock")));
}

/// Both change the same landmark: what was written first stays, the other's is kept until it is saved
/// elsewhere.
void TrainingTest::twoProgramsAtOneLandmark() {
    openLibrary();
    recognition::LandmarkLibrary theirs = *m_page->document().library();
    theirs.templates[0].name = "Theirs";
    QVERIFY(recognition::saveLibrary(theirs, toUtf8(m_library)).ok());
    QTRY_VERIFY_WITH_TIMEOUT(
        m_page->banners().text(QStringLiteral("outside")).contains(QLatin1String("has changed")), kPatience);
    QVERIFY(
        m_page->document().change(QStringLiteral("mine"), [](const recognition::LandmarkLibrary& library) {
            recognition::Template changed = library.templates[0];
            changed.name = "Mine";
            return recognition::change(library, 0, changed);
        }));
    QTRY_VERIFY_WITH_TIMEOUT(m_page->banners().shows(QStringLiteral("unsaved")), kPatience);
    QVERIFY(m_page->document().unsaved());
    QCOMPARE(m_page->document().library()->templates[0].name, std::string("Mine"));
    QCOMPARE(recognition::loadLibrary(toUtf8(m_library))->templates[0].name, std::string("Theirs"));
    const QString elsewhere = m_folder.filePath(QStringLiteral("mine.gpkg"));
    m_page->document().saveAs(elsewhere);
    QTRY_VERIFY_WITH_TIMEOUT(!m_page->document().unsaved() && m_page->document().settled(), kPatience);
    QCOMPARE(recognition::loadLibrary(toUtf8(elsewhere))->templates[0].name, std::string("Mine"));
    QCOMPARE(recognition::loadLibrary(toUtf8(m_library))->templates[0].name, std::string("Theirs"));
}

/// Whoever only presses Enter keeps what was taught.
void TrainingTest::givingUpIsNotASlip() {
    openLibrary();
    m_page->teach();
    type(m_page->wizard().what().name(), QStringLiteral("Notice"));
    press(m_page->wizard().giveUp());
    auto* ask = m_page->findChild<QMessageBox*>();
    QVERIFY(ask && ask->defaultButton());
    QCOMPARE(ask->buttonRole(ask->defaultButton()), QMessageBox::RejectRole);
    QTest::keyClick(ask, Qt::Key_Return);
    QVERIFY(m_page->teaching());
    QVERIFY(m_page->session().unfinished());
}

/// What another program makes is told, and shown on demand.
void TrainingTest::whatAnotherProgramMakesIsLoadedAgain() {
    openLibrary();
    recognition::LandmarkLibrary theirs = *m_page->document().library();
    recognition::test::trainPoster(theirs, 9);
    QVERIFY(recognition::saveLibrary(theirs, toUtf8(m_library)).ok());
    QTRY_VERIFY_WITH_TIMEOUT(m_page->banners().shows(QStringLiteral("outside")), kPatience);
    for (QPushButton* button : m_page->banners().findChildren<QPushButton*>())
        if (button->text() == QLatin1String("&Load it again")) press(*button);
    QTRY_COMPARE_WITH_TIMEOUT(m_page->document().library()->templates.size(), std::size_t{3}, kPatience);
    QVERIFY(!m_page->banners().shows(QStringLiteral("outside")));
}

/// Each program keeps what it is teaching for itself; what a crash left anywhere is found again.
void TrainingTest::unfinishedWorkOfTwoPrograms() {
    const QString folder = m_folder.filePath(QStringLiteral("teaching"));
    m_page.reset();
    QProcess other;
    other.start(QStringLiteral("sleep"), {QStringLiteral("600")});
    QVERIFY(other.waitForStarted(kPatience));
    QFile lock(folder + QStringLiteral(".lock"));
    QVERIFY(lock.open(QIODevice::WriteOnly)); // as QLockFile of that program writes it
    for (const QByteArray& line :
         {QByteArray::number(other.processId()), QByteArray("sleep"), QSysInfo::machineHostName().toUtf8(),
          QSysInfo::machineUniqueId(), QSysInfo::bootUniqueId()})
        lock.write(line + '\n');
    lock.close();
    TeachDraft draft;
    draft.name = QStringLiteral("Mine");
    {
        const DraftStore mine(folder);
        QVERIFY(mine.save(draft).ok());
        QVERIFY(!QFile::exists(folder + QStringLiteral("/draft.json")));
        QCOMPARE(mine.load()->name, draft.name);
    }
    other.kill();
    QVERIFY(other.waitForFinished(kPatience));
    QVERIFY(DraftStore(folder).load().has_value()); // though the first folder is free again
    DraftStore(folder).clear();
    QVERIFY(!DraftStore(folder).load());
}

void TrainingTest::whatCannotBeWrittenIsTold() {
    openLibrary();
    m_page->document().saveAs(m_folder.filePath(QStringLiteral("no/such/folder/x.gpkg")));
    QTRY_VERIFY_WITH_TIMEOUT(m_page->banners().shows(QStringLiteral("unsaved")), kPatience);
    QVERIFY(m_page->document().unsaved());
    m_page->document().saveAs(m_folder.filePath(QStringLiteral("else.gpkg")));
    QTRY_VERIFY_WITH_TIMEOUT(!m_page->banners().shows(QStringLiteral("unsaved")), kPatience);
    QVERIFY(QFile::exists(m_folder.filePath(QStringLiteral("else.gpkg"))));
}

void TrainingTest::aMissingLibraryIsTold() {
    m_page->open(m_folder.filePath(QStringLiteral("none.gpkg")));
    QTRY_VERIFY_WITH_TIMEOUT(
        m_page->banners().text(QStringLiteral("failure")).contains(QLatin1String("none.gpkg")), kPatience);
    QVERIFY(!m_page->actions().teach->isEnabled());
    QSignalSpy opened(&m_page->document(), &LibraryDocument::opened);
    m_page->document().create(m_folder.filePath(QStringLiteral("fresh.gpkg")));
    QVERIFY(opened.wait(kPatience));
    QVERIFY(m_page->actions().teach->isEnabled());
    QVERIFY(!m_page->actions().remove->isEnabled());
}

void TrainingTest::adviceHasWords() {
    QStringList seen;
    for (int i = 0; i <= static_cast<int>(recognition::Advice::Enough); ++i) {
        const QString words = TrainingWords::advice(static_cast<recognition::Advice>(i));
        QVERIFY(!words.isEmpty());
        QVERIFY2(!seen.contains(words), qPrintable(words));
        seen << words;
    }
}

void TrainingTest::namesBecomeIds() {
    QCOMPARE(TrainingWords::idFrom(QStringLiteral("  Saída de Emergência! 2 ")),
             QStringLiteral("saida-de-emergencia-2"));
    QCOMPARE(TrainingWords::idFrom(QStringLiteral("—")), QString());
}

} // namespace farol::ui

QTEST_MAIN(farol::ui::TrainingTest)
#include "test_training.moc"
