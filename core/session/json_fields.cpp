#include "core/session/json_fields.h"

#include <cmath>
#include <limits>

namespace farol::session {

namespace {

const Json& emptyArray() {
    static const Json json = Json::array();
    return json;
}

const Json& emptyObject() {
    static const Json json = Json::object();
    return json;
}

std::string quoted(const char* key) {
    return std::string("\"") + key + "\"";
}

} // namespace

JsonFields::JsonFields(const Json& object) : m_object(object) {
    if (!object.is_object()) complain("is not a JSON object");
}

const Json* JsonFields::find(const char* key) const {
    if (!m_object.is_object()) return nullptr;
    auto it = m_object.find(key);
    return it == m_object.end() || it->is_null() ? nullptr : &*it;
}

bool JsonFields::has(const char* key) const {
    return find(key) != nullptr;
}

void JsonFields::complain(const std::string& sentence) {
    if (m_wrong.empty()) m_wrong = sentence;
}

std::optional<double> JsonFields::optionalNumber(const char* key) {
    const Json* value = find(key);
    if (value == nullptr) return std::nullopt;
    if (!value->is_number() || !std::isfinite(value->get<double>())) {
        complain(quoted(key) + " is not a finite number");
        return std::nullopt;
    }
    return value->get<double>();
}

double JsonFields::numberOr(const char* key, double fallback) {
    return optionalNumber(key).value_or(fallback);
}

double JsonFields::number(const char* key) {
    if (!has(key)) complain(quoted(key) + " is missing");
    return numberOr(key, 0.0);
}

std::int64_t JsonFields::integerOr(const char* key, std::int64_t low, std::int64_t high,
                                   std::int64_t fallback) {
    const Json* value = find(key);
    if (value == nullptr) return fallback;
    // A number beyond 63 bits is stored as unsigned and would wrap.
    bool whole = value->is_number_unsigned()
                     ? value->get<std::uint64_t>() <=
                           static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())
                     : value->is_number_integer();
    if (whole) {
        auto number = value->get<std::int64_t>();
        if (number >= low && number <= high) return number;
    }
    complain(quoted(key) + " is not a whole number from " + std::to_string(low) + " on that fits");
    return fallback;
}

std::int64_t JsonFields::integer(const char* key, std::int64_t low, std::int64_t high) {
    if (!has(key)) complain(quoted(key) + " is missing");
    return integerOr(key, low, high, low);
}

bool JsonFields::flagOr(const char* key, bool fallback) {
    const Json* value = find(key);
    if (value == nullptr) return fallback;
    if (value->is_boolean()) return value->get<bool>();
    complain(quoted(key) + " is neither true nor false");
    return fallback;
}

std::string JsonFields::textOr(const char* key, const std::string& fallback) {
    const Json* value = find(key);
    if (value == nullptr) return fallback;
    if (value->is_string()) return value->get<std::string>();
    complain(quoted(key) + " is not text");
    return fallback;
}

std::string JsonFields::text(const char* key) {
    if (!has(key)) complain(quoted(key) + " is missing");
    return textOr(key, "");
}

const Json& JsonFields::array(const char* key) {
    const Json* value = find(key);
    if (value == nullptr) return emptyArray();
    if (value->is_array()) return *value;
    complain(quoted(key) + " is not a list");
    return emptyArray();
}

const Json& JsonFields::object(const char* key) {
    const Json* value = find(key);
    if (value == nullptr) return emptyObject();
    if (value->is_object()) return *value;
    complain(quoted(key) + " is not an object");
    return emptyObject();
}

std::vector<double> JsonFields::numbers(const char* key, std::size_t count) {
    std::vector<double> values;
    for (const Json& value : array(key)) {
        if (values.size() == count || !value.is_number() || !std::isfinite(value.get<double>())) {
            values.clear();
            break;
        }
        values.push_back(value.get<double>());
    }
    if (values.size() != count) {
        complain(quoted(key) + " is not a list of " + std::to_string(count) + " finite numbers");
        values.assign(count, 0.0);
    }
    return values;
}

Quad JsonFields::quad(const char* key) {
    Quad corners{};
    const Json& list = array(key);
    bool whole = list.size() == corners.size();
    for (std::size_t i = 0; whole && i < corners.size(); ++i) {
        const Json& corner = list[i];
        whole = corner.is_array() && corner.size() == 2 && corner[0].is_number() && corner[1].is_number();
        if (whole) corners[i] = {corner[0].get<double>(), corner[1].get<double>()};
        whole = whole && std::isfinite(corners[i].x) && std::isfinite(corners[i].y);
    }
    if (!whole) complain(quoted(key) + " is not a list of four corners [x, y]");
    return corners;
}

std::string dumped(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json exactNumber(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json printedNumber(double value) {
    double scaled = value * 1000.0;
    if (!std::isfinite(scaled)) return exactNumber(value);
    double rounded = std::round(scaled) / 1000.0;
    return rounded == 0.0 ? Json(0.0) : Json(rounded); // never "-0.0"
}

std::optional<Json> parsedJson(const std::string& text) {
    Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) return std::nullopt;
    return json;
}

} // namespace farol::session
