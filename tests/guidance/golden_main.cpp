// golden_walks FOLDER: are the walks told as they stand in the folder's files? With --renew the files are
// written anew, to be read before they are committed.

#include "tests/guidance/golden_walk.h"
#include "ui/speech/phrasebook.h"

#include <QCoreApplication>
#include <QFile>
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
            good = (renew ? write(name, text) : same(name, text)) && good;
        }
    }
    return good ? 0 : 1;
}
