#include "core/session/json_lines.h"

#include "core/base/zone.h"
#include "core/session/place_json.h"

#include <algorithm>
#include <cmath>

namespace farol::session {

namespace {

Json textOrNull(const std::string& text) {
    return text.empty() ? Json(nullptr) : Json(text);
}

Json pointJson(double x, double y) {
    return Json::array({printedNumber(x), printedNumber(y)});
}

Json degreesJson(Radians angle) {
    return printedNumber(toDegrees(angle));
}

Json lineHead(const char* type, double time, std::uint64_t frame) {
    Json json;
    json["type"] = type;
    json["t"] = printedNumber(time);
    json["frame"] = frame;
    return json;
}

Json frameJson(const Percept& percept) {
    Json json = lineHead("frame", percept.time, percept.frame);
    json["name"] = percept.name;
    json["scene"] = percept.scene;
    json["sharpness"] = printedNumber(percept.sharpness);
    json["size"] = Json::array({percept.size.width, percept.size.height});
    return json;
}

Json detectionJson(const Percept& percept, const recognition::Detection& detection) {
    Json json = lineHead("detection", percept.time, percept.frame);
    ImageBox box = boundingBox(detection.quad);
    json["scene"] = percept.scene;
    json["kind"] = kindName(detection.kind);
    json["template"] = textOrNull(detection.templateId.value);
    json["text"] = textOrNull(detection.text);
    json["box"] = Json::array(
        {printedNumber(box.x), printedNumber(box.y), printedNumber(box.width), printedNumber(box.height)});
    json["image"] = Json::array({detection.image.width, detection.image.height});
    json["score"] = printedNumber(detection.score);
    addLookAlikes(json, detection, printedNumber);
    json["range_m"] = detection.rangeM ? printedNumber(*detection.rangeM) : Json(nullptr);
    if (detection.rangeSpread) json["range_spread"] = printedNumber(*detection.rangeSpread);
    json["bearing_deg"] = detection.bearing ? degreesJson(*detection.bearing) : Json(nullptr);
    json["zone"] = zoneName(detection.zone());
    if (detection.track != 0) {
        json["track"] = detection.track;
        json["confirmations"] = detection.confirmations;
    }
    Json quad = Json::array();
    for (ImagePoint corner : detection.quad) quad.push_back(pointJson(corner.x, corner.y));
    json["quad"] = std::move(quad);
    return json;
}

Json voteJson(const localisation::RegionVote& vote) {
    Json json;
    json["region"] = vote.region.value;
    json["vote"] = printedNumber(vote.vote);
    json["terms"] = Json::object();
    for (const auto& [name, value] : vote.terms) json["terms"][name] = printedNumber(value);
    return json;
}

void addFixFields(Json& json, const localisation::Fix& fix) {
    json["region"] = fix.region ? Json(fix.region->value) : Json(nullptr);
    json["confidence"] = printedNumber(fix.confidence);
    json["near"] = Json::array();
    for (const RegionId& region : fix.near) json["near"].push_back(region.value);
    json["near_confidence"] = printedNumber(fix.nearConfidence);
    json["level"] = fix.level ? printedNumber(*fix.level) : Json(nullptr);
    json["position"] = fix.position ? pointJson(fix.position->x, fix.position->y) : Json(nullptr);
    json["sigma_m"] = printedNumber(fix.sigmaM);
    json["heading_deg"] = fix.heading ? degreesJson(*fix.heading) : Json(nullptr);
    if (fix.heading && fix.headingSigma.value > 0.0)
        json["heading_sigma_deg"] = degreesJson(fix.headingSigma);
    json["votes"] = Json::array();
    for (const localisation::RegionVote& vote : fix.votes) json["votes"].push_back(voteJson(vote));
}

const char* verticalName(routing::Vertical vertical) {
    switch (vertical) {
    case routing::Vertical::Up:
        return "up";
    case routing::Vertical::Down:
        return "down";
    case routing::Vertical::None:
        break;
    }
    return "none";
}

Json manoeuvreJson(const routing::Manoeuvre& manoeuvre) {
    Json json;
    json["kind"] = routing::manoeuvreKindName(manoeuvre.kind);
    json["access"] = textOrNull(manoeuvre.access.value);
    json["from"] = textOrNull(manoeuvre.from.value);
    json["into"] = textOrNull(manoeuvre.into.value);
    json["position"] = pointJson(manoeuvre.position.x, manoeuvre.position.y);
    json["level"] = printedNumber(manoeuvre.level);
    json["target_level"] = printedNumber(manoeuvre.targetLevel);
    json["turn_deg"] = degreesJson(manoeuvre.turn);
    json["vertical"] = verticalName(manoeuvre.vertical);
    json["steps"] = manoeuvre.steps ? Json(*manoeuvre.steps) : Json(nullptr);
    bool counted = manoeuvre.side != routing::Side::None;
    json["side"] = !counted ? Json(nullptr) : Json(manoeuvre.side == routing::Side::Left ? "left" : "right");
    json["number"] = counted ? Json(manoeuvre.number) : Json(nullptr);
    if (manoeuvre.alongWall) json["along_wall"] = true;
    json["behind_deg"] = manoeuvre.behind ? degreesJson(*manoeuvre.behind) : Json(nullptr);
    json["at_m"] = printedNumber(manoeuvre.atM);
    return json;
}

/// What a change is judged by; the route itself follows only with a new version.
Json progressFields(const guidance::Progress& progress) {
    Json json;
    json["travel"] = guidance::travelName(progress.travel);
    const routing::Route* route = progress.route.get();
    bool known = route != nullptr && progress.regionsPassed < route->regions.size();
    json["region"] = known ? Json(route->regions[progress.regionsPassed].value) : Json(nullptr);
    json["next"] = progress.next ? Json(routing::manoeuvreKindName(progress.next->kind)) : Json(nullptr);
    json["next_access"] = progress.next ? textOrNull(progress.next->access.value) : Json(nullptr);
    json["distance_m"] = progress.distanceM ? printedNumber(*progress.distanceM) : Json(nullptr);
    json["remaining_m"] = progress.remainingM ? printedNumber(*progress.remainingM) : Json(nullptr);
    json["off_route"] = progress.travel == guidance::Travel::OffRoute;
    json["arrived"] = progress.travel == guidance::Travel::Arrived;
    json["route_version"] = progress.routeVersion;
    if (!progress.reason.empty()) json["reason"] = progress.reason;
    return json;
}

Json progressJson(const NavigationStep& step, Json fields, const guidance::Progress* before) {
    Json json = lineHead("progress", step.percept.time, step.percept.frame);
    for (auto& [key, value] : fields.items()) json[key] = std::move(value);
    const guidance::Progress& now = step.progress;
    if (now.route && (before == nullptr || before->routeVersion != now.routeVersion))
        json["route"] = routeJson(*now.route);
    return json;
}

const char* priorityName(guidance::CuePriority priority) {
    switch (priority) {
    case guidance::CuePriority::Warning:
        return "warning";
    case guidance::CuePriority::ActNow:
        return "act_now";
    case guidance::CuePriority::OffRoute:
        return "off_route";
    case guidance::CuePriority::Prepare:
        return "prepare";
    case guidance::CuePriority::Arrival:
        return "arrival";
    case guidance::CuePriority::Answer:
        return "answer";
    case guidance::CuePriority::Detection:
        return "detection";
    case guidance::CuePriority::Reassurance:
        break;
    }
    return "reassurance";
}

Json surroundingJson(const guidance::Surrounding& what) {
    Json json;
    json["kind"] = what.access ? routing::manoeuvreKindName(*what.access) : std::string(kindName(what.kind));
    json["name"] = textOrNull(what.name);
    if (what.vertical != routing::Vertical::None) json["vertical"] = verticalName(what.vertical);
    json["direction_deg"] = what.direction ? degreesJson(*what.direction) : Json(nullptr);
    json["distance_m"] = what.distanceM ? printedNumber(*what.distanceM) : Json(nullptr);
    return json;
}

const char* sideName(routing::Side side) {
    return side == routing::Side::Left ? "left" : side == routing::Side::Right ? "right" : "none";
}

/// What an answer lists, and what is told beside the manoeuvre.
void addCueDetails(Json& json, const guidance::Cue& cue) {
    if (cue.asked) json["asked"] = true;
    if (cue.chime != guidance::Chime::None) json["chime"] = guidance::chimeName(cue.chime);
    if (cue.kind == guidance::CueKind::OffRoute) json["deviation"] = guidance::deviationName(cue.deviation);
    if (cue.manoeuvre && !cue.facingWay) json["facing_way"] = false;
    if (cue.staying) json["staying"] = true;
    if (cue.stop) json["stop"] = true;
    if (cue.mark) json["after"] = {{"kind", kindName(cue.mark->kind)}, {"side", sideName(cue.mark->side)}};
    if (cue.kind == guidance::CueKind::Around) {
        json["bearing"] = guidance::bearingName(cue.bearing);
        json["around"] = Json::array();
        for (const guidance::Surrounding& what : cue.around) json["around"].push_back(surroundingJson(what));
    }
    if (cue.kind == guidance::CueKind::Itinerary) {
        json["steps"] = Json::array();
        for (const guidance::Cue& step : cue.steps)
            if (step.manoeuvre) json["steps"].push_back(manoeuvreJson(*step.manoeuvre));
    }
}

void addCueSubject(Json& json, const guidance::Cue& cue) {
    auto addText = [&](const char* key, const std::string& text) {
        if (!text.empty()) json[key] = text;
    };
    if (cue.manoeuvre) json["manoeuvre"] = manoeuvreJson(*cue.manoeuvre);
    if (cue.next) json["next"] = manoeuvreJson(*cue.next);
    if (cue.hour) json["hour"] = *cue.hour;
    if (cue.turnFirst) json["turn_first_deg"] = degreesJson(*cue.turnFirst);
    if (cue.distanceM) json["distance_m"] = printedNumber(*cue.distanceM);
    if (cue.firstM) json["first_m"] = printedNumber(*cue.firstM);
    addText("region", cue.region.value);
    addText("region_name", cue.regionName);
    addText("into_name", cue.intoName);
    addText("level_name", cue.levelName);
    json["sure"] = cue.sure;
    bool object = cue.kind == guidance::CueKind::Detection;
    if (object) json["object_kind"] = kindName(cue.objectKind);
    if (object || cue.kind == guidance::CueKind::Text) json["zone"] = zoneName(cue.zone);
    addText("text", cue.text);
    if (cue.sweep != guidance::SweepStep::None) json["sweep"] = guidance::sweepStepName(cue.sweep);
    if (cue.reason != guidance::CueReason::None) json["reason"] = guidance::cueReasonName(cue.reason);
    addText("detail", cue.detail);
    addCueDetails(json, cue);
}

} // namespace

Json fixJson(const localisation::Fix& fix) {
    Json json;
    json["t"] = printedNumber(fix.time);
    addFixFields(json, fix);
    return json;
}

Json routeJson(const routing::Route& route) {
    Json json;
    json["planner"] = route.planner;
    json["regions"] = Json::array();
    for (const RegionId& region : route.regions) json["regions"].push_back(region.value);
    json["accesses"] = Json::array();
    for (const AccessId& access : route.accesses) json["accesses"].push_back(access.value);
    json["path"] = Json::array();
    for (const routing::PathPoint& point : route.path)
        json["path"].push_back(Json::array(
            {printedNumber(point.position.x), printedNumber(point.position.y), printedNumber(point.level)}));
    json["length_m"] = printedNumber(route.lengthM);
    json["seconds"] = printedNumber(route.seconds);
    json["manoeuvres"] = Json::array();
    for (const routing::Manoeuvre& manoeuvre : route.manoeuvres)
        json["manoeuvres"].push_back(manoeuvreJson(manoeuvre));
    return json;
}

std::string cueLine(const guidance::Cue& cue) {
    Json json = lineHead("cue", cue.time, cue.frame);
    json["id"] = cue.id;
    json["kind"] = guidance::cueKindName(cue.kind);
    json["priority"] = priorityName(cue.priority);
    json["valid_until"] = printedNumber(cue.validUntil);
    if (!cue.validIn.empty()) {
        json["valid_in"] = Json::array();
        for (const RegionId& region : cue.validIn) json["valid_in"].push_back(region.value);
    }
    if (cue.routeVersion != 0) json["route_version"] = cue.routeVersion;
    addCueSubject(json, cue);
    return dumped(json);
}

std::string warningLine(double time, std::uint64_t frame, const std::string& message) {
    Json json = lineHead("warning", time, frame);
    json["message"] = message;
    return dumped(json);
}

std::string utteranceLine(double time, std::uint64_t frame, std::uint64_t cause, const std::string& text) {
    Json json = lineHead("utterance", time, frame);
    json["cause"] = cause;
    json["text"] = text;
    return dumped(json);
}

std::vector<std::string> linesOf(const NavigationStep& step, const guidance::Progress* before) {
    const Percept& percept = step.percept;
    std::vector<std::string> lines{dumped(frameJson(percept))};
    for (const recognition::Detection& detection : percept.detections)
        lines.push_back(dumped(detectionJson(percept, detection)));
    Json fix = lineHead("fix", percept.time, percept.frame);
    addFixFields(fix, step.fix);
    lines.push_back(dumped(fix));
    Json progress = progressFields(step.progress);
    if (before == nullptr || progress != progressFields(*before))
        lines.push_back(dumped(progressJson(step, std::move(progress), before)));
    for (const guidance::Cue& cue : step.cues) lines.push_back(cueLine(cue));
    return lines;
}

} // namespace farol::session
