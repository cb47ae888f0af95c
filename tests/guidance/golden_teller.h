#pragma once
// What is heard, as text: the real tracker, scheduler, phrasebook and speech queue, and a voice that takes
// the time that speaking takes.

#include "core/guidance/cue_scheduler.h"
#include "core/routing/route.h"
#include "ui/speech/speech_queue.h"

#include <QStringList>

#include <functional>
#include <memory>

namespace farol::test {

/// How long espeak-ng takes for it at its own speed, in any of the languages.
double speakingSeconds(const QString& text);

/// Says nothing and takes as long as saying it would.
class TimedVoice final : public ui::SpeechOutput {
public:
    void say(const QString& text) override;
    void stop() override { m_speaking = false; }
    bool speaking() const override { return m_speaking; }
    QString description() const override { return QStringLiteral("timed"); }
    void pass(double seconds);

private:
    double m_left = 0.0;
    bool m_speaking = false;
    bool m_follows = false; ///< what is said now comes right behind something else
};

class Teller {
public:
    Teller(std::shared_ptr<const building::Building> building,
           std::shared_ptr<const routing::Planner> planner, const guidance::GuidanceOptions& options,
           const guidance::TrackerOptions& tracking = {});

    void setListener(std::function<void(const guidance::Cue& cue, const QString& words)> listener) {
        m_listener = std::move(listener);
    }
    guidance::RouteTracker& tracker() { return m_tracker; }
    TimedVoice& voice() { return m_voice; }
    void write(const QString& line) { m_lines << line; }
    /// So many seconds later, with this fix; `gone` metres are done.
    void step(const localisation::Fix& fix, double seconds, double gone,
              const std::vector<localisation::Observation>& seen = {});
    void warn(guidance::CueReason reason);
    /// What would be answered now; asking does not disturb the walk.
    void ask(guidance::Question question);
    QString text() const { return m_lines.join(QLatin1Char('\n')) + QLatin1Char('\n'); }

private:
    void add(const QString& what, const guidance::Cue& cue);

    guidance::RouteTracker m_tracker;
    guidance::CueScheduler m_scheduler;
    ui::Phrasebook m_phrasebook;
    TimedVoice m_voice;
    ui::SpeechQueue m_queue;
    localisation::Fix m_fix;
    guidance::Progress m_progress;
    double m_gone = 0.0;
    std::uint64_t m_frame = 0;
    QStringList m_lines;
    std::function<void(const guidance::Cue&, const QString&)> m_listener;
};

} // namespace farol::test
