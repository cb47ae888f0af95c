#include "core/base/database_source.h"

#include "core/base/base_sayings.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace farol {

namespace {

using Word = std::pair<std::string, std::string>; // key and value
using Words = std::vector<Word>;

bool startsWith(const std::string& text, const std::string& start) {
    return text.size() >= start.size() &&
           std::equal(start.begin(), start.end(), text.begin(), [](char a, char b) {
               return std::tolower(static_cast<unsigned char>(a)) ==
                      std::tolower(static_cast<unsigned char>(b));
           });
}

bool isAddress(const std::string& source) {
    return startsWith(source, "postgresql://") || startsWith(source, "postgres://") ||
           startsWith(source, "PG:postgres");
}

const std::set<std::string>& shownKeys() {
    static const std::set<std::string> keys{"dbname",  "host",    "hostaddr",      "port",  "user",
                                            "service", "schemas", "active_schema", "tables"};
    return keys;
}

const std::set<std::string>& hiddenKeys() {
    static const std::set<std::string> keys{"password",
                                            "passfile",
                                            "sslpassword",
                                            "sslmode",
                                            "sslcert",
                                            "sslkey",
                                            "sslrootcert",
                                            "sslcrl",
                                            "sslcrldir",
                                            "sslsni",
                                            "sslcompression",
                                            "requirepeer",
                                            "channel_binding",
                                            "connect_timeout",
                                            "client_encoding",
                                            "options",
                                            "application_name",
                                            "fallback_application_name",
                                            "keepalives",
                                            "keepalives_idle",
                                            "keepalives_interval",
                                            "keepalives_count",
                                            "tcp_user_timeout",
                                            "gssencmode",
                                            "krbsrvname",
                                            "gsslib",
                                            "target_session_attrs",
                                            "ssl_min_protocol_version",
                                            "ssl_max_protocol_version",
                                            "preludestatements",
                                            "closingstatements"};
    return keys;
}

bool isBlank(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

/// key=value pairs as the driver reads them: values in single quotes may hold blanks, a backslash takes the
/// next character as it is.
class WordReader {
public:
    explicit WordReader(const std::string& text) : m_text(text) {}

    std::optional<Words> read() {
        Words words;
        for (skip(); m_at < m_text.size(); skip()) {
            std::string key;
            while (m_at < m_text.size() && !isBlank(m_text[m_at]) && m_text[m_at] != '=')
                key += m_text[m_at++];
            skip();
            if (key.empty() || m_at >= m_text.size() || m_text[m_at] != '=') return std::nullopt;
            ++m_at;
            skip();
            std::string value;
            if (!readValue(value)) return std::nullopt;
            if (shownKeys().count(key) + hiddenKeys().count(key) == 0) return std::nullopt;
            words.emplace_back(std::move(key), std::move(value));
        }
        return words;
    }

private:
    void skip() {
        while (m_at < m_text.size() && isBlank(m_text[m_at])) ++m_at;
    }
    bool readValue(std::string& value) {
        bool quoted = m_at < m_text.size() && m_text[m_at] == '\'';
        if (quoted) ++m_at;
        while (m_at < m_text.size() && (quoted ? m_text[m_at] != '\'' : !isBlank(m_text[m_at]))) {
            if (m_text[m_at] == '\\' && m_at + 1 < m_text.size()) ++m_at;
            value += m_text[m_at++];
        }
        if (!quoted) return true;
        return m_at < m_text.size() && m_text[m_at++] == '\'';
    }

    const std::string& m_text;
    std::size_t m_at = 0;
};

std::optional<Words> wordsOf(const std::string& source) {
    if (isAddress(source) || !startsWith(source, "PG:")) return std::nullopt;
    return WordReader(source.substr(3)).read();
}

std::string quotedWhereNeeded(const std::string& value) {
    bool plain = !value.empty() && std::none_of(value.begin(), value.end(),
                                                [](char c) { return isBlank(c) || c == '\'' || c == '\\'; });
    return plain ? value : "'" + value + "'";
}

void replaceAll(std::string& text, const std::string& what, const std::string& by) {
    if (what.empty()) return;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
}

} // namespace

bool isDatabase(const std::string& source) {
    return startsWith(source, "PG:") || isAddress(source);
}

std::string shownSource(const std::string& source) {
    if (!isDatabase(source)) return source;
    auto words = wordsOf(source);
    std::string shown;
    if (words)
        for (const auto& [key, value] : *words)
            if (shownKeys().count(key) != 0)
                shown += (shown.empty() ? "" : " ") + key + "=" + quotedWhereNeeded(value);
    return shown.empty() ? "the database" : "PG:" + shown;
}

Result<std::string> checkedConnection(const std::string& source) {
    auto words = wordsOf(source);
    if (!words)
        return Error{ErrorCode::InvalidArgument, said(BaseSaying::ConnectionUnclear), shownSource(source)};
    bool bounded = std::any_of(words->begin(), words->end(),
                               [](const Word& word) { return word.first == "connect_timeout"; });
    return "PG:" + source.substr(3) + (bounded ? "" : " connect_timeout=10");
}

std::string withoutSecrets(std::string text, const std::string& source) {
    if (!isDatabase(source)) return text;
    replaceAll(text, source, shownSource(source));
    if (auto words = wordsOf(source))
        for (const auto& [key, value] : *words)
            if (key == "password" || key == "sslpassword") replaceAll(text, value, "***");
    return text;
}

} // namespace farol
