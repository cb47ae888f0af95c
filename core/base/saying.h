#pragma once
// How a module of core keeps what it says in its errors: one table of English sentences with places (%1, %2,
// ...) for what differs. Errors hold their English only; the workstation knows the sentence by it again and
// says it in the user's language (ui/models/core_words).

#include <cstddef>
#include <string>
#include <vector>

// A name that lupdate is told of (cmake/FarolTranslations.cmake).
#define SAID(context, english) english

namespace farol {

/// One row. The name is an enumerator of the module, and tables are in the order of their enumeration.
template <class Name>
struct Saying {
    Name name;
    const char* english;
};

template <class Name, std::size_t N>
constexpr bool inOrder(const Saying<Name> (&table)[N]) {
    for (std::size_t i = 0; i < N; ++i)
        if (static_cast<std::size_t>(table[i].name) != i) return false;
    return true;
}

template <class Name, std::size_t N>
std::vector<const char*> englishOf(const Saying<Name> (&table)[N]) {
    std::vector<const char*> texts;
    for (const Saying<Name>& row : table) texts.push_back(row.english);
    return texts;
}

/// Each %1, %2, ... of the text replaced once; what is put in is not looked at again.
std::string withPlaces(const std::string& text, const std::vector<std::string>& places);

} // namespace farol
