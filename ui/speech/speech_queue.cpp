#include "ui/speech/speech_queue.h"

#include <algorithm>
#include <utility>

namespace farol::ui {

using guidance::Cue;
using guidance::CueKind;
using guidance::CuePriority;
using guidance::CueReason;

namespace {

constexpr double kRepeatSeconds = 15.0;
constexpr double kJumpSeconds = 5.0;
constexpr double kOldDistanceSeconds = 1.5; ///< more than a metre of walking
constexpr int kDefaultGapMs = 1000;

bool tellsToMove(CueKind kind) {
    return kind == CueKind::RouteStart || kind == CueKind::Prepare || kind == CueKind::Act ||
           kind == CueKind::Reassure;
}

/// After these words nobody may hear an older "go through the door".
bool endsTheWay(const Cue& cue) {
    if (cue.kind == CueKind::Warning) {
        return cue.reason != CueReason::CameraBack && cue.reason != CueReason::RecordingStopped &&
               cue.reason != CueReason::FrameSkipped;
    }
    return cue.kind == CueKind::OffRoute || cue.kind == CueKind::Unsure || cue.kind == CueKind::Arrived ||
           cue.kind == CueKind::NoRoute || cue.kind == CueKind::AlreadyThere;
}

bool actionable(const Cue& cue) {
    return endsTheWay(cue) || (tellsToMove(cue.kind) && cue.kind != CueKind::Reassure);
}

/// "Turn left" at the next corner is another message than "turn left" here.
bool sameManoeuvre(const Cue& a, const Cue& b) {
    if (a.manoeuvre.has_value() != b.manoeuvre.has_value()) return false;
    if (!a.manoeuvre) return true;
    return a.manoeuvre->kind == b.manoeuvre->kind && a.manoeuvre->access == b.manoeuvre->access &&
           a.manoeuvre->from == b.manoeuvre->from && a.manoeuvre->position == b.manoeuvre->position;
}

/// What a choice of the destination is answered with: whoever chooses the same place again, and so is given
/// another route, waits for these words again.
bool answersAnotherChoice(const Cue& told, const Cue& now) {
    const bool answers =
        now.kind == CueKind::RouteStart || now.kind == CueKind::AlreadyThere || now.kind == CueKind::NoRoute;
    return answers && told.routeVersion != now.routeVersion;
}

/// The order to act waits for the end of the words that announce the very same: "… on your" cut off before
/// "left" leaves open where.
bool announcesIt(const Cue& told, const Cue& order) {
    const bool announces = told.kind == CueKind::Prepare || told.kind == CueKind::RouteStart ||
                           (told.kind == CueKind::OffRoute && told.manoeuvre);
    return announces && order.kind == CueKind::Act && order.manoeuvre && !order.turnFirst &&
           told.routeVersion == order.routeVersion && sameManoeuvre(told, order);
}

/// "Go through the door", while the user does just that: "you have arrived" can wait for its end, if it does
/// not stop him.
bool isLastOrder(const Cue& told, const Cue& arrival) {
    return arrival.kind == CueKind::Arrived && !arrival.stop && told.kind == CueKind::Act && told.manoeuvre &&
           told.manoeuvre->into == arrival.region && told.routeVersion == arrival.routeVersion;
}

} // namespace

SpeechQueue::SpeechQueue(SpeechOutput& output, Phrasebook& phrasebook, QObject* parent)
    : QObject(parent), m_output(&output), m_phrasebook(phrasebook) {
    m_gap.setSingleShot(true);
    m_gap.setInterval(kDefaultGapMs);
    connect(&m_gap, &QTimer::timeout, this, &SpeechQueue::speakNext);
    connectOutput();
}

void SpeechQueue::connectOutput() {
    connect(m_output, &SpeechOutput::finished, this, [this] {
        if (!m_current) return;
        m_trouble.clear();
        finish(UtteranceState::Spoken);
        pauseThenNext();
    });
    connect(m_output, &SpeechOutput::failed, this, &SpeechQueue::outputFailed);
}

void SpeechQueue::useOutput(SpeechOutput& output) {
    m_output->disconnect(this);
    m_output->stop();
    m_output = &output;
    connectOutput();
    m_trouble.clear();
    if (!m_current) return;
    const Utterance again = *m_current;
    finish(UtteranceState::Interrupted);
    if (!stale(again.cue)) enqueue(again);
    speakNext();
}

bool SpeechQueue::stale(const Cue& cue) const {
    if (cue.validUntil > 0.0 && m_now > cue.validUntil) return true;
    if (cue.routeVersion != 0 && cue.routeVersion < m_routeVersion) return true;
    if (cue.validIn.empty() || !m_region) return false;
    return std::find(cue.validIn.begin(), cue.validIn.end(), *m_region) == cue.validIn.end();
}

bool SpeechQueue::toldLately(const Utterance& utterance) const {
    auto same = [&](const Cue& cue, const QString& text) {
        return text == utterance.text && sameManoeuvre(cue, utterance.cue) &&
               !answersAnotherChoice(cue, utterance.cue);
    };
    if (utterance.cue.asked) return false;                   // whoever asks twice wants to hear it twice
    if (utterance.cue.kind == CueKind::Unsure) return false; // who turns has to be told to stop, each time
    if (m_current && same(m_current->cue, m_current->text)) return true;
    return std::any_of(m_told.begin(), m_told.end(), [&](const Told& told) {
        return m_now - told.cue.time < kRepeatSeconds && same(told.cue, told.text);
    });
}

void SpeechQueue::add(const Cue& cue) {
    Utterance utterance{cue, m_phrasebook.sentence(cue), UtteranceState::Waiting};
    if (utterance.text.isEmpty()) return;
    m_now = std::max(m_now, cue.time);
    if (stale(cue) || toldLately(utterance)) {
        utterance.state = UtteranceState::Expired;
        Q_EMIT changed(utterance);
        return;
    }
    // The newer of two equal ones has the longer life.
    dropWaiting(
        [&](const Utterance& old) { return old.text == utterance.text && sameManoeuvre(old.cue, cue); },
        UtteranceState::Expired);
    if (endsTheWay(cue)) {
        dropWaiting([](const Utterance& old) { return tellsToMove(old.cue.kind); }, UtteranceState::Expired);
    } else if (cue.kind == CueKind::Act) {
        dropWaiting(
            [](const Utterance& old) {
                return old.cue.kind == CueKind::Prepare || old.cue.kind == CueKind::Reassure;
            },
            UtteranceState::Expired);
    }
    if (m_muted) {
        show(std::move(utterance));
        return;
    }
    enqueue(std::move(utterance));
    interruptFor(cue);
    if (!m_current && !m_gap.isActive()) speakNext();
}

void SpeechQueue::enqueue(Utterance utterance) {
    auto place = std::upper_bound(
        m_waiting.begin(), m_waiting.end(), utterance,
        [](const Utterance& a, const Utterance& b) { return a.cue.priority < b.cue.priority; });
    utterance.state = UtteranceState::Waiting;
    const Utterance told = *m_waiting.insert(place, std::move(utterance));
    Q_EMIT changed(told);
}

/// A more urgent cue does not wait for the end of what is being said, nor for the silence after it.
void SpeechQueue::interruptFor(const Cue& cue) {
    // The answer to the newest key: what an older one began to tell is not wanted any more.
    if (cue.asked) m_gap.stop();
    if (cue.asked && m_current && (m_current->own || m_current->cue.asked)) {
        finish(UtteranceState::Interrupted);
        return speakNext();
    }
    if (!m_current) {
        if (cue.priority <= CuePriority::ActNow) m_gap.stop();
        return;
    }
    const bool contradicts =
        endsTheWay(cue) && tellsToMove(m_current->cue.kind) && !isLastOrder(m_current->cue, cue);
    if (cue.priority >= m_current->cue.priority && !contradicts) return;
    if (announcesIt(m_current->cue, cue)) return;
    // A remark such as "the recording has stopped" must not cost the user the turn that was being told.
    std::optional<Utterance> again;
    if (cue.kind == CueKind::Warning && !endsTheWay(cue) && actionable(m_current->cue)) again = m_current;
    finish(UtteranceState::Interrupted);
    if (again && !stale(again->cue)) enqueue(std::move(*again));
    speakNext();
    if (!m_current) m_output->stop();
}

void SpeechQueue::setNow(double time, const std::optional<RegionId>& region, std::uint64_t routeVersion) {
    // A replay that jumped back: nothing of this was told yet. A screen that lags a little behind is no jump.
    if (time < m_now - kJumpSeconds) m_told.clear();
    m_now = time;
    m_region = region;
    m_routeVersion = routeVersion;
    dropWaiting([this](const Utterance& utterance) { return stale(utterance.cue); }, UtteranceState::Expired);
    std::erase_if(m_told, [this](const Told& told) { return m_now - told.cue.time >= kRepeatSeconds; });
    // An instruction of an old route is wrong while it is being spoken, too; one whose place was just left is
    // only a little late, and its end may still be needed ("then turn right").
    if (!m_current || m_current->cue.routeVersion == 0 || m_current->cue.routeVersion >= m_routeVersion)
        return;
    finish(UtteranceState::Interrupted);
    m_output->stop();
    speakNext();
}

void SpeechQueue::dropWaiting(const std::function<bool(const Utterance&)>& unwanted, UtteranceState state) {
    std::vector<Utterance> dropped;
    for (auto it = m_waiting.begin(); it != m_waiting.end();) {
        if (!unwanted(*it)) {
            ++it;
            continue;
        }
        dropped.push_back(std::move(*it));
        it = m_waiting.erase(it);
    }
    for (Utterance& utterance : dropped) {
        utterance.state = state;
        Q_EMIT changed(utterance);
    }
}

void SpeechQueue::speakNext() {
    m_gap.stop();
    if (m_current || m_muted) return;
    dropWaiting([this](const Utterance& utterance) { return stale(utterance.cue); }, UtteranceState::Expired);
    if (m_waiting.empty()) return;
    m_current = std::move(m_waiting.front());
    m_waiting.erase(m_waiting.begin());
    dropOldDistance(*m_current);
    m_current->state = UtteranceState::Speaking;
    if (actionable(m_current->cue)) m_lastActionable = m_current;
    const Utterance started = *m_current;
    Q_EMIT changed(started);
    m_output->say(started.text);
}

/// "In about 6 metres" that had to wait is 4 metres by now: "soon".
void SpeechQueue::dropOldDistance(Utterance& utterance) {
    const bool moves = utterance.cue.kind == CueKind::Prepare || utterance.cue.kind == CueKind::Reassure;
    if (utterance.own || !moves || !utterance.cue.distanceM) return;
    if (m_now - utterance.cue.time <= kOldDistanceSeconds) return;
    utterance.cue.distanceM.reset();
    utterance.text = m_phrasebook.sentence(utterance.cue);
}

void SpeechQueue::pauseThenNext() {
    // Whoever has pressed a key waits for the answer: no silence before it.
    const bool asked = !m_waiting.empty() && m_waiting.front().cue.asked;
    if (asked || m_gap.interval() <= 0)
        speakNext();
    else
        m_gap.start();
}

void SpeechQueue::finish(UtteranceState state) {
    Utterance ended = std::move(*m_current);
    m_current.reset();
    ended.state = state;
    if (state == UtteranceState::Spoken && !ended.own) m_told.push_back({ended.cue, ended.text});
    Q_EMIT changed(ended);
}

void SpeechQueue::show(Utterance utterance) {
    utterance.state = UtteranceState::Shown;
    if (actionable(utterance.cue)) m_lastActionable = utterance;
    Q_EMIT changed(utterance);
}

void SpeechQueue::outputFailed(const QString& message) {
    if (!m_current) return;
    finish(UtteranceState::Shown);
    if (message != m_trouble) {
        m_trouble = message;
        Q_EMIT trouble(message);
    }
    speakNext();
}

void SpeechQueue::repeatLast() {
    Utterance again;
    const bool old = m_lastActionable && m_lastActionable->cue.routeVersion != 0 &&
                     m_lastActionable->cue.routeVersion < m_routeVersion;
    if (m_lastActionable && !old) {
        again.cue = m_lastActionable->cue;
        again.cue.distanceM.reset();
        again.cue.firstM.reset();
        again.cue.hour.reset();
        again.cue.turnFirst.reset();
        again.cue.time = m_now;
        again.cue.validUntil = 0.0; // asked for now, so it is wanted now
        again.cue.validIn.clear();
        again.text = m_phrasebook.sentence(again.cue);
    }
    if (again.text.isEmpty()) {
        again.cue = {};
        again.text = tr("There is nothing to repeat.");
    }
    if (m_muted) {
        show(std::move(again));
        return;
    }
    if (m_current && m_current->cue.priority == CuePriority::Warning) {
        enqueue(std::move(again));
        return;
    }
    if (m_current) finish(UtteranceState::Interrupted);
    m_gap.stop();
    // In front of everything: the user has asked for it.
    m_waiting.insert(m_waiting.begin(), std::move(again));
    Q_EMIT changed(Utterance(m_waiting.front()));
    speakNext();
}

void SpeechQueue::say(const QString& text) {
    Utterance own;
    own.cue.kind = CueKind::Located; // no instruction to move, so that no other cue makes it void
    own.cue.priority = CuePriority::Answer;
    own.cue.time = m_now;
    own.text = text;
    own.own = true;
    dropWaiting([](const Utterance& old) { return old.own; }, UtteranceState::Expired);
    if (m_muted) return show(std::move(own));
    interruptForOwn();
    const auto place = std::find_if(m_waiting.begin(), m_waiting.end(), [](const Utterance& old) {
        return old.cue.priority > CuePriority::Warning;
    });
    const Utterance told = *m_waiting.insert(place, std::move(own));
    Q_EMIT changed(told);
    speakNext();
}

void SpeechQueue::interruptForOwn() {
    m_gap.stop();
    if (!m_current || m_current->cue.priority == CuePriority::Warning) return;
    std::optional<Utterance> again;
    if (!m_current->own && actionable(m_current->cue)) again = m_current;
    finish(UtteranceState::Interrupted);
    if (again && !stale(again->cue)) enqueue(std::move(*again));
}

void SpeechQueue::forgetWay() {
    const auto ofTheWay = [](const Utterance& utterance) { return utterance.cue.routeVersion != 0; };
    if (m_lastActionable && ofTheWay(*m_lastActionable)) m_lastActionable.reset();
    dropWaiting(ofTheWay, UtteranceState::Expired);
    if (!m_current || !ofTheWay(*m_current)) return;
    finish(UtteranceState::Interrupted);
    m_output->stop();
    speakNext();
}

void SpeechQueue::setMuted(bool muted) {
    if (muted == m_muted) return;
    m_muted = muted;
    if (!muted) return;
    m_gap.stop();
    if (m_current) {
        finish(UtteranceState::Interrupted);
        m_output->stop();
    }
    std::vector<Utterance> unspoken = std::exchange(m_waiting, {});
    for (Utterance& utterance : unspoken) show(std::move(utterance));
}

void SpeechQueue::clear() {
    m_gap.stop();
    if (m_current) {
        finish(UtteranceState::Interrupted);
        m_output->stop();
    }
    dropWaiting([](const Utterance&) { return true; }, UtteranceState::Expired);
    m_lastActionable.reset();
    m_told.clear();
    m_trouble.clear();
    m_now = 0.0;
    m_region.reset();
    m_routeVersion = 0;
}

} // namespace farol::ui
