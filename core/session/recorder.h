#pragma once
// A recording: a folder with recording.json (what was run on what, with which options), map.gpkg (a copy),
// walk.jsonl (percepts and commands in order, every digit kept) and frames/ (JPEG, to look at). Replay runs
// hops 3 to 6 again from the percepts and gives the same lines byte for byte.

#include "core/base/error.h"
#include "core/session/navigator.h"
#include "core/session/percept.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace farol::session {

struct RecordingHeader {
    int version = 1;
    std::string source, map, library; ///< as they were named; for people
    NavigatorOptions options;
};

/// What changed the walk or was told in it from outside the chain, in the order of the frames.
struct StartCommand {
    double time = 0.0;
    std::optional<RegionId> region;
};
struct DestinationCommand {
    std::optional<building::Location> destination;
};
struct VerbosityCommand {
    guidance::Verbosity verbosity = guidance::Verbosity::Objects;
};
struct LanguageCommand {
    std::string language;
};
struct WarningCommand {
    guidance::CueReason reason = guidance::CueReason::None;
    std::string detail;
};
struct MessageCommand {
    std::string text;
};
struct AskCommand {
    guidance::Question question = guidance::Question::WhereAmI;
};
struct HeardCommand {
    std::uint64_t cue = 0; ///< its id
};
using Command = std::variant<StartCommand, DestinationCommand, VerbosityCommand, LanguageCommand,
                             WarningCommand, MessageCommand, AskCommand, HeardCommand>;
using RecordEntry = std::variant<Percept, Command>;

/// Writes as the walk goes, handed to the system once a frame. After a failure (full disk) it stays quiet:
/// failed() tells, the walk goes on, and what was written until then can be replayed.
class Recorder {
public:
    /// The folder must be new or empty. The map goes into it as it stands in memory.
    static Result<std::unique_ptr<Recorder>> create(const std::filesystem::path& folder,
                                                    const RecordingHeader& header,
                                                    const building::Building& building);
    ~Recorder();
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    /// An empty image is no picture. The error comes once; after it every write answers "done" and does
    /// nothing.
    Result<void> write(const Percept& percept, const cv::Mat& image);
    Result<void> write(const Command& command);
    bool failed() const { return m_failed; }

private:
    Recorder(std::filesystem::path folder, int walk);
    Result<void> writeLine(const std::string& line);
    Result<void> writePicture(const std::string& name, const cv::Mat& image);
    Result<void> giveUp(Error error);

    std::filesystem::path m_folder;
    int m_walk = -1; ///< file descriptor: a stream would hide why a write failed
    bool m_failed = false;
};

struct Recording {
    RecordingHeader header;
    std::filesystem::path folder; ///< its map is folder/map.gpkg
    std::vector<RecordEntry> entries;
    std::vector<std::string> warnings; ///< a torn last line, a missing picture
};

/// NotFound, UnsupportedFormat (a later version), Corrupt (line number and reason). A torn last line, as a
/// crash leaves it, is dropped with a warning.
Result<Recording> loadRecording(const std::filesystem::path& folder);
/// The same from the two files' contents; pictures are not looked for.
Result<Recording> parseRecording(const std::string& header, const std::string& walk);

/// Replays hops 3 to 6. `options` replaces the recorded ones where given (re-voting with other settings).
struct ReplayHandlers {
    std::function<void(const NavigationStep&)> step;
    std::function<void(const guidance::Cue&)> warning;                      ///< and answers
    std::function<void(double, std::uint64_t, const std::string&)> message; ///< time, frame, text
};
Result<void> replay(const Recording& recording, std::shared_ptr<const building::Building> building,
                    const std::optional<NavigatorOptions>& options, const ReplayHandlers& handlers);

/// One command on the navigator, as the walk and its replay both do it; what is told goes to the handlers.
void apply(const Command& command, Navigator& navigator, const ReplayHandlers& handlers);

} // namespace farol::session
