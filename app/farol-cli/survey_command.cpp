#include "app/farol-cli/commands.h"
#include "app/farol-cli/output.h"
#include "app/farol-cli/walk_inputs.h"
#include "core/building/geopackage.h"
#include "core/capture/sources.h"
#include "core/session/survey.h"

#include <nlohmann/json.hpp>

#include <charconv>
#include <cstdio>

namespace farol::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr char kExamples[] = "Examples:\n"
                             "  farol-cli survey office.gpkg office-library.gpkg --source monday.mp4 --along "
                             "Entrance,Corridor,Library\n"
                             "  farol-cli survey office.gpkg office.gpkg --source pictures/ --fps 2 --along "
                             "\"1.5,0,0,leg-b,leg-c,20,3.5,0\"\n"
                             "Walk the way with the camera at its usual height, looking where you go, and "
                             "record it. The places are trained\n"
                             "into LIBRARY and written as landmarks of kind place into MAP.\n";

struct SurveyArguments {
    std::string map, library, source, along, prefix = "place";
    double framesPerSecond = 0.0, spacingM = 1.0;
    bool json = false;
};

bool isNumber(const std::string& text) {
    double value = 0.0;
    auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

/// A place may itself be "x,y,level": three numbers in a row are one place.
std::vector<std::string> placesOf(const std::string& along) {
    std::vector<std::string> words;
    for (std::size_t start = 0; start <= along.size();) {
        std::size_t end = std::min(along.find(',', start), along.size());
        words.push_back(along.substr(start, end - start));
        start = end + 1;
    }
    std::vector<std::string> places;
    for (std::size_t i = 0; i < words.size(); ++i) {
        bool spot =
            i + 2 < words.size() && isNumber(words[i]) && isNumber(words[i + 1]) && isNumber(words[i + 2]);
        places.push_back(spot ? words[i] + "," + words[i + 1] + "," + words[i + 2] : words[i]);
        if (spot) i += 2;
    }
    return places;
}

Json surveyJson(const session::Survey& survey) {
    Json json;
    json["length_m"] = survey.lengthM;
    json["frames"] = survey.frames;
    json["frames_with_motion"] = survey.framesWithMotion;
    json["frames_with_landmarks"] = survey.framesWithLandmarks;
    json["blurred"] = survey.blurred;
    json["left_out"] = survey.leftOut;
    json["places"] = Json::array();
    for (const session::SurveyedPlace& place : survey.places) {
        Json one;
        one["landmark_id"] = place.landmark.id.value;
        one["region"] = place.landmark.region.value;
        one["level"] = place.landmark.level;
        one["position"] = {place.landmark.position.x, place.landmark.position.y};
        one["heading_deg"] =
            place.landmark.heading ? Json(toDegrees(*place.landmark.heading)) : Json(nullptr);
        one["frame"] = place.frame;
        one["t"] = place.time;
        one["at_m"] = place.atM;
        json["places"].push_back(std::move(one));
    }
    json["frame_at_m"] = survey.frameAtM;
    return json;
}

int survey(const SurveyArguments& arguments) {
    int exitCode = kDone;
    auto map = openMap(arguments.map, exitCode);
    if (!map) return exitCode;
    std::vector<building::Location> along;
    for (const std::string& where : placesOf(arguments.along)) {
        std::optional<building::Location> place;
        if (!findPlace(*map, "--along", where, place, exitCode)) return exitCode;
        if (place) along.push_back(*std::move(place));
    }
    auto library = recognition::loadLibrary(arguments.library);
    if (!library && library.error().code != ErrorCode::NotFound) return report(library.error());
    recognition::LandmarkLibrary grown = library ? *std::move(library) : recognition::LandmarkLibrary{};
    session::SurveyOptions options;
    options.spacingM = arguments.spacingM;
    options.prefix = arguments.prefix;
    capture::SourceOptions sourceOptions;
    sourceOptions.framesPerSecond = arguments.framesPerSecond;
    auto open = [&] { return capture::openSource(arguments.source, sourceOptions); };
    auto surveyed = session::surveyWalk(map, grown, open, along, options);
    if (!surveyed) return report(surveyed.error());
    // The library first: places that the map does not know yet do no harm, the other way round they could not
    // be recognised.
    if (auto saved = recognition::saveLibrary(grown, arguments.library); !saved) return report(saved.error());
    building::BuildingData data = map->data();
    for (const session::SurveyedPlace& place : surveyed->places) data.landmarks.push_back(place.landmark);
    if (auto saved = building::saveBuilding(building::Building(std::move(data)), arguments.map); !saved)
        return report(saved.error());
    if (arguments.json) {
        printLine(surveyJson(*surveyed).dump());
        return kDone;
    }
    std::printf(
        "%zu places trained along %.1f m, from %zu frames (%zu with motion, %zu with known landmarks, %zu "
        "blurred).\n",
        surveyed->places.size(), surveyed->lengthM, surveyed->frames, surveyed->framesWithMotion,
        surveyed->framesWithLandmarks, surveyed->blurred);
    if (surveyed->framesWithMotion == 0)
        warn("the pictures are too far apart in time to see the motion: an even pace was assumed");
    return kDone;
}

} // namespace

void addSurveyCommand(CLI::App& app, int& exitCode) {
    auto arguments = std::make_shared<SurveyArguments>();
    CLI::App* command = app.add_subcommand("survey", "train places along a recorded walk");
    command->footer(kExamples);
    command->add_option("MAP", arguments->map, "the building file; the places are added to it")->required();
    command->add_option("LIBRARY", arguments->library, "the landmark library; made when it is not there")
        ->required();
    command
        ->add_option("--source", arguments->source, "the recorded walk: a video file or a folder of pictures")
        ->required();
    command->add_option("--along", arguments->along, "WHERE,WHERE,...: the places passed, first to last")
        ->required();
    command->add_option("--fps", arguments->framesPerSecond, "pictures of a folder per second");
    command->add_option("--spacing", arguments->spacingM, "metres from one place to the next")
        ->capture_default_str();
    command->add_option("--prefix", arguments->prefix, "how the names of the places begin")
        ->capture_default_str();
    command->add_flag("--json", arguments->json, "one JSON document");
    command->callback([arguments, &exitCode] { exitCode = survey(*arguments); });
}

} // namespace farol::cli
