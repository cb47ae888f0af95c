#include "ui/kiosk/kiosk_keys.h"

#include <Qt>

namespace farol::ui {

namespace {

/// With and without Num Lock.
KioskCommand onNumberPad(int key) {
    switch (key) {
    case Qt::Key_8:
    case Qt::Key_Up:
        return KioskCommand::Up;
    case Qt::Key_2:
    case Qt::Key_Down:
        return KioskCommand::Down;
    case Qt::Key_4:
    case Qt::Key_Left:
        return KioskCommand::Left;
    case Qt::Key_6:
    case Qt::Key_Right:
        return KioskCommand::Right;
    case Qt::Key_5:
    case Qt::Key_Clear:
    case Qt::Key_Enter:
        return KioskCommand::Enter;
    case Qt::Key_0:
    case Qt::Key_Insert:
        return KioskCommand::Repeat;
    case Qt::Key_1:
    case Qt::Key_End:
        return KioskCommand::WhereAmI;
    case Qt::Key_3:
    case Qt::Key_PageDown:
        return KioskCommand::AroundMe;
    case Qt::Key_7:
    case Qt::Key_Home:
        return KioskCommand::Next;
    case Qt::Key_9:
    case Qt::Key_PageUp:
        return KioskCommand::List;
    case Qt::Key_Plus:
        return KioskCommand::Faster;
    case Qt::Key_Minus:
        return KioskCommand::Slower;
    case Qt::Key_Asterisk:
        return KioskCommand::Help;
    case Qt::Key_Slash:
        return KioskCommand::Mute;
    case Qt::Key_Period:
    case Qt::Key_Comma:
    case Qt::Key_Delete:
        return KioskCommand::Back;
    default:
        return KioskCommand::None;
    }
}

KioskCommand ofLetter(int key) {
    switch (key) {
    case Qt::Key_W:
        return KioskCommand::WhereAmI;
    case Qt::Key_A:
        return KioskCommand::AroundMe;
    case Qt::Key_N:
        return KioskCommand::Next;
    case Qt::Key_L:
        return KioskCommand::List;
    case Qt::Key_S:
        return KioskCommand::Scan;
    case Qt::Key_M:
        return KioskCommand::Mute;
    case Qt::Key_V:
        return KioskCommand::Verbosity;
    case Qt::Key_D:
        return KioskCommand::Directions;
    case Qt::Key_U:
        return KioskCommand::Units;
    case Qt::Key_F:
        return KioskCommand::Find;
    case Qt::Key_Plus:
    case Qt::Key_Equal: // plus without Shift on many keyboards
        return KioskCommand::Faster;
    case Qt::Key_Minus:
        return KioskCommand::Slower;
    case Qt::Key_F1:
        return KioskCommand::Help;
    case Qt::Key_F2:
        return KioskCommand::Language;
    case Qt::Key_F4:
        return KioskCommand::Switches;
    default:
        return KioskCommand::None;
    }
}

} // namespace

KioskCommand commandOf(const KioskKey& key) {
    if (key.keypad) return onNumberPad(key.key);
    switch (key.key) {
    case Qt::Key_Up:
        return KioskCommand::Up;
    case Qt::Key_Down:
        return KioskCommand::Down;
    case Qt::Key_Left:
        return KioskCommand::Left;
    case Qt::Key_Right:
        return KioskCommand::Right;
    case Qt::Key_Home:
        return KioskCommand::First;
    case Qt::Key_End:
        return KioskCommand::Last;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return KioskCommand::Enter;
    case Qt::Key_Escape:
        return KioskCommand::Back;
    case Qt::Key_Space:
        return KioskCommand::Repeat;
    default:
        return ofLetter(key.key);
    }
}

bool isModifier(int key) {
    switch (key) {
    case Qt::Key_Shift:
    case Qt::Key_Control:
    case Qt::Key_Alt:
    case Qt::Key_AltGr:
    case Qt::Key_Meta:
    case Qt::Key_Super_L:
    case Qt::Key_Super_R:
        return true;
    default:
        return key >= Qt::Key_Dead_Grave && key <= Qt::Key_Dead_Longsolidusoverlay;
    }
}

bool isTyped(const KioskKey& key) {
    return key.text.size() == 1 && key.text[0].isPrint();
}

bool repeats(KioskCommand command) {
    return command == KioskCommand::Up || command == KioskCommand::Down || command == KioskCommand::Left ||
           command == KioskCommand::Right;
}

const std::vector<KioskCommand>& kioskCommands() {
    using enum KioskCommand;
    static const std::vector<KioskCommand> all{
        Up,   Down, First, Last, Left,   Right,  Enter,     Back,       Repeat, WhereAmI, AroundMe, Next,
        List, Scan, Find,  Mute, Faster, Slower, Verbosity, Directions, Units,  Language, Switches, Help};
    return all;
}

} // namespace farol::ui
