#include "app/farol-cli/commands.h"
#include "app/farol-cli/output.h"
#include "core/base/text.h"
#include "core/building/geopackage.h"
#include "core/routing/route.h"
#include "core/session/json_fields.h"
#include "core/session/json_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <memory>
#include <utility>

namespace farol::cli {

namespace {

using routing::Manoeuvre;
using routing::ManoeuvreKind;
using routing::Route;
using session::Json;

struct RouteArguments {
    std::string map;
    std::string from;
    std::string to;
    std::string planner = "optimal";
    std::vector<std::string> avoid;
    bool json = false;
};

/// The keys of the contract, whether or not a way was found.
Json foundJson(const Route& route) {
    Json json;
    json["found"] = true;
    Json fields = session::routeJson(route);
    for (auto& [key, value] : fields.items()) json[key] = std::move(value);
    return json;
}

Json notFoundJson(const std::string& reason) {
    Json json;
    json["found"] = false;
    json["reason"] = reason;
    for (const char* key : {"regions", "accesses", "path"}) json[key] = Json::array();
    json["length_m"] = nullptr;
    json["seconds"] = nullptr;
    json["manoeuvres"] = Json::array();
    return json;
}

std::string metres(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f m", value);
    return text;
}

std::string nameOf(const building::Building& building, const RegionId& id) {
    const building::Region* region = building.region(id);
    return region == nullptr ? id.value : spokenName(*region);
}

std::string turnWords(Radians turn) {
    long degrees = std::lround(toDegrees(turn));
    if (std::abs(degrees) < 30) return "";
    return ", turn " + std::to_string(std::abs(degrees)) + (degrees > 0 ? " degrees left" : " degrees right");
}

/// ", the third on the left" of the doors in the wall beside the way.
std::string countWords(const Manoeuvre& manoeuvre) {
    if (manoeuvre.side == routing::Side::None) return "";
    static const char* const ordinals[] = {"first", "second",  "third",  "fourth", "fifth",
                                           "sixth", "seventh", "eighth", "ninth",  "tenth"};
    bool named = manoeuvre.number >= 1 && manoeuvre.number <= 10;
    std::string number =
        named ? ordinals[manoeuvre.number - 1] : "number " + std::to_string(manoeuvre.number);
    return (named ? ", the " : ", ") + number + (manoeuvre.alongWall ? " along the wall" : "") +
           (manoeuvre.side == routing::Side::Left ? " on the left" : " on the right");
}

std::string lineOf(const building::Building& building, const Manoeuvre& manoeuvre) {
    char at[32];
    std::snprintf(at, sizeof at, "%7.1f m  ", manoeuvre.atM);
    std::string line = at + routing::manoeuvreKindName(manoeuvre.kind);
    if (manoeuvre.kind == ManoeuvreKind::Start || manoeuvre.kind == ManoeuvreKind::Arrive ||
        manoeuvre.kind == ManoeuvreKind::Turn)
        line += " in " + nameOf(building, manoeuvre.into);
    else
        line += " to " + nameOf(building, manoeuvre.into);
    if (manoeuvre.vertical != routing::Vertical::None)
        line += std::string(manoeuvre.vertical == routing::Vertical::Up ? ", up" : ", down") + " to level " +
                formatNumber(manoeuvre.targetLevel);
    if (manoeuvre.steps) line += ", " + std::to_string(*manoeuvre.steps) + " steps";
    return line + countWords(manoeuvre) + turnWords(manoeuvre.turn);
}

void printRoute(const building::Building& building, const Route& route) {
    printLine(nameOf(building, route.regions.front()) + " to " + nameOf(building, route.regions.back()) +
              ": " + metres(route.lengthM) + ", about " + std::to_string(std::lround(route.seconds)) +
              " s (" + route.planner + ")");
    for (const Manoeuvre& manoeuvre : route.manoeuvres) printLine(lineOf(building, manoeuvre));
}

Result<routing::RouteOptions> optionsOf(const std::vector<std::string>& avoid) {
    routing::RouteOptions options;
    const std::pair<const char*, bool*> names[] = {
        {"stairs", &options.avoidStairs},
        {"elevator", &options.avoidElevator},
        {"escalator", &options.avoidEscalator},
        {"moving-walkway", &options.avoidWalkway},
        {"ramp", &options.avoidRamp},
        {"narrow-doors", &options.avoidNarrow},
        {"restricted", &options.avoidRestricted},
    };
    for (const std::string& what : avoid) {
        auto known = std::find_if(std::begin(names), std::end(names),
                                  [&](const auto& each) { return what == each.first; });
        if (known == std::end(names))
            return Error{ErrorCode::InvalidArgument,
                         "\"" + what +
                             "\" cannot be avoided; stairs, elevator, escalator, moving-walkway, ramp, "
                             "narrow-doors and restricted can",
                         "--avoid"};
        *known->second = true;
    }
    return options;
}

int route(const RouteArguments& arguments) {
    auto options = optionsOf(arguments.avoid);
    if (!options) return report(options.error());
    auto loaded = building::loadBuilding(arguments.map);
    if (!loaded) return report(loaded.error());
    warnAll(loaded->warnings);
    auto from = building::resolveWhere(*loaded->building, arguments.from);
    if (!from) return report(from.error());
    auto to = building::resolveWhere(*loaded->building, arguments.to);
    if (!to) return report(to.error());
    auto planner = arguments.planner == "greedy" ? routing::makeGreedyPlanner(loaded->building, *options)
                                                 : routing::makeOptimalPlanner(loaded->building, *options);
    auto planned = planner->plan(*from, *to);
    if (!planned) {
        if (arguments.json && planned.error().code == ErrorCode::NotFound)
            printLine(session::dumped(notFoundJson(planned.error().message)));
        return report(planned.error());
    }
    if (arguments.json)
        printLine(session::dumped(foundJson(*planned)));
    else
        printRoute(*loaded->building, *planned);
    return kDone;
}

} // namespace

void addRouteCommand(CLI::App& app, int& exitCode) {
    CLI::App* command = app.add_subcommand("route", "Plans a way through a building");
    auto arguments = std::make_shared<RouteArguments>();
    command->add_option("MAP", arguments->map, "Building file (.gpkg) or OGR connection string (PG:...)")
        ->required();
    const std::string where = " WHERE: a region's id, its unique name or ref, or x,y,level";
    command->add_option("--from", arguments->from, "Where the way starts." + where)
        ->required()
        ->type_name("WHERE");
    command->add_option("--to", arguments->to, "Where it leads." + where)->required()->type_name("WHERE");
    command
        ->add_option("--planner", arguments->planner,
                     "optimal: least time; greedy: as in the paper, section 4.1")
        ->check(CLI::IsMember({"optimal", "greedy"}))
        ->capture_default_str();
    command
        ->add_option(
            "--avoid", arguments->avoid,
            "What not to use: stairs, elevator, escalator, moving-walkway, ramp, narrow-doors (below 0.8 m), "
            "restricted")
        ->delimiter(',');
    command->add_flag("--json", arguments->json, "One JSON document on standard output");
    command->footer("Example:\n  farol-cli route building.gpkg --from \"Main entrance\" --to 2.14 --avoid "
                    "stairs,narrow-doors");
    command->callback([arguments, &exitCode] { exitCode = route(*arguments); });
}

} // namespace farol::cli
