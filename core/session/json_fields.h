#pragma once
// Reads fields of a JSON object that somebody else wrote: the first thing that is wrong is kept as a
// sentence, later reads answer something harmless, and the caller asks once at the end.

#include "core/base/error.h"
#include "core/base/geometry.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace farol::session {

using Json = nlohmann::ordered_json;

class JsonFields {
public:
    explicit JsonFields(const Json& object);

    bool has(const char* key) const; ///< present and not null
    double number(const char* key);
    double numberOr(const char* key, double fallback);
    std::optional<double> optionalNumber(const char* key);
    std::int64_t integer(const char* key, std::int64_t low, std::int64_t high);
    std::int64_t integerOr(const char* key, std::int64_t low, std::int64_t high, std::int64_t fallback);
    bool flagOr(const char* key, bool fallback);
    std::string text(const char* key);
    std::string textOr(const char* key, const std::string& fallback); ///< also for null
    /// Exactly `count` finite numbers.
    std::vector<double> numbers(const char* key, std::size_t count);
    Quad quad(const char* key);          ///< [[x,y] x 4]
    const Json& array(const char* key);  ///< an empty array when it is none
    const Json& object(const char* key); ///< an empty object when it is none

    void complain(const std::string& sentence); ///< the first one stays
    bool ok() const { return m_wrong.empty(); }
    const std::string& wrong() const { return m_wrong; }
    Error error() const { return {ErrorCode::Corrupt, m_wrong, ""}; }

private:
    const Json* find(const char* key) const; ///< nullptr when missing or null

    const Json& m_object;
    std::string m_wrong;
};

/// Shortest text that reads back the same; bytes that are no UTF-8 (a file name) become replacement
/// characters.
std::string dumped(const Json& json);
/// A finite number with all its digits, else null.
Json exactNumber(double value);
/// Rounded to three decimals for people and scripts; null when not finite.
Json printedNumber(double value);

/// Empty for text that is no JSON; no exception leaves this function.
std::optional<Json> parsedJson(const std::string& text);

} // namespace farol::session
