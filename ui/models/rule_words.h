#pragma once
// What the rules of the map check and of the importers mean, and what to do about them.

#include <QCoreApplication>
#include <QString>

#include <string>

namespace farol::ui {

class RuleWords {
    Q_DECLARE_TR_FUNCTIONS(farol::ui::RuleWords)

public:
    /// Never empty: a rule without words of its own is called by what its first word says.
    static QString title(const std::string& rule);
    static QString fix(const std::string& rule); ///< empty where nothing is to be done
    static bool knows(const std::string& rule);
};

} // namespace farol::ui
