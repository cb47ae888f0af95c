#pragma once
// Small text helpers on UTF-8.

#include <string>
#include <string_view>

namespace farol {

/// Levenshtein distance between the code points of two UTF-8 strings.
int editDistance(std::string_view a, std::string_view b);
/// The form in which names are compared: trimmed, single spaces, ASCII and Latin-1 letters in upper case
/// without accents. "  Sortié " becomes "SORTIE".
std::string foldedForMatching(std::string_view text);
/// Natural order of file names: digits compare by value, so 2.jpg stands before 10.jpg.
bool naturalLess(std::string_view a, std::string_view b);
/// A number in the shortest form that reads back the same, with a point whatever the locale ("0.5", "-2").
std::string formatNumber(double value);

} // namespace farol
