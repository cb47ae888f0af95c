#pragma once
// A voice that misbehaves as real ones do: it never ends, or it reports an error and then that it is ready.

#include <QTextToSpeechEngine>
#include <QTextToSpeechPlugin>

namespace farol::test {

class StuckEngine : public QTextToSpeechEngine {
    Q_OBJECT

public:
    using QTextToSpeechEngine::QTextToSpeechEngine;

    QList<QLocale> availableLocales() const override {
        return {QLocale(QLocale::English, QLocale::UnitedKingdom)};
    }
    QList<QVoice> availableVoices() const override { return {}; }
    void say(const QString& text) override {
        set(QTextToSpeech::Speaking);
        if (text != QLatin1String("break")) return;
        set(QTextToSpeech::Error);
        Q_EMIT errorOccurred(QTextToSpeech::ErrorReason::Playback, errorString());
        set(QTextToSpeech::Ready);
    }
    void stop(QTextToSpeech::BoundaryHint) override { set(QTextToSpeech::Ready); }
    void pause(QTextToSpeech::BoundaryHint) override {}
    void resume() override {}
    double rate() const override { return 0.0; }
    bool setRate(double) override { return false; }
    double pitch() const override { return 0.0; }
    bool setPitch(double) override { return false; }
    QLocale locale() const override { return availableLocales().first(); }
    bool setLocale(const QLocale&) override { return true; }
    double volume() const override { return 1.0; }
    bool setVolume(double) override { return false; }
    QVoice voice() const override { return {}; }
    bool setVoice(const QVoice&) override { return false; }
    QTextToSpeech::State state() const override { return m_state; }
    QTextToSpeech::ErrorReason errorReason() const override { return QTextToSpeech::ErrorReason::Playback; }
    QString errorString() const override { return QStringLiteral("broken on purpose"); }

private:
    void set(QTextToSpeech::State state) {
        m_state = state;
        Q_EMIT stateChanged(state);
    }
    QTextToSpeech::State m_state = QTextToSpeech::Ready;
};

} // namespace farol::test

class StuckPlugin : public QObject, public QTextToSpeechPlugin {
    Q_OBJECT
    Q_INTERFACES(QTextToSpeechPlugin)
    Q_PLUGIN_METADATA(IID "org.qt-project.qt.speech.tts.plugin/6.0" FILE "stuck_engine.json")

public:
    QTextToSpeechEngine* createTextToSpeechEngine(const QVariantMap&, QObject* parent,
                                                  QString*) const override {
        return new farol::test::StuckEngine(parent);
    }
};
