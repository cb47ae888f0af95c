#include "ui/models/core_words.h"

#include "ui/convert/convert.h"
#include "ui/models/words.h"
#include "ui/speech/phrasebook.h"

#include <QCoreApplication>
#include <QLocale>

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

/// What stands between the two places.
QString middleOf(const QString& text) {
    return text.section(QStringLiteral("%1"), 1).section(QStringLiteral("%2"), 0, 0);
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
    QString text = phrase(message);
    if (text.isEmpty()) return text;
    text[0] = text[0].toUpper();
    if (!QStringLiteral(".?!").contains(text.back())) text += QLatin1Char('.');
    return text;
}

QString CoreWords::id(const std::string& id) {
    const QString english = toQString(building::textOf(Sentence::LayerOfFile).text);
    return toQString(id).replace(middleOf(english), middleOf(translated(Sentence::LayerOfFile)));
}

} // namespace farol::ui
