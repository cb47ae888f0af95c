// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// libespeak-ng, which has one state for the whole process: every call goes through here, one at a time.

#include <QByteArray>
#include <QList>
#include <QLocale>
#include <QString>

#include <optional>

namespace farol::espeak {

struct LibraryVoice {
    QByteArray identifier; ///< what the library is asked for
    QString name;          ///< for people: "Portuguese (Portugal)"
    QByteArray language;   ///< "pt", "en-gb", "en-gb-scotland"
    QLocale locale;
    int gender = 0; ///< 0 not told, 1 male, 2 female
    int age = 0;    ///< years, 0 not told
};

struct Manner {
    QByteArray voice;
    double rate = 0.0;  ///< -1 to 1
    double pitch = 0.0; ///< -1 to 1
};

struct Sound {
    QByteArray samples; ///< signed 16 bit, one channel
    int sampleRate = 0;
};

/// Starts the library where it has not been; the sample rate, or 0 when its data are missing.
int start();
/// In the library's order of preference for each locale. Empty when the library cannot start.
const QList<LibraryVoice>& voices();
/// Empty when the library refuses; `why` then says so.
std::optional<Sound> synthesise(const QString& text, const Manner& manner, QString* why);

} // namespace farol::espeak
