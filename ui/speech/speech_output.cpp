#include "ui/speech/speech_output.h"

#include "ui/speech/phrasebook.h"
#include "ui/speech/voice.h"

#include <QCoreApplication>
#include <QThread>
#include <QTimer>

#include <algorithm>
#include <utility>

namespace farol::ui {

namespace {

/// Engines take this long to start at the very most (speech-dispatcher: 6 s measured).
constexpr int kStartMs = 10000;
/// A normal voice takes 0.07 s for a letter; twice that is stuck.
constexpr int kMsPerLetter = 150;
constexpr int kSpareMs = 4000;
/// A program that ends does not wait longer for a voice that hangs.
constexpr unsigned long kFarewellMs = 2000;

/// Voices that are not wanted any more end their threads by themselves: an engine can take half a second to
/// let go of a sound device, and the next voice must not wait for it. Only the end of the program does.
QList<QThread*>& retiring() {
    static QList<QThread*> threads;
    return threads;
}

void waitForRetiring() {
    for (QThread* thread : std::exchange(retiring(), {})) {
        // A thread that hangs in an engine cannot be ended: it is left behind rather than the window.
        if (thread->wait(kFarewellMs)) delete thread;
    }
}

void retire(QThread* thread) {
    static const bool registered = [] {
        qAddPostRoutine(waitForRetiring);
        return true;
    }();
    Q_UNUSED(registered);
    QList<QThread*>& threads = retiring();
    threads.removeIf([](QThread* old) {
        const bool over = old->isFinished();
        if (over) delete old;
        return over;
    });
    thread->quit();
    threads << thread;
}

class QtSpeechOutput : public SpeechOutput {
public:
    QtSpeechOutput(VoiceChoice choice, QObject* parent) : SpeechOutput(parent), m_choice(std::move(choice)) {
        if (m_choice.language.isEmpty()) m_choice.language = installedLanguage();
        m_watchdog.setSingleShot(true);
        connect(&m_watchdog, &QTimer::timeout, this, &QtSpeechOutput::stuck);
    }

    ~QtSpeechOutput() override {
        if (!m_thread) return;
        m_voice->disconnect(this);
        // Silent at once, even while the thread takes its time to end.
        QMetaObject::invokeMethod(m_voice, [voice = m_voice] { voice->stop(); });
        retire(m_thread);
    }

    void say(const QString& text) override {
        startThread();
        m_speaking = true;
        const int serial = ++m_serial;
        m_watchdog.start(patienceMs(text));
        QMetaObject::invokeMethod(m_voice, [voice = m_voice, serial, text] { voice->say(serial, text); });
    }

    void stop() override {
        ++m_serial;
        m_speaking = false;
        m_watchdog.stop();
        if (m_voice) QMetaObject::invokeMethod(m_voice, [voice = m_voice] { voice->stop(); });
    }

    bool speaking() const override { return m_speaking; }

    QString description() const override {
        return m_description.isEmpty() ? SpeechOutput::tr("The voice starts with the first sentence.")
                                       : m_description;
    }

private:
    void startThread() {
        if (m_thread) return;
        addSpeechPlugins();
        m_thread = new QThread;
        m_thread->setObjectName(QStringLiteral("speech"));
        m_voice = new Voice(m_choice);
        m_voice->moveToThread(m_thread);
        connect(m_thread, &QThread::finished, m_voice, &QObject::deleteLater);
        connect(m_voice, &Voice::ready, this,
                [this](const QString& description) { m_description = description; });
        connect(m_voice, &Voice::finished, this, [this](int serial) {
            if (!ended(serial)) return;
            Q_EMIT finished();
        });
        connect(m_voice, &Voice::failed, this, [this](int serial, const QString& message) {
            if (!ended(serial)) return;
            Q_EMIT failed(message);
        });
        m_thread->start();
    }

    /// Reports of texts that were stopped or replaced do not count.
    bool ended(int serial) {
        if (serial != m_serial || !m_speaking) return false;
        m_speaking = false;
        m_watchdog.stop();
        return true;
    }

    int patienceMs(const QString& text) const {
        if (m_choice.patienceMs > 0) return m_choice.patienceMs;
        const int perLetter = m_choice.rate < 0.0 ? 2 * kMsPerLetter : kMsPerLetter;
        return kSpareMs + static_cast<int>(text.size()) * perLetter +
               (m_description.isEmpty() ? kStartMs : 0);
    }

    void stuck() {
        stop();
        Q_EMIT failed(
            SpeechOutput::tr("The voice hangs: nothing may be heard. Choose another one in the settings."));
    }

    VoiceChoice m_choice;
    QThread* m_thread = nullptr;
    Voice* m_voice = nullptr; ///< lives in m_thread
    QTimer m_watchdog;
    QString m_description;
    int m_serial = 0;
    bool m_speaking = false;
};

} // namespace

std::unique_ptr<SpeechOutput> makeSpeechOutput(const VoiceChoice& choice, QObject* parent) {
    return std::make_unique<QtSpeechOutput>(choice, parent);
}

QStringList speechEngines() {
    addSpeechPlugins();
    QStringList engines = QTextToSpeech::availableEngines();
    // flite last: in Qt 6.4 it swallows ordinary sentences, and it knows English only.
    auto rank = [](const QString& name) {
        return name == QLatin1String("farol") ? 0 : name == QLatin1String("flite") ? 2 : 1;
    };
    std::sort(engines.begin(), engines.end(), [&](const QString& a, const QString& b) {
        return rank(a) != rank(b) ? rank(a) < rank(b) : a < b;
    });
    return engines;
}

QStringList speechVoices(const VoiceChoice& choice) {
    const QStringList engines = speechEngines();
    const QString name = choice.engine.isEmpty() ? engines.value(0) : choice.engine;
    if (!engines.contains(name)) return {};
    QTextToSpeech engine(name);
    engine.setLocale(speechLocale(choice.language.isEmpty() ? installedLanguage() : choice.language));
    QStringList names;
    for (const QVoice& voice : engine.availableVoices()) names << voice.name();
    return names;
}

} // namespace farol::ui
