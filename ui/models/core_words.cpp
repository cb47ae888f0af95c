#include "ui/models/core_words.h"

#include "core/base/base_sayings.h"
#include "core/base/kind.h"
#include "core/capture/sayings.h"
#include "core/recognition/sayings.h"
#include "core/session/sayings.h"
#include "ui/convert/convert.h"
#include "ui/models/words.h"
#include "ui/speech/phrasebook.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <optional>

namespace farol::ui {

namespace {

using building::Argument;
using building::Message;
using building::Sentence;

constexpr const char* kContext = "core"; // as in core/building/sentence_table.cpp

/// The word that people use, and the one that stands in the map, which a curator may have to write there.
QString withCode(const QString& word, const std::string& code) {
    const QString written = toQString(code);
    return word == written ? word : QStringLiteral("%1 (%2)").arg(word, written);
}

QStringList wordsOf(const Argument& argument) {
    QStringList words;
    if (argument.is == Argument::Is::Numbers) {
        QLocale locale(installedLanguage());
        locale.setNumberOptions(QLocale::OmitGroupSeparator);
        for (double number : argument.numbers)
            words << locale.toString(number, 'f', QLocale::FloatingPointShortest);
        return words;
    }
    if (argument.is == Argument::Is::Phrase) return {CoreWords::phrase(*argument.phrase)};
    for (const std::string& code : argument.words()) {
        if (argument.is == Argument::Is::RegionKinds)
            words << withCode(Words::regionKind(*building::regionKindFromName(code)), code);
        else if (argument.is == Argument::Is::AccessKinds)
            words << withCode(Words::accessKind(*building::accessKindFromName(code)), code);
        else if (argument.is == Argument::Is::LandmarkKinds)
            words << withCode(Phrasebook::kindWord(*kindFromName(code)), code);
        else
            words << CoreWords::id(code);
    }
    return words;
}

QString translated(Sentence sentence, int count = -1) {
    return QCoreApplication::translate(kContext, building::textOf(sentence).text, nullptr, count);
}

/// A row of a table as it is found in a text, its places as they were filled.
struct Pattern {
    const char* english;
    Sentence sentence; ///< Nothing: a row of another table than that of maps
    QRegularExpression filled;
    qsizetype letters = 0; ///< of two patterns that fit, the longer one was meant
};

/// Frames of names, not sentences.
constexpr std::array kFrames{Sentence::Nothing,         Sentence::InContext, Sentence::LayerOfFile,
                             Sentence::FeatureNumberOf, Sentence::FeatureOf, Sentence::LineOf,
                             Sentence::LevelOf,         Sentence::MoreOf,    Sentence::RegionOnLevel};

QRegularExpression filledIn(const char* english) {
    static const QRegularExpression place(QStringLiteral("%[1-9]"));
    QStringList between;
    for (const QString& part : toQString(english).split(place)) between << QRegularExpression::escape(part);
    return QRegularExpression(QRegularExpression::anchoredPattern(between.join(QStringLiteral("(.+)"))),
                              QRegularExpression::DotMatchesEverythingOption);
}

/// Names of places in a library: the same for its table.
bool isFrame(recognition::Saying saying) {
    return saying >= recognition::Saying::TemplateNamed;
}

const char* englishOf(recognition::Saying saying) {
    static const std::vector<const char*> all = recognition::sayings();
    return all[static_cast<std::size_t>(saying)];
}

std::vector<Pattern> patterns() {
    std::vector<Pattern> all;
    const auto add = [&all](const char* english, Sentence sentence) {
        all.push_back({english, sentence, filledIn(english), toQString(english).size()});
    };
    for (const building::SentenceText& row : building::allSentences())
        if (!row.counts() && std::find(kFrames.begin(), kFrames.end(), row.sentence) == kFrames.end())
            add(row.text, row.sentence);
    for (const char* english : baseSayings()) add(english, Sentence::Nothing);
    for (const std::vector<const char*>& sayings : {capture::sayings(), session::sayings()})
        for (const char* english : sayings) add(english, Sentence::Nothing);
    const std::vector<const char*> ofLibraries = recognition::sayings();
    for (std::size_t i = 0; i < ofLibraries.size(); ++i)
        if (!isFrame(static_cast<recognition::Saying>(i))) add(ofLibraries[i], Sentence::Nothing);
    std::stable_sort(all.begin(), all.end(),
                     [](const Pattern& a, const Pattern& b) { return a.letters > b.letters; });
    return all;
}

/// What the system says of a file, where it says it in English.
QString systemWords(const QString& english) {
    static constexpr std::array kWords{QT_TRANSLATE_NOOP("core", "Permission denied"),
                                       QT_TRANSLATE_NOOP("core", "No such file or directory"),
                                       QT_TRANSLATE_NOOP("core", "Read-only file system"),
                                       QT_TRANSLATE_NOOP("core", "No space left on device"),
                                       QT_TRANSLATE_NOOP("core", "Input/output error"),
                                       QT_TRANSLATE_NOOP("core", "Is a directory"),
                                       QT_TRANSLATE_NOOP("core", "Not a directory"),
                                       QT_TRANSLATE_NOOP("core", "File name too long"),
                                       QT_TRANSLATE_NOOP("core", "Operation not permitted"),
                                       QT_TRANSLATE_NOOP("core", "Too many open files")};
    for (const char* words : kWords)
        if (english == QLatin1String(words)) return QCoreApplication::translate(kContext, words);
    return english;
}

/// "a, b and 3 more", as core shortens a list.
Argument listed(const QString& english) {
    static const QRegularExpression more = filledIn(building::textOf(Sentence::MoreOf).text);
    const QRegularExpressionMatch found = more.match(english);
    bool number = false;
    const int count = found.captured(2).toInt(&number);
    if (!number) return toUtf8(english);
    return building::said(Sentence::MoreOf, toUtf8(found.captured(1)), static_cast<double>(count));
}

/// "house.gpkg, layer rooms", between whatever else stands there.
QString translatedPlace(QString text, const char* where) {
    static const QRegularExpression places(QStringLiteral("%[12]"));
    return text.replace(toQString(where).split(places).at(1),
                        QCoreApplication::translate(kContext, where).split(places).value(1));
}

QString translatedPlace(QString text, Sentence where) {
    return translatedPlace(std::move(text), building::textOf(where).text);
}

std::optional<QString> known(const QString& english);
std::optional<QString> placedSentence(const QString& english);

QString mapSentence(const Pattern& pattern, const QRegularExpressionMatch& found) {
    std::vector<Argument> places;
    for (int i = 1; i <= found.lastCapturedIndex(); ++i)
        places.push_back(listed(pattern.sentence == Sentence::WhereShared
                                    ? translatedPlace(found.captured(i), Sentence::RegionOnLevel)
                                    : found.captured(i)));
    return CoreWords::phrase({pattern.sentence, std::nullopt, std::move(places)});
}

/// Of another table: what stands in a place may be a sentence of its own, or a kind.
QString otherSentence(const Pattern& pattern, const QRegularExpressionMatch& found) {
    std::vector<std::string> places;
    for (int i = 1; i <= found.lastCapturedIndex(); ++i) {
        const QString place = found.captured(i);
        QString text = known(place).value_or(placedSentence(place).value_or(place));
        if (pattern.english == englishOf(recognition::Saying::KindOther))
            if (const auto kind = kindFromName(toUtf8(place))) text = Phrasebook::kindWord(*kind);
        places.push_back(toUtf8(text));
    }
    return toQString(withPlaces(toUtf8(QCoreApplication::translate(kContext, pattern.english)), places));
}

/// Nothing when no table holds it.
std::optional<QString> known(const QString& english) {
    static const std::vector<Pattern> all = patterns();
    for (const Pattern& pattern : all)
        if (const QRegularExpressionMatch found = pattern.filled.match(english); found.hasMatch())
            return pattern.sentence == Sentence::Nothing ? otherSentence(pattern, found)
                                                         : mapSentence(pattern, found);
    return std::nullopt;
}

/// The same with what a library or the system says behind it: in brackets, or after a colon.
std::optional<QString> knownWithDetail(const QString& english) {
    if (const auto text = known(english)) return text;
    static const QRegularExpression bracketed(QStringLiteral("^(.*?) \\((.*)\\)$"),
                                              QRegularExpression::DotMatchesEverythingOption);
    static const QRegularExpression behindColon(QStringLiteral("^(.*?): (.*)$"),
                                                QRegularExpression::DotMatchesEverythingOption);
    if (const QRegularExpressionMatch parts = bracketed.match(english); parts.hasMatch())
        if (const auto head = known(parts.captured(1)))
            return QStringLiteral("%1 (%2)").arg(*head, parts.captured(2));
    if (const QRegularExpressionMatch parts = behindColon.match(english); parts.hasMatch())
        if (const auto head = known(parts.captured(1)))
            return CoreWords::phrase(
                building::said(Sentence::InContext, toUtf8(*head), toUtf8(systemWords(parts.captured(2)))));
    return std::nullopt;
}

QString stopped(QString text) {
    if (!text.isEmpty() && !QStringLiteral(".?!").contains(text.back())) text += QLatin1Char('.');
    return text;
}

/// Without a stop.
QString inContext(QString context, const QString& text) {
    for (const Sentence where : {Sentence::LayerOfFile, Sentence::FeatureNumberOf, Sentence::FeatureOf,
                                 Sentence::LineOf, Sentence::LevelOf})
        context = translatedPlace(context, where);
    using recognition::Saying;
    for (const Saying where : {Saying::SomeViewOf, Saying::TemplateOf, Saying::ViewOf, Saying::RowOf})
        context = translatedPlace(context, englishOf(where));
    static const QString named = toQString(englishOf(Saying::TemplateNamed)).remove(QStringLiteral("%1"));
    if (context.startsWith(named))
        context = QCoreApplication::translate(kContext, englishOf(Saying::TemplateNamed))
                      .replace(QStringLiteral("%1"), context.mid(named.size()));
    return CoreWords::phrase(building::said(Sentence::InContext, toUtf8(context), toUtf8(text)));
}

/// A sentence behind the name of the place it is about; names may hold a colon, too.
std::optional<QString> placedSentence(const QString& english) {
    const QString colon = QStringLiteral(": ");
    for (qsizetype at = english.indexOf(colon); at >= 0; at = english.indexOf(colon, at + 1))
        if (const auto text = knownWithDetail(english.mid(at + colon.size())))
            return inContext(english.left(at), *text);
    return std::nullopt;
}

} // namespace

QString CoreWords::phrase(const Message& message) {
    const QString text = translated(message.sentence, message.count ? static_cast<int>(*message.count) : -1);
    std::vector<std::string> places;
    for (const Argument& argument : message.arguments)
        places.push_back(toUtf8(wordsOf(argument).join(QStringLiteral(", "))));
    return toQString(building::withPlaces(toUtf8(text), places));
}

QString CoreWords::sentence(const Message& message) {
    QString text = stopped(phrase(message));
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return text;
}

QString CoreWords::problem(const Error& error) {
    const QString english = toQString(error.message);
    const std::optional<QString> text = knownWithDetail(english);
    if (error.context.empty()) {
        QString alone = stopped(text.value_or(english));
        if (!alone.isEmpty()) alone[0] = alone[0].toUpper();
        return alone;
    }
    return stopped(inContext(toQString(error.context), text.value_or(english)));
}

QString CoreWords::message(const std::string& english) {
    return known(toQString(english)).value_or(toQString(english));
}

QString CoreWords::remark(const std::string& warning) {
    const auto text = placedSentence(toQString(warning));
    return text ? stopped(*text) : toQString(warning);
}

QString CoreWords::id(const std::string& id) {
    return translatedPlace(toQString(id), Sentence::LayerOfFile);
}

} // namespace farol::ui
