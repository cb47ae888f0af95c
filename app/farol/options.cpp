#include "app/farol/options.h"

#include <QCommandLineParser>
#include <QCoreApplication>

#include <cstdio>
#include <cstdlib>

namespace farol {

namespace {

QString words(const char* text) {
    return QCoreApplication::translate("farol::Options", text);
}

[[noreturn]] void wrongUsage(const QString& message) {
    std::fprintf(stderr, "farol: %s\n", qPrintable(message));
    std::exit(2);
}

double positive(const QString& text, const QString& option) {
    bool fine = false;
    const double value = text.toDouble(&fine);
    if (!fine || !(value > 0.0) || value > 1000.0)
        wrongUsage(words(QT_TRANSLATE_NOOP("farol::Options", "%1 needs a number above 0, not “%2”"))
                       .arg(option, text));
    return value;
}

QSize sizeFrom(const QString& text) {
    const QStringList parts = text.split(QLatin1Char('x'));
    const QSize size = parts.size() == 2 ? QSize(parts[0].toInt(), parts[1].toInt()) : QSize();
    if (size.width() < 320 || size.height() < 240 || size.width() > 16384 || size.height() > 16384)
        wrongUsage(words(QT_TRANSLATE_NOOP("farol::Options", "%1 needs a size such as 1280x800, not “%2”"))
                       .arg(QStringLiteral("--size"), text));
    return size;
}

} // namespace

Options optionsFrom(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Farol: guidance through a building with one camera.\n"
        "Example: farol --map campus.gpkg --library campus.gpkg --source camera:0 --to 2.14 --start"));
    const auto value = [&](const char* name, const char* what, const char* help) {
        const QCommandLineOption option(QString::fromLatin1(name), QString::fromLatin1(help),
                                        QString::fromLatin1(what));
        parser.addOption(option);
        return option;
    };
    const auto flag = [&](const char* name, const char* help) {
        const QCommandLineOption option(QString::fromLatin1(name), QString::fromLatin1(help));
        parser.addOption(option);
        return option;
    };
    const auto map = value("map", "file", "Map of the building (GeoPackage)");
    const auto edit = value("edit", "source", "Show the Map page with a map of any kind");
    const auto level = value("level", "number", "Level that the Map page shows");
    const auto panel = value("panel", "name", "What stands beside the plan: table, check or route");
    const auto dark = flag("dark", "Dark colours");
    const auto alike = flag("alike", "Mark the places that look alike");
    const auto library = value("library", "file", "Landmark library");
    const auto source = value("source", "source",
                              "camera:0, a video file, a folder of pictures, an http or rtsp address, "
                              "sim:WHERE or sim: (simulated visitors)");
    const auto fps = value("fps", "number", "Pictures a second of a folder");
    const auto from = value("from", "where", "Where the walk starts");
    const auto to = value("to", "where", "Where to go");
    const auto localiser =
        value("localiser", "name", "bayes-guided, bayes, voting or voting-literal (as in the settings)");
    const auto lang = value("lang", "language", "en, pt, es, fr or de");
    const auto start = flag("start", "Begin to play at once");
    const auto banner = value("banner", "text", "Which example is running");
    const auto screenshot = value("screenshot", "file", "Save a picture of the window, then quit");
    const auto after = value("after", "pictures", "Pictures shown before the screenshot (10)");
    const auto size = value("size", "WxH", "Size of the window");
    const auto selfTest = flag("self-test", "Start, load, quit");
    const auto kiosk = flag("kiosk", "For a blind user: full screen, by keys and speech alone");
    const auto utterances =
        value("utterances", "file", "The kiosk writes there what it says, when and why (JSON lines)");
    const auto watched = flag("watched", "The kiosk without the process that starts it again after a crash");
    parser.addHelpOption();
    parser.addVersionOption();
    parser.setOptionsAfterPositionalArgumentsMode(QCommandLineParser::ParseAsOptions);
    if (!parser.parse(arguments)) wrongUsage(parser.errorText());
    if (parser.isSet(QStringLiteral("version"))) parser.showVersion();
    if (parser.isSet(QStringLiteral("help"))) parser.showHelp(0);
    if (!parser.positionalArguments().isEmpty())
        wrongUsage(words(QT_TRANSLATE_NOOP("farol::Options", "“%1” is not known; see --help"))
                       .arg(parser.positionalArguments().first()));

    Options options;
    options.begin = {
        parser.value(map),       parser.value(library), parser.value(source), 0.0,
        parser.value(from),      parser.value(to),      parser.value(banner), parser.isSet(start),
        parser.value(localiser), parser.value(edit)};
    if (parser.isSet(fps))
        options.begin.framesPerSecond = positive(parser.value(fps), QStringLiteral("--fps"));
    options.language = parser.value(lang);
    options.screenshot = parser.value(screenshot);
    if (parser.isSet(after))
        options.after = static_cast<int>(positive(parser.value(after), QStringLiteral("--after")));
    if (parser.isSet(size)) options.size = sizeFrom(parser.value(size));
    if (parser.isSet(level)) options.level = parser.value(level).toDouble();
    options.panel = parser.value(panel);
    options.dark = parser.isSet(dark);
    options.alike = parser.isSet(alike);
    options.selfTest = parser.isSet(selfTest);
    options.kiosk = parser.isSet(kiosk);
    options.utterances = parser.value(utterances);
    options.watched = parser.isSet(watched);
    return options;
}

} // namespace farol
