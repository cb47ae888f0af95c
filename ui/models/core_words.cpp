#include "ui/models/core_words.h"

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

/// A row of the table as it is found in a text, its places as they were filled.
struct Pattern {
    Sentence sentence;
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

std::vector<Pattern> patterns() {
    std::vector<Pattern> all;
    for (const building::SentenceText& row : building::allSentences())
        if (!row.counts() && std::find(kFrames.begin(), kFrames.end(), row.sentence) == kFrames.end())
            all.push_back({row.sentence, filledIn(row.text), toQString(row.text).size()});
    std::stable_sort(all.begin(), all.end(),
                     [](const Pattern& a, const Pattern& b) { return a.letters > b.letters; });
    return all;
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
QString translatedPlace(QString text, Sentence where) {
    static const QRegularExpression places(QStringLiteral("%[12]"));
    return text.replace(toQString(building::textOf(where).text).split(places).at(1),
                        translated(where).split(places).value(1));
}

/// Nothing when the table does not hold it.
std::optional<QString> known(const QString& english) {
    static const std::vector<Pattern> all = patterns();
    for (const Pattern& pattern : all) {
        const QRegularExpressionMatch found = pattern.filled.match(english);
        if (!found.hasMatch()) continue;
        std::vector<Argument> places;
        for (int i = 1; i <= found.lastCapturedIndex(); ++i)
            places.push_back(listed(pattern.sentence == Sentence::WhereShared
                                        ? translatedPlace(found.captured(i), Sentence::RegionOnLevel)
                                        : found.captured(i)));
        return CoreWords::phrase({pattern.sentence, std::nullopt, std::move(places)});
    }
    return std::nullopt;
}

QString stopped(QString text) {
    if (!text.isEmpty() && !QStringLiteral(".?!").contains(text.back())) text += QLatin1Char('.');
    return text;
}

QString inContext(QString context, const QString& text) {
    for (const Sentence where : {Sentence::LayerOfFile, Sentence::FeatureNumberOf, Sentence::FeatureOf,
                                 Sentence::LineOf, Sentence::LevelOf})
        context = translatedPlace(context, where);
    return stopped(CoreWords::phrase(building::said(Sentence::InContext, toUtf8(context), toUtf8(text))));
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
    std::optional<QString> text = known(english);
    static const QRegularExpression detailed(QStringLiteral("^(.*?) \\((.*)\\)$"),
                                             QRegularExpression::DotMatchesEverythingOption);
    if (const QRegularExpressionMatch parts = detailed.match(english); !text && parts.hasMatch())
        if (const auto head = known(parts.captured(1))) // behind it, what a library says
            text = QStringLiteral("%1 (%2)").arg(*head, parts.captured(2));
    if (error.context.empty()) {
        QString alone = stopped(text.value_or(english));
        if (!alone.isEmpty()) alone[0] = alone[0].toUpper();
        return alone;
    }
    return inContext(toQString(error.context), text.value_or(english));
}

QString CoreWords::remark(const std::string& warning) {
    const QString english = toQString(warning), colon = QStringLiteral(": ");
    for (qsizetype at = english.indexOf(colon); at >= 0;
         at = english.indexOf(colon, at + 1)) // names may hold one
        if (const auto text = known(english.mid(at + colon.size())))
            return inContext(english.left(at), *text);
    return english;
}

QString CoreWords::id(const std::string& id) {
    return translatedPlace(toQString(id), Sentence::LayerOfFile);
}

} // namespace farol::ui
