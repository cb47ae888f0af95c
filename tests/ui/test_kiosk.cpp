// The kiosk's page with a walk behind it: only keys go in, only the utterances come out.

#include "core/building/geopackage.h"
#include "tests/ui/hand_made.h"
#include "ui/convert/convert.h"
#include "ui/kiosk/kiosk_page.h"

#include <QElapsedTimer>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <sys/resource.h>

namespace farol::ui {

namespace {

class CountedChimes : public Chimes {
public:
    explicit CountedChimes(int& warnings) : m_warnings(warnings) {}
    void play(Sound sound) override { m_warnings += sound == Sound::Warning ? 1 : 0; }

private:
    int& m_warnings;
};

} // namespace

class KioskTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanup();
    void fromTheListToTheWay();
    void beingThereAlreadyIsTold();
    void theMissingMapIsTold();
    void theMissingSourceIsTold();
    void theEndOfThePicturesIsToldAndTriedAgain();
    void noCameraIsTold();
    void aMissingLibraryIsTold();
    void itLeavesAfterTheLastWords();
    void escapeHeldDown();
    void closingWhileLoading();
    void aCrashIsRememberedAndAGoodEndIsNot();
    void theLanguageChangesAtOnce();
    void keysSpeakBeforeALongWalk();
    void everyKeyOfThePageSpeaks_data();
    void everyKeyOfThePageSpeaks();
    void whatIsSaidIsWrittenDown();
    void picturesDeletedWhileRunningAreTold();
    void anotherVoiceTakesOver();
    void withoutAnyVoiceItIsShown();
    void aChangedMapIsUsedWhenNobodyIsLed();
    void aMapThatIsGoneIsKept();
    void aFolderThatCannotBeWrittenIsTold();
    void aFullDiskIsTold();
    void twoKiosksOfOneUser();
    void closingWhileLed();
    void theSimulatedUserStandsThere();
    void thePageHasNamesAndLargeLetters();

private:
    void make(std::uint64_t frames = 1000000, const QString& from = QStringLiteral("c"));
    void start();
    void key(int key, const QString& text = {});
    void bring(KioskState state);
    void choose(int index);
    bool heard(const char* part) const;

    QTemporaryDir m_folder;
    KioskStart m_start;
    std::unique_ptr<Settings> m_settings;
    std::unique_ptr<Kiosk> m_kiosk;
    std::unique_ptr<KioskPage> m_page;
    QStringList m_log;
    int m_warnings = 0;
    std::function<bool(const VoiceChoice&)> m_works; ///< which voices do; none: all
};

void KioskTest::initTestCase() {
    std::signal(SIGXFSZ, SIG_IGN); // a write beyond the limit then fails as on a full disk
    QVERIFY(building::saveBuilding(*test::handMadeBuilding(),
                                   toUtf8(m_folder.filePath(QStringLiteral("house.gpkg"))))
                .ok());
}

void KioskTest::init() {
    installTranslation(QStringLiteral("en"));
    const QString file = m_folder.filePath(QStringLiteral("kiosk.ini"));
    QFile::remove(file);
    m_settings = std::make_unique<Settings>(file);
    m_settings->setLanguage(QStringLiteral("en"));
    m_start = {};
    m_start.map = m_folder.filePath(QStringLiteral("house.gpkg"));
    m_start.source = QStringLiteral("grey");
    m_start.memoryFile = m_folder.filePath(QStringLiteral("state.json"));
    QFile::remove(m_start.memoryFile);
    m_warnings = 0;
    m_works = {};
}

void KioskTest::cleanup() {
    m_page.reset();
    m_kiosk.reset();
    m_settings.reset();
}

void KioskTest::make(std::uint64_t frames, const QString& from) {
    m_page.reset();
    m_kiosk.reset();
    m_log.clear();
    m_start.from = from;
    const auto open =
        [frames](const std::string& name,
                 const capture::SourceOptions& options) -> Result<std::unique_ptr<capture::FrameSource>> {
        if (name.front() == '/') return capture::openSource(name, options);
        if (name == "broken") return Error{ErrorCode::Unavailable, "there is no such camera", name};
        return std::unique_ptr<capture::FrameSource>(std::make_unique<test::FakeSource>(frames, 0.05));
    };
    m_kiosk = std::make_unique<Kiosk>(
        *m_settings, m_start, open,
        [this](const VoiceChoice& choice) {
            return std::make_unique<test::FakeVoice>(!m_works || m_works(choice));
        },
        std::make_unique<CountedChimes>(m_warnings));
    m_kiosk->speech().setGapMs(0); // the pictures show nothing: the longer a test takes, the less is sure
    connect(m_kiosk.get(), &Kiosk::spoken, this, [this](const QString& text) { m_log << text; });
    m_page = std::make_unique<KioskPage>(*m_kiosk);
    m_page->resize(1280, 800);
    m_page->show();
    m_kiosk->begin();
}

/// Until the camera runs, so that keys are answered by the walk.
void KioskTest::start() {
    make();
    QTRY_COMPARE_WITH_TIMEOUT(m_kiosk->walk().state(), session::RunState::Running, 60000);
    QTRY_VERIFY_WITH_TIMEOUT(m_kiosk->walk().snapshot() != nullptr, 60000);
    QTRY_COMPARE(m_kiosk->machine().state(), KioskState::Choosing);
}

void KioskTest::key(int key, const QString& text) {
    Q_UNUSED(text);
    QTest::keyClick(m_page.get(), static_cast<Qt::Key>(key));
}

bool KioskTest::heard(const char* part) const {
    return !m_log.filter(QString::fromUtf8(part)).isEmpty();
}

void KioskTest::fromTheListToTheWay() {
    start();
    QVERIFY(heard("Choose a destination: 6 places"));
    key(Qt::Key_F);
    QTest::keyClicks(m_page.get(), QStringLiteral("library"));
    key(Qt::Key_Return);
    QTRY_VERIFY(heard("Library 1.01, level 1"));
    key(Qt::Key_Return);
    QTRY_VERIFY(heard("To: Library 1.01, level 1."));
    QTRY_VERIFY_WITH_TIMEOUT(heard("Destination: Library"), 60000); // the walk's own words
    key(Qt::Key_L);
    QTRY_VERIFY_WITH_TIMEOUT(heard("stairs"), 60000);
    key(Qt::Key_Return);
    QCOMPARE(m_kiosk->machine().state(), KioskState::Walking);
    m_log.clear();
    key(Qt::Key_W);
    QTRY_VERIFY_WITH_TIMEOUT(heard("Main corridor"), 60000);
    key(Qt::Key_Escape);
    QTRY_VERIFY(heard("Stop the guidance?"));
    key(Qt::Key_Escape);
    QTRY_VERIFY(!m_kiosk->walk().destination());
}

void KioskTest::beingThereAlreadyIsTold() {
    start();
    key(Qt::Key_F);
    QTest::keyClicks(m_page.get(), QStringLiteral("main"));
    key(Qt::Key_Return);
    key(Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(m_kiosk->machine().state(), KioskState::Arrived, 60000);
    QTRY_VERIFY_WITH_TIMEOUT(heard("already there"), 60000);
    key(Qt::Key_Return);
    QCOMPARE(m_kiosk->machine().state(), KioskState::Choosing);
    for (int again = 0; again < 2; ++again) { // each choice is answered, however soon it comes
        m_log.clear();
        bring(KioskState::Arrived);
        QTRY_VERIFY_WITH_TIMEOUT(heard("already there") || heard("there already"), 60000);
    }
}

void KioskTest::theMissingMapIsTold() {
    m_start.map = m_folder.filePath(QStringLiteral("none.gpkg"));
    make();
    QTRY_VERIFY_WITH_TIMEOUT(heard("The map cannot be opened"), 60000);
    QVERIFY(!m_kiosk->detail().isEmpty());
    m_start.map.clear();
    make();
    QTRY_VERIFY(heard("The map cannot be opened"));
}

void KioskTest::theMissingSourceIsTold() {
    m_start.source = QStringLiteral("broken");
    make();
    QTRY_VERIFY_WITH_TIMEOUT(heard("The camera gives no pictures"), 60000);
    QVERIFY(m_kiosk->detail().contains(QLatin1String("no such camera")));
}

void KioskTest::theEndOfThePicturesIsToldAndTriedAgain() {
    make(2);
    QTRY_VERIFY_WITH_TIMEOUT(heard("The camera gives no pictures"), 60000);
    QSignalSpy began(&m_kiosk->walk(), &Walk::walkBegan);
    key(Qt::Key_Down);
    key(Qt::Key_Return);
    key(Qt::Key_Return);
    QTRY_VERIFY(heard("I try the camera again"));
    QTRY_COMPARE_WITH_TIMEOUT(began.count(), 1, 60000);
    QTRY_VERIFY_WITH_TIMEOUT(heard("Stop. The camera gives no pictures"), 60000);
}

void KioskTest::noCameraIsTold() {
    m_start.source.clear();
    make();
    QTRY_VERIFY_WITH_TIMEOUT(heard("Choose a destination"), 60000);
    key(Qt::Key_W);
    QTRY_VERIFY(heard("No camera is set up"));
}

void KioskTest::aMissingLibraryIsTold() {
    m_start.library = m_folder.filePath(QStringLiteral("none.gpkg"));
    make();
    QTRY_VERIFY_WITH_TIMEOUT(heard("The landmarks cannot be loaded"), 60000);
    QTRY_COMPARE_WITH_TIMEOUT(m_kiosk->walk().state(), session::RunState::Running, 60000);
}

void KioskTest::itLeavesAfterTheLastWords() {
    start();
    QSignalSpy finished(m_kiosk.get(), &Kiosk::finished);
    key(Qt::Key_Escape);
    QTRY_VERIFY(heard("Leave Farol?"));
    key(Qt::Key_Escape);
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 60000);
    QVERIFY(heard("Goodbye."));
    QVERIFY(!m_page->isVisible());
}

void KioskTest::escapeHeldDown() {
    start();
    QSignalSpy finished(m_kiosk.get(), &Kiosk::finished);
    m_page->setHoldMs(0);
    QTest::keyPress(m_page.get(), Qt::Key_Escape);
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 60000);
}

void KioskTest::closingWhileLoading() {
    make();
    m_page->close();
    m_page.reset();
    m_kiosk.reset(); // waits for what runs; nothing is left that could still speak
    QVERIFY(!QFile::exists(m_start.memoryFile));
}

void KioskTest::aCrashIsRememberedAndAGoodEndIsNot() {
    start();
    key(Qt::Key_End);
    key(Qt::Key_Return);
    QTRY_VERIFY(QFile::exists(m_start.memoryFile));
    const auto destination = m_kiosk->machine().destination();
    make(); // without closing: as after a crash
    QTRY_VERIFY_WITH_TIMEOUT(heard("started again"), 60000);
    QCOMPARE(m_kiosk->machine().destination(), destination);
    QCOMPARE(m_kiosk->walk().destination(), destination);
    m_page->close();
    QVERIFY(!QFile::exists(m_start.memoryFile));
}

void KioskTest::theLanguageChangesAtOnce() {
    start();
    key(Qt::Key_F2);
    QTRY_VERIFY(heard("Falo português agora."));
    m_log.clear();
    key(Qt::Key_Down);
    QTRY_VERIFY(heard("1 de 6"));
    for (const char* now : {"Ahora hablo español.", "Je parle français maintenant.",
                            "Ich spreche jetzt Deutsch.", "I speak English now."}) {
        key(Qt::Key_F2);
        QTRY_VERIFY2(heard(now), now);
    }
}

/// From the key to the voice, with a walk running: what is the kiosk's own is said within the same call.
void KioskTest::keysSpeakBeforeALongWalk() {
    start();
    QTRY_VERIFY(heard("Choose a destination"));
    for (int i = 0; i < 5; ++i) {
        const qsizetype before = m_log.size();
        key(Qt::Key_Down);
        QTRY_VERIFY(m_log.size() > before);
    }
}

void KioskTest::everyKeyOfThePageSpeaks_data() {
    QTest::addColumn<KioskState>("state");
    for (const auto& [name, state] :
         std::initializer_list<std::pair<const char*, KioskState>>{{"list", KioskState::Choosing},
                                                                   {"search", KioskState::Typing},
                                                                   {"preview", KioskState::Preview},
                                                                   {"walking", KioskState::Walking},
                                                                   {"arrived", KioskState::Arrived},
                                                                   {"stop?", KioskState::StopQuestion},
                                                                   {"leave?", KioskState::LeaveQuestion},
                                                                   {"keys", KioskState::Help}})
        QTest::newRow(name) << state;
}

/// To a state by keys, as a user comes there.
void KioskTest::bring(KioskState state) {
    KioskMachine& machine = m_kiosk->machine();
    for (int i = 0; i < 6 && machine.state() != KioskState::Choosing; ++i) {
        const bool stays = machine.state() == KioskState::LeaveQuestion; // Escape would be a yes
        key(stays ? Qt::Key_Down : Qt::Key_Escape);
    }
    QCOMPARE(machine.state(), KioskState::Choosing);
    if (state == KioskState::Typing) key(Qt::Key_F);
    if (state == KioskState::LeaveQuestion) key(Qt::Key_Escape);
    if (state == KioskState::Help) key(Qt::Key_F1);
    const bool way =
        state == KioskState::Preview || state == KioskState::Walking || state == KioskState::StopQuestion;
    if (way || state == KioskState::Arrived) {
        key(way ? Qt::Key_End : Qt::Key_Home);
        if (!way) key(Qt::Key_Down); // where one is already
        key(Qt::Key_Return);
    }
    if (state == KioskState::Walking || state == KioskState::StopQuestion) key(Qt::Key_Return);
    if (state == KioskState::StopQuestion) key(Qt::Key_Escape);
    QTRY_COMPARE_WITH_TIMEOUT(machine.state(), state, 60000);
}

/// Also those that mean nothing there, and those that the walk has to answer.
void KioskTest::everyKeyOfThePageSpeaks() {
    QFETCH(KioskState, state);
    start();
    QList<int> keys{Qt::Key_Escape,   Qt::Key_Tab,     Qt::Key_Backtab, Qt::Key_Backspace, Qt::Key_Return,
                    Qt::Key_Insert,   Qt::Key_Delete,  Qt::Key_Home,    Qt::Key_End,       Qt::Key_Left,
                    Qt::Key_Up,       Qt::Key_Right,   Qt::Key_Down,    Qt::Key_PageUp,    Qt::Key_PageDown,
                    Qt::Key_CapsLock, Qt::Key_NumLock, Qt::Key_Menu,    Qt::Key_F1,        Qt::Key_F4,
                    Qt::Key_F12,      Qt::Key_Space,   Qt::Key_Plus,    Qt::Key_Minus,     Qt::Key_7};
    for (int letter = Qt::Key_A; letter <= Qt::Key_Z; ++letter) keys << letter;
    for (const int each : keys) {
        m_settings->setTwoKeys(false);
        bring(state);
        if (QTest::currentTestFailed()) return;
        const bool leaves =
            state == KioskState::LeaveQuestion && (each == Qt::Key_Escape || each == Qt::Key_Return);
        if (leaves) continue; // see itLeavesAfterTheLastWords()
        m_log.clear();
        key(each);
        QTRY_VERIFY2_WITH_TIMEOUT(!m_log.isEmpty() && !m_log.last().isEmpty(),
                                  qPrintable(QStringLiteral("key %1").arg(each)), 60000);
    }
}

void KioskTest::whatIsSaidIsWrittenDown() {
    m_start.utteranceFile = m_folder.filePath(QStringLiteral("said.jsonl"));
    QFile::remove(m_start.utteranceFile);
    start();
    key(Qt::Key_Down);
    key(Qt::Key_W);
    QTRY_VERIFY_WITH_TIMEOUT(heard("Main corridor"), 60000);
    QFile file(m_start.utteranceFile);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QJsonObject answer, place;
    double pressed = 0.0;
    while (!file.atEnd()) {
        const QJsonObject line = QJsonDocument::fromJson(file.readLine()).object();
        if (line[QStringLiteral("key")] == QStringLiteral("Down") && !line.contains(QStringLiteral("text")))
            pressed = line[QStringLiteral("at")].toDouble();
        if (line[QStringLiteral("state")] != QStringLiteral("speaking")) continue;
        if (line[QStringLiteral("cause")] == QStringLiteral("located")) place = line;
        if (line[QStringLiteral("text")].toString().endsWith(QLatin1String("1 of 6."))) answer = line;
    }
    QVERIFY(pressed > 0.0 && answer[QStringLiteral("at")].toDouble() >= pressed);
    QCOMPARE(answer[QStringLiteral("cause")].toString(), QStringLiteral("key"));
    QCOMPARE(answer[QStringLiteral("key")].toString(), QStringLiteral("Down"));
    QVERIFY(answer[QStringLiteral("age_ms")].toDouble() >= 0.0);
    QCOMPARE(place[QStringLiteral("key")].toString(), QStringLiteral("W"));
    QVERIFY(place[QStringLiteral("asked")].toBool() && place.contains(QStringLiteral("frame")));

    m_start.utteranceFile = m_folder.filePath(QStringLiteral("none/said.jsonl"));
    make(); // it goes on without
    QVERIFY(m_kiosk->detail().contains(QLatin1String("said.jsonl")));
    QTRY_VERIFY_WITH_TIMEOUT(heard("Choose a destination"), 60000);
}

void KioskTest::choose(int index) {
    key(Qt::Key_Home);
    for (int i = 0; i < index; ++i) key(Qt::Key_Down);
    key(Qt::Key_Return);
    QTRY_VERIFY(m_kiosk->machine().destination());
}

void KioskTest::picturesDeletedWhileRunningAreTold() {
    const QDir folder(m_folder.filePath(QStringLiteral("pictures")));
    QVERIFY(folder.mkpath(QStringLiteral(".")));
    QImage grey(64, 48, QImage::Format_RGB32);
    grey.fill(Qt::gray);
    for (int i = 0; i < 60; ++i)
        QVERIFY(grey.save(folder.filePath(QStringLiteral("%1.png").arg(i, 3, 10, QLatin1Char('0')))));
    m_start.source = folder.absolutePath();
    m_start.framesPerSecond = 20.0;
    start();
    QVERIFY(QDir(folder).removeRecursively());
    QTRY_VERIFY_WITH_TIMEOUT(heard("The camera gives no pictures"), 60000);
    QVERIFY(!m_kiosk->machine().title().isEmpty());
    key(Qt::Key_Down); // and the keys still speak
    QTRY_VERIFY(heard("1 of 6"));
    key(Qt::Key_Return);
    key(Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(!m_kiosk->detail().isEmpty(), 60000); // the folder that is not there
}

void KioskTest::anotherVoiceTakesOver() {
    VoiceChoice voice = m_settings->voice();
    voice.engine = QStringLiteral("hoarse");
    m_settings->setVoice(voice);
    m_works = [](const VoiceChoice& choice) { return choice.engine.isEmpty(); };
    make();
    QTRY_VERIFY_WITH_TIMEOUT(heard("The chosen voice does not work. This is another one."), 60000);
    QVERIFY(m_warnings > 0);
    QTRY_COMPARE(m_kiosk->machine().state(), KioskState::Choosing);
    m_log.clear();
    key(Qt::Key_Down);
    QTRY_VERIFY(heard("1 of 6"));
    QCOMPARE(m_settings->voice().engine, QStringLiteral("hoarse")); // the choice is the user's
}

void KioskTest::withoutAnyVoiceItIsShown() {
    m_works = [](const VoiceChoice&) { return false; };
    make();
    QTRY_VERIFY_WITH_TIMEOUT(heard("Choose a destination"), 60000);
    QTRY_COMPARE(m_kiosk->detail(), QStringLiteral("the fake voice is hoarse"));
    QVERIFY(m_warnings > 0);
    m_works = {};
    key(Qt::Key_Plus); // a new voice, that works
    key(Qt::Key_Down);
    QTRY_VERIFY(heard("1 of 6"));
    QTRY_VERIFY(m_kiosk->detail().isEmpty());
}

void KioskTest::aChangedMapIsUsedWhenNobodyIsLed() {
    const QString house = m_folder.filePath(QStringLiteral("house.gpkg"));
    m_start.map = m_folder.filePath(QStringLiteral("changing.gpkg"));
    QFile::remove(m_start.map);
    QVERIFY(QFile::copy(house, m_start.map));
    start();
    choose(3);
    const auto before = m_kiosk->walk().building();
    building::BuildingData data = before->data();
    for (building::Region& region : data.regions)
        if (region.id == RegionId("r2")) region.name = "Kitchen";
    QVERIFY(building::saveBuilding(building::Building(data), toUtf8(m_start.map)).ok());
    QTRY_VERIFY_WITH_TIMEOUT(m_kiosk->detail().contains(QLatin1String("after this way")), 60000);
    QCOMPARE(m_kiosk->walk().building(), before); // who is led is led by the old one
    QVERIFY(m_kiosk->machine().destination());
    m_log.clear();
    key(Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(heard("The map has been changed, and I use the new one."), 60000);
    QVERIFY(m_kiosk->walk().building()->region(RegionId("r2"))->name == "Kitchen");
    QTRY_COMPARE_WITH_TIMEOUT(m_kiosk->walk().state(), session::RunState::Running, 60000);
    QVERIFY(m_kiosk->detail().isEmpty());
}

void KioskTest::aMapThatIsGoneIsKept() {
    m_start.map = m_folder.filePath(QStringLiteral("going.gpkg"));
    QVERIFY(QFile::copy(m_folder.filePath(QStringLiteral("house.gpkg")), m_start.map));
    start();
    QVERIFY(QFile::remove(m_start.map));
    QTRY_VERIFY_WITH_TIMEOUT(m_kiosk->detail().contains(QLatin1String("The file of the map is gone")), 60000);
    choose(1);
    key(Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(heard("The file of the map is gone. I keep the map that I have."), 60000);
}

void KioskTest::aFolderThatCannotBeWrittenIsTold() {
    m_start.memoryFile = QStringLiteral("/proc/none/state.json");
    start();
    QVERIFY(heard("The destination cannot be kept for a restart"));
    QTRY_VERIFY(m_kiosk->detail().contains(QLatin1String("cannot be kept")));
    choose(2); // it guides all the same
    QCOMPARE(m_kiosk->machine().state(), KioskState::Preview);
}

void KioskTest::aFullDiskIsTold() {
    m_start.utteranceFile = m_folder.filePath(QStringLiteral("full.jsonl"));
    start();
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    rlimit none = before;
    none.rlim_cur = 0;
    setrlimit(RLIMIT_FSIZE, &none);
    key(Qt::Key_End);
    key(Qt::Key_Return);
    const bool told = QTest::qWaitFor([&] { return !m_kiosk->detail().isEmpty(); }, 60000);
    m_log.clear();
    key(Qt::Key_Escape);
    setrlimit(RLIMIT_FSIZE, &before);
    QVERIFY(told);
    QTRY_VERIFY(heard("The destination cannot be kept for a restart"));
    QVERIFY(m_kiosk->detail().contains(QLatin1String("full.jsonl")));
}

void KioskTest::twoKiosksOfOneUser() {
    start();
    choose(3);
    QTRY_VERIFY(QFile::exists(m_start.memoryFile));
    QStringList said;
    int warnings = 0;
    Kiosk second(
        *m_settings, m_start, {}, [](const VoiceChoice&) { return std::make_unique<test::FakeVoice>(); },
        std::make_unique<CountedChimes>(warnings));
    QSignalSpy finished(&second, &Kiosk::finished);
    connect(&second, &Kiosk::spoken, this, [&](const QString& text) { said << text; });
    second.begin();
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 60000);
    QCOMPARE(said, QStringList(QStringLiteral("Farol is already running here. I close this one. Goodbye.")));
    QVERIFY(second.detail().contains(QLatin1String("Another Farol kiosk")));
    second.close();
    QVERIFY(QFile::exists(m_start.memoryFile)); // it is the first one's
    QVERIFY(m_kiosk->machine().destination());
}

void KioskTest::closingWhileLed() {
    start();
    choose(3);
    key(Qt::Key_Return);
    QCOMPARE(m_kiosk->machine().state(), KioskState::Walking);
    m_page->close();
    m_page.reset();
    m_kiosk.reset();
    QVERIFY(!QFile::exists(m_start.memoryFile)); // a good end is no crash
    make();                                      // and nothing is locked
    QTRY_VERIFY_WITH_TIMEOUT(heard("Choose a destination"), 60000);
}

/// A camera without a lens: whoever is led stands where the source says, until the way is started.
void KioskTest::theSimulatedUserStandsThere() {
    m_start.source = QStringLiteral("sim:r1");
    make(0, QString());
    QSignalSpy moved(&m_kiosk->user(), &SimulatedUser::movedTo);
    QTRY_COMPARE_WITH_TIMEOUT(moved.count(), 1, 120000);
    QCOMPARE(moved.front().front().value<RegionId>(), RegionId("r1"));
    QTRY_COMPARE(m_kiosk->machine().state(), KioskState::Choosing);
    QCOMPARE(m_kiosk->walk().start(), RegionId("r1"));
    QVERIFY(!m_kiosk->walk().destination()); // nobody chose one
    m_start.source = QStringLiteral("sim:nowhere");
    make(0, QString());
    QTRY_VERIFY_WITH_TIMEOUT(heard("The camera gives no pictures"), 120000);
}

void KioskTest::thePageHasNamesAndLargeLetters() {
    for (const Language& language : languages()) {
        m_settings->setLanguage(language.code);
        start();
        installTranslation(language.code);
        m_kiosk->machine().retranslate();
        key(Qt::Key_F1); // the longest text
        QTRY_COMPARE(m_kiosk->machine().state(), KioskState::Help);
        QVERIFY(!m_page->accessibleName().isEmpty());
        for (const QLabel* label : m_page->findChildren<QLabel*>()) {
            if (!label->isVisible()) continue;
            QVERIFY2(!label->accessibleName().isEmpty(), qPrintable(label->objectName()));
            QVERIFY(QFontInfo(label->font()).pointSizeF() >= 39.5);
            QTRY_VERIFY(label->height() >= label->heightForWidth(label->width())); // once it is laid out
        }
        const auto* area = m_page->findChild<QScrollArea*>();
        QVERIFY(area->viewport()->height() >= 200); // three lines of what is said
    }
}

} // namespace farol::ui

QTEST_MAIN(farol::ui::KioskTest)
#include "test_kiosk.moc"
