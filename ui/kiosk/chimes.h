#pragma once
// The two sounds of the kiosk.

#include <QByteArray>
#include <QObject>

#include <memory>

namespace farol::ui {

enum class Sound { Fix, Warning };

class Chimes : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;
    virtual void play(Sound sound) = 0; ///< at once, beside the voice
};

/// Two short tones up for a fix, two down for a warning, 16 bit mono at 48 kHz.
QByteArray chimeSamples(Sound sound);
/// Plays in a thread of its own; without a sound device it is silent: words tell the same.
std::unique_ptr<Chimes> makeChimes();

} // namespace farol::ui
