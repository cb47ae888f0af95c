// The lines of a `locate` log.

#include "core/session/json_lines.h"
#include "core/session/place_json.h"

#include <limits>
#include <set>

namespace farol::session {

namespace {

constexpr std::int64_t kMostFrames = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t kMostPixels = 1'000'000;

ImageSize readSize(JsonFields& fields, const char* key) {
    std::vector<double> size = fields.numbers(key, 2);
    bool sane =
        size[0] >= 1.0 && size[1] >= 1.0 && size[0] <= double(kMostPixels) && size[1] <= double(kMostPixels);
    if (!sane) {
        fields.complain(std::string("\"") + key + "\" is not a picture's [width, height] in pixels");
        return {};
    }
    return {static_cast<int>(size[0]), static_cast<int>(size[1])};
}

Quad readOutline(JsonFields& fields) {
    std::vector<double> box = fields.numbers("box", 4);
    if (box[2] < 0.0 || box[3] < 0.0) fields.complain("\"box\" has a negative width or height");
    return fields.has("quad") ? fields.quad("quad") : quadOf({box[0], box[1], box[2], box[3]});
}

Result<LogLine> readDetection(JsonFields& fields, double time) {
    LogDetection line;
    recognition::Detection detection;
    std::string word = fields.text("kind");
    if (auto kind = kindFromName(word)) {
        detection.kind = *kind;
    } else {
        line.unknownKind = word;
    }
    detection.templateId = TemplateId(fields.textOr("template", ""));
    detection.text = fields.textOr("text", "");
    detection.quad = readOutline(fields);
    detection.image = readSize(fields, "image");
    detection.score = fields.numberOr("score", 1.0);
    if (detection.score < 0.0 || detection.score > 1.0) fields.complain("\"score\" is not between 0 and 1");
    readLookAlikes(fields, detection);
    detection.rangeM = fields.optionalNumber("range_m");
    if (detection.rangeM && *detection.rangeM < 0.0) fields.complain("\"range_m\" is negative");
    detection.rangeSpread = fields.optionalNumber("range_spread");
    if (detection.rangeSpread && *detection.rangeSpread < 0.0)
        fields.complain("\"range_spread\" is negative");
    if (auto bearing = fields.optionalNumber("bearing_deg")) detection.bearing = fromDegrees(*bearing);
    detection.track = static_cast<std::uint64_t>(fields.integerOr("track", 0, kMostFrames, 0));
    detection.confirmations =
        static_cast<int>(fields.integerOr("confirmations", 0, std::numeric_limits<int>::max(), 1));
    line.percept.time = time;
    line.frameGiven = fields.has("frame");
    line.percept.frame = static_cast<std::uint64_t>(fields.integerOr("frame", 0, kMostFrames, 0));
    line.percept.scene = static_cast<int>(fields.integerOr("scene", 0, std::numeric_limits<int>::max(), 0));
    line.percept.size = detection.image;
    line.percept.detections.push_back(std::move(detection));
    if (!fields.ok()) return fields.error();
    return LogLine(std::move(line));
}

Result<LogLine> readMotion(JsonFields& fields, double time) {
    JsonFields motion(fields.object("motion"));
    LogMotion line{time, {}};
    if (auto turn = motion.optionalNumber("turn_deg")) line.motion.turn = fromDegrees(*turn);
    line.motion.speed = motion.optionalNumber("speed");
    if (line.motion.speed && *line.motion.speed < 0.0) motion.complain("\"speed\" is negative");
    if (!motion.ok()) fields.complain("in \"motion\": " + motion.wrong());
    if (!fields.ok()) return fields.error();
    return LogLine(line);
}

bool isLineOfRun(const std::string& type) {
    static const std::set<std::string> kTypes{"frame", "fix", "progress", "cue", "utterance", "warning"};
    return kTypes.count(type) != 0;
}

} // namespace

Result<LogLine> parseLogLine(const std::string& text) {
    auto json = parsedJson(text);
    if (!json)
        return Error{ErrorCode::Corrupt, "is not JSON (numbers such as NaN are not allowed either)", ""};
    JsonFields fields(*json);
    double time = fields.number("t");
    std::string type = fields.textOr("type", "detection");
    if (!fields.ok()) return fields.error();
    if (isLineOfRun(type)) return LogLine(LogOther{time});
    if (type != "detection") return Error{ErrorCode::Corrupt, "has the unknown \"type\" " + type, ""};
    if (json->contains("start")) {
        std::string region = fields.textOr("start", "");
        if (!fields.ok()) return fields.error();
        return LogLine(LogStart{time, region.empty() ? std::nullopt : std::optional(RegionId(region))});
    }
    if (json->contains("to")) {
        std::string where = fields.text("to");
        if (!fields.ok()) return fields.error();
        return LogLine(LogDestination{time, where});
    }
    if (json->contains("motion")) return readMotion(fields, time);
    if (json->contains("kind")) return readDetection(fields, time);
    return Error{ErrorCode::Corrupt, "is neither a detection (\"kind\") nor \"start\", \"to\" or \"motion\"",
                 ""};
}

} // namespace farol::session
