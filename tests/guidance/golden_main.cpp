// golden_walks FOLDER: are the walks told as they stand in the folder's files? With --renew the files are
// written anew, to be read before they are committed.

#include "tests/guidance/golden_situations.h"
#include "tests/guidance/golden_teller.h"
#include "tests/guidance/golden_walk.h"
#include "ui/speech/phrasebook.h"

#include <QCoreApplication>
#include <QFile>
#include <QMap>
#include <QRegularExpression>
#include <QStringList>

#include <cstdio>

namespace {

bool write(const QString& name, const QString& text) {
    QFile file(name);
    return file.open(QIODevice::WriteOnly) && file.write(text.toUtf8()) >= 0;
}

/// All are told in English and Portuguese; these, with everything that has words of its own, in the others,
/// too.
bool isTold(const std::string& building, const QString& language) {
    if (language == QLatin1String("en") || language == QLatin1String("pt")) return true;
    for (const char* name : {"stairs", "lift", "bend", "tee", "crossing"})
        if (building == name) return true;
    return false;
}

/// True when the file says the same; else the first difference is told.
bool same(const QString& name, const QString& text) {
    QFile file(name);
    const QString before =
        file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QStringLiteral("(no file)");
    const QStringList then = before.split(QLatin1Char('\n')), now = text.split(QLatin1Char('\n'));
    for (qsizetype i = 0; i < std::max(then.size(), now.size()); ++i) {
        const QString a = then.value(i), b = now.value(i);
        if (a == b) continue;
        std::printf("%s, line %d\n  on file: %s\n  told:    %s\n", qUtf8Printable(name), int(i + 1),
                    qUtf8Printable(a), qUtf8Printable(b));
        return false;
    }
    return true;
}

/// Who walks as planned hears every order to its end, no order takes too long, and nothing is said twice
/// within 15 s.
bool keepsTheRules(const QString& name, const QString& text) {
    constexpr double kLongestOrderS = 6.8, kRepeatS = 15.0;
    static const QRegularExpression spoken(QStringLiteral("^ *([0-9.]+) s +[0-9.]+ m +(\\w+) +([^ ].*)$"));
    static const QRegularExpression styled(QStringLiteral("^ +\\[\\w+\\] (.*)$"));
    static const QString kCut = QStringLiteral("(cut short: ");
    QMap<QString, double> saidAt;
    QStringList orders;
    QString kind, fault;
    for (const QString& line : text.split(QLatin1Char('\n'))) {
        const auto match = spoken.match(line), style = styled.match(line);
        if (match.hasMatch()) kind = match.captured(2);
        if (!match.hasMatch() && !style.hasMatch() && !line.contains(kCut)) kind.clear();
        const bool isOrder = kind == QLatin1String("act") || kind == QLatin1String("prepare");
        const QString words = match.hasMatch() ? match.captured(3) : style.captured(1);
        if (isOrder && farol::test::speakingSeconds(words) > kLongestOrderS)
            fault = QStringLiteral("takes %1 s").arg(farol::test::speakingSeconds(words));
        if (match.hasMatch()) {
            const double time = match.captured(1).toDouble();
            if (saidAt.contains(words) && time - saidAt[words] < kRepeatS) fault = QStringLiteral("again");
            saidAt[words] = time;
            if (isOrder || kind == QLatin1String("route_start")) orders << words;
        }
        if (line.contains(kCut) && orders.contains(line.section(kCut, 1).chopped(1)))
            fault = QStringLiteral("cut short");
        if (fault.isEmpty()) continue;
        std::printf("%s: %s\n  %s\n", qUtf8Printable(name), qUtf8Printable(fault), qUtf8Printable(line));
        return false;
    }
    return true;
}

} // namespace

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    QStringList words = QCoreApplication::arguments().mid(1);
    const bool renew = words.removeAll(QStringLiteral("--renew")) > 0;
    if (words.size() != 1) {
        std::fputs("golden_walks FOLDER [--renew]\n", stderr);
        return 2;
    }
    bool good = true;
    for (const char* language : {"en", "pt", "es", "fr", "de"}) {
        good = farol::ui::installTranslation(QLatin1String(language)) && good;
        for (const farol::test::GoldenBuilding& golden : farol::test::goldenBuildings()) {
            if (!isTold(golden.name, QLatin1String(language))) continue;
            const QString name =
                QStringLiteral("%1/%2.%3.txt")
                    .arg(words.front(), QString::fromStdString(golden.name), QLatin1String(language));
            const QString text = farol::test::tellWalk(golden);
            good = (renew ? write(name, text) : same(name, text)) && keepsTheRules(name, text) && good;
        }
        const bool both = qstrcmp(language, "en") == 0 || qstrcmp(language, "pt") == 0;
        for (const farol::test::GoldenSituation& golden : farol::test::goldenSituations()) {
            if (!both) break;
            const QString name =
                QStringLiteral("%1/situation_%2.%3.txt")
                    .arg(words.front(), QString::fromStdString(golden.name), QLatin1String(language));
            const QString text = golden.tell();
            good = (renew ? write(name, text) : same(name, text)) && good;
        }
    }
    return good ? 0 : 1;
}
