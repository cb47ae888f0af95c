#include "tests/guidance/golden_teller.h"

namespace farol::test {

using guidance::Cue;
using ui::DirectionStyle;
using ui::Phrasebook;
using ui::Utterance;
using ui::UtteranceState;

namespace {

constexpr double kGapS = 0.5; ///< between two utterances

} // namespace

double speakingSeconds(const QString& text) {
    // Letters, and the rests at stops and colons.
    constexpr double kBeginS = 0.4, kLetterS = 0.055, kRestS = 0.3;
    const auto rests = text.count(QLatin1String(". ")) + text.count(QLatin1String(": "));
    return kBeginS + kLetterS * static_cast<double>(text.size()) + kRestS * static_cast<double>(rests);
}

void TimedVoice::say(const QString& text) {
    m_left = speakingSeconds(text) + (m_follows ? kGapS : 0.0);
    m_speaking = true;
}

void TimedVoice::pass(double seconds) {
    if (!m_speaking) return;
    m_left -= seconds;
    if (m_left > 0.0) return;
    m_speaking = false;
    m_follows = true;
    Q_EMIT finished();
    m_follows = false;
}

Teller::Teller(std::shared_ptr<const building::Building> building,
               std::shared_ptr<const routing::Planner> planner, const guidance::GuidanceOptions& options,
               const guidance::TrackerOptions& tracking)
    : m_tracker(building, std::move(planner), tracking),
      m_scheduler(building, options),
      m_queue(m_voice, m_phrasebook) {
    m_queue.setGapMs(0);
    QObject::connect(&m_queue, &ui::SpeechQueue::changed, [this](const Utterance& utterance) {
        if (utterance.state == UtteranceState::Speaking)
            add(QString::fromStdString(cueKindName(utterance.cue.kind)), utterance.cue);
        if (utterance.state == UtteranceState::Expired || utterance.state == UtteranceState::Interrupted) {
            bool cut = utterance.state == UtteranceState::Interrupted;
            m_lines << QStringLiteral("%1 (%2: %3)")
                           .arg(QString(), 20)
                           .arg(cut ? QStringLiteral("cut short") : QStringLiteral("not spoken"),
                                utterance.text);
        }
    });
}

void Teller::ask(guidance::Question question) {
    const Cue cue = m_scheduler.answer(question, m_frame, m_fix, m_progress);
    add(QStringLiteral("? ") + QString::fromStdString(questionName(question)), cue);
}

void Teller::warn(guidance::CueReason reason) {
    m_queue.add(m_scheduler.warning(m_frame, m_fix.time, reason, {}));
}

void Teller::add(const QString& what, const Cue& cue) {
    auto said = [&](DirectionStyle style) { return Phrasebook(style).sentence(cue); };
    const QString plain = said(DirectionStyle::LeftRight);
    if (m_listener) m_listener(cue, plain);
    m_lines << QStringLiteral("%1 s %2 m  %3 %4")
                   .arg(m_fix.time, 5, 'f', 1)
                   .arg(m_gone, 5, 'f', 1)
                   .arg(what, -12)
                   .arg(plain);
    const QString margin(30, QLatin1Char(' '));
    for (auto [style, name] :
         {std::pair(DirectionStyle::Clock, "clock"), {DirectionStyle::Degrees, "degrees"}}) {
        const QString text = said(style);
        if (text != plain) m_lines << margin + QStringLiteral("[%1] %2").arg(QLatin1String(name), text);
    }
}

void Teller::step(const localisation::Fix& fix, double seconds, double gone,
                  const std::vector<localisation::Observation>& seen) {
    m_fix = fix;
    m_gone = gone;
    m_voice.pass(seconds);
    m_progress = m_tracker.update(m_fix);
    m_queue.setNow(m_fix.time, m_fix.region, m_progress.routeVersion);
    for (const Cue& cue : m_scheduler.update(++m_frame, m_fix, m_progress, seen)) {
        if (cue.chime != guidance::Chime::None)
            m_lines << QStringLiteral("%1 s %2 m  (chime: %3)")
                           .arg(m_fix.time, 5, 'f', 1)
                           .arg(m_gone, 5, 'f', 1)
                           .arg(QString::fromStdString(chimeName(cue.chime)));
        m_queue.add(cue);
    }
}

} // namespace farol::test
