#include "ui/speech/pronounced.h"

#include <QMap>
#include <QRegularExpression>
#include <QStringList>

namespace farol::ui::spoken {

namespace {

QRegularExpression rule(const char* pattern) {
    return QRegularExpression(QString::fromUtf8(pattern), QRegularExpression::UseUnicodePropertiesOption);
}

/// Numbers with a mark that makes them "first", "second", ...: written out as far as buildings go.
struct Ordinals {
    QRegularExpression marked; ///< captures the number
    QStringList words;
};

QStringList list(const char* words) {
    return QString::fromUtf8(words).split(QLatin1Char(' '));
}

const QMap<QString, QList<Ordinals>>& ordinals() {
    static const QMap<QString, QList<Ordinals>> kOrdinals{
        {QStringLiteral("pt"),
         {{rule("\\b(\\d+)\\.?º"),
           list("primeiro segundo terceiro quarto quinto sexto sétimo oitavo nono décimo")},
          {rule("\\b(\\d+)\\.?ª"),
           list("primeira segunda terceira quarta quinta sexta sétima oitava nona décima")}}},
        {QStringLiteral("es"),
         {{rule("\\b(\\d+)\\.?(?:º|er\\b)"),
           list("primer segundo tercer cuarto quinto sexto séptimo octavo noveno décimo")},
          {rule("\\b(\\d+)\\.?ª"),
           list("primera segunda tercera cuarta quinta sexta séptima octava novena décima")}}},
        {QStringLiteral("fr"),
         {{rule("\\b(\\d+)(?:e|ème|ᵉ)\\b"),
           list("premier deuxième troisième quatrième cinquième sixième septième "
                "huitième neuvième dixième")}}},
        {QStringLiteral("de"),
         {{rule("\\b(\\d+)\\. ?(?=Stock)"),
           list("erster zweiter dritter vierter fünfter sechster siebter achter neunter zehnter")},
          {rule("\\b(\\d+)\\. ?(?=Etage|Ebene)"),
           list("erste zweite dritte vierte fünfte sechste siebte achte neunte zehnte")},
          {rule("\\b(\\d+)\\. ?(?=[OU]G\\b|Obergeschoss|Untergeschoss)"),
           list("erstes zweites drittes viertes fünftes sechstes siebtes achtes neuntes zehntes")}}}};
    return kOrdinals;
}

void writeOut(QString& text, const Ordinals& ordinals, bool apart) {
    qsizetype from = 0;
    for (auto match = ordinals.marked.match(text); match.hasMatch();
         match = ordinals.marked.match(text, from)) {
        const int number = match.captured(1).toInt();
        const bool known = number >= 1 && number <= ordinals.words.size();
        QString word = known ? ordinals.words[number - 1] : match.captured(1);
        if (apart) word += QLatin1Char(' ');
        text.replace(match.capturedStart(), match.capturedLength(), word);
        from = match.capturedStart() + word.size();
    }
}

} // namespace

QString pronounced(QString text, const QString& language) {
    const QString code = language.left(2).toLower();
    static const QRegularExpression range = rule("(?<=\\d)[-\u2013](?=\\d)");
    text.replace(range, QStringLiteral(" "));
    static const QRegularExpression title =
        rule("\\b(Dr|Dra|Prof|Profa|Eng|Sr|Sra|Mr|Mrs|Ms|St|Lab|Gab|Rm|Bldg|Av)\\. (?=\\S)");
    text.replace(title, QStringLiteral("\\1 "));
    static const QMap<QString, QString> kNumber{{QStringLiteral("pt"), QStringLiteral("número ")},
                                                {QStringLiteral("es"), QStringLiteral("número ")},
                                                {QStringLiteral("fr"), QStringLiteral("numéro ")},
                                                {QStringLiteral("de"), QStringLiteral("Nummer ")},
                                                {QStringLiteral("en"), QStringLiteral("number ")}};
    static const QRegularExpression number = rule("\\b(?:[Nn]\\.?[º°]|No\\.|Nr\\.) ?(?=\\d)");
    text.replace(number, kNumber.value(code, QStringLiteral("number ")));
    const QList<Ordinals> all = ordinals().value(code);
    for (const Ordinals& each : all) writeOut(text, each, code == QLatin1String("de"));
    if (code == QLatin1String("en")) return text;
    // Of a room's number; English reads it digit by digit.
    static const QRegularExpression thousands = rule("(?<=\\d)\\.(?=\\d{3}\\b)");
    text.replace(thousands, QStringLiteral(" "));
    return text;
}

} // namespace farol::ui::spoken
