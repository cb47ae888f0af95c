// Which language the program speaks. The .qm files stand in the program itself.

#include "ui/speech/phrasebook.h"

#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

#include <memory>
#include <vector>

// A static library's resources are dropped by the linker unless something names them; outside any namespace.
static void nameTranslations() {
    Q_INIT_RESOURCE(farol_translations);
}

namespace farol::ui {

namespace {

std::vector<std::unique_ptr<QTranslator>>& installed() {
    static std::vector<std::unique_ptr<QTranslator>> translators;
    return translators;
}

QString& currentLanguage() {
    static QString language = QStringLiteral("en");
    return language;
}

bool install(const QString& file, const QString& folder) {
    auto translator = std::make_unique<QTranslator>();
    if (!translator->load(file, folder)) return false;
    QCoreApplication::installTranslator(translator.get());
    installed().push_back(std::move(translator));
    return true;
}

/// "pt_BR" is served by "pt": one Portuguese, understood by both.
bool installFarol(const QString& language) {
    const QString folder = QStringLiteral(":/farol/translations");
    QString name = language;
    name.replace(QLatin1Char('-'), QLatin1Char('_'));
    if (name.isEmpty() || name.contains(QLatin1Char('/'))) return false;
    return install(QStringLiteral("farol_") + name, folder) ||
           install(QStringLiteral("farol_") + name.section(QLatin1Char('_'), 0, 0).toLower(), folder);
}

} // namespace

const QList<Language>& languages() {
    static const QList<Language> list{{QStringLiteral("en"), QStringLiteral("English")},
                                      {QStringLiteral("pt"), QStringLiteral("Português")},
                                      {QStringLiteral("es"), QStringLiteral("Español")},
                                      {QStringLiteral("fr"), QStringLiteral("Français")},
                                      {QStringLiteral("de"), QStringLiteral("Deutsch")}};
    return list;
}

bool installTranslation(const QString& language) {
    nameTranslations();
    for (const auto& translator : installed()) QCoreApplication::removeTranslator(translator.get());
    installed().clear();
    const bool found = installFarol(language);
    // English has plurals of its own, so it is a translation too.
    if (!found) installFarol(QStringLiteral("en"));
    currentLanguage() = found ? language.left(2).toLower() : QStringLiteral("en");
    const QString qtFolder = QLibraryInfo::path(QLibraryInfo::TranslationsPath);
    if (found && !install(QStringLiteral("qtbase_") + language, qtFolder)) {
        install(QStringLiteral("qtbase_") + QLocale(language).name(), qtFolder);
    }
    return found;
}

QString installedLanguage() {
    return currentLanguage();
}

} // namespace farol::ui
