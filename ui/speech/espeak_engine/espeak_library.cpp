// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/speech/espeak_engine/espeak_library.h"

#include <QCoreApplication>
#include <QMutex>

#include <algorithm>
#include <espeak-ng/speak_lib.h>

namespace farol::espeak {

namespace {

QMutex& libraryMutex() {
    static QMutex mutex;
    return mutex;
}

QByteArray* g_samples = nullptr; ///< of the synthesis that runs; guarded by libraryMutex()

int collect(short* wave, int count, espeak_EVENT* /*events*/) {
    if (wave != nullptr && count > 0 && g_samples != nullptr) {
        g_samples->append(reinterpret_cast<const char*>(wave), static_cast<qsizetype>(count) * 2);
    }
    return 0;
}

/// Caller holds the mutex.
int startLocked() {
    static const int rate = [] {
        const int found = espeak_Initialize(AUDIO_OUTPUT_SYNCHRONOUS, 0, nullptr, espeakINITIALIZE_DONT_EXIT);
        if (found <= 0) return 0;
        espeak_SetSynthCallback(collect);
        return found;
    }();
    return rate;
}

QLocale localeOf(const QByteArray& language) {
    // Plain "pt" means Portugal to espeak-ng and Brazil to Qt.
    if (language == "pt") return QLocale(QLocale::Portuguese, QLocale::Portugal);
    QString name = QString::fromLatin1(language);
    name.replace(QLatin1Char('-'), QLatin1Char('_'));
    QLocale locale(name);
    if (locale.language() == QLocale::C) locale = QLocale(name.section(QLatin1Char('_'), 0, 1));
    return locale.language() == QLocale::C ? QLocale(name.section(QLatin1Char('_'), 0, 0)) : locale;
}

QList<LibraryVoice> listVoices() {
    QList<LibraryVoice> list;
    if (startLocked() == 0) return list;
    for (const espeak_VOICE** voice = espeak_ListVoices(nullptr); voice != nullptr && *voice != nullptr;
         ++voice) {
        // languages: pairs of a priority byte and a zero-terminated tag; the first is the voice's own.
        const QByteArray language =
            (*voice)->languages != nullptr ? QByteArray((*voice)->languages + 1) : QByteArray();
        const QLocale locale = localeOf(language);
        if (language.isEmpty() || locale.language() == QLocale::C) continue;
        list.append({QByteArray((*voice)->identifier), QString::fromUtf8((*voice)->name), language, locale,
                     (*voice)->gender, (*voice)->age});
    }
    // The plain variety of a language stands before its dialects ("en-gb" before "en-gb-scotland").
    std::stable_sort(list.begin(), list.end(), [](const LibraryVoice& a, const LibraryVoice& b) {
        return a.language.size() != b.language.size() ? a.language.size() < b.language.size()
                                                      : a.language < b.language;
    });
    return list;
}

} // namespace

int start() {
    const QMutexLocker lock(&libraryMutex());
    return startLocked();
}

const QList<LibraryVoice>& voices() {
    const QMutexLocker lock(&libraryMutex());
    static const QList<LibraryVoice> list = listVoices();
    return list;
}

std::optional<Sound> synthesise(const QString& text, const Manner& manner, QString* why) {
    const QMutexLocker lock(&libraryMutex());
    Sound sound;
    sound.sampleRate = startLocked();
    if (sound.sampleRate == 0) {
        *why = QCoreApplication::translate("farol::espeak",
                                           "The data of the voice are missing: install espeak-ng-data.");
        return std::nullopt;
    }
    if (espeak_SetVoiceByName(manner.voice.constData()) != EE_OK) {
        *why =
            QCoreApplication::translate("farol::espeak", "The voice cannot be loaded: choose another one.");
        return std::nullopt;
    }
    const double rate = std::clamp(manner.rate, -1.0, 1.0);
    const double words = rate < 0.0 ? espeakRATE_NORMAL + rate * (espeakRATE_NORMAL - espeakRATE_MINIMUM)
                                    : espeakRATE_NORMAL + rate * (espeakRATE_MAXIMUM - espeakRATE_NORMAL);
    espeak_SetParameter(espeakRATE, static_cast<int>(words), 0);
    espeak_SetParameter(espeakPITCH, static_cast<int>(50.0 + 50.0 * std::clamp(manner.pitch, -1.0, 1.0)), 0);
    const QByteArray bytes = text.toUtf8();
    g_samples = &sound.samples;
    const espeak_ERROR error = espeak_Synth(bytes.constData(), static_cast<std::size_t>(bytes.size()) + 1, 0,
                                            POS_CHARACTER, 0, espeakCHARS_UTF8, nullptr, nullptr);
    g_samples = nullptr;
    if (error != EE_OK) {
        *why = QCoreApplication::translate("farol::espeak", "The text could not be turned into sound.");
        return std::nullopt;
    }
    return sound;
}

} // namespace farol::espeak
