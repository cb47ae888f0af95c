#pragma once
// A voice. An interface, so that the queue is tested with a recording one and a machine without sound still
// works.

#include <QLocale>
#include <QObject>
#include <QString>
#include <QStringList>

#include <memory>

namespace farol::ui {

struct VoiceChoice {
    QString engine;      ///< empty: the first that works (Farol's own, then what Qt finds)
    QString voice;       ///< empty: the engine's choice for the language
    QString language;    ///< "en", "pt", "pt_BR"; empty: the program's language
    double rate = 0.0;   ///< -1 slow to 1 fast
    double volume = 1.0; ///< 0 to 1
    int patienceMs = 0;  ///< how long one text may take before it counts as stuck; 0: by its length
};

class SpeechOutput : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    virtual void say(const QString& text) = 0; ///< replaces what is being said
    virtual void stop() = 0;                   ///< silence; nothing is reported for the stopped text
    virtual bool speaking() const = 0;
    virtual QString description() const = 0; ///< engine and voice, for people

Q_SIGNALS:
    /// One of these for each text that is not stopped or replaced before its end.
    void finished();                     ///< the text was spoken
    void failed(const QString& message); ///< it was not heard; the message says why and what to do
};

/// The voice over QTextToSpeech, in a thread of its own: an engine that blocks while it starts does not block
/// the window. Never null: without an engine or audio device it reports failed() for each text. A watchdog
/// tells when an engine speaks for longer than the text could take.
std::unique_ptr<SpeechOutput> makeSpeechOutput(const VoiceChoice& choice, QObject* parent = nullptr);
/// Farol's own first.
QStringList speechEngines();
/// Names of the voices of an engine for a language. Starts the engine: some take seconds.
QStringList speechVoices(const VoiceChoice& choice);

} // namespace farol::ui
