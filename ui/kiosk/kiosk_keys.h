#pragma once
// What a key of the kiosk means: one small keyboard, and the same on a number pad.

#include <QString>

#include <vector>

namespace farol::ui {

enum class KioskCommand {
    None, ///< a key without a meaning
    Up,
    Down,
    First,
    Last,
    Left,
    Right,
    Enter,
    Back,
    Repeat,
    WhereAmI,
    AroundMe,
    Next,
    List,
    Scan,
    Mute,
    Faster,
    Slower,
    Verbosity,
    Directions,
    Units,
    Find,
    Help,
    Language,
    Switches
};

struct KioskKey {
    int key = 0;         ///< Qt::Key
    QString text;        ///< what it types
    bool keypad = false; ///< on the number pad
};

KioskCommand commandOf(const KioskKey& key);
/// Shift, Ctrl and the like do nothing by themselves.
bool isModifier(int key);
/// A letter, a digit, a space: something that can stand in the name of a place.
bool isTyped(const KioskKey& key);
/// Does a key that is held down go on by itself?
bool repeats(KioskCommand command);
/// All that have a key, in the order in which help tells them.
const std::vector<KioskCommand>& kioskCommands();

} // namespace farol::ui
