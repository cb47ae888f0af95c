// What a walker hears, in which order, and what is never said.

#include "tests/ui/recording_output.h"
#include "ui/speech/speech_queue.h"

#include <QSignalSpy>

using namespace farol;
using guidance::Cue;
using guidance::CueKind;
using guidance::CuePriority;
using guidance::CueReason;
using test::RecordingOutput;
using ui::SpeechQueue;
using ui::Utterance;
using ui::UtteranceState;

namespace {

Cue cueOf(CueKind kind, CuePriority priority, double time = 0.0) {
    Cue cue;
    cue.kind = kind;
    cue.priority = priority;
    cue.time = time;
    return cue;
}

Cue turn(CueKind kind, double degrees, double x = 0.0, double time = 0.0) {
    Cue cue = cueOf(kind, kind == CueKind::Act ? CuePriority::ActNow : CuePriority::Prepare, time);
    cue.manoeuvre.emplace();
    cue.manoeuvre->kind = routing::ManoeuvreKind::Turn;
    cue.manoeuvre->turn = fromDegrees(degrees);
    cue.manoeuvre->position = {x, 0.0};
    return cue;
}

Cue seen(Kind kind, double time = 0.0) {
    Cue cue = cueOf(CueKind::Detection, CuePriority::Detection, time);
    cue.objectKind = kind;
    cue.zone = {Column::Left, Row::Down};
    return cue;
}

Cue warning(CueReason reason) {
    Cue cue = cueOf(CueKind::Warning, CuePriority::Warning);
    cue.reason = reason;
    return cue;
}

Cue reassure(double time = 0.0) {
    return cueOf(CueKind::Reassure, CuePriority::Reassurance, time);
}

const QString kLeft = QStringLiteral("Turn left.");
const QString kRight = QStringLiteral("Turn right.");
const QString kSoonRight = QStringLiteral("Soon, turn right.");
const QString kKeep = QStringLiteral("Keep moving forward.");
const QString kExtinguisher = QStringLiteral("Extinguisher, left, down.");
const QString kDoor = QStringLiteral("Door, left, down.");
const QString kUnsure = QStringLiteral(
    "I am not sure where you are. Stop, and turn slowly to the right, so that I can look around.");

struct Walk {
    Walk() : queue(output, phrasebook) {
        queue.setGapMs(0);
        QObject::connect(&queue, &SpeechQueue::changed, &queue, [this](const Utterance& utterance) {
            changes.append(qMakePair(utterance.text, utterance.state));
        });
    }
    /// The states a text went through.
    QList<UtteranceState> statesOf(const QString& text) const {
        QList<UtteranceState> states;
        for (const auto& change : changes) {
            if (change.first == text) states << change.second;
        }
        return states;
    }
    void finishAll() {
        while (output.speaking()) output.finish();
    }

    RecordingOutput output;
    ui::Phrasebook phrasebook;
    SpeechQueue queue;
    QList<QPair<QString, UtteranceState>> changes;
};

using States = QList<UtteranceState>;

} // namespace

class TestSpeechQueue : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void ownWordsComeAtOnceAndCostNoInstruction();
    void aWarningIsSpokenToItsEndBeforeOwnWords();
    void anotherVoiceLosesNothing();
    void initTestCase() { QVERIFY(ui::installTranslation(QStringLiteral("en"))); }
    void speaksInOrderOfUrgencyThenArrival();
    void urgentCueInterrupts();
    void equalOrLowerCueWaits();
    void remarkDoesNotCostTheTurn();
    void expiredIsNeverSpoken();
    void cueOfAnotherPlaceIsNeverSpoken();
    void cueOfAnOldRouteIsCutOff();
    void aWayGivenUpIsNotTold();
    void nothingToMoveWaitsBehindStop();
    void theAnnouncementOfAnOrderIsHeardToItsEnd();
    void anOldDistanceIsNotSpoken();
    void whoTurnsIsToldToStopEachTime();
    void theLastOrderIsHeardToItsEnd();
    void actMakesItsPreparationSuperfluous();
    void sameTextIsNotRepeatedWithin15Seconds();
    void sameWordsAtTwoCornersAreBothTold();
    void theSameChoiceIsAnsweredAgain();
    void interruptedTextMayComeAgain();
    void repeatSaysTheLastActionWithoutOldFigures();
    void repeatWithoutAnythingSaysSo();
    void repeatDoesNotTalkOverAWarning();
    void mutedTextIsShown();
    void failureIsShownAndToldOncePerCause();
    void clearForgetsTheWalk();
    void gapSeparatesUtterancesButNotUrgentOnes();
    void lateReportsOfTheVoiceAreHarmless();
    void emptySentenceIsNothing();
};

/// Who goes through the last door hears all of "go through the door", then that it was the last one.
void TestSpeechQueue::theAnnouncementOfAnOrderIsHeardToItsEnd() {
    Walk walk;
    walk.queue.add(turn(CueKind::Prepare, -90));
    walk.queue.add(turn(CueKind::Act, -90, 0.0, 4.0));
    QCOMPARE(walk.output.said.last(), kSoonRight);
    walk.finishAll();
    QCOMPARE(walk.output.said, (QStringList{kSoonRight, kRight}));

    // Of another corner, and of a place that has been passed by then.
    Walk other;
    other.queue.add(turn(CueKind::Prepare, -90, 5.0));
    other.queue.add(turn(CueKind::Act, 90, 0.0, 4.0));
    QCOMPARE(other.output.said.last(), kLeft);
    Walk passed;
    passed.queue.add(turn(CueKind::Prepare, -90));
    Cue act = turn(CueKind::Act, -90, 0.0, 4.0);
    act.validUntil = 8.0;
    passed.queue.add(act);
    passed.queue.setNow(8.5, RegionId("corridor"), 0);
    passed.finishAll();
    QCOMPARE(passed.output.said, QStringList{kSoonRight});
}

void TestSpeechQueue::anOldDistanceIsNotSpoken() {
    Walk walk;
    walk.queue.add(turn(CueKind::Act, 90));
    Cue soon = turn(CueKind::Prepare, -90, 1.0, 1.0);
    soon.distanceM = 6.0;
    soon.validUntil = 30.0;
    walk.queue.add(soon);
    walk.queue.setNow(4.0, RegionId("corridor"), 0);
    walk.finishAll();
    QCOMPARE(walk.output.said.last(), kSoonRight);
    soon.time = 20.0;
    soon.manoeuvre->position = {50.0, 0.0};
    walk.queue.add(soon);
    QCOMPARE(walk.output.said.last(), QStringLiteral("In about 6 metres, turn right."));
}

void TestSpeechQueue::whoTurnsIsToldToStopEachTime() {
    Walk walk;
    Cue done = cueOf(CueKind::Unsure, CuePriority::OffRoute, 1.0);
    done.sweep = farol::guidance::SweepStep::Done;
    walk.queue.add(done);
    walk.finishAll();
    done.time = 11.0;
    walk.queue.add(done);
    walk.finishAll();
    QCOMPARE(walk.output.said.size(), 2);
}

void TestSpeechQueue::theLastOrderIsHeardToItsEnd() {
    const auto order = [](CueKind kind, const char* into) {
        Cue cue = turn(kind, 0.0);
        cue.manoeuvre->kind = routing::ManoeuvreKind::Door;
        cue.manoeuvre->into = RegionId(into);
        cue.validIn = {RegionId("corridor")};
        return cue;
    };
    Cue arrived = cueOf(CueKind::Arrived, CuePriority::Arrival, 2.0);
    arrived.region = RegionId("library");
    Walk walk;
    walk.queue.add(order(CueKind::Act, "library"));
    walk.queue.setNow(2.0, RegionId("library"), 0);
    walk.queue.add(arrived);
    QCOMPARE(walk.output.said.size(), 1);
    walk.finishAll();
    QCOMPARE(walk.output.said.last(), QStringLiteral("You have arrived."));

    // Nor are the words to be heard to their end by one who is to stop.
    Walk sudden;
    sudden.queue.add(order(CueKind::Act, "library"));
    Cue stop = arrived;
    stop.stop = true;
    sudden.queue.add(stop);
    QCOMPARE(sudden.output.said.last(), QStringLiteral("Stop. You have arrived."));

    // What was said of another door, or only announced, must not be heard in the destination.
    for (const Cue& other : {order(CueKind::Act, "hall"), order(CueKind::Prepare, "library")}) {
        Walk next;
        next.queue.add(other);
        next.queue.add(arrived);
        QCOMPARE(next.output.said.last(), QStringLiteral("You have arrived."));
    }
}

void TestSpeechQueue::ownWordsComeAtOnceAndCostNoInstruction() {
    Walk walk;
    const QString own = QStringLiteral("Speed 7 of 11.");
    walk.queue.add(turn(CueKind::Act, 90.0));
    walk.queue.say(QStringLiteral("Speed 6 of 11."));
    walk.queue.say(own); // the newer in place of the older
    QCOMPARE(walk.output.said.last(), own);
    walk.finishAll();
    QCOMPARE(walk.output.said.last(), kLeft); // what was cut off is told again
    walk.queue.say(own);
    walk.queue.say(own); // the same key twice
    QCOMPARE(walk.output.said.count(own), 3);
}

void TestSpeechQueue::aWarningIsSpokenToItsEndBeforeOwnWords() {
    Walk walk;
    walk.queue.add(warning(CueReason::CameraLost));
    walk.queue.say(QStringLiteral("Speed 6 of 11."));
    QCOMPARE(walk.output.said.size(), 1);
    walk.output.finish();
    QCOMPARE(walk.output.said.last(), QStringLiteral("Speed 6 of 11."));
}

void TestSpeechQueue::anotherVoiceLosesNothing() {
    Walk walk;
    RecordingOutput faster;
    walk.queue.add(turn(CueKind::Act, 90.0));
    walk.queue.add(seen(Kind::Extinguisher));
    walk.queue.useOutput(faster);
    QCOMPARE(faster.said, QStringList{kLeft});
    faster.finish();
    QCOMPARE(faster.said.last(), kExtinguisher);
    QCOMPARE(walk.output.said, QStringList{kLeft}); // the old voice says no more
}

void TestSpeechQueue::speaksInOrderOfUrgencyThenArrival() {
    Walk walk;
    walk.queue.add(warning(CueReason::CameraBack));
    walk.queue.add(reassure());
    walk.queue.add(seen(Kind::Door));
    walk.queue.add(seen(Kind::Extinguisher));
    walk.queue.add(turn(CueKind::Act, 90));
    QCOMPARE(walk.queue.waiting().size(), std::size_t(3)); // the turn made the reassurance superfluous
    walk.finishAll();
    QCOMPARE(walk.output.said,
             (QStringList{QStringLiteral("The camera works again."), kLeft, kDoor, kExtinguisher}));
    QCOMPARE(walk.statesOf(kLeft),
             (States{UtteranceState::Waiting, UtteranceState::Speaking, UtteranceState::Spoken}));
}

void TestSpeechQueue::urgentCueInterrupts() {
    Walk walk;
    walk.queue.add(seen(Kind::Extinguisher));
    walk.queue.add(turn(CueKind::Act, 90));
    QCOMPARE(walk.output.said, (QStringList{kExtinguisher, kLeft}));
    QCOMPARE(walk.statesOf(kExtinguisher).last(), UtteranceState::Interrupted);
    walk.finishAll();
    QCOMPARE(walk.output.said.size(), 2);
}

void TestSpeechQueue::equalOrLowerCueWaits() {
    Walk walk;
    walk.queue.add(turn(CueKind::Act, 90, 1.0));
    walk.queue.add(turn(CueKind::Act, -90, 2.0));
    walk.queue.add(seen(Kind::Door));
    QCOMPARE(walk.output.said, QStringList{kLeft});
    walk.finishAll();
    QCOMPARE(walk.output.said, (QStringList{kLeft, kRight, kDoor}));
}

void TestSpeechQueue::remarkDoesNotCostTheTurn() {
    Walk walk;
    walk.queue.add(turn(CueKind::Act, 90));
    walk.queue.add(warning(CueReason::RecordingStopped));
    walk.finishAll();
    QCOMPARE(walk.output.said,
             (QStringList{kLeft, QStringLiteral("The recording has stopped. I keep guiding you."), kLeft}));
}

void TestSpeechQueue::expiredIsNeverSpoken() {
    Walk walk;
    walk.queue.add(turn(CueKind::Act, 90));
    Cue soon = seen(Kind::Door, 1.0);
    soon.validUntil = 4.0;
    walk.queue.add(soon);
    walk.queue.setNow(4.5, std::nullopt, 0);
    QCOMPARE(walk.statesOf(kDoor), (States{UtteranceState::Waiting, UtteranceState::Expired}));
    Cue late = seen(Kind::Extinguisher, 2.0);
    late.validUntil = 3.0;
    walk.queue.add(late); // has come too late already
    QCOMPARE(walk.statesOf(kExtinguisher), States{UtteranceState::Expired});
    walk.finishAll();
    QCOMPARE(walk.output.said, QStringList{kLeft});
}

void TestSpeechQueue::cueOfAnotherPlaceIsNeverSpoken() {
    Walk walk;
    walk.queue.setNow(1.0, RegionId{"R1"}, 1);
    walk.queue.add(turn(CueKind::Act, 90));
    Cue here = turn(CueKind::Prepare, -90, 5.0);
    here.validIn = {RegionId{"R1"}, RegionId{"R2"}};
    walk.queue.add(here);
    walk.queue.setNow(2.0, RegionId{"R2"}, 1);
    QCOMPARE(walk.queue.waiting().size(), std::size_t(1));
    walk.queue.setNow(3.0, std::nullopt, 1); // not knowing the place voids nothing
    QCOMPARE(walk.queue.waiting().size(), std::size_t(1));
    walk.queue.setNow(4.0, RegionId{"R3"}, 1);
    QVERIFY(walk.queue.waiting().empty());
    walk.finishAll();
    QCOMPARE(walk.output.said, QStringList{kLeft});
}

void TestSpeechQueue::cueOfAnOldRouteIsCutOff() {
    Walk walk;
    Cue old = turn(CueKind::Act, 90);
    old.routeVersion = 3;
    Cue waiting = turn(CueKind::Prepare, -90, 5.0);
    waiting.routeVersion = 3;
    walk.queue.setNow(1.0, std::nullopt, 3);
    walk.queue.add(old);
    walk.queue.add(waiting);
    walk.queue.setNow(2.0, std::nullopt, 4);
    QVERIFY(!walk.output.speaking());
    QCOMPARE(walk.statesOf(kLeft).last(), UtteranceState::Interrupted);
    QCOMPARE(walk.statesOf(kSoonRight).last(), UtteranceState::Expired);
    walk.queue.repeatLast(); // the old route is not repeated either
    QCOMPARE(walk.output.said.last(), QStringLiteral("There is nothing to repeat."));
}

void TestSpeechQueue::aWayGivenUpIsNotTold() {
    Walk walk;
    Cue told = turn(CueKind::Act, 90);
    told.routeVersion = 3;
    Cue waiting = turn(CueKind::Prepare, -90, 5.0);
    waiting.routeVersion = 3;
    walk.queue.setNow(1.0, std::nullopt, 3);
    walk.queue.add(told);
    walk.queue.add(waiting);
    const QString list = QStringLiteral("Choose a destination.");
    walk.queue.forgetWay();
    QVERIFY(!walk.output.speaking());
    walk.queue.say(list);
    walk.finishAll();
    QCOMPARE(walk.output.said.last(), list); // and not the turn that it would have interrupted
    walk.queue.repeatLast();
    QCOMPARE(walk.output.said.last(), QStringLiteral("There is nothing to repeat."));
    // What has nothing to do with a way stays.
    walk.queue.add(warning(CueReason::PictureCovered));
    walk.queue.forgetWay();
    QVERIFY(walk.output.speaking());
}

void TestSpeechQueue::nothingToMoveWaitsBehindStop() {
    for (const Cue& stop :
         {warning(CueReason::CameraLost), warning(CueReason::PictureCovered),
          cueOf(CueKind::Unsure, CuePriority::OffRoute), cueOf(CueKind::OffRoute, CuePriority::OffRoute)}) {
        Walk walk;
        walk.queue.add(turn(CueKind::Act, 90));
        walk.queue.add(turn(CueKind::Act, -90, 4.0));
        walk.queue.add(turn(CueKind::Prepare, -90, 8.0));
        walk.queue.add(reassure());
        walk.queue.add(stop);
        QCOMPARE(walk.statesOf(kLeft).last(), UtteranceState::Interrupted);
        walk.finishAll();
        QCOMPARE(walk.output.said.size(), 2);
        QVERIFY(walk.output.said.last().contains(QStringLiteral("Stop")));
    }
}

void TestSpeechQueue::actMakesItsPreparationSuperfluous() {
    Walk walk;
    walk.queue.add(turn(CueKind::Act, 90));
    walk.queue.add(turn(CueKind::Prepare, -90, 5.0));
    walk.queue.add(turn(CueKind::Act, -90, 5.0));
    walk.finishAll();
    QCOMPARE(walk.output.said, (QStringList{kLeft, kRight}));
    QCOMPARE(walk.statesOf(kSoonRight), (States{UtteranceState::Waiting, UtteranceState::Expired}));
}

void TestSpeechQueue::sameTextIsNotRepeatedWithin15Seconds() {
    Walk walk;
    walk.queue.setNow(1.0, std::nullopt, 0);
    walk.queue.add(reassure(1.0));
    walk.queue.add(reassure(2.0)); // while it is being said
    walk.finishAll();
    walk.queue.setNow(15.9, std::nullopt, 0);
    walk.queue.add(reassure(15.9));
    walk.queue.setNow(15.5, std::nullopt, 0); // a screen that lags behind
    walk.queue.add(reassure(15.5));
    QCOMPARE(walk.output.said, QStringList{kKeep});
    walk.queue.setNow(16.0, std::nullopt, 0);
    walk.queue.add(reassure(16.0));
    QCOMPARE(walk.output.said, (QStringList{kKeep, kKeep}));
    walk.finishAll();
    walk.queue.setNow(2.0, std::nullopt, 0); // a replay that jumped back
    walk.queue.add(reassure(2.0));
    QCOMPARE(walk.output.said.size(), 3);
}

void TestSpeechQueue::sameWordsAtTwoCornersAreBothTold() {
    Walk walk;
    walk.queue.add(turn(CueKind::Act, 90, 1.0, 1.0));
    walk.finishAll();
    walk.queue.add(turn(CueKind::Act, 90, 1.0, 4.0));
    QCOMPARE(walk.output.said, QStringList{kLeft});
    walk.queue.add(turn(CueKind::Act, 90, 6.0, 8.0));
    QCOMPARE(walk.output.said, (QStringList{kLeft, kLeft}));
}

void TestSpeechQueue::theSameChoiceIsAnsweredAgain() {
    for (const CueKind kind : {CueKind::AlreadyThere, CueKind::RouteStart, CueKind::NoRoute}) {
        Walk walk;
        Cue answer;
        answer.kind = kind;
        answer.regionName = "Library";
        answer.reason = CueReason::DestinationUnreachable;
        answer.routeVersion = 1;
        answer.time = 1.0;
        walk.queue.setNow(1.0, std::nullopt, 1);
        walk.queue.add(answer);
        walk.finishAll();
        answer.time = 3.0;
        walk.queue.add(answer);
        QCOMPARE(walk.output.said.size(), 1); // nothing was chosen
        answer.routeVersion = 2;
        answer.time = 5.0;
        walk.queue.setNow(5.0, std::nullopt, 2);
        walk.queue.add(answer);
        walk.finishAll();
        QCOMPARE(walk.output.said.size(), 2);
        QCOMPARE(walk.output.said.first(), walk.output.said.last());
    }
}

void TestSpeechQueue::interruptedTextMayComeAgain() {
    Walk walk;
    walk.queue.add(seen(Kind::Door));
    walk.queue.add(turn(CueKind::Act, 90));
    walk.queue.add(seen(Kind::Door, 2.0));
    walk.finishAll();
    QCOMPARE(walk.output.said, (QStringList{kDoor, kLeft, kDoor}));
}

void TestSpeechQueue::repeatSaysTheLastActionWithoutOldFigures() {
    Walk walk;
    Cue soon = turn(CueKind::Prepare, -90, 0.0, 1.0);
    soon.distanceM = 6.0;
    soon.turnFirst = fromDegrees(180);
    soon.validUntil = 5.0;
    walk.queue.add(soon);
    walk.finishAll();
    QCOMPARE(walk.output.said.last(), QStringLiteral("Turn around. In about 6 metres, turn right."));
    walk.queue.setNow(9.0, RegionId{"R1"}, 0);
    walk.queue.add(reassure(9.0));
    walk.queue.repeatLast();
    QCOMPARE(walk.output.said.last(), kSoonRight);
    QCOMPARE(walk.statesOf(kKeep).last(), UtteranceState::Interrupted);
    walk.queue.repeatLast(); // pressed again at once
    walk.finishAll();
    QCOMPARE(walk.output.said.last(), kSoonRight);
}

void TestSpeechQueue::repeatWithoutAnythingSaysSo() {
    Walk walk;
    walk.queue.repeatLast();
    QCOMPARE(walk.output.said, QStringList{QStringLiteral("There is nothing to repeat.")});
    walk.queue.add(turn(CueKind::Act, 90));
    QCOMPARE(walk.output.said.last(), kLeft);
}

void TestSpeechQueue::repeatDoesNotTalkOverAWarning() {
    Walk walk;
    walk.queue.add(turn(CueKind::Act, 90));
    walk.finishAll();
    walk.queue.add(warning(CueReason::FrameSkipped));
    walk.queue.repeatLast();
    QCOMPARE(walk.output.said.size(), 2);
    walk.finishAll();
    QCOMPARE(walk.output.said.last(), kLeft);
}

void TestSpeechQueue::mutedTextIsShown() {
    Walk walk;
    walk.queue.add(turn(CueKind::Act, 90));
    walk.queue.add(seen(Kind::Door));
    walk.queue.setMuted(true);
    QVERIFY(!walk.output.speaking());
    QCOMPARE(walk.statesOf(kLeft).last(), UtteranceState::Interrupted);
    QCOMPARE(walk.statesOf(kDoor).last(), UtteranceState::Shown);
    walk.queue.add(turn(CueKind::Act, -90, 3.0));
    QCOMPARE(walk.statesOf(kRight), States{UtteranceState::Shown});
    QVERIFY(walk.queue.waiting().empty());
    walk.queue.setMuted(false);
    QCOMPARE(walk.output.said, QStringList{kLeft}); // nothing old is poured out
    walk.queue.repeatLast();
    QCOMPARE(walk.output.said.last(), kRight);
}

void TestSpeechQueue::failureIsShownAndToldOncePerCause() {
    Walk walk;
    QSignalSpy trouble(&walk.queue, &SpeechQueue::trouble);
    walk.output.broken = QStringLiteral("no sound device");
    walk.queue.add(turn(CueKind::Act, 90, 1.0));
    walk.queue.add(turn(CueKind::Act, -90, 2.0));
    QCOMPARE(walk.statesOf(kLeft).last(), UtteranceState::Shown);
    QCOMPARE(walk.statesOf(kRight).last(), UtteranceState::Shown);
    QCOMPARE(trouble.size(), 1);
    QCOMPARE(trouble[0][0].toString(), QStringLiteral("no sound device"));
    walk.output.broken = QStringLiteral("stuck");
    walk.queue.add(seen(Kind::Door));
    QCOMPARE(trouble.size(), 2);
    walk.output.broken.clear();
    walk.queue.add(seen(Kind::Extinguisher));
    walk.finishAll();
    QCOMPARE(walk.statesOf(kExtinguisher).last(), UtteranceState::Spoken);
    walk.output.broken = QStringLiteral("stuck");
    walk.queue.add(turn(CueKind::Act, 90, 9.0));
    QCOMPARE(trouble.size(), 3); // it had worked in between
}

void TestSpeechQueue::clearForgetsTheWalk() {
    Walk walk;
    walk.queue.setNow(100.0, RegionId{"R9"}, 7);
    Cue cue = turn(CueKind::Act, 90, 0.0, 100.0);
    walk.queue.add(cue);
    walk.queue.add(seen(Kind::Door, 100.0));
    walk.queue.clear();
    QVERIFY(!walk.output.speaking());
    QVERIFY(walk.queue.waiting().empty());
    QCOMPARE(walk.statesOf(kDoor).last(), UtteranceState::Expired);
    Cue again =
        turn(CueKind::Act, 90, 0.0, 1.0); // the next walk starts clean: same words, old clock, version 1
    again.routeVersion = 1;
    again.validUntil = 5.0;
    again.validIn = {RegionId{"R1"}};
    walk.queue.add(again);
    QCOMPARE(walk.output.said, (QStringList{kLeft, kLeft}));
}

void TestSpeechQueue::gapSeparatesUtterancesButNotUrgentOnes() {
    Walk walk;
    walk.queue.setGapMs(1000 * 1000);
    walk.queue.add(seen(Kind::Door));
    walk.queue.add(seen(Kind::Extinguisher));
    walk.output.finish();
    QVERIFY(!walk.output.speaking());
    walk.queue.add(seen(Kind::Stairs));
    QCOMPARE(walk.output.said, QStringList{kDoor});
    walk.queue.add(turn(CueKind::Act, 90));
    QCOMPARE(walk.output.said, (QStringList{kDoor, kLeft}));
    Cue asked = cueOf(CueKind::Located, CuePriority::Answer); // met a sentence that goes first
    asked.asked = true;
    walk.queue.add(asked);
    QCOMPARE(walk.output.said.last(), kLeft);
    walk.output.finish();
    QVERIFY(walk.output.said.last().startsWith(QLatin1String("I do not know yet")));
    walk.output.finish();
    walk.queue.setGapMs(1);
    walk.queue.add(warning(CueReason::CameraBack));
    walk.output.finish();
    QTRY_COMPARE(walk.output.said.last(), kExtinguisher);
}

void TestSpeechQueue::lateReportsOfTheVoiceAreHarmless() {
    Walk walk;
    Q_EMIT walk.output.finished();
    Q_EMIT walk.output.failed(QStringLiteral("late"));
    walk.queue.add(cueOf(CueKind::Unsure, CuePriority::OffRoute));
    walk.queue.clear();
    Q_EMIT walk.output.finished();
    QCOMPARE(walk.statesOf(kUnsure).last(), UtteranceState::Interrupted);
}

void TestSpeechQueue::emptySentenceIsNothing() {
    Walk walk;
    walk.queue.add(cueOf(CueKind::Act, CuePriority::ActNow)); // an action without a manoeuvre has no words
    QVERIFY(walk.output.said.isEmpty());
    QVERIFY(walk.changes.isEmpty());
}

QTEST_GUILESS_MAIN(TestSpeechQueue)
#include "test_speech_queue.moc"
