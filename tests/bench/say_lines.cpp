// farol-bench-say [LANGUAGE [RATE [ENGINE]]]: speaks each line of its input with the voice that users hear,
// one after the other, and answers each with "finished" or "failed: why". For recordings of the voice; see
// heard_speech/heard.py.

#include "ui/speech/speech_output.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QTextStream>

#include <cstdio>

namespace {

QString spoken(farol::ui::SpeechOutput& voice, const QString& text) {
    QEventLoop loop;
    QString outcome;
    QObject::connect(&voice, &farol::ui::SpeechOutput::finished, &loop, [&] {
        outcome = QStringLiteral("finished");
        loop.quit();
    });
    QObject::connect(&voice, &farol::ui::SpeechOutput::failed, &loop, [&](const QString& message) {
        outcome = QStringLiteral("failed: ") + message;
        loop.quit();
    });
    voice.say(text);
    if (outcome.isEmpty()) loop.exec();
    return outcome;
}

} // namespace

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    farol::ui::VoiceChoice choice;
    choice.language = arguments.value(1, QStringLiteral("en"));
    choice.rate = arguments.value(2, QStringLiteral("0")).toDouble();
    choice.engine = arguments.value(3);
    const auto voice = farol::ui::makeSpeechOutput(choice);
    QTextStream input(stdin);
    bool failed = false;
    while (true) {
        const QString line = input.readLine();
        if (line.isNull()) break;
        const QString outcome = spoken(*voice, line);
        failed = failed || !outcome.startsWith(QLatin1String("finished"));
        std::printf("%s\n", qPrintable(outcome));
        std::fflush(stdout);
    }
    std::fprintf(stderr, "%s\n", qPrintable(voice->description()));
    return failed ? 1 : 0;
}
