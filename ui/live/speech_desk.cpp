#include "ui/live/speech_desk.h"

namespace farol::ui {

SpeechDesk::SpeechDesk(Settings& settings, MakeOutput make, QObject* parent)
    : QObject(parent), m_settings(settings), m_make(std::move(make)) {
    if (!m_make) m_make = [](const VoiceChoice& choice) { return makeSpeechOutput(choice); };
    connect(&settings, &Settings::voiceChanged, this, &SpeechDesk::rebuild);
    connect(&settings, &Settings::languageChanged, this, &SpeechDesk::rebuild);
    connect(&settings, &Settings::guidanceChanged, this, [this] {
        m_phrasebook.setStyle(m_settings.directionStyle());
        m_phrasebook.setUnit(m_settings.unit());
    });
    connect(&settings, &Settings::mutedChanged, this, [this](bool muted) {
        m_queue->setMuted(muted);
        setStatus(muted ? tr("Voice off: sentences are only shown") : m_output->description(), false);
    });
    rebuild();
}

SpeechDesk::~SpeechDesk() = default;

void SpeechDesk::rebuild() {
    m_phrasebook.setStyle(m_settings.directionStyle());
    m_phrasebook.setUnit(m_settings.unit());
    std::unique_ptr<SpeechOutput> output = m_make(m_settings.voice());
    if (m_queue) {
        m_queue->useOutput(*output);
        m_output = std::move(output);
    } else {
        m_output = std::move(output);
        m_queue = std::make_unique<SpeechQueue>(*m_output, m_phrasebook);
        connect(m_queue.get(), &SpeechQueue::changed, this, [this](const Utterance& utterance) {
            if (utterance.state == UtteranceState::Spoken && m_trouble)
                setStatus(m_output->description(), false);
            Q_EMIT utteranceChanged(utterance);
        });
        connect(m_queue.get(), &SpeechQueue::trouble, this,
                [this](const QString& message) { setStatus(message, true); });
    }
    m_queue->setMuted(m_settings.muted());
    setStatus(m_settings.muted() ? tr("Voice off: sentences are only shown") : m_output->description(),
              false);
}

void SpeechDesk::setStatus(const QString& status, bool trouble) {
    if (status == m_status && trouble == m_trouble) return;
    m_status = status;
    m_trouble = trouble;
    Q_EMIT statusChanged(status, trouble);
}

void SpeechDesk::add(const guidance::Cue& cue) {
    m_queue->add(cue);
}

void SpeechDesk::say(const QString& text) {
    m_queue->say(text);
}

void SpeechDesk::setNow(double time, const std::optional<RegionId>& region, std::uint64_t routeVersion) {
    m_queue->setNow(time, region, routeVersion);
}

void SpeechDesk::forgetWay() {
    m_queue->forgetWay();
}

void SpeechDesk::repeatLast() {
    m_queue->repeatLast();
}

void SpeechDesk::reset() {
    m_queue->clear();
}

} // namespace farol::ui
