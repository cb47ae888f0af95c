#include "ui/speech/spoken.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <utility>

namespace farol::ui::spoken {

namespace {

constexpr qsizetype kLongestText = 60;

} // namespace

QString name(const std::string& fromMap) {
    QString text = QString::fromUtf8(fromMap.data(), static_cast<qsizetype>(fromMap.size()));
    text.replace(QLatin1Char('_'), QLatin1Char(' ')); // "Sala_2" as people say it
    text = text.simplified();
    while (text.endsWith(QLatin1Char('.')) || text.endsWith(QLatin1Char(' '))) text.chop(1);
    return text;
}

QString shortened(const std::string& read) {
    const QString text = name(read);
    if (text.size() <= kLongestText) return text;
    const qsizetype space = text.lastIndexOf(QLatin1Char(' '), kLongestText);
    return text.left(space > kLongestText / 2 ? space : kLongestText);
}

QString level(const std::string& fromMap, const QString& levelWord, const QString& minusWord,
              const QString& decimalPoint) {
    QString text = name(fromMap);
    static const QRegularExpression word(QStringLiteral("\\p{L}{3}"));
    const bool isName = text.isEmpty() || word.match(text).hasMatch();
    // Voices read the sign in "Level -1" as a dash, or not at all.
    static const QRegularExpression negative(QStringLiteral("(?<=^|\\s)[-\u2212](\\d\\S*)"));
    if (const auto match = negative.match(text); match.hasMatch())
        text.replace(match.capturedStart(), match.capturedLength(), minusWord.arg(match.captured(1)));
    if (isName) return text;
    // A level without a name, such as 0.5, is a number; voices of other languages read its dot as nothing.
    static const QRegularExpression half(QStringLiteral("^(.*\\d)\\.(\\d)$"));
    if (const auto match = half.match(text); match.hasMatch())
        text = match.captured(1) + decimalPoint + match.captured(2);
    return levelWord.arg(text);
}

QString capitalised(QString text) {
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return text;
}

QString sentence(QString clause) {
    return clause.isEmpty() ? clause : capitalised(std::move(clause)) + QLatin1Char('.');
}

QString joined(const QStringList& sentences) {
    QStringList said = sentences;
    said.removeAll(QString());
    return said.join(QLatin1Char(' '));
}

int metres(const std::optional<double>& distance) {
    if (!distance || !std::isfinite(*distance) || *distance < 0.0 || *distance > 1e6) return 0;
    const int step = *distance < 10.0 ? 1 : *distance < 30.0 ? 5 : *distance < 200.0 ? 10 : 50;
    return std::max(1, static_cast<int>(std::lround(*distance / step)) * step);
}

} // namespace farol::ui::spoken
