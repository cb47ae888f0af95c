// What the kiosk says of itself: short, the thing first, the key behind it.

#include "ui/kiosk/kiosk_machine.h"
#include "ui/speech/spoken.h"

#include <cmath>

namespace farol::ui {

QString KioskMachine::destinationWords() const {
    return m_destination ? m_places.words(*m_destination) : QString();
}

QString KioskMachine::placeWords() const {
    //: %1 a place, then which of how many
    return tr("%1. %2 of %3.")
        .arg(m_places.wordsAt(m_places.current()), QString::number(m_places.current() + 1),
             QString::number(m_places.count()));
}

QString KioskMachine::chooseWords() const {
    const QString places = tr("Choose a destination: %n place(s).", nullptr, m_places.count());
    return places + QLatin1Char(' ') +
           (m_settings.twoKeys() ? tr("Space: next. Enter: take it.")
                                 : tr("Arrow down: first place. F: type a name. F1: all keys."));
}

QString KioskMachine::previewWords() const {
    QStringList words{tr("To: %1.").arg(destinationWords())};
    if (m_camera != KioskCamera::Running)
        words << cameraWords();
    else if (!m_region)
        words << tr("I do not know yet where you are, and look for it on the way.");
    words << (m_settings.twoKeys() ? tr("Space: choices.")
                                   : tr("Enter: start. L: the whole way. Escape: another place."));
    return spoken::joined(words);
}

QString KioskMachine::questionWords() const {
    const QString what = m_state == KioskState::StopQuestion ? tr("Stop the guidance?") : tr("Leave Farol?");
    return what + QLatin1Char(' ') +
           (m_settings.twoKeys() ? tr("Space: choices.") : tr("Enter or Escape: yes. Any other key: no."));
}

QString KioskMachine::cameraWords() const {
    switch (m_camera) {
    case KioskCamera::None:
        return tr("No camera is set up, and I cannot guide you. Ask for help.");
    case KioskCamera::Opening:
        return tr("The camera is starting.");
    case KioskCamera::Gone:
        return underlying() == KioskState::Walking
                   ? tr("Stop. The camera gives no pictures, and I cannot guide you. Enter: try again.")
                   : tr("The camera gives no pictures. I try it again when you start.");
    case KioskCamera::Running:
        break;
    }
    return {};
}

QString KioskMachine::typedWords() const {
    const QString typed = m_places.typed();
    if (typed.trimmed().isEmpty()) return tr("Nothing is typed.");
    if (m_places.count() == 0) return tr("No place fits: %1. Delete letters, or press Escape.").arg(typed);
    return tr("%n place(s) fit: %1.", nullptr, m_places.count()).arg(typed);
}

QString KioskMachine::stateWords() const {
    switch (m_state) {
    case KioskState::Loading:
        if (m_building) return tr("This map has no places to go to. Ask for help.");
        return m_mapFailed ? tr("The map cannot be opened. Ask for help.")
                           : tr("The map is being opened. Please wait.");
    case KioskState::Choosing:
        return m_places.current() >= 0 ? placeWords() : chooseWords();
    case KioskState::Typing:
        return typedWords();
    case KioskState::Preview:
        return previewWords();
    case KioskState::Walking:
        return tr("On the way to: %1.").arg(destinationWords());
    case KioskState::Arrived:
        return (m_arrivalSure ? tr("You have arrived: %1. Enter: another destination.")
                              : tr("You have probably arrived: %1. Enter: another destination."))
            .arg(destinationWords());
    case KioskState::StopQuestion:
    case KioskState::LeaveQuestion:
        return questionWords();
    case KioskState::Help:
        return KioskWords::allKeys();
    case KioskState::Leaving:
        break;
    }
    return tr("Goodbye.");
}

QString KioskMachine::settingWords(KioskCommand command) const {
    switch (command) {
    case KioskCommand::Mute:
        return m_quiet ? tr("Quiet: I tell only warnings and what you ask. M: speak again.")
                       : tr("I tell everything again.");
    case KioskCommand::Faster:
    case KioskCommand::Slower: {
        const int step = static_cast<int>(std::lround(m_settings.voice().rate * 5.0)) + 6;
        return tr("Speed %1 of %2.").arg(QString::number(step), QStringLiteral("11"));
    }
    case KioskCommand::Verbosity:
        return KioskWords::verbosity(m_settings.verbosity());
    case KioskCommand::Directions:
        return KioskWords::style(m_settings.directionStyle());
    case KioskCommand::Units:
        return KioskWords::unit(m_settings.unit());
    case KioskCommand::Language:
        return tr("I speak English now.");
    default:
        return m_settings.twoKeys()
                   ? tr("Two keys: space goes through the choices, Enter takes one. F4: all keys again.")
                   : tr("All keys are in use again.");
    }
}

QString KioskMachine::title() const {
    switch (m_state) {
    case KioskState::Loading:
        return tr("Farol");
    case KioskState::Choosing:
        return tr("Where to? %1")
            .arg(m_places.typed().isEmpty() ? m_places.categoryWords() : m_places.typed());
    case KioskState::Typing:
        return tr("Search: %1").arg(m_places.typed());
    case KioskState::Preview:
        return tr("The way to %1").arg(destinationWords());
    case KioskState::Walking:
        return tr("Walking to %1").arg(destinationWords());
    case KioskState::Arrived:
        return m_arrivalSure ? tr("Arrived") : tr("Probably arrived");
    case KioskState::StopQuestion:
        return tr("Stop?");
    case KioskState::LeaveQuestion:
        return tr("Leave?");
    case KioskState::Help:
        return tr("Keys");
    case KioskState::Leaving:
        break;
    }
    return tr("Goodbye");
}

QString KioskMachine::hint() const {
    if (m_settings.twoKeys()) return tr("Space: next   Enter: take   F4: all keys");
    switch (m_state) {
    case KioskState::Choosing:
        return tr("Arrows: places   Enter: go   F: search   F1: keys");
    case KioskState::Typing:
        return tr("Enter: done   Esc: back");
    case KioskState::Preview:
        return tr("Enter: start   L: whole way   Esc: back");
    case KioskState::Walking:
        return tr("Space: again   W: where am I   Esc: stop");
    case KioskState::Arrived:
        return tr("Enter: another destination");
    case KioskState::StopQuestion:
    case KioskState::LeaveQuestion:
        return tr("Enter: yes   any other key: no");
    case KioskState::Help:
        return tr("Esc: back   F1: number pad");
    case KioskState::Loading:
        return tr("Esc: leave   F1: keys");
    case KioskState::Leaving:
        break;
    }
    return {};
}

QString KioskWords::key(KioskCommand command) {
    switch (command) {
    case KioskCommand::Up:
        return tr("Arrow up");
    case KioskCommand::Down:
        return tr("Arrow down");
    case KioskCommand::First:
        return tr("Home");
    case KioskCommand::Last:
        return tr("End");
    case KioskCommand::Left:
        return tr("Arrow left");
    case KioskCommand::Right:
        return tr("Arrow right");
    case KioskCommand::Enter:
        return tr("Enter");
    case KioskCommand::Back:
        return tr("Escape");
    case KioskCommand::Repeat:
        return tr("Space");
    case KioskCommand::WhereAmI:
        return QStringLiteral("W");
    case KioskCommand::AroundMe:
        return QStringLiteral("A");
    case KioskCommand::Next:
        return QStringLiteral("N");
    case KioskCommand::List:
        return QStringLiteral("L");
    case KioskCommand::Scan:
        return QStringLiteral("S");
    case KioskCommand::Mute:
        return QStringLiteral("M");
    case KioskCommand::Faster:
        return tr("Plus");
    case KioskCommand::Slower:
        return tr("Minus");
    case KioskCommand::Verbosity:
        return QStringLiteral("V");
    case KioskCommand::Directions:
        return QStringLiteral("D");
    case KioskCommand::Units:
        return QStringLiteral("U");
    case KioskCommand::Find:
        return QStringLiteral("F");
    case KioskCommand::Help:
        return QStringLiteral("F1");
    case KioskCommand::Language:
        return QStringLiteral("F2");
    case KioskCommand::Switches:
        return QStringLiteral("F4");
    case KioskCommand::None:
        break;
    }
    return {};
}

QString KioskWords::meaning(KioskCommand command) {
    switch (command) {
    case KioskCommand::Up:
        return tr("the place before");
    case KioskCommand::Down:
        return tr("the next place");
    case KioskCommand::First:
        return tr("the first place");
    case KioskCommand::Last:
        return tr("the last place");
    case KioskCommand::Left:
        return tr("another kind of places, back");
    case KioskCommand::Right:
        return tr("another kind of places, on");
    case KioskCommand::Enter:
        return tr("choose, start");
    case KioskCommand::Back:
        return tr("back; hold it down to leave");
    case KioskCommand::Repeat:
        return tr("say again");
    case KioskCommand::WhereAmI:
        return tr("where am I");
    case KioskCommand::AroundMe:
        return tr("what is around me");
    case KioskCommand::Next:
        return tr("what comes next");
    case KioskCommand::List:
        return tr("the whole way");
    case KioskCommand::Scan:
        return tr("look around");
    case KioskCommand::Mute:
        return tr("quiet, or speak again");
    case KioskCommand::Faster:
        return tr("speak faster");
    case KioskCommand::Slower:
        return tr("speak slower");
    case KioskCommand::Verbosity:
        return tr("how much I tell");
    case KioskCommand::Directions:
        return tr("how I tell directions");
    case KioskCommand::Units:
        return tr("metres, feet or steps");
    case KioskCommand::Find:
        return tr("search a place by typing");
    case KioskCommand::Help:
        return tr("the keys");
    case KioskCommand::Language:
        return tr("another language");
    case KioskCommand::Switches:
        return tr("everything with two keys");
    case KioskCommand::None:
        break;
    }
    return {};
}

QString KioskWords::explained(KioskCommand command) {
    //: %1 a key, %2 what it does
    return tr("%1: %2.").arg(key(command), meaning(command));
}

QString KioskWords::allKeys() {
    QStringList sentences{tr("Keys. Press one to hear what it does; F1: number pad; Escape: back.")};
    for (const KioskCommand command : kioskCommands()) sentences << explained(command);
    return spoken::joined(sentences);
}

QString KioskWords::numberPad() {
    return tr(
        "Number pad. 8 and 2: up and down. 4 and 6: left and right. 5 or Enter: choose. 0: say again. 1: "
        "where am I. 3: around me. 7: what comes next. 9: the whole way. Plus and minus: speed. Star: keys. "
        "Slash: quiet. Point: back.");
}

QString KioskWords::unknownKey() {
    return tr("This key does nothing here. F1: all keys.");
}

QString KioskWords::verbosity(guidance::Verbosity verbosity) {
    switch (verbosity) {
    case guidance::Verbosity::Directions:
        return tr("I tell directions only.");
    case guidance::Verbosity::Objects:
        return tr("I tell directions and objects.");
    case guidance::Verbosity::ObjectsAndTexts:
        break;
    }
    return tr("I tell directions, objects and texts.");
}

QString KioskWords::style(DirectionStyle style) {
    switch (style) {
    case DirectionStyle::LeftRight:
        return tr("Directions as left and right.");
    case DirectionStyle::Clock:
        return tr("Directions as on a clock.");
    case DirectionStyle::Degrees:
        break;
    }
    return tr("Directions in degrees.");
}

QString KioskWords::unit(DistanceUnit unit) {
    switch (unit) {
    case DistanceUnit::Metres:
        return tr("Distances in metres.");
    case DistanceUnit::Feet:
        return tr("Distances in feet.");
    case DistanceUnit::Steps:
        break;
    }
    return tr("Distances in steps.");
}

} // namespace farol::ui
