#include "core/building/sayable.h"

#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace farol::building {

namespace {

constexpr std::size_t kMostDigitsInARow = 5; // room numbers have fewer, numbers of databases more
constexpr std::size_t kLongestName = 80;

/// Letters and digits only, in upper case without accents, words with one space between.
std::string wordsOf(const std::string& name) {
    std::string words;
    for (char c : foldedForMatching(name)) {
        bool kept = std::isalnum(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80;
        if (kept)
            words.push_back(c);
        else if (!words.empty() && words.back() != ' ')
            words.push_back(' ');
    }
    while (!words.empty() && words.back() == ' ') words.pop_back();
    return words;
}

bool isDigit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// "room 12" is a name, "region 12" or "polygon12" a drawing program's.
std::string withoutCounter(const std::string& words) {
    std::size_t end = words.find_last_not_of("0123456789 ");
    return end == std::string::npos ? std::string() : words.substr(0, end + 1);
}

bool hasIdentifier(const std::string& name) {
    std::size_t digits = 0, hex = 0;
    bool hexDigit = false, hexLetter = false;
    for (char c : name) {
        digits = isDigit(c) ? digits + 1 : 0;
        if (digits > kMostDigitsInARow || c == '{' || c == '}' || c == '\\') return true;
        bool isHex = std::isxdigit(static_cast<unsigned char>(c)) != 0;
        hex = isHex ? hex + 1 : 0;
        hexDigit = isHex && (hexDigit || isDigit(c));
        hexLetter = isHex && (hexLetter || !isDigit(c));
        if (hex >= 8 && hexDigit && hexLetter) return true;
    }
    return name.find("://") != std::string::npos;
}

} // namespace

bool isPlaceholderName(const std::string& name) {
    static constexpr std::array<std::string_view, 43> kPlaceholders{"INPUT NAME HERE",
                                                                    "ENTER NAME",
                                                                    "ENTER NAME HERE",
                                                                    "NAME",
                                                                    "NAME HERE",
                                                                    "YOUR NAME HERE",
                                                                    "UNNAMED",
                                                                    "UNNAMED ROOM",
                                                                    "UNNAMED SPACE",
                                                                    "UNNAMED REGION",
                                                                    "NO NAME",
                                                                    "NONAME",
                                                                    "SEM NOME",
                                                                    "UNTITLED",
                                                                    "TBD",
                                                                    "TBA",
                                                                    "TODO",
                                                                    "TO DO",
                                                                    "FIXME",
                                                                    "NULL",
                                                                    "NONE",
                                                                    "NAN",
                                                                    "N A",
                                                                    "NA",
                                                                    "NIL",
                                                                    "UNKNOWN",
                                                                    "DESCONHECIDO",
                                                                    "UNDEFINED",
                                                                    "DEFAULT",
                                                                    "XXX",
                                                                    "XX",
                                                                    "NEW REGION",
                                                                    "NEW ROOM",
                                                                    "NEW SPACE",
                                                                    "NEW FEATURE",
                                                                    "PLACEHOLDER",
                                                                    "LOREM IPSUM",
                                                                    "SEM NOME AINDA",
                                                                    "SIN NOMBRE",
                                                                    "SANS NOM",
                                                                    "OHNE NAMEN",
                                                                    "UNBENANNT",
                                                                    "UNDEF"};
    static constexpr std::array<std::string_view, 7> kCounted{"REGION", "POLYGON", "FEATURE", "OBJECT",
                                                              "SHAPE",  "SPACE",   "UNNAMED"};
    std::string words = wordsOf(name);
    if (words.empty()) return true;
    auto among = [](const auto& list, const std::string& text) {
        return std::find(list.begin(), list.end(), text) != list.end();
    };
    return among(kPlaceholders, words) || among(kCounted, withoutCounter(words));
}

bool isSayable(const std::string& name) {
    if (isPlaceholderName(name) || name.size() > kLongestName) return false;
    return !hasIdentifier(name);
}

std::string sayableName(const Region& region, const std::string& language) {
    if (std::string name = nameIn(region, language); isSayable(name)) return name;
    if (isSayable(region.name)) return region.name;
    return isSayable(region.ref) ? region.ref : std::string();
}

} // namespace farol::building
