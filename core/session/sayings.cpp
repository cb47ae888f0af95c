#include "core/session/sayings.h"

#include "core/base/saying.h"

namespace farol::session {

namespace {

constexpr farol::Saying<Saying> kTable[]{
    {Saying::NoFolder, SAID("core", "there is no such folder")},
    {Saying::NoRecording, SAID("core", "is not a recording: it holds no recording.json")},
    {Saying::NoJson, SAID("core", "is not JSON")},
    {Saying::NoHeader, SAID("core", "is not the header of a recording")},
    {Saying::RecordingLater,
     SAID("core", "was made by a later version of Farol (recording format %1, this program reads up to %2)")},
    {Saying::LineUnknown, SAID("core", "is neither a percept nor a command")},
    {Saying::FolderIsFile, SAID("core", "is a file; a new or empty folder is wanted for a recording")},
    {Saying::FolderNotEmpty,
     SAID("core", "is not empty; choose a new folder, so that no recording is overwritten")},
    {Saying::NotCreated, SAID("core", "cannot create")},
    {Saying::RecordingNotCreated, SAID("core", "cannot create the recording")},
    {Saying::PictureNotEncoded, SAID("core", "cannot encode the picture")},
    {Saying::RecordingStopped, SAID("core", "the recording stopped (%1); the walk goes on")},
    {Saying::WalkBrokeOff, SAID("core", "the walk broke off: %1")},
    {Saying::FrameNotLookedAt, SAID("core", "frame %1 could not be looked at: %2")},
    {Saying::NoSource, SAID("core", "there is no source of pictures; open one first")},
    {Saying::NoMap, SAID("core", "there is no map; open one first")},
};
static_assert(inOrder(kTable), "said() looks rows up by their number");

} // namespace

std::string said(Saying saying, const std::vector<std::string>& places) {
    return withPlaces(kTable[static_cast<std::size_t>(saying)].english, places);
}

std::vector<const char*> sayings() {
    return englishOf(kTable);
}

} // namespace farol::session
