// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/speech/espeak_engine/espeak_engine.h"

#include "ui/speech/espeak_engine/wav.h"

#include <QAudioDevice>
#include <QCoreApplication>
#include <QDir>
#include <QMediaDevices>

#include <algorithm>
#include <atomic>

namespace farol::espeak {

namespace {

/// What a device still holds when the sink has read all is cut off by stop(): let that be silence.
constexpr int kTailMs = 250;

QString said(const char* text) {
    return QCoreApplication::translate("farol::espeak", text);
}

void scale(Sound& sound, double volume) {
    auto* samples = reinterpret_cast<qint16*>(sound.samples.data());
    for (qsizetype i = 0; i < sound.samples.size() / 2; ++i) {
        samples[i] = static_cast<qint16>(static_cast<double>(samples[i]) * volume);
    }
}

} // namespace

EspeakEngine::EspeakEngine(const QVariantMap& parameters, QObject* parent) : QTextToSpeechEngine(parent) {
    m_wavFolder =
        parameters.value(QStringLiteral("wav"), qEnvironmentVariable("FAROL_SPEECH_WAV")).toString();
    if (voices().isEmpty()) {
        m_state = QTextToSpeech::Error;
        m_errorReason = QTextToSpeech::ErrorReason::Initialization;
        m_errorString = said(
            QT_TRANSLATE_NOOP("farol::espeak", "The data of the voice are missing: install espeak-ng-data."));
        return;
    }
    if (!setLocale(QLocale())) setLocale(QLocale(QLocale::English, QLocale::UnitedKingdom));
}

EspeakEngine::~EspeakEngine() {
    silence();
}

QList<QLocale> EspeakEngine::availableLocales() const {
    QList<QLocale> locales;
    for (const LibraryVoice& voice : voices()) {
        if (!locales.contains(voice.locale)) locales.append(voice.locale);
    }
    return locales;
}

QVoice EspeakEngine::publicVoice(const LibraryVoice& voice) {
    const QVoice::Gender gender = voice.gender == 1   ? QVoice::Male
                                  : voice.gender == 2 ? QVoice::Female
                                                      : QVoice::Unknown;
    const QVoice::Age age = voice.age == 0   ? QVoice::Other
                            : voice.age < 13 ? QVoice::Child
                            : voice.age < 20 ? QVoice::Teenager
                            : voice.age < 60 ? QVoice::Adult
                                             : QVoice::Senior;
    return createVoice(voice.name, voice.locale, gender, age, voice.identifier);
}

QList<QVoice> EspeakEngine::availableVoices() const {
    QList<QVoice> list;
    for (const LibraryVoice& voice : voices()) {
        if (voice.locale == m_locale) list.append(publicVoice(voice));
    }
    return list;
}

bool EspeakEngine::setLocale(const QLocale& locale) {
    auto matches = [&](bool territoryToo) {
        return std::find_if(voices().begin(), voices().end(), [&](const LibraryVoice& voice) {
            return voice.locale.language() == locale.language() &&
                   (!territoryToo || voice.locale.territory() == locale.territory());
        });
    };
    auto found = matches(true);
    if (found == voices().end()) found = matches(false);
    if (found == voices().end()) return false;
    m_voice = *found;
    m_locale = found->locale;
    m_manner.voice = found->identifier;
    return true;
}

QVoice EspeakEngine::voice() const {
    return publicVoice(m_voice);
}

bool EspeakEngine::setVoice(const QVoice& voice) {
    const QByteArray identifier = voiceData(voice).toByteArray();
    auto found = std::find_if(voices().begin(), voices().end(),
                              [&](const LibraryVoice& known) { return known.identifier == identifier; });
    if (found == voices().end()) return false;
    m_voice = *found;
    m_locale = found->locale;
    m_manner.voice = identifier;
    return true;
}

bool EspeakEngine::setRate(double rate) {
    m_manner.rate = std::clamp(rate, -1.0, 1.0);
    return true;
}

bool EspeakEngine::setPitch(double pitch) {
    m_manner.pitch = std::clamp(pitch, -1.0, 1.0);
    return true;
}

bool EspeakEngine::setVolume(double volume) {
    m_volume = std::clamp(volume, 0.0, 1.0);
    if (m_sink) m_sink->setVolume(m_volume);
    return true;
}

void EspeakEngine::say(const QString& text) {
    silence();
    QString why;
    std::optional<Sound> sound = synthesise(text, m_manner, &why);
    if (!sound) {
        fail(QTextToSpeech::ErrorReason::Input, why);
        return;
    }
    m_errorReason = QTextToSpeech::ErrorReason::NoError;
    m_errorString.clear();
    if (m_wavFolder.isEmpty())
        play(*sound);
    else
        saveWav(std::move(*sound));
}

void EspeakEngine::play(const Sound& sound) {
    const QAudioDevice device = QMediaDevices::defaultAudioOutput();
    if (device.isNull()) {
        fail(QTextToSpeech::ErrorReason::Playback,
             said(QT_TRANSLATE_NOOP("farol::espeak", "There is no sound device.")));
        return;
    }
    QAudioFormat format;
    format.setSampleRate(sound.sampleRate);
    format.setChannelCount(1);
    format.setSampleFormat(QAudioFormat::Int16);
    if (!device.isFormatSupported(format)) {
        fail(QTextToSpeech::ErrorReason::Playback,
             said(QT_TRANSLATE_NOOP("farol::espeak",
                                    "The sound device cannot play speech: choose another one.")));
        return;
    }
    m_buffer.setData(sound.samples +
                     QByteArray(static_cast<qsizetype>(format.bytesForDuration(kTailMs * 1000)), '\0'));
    m_buffer.open(QIODevice::ReadOnly);
    m_sink = std::make_unique<QAudioSink>(device, format);
    m_sink->setVolume(m_volume);
    connect(m_sink.get(), &QAudioSink::stateChanged, this, &EspeakEngine::sinkChanged);
    m_sink->start(&m_buffer);
    if (m_sink && m_sink->error() == QAudio::NoError)
        setState(QTextToSpeech::Speaking);
    else if (m_state != QTextToSpeech::Error) {
        fail(QTextToSpeech::ErrorReason::Playback,
             said(QT_TRANSLATE_NOOP("farol::espeak", "The sound device does not start.")));
    }
}

void EspeakEngine::saveWav(Sound sound) {
    scale(sound, m_volume);
    QDir().mkpath(m_wavFolder);
    static std::atomic<int> written = 0; // engines of one process share the folder
    m_wavCount = ++written;
    const QString name = QStringLiteral("utterance-%1.wav").arg(m_wavCount, 4, 10, QLatin1Char('0'));
    const QString why = writeWav(QDir(m_wavFolder).filePath(name), sound);
    if (!why.isEmpty()) {
        fail(QTextToSpeech::ErrorReason::Playback, why);
        return;
    }
    setState(QTextToSpeech::Speaking);
    // Not from within say(), as with a device.
    QMetaObject::invokeMethod(
        this,
        [this, count = m_wavCount] {
            if (count == m_wavCount && m_state == QTextToSpeech::Speaking) setState(QTextToSpeech::Ready);
        },
        Qt::QueuedConnection);
}

void EspeakEngine::sinkChanged(QAudio::State state) {
    if (!m_sink) return;
    const bool ended = state == QAudio::IdleState && m_buffer.atEnd();
    const bool broken = state == QAudio::StoppedState && m_sink->error() != QAudio::NoError;
    if (!ended && !broken) return;
    // The sink is still in its own signal: it may not be deleted here.
    QMetaObject::invokeMethod(
        this,
        [this, broken, sink = m_sink.get()] {
            if (sink != m_sink.get()) return; // another text since
            silence();
            if (broken) {
                fail(QTextToSpeech::ErrorReason::Playback,
                     said(QT_TRANSLATE_NOOP("farol::espeak",
                                            "The sound device stopped in the middle of a text.")));
            } else {
                setState(QTextToSpeech::Ready);
            }
        },
        Qt::QueuedConnection);
}

void EspeakEngine::silence() {
    if (m_sink) {
        m_sink->disconnect(this);
        m_sink->reset();
        m_sink->stop();
        m_sink.reset();
    }
    m_buffer.close();
}

void EspeakEngine::stop(QTextToSpeech::BoundaryHint /*boundaryHint*/) {
    silence();
    if (m_state != QTextToSpeech::Error) setState(QTextToSpeech::Ready);
}

void EspeakEngine::pause(QTextToSpeech::BoundaryHint /*boundaryHint*/) {
    if (m_state != QTextToSpeech::Speaking || !m_sink) return;
    m_sink->suspend();
    setState(QTextToSpeech::Paused);
}

void EspeakEngine::resume() {
    if (m_state != QTextToSpeech::Paused || !m_sink) return;
    m_sink->resume();
    setState(QTextToSpeech::Speaking);
}

void EspeakEngine::setState(QTextToSpeech::State state) {
    if (state == m_state) return;
    m_state = state;
    Q_EMIT stateChanged(state);
}

void EspeakEngine::fail(QTextToSpeech::ErrorReason reason, const QString& message) {
    silence();
    m_errorReason = reason;
    m_errorString = message;
    setState(QTextToSpeech::Error);
    Q_EMIT errorOccurred(reason, message);
}

} // namespace farol::espeak
