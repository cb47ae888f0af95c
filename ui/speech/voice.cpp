#include "ui/speech/voice.h"

#include "ui/speech/pronounced.h"

#include <QAudioDevice>
#include <QCoreApplication>
#include <QDir>
#include <QMediaDevices>

#include <algorithm>

namespace farol::ui {

namespace {

/// Farol's own engine then writes files and needs no device.
bool writesFiles() {
    return !qEnvironmentVariableIsEmpty("FAROL_SPEECH_WAV");
}

} // namespace

void addSpeechPlugins() {
    const QDir program(QCoreApplication::applicationDirPath());
    for (const char* folder : {"plugins", "../lib/farol/plugins"}) {
        const QString path = QDir::cleanPath(program.filePath(QLatin1String(folder)));
        if (QDir(path).exists()) QCoreApplication::addLibraryPath(path);
    }
}

QLocale speechLocale(const QString& language) {
    if (language == QLatin1String("pt")) return QLocale(QLocale::Portuguese, QLocale::Portugal);
    if (language == QLatin1String("en")) return QLocale(QLocale::English, QLocale::UnitedKingdom);
    return QLocale(language);
}

bool Voice::startEngine(const QString& engine, QString* why) {
    if (!QTextToSpeech::availableEngines().contains(engine)) {
        *why = tr("The voice \"%1\" is not installed. Choose another one in the settings.").arg(engine);
        return false;
    }
    auto made = std::make_unique<QTextToSpeech>(engine);
    if (made->state() == QTextToSpeech::Error) {
        *why = tr("The voice \"%1\" does not start: %2").arg(engine, made->errorString());
        return false;
    }
    const QLocale locale = speechLocale(m_choice.language);
    const QList<QLocale> known = made->availableLocales();
    const bool speaksIt = std::any_of(
        known.begin(), known.end(), [&](const QLocale& one) { return one.language() == locale.language(); });
    if (!speaksIt) {
        *why = tr("The voice \"%1\" does not speak this language. Choose another one in the settings.")
                   .arg(engine);
        return false;
    }
    made->setLocale(locale);
    const QList<QVoice> voices = made->availableVoices();
    auto chosen = std::find_if(voices.begin(), voices.end(),
                               [&](const QVoice& voice) { return voice.name() == m_choice.voice; });
    if (chosen != voices.end()) made->setVoice(*chosen);
    made->setRate(m_choice.rate);
    made->setVolume(m_choice.volume);
    m_engine = std::move(made);
    return true;
}

bool Voice::start(QString* why) {
    if (m_engine) return true;
    const QStringList engines = m_choice.engine.isEmpty() ? speechEngines() : QStringList{m_choice.engine};
    *why = tr("No voice is installed.");
    for (const QString& engine : engines) {
        if (startEngine(engine, why)) break;
    }
    if (!m_engine) return false;
    connect(m_engine.get(), &QTextToSpeech::stateChanged, this, &Voice::stateChanged);
    connect(m_engine.get(), &QTextToSpeech::errorOccurred, this,
            [this](QTextToSpeech::ErrorReason, const QString& message) { fail(message); });
    return true;
}

void Voice::say(int serial, const QString& text) {
    stop();
    m_serial = serial;
    m_begun = false;
    QString why;
    if (!start(&why)) {
        fail(why);
        return;
    }
    Q_EMIT ready(m_engine->engine() + QStringLiteral(", ") + m_engine->voice().name());
    // Some engines speak for ever where there is nothing to sound from.
    if (!writesFiles() && QMediaDevices::audioOutputs().isEmpty()) {
        fail(tr("There is no sound device. Connect headphones or a loudspeaker."));
        return;
    }
    m_engine->say(spoken::pronounced(text, m_choice.language));
    if (m_serial == serial && m_endsToIgnore == 0 && m_engine->state() == QTextToSpeech::Speaking)
        m_begun = true;
}

void Voice::stop() {
    const bool speaking = m_serial != 0;
    m_serial = 0;
    if (!m_engine || !speaking) return;
    m_engine->stop(QTextToSpeech::BoundaryHint::Immediate);
    if (m_engine->state() == QTextToSpeech::Speaking) ++m_endsToIgnore;
}

void Voice::stateChanged(QTextToSpeech::State state) {
    if (state == QTextToSpeech::Speaking) {
        m_endsToIgnore = 0; // engines that skip the report of a replaced text
        m_begun = true;
        return;
    }
    if (state == QTextToSpeech::Error) {
        fail(m_engine->errorString());
        return;
    }
    if (state != QTextToSpeech::Ready) return;
    if (m_endsToIgnore > 0) {
        --m_endsToIgnore;
        return;
    }
    if (m_serial == 0 || !m_begun) return;
    const int ended = m_serial;
    m_serial = 0;
    Q_EMIT finished(ended);
}

void Voice::fail(const QString& message) {
    if (m_serial == 0) return; // told already, or nobody waits for it
    const int ended = m_serial;
    m_serial = 0;
    Q_EMIT failed(ended, message.isEmpty()
                             ? tr("The voice does not work. Choose another one in the settings.")
                             : message);
}

} // namespace farol::ui
