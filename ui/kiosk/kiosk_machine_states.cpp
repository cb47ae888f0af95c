// What each command does in each state. Every one ends in words.

#include "ui/kiosk/kiosk_machine.h"
#include "ui/speech/spoken.h"

namespace farol::ui {

void KioskMachine::loading(KioskCommand command) {
    if (command != KioskCommand::Back) return say(stateWords());
    m_before = m_state;
    setState(KioskState::LeaveQuestion);
    say(stateWords());
}

void KioskMachine::choosing(KioskCommand command) {
    switch (command) {
    case KioskCommand::Down:
        return moveTo(m_places.current() + 1);
    case KioskCommand::Up:
        return moveTo(m_places.current() - 1);
    case KioskCommand::First:
        return moveTo(0);
    case KioskCommand::Last:
        return moveTo(m_places.count() - 1);
    case KioskCommand::Left:
        return changeCategory(-1);
    case KioskCommand::Right:
        return changeCategory(1);
    case KioskCommand::Enter:
        return confirm();
    case KioskCommand::Find:
        return startTyping({});
    case KioskCommand::Repeat:
        return say(stateWords());
    case KioskCommand::Next:
    case KioskCommand::List:
        return say(tr("No destination is chosen yet. Choose one first."));
    case KioskCommand::Back:
        if (!m_places.typed().isEmpty() || m_inCategory) return toChoosing();
        m_before = m_state;
        setState(KioskState::LeaveQuestion);
        return say(stateWords());
    default:
        performAsked(command);
    }
}

void KioskMachine::moveTo(int index) {
    const int count = m_places.count();
    QStringList words;
    if (index < 0) words << tr("This is the first place.");
    if (index >= count) words << tr("This is the last place.");
    m_places.setCurrent(std::max(0, std::min(index, count - 1)));
    words << placeWords();
    say(spoken::joined(words));
    Q_EMIT changed();
}

void KioskMachine::changeCategory(int by) {
    const int count = m_places.categories();
    m_places.setCategory((m_places.category() + by + count) % count);
    m_places.setCurrent(0);
    //: %1 "Rooms", %2 the first of them
    say(tr("%1: %n place(s). %2.", nullptr, m_places.count())
            .arg(m_places.categoryWords(), m_places.wordsAt(0)));
    Q_EMIT changed();
}

void KioskMachine::startTyping(const QString& first) {
    m_places.setTyped({});
    setState(KioskState::Typing);
    if (first.isEmpty()) return say(tr("Type part of a name or a number, then press Enter."));
    type(first);
}

void KioskMachine::type(const QString& text) {
    m_places.setTyped(m_places.typed() + text);
    const QString letter = text == QLatin1String(" ") ? tr("space") : text;
    //: %1 the letter just typed
    say(tr("%1: %n place(s).", "while typing", m_places.count()).arg(letter));
    Q_EMIT changed();
}

/// False: the key is none of typing, and does what it does in the list.
bool KioskMachine::typing(const KioskKey& key, KioskCommand command) {
    const bool pad = key.keypad && !(isTyped(key) && key.text[0].isDigit());
    if (key.key == Qt::Key_Backspace) {
        const QString typed = m_places.typed();
        if (typed.isEmpty()) {
            say(tr("Nothing is typed."));
            return true;
        }
        m_places.setTyped(typed.chopped(1));
        say(tr("Deleted: %1. %2").arg(typed.right(1), typedWords()));
        Q_EMIT changed();
        return true;
    }
    if (!pad && isTyped(key)) {
        type(key.text);
        return true;
    }
    switch (command) {
    case KioskCommand::Back:
        toChoosing();
        return true;
    case KioskCommand::Enter:
        endTyping();
        return true;
    case KioskCommand::Up:
    case KioskCommand::Down:
        if (m_places.count() == 0) {
            say(typedWords());
            return true;
        }
        setState(KioskState::Choosing);
        moveTo(command == KioskCommand::Down ? 0 : m_places.count() - 1);
        return true;
    case KioskCommand::Help:
    case KioskCommand::Language:
    case KioskCommand::Switches:
        return false;
    default:
        say(KioskWords::unknownKey());
        return true;
    }
}

void KioskMachine::endTyping() {
    if (m_places.typed().trimmed().isEmpty()) return toChoosing();
    if (m_places.count() == 0) return say(typedWords());
    setState(KioskState::Choosing);
    m_places.setCurrent(0);
    // Not gone to at once, even when it is the only one: it is heard first.
    say(tr("%1 %2. Enter: go there. Arrow down: next.").arg(typedWords(), m_places.wordsAt(0)));
    Q_EMIT changed();
}

void KioskMachine::confirm() {
    const std::optional<RegionId> chosen = m_places.chosen();
    if (!chosen) return say(tr("Nothing is chosen yet. Press arrow down to hear the places."));
    toPreview(*chosen);
}

void KioskMachine::toChoosing() {
    const bool had = m_destination.has_value();
    m_destination.reset();
    m_inCategory = false;
    m_places.setCategory(0);
    setState(KioskState::Choosing);
    if (had) Q_EMIT destinationChosen(m_destination);
    say(withRemarks(chooseWords()));
}

void KioskMachine::toPreview(const RegionId& region) {
    m_destination = region;
    m_wayTold = false;
    setState(KioskState::Preview);
    say(previewWords());
    Q_EMIT destinationChosen(m_destination);
}

void KioskMachine::toWalking() {
    setState(KioskState::Walking);
    if (m_camera == KioskCamera::Gone) {
        Q_EMIT cameraWanted();
        return say(tr("I try the camera again."));
    }
    ask(KioskQuestion::Next);
}

void KioskMachine::preview(KioskCommand command) {
    switch (command) {
    case KioskCommand::Enter:
        return toWalking();
    case KioskCommand::Back:
        return toChoosing();
    case KioskCommand::Repeat:
        return say(previewWords());
    case KioskCommand::List:
        return ask(KioskQuestion::Preview);
    case KioskCommand::Next:
        return ask(KioskQuestion::Next);
    default:
        performAsked(command);
    }
}

void KioskMachine::walking(KioskCommand command) {
    switch (command) {
    case KioskCommand::Enter:
        if (m_camera != KioskCamera::Gone) return ask(KioskQuestion::Next);
        Q_EMIT cameraWanted();
        return say(tr("I try the camera again."));
    case KioskCommand::Next:
        return ask(KioskQuestion::Next);
    case KioskCommand::List:
        return ask(KioskQuestion::Remaining);
    case KioskCommand::Repeat:
        return ask(KioskQuestion::Repeat);
    case KioskCommand::Back:
        m_before = m_state;
        setState(KioskState::StopQuestion);
        return say(stateWords());
    default:
        performAsked(command);
    }
}

void KioskMachine::arrived(KioskCommand command) {
    switch (command) {
    case KioskCommand::Enter:
    case KioskCommand::Back:
        return toChoosing();
    case KioskCommand::Repeat:
    case KioskCommand::Next:
    case KioskCommand::List:
        return say(stateWords());
    default:
        performAsked(command);
    }
}

/// Yes by Enter or Escape again; every other key goes on as before.
void KioskMachine::question(KioskCommand command) {
    const bool yes = command == KioskCommand::Enter || command == KioskCommand::Back;
    if (!yes) {
        setState(m_before);
        return say(tr("Going on. %1").arg(stateWords()));
    }
    if (m_state == KioskState::StopQuestion) return toChoosing();
    holdBack();
}

void KioskMachine::help(KioskCommand command) {
    switch (command) {
    case KioskCommand::Back:
        setState(m_before);
        return say(stateWords());
    case KioskCommand::Help:
        return say(KioskWords::numberPad());
    case KioskCommand::None:
        return say(tr("This key does nothing. Escape: back."));
    default:
        say(KioskWords::explained(command));
    }
}

} // namespace farol::ui
