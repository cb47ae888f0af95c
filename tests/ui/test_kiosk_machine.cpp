// The kiosk by its keys and its words alone: no screen, no walk.

#include "tests/ui/hand_made.h"
#include "ui/kiosk/chimes.h"
#include "ui/kiosk/kiosk_machine.h"
#include "ui/kiosk/kiosk_memory.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace farol::ui {

using guidance::Cue;
using guidance::CueKind;
using guidance::CuePriority;

class KioskMachineTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void aPlaceIsChosenByArrows();
    void aPlaceIsChosenByTyping();
    void aNumberBeginsTheSearch();
    void nothingFits();
    void kindsAndFloors();
    void nothingIsTakenUnheard();
    void everyKeyFromEveryStateSpeaks();
    void oneKeyGoesThroughTheLanguages();
    void settingsAreKept();
    void quietTellsWarningsAndAnswersOnly();
    void theNumberPad_data();
    void theNumberPad();
    void helpTellsWhatAKeyDoes();
    void backAndOut();
    void anyOtherKeyStays();
    void escapeHeldDownLeaves();
    void twoKeysDoEverything();
    void arrivalAndRefusal();
    void theCameraGoesAndComes();
    void lookingAround();
    void aSlowAnswerIsAnnounced();
    void aMapWithoutPlaces();
    void aMapThatCannotBeOpened();
    void afterACrash();
    void placesThatSoundAlike();
    void theMemoryIsWholeOrAbsent();
    void theTwoSoundsDiffer();

private:
    void press(int key, const QString& text = {}, bool keypad = false) {
        m_machine->press({key, text, keypad});
    }
    void type(const char* text);
    void make(const std::shared_ptr<const building::Building>& building);
    void bring(KioskState state);
    QString last() const { return m_log.isEmpty() ? QString() : m_log.last(); }
    bool heard(const char* part) const { return last().contains(QString::fromUtf8(part)); }

    QTemporaryDir m_folder;
    std::unique_ptr<Settings> m_settings;
    std::unique_ptr<KioskMachine> m_machine;
    QStringList m_log; ///< what is said, and "? n" for what is asked
};

void KioskMachineTest::init() {
    installTranslation(QStringLiteral("en"));
    m_machine.reset();
    m_settings.reset(); // writes before the file goes
    QFile::remove(m_folder.filePath(QStringLiteral("kiosk.ini")));
    m_settings = std::make_unique<Settings>(m_folder.filePath(QStringLiteral("kiosk.ini")));
    make(test::handMadeBuilding());
}

void KioskMachineTest::make(const std::shared_ptr<const building::Building>& building) {
    m_machine = std::make_unique<KioskMachine>(*m_settings);
    m_log.clear();
    connect(m_machine.get(), &KioskMachine::said, this, [this](const QString& text) { m_log << text; });
    connect(m_machine.get(), &KioskMachine::asked, this, [this](KioskQuestion question) {
        m_log << QStringLiteral("? %1").arg(static_cast<int>(question));
    });
    if (building) m_machine->setBuilding(building);
    m_machine->setCamera(KioskCamera::Running);
}

void KioskMachineTest::type(const char* text) {
    for (const QChar letter : QString::fromUtf8(text)) press(letter.toUpper().unicode(), QString(letter));
}

void KioskMachineTest::bring(KioskState state) {
    make(state == KioskState::Loading ? nullptr : test::handMadeBuilding());
    if (state == KioskState::Typing) press(Qt::Key_F, QStringLiteral("f"));
    const bool way = state == KioskState::Preview || state == KioskState::Walking ||
                     state == KioskState::Arrived || state == KioskState::StopQuestion;
    if (way) {
        press(Qt::Key_Down);
        press(Qt::Key_Return);
    }
    if (way && state != KioskState::Preview) press(Qt::Key_Return);
    if (state == KioskState::Arrived) {
        Cue arrived;
        arrived.kind = CueKind::Arrived;
        m_machine->told(arrived);
    }
    if (state == KioskState::StopQuestion || state == KioskState::LeaveQuestion) press(Qt::Key_Escape);
    if (state == KioskState::Help) press(Qt::Key_F1);
    if (state == KioskState::Leaving) m_machine->holdBack();
    QCOMPARE(m_machine->state(), state);
}

void KioskMachineTest::aPlaceIsChosenByArrows() {
    QVERIFY(heard("6 places"));
    press(Qt::Key_Down);
    QCOMPARE(last(), QStringLiteral("Café 0.02, level G. 1 of 6."));
    press(Qt::Key_Down);
    QCOMPARE(last(), QStringLiteral("Main corridor, level G. 2 of 6."));
    press(Qt::Key_Up);
    press(Qt::Key_Up);
    QVERIFY(heard("first place") && heard("Café"));
    press(Qt::Key_End);
    QVERIFY(heard("6 of 6"));
    press(Qt::Key_Down);
    QVERIFY(heard("last place") && heard("6 of 6"));
    press(Qt::Key_Home);
    QSignalSpy chosen(m_machine.get(), &KioskMachine::destinationChosen);
    press(Qt::Key_Return);
    QCOMPARE(m_machine->state(), KioskState::Preview);
    QCOMPARE(m_machine->destination(), RegionId("r2"));
    QCOMPARE(chosen.count(), 1);
    QVERIFY(heard("To: Café 0.02") && heard("do not know yet where you are"));
    press(Qt::Key_L);
    QCOMPARE(last(), QStringLiteral("? 5")); // the whole way, before the start
    press(Qt::Key_Return);
    QCOMPARE(m_machine->state(), KioskState::Walking);
    QCOMPARE(last(), QStringLiteral("? 2"));
    press(Qt::Key_L);
    QCOMPARE(last(), QStringLiteral("? 3"));
    press(Qt::Key_Space, QStringLiteral(" "));
    QCOMPARE(last(), QStringLiteral("? 4"));
}

void KioskMachineTest::aPlaceIsChosenByTyping() {
    press(Qt::Key_F, QStringLiteral("f"));
    QVERIFY(heard("Type part of a name"));
    type("cafe"); // without its accent
    QVERIFY(heard("e: 1 place"));
    press(Qt::Key_Backspace);
    QVERIFY(heard("Deleted: e"));
    press(Qt::Key_Return);
    QVERIFY(heard("Café 0.02"));
    QVERIFY(!m_machine->destination()); // heard first
    press(Qt::Key_Return);
    QCOMPARE(m_machine->destination(), RegionId("r2"));
}

void KioskMachineTest::aNumberBeginsTheSearch() {
    press(Qt::Key_1, QStringLiteral("1"));
    QCOMPARE(m_machine->state(), KioskState::Typing);
    type(".01");
    press(Qt::Key_Return);
    press(Qt::Key_Return);
    QCOMPARE(m_machine->destination(), RegionId("lib"));
}

void KioskMachineTest::nothingFits() {
    press(Qt::Key_F, QStringLiteral("f"));
    type("zoo");
    press(Qt::Key_Return);
    QVERIFY(heard("No place fits: zoo"));
    QCOMPARE(m_machine->state(), KioskState::Typing);
    press(Qt::Key_Down);
    QVERIFY(heard("No place fits"));
    press(Qt::Key_Escape);
    QCOMPARE(m_machine->state(), KioskState::Choosing);
    QVERIFY(heard("6 places"));
}

void KioskMachineTest::kindsAndFloors() {
    press(Qt::Key_Right);
    QVERIFY(heard("Rooms: 3 places. Café"));
    press(Qt::Key_Left);
    QVERIFY(heard("All places: 6"));
    press(Qt::Key_Left);
    QVERIFY(heard("Level 1: 2 places"));
    press(Qt::Key_Return);
    QCOMPARE(m_machine->destination(), RegionId("lib"));
}

void KioskMachineTest::nothingIsTakenUnheard() {
    press(Qt::Key_Return);
    QCOMPARE(m_machine->state(), KioskState::Choosing);
    QVERIFY(heard("Nothing is chosen yet"));
}

void KioskMachineTest::everyKeyFromEveryStateSpeaks() {
    QList<int> keys{Qt::Key_Escape,   Qt::Key_Tab,    Qt::Key_Backspace, Qt::Key_Return, Qt::Key_Enter,
                    Qt::Key_Insert,   Qt::Key_Delete, Qt::Key_Pause,     Qt::Key_Home,   Qt::Key_End,
                    Qt::Key_Left,     Qt::Key_Up,     Qt::Key_Right,     Qt::Key_Down,   Qt::Key_PageUp,
                    Qt::Key_PageDown, Qt::Key_Menu,   Qt::Key_Ccedilla};
    for (int key = Qt::Key_F1; key <= Qt::Key_F12; ++key) keys << key;
    for (int key = Qt::Key_Space; key <= Qt::Key_AsciiTilde; ++key) keys << key;
    for (int state = 0; state <= static_cast<int>(KioskState::Leaving); ++state) {
        for (const bool twoKeys : {false, true}) {
            for (const bool keypad : {false, true}) {
                for (const int key : keys) {
                    bring(static_cast<KioskState>(state));
                    m_settings->setTwoKeys(twoKeys);
                    const qsizetype before = m_log.size();
                    const bool typed = key <= Qt::Key_AsciiTilde;
                    press(key, typed ? QString(QChar(key)).toLower() : QString(), keypad);
                    QVERIFY2(m_log.size() > before && !last().isEmpty(),
                             qPrintable(QStringLiteral("state %1, key %2").arg(state).arg(key)));
                    if (QTest::currentTestFailed()) return;
                    m_settings->setTwoKeys(false);
                }
            }
        }
        m_settings->setLanguage(QStringLiteral("en"));
    }
}

void KioskMachineTest::oneKeyGoesThroughTheLanguages() {
    m_settings->setLanguage(QStringLiteral("en"));
    installTranslation(QStringLiteral("en"));
    QStringList chosen;
    for (qsizetype i = 0; i < languages().size(); ++i) {
        press(Qt::Key_F2);
        chosen << m_settings->language();
        installTranslation(m_settings->language());
    }
    QCOMPARE(chosen, QStringList({QStringLiteral("pt"), QStringLiteral("es"), QStringLiteral("fr"),
                                  QStringLiteral("de"), QStringLiteral("en")}));
}

void KioskMachineTest::settingsAreKept() {
    press(Qt::Key_Plus, QStringLiteral("+"));
    QCOMPARE(last(), QStringLiteral("Speed 7 of 11."));
    for (int i = 0; i < 20; ++i) press(Qt::Key_Minus, QStringLiteral("-"));
    QCOMPARE(last(), QStringLiteral("Speed 1 of 11."));
    press(Qt::Key_V);
    QVERIFY(heard("objects and texts"));
    press(Qt::Key_V);
    QVERIFY(heard("directions only"));
    press(Qt::Key_D);
    QVERIFY(heard("clock"));
    press(Qt::Key_U);
    QVERIFY(heard("feet"));
    m_settings->sync();
    const Settings again(m_folder.filePath(QStringLiteral("kiosk.ini")));
    QCOMPARE(again.voice().rate, -1.0);
    QCOMPARE(again.verbosity(), guidance::Verbosity::Directions);
    QCOMPARE(again.directionStyle(), DirectionStyle::Clock);
    QCOMPARE(again.unit(), DistanceUnit::Feet);
}

void KioskMachineTest::quietTellsWarningsAndAnswersOnly() {
    bring(KioskState::Walking);
    Cue turn;
    turn.kind = CueKind::Act;
    turn.priority = CuePriority::ActNow;
    Cue stop;
    stop.kind = CueKind::Warning;
    stop.priority = CuePriority::Warning;
    QVERIFY(m_machine->wants(turn));
    press(Qt::Key_M);
    QVERIFY(heard("Quiet"));
    QVERIFY(!m_machine->wants(turn));
    QVERIFY(m_machine->wants(stop));
    press(Qt::Key_W);
    QCOMPARE(last(), QStringLiteral("? 0"));
    press(Qt::Key_M);
    QVERIFY(m_machine->wants(turn));
}

void KioskMachineTest::theNumberPad_data() {
    QTest::addColumn<int>("locked");
    QTest::addColumn<int>("unlocked");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char* name, int locked, int unlocked, const char* expected) {
        QTest::newRow(name) << locked << unlocked << QString::fromUtf8(expected);
    };
    row("2", Qt::Key_2, Qt::Key_Down, "Café 0.02, level G. 1 of 6.");
    row("6", Qt::Key_6, Qt::Key_Right, "Rooms: 3 places. Café 0.02, level G.");
    row("1", Qt::Key_1, Qt::Key_End, "? 0");
    row("3", Qt::Key_3, Qt::Key_PageDown, "? 1");
    row("5", Qt::Key_5, Qt::Key_Clear, "Nothing is chosen yet. Press arrow down to hear the places.");
    row("point", Qt::Key_Period, Qt::Key_Delete, "Leave Farol? Enter or Escape: yes. Any other key: no.");
}

void KioskMachineTest::theNumberPad() {
    QFETCH(int, locked);
    QFETCH(int, unlocked);
    QFETCH(QString, expected);
    press(locked, QString(QChar(locked)), true);
    QCOMPARE(last(), expected);
    make(test::handMadeBuilding());
    press(unlocked, {}, true);
    QCOMPARE(last(), expected);
}

void KioskMachineTest::helpTellsWhatAKeyDoes() {
    bring(KioskState::Walking);
    press(Qt::Key_F1);
    for (const KioskCommand command : kioskCommands()) {
        QVERIFY(last().contains(KioskWords::meaning(command)));
        QVERIFY(!KioskWords::key(command).isEmpty());
    }
    press(Qt::Key_M);
    QVERIFY(heard("M: quiet"));
    QVERIFY(!m_machine->quiet()); // told, not done
    press(Qt::Key_F1);
    QVERIFY(heard("Number pad"));
    press(Qt::Key_Escape);
    QCOMPARE(m_machine->state(), KioskState::Walking);
}

void KioskMachineTest::backAndOut() {
    bring(KioskState::Walking);
    QSignalSpy left(m_machine.get(), &KioskMachine::left);
    press(Qt::Key_Escape);
    QVERIFY(heard("Stop the guidance?"));
    QVERIFY(m_machine->destination()); // the guidance goes on while it is asked
    press(Qt::Key_Escape);
    QCOMPARE(m_machine->state(), KioskState::Choosing);
    QVERIFY(!m_machine->destination());
    press(Qt::Key_Escape);
    QVERIFY(heard("Leave Farol?"));
    QCOMPARE(left.count(), 0);
    press(Qt::Key_Escape);
    QCOMPARE(last(), QStringLiteral("Goodbye."));
    QCOMPARE(left.count(), 1);
}

void KioskMachineTest::anyOtherKeyStays() {
    bring(KioskState::StopQuestion);
    press(Qt::Key_X, QStringLiteral("x"));
    QCOMPARE(m_machine->state(), KioskState::Walking);
    QVERIFY(heard("Going on. On the way to"));
    bring(KioskState::LeaveQuestion);
    press(Qt::Key_W);
    QCOMPARE(m_machine->state(), KioskState::Choosing);
}

void KioskMachineTest::escapeHeldDownLeaves() {
    bring(KioskState::Walking);
    QSignalSpy left(m_machine.get(), &KioskMachine::left);
    m_machine->holdBack();
    m_machine->holdBack();
    QCOMPARE(left.count(), 1);
    QCOMPARE(last(), QStringLiteral("Goodbye."));
}

/// From the list to the way and out again with space and Enter alone.
void KioskMachineTest::twoKeysDoEverything() {
    press(Qt::Key_F4);
    QVERIFY(heard("Two keys"));
    const auto scan = [this] { press(Qt::Key_Space, QStringLiteral(" ")); };
    const auto take = [this] { press(Qt::Key_Return); };
    const auto scanTo = [&](const char* part) {
        for (int i = 0; i < 30; ++i) {
            scan();
            if (heard(part)) return true;
        }
        return false;
    };
    take();
    QVERIFY(heard("Press space"));
    QVERIFY(scanTo("Rooms"));
    take();
    QVERIFY(heard("Rooms: 3 places"));
    QVERIFY(scanTo("Back to the kinds"));
    take();
    QVERIFY(scanTo("Rooms"));
    take();
    QVERIFY(scanTo("Library"));
    take();
    QCOMPARE(m_machine->state(), KioskState::Preview);
    QCOMPARE(m_machine->destination(), RegionId("lib"));
    QVERIFY(scanTo("whole way"));
    take();
    QCOMPARE(last(), QStringLiteral("? 5"));
    QVERIFY(scanTo("Start"));
    take();
    QCOMPARE(m_machine->state(), KioskState::Walking);
    QVERIFY(scanTo("Where am I"));
    take();
    QCOMPARE(last(), QStringLiteral("? 0"));
    QVERIFY(scanTo("Stop the guidance"));
    take();
    QVERIFY(scanTo("No"));
    take();
    QCOMPARE(m_machine->state(), KioskState::Walking);
    QVERIFY(scanTo("Stop the guidance"));
    take();
    QVERIFY(scanTo("Yes"));
    take();
    QCOMPARE(m_machine->state(), KioskState::Choosing);
    QVERIFY(scanTo("Leave Farol"));
    take();
    QVERIFY(scanTo("Yes"));
    take();
    QCOMPARE(m_machine->state(), KioskState::Leaving);
}

void KioskMachineTest::arrivalAndRefusal() {
    bring(KioskState::Walking);
    Cue arrived;
    arrived.kind = CueKind::Arrived;
    QVERIFY(m_machine->wants(arrived));
    QCOMPARE(m_machine->state(), KioskState::Walking); // it may expire before anybody hears it
    m_machine->told(arrived);
    QCOMPARE(m_machine->state(), KioskState::Arrived);
    press(Qt::Key_Space);
    QVERIFY(heard("You have arrived"));
    press(Qt::Key_Return);
    QCOMPARE(m_machine->state(), KioskState::Choosing);
    // What was told as probable does not become certain by being told again.
    bring(KioskState::Walking);
    arrived.sure = false;
    m_machine->told(arrived);
    press(Qt::Key_Space);
    QVERIFY(heard("You have probably arrived"));
    QVERIFY(m_machine->title().contains(QStringLiteral("Probably")));
    bring(KioskState::Preview);
    Cue refusal;
    refusal.kind = CueKind::NoRoute;
    QVERIFY(m_machine->wants(refusal));
    QCOMPARE(m_machine->state(), KioskState::Choosing);
    QVERIFY(!m_machine->destination());
    // Who waits for the way hears why there is none yet; who has it can listen to it.
    bring(KioskState::Preview);
    Cue unsure;
    unsure.kind = CueKind::Unsure;
    unsure.priority = CuePriority::OffRoute;
    QVERIFY(m_machine->wants(unsure));
    Cue way;
    way.kind = CueKind::RouteStart;
    QVERIFY(m_machine->wants(way));
    QVERIFY(!m_machine->wants(unsure));
    // The way to the place that was chosen before is not the way to this one.
    bring(KioskState::Preview);
    way.region = RegionId{"elsewhere"};
    QVERIFY(!m_machine->wants(way));
    arrived.region = RegionId{"elsewhere"};
    QVERIFY(!m_machine->wants(arrived));
    QCOMPARE(m_machine->state(), KioskState::Preview);
    way.region = *m_machine->destination();
    QVERIFY(m_machine->wants(way));
    bring(KioskState::Choosing);
    // While a place is being chosen nobody is told to walk.
    Cue turn;
    turn.kind = CueKind::Act;
    turn.priority = CuePriority::ActNow;
    QVERIFY(!m_machine->wants(turn));
    bring(KioskState::StopQuestion);
    QVERIFY(m_machine->wants(turn));
}

void KioskMachineTest::theCameraGoesAndComes() {
    bring(KioskState::Walking);
    QSignalSpy wanted(m_machine.get(), &KioskMachine::cameraWanted);
    m_machine->setCamera(KioskCamera::Gone);
    QVERIFY(heard("Stop. The camera gives no pictures"));
    press(Qt::Key_W);
    QVERIFY(heard("The camera gives no pictures"));
    press(Qt::Key_Return);
    QCOMPARE(wanted.count(), 1);
    QVERIFY(heard("try the camera again"));
    m_machine->setCamera(KioskCamera::Opening);
    m_machine->setCamera(KioskCamera::Running);
    QVERIFY(heard("works again"));
}

void KioskMachineTest::lookingAround() {
    bring(KioskState::Walking);
    m_machine->setPace(0, 100000);
    Cue lost;
    lost.kind = CueKind::Unsure;
    press(Qt::Key_S);
    QVERIFY(heard("turn slowly to the right"));
    QVERIFY(!m_machine->wants(lost)); // one coach at a time
    QTRY_COMPARE(last(), QStringLiteral("? 0"));
    QVERIFY(m_log.filter(QStringLiteral("to the left")).size() == 1);
    QVERIFY(m_log.filter(QStringLiteral("up.")).size() == 1);
    QVERIFY(m_log.filter(QStringLiteral("down.")).size() == 1);
    press(Qt::Key_S);
    press(Qt::Key_N); // any key ends it
    QVERIFY(m_machine->wants(lost));
}

void KioskMachineTest::aSlowAnswerIsAnnounced() {
    bring(KioskState::Walking);
    m_machine->setPace(100000, 0);
    press(Qt::Key_W);
    QTRY_COMPARE(last(), QStringLiteral("One moment."));
    press(Qt::Key_W);
    m_machine->answered();
    QCoreApplication::processEvents();
    QCOMPARE(last(), QStringLiteral("? 0"));
}

void KioskMachineTest::aMapWithoutPlaces() {
    building::BuildingData empty;
    empty.regions.resize(1);
    empty.regions[0].id = RegionId("x");
    make(std::make_shared<const building::Building>(empty));
    QVERIFY(heard("no places to go to"));
    press(Qt::Key_Down);
    QVERIFY(heard("no places to go to"));
    press(Qt::Key_Escape);
    QVERIFY(heard("Leave Farol?"));
}

void KioskMachineTest::aMapThatCannotBeOpened() {
    make(nullptr);
    press(Qt::Key_Down);
    QVERIFY(heard("being opened"));
    m_machine->mapFailed();
    QVERIFY(heard("cannot be opened"));
    press(Qt::Key_Return);
    QVERIFY(heard("cannot be opened"));
}

void KioskMachineTest::afterACrash() {
    make(nullptr);
    m_machine->setWish(RegionId("lib"), true, RegionId("c"));
    m_machine->setBuilding(test::handMadeBuilding());
    QCOMPARE(m_machine->state(), KioskState::Preview);
    QCOMPARE(m_machine->destination(), RegionId("lib"));
    QVERIFY(heard("started again") && heard("last here: Main corridor") && heard("To: Library"));
    make(nullptr); // the map has changed since
    m_machine->setWish(RegionId("gone"), true, RegionId("c"));
    m_machine->setBuilding(test::handMadeBuilding());
    QCOMPARE(m_machine->state(), KioskState::Choosing);
}

void KioskMachineTest::placesThatSoundAlike() {
    building::BuildingData data = test::handMadeBuilding()->data();
    data.regions[1].name = data.regions[2].name = "Office";
    data.regions[1].ref = data.regions[2].ref = "";
    make(std::make_shared<const building::Building>(data));
    press(Qt::Key_F, QStringLiteral("f"));
    type("office");
    press(Qt::Key_Return);
    const QString first = last();
    press(Qt::Key_Down);
    QVERIFY(first.contains(QLatin1String("Office, level G, r1")));
    QVERIFY(heard("Office, level G, r2"));
}

void KioskMachineTest::theMemoryIsWholeOrAbsent() {
    const QString file = m_folder.filePath(QStringLiteral("deep/kiosk.json"));
    const KioskMemory memory(file);
    QVERIFY(!memory.load());
    QVERIFY(memory.save({QStringLiteral("m.gpkg"), QStringLiteral("lib"), QStringLiteral("c")}));
    QVERIFY(memory.load());
    QCOMPARE(memory.load()->region, QStringLiteral("c"));
    memory.forget();
    QVERIFY(!memory.load());
    QFile damaged(file);
    QVERIFY(damaged.open(QIODevice::WriteOnly));
    damaged.write("{\"map\": ");
    damaged.close();
    QVERIFY(!memory.load());
    QVERIFY(!KioskMemory(QStringLiteral("/proc/none/kiosk.json")).save({}));
}

void KioskMachineTest::theTwoSoundsDiffer() {
    const QByteArray fix = chimeSamples(Sound::Fix);
    QVERIFY(fix != chimeSamples(Sound::Warning));
    QVERIFY(fix.size() > 10000 && fix.size() < 96000); // under a second
}

} // namespace farol::ui

QTEST_GUILESS_MAIN(farol::ui::KioskMachineTest)
#include "test_kiosk_machine.moc"
