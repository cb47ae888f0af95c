#pragma once
// What core says of a map, in the user's language. Core gives the sentence and what stands in its places; its
// English text serves the command line alone.

#include "core/base/error.h"
#include "core/building/sentence.h"

#include <QString>

#include <string>

namespace farol::ui {

class CoreWords {
public:
    /// As it stands in the table: to be put behind another text.
    static QString phrase(const building::Message& message);
    /// A sentence of its own, from its capital to its stop.
    static QString sentence(const building::Message& message);
    /// One of a finding's ids. Where a source gives none, core makes one of words.
    static QString id(const std::string& id);
    /// Why something cannot be done, and where. Errors hold their English only, so their sentence is
    /// known by it; what no table of ours holds (a library's own complaint) stays as it is.
    static QString problem(const Error& error);
    /// One of a LoadedBuilding's warnings, known in the same way.
    static QString remark(const std::string& warning);
    /// What is told of a source while it is read: the sentence alone, as core puts it.
    static QString message(const std::string& english);
};

} // namespace farol::ui
