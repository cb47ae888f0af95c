#pragma once
// The words a map holds, to judge what was read: letters and digits that look alike (O/0, I/1, S/5, B/8, Z/2)
// are told apart by what really stands in the building.

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace farol::recognition {

class Lexicon {
public:
    Lexicon() = default;
    /// Empty words and repeats are left out.
    explicit Lexicon(const std::vector<std::string>& words);

    bool empty() const { return m_words.empty(); }
    /// The word that was meant: the same one but for case, accents and spaces; else the only one that looks
    /// the same; else, for words of six letters and more without digits, the only one that differs in one
    /// letter. Empty when none is, or when it could be several.
    std::optional<std::string> meant(const std::string& reading) const;

private:
    std::map<std::string, std::string> m_words; ///< folded form, and the word as the map writes it
    std::map<std::string, std::vector<std::string>> m_looks; ///< look-alike form, and the folded forms
};

} // namespace farol::recognition
