#pragma once
// What is said, when: priorities, expiry, no collisions (field.md 4.5). GUI thread.

#include "core/guidance/cue.h"
#include "ui/speech/phrasebook.h"
#include "ui/speech/speech_output.h"

#include <QObject>
#include <QTimer>

#include <optional>
#include <vector>

namespace farol::ui {

enum class UtteranceState { Waiting, Speaking, Spoken, Interrupted, Expired, Shown }; ///< Shown: as text, no sound

struct Utterance {
    guidance::Cue cue;
    QString text;
    UtteranceState state = UtteranceState::Waiting;
};

/// A more urgent cue interrupts; equal or lower ones wait; what has expired, or belongs to an older route or another
/// region, is dropped and never spoken late. The same text within 15 s of the walk's clock is not repeated.
class SpeechQueue : public QObject {
    Q_OBJECT

public:
    SpeechQueue(SpeechOutput& output, Phrasebook& phrasebook, QObject* parent = nullptr);

    void add(const guidance::Cue& cue);
    /// The walk's clock, place and route: stale utterances are dropped by these.
    void setNow(double time, const std::optional<RegionId>& region, std::uint64_t routeVersion);
    void repeatLast(); ///< the last actionable sentence again
    void setMuted(bool muted);
    bool muted() const { return m_muted; }
    void clear();
    const std::vector<Utterance>& waiting() const { return m_waiting; }

Q_SIGNALS:
    /// Every change of an utterance's state, for the log and the screen.
    void changed(const farol::ui::Utterance& utterance);
    /// Speech failed: to be shown, with a tone.
    void trouble(const QString& message);

private:
    void speakNext();
    void finish(UtteranceState state);

    SpeechOutput& m_output;
    Phrasebook& m_phrasebook;
    std::vector<Utterance> m_waiting;
    std::optional<Utterance> m_current;
    std::optional<Utterance> m_lastActionable;
    double m_now = 0.0;
    std::optional<RegionId> m_region;
    std::uint64_t m_routeVersion = 0;
    bool m_muted = false;
};

} // namespace farol::ui
