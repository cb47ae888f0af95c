#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <numeric>
#include <vector>

namespace farol {

namespace {

/// Malformed bytes count as one code point each, so that no input can derail a comparison.
std::u32string decoded(std::string_view text) {
    std::u32string points;
    for (std::size_t i = 0; i < text.size();) {
        auto lead = static_cast<unsigned char>(text[i]);
        std::size_t extra = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : lead >= 0xC0 ? 1 : 0;
        char32_t point = extra == 0 ? lead : lead & (0x3FU >> extra);
        bool whole = i + extra < text.size();
        for (std::size_t k = 1; whole && k <= extra; ++k) {
            auto next = static_cast<unsigned char>(text[i + k]);
            whole = (next & 0xC0U) == 0x80U;
            point = (point << 6U) | (next & 0x3FU);
        }
        points.push_back(whole ? point : lead);
        i += whole ? extra + 1 : 1;
    }
    return points;
}

/// The base letters of U+00C0 to U+00FF in upper case; a dot keeps the code point as it is.
constexpr std::string_view kLatin1Base = "AAAAAA.CEEEEIIII.NOOOOO.OUUUUY..AAAAAA.CEEEEIIII.NOOOOO.OUUUUY.Y";

void appendUtf8(std::string& out, char32_t point) {
    auto byte = [&](char32_t value) { out.push_back(static_cast<char>(static_cast<unsigned char>(value))); };
    if (point < 0x80) {
        byte(point);
    } else if (point < 0x800) {
        byte(0xC0 | (point >> 6));
        byte(0x80 | (point & 0x3F));
    } else if (point < 0x10000) {
        byte(0xE0 | (point >> 12));
        byte(0x80 | ((point >> 6) & 0x3F));
        byte(0x80 | (point & 0x3F));
    } else {
        byte(0xF0 | (point >> 18));
        byte(0x80 | ((point >> 12) & 0x3F));
        byte(0x80 | ((point >> 6) & 0x3F));
        byte(0x80 | (point & 0x3F));
    }
}

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

} // namespace

int editDistance(std::string_view a, std::string_view b) {
    std::u32string from = decoded(a);
    std::u32string to = decoded(b);
    std::vector<int> row(to.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 1; i <= from.size(); ++i) {
        int diagonal = row[0];
        row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= to.size(); ++j) {
            int above = row[j];
            row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (from[i - 1] == to[j - 1] ? 0 : 1)});
            diagonal = above;
        }
    }
    return row.back();
}

std::string foldedForMatching(std::string_view text) {
    std::string folded;
    bool pendingSpace = false;
    for (char32_t point : decoded(text)) {
        if (point == 0xA0 || (point < 0x80 && std::isspace(static_cast<int>(point)) != 0)) {
            pendingSpace = !folded.empty();
            continue;
        }
        if (pendingSpace) folded.push_back(' ');
        pendingSpace = false;
        if (point < 0x80) {
            folded.push_back(static_cast<char>(std::toupper(static_cast<int>(point))));
        } else if (point >= 0xC0 && point <= 0xFF && kLatin1Base[point - 0xC0] != '.') {
            folded.push_back(kLatin1Base[point - 0xC0]);
        } else {
            appendUtf8(folded, point);
        }
    }
    return folded;
}

bool naturalLess(std::string_view a, std::string_view b) {
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() && j < b.size()) {
        if (isDigit(a[i]) && isDigit(b[j])) {
            auto number = [](std::string_view text, std::size_t& at) {
                while (at < text.size() && text[at] == '0') ++at;
                std::size_t start = at;
                while (at < text.size() && isDigit(text[at])) ++at;
                return text.substr(start, at - start);
            };
            std::string_view x = number(a, i);
            std::string_view y = number(b, j);
            if (x.size() != y.size()) return x.size() < y.size();
            if (x != y) return x < y;
        } else if (a[i] != b[j]) {
            return static_cast<unsigned char>(a[i]) < static_cast<unsigned char>(b[j]);
        } else {
            ++i;
            ++j;
        }
    }
    if ((i < a.size()) != (j < b.size())) return j < b.size();
    return a < b; // "01" and "1": equal in value, still a strict order
}

std::string formatNumber(double value) {
    std::array<char, 40> buffer{};
    auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return std::string(buffer.data(), result.ptr);
}

} // namespace farol
