#include "core/session/recording_json.h"

#include "core/session/json_lines.h"
#include "core/session/sayings.h"

#include <array>
#include <limits>
#include <utility>

namespace farol::session {

namespace {

using guidance::CueReason;
using guidance::Question;
using guidance::Verbosity;

constexpr int kVersion = 1;
constexpr std::array<std::pair<Verbosity, const char*>, 3> kVerbosities{
    {{Verbosity::Directions, "directions"},
     {Verbosity::Objects, "objects"},
     {Verbosity::ObjectsAndTexts, "texts"}}};
constexpr std::array<Question, 6> kQuestions{Question::WhereAmI,  Question::AroundMe, Question::Next,
                                             Question::Remaining, Question::Repeat,   Question::Preview};
constexpr std::array<CueReason, 8> kReasons{
    CueReason::None,           CueReason::DestinationUnknown, CueReason::DestinationUnreachable,
    CueReason::CameraLost,     CueReason::CameraBack,         CueReason::RecordingStopped,
    CueReason::PictureCovered, CueReason::FrameSkipped};

std::string verbosityName(Verbosity verbosity) {
    for (const auto& [value, name] : kVerbosities)
        if (value == verbosity) return name;
    return "objects";
}

Verbosity verbosityFrom(JsonFields& fields) {
    std::string word = fields.textOr("verbosity", "objects");
    for (const auto& [value, name] : kVerbosities)
        if (word == name) return value;
    fields.complain("\"verbosity\" is none of directions, objects, texts");
    return Verbosity::Objects;
}

CueReason reasonFrom(JsonFields& fields) {
    std::string word = fields.text("reason");
    for (CueReason reason : kReasons)
        if (word == guidance::cueReasonName(reason)) return reason;
    fields.complain("\"reason\" is the unknown word " + word);
    return CueReason::None;
}

Question questionFrom(JsonFields& fields) {
    std::string word = fields.text("question");
    for (Question question : kQuestions)
        if (word == guidance::questionName(question)) return question;
    fields.complain("\"question\" is the unknown word " + word);
    return Question::WhereAmI;
}

Json routingJson(const routing::RouteOptions& options) {
    Json json;
    json["walking_speed"] = exactNumber(options.walkingSpeed);
    json["door_s"] = exactNumber(options.doorSeconds);
    json["stairs_s_per_level"] = exactNumber(options.stairsSecondsPerLevel);
    json["elevator_s"] = exactNumber(options.elevatorSeconds);
    json["storey_height_m"] = exactNumber(options.storeyHeightM);
    json["avoid_stairs"] = options.avoidStairs;
    json["avoid_elevator"] = options.avoidElevator;
    json["avoid_escalator"] = options.avoidEscalator;
    json["avoid_restricted"] = options.avoidRestricted;
    return json;
}

void readRouting(JsonFields fields, routing::RouteOptions& options, JsonFields& outer) {
    options.walkingSpeed = fields.numberOr("walking_speed", options.walkingSpeed);
    options.doorSeconds = fields.numberOr("door_s", options.doorSeconds);
    options.stairsSecondsPerLevel = fields.numberOr("stairs_s_per_level", options.stairsSecondsPerLevel);
    options.elevatorSeconds = fields.numberOr("elevator_s", options.elevatorSeconds);
    options.storeyHeightM = fields.numberOr("storey_height_m", options.storeyHeightM);
    options.avoidStairs = fields.flagOr("avoid_stairs", options.avoidStairs);
    options.avoidElevator = fields.flagOr("avoid_elevator", options.avoidElevator);
    options.avoidEscalator = fields.flagOr("avoid_escalator", options.avoidEscalator);
    options.avoidRestricted = fields.flagOr("avoid_restricted", options.avoidRestricted);
    if (!fields.ok()) outer.complain("in \"routing\": " + fields.wrong());
}

Json guidanceJson(const guidance::GuidanceOptions& options) {
    Json json;
    json["verbosity"] = verbosityName(options.verbosity);
    if (!options.language.empty()) json["language"] = options.language;
    json["prepare_distance_m"] = exactNumber(options.prepareDistanceM);
    json["act_distance_m"] = exactNumber(options.actDistanceM);
    json["reassure_every_m"] = exactNumber(options.reassureEveryM);
    json["reassure_every_s"] = exactNumber(options.reassureEverySeconds);
    json["repeat_after_s"] = exactNumber(options.repeatAfterSeconds);
    json["object_repeat_s"] = exactNumber(options.objectRepeatSeconds);
    json["unsure_after_s"] = exactNumber(options.unsureAfterSeconds);
    json["unsure_repeat_s"] = exactNumber(options.unsureRepeatSeconds);
    json["off_route_repeat_s"] = exactNumber(options.offRouteRepeatSeconds);
    json["sure_confidence"] = exactNumber(options.sureConfidence);
    json["usable_confidence"] = exactNumber(options.usableConfidence);
    json["usable_near_confidence"] = exactNumber(options.usableNearConfidence);
    json["max_sigma_for_distance_m"] = exactNumber(options.maxSigmaForDistanceM);
    return json;
}

void readGuidance(JsonFields fields, guidance::GuidanceOptions& options, JsonFields& outer) {
    options.verbosity = verbosityFrom(fields);
    options.language = fields.textOr("language", options.language);
    options.prepareDistanceM = fields.numberOr("prepare_distance_m", options.prepareDistanceM);
    options.actDistanceM = fields.numberOr("act_distance_m", options.actDistanceM);
    options.reassureEveryM = fields.numberOr("reassure_every_m", options.reassureEveryM);
    options.reassureEverySeconds = fields.numberOr("reassure_every_s", options.reassureEverySeconds);
    options.repeatAfterSeconds = fields.numberOr("repeat_after_s", options.repeatAfterSeconds);
    options.objectRepeatSeconds = fields.numberOr("object_repeat_s", options.objectRepeatSeconds);
    options.unsureAfterSeconds = fields.numberOr("unsure_after_s", options.unsureAfterSeconds);
    options.unsureRepeatSeconds = fields.numberOr("unsure_repeat_s", options.unsureRepeatSeconds);
    options.offRouteRepeatSeconds = fields.numberOr("off_route_repeat_s", options.offRouteRepeatSeconds);
    options.sureConfidence = fields.numberOr("sure_confidence", options.sureConfidence);
    options.usableConfidence = fields.numberOr("usable_confidence", options.usableConfidence);
    options.usableNearConfidence = fields.numberOr("usable_near_confidence", options.usableNearConfidence);
    options.maxSigmaForDistanceM = fields.numberOr("max_sigma_for_distance_m", options.maxSigmaForDistanceM);
    if (!fields.ok()) outer.complain("in \"guidance\": " + fields.wrong());
}

void readHistory(JsonFields fields, localisation::HistoryOptions& options, JsonFields& outer) {
    constexpr std::int64_t kMostItems = 1'000'000;
    options.capacity = static_cast<std::size_t>(
        fields.integerOr("capacity", 1, kMostItems, static_cast<std::int64_t>(options.capacity)));
    options.duplicateOverlap = fields.numberOr("duplicate_overlap", options.duplicateOverlap);
    if (!fields.ok()) outer.complain("in \"history\": " + fields.wrong());
}

void readTracker(JsonFields fields, guidance::TrackerOptions& options, JsonFields& outer) {
    options.offRouteFixes = static_cast<int>(
        fields.integerOr("off_route_fixes", 0, std::numeric_limits<int>::max(), options.offRouteFixes));
    options.offRouteConfidence = fields.numberOr("off_route_confidence", options.offRouteConfidence);
    options.offRouteSeconds = fields.numberOr("off_route_s", options.offRouteSeconds);
    options.minConfidence = fields.numberOr("min_confidence", options.minConfidence);
    if (!fields.ok()) outer.complain("in \"tracker\": " + fields.wrong());
}

Json destinationJson(const DestinationCommand& command) {
    Json json;
    json["command"] = "destination";
    if (!command.destination) return json;
    json["region"] = command.destination->region.value;
    if (auto position = command.destination->position)
        json["position"] = Json::array({exactNumber(position->x), exactNumber(position->y)});
    return json;
}

Command destinationFrom(JsonFields& fields) {
    DestinationCommand command;
    if (!fields.has("region")) return command;
    command.destination = building::Location{RegionId(fields.text("region")), std::nullopt};
    if (fields.has("position")) {
        std::vector<double> point = fields.numbers("position", 2);
        command.destination->position = Point2{point[0], point[1]};
    }
    return command;
}

Result<RecordLine> commandFrom(JsonFields& fields) {
    std::string word = fields.text("command");
    Command command;
    if (word == "start") {
        StartCommand start{fields.number("t"), std::nullopt};
        if (fields.has("region")) start.region = RegionId(fields.text("region"));
        command = std::move(start);
    } else if (word == "destination") {
        command = destinationFrom(fields);
    } else if (word == "verbosity") {
        command = VerbosityCommand{verbosityFrom(fields)};
    } else if (word == "language") {
        command = LanguageCommand{fields.text("language")};
    } else if (word == "warning") {
        command = WarningCommand{reasonFrom(fields), fields.textOr("detail", "")};
    } else if (word == "message") {
        command = MessageCommand{fields.text("text")};
    } else if (word == "heard") {
        command = HeardCommand{
            static_cast<std::uint64_t>(fields.integer("cue", 0, std::numeric_limits<std::int64_t>::max()))};
    } else if (word == "ask") {
        command = AskCommand{questionFrom(fields)};
    } else {
        fields.complain("has the unknown command " + word);
    }
    if (!fields.ok()) return fields.error();
    return RecordLine{std::move(command), ""};
}

} // namespace

Json headerJson(const RecordingHeader& header) {
    Json json;
    json["farol_recording"] = header.version;
    json["source"] = header.source;
    json["map"] = header.map;
    json["library"] = header.library;
    const NavigatorOptions& options = header.options;
    Json inner;
    inner["localiser"] = options.localiser;
    inner["planner"] = options.planner;
    inner["routing"] = routingJson(options.routing);
    inner["history"] = {{"capacity", options.history.capacity},
                        {"duplicate_overlap", exactNumber(options.history.duplicateOverlap)}};
    inner["tracker"] = {{"off_route_fixes", options.tracker.offRouteFixes},
                        {"off_route_confidence", exactNumber(options.tracker.offRouteConfidence)},
                        {"off_route_s", exactNumber(options.tracker.offRouteSeconds)},
                        {"min_confidence", exactNumber(options.tracker.minConfidence)}};
    inner["guidance"] = guidanceJson(options.guidance);
    if (options.heardIsReported) inner["heard_is_reported"] = true;
    json["options"] = std::move(inner);
    return json;
}

Result<RecordingHeader> headerFromJson(const Json& json) {
    JsonFields fields(json);
    RecordingHeader header;
    if (!fields.has("farol_recording") && fields.ok())
        return Error{ErrorCode::UnsupportedFormat, said(Saying::NoHeader), ""};
    header.version = static_cast<int>(fields.integer("farol_recording", 1, std::numeric_limits<int>::max()));
    if (header.version > kVersion)
        return Error{ErrorCode::UnsupportedFormat,
                     said(Saying::RecordingLater, {std::to_string(header.version), std::to_string(kVersion)}),
                     ""};
    header.source = fields.textOr("source", "");
    header.map = fields.textOr("map", "");
    header.library = fields.textOr("library", "");
    JsonFields options(fields.object("options"));
    header.options.localiser = options.textOr("localiser", header.options.localiser);
    header.options.planner = options.textOr("planner", header.options.planner);
    readRouting(JsonFields(options.object("routing")), header.options.routing, options);
    readHistory(JsonFields(options.object("history")), header.options.history, options);
    readTracker(JsonFields(options.object("tracker")), header.options.tracker, options);
    readGuidance(JsonFields(options.object("guidance")), header.options.guidance, options);
    header.options.heardIsReported = options.flagOr("heard_is_reported", false);
    if (!options.ok()) fields.complain("in \"options\": " + options.wrong());
    if (!fields.ok()) return fields.error();
    return header;
}

Json perceptLineJson(const Percept& percept, const std::string& picture) {
    Json json;
    json["percept"] = perceptJson(percept);
    if (!picture.empty()) json["picture"] = picture;
    return json;
}

Json commandJson(const Command& command) {
    Json json;
    if (const auto* start = std::get_if<StartCommand>(&command)) {
        json["command"] = "start";
        json["t"] = exactNumber(start->time);
        if (start->region) json["region"] = start->region->value;
    } else if (const auto* destination = std::get_if<DestinationCommand>(&command)) {
        json = destinationJson(*destination);
    } else if (const auto* verbosity = std::get_if<VerbosityCommand>(&command)) {
        json["command"] = "verbosity";
        json["verbosity"] = verbosityName(verbosity->verbosity);
    } else if (const auto* language = std::get_if<LanguageCommand>(&command)) {
        json["command"] = "language";
        json["language"] = language->language;
    } else if (const auto* warning = std::get_if<WarningCommand>(&command)) {
        json["command"] = "warning";
        json["reason"] = guidance::cueReasonName(warning->reason);
        json["detail"] = warning->detail;
    } else if (const auto* message = std::get_if<MessageCommand>(&command)) {
        json["command"] = "message";
        json["text"] = message->text;
    } else if (const auto* heard = std::get_if<HeardCommand>(&command)) {
        json["command"] = "heard";
        json["cue"] = heard->cue;
    } else if (const auto* ask = std::get_if<AskCommand>(&command)) {
        json["command"] = "ask";
        json["question"] = guidance::questionName(ask->question);
    }
    return json;
}

Result<RecordLine> recordLineFromJson(const Json& json) {
    JsonFields fields(json);
    if (fields.has("command")) return commandFrom(fields);
    if (!fields.has("percept")) return Error{ErrorCode::Corrupt, said(Saying::LineUnknown), ""};
    auto percept = perceptFromJson(fields.object("percept"));
    if (!percept) return percept.error();
    RecordLine line{std::move(percept).value(), fields.textOr("picture", "")};
    if (!fields.ok()) return fields.error();
    return line;
}

} // namespace farol::session
