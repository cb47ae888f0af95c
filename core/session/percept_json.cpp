// Percepts with every digit, as recordings keep them.

#include "core/session/json_lines.h"
#include "core/session/place_json.h"

#include <limits>

namespace farol::session {

namespace {

constexpr std::int64_t kMostInt = std::numeric_limits<int>::max();
constexpr std::int64_t kMostTracks = std::numeric_limits<std::int64_t>::max();

Json exactQuad(const Quad& quad) {
    Json json = Json::array();
    for (ImagePoint corner : quad)
        json.push_back(Json::array({exactNumber(corner.x), exactNumber(corner.y)}));
    return json;
}

Json sizeJson(ImageSize size) {
    return Json::array({size.width, size.height});
}

ImageSize sizeFrom(JsonFields& fields, const char* key) {
    std::vector<double> size = fields.numbers(key, 2);
    bool sane =
        size[0] >= 0.0 && size[1] >= 0.0 && size[0] <= double(kMostInt) && size[1] <= double(kMostInt);
    if (!sane) {
        fields.complain(std::string("\"") + key + "\" is not a picture's [width, height] in pixels");
        return {};
    }
    return {static_cast<int>(size[0]), static_cast<int>(size[1])};
}

Kind kindFrom(JsonFields& fields) {
    std::string word = fields.text("kind");
    return kindFromName(word).value_or(Kind::Other);
}

Json detectionJson(const recognition::Detection& detection) {
    Json json;
    json["kind"] = kindName(detection.kind);
    if (!detection.templateId.empty()) json["template"] = detection.templateId.value;
    if (!detection.text.empty()) json["text"] = detection.text;
    json["quad"] = exactQuad(detection.quad);
    json["image"] = sizeJson(detection.image);
    json["score"] = exactNumber(detection.score);
    if (detection.inliers != 0) json["inliers"] = detection.inliers;
    addLookAlikes(json, detection, exactNumber);
    if (detection.rangeM) json["range_m"] = exactNumber(*detection.rangeM);
    if (detection.rangeSpread) json["range_spread"] = exactNumber(*detection.rangeSpread);
    if (detection.bearing) json["bearing_rad"] = exactNumber(detection.bearing->value);
    if (detection.track != 0) json["track"] = detection.track;
    if (detection.confirmations != 1) json["confirmations"] = detection.confirmations;
    return json;
}

recognition::Detection detectionFrom(JsonFields& fields) {
    recognition::Detection detection;
    detection.kind = kindFrom(fields);
    detection.templateId = TemplateId(fields.textOr("template", ""));
    detection.text = fields.textOr("text", "");
    detection.quad = fields.quad("quad");
    detection.image = sizeFrom(fields, "image");
    detection.score = fields.number("score");
    detection.inliers = static_cast<int>(fields.integerOr("inliers", 0, kMostInt, 0));
    readLookAlikes(fields, detection);
    detection.rangeM = fields.optionalNumber("range_m");
    detection.rangeSpread = fields.optionalNumber("range_spread");
    if (auto bearing = fields.optionalNumber("bearing_rad")) detection.bearing = Radians{*bearing};
    detection.track = static_cast<std::uint64_t>(fields.integerOr("track", 0, kMostTracks, 0));
    detection.confirmations = static_cast<int>(fields.integerOr("confirmations", 0, kMostInt, 1));
    return detection;
}

Json trackJson(const recognition::Track& track) {
    Json json = detectionJson(track.now);
    json["first_t"] = exactNumber(track.firstTime);
    json["confirmed_t"] = exactNumber(track.confirmedTime);
    if (track.growth) json["growth"] = exactNumber(*track.growth);
    return json;
}

recognition::Track trackFrom(JsonFields& fields) {
    recognition::Track track;
    track.now = detectionFrom(fields);
    track.firstTime = fields.number("first_t");
    track.confirmedTime = fields.number("confirmed_t");
    track.growth = fields.optionalNumber("growth");
    return track;
}

Json rejectionJson(const recognition::Rejection& rejection) {
    Json json;
    json["detector"] = rejection.detector;
    json["kind"] = kindName(rejection.kind);
    if (!rejection.templateId.empty()) json["template"] = rejection.templateId.value;
    json["quad"] = exactQuad(rejection.quad);
    json["reason"] = rejection.reason;
    json["value"] = exactNumber(rejection.value);
    return json;
}

recognition::Rejection rejectionFrom(JsonFields& fields) {
    recognition::Rejection rejection;
    rejection.detector = fields.text("detector");
    rejection.kind = kindFrom(fields);
    rejection.templateId = TemplateId(fields.textOr("template", ""));
    rejection.quad = fields.quad("quad");
    rejection.reason = fields.text("reason");
    rejection.value = fields.numberOr("value", 0.0);
    return rejection;
}

template <class Value, class Read>
std::vector<Value> listFrom(JsonFields& fields, const char* key, Read read) {
    std::vector<Value> values;
    for (const Json& item : fields.array(key)) {
        JsonFields inner(item);
        values.push_back(read(inner));
        if (!inner.ok()) fields.complain(std::string("in \"") + key + "\": " + inner.wrong());
        if (!fields.ok()) return {};
    }
    return values;
}

} // namespace

Json perceptJson(const Percept& percept) {
    Json json;
    json["frame"] = percept.frame;
    json["t"] = exactNumber(percept.time);
    json["name"] = percept.name;
    json["size"] = sizeJson(percept.size);
    json["scene"] = percept.scene;
    json["sharpness"] = exactNumber(percept.sharpness);
    json["detections"] = Json::array();
    for (const recognition::Detection& detection : percept.detections)
        json["detections"].push_back(detectionJson(detection));
    json["rejections"] = Json::array();
    for (const recognition::Rejection& rejection : percept.rejections)
        json["rejections"].push_back(rejectionJson(rejection));
    for (const recognition::Track& track : percept.tracks) json["tracks"].push_back(trackJson(track));
    if (percept.motion.turn) json["turn_rad"] = exactNumber(percept.motion.turn->value);
    if (percept.motion.speed) json["speed"] = exactNumber(*percept.motion.speed);
    if (percept.motion.walking) json["walking"] = *percept.motion.walking;
    if (percept.motion.stepsPerSecond) json["steps_per_s"] = exactNumber(*percept.motion.stepsPerSecond);
    return json;
}

Result<Percept> perceptFromJson(const Json& json) {
    JsonFields fields(json);
    Percept percept;
    percept.frame =
        static_cast<std::uint64_t>(fields.integer("frame", 0, std::numeric_limits<std::int64_t>::max()));
    percept.time = fields.number("t");
    percept.name = fields.textOr("name", "");
    percept.size = sizeFrom(fields, "size");
    percept.scene = static_cast<int>(fields.integer("scene", 0, kMostInt));
    percept.sharpness = fields.numberOr("sharpness", 0.0);
    percept.detections = listFrom<recognition::Detection>(fields, "detections", detectionFrom);
    percept.rejections = listFrom<recognition::Rejection>(fields, "rejections", rejectionFrom);
    if (fields.has("tracks")) percept.tracks = listFrom<recognition::Track>(fields, "tracks", trackFrom);
    if (auto turn = fields.optionalNumber("turn_rad")) percept.motion.turn = Radians{*turn};
    percept.motion.speed = fields.optionalNumber("speed");
    if (fields.has("walking")) percept.motion.walking = fields.flagOr("walking", false);
    percept.motion.stepsPerSecond = fields.optionalNumber("steps_per_s");
    if (!fields.ok()) return fields.error();
    return percept;
}

} // namespace farol::session
