#include "app/farol/kiosk_program.h"

#include "ui/kiosk/kiosk_page.h"

#include <QApplication>
#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QLocale>
#include <QPixmap>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QThread>
#include <QTimer>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <sys/prctl.h>

namespace farol {

namespace {

constexpr int kMostCrashes = 5;          // in a row
constexpr qint64 kGoodRunMs = 60000;     // a run as long as this begins the count anew
constexpr unsigned long kPauseMs = 1000; // before the next start
constexpr int kPictureMs = 3000;         // words have been said, the camera has started or not

QString folder(QStandardPaths::StandardLocation location) {
    return QDir(QStandardPaths::writableLocation(location)).filePath(QStringLiteral("farol"));
}

/// What the command line leaves open is as the last time, in the kiosk or else in the workstation.
ui::KioskStart startOf(const Options& options, ui::Settings& settings, const ui::Settings& workstation) {
    using ui::RecentKind;
    ui::KioskStart start;
    const auto pick = [&](const QString& given, RecentKind kind) {
        if (!given.isEmpty()) settings.addRecent(kind, given);
        const QString own = settings.recent(kind).value(0);
        return own.isEmpty() ? workstation.recent(kind).value(0) : own;
    };
    start.map = pick(options.begin.map, RecentKind::Map);
    // A library and a camera belong to a map: those of another one would only mislead.
    const bool asBefore = options.begin.map.isEmpty();
    start.library = asBefore ? pick(options.begin.library, RecentKind::Library) : options.begin.library;
    start.source = asBefore ? pick(options.begin.source, RecentKind::Source) : options.begin.source;
    start.framesPerSecond = options.begin.framesPerSecond;
    start.from = options.begin.from;
    start.to = options.begin.to;
    start.utteranceFile = options.utterances;
    return start;
}

} // namespace

int runKiosk(const Options& options) {
    const QTemporaryDir scratch;
    const bool aside = options.selfTest || !options.screenshot.isEmpty();
    const QString config = aside ? scratch.path() : folder(QStandardPaths::GenericConfigLocation);
    ui::Settings settings(QDir(config).filePath(QStringLiteral("kiosk.ini")));
    const ui::Settings workstation(aside ? scratch.filePath(QStringLiteral("none.ini")) : QString());
    if (!options.language.isEmpty()) settings.setLanguage(options.language.left(2));
    const QString language = settings.language().isEmpty() ? QLocale::system().name() : settings.language();
    if (!ui::installTranslation(language)) ui::installTranslation(QStringLiteral("en"));

    ui::KioskStart start = startOf(options, settings, workstation);
    const QString data = aside ? scratch.path() : folder(QStandardPaths::GenericDataLocation);
    start.memoryFile = QDir(data).filePath(QStringLiteral("kiosk.json"));
    ui::Kiosk kiosk(settings, start);
    ui::KioskPage page(kiosk);
    if (aside) page.resize(options.size.value_or(QSize(1280, 800)));
    if (aside)
        page.show();
    else
        page.showFullScreen();
    page.activateWindow();
    page.setFocus();
    kiosk.begin();
    if (aside) {
        QTimer::singleShot(kPictureMs, &page, [&] {
            const bool saved = options.screenshot.isEmpty() || page.grab().save(options.screenshot);
            if (!saved) std::fprintf(stderr, "farol: %s cannot be written\n", qPrintable(options.screenshot));
            page.close();
            QApplication::exit(saved ? 0 : 1);
        });
    }
    return QApplication::exec();
}

bool wantsKeeping(int argc, char** argv) {
    bool kiosk = false, other = false;
    for (int i = 1; i < argc; ++i) {
        const auto is = [&](const char* option) {
            return std::strncmp(argv[i], option, std::strlen(option)) == 0;
        };
        kiosk = kiosk || std::strcmp(argv[i], "--kiosk") == 0;
        other = other || is("--watched") || is("--screenshot") || is("--self-test") || is("--help") ||
                is("-h") || is("--version") || is("-v");
    }
    return kiosk && !other;
}

int keepKioskRunning(int& argc, char** argv) {
    const QCoreApplication application(argc, argv);
    QStringList arguments = QCoreApplication::arguments().mid(1);
    arguments << QStringLiteral("--watched");
    for (int crashes = 0; crashes < kMostCrashes;) {
        QProcess kiosk;
        kiosk.setProcessChannelMode(QProcess::ForwardedChannels);
        kiosk.setInputChannelMode(QProcess::ForwardedInputChannel);
        // Whoever ends this process means the kiosk.
        kiosk.setChildProcessModifier([] { prctl(PR_SET_PDEATHSIG, SIGTERM); });
        QElapsedTimer run;
        run.start();
        kiosk.start(QCoreApplication::applicationFilePath(), arguments);
        if (!kiosk.waitForStarted(-1)) {
            std::fprintf(stderr, "farol: the kiosk cannot be started: %s\n", qPrintable(kiosk.errorString()));
            return 1;
        }
        kiosk.waitForFinished(-1);
        if (kiosk.exitStatus() == QProcess::NormalExit) return kiosk.exitCode();
        crashes = run.elapsed() >= kGoodRunMs ? 1 : crashes + 1;
        std::fprintf(stderr, "farol: the kiosk has crashed and is started again\n");
        QThread::msleep(kPauseMs);
    }
    std::fprintf(stderr, "farol: the kiosk crashes again and again; it is not started any more\n");
    return 1;
}

} // namespace farol
