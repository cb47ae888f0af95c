#pragma once
// What somebody hears who does not walk as planned, or whose place is not well known: drawn situations, each
// a short play. Together with the walks they show every kind of sentence.

#include <QString>

#include <functional>
#include <string>
#include <vector>

namespace farol::test {

struct GoldenSituation {
    std::string name;              ///< of its file
    std::function<QString()> tell; ///< in the language of the installed translators
};

std::vector<GoldenSituation> goldenSituations();

} // namespace farol::test
