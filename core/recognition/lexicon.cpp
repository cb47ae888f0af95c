#include "core/recognition/lexicon.h"

#include "core/base/text.h"

#include <algorithm>
#include <cctype>

namespace farol::recognition {

namespace {

/// Upper case without accents and spaces.
std::string folded(const std::string& word) {
    std::string out = foldedForMatching(word);
    std::erase(out, ' ');
    return out;
}

/// One sign for all that look alike.
std::string looks(const std::string& folded) {
    std::string out = folded;
    for (char& c : out) {
        switch (c) {
        case 'O':
        case 'Q':
            c = '0';
            break;
        case 'I':
        case 'L':
        case '|':
            c = '1';
            break;
        case 'S':
            c = '5';
            break;
        case 'B':
            c = '8';
            break;
        case 'Z':
            c = '2';
            break;
        case ',':
            c = '.';
            break;
        default:
            break;
        }
    }
    return out;
}

bool wordLike(const std::string& text) {
    return text.size() >= 6 && std::none_of(text.begin(), text.end(), [](char c) {
               return std::isdigit(static_cast<unsigned char>(c)) != 0;
           });
}

} // namespace

Lexicon::Lexicon(const std::vector<std::string>& words) {
    for (const std::string& word : words) {
        std::string key = folded(word);
        if (key.empty() || !m_words.emplace(key, word).second) continue;
        m_looks[looks(key)].push_back(key);
    }
}

std::optional<std::string> Lexicon::meant(const std::string& reading) const {
    std::string key = folded(reading);
    if (auto same = m_words.find(key); same != m_words.end()) return same->second;
    auto alike = m_looks.find(looks(key));
    if (alike != m_looks.end())
        return alike->second.size() == 1 ? std::optional(m_words.at(alike->second.front())) : std::nullopt;
    if (!wordLike(key)) return std::nullopt;
    std::optional<std::string> near;
    for (const auto& [other, word] : m_words) {
        if (!wordLike(other) || editDistance(key, other) > 1) continue;
        if (near) return std::nullopt;
        near = word;
    }
    return near;
}

} // namespace farol::recognition
