#pragma once
// What is said, when: priorities, expiry, no collisions (field.md 4.5). GUI thread.

#include "core/guidance/cue.h"
#include "ui/speech/phrasebook.h"
#include "ui/speech/speech_output.h"

#include <QObject>
#include <QTimer>

#include <functional>
#include <optional>
#include <vector>

namespace farol::ui {

enum class UtteranceState {
    Waiting,
    Speaking,
    Spoken,
    Interrupted,
    Expired,
    Shown
}; ///< Shown: as text, no sound

struct Utterance {
    guidance::Cue cue;
    QString text;
    UtteranceState state = UtteranceState::Waiting;
    bool own = false; ///< the program's own words, such as the answer to a key: no cue stands behind them
};

/// A more urgent cue interrupts; equal or lower ones wait; what has expired, or belongs to an older route or
/// another region, is dropped and never spoken late. The same text within 15 s of the walk's clock is not
/// repeated, unless it tells of another manoeuvre ("turn left" at two corners) or answers the choice of a
/// destination. Nothing waits behind "stop":
/// an instruction to move that was waiting when the way was lost is dropped.
class SpeechQueue : public QObject {
    Q_OBJECT

public:
    SpeechQueue(SpeechOutput& output, Phrasebook& phrasebook, QObject* parent = nullptr);

    void add(const guidance::Cue& cue);
    /// The program's own words: at once, in place of older ones of the same sort; only a warning is spoken to
    /// its end. An instruction that they interrupt is told again after them.
    void say(const QString& text);
    /// Another voice: nothing that waits is lost, and what was being said is said again.
    void useOutput(SpeechOutput& output);
    /// The walk's clock, place and route: stale utterances are dropped by these.
    void setNow(double time, const std::optional<RegionId>& region, std::uint64_t routeVersion);
    /// The destination was given up or changed: nothing of the way there is told any more, nor repeated.
    void forgetWay();
    /// The last actionable sentence again, without the distance and direction of that moment.
    void repeatLast();
    void setMuted(bool muted);
    bool muted() const { return m_muted; }
    /// Silence, and everything forgotten: for a new walk.
    void clear();
    /// Silence between two utterances; what interrupts or follows a failure does not wait for it.
    void setGapMs(int gapMs) { m_gap.setInterval(gapMs); }
    const std::vector<Utterance>& waiting() const { return m_waiting; }

Q_SIGNALS:
    /// Every change of an utterance's state, for the log and the screen.
    void changed(const farol::ui::Utterance& utterance);
    /// Speech failed: to be shown, with a tone. Once per cause, until speech works again.
    void trouble(const QString& message);

private:
    /// What was heard lately, so that it is not said again. The 15 s count from the cue, not from the end of
    /// a long sentence: what the engine repeats every 15 s is to be repeated.
    struct Told {
        guidance::Cue cue;
        QString text;
    };

    bool stale(const guidance::Cue& cue) const;
    bool toldLately(const Utterance& utterance) const;
    void dropWaiting(const std::function<bool(const Utterance&)>& unwanted, UtteranceState state);
    void enqueue(Utterance utterance);
    void interruptFor(const guidance::Cue& cue);
    void speakNext();
    void dropOldDistance(Utterance& utterance);
    void pauseThenNext();
    void finish(UtteranceState state);
    void connectOutput();
    void interruptForOwn();
    void outputFailed(const QString& message);
    void show(Utterance utterance);

    SpeechOutput* m_output; ///< never null
    Phrasebook& m_phrasebook;
    QTimer m_gap;
    std::vector<Utterance> m_waiting; ///< most urgent first, then in order of arrival
    std::optional<Utterance> m_current;
    std::optional<Utterance> m_lastActionable;
    std::vector<Told> m_told;
    QString m_trouble; ///< the last cause told
    double m_now = 0.0;
    std::optional<RegionId> m_region;
    std::uint64_t m_routeVersion = 0;
    bool m_muted = false;
};

} // namespace farol::ui
