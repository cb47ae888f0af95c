// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Qt's text-to-speech engine over libespeak-ng: a text is synthesised whole (some ten milliseconds) and then
// pulled by the sound device. With FAROL_SPEECH_WAV=<folder> each text becomes a WAV file there instead and
// no device is used.

#include "ui/speech/espeak_engine/espeak_library.h"

#include <QAudioSink>
#include <QBuffer>
#include <QTextToSpeechEngine>

#include <memory>

namespace farol::espeak {

class EspeakEngine : public QTextToSpeechEngine {
    Q_OBJECT

public:
    EspeakEngine(const QVariantMap& parameters, QObject* parent);
    ~EspeakEngine() override;

    QList<QLocale> availableLocales() const override;
    QList<QVoice> availableVoices() const override;
    void say(const QString& text) override;
    void stop(QTextToSpeech::BoundaryHint boundaryHint) override;
    void pause(QTextToSpeech::BoundaryHint boundaryHint) override;
    void resume() override;
    double rate() const override { return m_manner.rate; }
    bool setRate(double rate) override;
    double pitch() const override { return m_manner.pitch; }
    bool setPitch(double pitch) override;
    QLocale locale() const override { return m_locale; }
    bool setLocale(const QLocale& locale) override;
    double volume() const override { return m_volume; }
    bool setVolume(double volume) override;
    QVoice voice() const override;
    bool setVoice(const QVoice& voice) override;
    QTextToSpeech::State state() const override { return m_state; }
    QTextToSpeech::ErrorReason errorReason() const override { return m_errorReason; }
    QString errorString() const override { return m_errorString; }

private:
    static QVoice publicVoice(const LibraryVoice& voice);
    void play(const Sound& sound);
    void saveWav(Sound sound);
    void silence();
    void sinkChanged(QAudio::State state);
    void setState(QTextToSpeech::State state);
    void fail(QTextToSpeech::ErrorReason reason, const QString& message);

    Manner m_manner;
    LibraryVoice m_voice;
    QLocale m_locale;
    double m_volume = 1.0;
    QTextToSpeech::State m_state = QTextToSpeech::Ready;
    QTextToSpeech::ErrorReason m_errorReason = QTextToSpeech::ErrorReason::NoError;
    QString m_errorString;
    QBuffer m_buffer;
    std::unique_ptr<QAudioSink> m_sink;
    QString m_wavFolder; ///< empty: to the sound device
    int m_wavCount = 0;
};

} // namespace farol::espeak
