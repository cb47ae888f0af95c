#pragma once
// Small parts of sentences that need no translation.

#include <QString>
#include <QStringList>

#include <optional>
#include <string>

namespace farol::ui::spoken {

/// A name from the map as it can stand inside a sentence: one line, no stop at its end.
QString name(const std::string& fromMap);
/// What was read on a wall, which can be a whole notice, cut at a word.
QString shortened(const std::string& read);
/// A level as people say it: "Floor 2" stays, "2" becomes "level 2" and "-1" "level minus 1".
QString level(const std::string& fromMap, const QString& levelWord, const QString& minusWord,
              const QString& decimalPoint);
QString capitalised(QString text);
/// A clause as a sentence: upper case in front, a stop behind.
QString sentence(QString clause);
/// The sentences that are not empty, with spaces.
QString joined(const QStringList& sentences);
/// Metres as one says them: coarser the farther it is. 0 when there is nothing to say.
int metres(const std::optional<double>& distance);

} // namespace farol::ui::spoken
