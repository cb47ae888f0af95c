#include "app/farol-cli/commands.h"
#include "app/farol-cli/output.h"
#include "core/base/file.h"
#include "core/recognition/library_check.h"
#include "core/recognition/training.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <unistd.h>

namespace farol::cli {

namespace {

using Json = nlohmann::ordered_json;
using namespace recognition;

/// Names may hold any bytes; JSON may not.
std::string dumped(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

struct TrainArguments {
    std::string library, templateName, kind, name, extractor;
    std::vector<double> outline;
    double widthM = 0.0, heightM = 0.0;
    std::vector<std::string> views;
};

/// The library at the path, or a new one: a file that is not there yet, or a map that holds none.
Result<LandmarkLibrary> libraryToExtend(const std::string& path, const std::string& extractor) {
    std::optional<ExtractorOptions> wanted;
    if (!extractor.empty()) {
        auto named = ExtractorOptions::named(extractor);
        if (!named) return named.error();
        wanted = *named;
    }
    auto library = loadLibrary(path, wanted);
    if (library || library.error().code != ErrorCode::NotFound) return library;
    LandmarkLibrary fresh;
    if (wanted) fresh.extractor = *wanted;
    return fresh;
}

Result<TrainingRequest> requestFrom(const TrainArguments& arguments) {
    auto kind = kindFromName(arguments.kind);
    if (!kind) {
        std::string known;
        for (Kind one : allKinds()) known += (known.empty() ? "" : ", ") + std::string(kindName(one));
        return Error{ErrorCode::InvalidArgument,
                     "\"" + arguments.kind + "\" is no kind; the kinds are " + known, "--kind"};
    }
    if (!arguments.outline.empty() && arguments.outline.size() != 8)
        return Error{ErrorCode::InvalidArgument,
                     "an outline is four corners, x,y,x,y,x,y,x,y, clockwise from the object's top left",
                     "--outline"};
    TrainingRequest request;
    request.id = TemplateId(arguments.templateName);
    request.kind = *kind;
    request.name = arguments.name;
    if (arguments.widthM != 0.0) request.widthM = arguments.widthM;
    if (arguments.heightM != 0.0) request.heightM = arguments.heightM;
    return request;
}

int train(const TrainArguments& arguments) {
    auto request = requestFrom(arguments);
    if (!request) return report(request.error());
    auto library = libraryToExtend(arguments.library, arguments.extractor);
    if (!library) return reportLibrary(library.error(), arguments.library);
    std::optional<Quad> outline;
    if (!arguments.outline.empty()) {
        outline.emplace();
        for (std::size_t i = 0; i < 4; ++i)
            (*outline)[i] = {arguments.outline[2 * i], arguments.outline[2 * i + 1]};
    }
    std::size_t added = 0;
    int lastCode = kFailed;
    for (const std::string& view : arguments.views) {
        auto bytes = readFile(view);
        if (!bytes) {
            lastCode = report(bytes.error());
            continue;
        }
        if (auto trained = addView(*library, *request, *bytes, outline); !trained) {
            lastCode = report({trained.error().code, trained.error().message, view});
            continue;
        }
        ++added;
    }
    if (added == 0) return lastCode;
    if (auto saved = saveLibrary(*library, arguments.library); !saved) return report(saved.error());
    const Template& entry = *library->find(request->id);
    std::size_t features = 0;
    for (const View& view : entry.views) features += view.features.keypoints.size();
    std::printf("%s: template %s (%s) has %zu views and %zu features\n", arguments.library.c_str(),
                entry.id.value.c_str(), std::string(kindName(entry.kind)).c_str(), entry.views.size(),
                features);
    return kDone;
}

Json templateJson(const Template& entry) {
    std::size_t features = 0;
    for (const View& view : entry.views) features += view.features.keypoints.size();
    Json json;
    json["template"] = entry.id.value;
    json["kind"] = entry.unknownKind.empty() ? std::string(kindName(entry.kind)) : entry.unknownKind;
    json["name"] = entry.name;
    json["width_m"] = entry.widthM ? Json(*entry.widthM) : Json(nullptr);
    json["height_m"] = entry.heightM ? Json(*entry.heightM) : Json(nullptr);
    json["views"] = entry.views.size();
    json["features"] = features;
    return json;
}

int list(const std::string& path, bool asJson) {
    auto library = loadLibrary(path);
    if (!library) return reportLibrary(library.error(), path);
    if (asJson) {
        Json json;
        json["library"] = path;
        json["extractor"] = library->extractor.description();
        json["templates"] = Json::array();
        for (const Template& entry : library->templates) json["templates"].push_back(templateJson(entry));
        printLine(dumped(json));
        return kDone;
    }
    std::printf("%s: %zu templates, %zu views, %s\n", path.c_str(), library->templates.size(),
                library->viewCount(), library->extractor.description().c_str());
    for (const Template& entry : library->templates) {
        Json json = templateJson(entry);
        std::printf("  %-24s %-16s %zu views  %s\n", entry.id.value.c_str(),
                    json["kind"].get<std::string>().c_str(), entry.views.size(), entry.name.c_str());
    }
    return kDone;
}

int removeOne(const std::string& path, const std::string& name) {
    auto library = loadLibrary(path);
    if (!library) return reportLibrary(library.error(), path);
    if (!removeTemplate(*library, TemplateId(name)))
        return report({ErrorCode::NotFound, "there is no template \"" + name + "\"; see library list", path});
    if (auto saved = saveLibrary(*library, path); !saved) return report(saved.error());
    std::printf("%s: template %s is removed\n", path.c_str(), name.c_str());
    return kDone;
}

int retrainAll(const std::string& path, const std::string& extractor) {
    auto options = ExtractorOptions::named(extractor);
    if (!options) return report(options.error());
    auto photographs = loadPhotographs(path);
    if (!photographs) return report(photographs.error());
    bool terminal = ::isatty(STDERR_FILENO) == 1;
    auto fresh = retrain(*photographs, *options, [&](std::size_t done, std::size_t all) {
        if (terminal) std::fprintf(stderr, "\r%zu of %zu views%s", done, all, done == all ? "\n" : "");
    });
    if (!fresh) return report(fresh.error());
    for (const Error& refused : fresh->refused) warn(refused.text());
    std::size_t lost = photographs->templates.size() - fresh->library.templates.size();
    if (lost > 0)
        return report({ErrorCode::Conflict,
                       std::to_string(lost) + " templates would be lost with " + extractor +
                           ", which finds too little in their photographs; the library stays as it was",
                       path});
    if (auto saved = saveLibrary(fresh->library, path); !saved) return report(saved.error());
    std::printf("%s: %zu templates, %zu of %zu views trained again with %s\n", path.c_str(),
                fresh->library.templates.size(), fresh->library.viewCount(), photographs->viewCount(),
                fresh->library.extractor.description().c_str());
    return kDone;
}

Json checkJson(const std::string& path, const std::vector<TemplateCheck>& checks) {
    Json json;
    json["library"] = path;
    json["templates"] = Json::array();
    for (const TemplateCheck& check : checks) {
        Json entry;
        entry["template"] = check.id.value;
        entry["views"] = check.views;
        entry["tested"] = check.tested;
        entry["found"] = check.found;
        entry["made"] = check.shown;
        entry["made_found"] = check.shownFound;
        entry["smallest_px"] = check.smallestPx > 0.0 ? Json(check.smallestPx) : Json(nullptr);
        entry["farthest_m"] =
            check.farthestM ? Json(std::round(*check.farthestM * 100.0) / 100.0) : Json(nullptr);
        entry["widest_deg"] =
            check.shown > 0 && check.widestDegrees >= 0.0 ? Json(check.widestDegrees) : Json(nullptr);
        entry["confused_with"] = Json::object();
        for (const auto& [name, times] : check.confusedWith) entry["confused_with"][name] = times;
        json["templates"].push_back(std::move(entry));
    }
    return json;
}

std::string sentence(const TemplateCheck& one) {
    std::string line = "  " + one.id.value + ": ";
    line += one.tested == 0 ? "one view only, so none could be held back"
                            : "found in " + std::to_string(one.found) + " of " + std::to_string(one.tested) +
                                  " views held back";
    char text[160];
    if (one.shown > 0 && one.smallestPx > 0.0) {
        std::snprintf(text, sizeof text, "; down to %.0f px", one.smallestPx);
        line += text;
        if (one.farthestM) {
            std::snprintf(text, sizeof text, " (%.1f m)", *one.farthestM);
            line += text;
        }
        std::snprintf(text, sizeof text, ", up to %.0f degrees aside", std::max(0.0, one.widestDegrees));
        line += text;
    } else if (one.shown > 0) {
        line += "; never found in the views made from its photograph";
    }
    for (const auto& [name, times] : one.confusedWith)
        line += "; confused with " + name + " (" + std::to_string(times) + ")";
    return line;
}

int check(const std::string& path, bool asJson) {
    auto library = loadLibrary(path);
    if (!library) return reportLibrary(library.error(), path);
    bool terminal = ::isatty(STDERR_FILENO) == 1;
    auto checks = checkLibrary(*library, {}, [&](std::size_t done, std::size_t all) {
        if (terminal) std::fprintf(stderr, "\r%zu of %zu pictures%s", done, all, done == all ? "\n" : "");
    });
    if (asJson) {
        printLine(dumped(checkJson(path, checks)));
        return kDone;
    }
    for (const TemplateCheck& one : checks) printLine(sentence(one));
    return kDone;
}

void addTrain(CLI::App& app, int& exitCode) {
    CLI::App* command = app.add_subcommand("train", "Teach a library what a landmark looks like");
    command->footer(
        "Example:\n  farol-cli train corridor.gpkg --template extinguisher-2 --kind extinguisher "
        "--outline 120,80,220,80,220,320,120,320 --width-m 0.2 near.jpg left.jpg right.jpg\n"
        "Kind place takes whole pictures of a spot; every other kind an object, flat or nearly so.");
    auto arguments = std::make_shared<TrainArguments>();
    command->add_option("library", arguments->library, "Library or map (*.gpkg); made when it is not there")
        ->required();
    command
        ->add_option("--template", arguments->templateName,
                     "Name of the template; more views of one are added")
        ->required();
    command->add_option("--kind", arguments->kind, "What it is: place, door, poster, extinguisher, sign, ...")
        ->required();
    command
        ->add_option("--outline", arguments->outline,
                     "x,y,x,y,x,y,x,y in pixels, clockwise from the object's top left; "
                     "the whole picture without it")
        ->delimiter(',');
    command->add_option("--name", arguments->name, "Name for people");
    command->add_option("--width-m", arguments->widthM, "Real width in metres")->check(CLI::PositiveNumber);
    command->add_option("--height-m", arguments->heightM, "Real height in metres")
        ->check(CLI::PositiveNumber);
    command->add_option("--extractor", arguments->extractor,
                        "Features of a new library: rootsift (usual), surf, orb, akaze");
    command->add_option("views", arguments->views, "Photographs")->required();
    command->callback([arguments, &exitCode] { exitCode = train(*arguments); });
}

} // namespace

void addLibraryCommands(CLI::App& app, int& exitCode) {
    addTrain(app, exitCode);
    CLI::App* library = app.add_subcommand("library", "Look into a landmark library");
    library->require_subcommand(1);
    struct Arguments {
        std::string path, name, extractor = "rootsift";
        bool json = false;
    };
    auto arguments = std::make_shared<Arguments>();
    CLI::App* listing = library->add_subcommand("list", "The templates and their views");
    listing->footer("Example:\n  farol-cli library list corridor.gpkg --json");
    listing->add_option("library", arguments->path, "Library or map (*.gpkg)")->required();
    listing->add_flag("--json", arguments->json, "One JSON document");
    listing->callback([arguments, &exitCode] { exitCode = list(arguments->path, arguments->json); });
    CLI::App* removal = library->add_subcommand("remove", "Forget a template");
    removal->footer("Example:\n  farol-cli library remove corridor.gpkg extinguisher-2");
    removal->add_option("library", arguments->path, "Library or map (*.gpkg)")->required();
    removal->add_option("template", arguments->name, "Name of the template")->required();
    removal->callback([arguments, &exitCode] { exitCode = removeOne(arguments->path, arguments->name); });
    CLI::App* again = library->add_subcommand(
        "retrain", "Make all features anew from the kept photographs, also with another extractor");
    again->footer("Example:\n  farol-cli library retrain corridor.gpkg --extractor akaze");
    again->add_option("library", arguments->path, "Library or map (*.gpkg)")->required();
    again->add_option("--extractor", arguments->extractor, "rootsift, surf, orb, akaze")
        ->capture_default_str();
    again->callback([arguments, &exitCode] { exitCode = retrainAll(arguments->path, arguments->extractor); });
    CLI::App* checking =
        library->add_subcommand("check", "From where is each template found, and what is it confused with?");
    checking->footer(
        "Each view is held back once and looked for with the rest; then the squarest photograph is "
        "shown\nsmaller and turned. Metres are for a lens of 56 degrees.\n"
        "Example:\n  farol-cli library check corridor.gpkg --json");
    checking->add_option("library", arguments->path, "Library or map (*.gpkg)")->required();
    checking->add_flag("--json", arguments->json, "One JSON document");
    checking->callback([arguments, &exitCode] { exitCode = check(arguments->path, arguments->json); });
}

} // namespace farol::cli
