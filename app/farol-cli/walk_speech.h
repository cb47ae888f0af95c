#pragma once
// The spoken side of `run --speak`: an event loop with the speech queue, fed from the session thread.

#include "core/session/percept.h"
#include "ui/speech/speech_queue.h"

#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace farol::cli {

class WalkSpeech {
public:
    explicit WalkSpeech(const std::string& language);
    ~WalkSpeech();

    // From any thread.
    void step(const session::NavigationStep& step);
    void warning(const guidance::Cue& cue);
    /// No more cues come: what is being said, and what still holds, is said to its end; then run() returns.
    void finish();
    /// run() returns at once.
    void abort();

    void run(); ///< the event loop; main thread
    /// Called with what the voice begins to say. Main thread, before run().
    void setHeard(std::function<void(const guidance::Cue& cue)> heard) { m_heard = std::move(heard); }

private:
    void leaveWhenSilent();

    ui::Phrasebook m_phrasebook;
    std::unique_ptr<ui::SpeechOutput> m_output;
    ui::SpeechQueue m_queue;
    std::function<void(const guidance::Cue& cue)> m_heard;
    bool m_speaking = false, m_finishing = false, m_told = false;
};

} // namespace farol::cli
