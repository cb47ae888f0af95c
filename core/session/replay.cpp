#include "core/base/file.h"
#include "core/session/recorder.h"
#include "core/session/recording_json.h"
#include "core/session/sayings.h"

#include <utility>

namespace farol::session {

namespace fs = std::filesystem;

namespace {

Error onLine(Error error, std::size_t number) {
    error.context = "walk.jsonl, line " + std::to_string(number);
    return error;
}

struct Lines {
    std::vector<RecordLine> lines;
    std::vector<std::string> warnings;
};

Result<Lines> parseWalk(const std::string& walk) {
    Lines result;
    std::size_t number = 0;
    for (std::size_t at = 0; at < walk.size();) {
        std::size_t end = walk.find('\n', at);
        bool torn = end == std::string::npos;
        std::string text = walk.substr(at, torn ? end : end - at);
        at = torn ? walk.size() : end + 1;
        ++number;
        auto json = parsedJson(text);
        if (!json && torn) {
            result.warnings.push_back("walk.jsonl, line " + std::to_string(number) +
                                      ": the last line was not written to its end and is left out");
            break;
        }
        if (!json) return onLine({ErrorCode::Corrupt, said(Saying::NoJson), ""}, number);
        auto line = recordLineFromJson(*json);
        if (!line) return onLine(line.error(), number);
        result.lines.push_back(std::move(line).value());
    }
    return result;
}

Error inFolder(Error error, const fs::path& folder) {
    error.context = folder.string() + (error.context.empty() ? "" : ", " + error.context);
    return error;
}

Result<RecordingHeader> parseHeader(const std::string& text) {
    auto json = parsedJson(text);
    if (!json) return Error{ErrorCode::Corrupt, said(Saying::NoJson), "recording.json"};
    auto header = headerFromJson(*json);
    if (header) return header;
    Error error = header.error();
    error.context = "recording.json";
    return error;
}

Result<Recording> assemble(const std::string& header, const std::string& walk, const fs::path& folder) {
    auto parsed = parseHeader(header);
    if (!parsed) return parsed.error();
    auto lines = parseWalk(walk);
    if (!lines) return lines.error();
    Recording recording{std::move(parsed).value(), folder, {}, std::move(lines->warnings)};
    std::size_t missing = 0;
    std::string firstMissing;
    for (RecordLine& line : lines->lines) {
        std::error_code failure;
        if (!folder.empty() && !line.picture.empty() && !fs::exists(folder / line.picture, failure)) {
            if (missing++ == 0) firstMissing = line.picture;
        }
        recording.entries.push_back(std::move(line.entry));
    }
    if (missing > 0)
        recording.warnings.push_back(firstMissing + " is missing (" + std::to_string(missing) +
                                     " pictures in all); the walk replays without them");
    return recording;
}

} // namespace

Result<Recording> parseRecording(const std::string& header, const std::string& walk) {
    return assemble(header, walk, {});
}

Result<Recording> loadRecording(const fs::path& folder) {
    std::error_code failure;
    if (!fs::is_directory(folder, failure))
        return Error{ErrorCode::NotFound, said(Saying::NoFolder), folder.string()};
    if (!fs::exists(folder / "recording.json", failure))
        return Error{ErrorCode::NotFound, said(Saying::NoRecording), folder.string()};
    auto header = readFile(folder / "recording.json");
    if (!header) return header.error();
    auto walk = readFile(folder / "walk.jsonl");
    if (!walk) return walk.error();
    auto recording = assemble(*header, *walk, folder);
    if (!recording) return inFolder(recording.error(), folder);
    return recording;
}

void apply(const Command& command, Navigator& navigator, const ReplayHandlers& handlers) {
    if (const auto* start = std::get_if<StartCommand>(&command)) {
        navigator.start(start->time, start->region);
    } else if (const auto* destination = std::get_if<DestinationCommand>(&command)) {
        navigator.setDestination(destination->destination);
    } else if (const auto* verbosity = std::get_if<VerbosityCommand>(&command)) {
        navigator.setVerbosity(verbosity->verbosity);
    } else if (const auto* language = std::get_if<LanguageCommand>(&command)) {
        navigator.setLanguage(language->language);
    } else if (const auto* warning = std::get_if<WarningCommand>(&command)) {
        guidance::Cue cue = navigator.warning(warning->reason, warning->detail);
        if (handlers.warning) handlers.warning(cue);
    } else if (const auto* heard = std::get_if<HeardCommand>(&command)) {
        navigator.heard(heard->cue);
    } else if (const auto* ask = std::get_if<AskCommand>(&command)) {
        guidance::Cue cue = navigator.answer(ask->question);
        if (handlers.warning) handlers.warning(cue);
    } else if (const auto* message = std::get_if<MessageCommand>(&command)) {
        if (handlers.message) handlers.message(navigator.lastTime(), navigator.lastFrame(), message->text);
    }
}

Result<void> replay(const Recording& recording, std::shared_ptr<const building::Building> building,
                    const std::optional<NavigatorOptions>& options, const ReplayHandlers& handlers) {
    auto navigator = Navigator::create(std::move(building), options.value_or(recording.header.options));
    if (!navigator) return navigator.error();
    for (const RecordEntry& entry : recording.entries) {
        if (const auto* command = std::get_if<Command>(&entry)) {
            apply(*command, **navigator, handlers);
        } else {
            NavigationStep step = (*navigator)->advance(std::get<Percept>(entry));
            if (handlers.step) handlers.step(step);
        }
    }
    return {};
}

} // namespace farol::session
