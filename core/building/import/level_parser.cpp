#include "core/building/import/level_parser.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

namespace farol::building {

namespace {

constexpr double kHighestLevel = 10000.0;

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}
bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// One dash and no blanks, so that the rest reads single characters.
std::string plainDashes(std::string_view text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        std::string_view three = text.substr(i, 3);
        if (three == "\xE2\x88\x92" || three == "\xE2\x80\x93") { // minus sign, en dash
            plain += '-';
            i += 2;
        } else if (!isBlank(text[i])) {
            plain += text[i];
        } else if (!plain.empty() && (isDigit(plain.back()) || plain.back() == ',') && i + 1 < text.size()) {
            plain += ' '; // "1 2" must not become twelve, nor "0, 1" a tenth
        }
    }
    return plain;
}

std::string withoutBlanksBefore(std::string_view part) {
    std::string text(part);
    for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at))
        if (at + 1 == text.size() || !isDigit(text[at + 1]))
            text.erase(at, 1);
        else
            ++at;
    return text;
}

class Part {
public:
    explicit Part(std::string_view text) : m_text(text) {}

    std::optional<double> number() {
        std::size_t start = m_at;
        if (m_at < m_text.size() && m_text[m_at] == '+')
            start = ++m_at;
        else if (m_at < m_text.size() && m_text[m_at] == '-')
            ++m_at;
        std::size_t digits = m_at;
        while (m_at < m_text.size() && (isDigit(m_text[m_at]) || m_text[m_at] == '.')) ++m_at;
        if (m_at == digits) return std::nullopt;
        double value = 0.0;
        const char* end = m_text.data() + m_at;
        auto read = std::from_chars(m_text.data() + start, end, value, std::chars_format::fixed);
        if (read.ec != std::errc() || read.ptr != end || std::abs(value) > kHighestLevel) return std::nullopt;
        return value + 0.0; // "-0" is 0
    }
    bool dash() {
        if (m_at >= m_text.size() || m_text[m_at] != '-') return false;
        ++m_at;
        return true;
    }
    bool done() const { return m_at == m_text.size(); }

private:
    std::string_view m_text;
    std::size_t m_at = 0;
};

bool appendPart(std::string_view text, std::vector<double>& levels) {
    Part part(text);
    auto first = part.number();
    if (!first) return false;
    auto last = first;
    if (part.dash()) last = part.number();
    if (!last || !part.done()) return false;
    double low = std::min(*first, *last), high = std::max(*first, *last);
    if (high - low > static_cast<double>(kMaxLevelsPerValue)) return false;
    levels.push_back(low);
    for (double level = std::floor(low) + 1.0; level < high; level += 1.0) levels.push_back(level);
    if (high > low) levels.push_back(high);
    return true;
}

/// The part between two ';': commas are decimal signs or separators.
bool appendCommaPart(std::string part, std::vector<double>& levels) {
    std::size_t decimals = 0;
    auto isDecimal = [&part](std::size_t at) {
        return at > 0 && at + 1 < part.size() && isDigit(part[at - 1]) && isDigit(part[at + 1]);
    };
    for (std::size_t at = 0; at < part.size(); ++at) decimals += part[at] == ',' && isDecimal(at) ? 1U : 0U;
    if (std::size_t at = part.find(','); decimals == 1 && std::count(part.begin(), part.end(), ',') == 1)
        part[at] = '.';
    bool understood = true;
    for (std::size_t start = 0; start <= part.size();) {
        std::size_t end = std::min(part.find(',', start), part.size());
        std::string_view whole = std::string_view(part).substr(start, end - start);
        std::string piece =
            withoutBlanksBefore(whole.substr(std::min(whole.find_first_not_of(' '), whole.size())));
        if (levels.size() > kMaxLevelsPerValue) return false;
        if (!piece.empty()) understood = appendPart(piece, levels) && understood;
        start = end + 1;
    }
    return understood;
}

} // namespace

ParsedLevels parseLevels(std::string_view text) {
    ParsedLevels parsed;
    std::string plain = plainDashes(text);
    for (std::size_t start = 0; start <= plain.size();) {
        std::size_t end = std::min(plain.find(';', start), plain.size());
        parsed.understood =
            appendCommaPart(plain.substr(start, end - start), parsed.levels) && parsed.understood;
        if (parsed.levels.size() > kMaxLevelsPerValue) return {{}, false};
        start = end + 1;
    }
    std::sort(parsed.levels.begin(), parsed.levels.end());
    parsed.levels.erase(std::unique(parsed.levels.begin(), parsed.levels.end()), parsed.levels.end());
    return parsed;
}

} // namespace farol::building
