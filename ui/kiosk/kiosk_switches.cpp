// Everything with two keys: space goes through what there is, Enter takes it.

#include "ui/kiosk/kiosk_machine.h"
#include "ui/speech/spoken.h"

namespace farol::ui {

KioskMachine::Option KioskMachine::optionOf(KioskCommand command) {
    return {spoken::sentence(KioskWords::meaning(command)), command};
}

std::vector<KioskMachine::Option> KioskMachine::choosingOptions() const {
    std::vector<Option> all;
    if (m_inCategory) {
        for (int i = 0; i < m_places.count(); ++i)
            all.push_back({spoken::sentence(m_places.wordsAt(i)), KioskCommand::None, -1, i});
        all.push_back({tr("Back to the kinds of places."), KioskCommand::Back});
        return all;
    }
    for (int i = 0; i < m_places.categories(); ++i)
        all.push_back({spoken::sentence(m_places.categoryWordsAt(i)), KioskCommand::None, i, -1});
    all.push_back(optionOf(KioskCommand::WhereAmI));
    all.push_back(optionOf(KioskCommand::AroundMe));
    all.push_back(optionOf(KioskCommand::Slower));
    all.push_back(optionOf(KioskCommand::Faster));
    all.push_back({tr("Leave Farol."), KioskCommand::Back});
    return all;
}

std::vector<KioskMachine::Option> KioskMachine::options() const {
    using enum KioskCommand;
    switch (m_state) {
    case KioskState::Choosing:
        return choosingOptions();
    case KioskState::Preview:
        return {{tr("Start."), Enter}, {tr("Hear the whole way."), List}, {tr("Another place."), Back}};
    case KioskState::Walking: {
        std::vector<Option> all;
        if (m_camera == KioskCamera::Gone) all.push_back({tr("Try the camera again."), Enter});
        for (const KioskCommand command : {Repeat, WhereAmI, AroundMe, List, Scan, Mute})
            all.push_back(optionOf(command));
        all.push_back({tr("Stop the guidance."), Back});
        return all;
    }
    case KioskState::Arrived:
        return {{tr("Choose another place."), Enter}, optionOf(WhereAmI), optionOf(AroundMe)};
    case KioskState::StopQuestion:
        return {{tr("Yes, stop."), Enter}, {tr("No, go on."), None}};
    case KioskState::LeaveQuestion:
        return {{tr("Yes, leave."), Enter}, {tr("No, stay."), None}};
    default:
        return {{stateWords(), None}, {tr("Leave Farol."), Back}};
    }
}

void KioskMachine::scanOptions() {
    const std::vector<Option> all = options();
    m_option = (m_option + 1) % static_cast<int>(all.size());
    say(all[static_cast<std::size_t>(m_option)].words);
}

void KioskMachine::chooseOption() {
    const std::vector<Option> all = options();
    if (m_option < 0 || m_option >= static_cast<int>(all.size()))
        return say(tr("Press space to hear what there is, then Enter."));
    const Option taken = all[static_cast<std::size_t>(m_option)];
    if (taken.category >= 0) {
        m_places.setCategory(taken.category);
        m_inCategory = true;
        m_option = -1;
        say(tr("%1: %n place(s). Space: first place.", nullptr, m_places.count())
                .arg(m_places.categoryWords()));
        Q_EMIT changed();
        return;
    }
    if (taken.place >= 0) {
        m_places.setCurrent(taken.place);
        return confirm();
    }
    perform(taken.command);
}

} // namespace farol::ui
