#include "app/farol-cli/walk_speech.h"

#include "app/farol-cli/output.h"

#include <QCoreApplication>
#include <QMetaObject>
#include <QTimer>

namespace farol::cli {

namespace {

/// At the end of a walk nobody waits longer than this for the last words.
constexpr int kLastWordsMs = 20000;

std::unique_ptr<ui::SpeechOutput> makeVoice(const std::string& language) {
    ui::VoiceChoice choice;
    choice.language = QString::fromStdString(language);
    return ui::makeSpeechOutput(choice);
}

} // namespace

WalkSpeech::WalkSpeech(const std::string& language)
    : m_output(makeVoice(language)), m_queue(*m_output, m_phrasebook) {
    QObject::connect(&m_queue, &ui::SpeechQueue::changed, &m_queue, [this](const ui::Utterance& utterance) {
        m_speaking = utterance.state == ui::UtteranceState::Speaking;
        if (m_speaking && m_heard) m_heard(utterance.cue);
        leaveWhenSilent();
    });
    QObject::connect(&m_queue, &ui::SpeechQueue::trouble, &m_queue, [this](const QString& message) {
        if (!m_told) warn("nothing is spoken: " + message.toStdString());
        m_told = true;
    });
}

WalkSpeech::~WalkSpeech() = default;

void WalkSpeech::step(const session::NavigationStep& step) {
    QMetaObject::invokeMethod(
        &m_queue,
        [this, cues = step.cues, time = step.fix.time, region = step.fix.region,
         route = step.progress.routeVersion] {
            m_queue.setNow(time, region, route);
            for (const guidance::Cue& cue : cues) m_queue.add(cue);
        },
        Qt::QueuedConnection);
}

void WalkSpeech::warning(const guidance::Cue& cue) {
    QMetaObject::invokeMethod(
        &m_queue, [this, cue] { m_queue.add(cue); }, Qt::QueuedConnection);
}

void WalkSpeech::finish() {
    QMetaObject::invokeMethod(
        &m_queue,
        [this] {
            m_finishing = true;
            QTimer::singleShot(kLastWordsMs, &m_queue, [] { QCoreApplication::quit(); });
            leaveWhenSilent();
        },
        Qt::QueuedConnection);
}

void WalkSpeech::abort() {
    QMetaObject::invokeMethod(
        &m_queue, [] { QCoreApplication::quit(); }, Qt::QueuedConnection);
}

void WalkSpeech::leaveWhenSilent() {
    // Asked again from the event loop: the queue starts the next utterance after it told the end of the last
    // one.
    QTimer::singleShot(0, &m_queue, [this] {
        if (m_finishing && !m_speaking && m_queue.waiting().empty()) QCoreApplication::quit();
    });
}

void WalkSpeech::run() {
    QCoreApplication::exec();
}

} // namespace farol::cli
