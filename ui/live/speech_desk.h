#pragma once
// The voice and its queue, made anew whenever the user chooses another voice.

#include "ui/settings/settings.h"
#include "ui/speech/speech_queue.h"

#include <QObject>

#include <functional>
#include <memory>
#include <optional>

namespace farol::ui {

class SpeechDesk : public QObject {
    Q_OBJECT

public:
    using MakeOutput = std::function<std::unique_ptr<SpeechOutput>(const VoiceChoice&)>;

    /// `make` is replaced by tests; empty: the real voices.
    explicit SpeechDesk(Settings& settings, MakeOutput make = {}, QObject* parent = nullptr);
    ~SpeechDesk() override;

    void add(const guidance::Cue& cue);
    void say(const QString& text); ///< the program's own words, at once
    void setNow(double time, const std::optional<RegionId>& region, std::uint64_t routeVersion);
    void forgetWay();
    void repeatLast();
    void rebuild(); ///< the voice anew, as the settings and `make` now say
    void reset();   ///< a new walk: nothing of the old one is said any more
    void setGapMs(int gapMs) { m_queue->setGapMs(gapMs); } ///< silence between two utterances; tests: 0
    QString status() const { return m_status; }
    bool trouble() const { return m_trouble; }

Q_SIGNALS:
    void utteranceChanged(const farol::ui::Utterance& utterance);
    void statusChanged(const QString& status, bool trouble);

private:
    void setStatus(const QString& status, bool trouble);

    Settings& m_settings;
    MakeOutput m_make;
    Phrasebook m_phrasebook;
    std::unique_ptr<SpeechOutput> m_output;
    std::unique_ptr<SpeechQueue> m_queue;
    QString m_status;
    bool m_trouble = false;
};

} // namespace farol::ui
