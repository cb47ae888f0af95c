#include "ui/kiosk/kiosk_machine.h"

#include "ui/speech/spoken.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace farol::ui {

using guidance::Cue;
using guidance::CueKind;
using guidance::CuePriority;

namespace {

constexpr int kSweepMs = 6000;    // as the coached look around of someone lost
constexpr int kPatienceMs = 200;  // longer, and a key seems to do nothing
constexpr double kRateStep = 0.2; // five steps to each side

/// One key goes round: whoever hears words he does not understand presses it again.
QString nextLanguage() {
    const QList<Language>& all = languages();
    qsizetype at = 0;
    while (at < all.size() && all[at].code != installedLanguage()) ++at;
    return all[(at + 1) % all.size()].code;
}

bool isArrival(const Cue& cue) {
    return cue.kind == CueKind::Arrived || cue.kind == CueKind::AlreadyThere;
}

bool namesDestination(const Cue& cue) {
    return !cue.region.empty() && !cue.asked &&
           (cue.kind == CueKind::RouteStart || cue.kind == CueKind::NoRoute || isArrival(cue));
}

} // namespace

KioskMachine::KioskMachine(Settings& settings, QObject* parent) : QObject(parent), m_settings(settings) {
    m_patience.setSingleShot(true);
    setPace(kSweepMs, kPatienceMs);
    connect(&m_patience, &QTimer::timeout, this, [this] { say(tr("One moment.")); });
    connect(&m_sweepTimer, &QTimer::timeout, this, &KioskMachine::stepSweep);
}

void KioskMachine::setPace(int sweepMs, int patienceMs) {
    m_sweepTimer.setInterval(sweepMs);
    m_patience.setInterval(patienceMs);
}

void KioskMachine::say(const QString& text) {
    Q_EMIT said(text);
}

void KioskMachine::setState(KioskState state) {
    m_option = -1;
    m_state = state;
    Q_EMIT changed();
}

/// Behind help and questions.
KioskState KioskMachine::underlying() const {
    const bool over = m_state == KioskState::Help || m_state == KioskState::StopQuestion ||
                      m_state == KioskState::LeaveQuestion;
    return over ? m_before : m_state;
}

bool KioskMachine::guiding() const {
    const KioskState state = underlying();
    return state == KioskState::Walking || state == KioskState::Arrived;
}

void KioskMachine::greet() {
    say(tr("Farol. I am opening the map."));
}

void KioskMachine::setBuilding(std::shared_ptr<const building::Building> building) {
    m_building = std::move(building);
    m_mapFailed = false;
    m_region.reset();
    m_places.setBuilding(m_building);
    if (!m_places.any()) {
        setState(KioskState::Loading);
        say(stateWords());
        return;
    }
    if (m_wish && m_building->region(m_wish->destination)) return wishGranted();
    m_wish.reset();
    toChoosing();
}

void KioskMachine::mapFailed() {
    m_mapFailed = true;
    if (m_building) return say(tr("The new map cannot be opened. I keep the old one."));
    setState(KioskState::Loading);
    say(stateWords());
}

void KioskMachine::remark(const QString& text) {
    if (!m_remarks.contains(text)) m_remarks << text;
}

QString KioskMachine::withRemarks(const QString& words) {
    return spoken::joined(QStringList{words} + std::exchange(m_remarks, {}));
}

void KioskMachine::refuse(const QString& why) {
    setState(KioskState::Leaving);
    say(why);
    Q_EMIT left();
}

void KioskMachine::setWish(const RegionId& destination, bool afterCrash,
                           const std::optional<RegionId>& region) {
    m_wish = Wish{destination, afterCrash, region};
}

void KioskMachine::wishGranted() {
    const Wish wish = *m_wish;
    m_wish.reset();
    m_destination = wish.destination;
    m_wayTold = false;
    Q_EMIT destinationChosen(m_destination);
    setState(KioskState::Preview);
    if (!wish.afterCrash) return say(withRemarks(previewWords()));
    QStringList words{tr("Farol was interrupted and has started again.")};
    const QString place = wish.region ? m_places.words(*wish.region) : QString();
    if (!place.isEmpty()) words << tr("You were last here: %1.").arg(place);
    words << previewWords();
    say(withRemarks(spoken::joined(words)));
}

void KioskMachine::setCamera(KioskCamera camera, bool told) {
    if (camera == m_camera) return;
    m_camera = camera;
    if (camera == KioskCamera::Gone) {
        m_cameraWasGone = true;
        stopSweep();
        m_patience.stop();
        if (!told) say(cameraWords());
    } else if (camera == KioskCamera::Running && m_cameraWasGone) {
        m_cameraWasGone = false;
        if (!told) say(tr("The camera works again."));
    }
    Q_EMIT changed();
}

void KioskMachine::setRegion(const std::optional<RegionId>& region) {
    m_region = region;
}

bool KioskMachine::wants(const Cue& cue) {
    if (cue.asked) m_patience.stop();
    const bool warning = cue.priority == CuePriority::Warning;
    const KioskState state = underlying();
    const bool way = state == KioskState::Walking || state == KioskState::Preview;
    // What was on its way when another destination was chosen.
    if (m_destination && namesDestination(cue) && cue.region != *m_destination) return false;
    if (m_state == KioskState::Leaving) return warning;
    if (way && isArrival(cue)) return true;
    if (m_sweep > 0 && cue.kind == CueKind::Unsure) return false; // one coach at a time
    if (warning || cue.asked) return true;
    switch (state) {
    case KioskState::Preview:
        if (cue.kind == CueKind::NoRoute) {
            m_destination.reset();
            setState(KioskState::Choosing);
            Q_EMIT destinationChosen(m_destination);
            return true;
        }
        // Who waits for the way hears why there is none yet, and what to do about it.
        if (cue.kind == CueKind::Unsure) return !m_wayTold;
        m_wayTold = m_wayTold || cue.kind == CueKind::RouteStart;
        return cue.kind == CueKind::RouteStart;
    case KioskState::Walking:
        return !m_quiet;
    default:
        return false;
    }
}

void KioskMachine::told(const Cue& cue) {
    const KioskState state = underlying();
    const bool way = state == KioskState::Walking || state == KioskState::Preview;
    if (!way || !isArrival(cue) || m_state == KioskState::Leaving) return;
    stopSweep();
    m_arrivalSure = cue.sure;
    setState(KioskState::Arrived);
}

void KioskMachine::press(const KioskKey& key) {
    if (isModifier(key.key)) return;
    if (m_state == KioskState::Leaving) return say(stateWords());
    stopSweep();
    m_patience.stop();
    const KioskCommand command = commandOf(key);
    if (m_state == KioskState::Typing && typing(key, command)) return;
    // A room number can be typed at once; letters are commands, so that names begin with F.
    if (m_state == KioskState::Choosing && !key.keypad && isTyped(key) && key.text[0].isDigit())
        return startTyping(key.text);
    const bool offered = m_settings.twoKeys() && m_state != KioskState::Help;
    if (offered && command == KioskCommand::Repeat) return scanOptions();
    if (offered && command == KioskCommand::Enter) return chooseOption();
    perform(command);
}

void KioskMachine::perform(KioskCommand command) {
    if (m_state == KioskState::Help) return help(command);
    if (m_state == KioskState::StopQuestion || m_state == KioskState::LeaveQuestion) return question(command);
    if (command == KioskCommand::Help) {
        m_before = m_state;
        setState(KioskState::Help);
        return say(KioskWords::allKeys());
    }
    if (performSetting(command)) return;
    switch (m_state) {
    case KioskState::Choosing:
        return choosing(command);
    case KioskState::Preview:
        return preview(command);
    case KioskState::Walking:
        return walking(command);
    case KioskState::Arrived:
        return arrived(command);
    default:
        return loading(command);
    }
}

void KioskMachine::holdBack() {
    if (m_state == KioskState::Leaving) return;
    stopSweep();
    m_patience.stop();
    setState(KioskState::Leaving);
    say(stateWords());
    Q_EMIT left();
}

/// What means the same in every state with a map.
void KioskMachine::performAsked(KioskCommand command) {
    switch (command) {
    case KioskCommand::WhereAmI:
        return ask(KioskQuestion::WhereAmI);
    case KioskCommand::AroundMe:
        return ask(KioskQuestion::AroundMe);
    case KioskCommand::Scan:
        return startSweep();
    default:
        say(KioskWords::unknownKey());
    }
}

bool KioskMachine::performSetting(KioskCommand command) {
    switch (command) {
    case KioskCommand::Mute:
        m_quiet = !m_quiet;
        break;
    case KioskCommand::Faster:
    case KioskCommand::Slower: {
        VoiceChoice voice = m_settings.voice();
        const double step = command == KioskCommand::Faster ? kRateStep : -kRateStep;
        voice.rate = std::clamp(std::round((voice.rate + step) * 5.0) / 5.0, -1.0, 1.0);
        m_settings.setVoice(voice);
        break;
    }
    case KioskCommand::Verbosity:
        m_settings.setVerbosity(
            static_cast<guidance::Verbosity>((static_cast<int>(m_settings.verbosity()) + 1) % 3));
        break;
    case KioskCommand::Directions:
        m_settings.setDirectionStyle(
            static_cast<DirectionStyle>((static_cast<int>(m_settings.directionStyle()) + 1) % 3));
        break;
    case KioskCommand::Units:
        m_settings.setUnit(static_cast<DistanceUnit>((static_cast<int>(m_settings.unit()) + 1) % 3));
        break;
    case KioskCommand::Language:
        m_settings.setLanguage(nextLanguage());
        break;
    case KioskCommand::Switches:
        m_settings.setTwoKeys(!m_settings.twoKeys());
        m_option = -1;
        break;
    default:
        return false;
    }
    say(settingWords(command));
    Q_EMIT changed();
    return true;
}

void KioskMachine::ask(KioskQuestion question) {
    if (m_camera != KioskCamera::Running) return say(cameraWords());
    m_patience.start();
    Q_EMIT asked(question);
}

void KioskMachine::startSweep() {
    if (m_camera != KioskCamera::Running) return say(cameraWords());
    m_sweep = 0;
    m_sweepTimer.start();
    stepSweep();
}

void KioskMachine::stepSweep() {
    ++m_sweep;
    Cue order;
    order.kind = CueKind::Unsure;
    switch (m_sweep) {
    case 1:
        return say(tr("Stop, and turn slowly to the right, so that I can look around."));
    case 2:
        order.sweep = guidance::SweepStep::Left;
        break;
    case 3:
        order.sweep = guidance::SweepStep::Up;
        break;
    case 4:
        order.sweep = guidance::SweepStep::Down;
        break;
    default:
        stopSweep();
        return ask(KioskQuestion::WhereAmI);
    }
    say(Phrasebook().sentence(order));
}

void KioskMachine::stopSweep() {
    m_sweep = 0;
    m_sweepTimer.stop();
}

void KioskMachine::retranslate() {
    const std::optional<RegionId> chosen = m_places.chosen();
    const int category = m_places.category();
    const QString typed = m_places.typed();
    const int current = m_places.current();
    m_places.setBuilding(m_building);
    m_places.setCategory(category);
    if (!typed.isEmpty()) m_places.setTyped(typed);
    m_places.setCurrent(current);
    if (m_places.chosen() != chosen) m_places.setCurrent(-1); // another order: nothing is chosen by chance
    Q_EMIT changed();
}

} // namespace farol::ui
