#pragma once
// The part of the speech output that lives in the speech thread: it starts the engine and speaks.

#include "ui/speech/speech_output.h"

#include <QTextToSpeech>

#include <memory>

namespace farol::ui {

/// Makes Farol's own engine known to Qt: plugins beside the program, or where it was installed.
void addSpeechPlugins();
/// The locale whose voice speaks a language of ours: "pt" is Portugal's, "en" Britain's.
QLocale speechLocale(const QString& language);

class Voice : public QObject {
    Q_OBJECT

public:
    explicit Voice(VoiceChoice choice) : m_choice(std::move(choice)) {}

    void say(int serial, const QString& text);
    void stop();

Q_SIGNALS:
    void ready(const QString& description); ///< the engine has started
    void finished(int serial);
    void failed(int serial, const QString& message);

private:
    bool start(QString* why);
    bool startEngine(const QString& engine, QString* why);
    void stateChanged(QTextToSpeech::State state);
    void fail(const QString& message);

    VoiceChoice m_choice;
    std::unique_ptr<QTextToSpeech> m_engine;
    int m_serial = 0;       ///< of the text being spoken; 0: none
    bool m_begun = false;   ///< the engine has said that it speaks this text
    int m_endsToIgnore = 0; ///< ends of stopped texts that an engine still has to report
};

} // namespace farol::ui
