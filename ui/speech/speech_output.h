#pragma once
// A voice. An interface, so that the queue is tested with a recording one and a machine without sound still works.

#include <QLocale>
#include <QObject>
#include <QString>
#include <QStringList>

#include <memory>

namespace farol::ui {

struct VoiceChoice {
    QString engine;       ///< empty: the first that works (Farol's own, then what Qt finds)
    QString voice;        ///< empty: the engine's choice for the language
    QString language;     ///< "en", "pt", "pt_BR"; empty: the program's language
    double rate = 0.0;    ///< -1 slow to 1 fast
    double volume = 1.0;  ///< 0 to 1
};

class SpeechOutput : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    virtual void say(const QString& text) = 0; ///< interrupts what is being said
    virtual void stop() = 0;
    virtual bool speaking() const = 0;
    virtual QString description() const = 0; ///< engine and voice, for people

Q_SIGNALS:
    void finished();                     ///< the text was spoken to its end, or stopped
    void failed(const QString& message); ///< no sound came out; the message says why and what to do
};

/// The voice over QTextToSpeech. Never null: without an engine or audio device it reports failed() for each text.
/// A watchdog tells when an engine speaks for longer than the text could take. GUI thread.
std::unique_ptr<SpeechOutput> makeSpeechOutput(const VoiceChoice& choice, QObject* parent = nullptr);
QStringList speechEngines();
QStringList speechVoices(const VoiceChoice& choice);

} // namespace farol::ui
