#include "core/recognition/network_detector.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <set>

namespace farol::recognition {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostBytes = 1U << 20U;
constexpr std::size_t kMostClasses = 1000;
constexpr int kLeastSide = 16, kMostSide = 2048;

/// Reads named values and remembers the first thing that is wrong.
class Reader {
public:
    explicit Reader(const std::filesystem::path& where) : m_where(where.string()) {}

    void fail(const std::string& name, const std::string& message,
              ErrorCode code = ErrorCode::InvalidArgument) {
        if (!m_error) m_error = Error{code, message, m_where + (name.empty() ? "" : ", \"" + name + "\"")};
    }

    const Json* object(const Json& in, const std::string& name) {
        auto at = in.find(name);
        if (at != in.end() && at->is_object()) return &*at;
        fail(name, at == in.end() ? "is missing" : "must be an object in braces");
        return nullptr;
    }

    /// The text, or `otherwise`; without one it must be there.
    std::string word(const Json& in, const std::string& name, const std::optional<std::string>& otherwise) {
        auto at = in.find(name);
        if (at == in.end() && otherwise) return *otherwise;
        if (at != in.end() && at->is_string() && !at->get_ref<const std::string&>().empty())
            return at->get<std::string>();
        fail(name, at == in.end() ? "is missing" : "must be a text in quotes");
        return {};
    }

    bool choice(const Json& in, const std::string& name, const char* yes, const char* no,
                const std::optional<std::string>& otherwise) {
        std::string value = word(in, name, otherwise);
        if (!m_error && value != yes && value != no)
            fail(name, "\"" + value + "\" is not known; it is \"" + yes + "\" or \"" + no + "\"");
        return value == yes;
    }

    double number(const Json& in, const std::string& name, std::optional<double> otherwise, double least,
                  double most, const std::string& rule) {
        auto at = in.find(name);
        if (at == in.end() && otherwise) return *otherwise;
        double value = at != in.end() && at->is_number() ? at->get<double>() : std::nan("");
        if (at == in.end())
            fail(name, "is missing");
        else if (!(value >= least && value <= most))
            fail(name, rule);
        return value;
    }

    int side(const Json& in, const std::string& name) {
        std::string rule = "must be a whole number of pixels from " + std::to_string(kLeastSide) + " to " +
                           std::to_string(kMostSide);
        double value = number(in, name, std::nullopt, kLeastSide, kMostSide, rule);
        if (!m_error && value != std::floor(value)) fail(name, rule);
        return m_error ? 0 : static_cast<int>(value);
    }

    /// A misspelt name would otherwise be a value silently left at its usual one.
    void onlyNames(const Json& in, const std::string& of, const std::set<std::string>& known) {
        for (const auto& [name, value] : in.items())
            if (known.count(name) == 0) fail(of.empty() ? name : of + "." + name, "is not a known name");
    }

    const std::optional<Error>& error() const { return m_error; }

private:
    std::string m_where;
    std::optional<Error> m_error;
};

void readInput(const Json& input, DetectorDescription& description, Reader& reader) {
    reader.onlyNames(input, "input", {"width", "height", "scale", "mean", "channels", "fit"});
    description.width = reader.side(input, "width");
    description.height = reader.side(input, "height");
    description.scale = reader.number(input, "scale", 1.0 / 255.0, 1e-6, 1e3,
                                      "must be a number from 0.000001 to 1000; 0.00392157 is 1/255");
    description.redFirst = reader.choice(input, "channels", "rgb", "bgr", "rgb");
    description.letterbox = reader.choice(input, "fit", "letterbox", "stretch", "letterbox");
    auto mean = input.find("mean");
    if (mean == input.end()) return;
    if (!mean->is_array() || mean->size() != 3) {
        reader.fail("mean", "must be three numbers in brackets, one for each channel");
        return;
    }
    for (int i = 0; i < 3; ++i) {
        const Json& one = (*mean)[static_cast<std::size_t>(i)];
        double value = one.is_number() ? one.get<double>() : std::nan("");
        if (!(std::abs(value) <= 1000.0)) reader.fail("mean", "must be three numbers from -1000 to 1000");
        description.mean[i] = value;
    }
}

std::string knownKinds() {
    std::string names;
    for (Kind kind : allKinds()) names += (names.empty() ? "" : ", ") + std::string(kindName(kind));
    return names;
}

void readClasses(const Json& whole, DetectorDescription& description, Reader& reader) {
    auto classes = whole.find("classes");
    if (classes == whole.end() || !classes->is_array() || classes->empty() ||
        classes->size() > kMostClasses) {
        reader.fail("classes", "must be a list of 1 to " + std::to_string(kMostClasses) +
                                   " classes, in the order of the network");
        return;
    }
    for (std::size_t i = 0; i < classes->size(); ++i) {
        const Json& one = (*classes)[i];
        std::string at = "classes[" + std::to_string(i) + "]";
        if (!one.is_object()) {
            reader.fail(at, "must be an object in braces with a name and a kind");
            return;
        }
        reader.onlyNames(one, at, {"name", "kind"});
        DetectorDescription::Class made{reader.word(one, "name", std::nullopt), std::nullopt};
        auto kind = one.find("kind");
        if (kind == one.end() || !(kind->is_null() || kind->is_string())) {
            reader.fail(at + ".kind", "must be a kind in quotes, or null for a class that is not told");
        } else if (kind->is_string()) {
            made.kind = kindFromName(kind->get_ref<const std::string&>());
            if (!made.kind)
                reader.fail(at + ".kind", "\"" + kind->get<std::string>() +
                                              "\" is not a known kind; there are " + knownKinds());
        }
        description.classes.push_back(std::move(made));
    }
}

} // namespace

Result<DetectorDescription> DetectorDescription::parse(std::string_view json,
                                                       const std::filesystem::path& where) {
    Reader reader(where);
    if (json.size() > kMostBytes) {
        reader.fail("", "is far too long for the description of a detector", ErrorCode::UnsupportedFormat);
        return *reader.error();
    }
    Json whole = Json::parse(json, nullptr, false);
    if (whole.is_discarded() || !whole.is_object()) {
        reader.fail("", "is not the description of a detector: JSON with braces round all of it is expected",
                    ErrorCode::UnsupportedFormat);
        return *reader.error();
    }
    reader.onlyNames(whole, "", {"model", "input", "layout", "classes", "score", "nms"});
    DetectorDescription description;
    std::filesystem::path model = reader.word(whole, "model", std::nullopt);
    description.model = model.is_absolute() ? model : where.parent_path() / model;
    if (const Json* input = reader.object(whole, "input")) readInput(*input, description, reader);
    description.layout =
        reader.choice(whole, "layout", "yolo", "ssd", std::nullopt) ? Layout::Yolo : Layout::Ssd;
    readClasses(whole, description, reader);
    description.minScore = reader.number(whole, "score", 0.5, 0.01, 1.0, "must be a number from 0.01 to 1");
    description.maxOverlap = reader.number(whole, "nms", 0.45, 0.0, 1.0, "must be a number from 0 to 1");
    if (reader.error()) return *reader.error();
    return description;
}

} // namespace farol::recognition
