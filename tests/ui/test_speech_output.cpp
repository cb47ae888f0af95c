// Farol's own voice as sound (written to files, so that no device is needed), and what is told when a voice
// fails.

#include "tests/ui/stuck_engine.h"
#include "ui/speech/phrasebook.h"
#include "ui/speech/speech_output.h"

#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>
#include <QtPlugin>

#include <cmath>

Q_IMPORT_PLUGIN(StuckPlugin)

using farol::ui::makeSpeechOutput;
using farol::ui::SpeechOutput;
using farol::ui::VoiceChoice;

namespace {

constexpr int kPatienceMs = 60000;

struct Wav {
    double seconds = 0.0;
    double loudness = 0.0; ///< root mean square of the samples
    int peak = 0;
    QString voice;
};

Wav readWav(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) return {};
    const QByteArray all = file.readAll();
    if (all.size() < 44 || !all.startsWith("RIFF") || all.mid(8, 4) != "WAVE") return {};
    const auto rate = qFromLittleEndian<quint32>(all.constData() + 24);
    Wav wav;
    const QByteArray samples = all.mid(44);
    const qsizetype count = samples.size() / 2;
    double sum = 0.0;
    for (qsizetype i = 0; i < count; ++i) {
        const int sample = qFromLittleEndian<qint16>(samples.constData() + 2 * i);
        sum += static_cast<double>(sample) * sample;
        wav.peak = std::max(wav.peak, std::abs(sample));
    }
    wav.seconds = static_cast<double>(count) / rate;
    wav.loudness = count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count));
    return wav;
}

VoiceChoice own(const QString& language, double rate = 0.0, double volume = 1.0) {
    VoiceChoice choice;
    choice.engine = QStringLiteral("farol");
    choice.language = language;
    choice.rate = rate;
    choice.volume = volume;
    return choice;
}

} // namespace

class TestSpeechOutput : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void ownEngineComesFirst();
    void speaksEnglishAndPortuguese();
    void speaksSpanishFrenchAndGerman();
    void everyWordIsSounded();
    void rateAndVolumeAreHeard();
    void voiceIsChosenByName();
    void replacedTextReportsNothing();
    void stoppedTextReportsNothing();
    void missingDeviceIsToldForEachText();
    void unwritableFolderIsTold();
    void unknownEngineIsTold();
    void wrongLanguageIsNotSpoken();
    void hangingVoiceIsTold();
    void brokenVoiceIsToldOnce();

private:
    /// Speaks and returns the sound; empty when it failed.
    Wav spoken(const VoiceChoice& choice, const QString& text);
    QString failure(const VoiceChoice& choice, const QString& text);
    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestSpeechOutput::initTestCase() {
    QCoreApplication::addLibraryPath(QStringLiteral(FAROL_PLUGIN_FOLDER));
    QVERIFY(farol::ui::installTranslation(QStringLiteral("en")));
}

void TestSpeechOutput::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(m_folder->isValid());
    qputenv("FAROL_SPEECH_WAV", m_folder->path().toUtf8());
}

Wav TestSpeechOutput::spoken(const VoiceChoice& choice, const QString& text) {
    const QStringList before = QDir(m_folder->path()).entryList({QStringLiteral("*.wav")});
    auto output = makeSpeechOutput(choice);
    QSignalSpy finished(output.get(), &SpeechOutput::finished);
    QSignalSpy failed(output.get(), &SpeechOutput::failed);
    output->say(text);
    if (!finished.wait(kPatienceMs) || !failed.isEmpty()) return {};
    for (const QString& name : QDir(m_folder->path()).entryList({QStringLiteral("*.wav")})) {
        if (before.contains(name)) continue;
        Wav wav = readWav(m_folder->filePath(name));
        wav.voice = output->description();
        return wav;
    }
    return {};
}

QString TestSpeechOutput::failure(const VoiceChoice& choice, const QString& text) {
    auto output = makeSpeechOutput(choice);
    QSignalSpy finished(output.get(), &SpeechOutput::finished);
    QSignalSpy failed(output.get(), &SpeechOutput::failed);
    output->say(text);
    if (!output->speaking() || !failed.wait(kPatienceMs) || !finished.isEmpty() || output->speaking())
        return {};
    return failed[0][0].toString();
}

void TestSpeechOutput::ownEngineComesFirst() {
    QCOMPARE(farol::ui::speechEngines().value(0), QStringLiteral("farol"));
    VoiceChoice any;
    auto output = makeSpeechOutput(any);
    QSignalSpy finished(output.get(), &SpeechOutput::finished);
    output->say(QStringLiteral("Stop."));
    QVERIFY(finished.wait(kPatienceMs));
    QVERIFY2(output->description().startsWith(QStringLiteral("farol, English (Great Britain)")),
             qUtf8Printable(output->description()));
}

void TestSpeechOutput::speaksEnglishAndPortuguese() {
    const Wav english = spoken(own(QStringLiteral("en")),
                               QStringLiteral("Go through the door, turning left. Next: Corridor B."));
    QVERIFY2(english.seconds > 2.0 && english.seconds < 6.0, qPrintable(QString::number(english.seconds)));
    QVERIFY(english.loudness > 500.0);
    const QString text = QStringLiteral("Passe a porta, virando à esquerda. A seguir: Corredor B.");
    const Wav portuguese = spoken(own(QStringLiteral("pt")), text);
    QVERIFY2(portuguese.seconds > 2.0 && portuguese.seconds < 6.0,
             qPrintable(QString::number(portuguese.seconds)));
    QVERIFY(portuguese.loudness > 500.0);
    QCOMPARE(english.voice, QStringLiteral("farol, English (Great Britain)"));
    QCOMPARE(portuguese.voice, QStringLiteral("farol, Portuguese (Portugal)"));
    const Wav brazilian = spoken(own(QStringLiteral("pt_BR")), text);
    QCOMPARE(brazilian.voice, QStringLiteral("farol, Portuguese (Brazil)"));
    QVERIFY(brazilian.loudness > 500.0);
    // Letters read by the wrong language's rules take another time: the voice is not a name only.
    const Wav misread = spoken(own(QStringLiteral("en")), text);
    QVERIFY(std::abs(misread.seconds - portuguese.seconds) > 0.1);
}

void TestSpeechOutput::speaksSpanishFrenchAndGerman() {
    struct Said {
        const char *language, *voice, *text;
    };
    for (const Said& said :
         {Said{"es", "Spanish", "A unos 6 metros, cruce la tercera puerta a su izquierda."},
          Said{"fr", "French", "Dans environ 6 mètres, passez par la troisième porte à votre gauche."},
          Said{"de", "German", "In etwa 6 Metern gehen Sie durch die dritte Tür links."}}) {
        const QString text = QString::fromUtf8(said.text);
        const Wav wav = spoken(own(QString::fromLatin1(said.language)), text);
        QVERIFY2(wav.voice.contains(QLatin1String(said.voice)), qPrintable(wav.voice));
        QVERIFY2(wav.seconds > 2.0 && wav.seconds < 6.0, qPrintable(QString::number(wav.seconds)));
        QVERIFY(wav.loudness > 500.0);
        const Wav misread = spoken(own(QStringLiteral("en")), text);
        QVERIFY2(std::abs(misread.seconds - wav.seconds) > 0.05, said.language);
    }
}

/// The short orders that another engine swallows.
void TestSpeechOutput::everyWordIsSounded() {
    auto output = makeSpeechOutput(own(QStringLiteral("en")));
    QSignalSpy finished(output.get(), &SpeechOutput::finished);
    const QStringList texts{QStringLiteral("Turn left."), QStringLiteral("Stop."),
                            QStringLiteral("Exit sign, 12 o'clock, up."),
                            QStringLiteral("Fire extinguisher, 9 o'clock, down.")};
    for (const QString& text : texts) {
        output->say(text);
        QVERIFY2(finished.wait(kPatienceMs), qUtf8Printable(text));
    }
    const QStringList files =
        QDir(m_folder->path()).entryList({QStringLiteral("*.wav")}, QDir::Files, QDir::Name);
    QCOMPARE(files.size(), texts.size());
    for (const QString& name : files) {
        const Wav wav = readWav(m_folder->filePath(name));
        QVERIFY2(wav.seconds > 0.3 && wav.loudness > 500.0, qUtf8Printable(name));
    }
}

void TestSpeechOutput::rateAndVolumeAreHeard() {
    const QString text = QStringLiteral("Keep moving forward for about 10 metres.");
    const Wav normal = spoken(own(QStringLiteral("en")), text);
    const Wav fast = spoken(own(QStringLiteral("en"), 0.5), text);
    const Wav slow = spoken(own(QStringLiteral("en"), -0.5), text);
    const Wav soft = spoken(own(QStringLiteral("en"), 0.0, 0.25), text);
    QVERIFY(fast.seconds < 0.8 * normal.seconds);
    QVERIFY(slow.seconds > 1.2 * normal.seconds);
    QVERIFY(soft.peak > 0.2 * normal.peak &&
            soft.peak < 0.3 * normal.peak); // no two syntheses are quite equal
}

void TestSpeechOutput::voiceIsChosenByName() {
    VoiceChoice choice = own(QStringLiteral("en"));
    const QStringList voices = farol::ui::speechVoices(choice);
    QVERIFY(voices.size() > 1);
    QCOMPARE(farol::ui::speechVoices(own(QStringLiteral("pt"))),
             QStringList{QStringLiteral("Portuguese (Portugal)")});
    choice.voice = voices.last();
    const Wav last = spoken(choice, QStringLiteral("Turn around."));
    QVERIFY(last.loudness > 500.0);
    QCOMPARE(last.voice, QStringLiteral("farol, ") + voices.last());
    choice.voice = QStringLiteral("a voice that was uninstalled");
    QCOMPARE(spoken(choice, QStringLiteral("Turn around.")).voice,
             QStringLiteral("farol, English (Great Britain)"));
}

void TestSpeechOutput::replacedTextReportsNothing() {
    auto output = makeSpeechOutput(own(QStringLiteral("en")));
    QSignalSpy finished(output.get(), &SpeechOutput::finished);
    QSignalSpy failed(output.get(), &SpeechOutput::failed);
    output->say(QStringLiteral("Extinguisher, left, down."));
    output->say(QStringLiteral("Turn left."));
    QVERIFY(finished.wait(kPatienceMs));
    output->say(QStringLiteral("Turn right."));
    QVERIFY(finished.wait(kPatienceMs));
    QCOMPARE(finished.size(), 2);
    QVERIFY(failed.isEmpty());
}

void TestSpeechOutput::stoppedTextReportsNothing() {
    auto output = makeSpeechOutput(own(QStringLiteral("en")));
    QSignalSpy finished(output.get(), &SpeechOutput::finished);
    output->stop(); // before anything was said
    output->say(QStringLiteral("Extinguisher, left, down."));
    output->stop();
    QVERIFY(!output->speaking());
    output->say(QStringLiteral("Turn right."));
    QVERIFY(finished.wait(kPatienceMs));
    QCOMPARE(finished.size(), 1);
}

void TestSpeechOutput::missingDeviceIsToldForEachText() {
    qunsetenv("FAROL_SPEECH_WAV");
    auto output = makeSpeechOutput(own(QStringLiteral("en")));
    QSignalSpy finished(output.get(), &SpeechOutput::finished);
    QSignalSpy failed(output.get(), &SpeechOutput::failed);
    for (int text = 1; text <= 2; ++text) {
        output->say(QStringLiteral("Turn left."));
        QVERIFY(failed.wait(kPatienceMs));
        QCOMPARE(failed.size(), text);
        QVERIFY(failed.last()[0].toString().contains(QStringLiteral("no sound device")));
    }
    QVERIFY(finished.isEmpty());
}

void TestSpeechOutput::unwritableFolderIsTold() {
    const QString file = m_folder->filePath(QStringLiteral("file"));
    QFile blocker(file);
    QVERIFY(blocker.open(QIODevice::WriteOnly));
    qputenv("FAROL_SPEECH_WAV", (file + QStringLiteral("/below")).toUtf8());
    QVERIFY(
        failure(own(QStringLiteral("en")), QStringLiteral("Turn left.")).contains(QStringLiteral("below")));
}

void TestSpeechOutput::unknownEngineIsTold() {
    VoiceChoice choice;
    choice.engine = QStringLiteral("gone");
    const QString message = failure(choice, QStringLiteral("Turn left."));
    QCOMPARE(message,
             QStringLiteral("The voice \"gone\" is not installed. Choose another one in the settings."));
    QVERIFY(farol::ui::speechVoices(choice).isEmpty());
}

void TestSpeechOutput::wrongLanguageIsNotSpoken() {
    VoiceChoice choice;
    choice.engine = QStringLiteral("stuck"); // knows English only
    choice.language = QStringLiteral("pt");
    QVERIFY(failure(choice, QStringLiteral("Vire à esquerda."))
                .contains(QStringLiteral("does not speak this language")));
}

void TestSpeechOutput::hangingVoiceIsTold() {
    VoiceChoice choice;
    choice.engine = QStringLiteral("stuck");
    choice.patienceMs = 50;
    QVERIFY(failure(choice, QStringLiteral("Turn left.")).contains(QStringLiteral("hangs")));
}

void TestSpeechOutput::brokenVoiceIsToldOnce() {
    VoiceChoice choice;
    choice.engine = QStringLiteral("stuck");
    auto output = makeSpeechOutput(choice);
    QSignalSpy finished(output.get(), &SpeechOutput::finished);
    QSignalSpy failed(output.get(), &SpeechOutput::failed);
    output->say(QStringLiteral("break"));
    QVERIFY(failed.wait(kPatienceMs));
    output->say(QStringLiteral("break"));
    QVERIFY(failed.wait(kPatienceMs));
    QCOMPARE(failed.size(), 2);
    QCOMPARE(failed[0][0].toString(), QStringLiteral("broken on purpose"));
    QVERIFY(finished.isEmpty());
}

int main(int argc, char** argv) {
    // No sound server, whatever the machine has: these tests are the same everywhere, and silent.
    qputenv("PULSE_SERVER", "unix:/nonexistent/farol-test");
    QCoreApplication program(argc, argv);
    TestSpeechOutput test;
    return QTest::qExec(&test, argc, argv);
}
#include "test_speech_output.moc"
