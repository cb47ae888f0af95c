#pragma once
// What is said of a walk and its recording: the module's table of sentences (core/base/saying.h).

#include <string>
#include <vector>

namespace farol::session {

enum class Saying {
    NoFolder,
    NoRecording,
    NoJson,
    NoHeader,
    RecordingLater,
    LineUnknown,
    FolderIsFile,
    FolderNotEmpty,
    NotCreated,
    RecordingNotCreated,
    PictureNotEncoded,
    RecordingStopped,
    WalkBrokeOff,
    FrameNotLookedAt,
    NoSource,
    NoMap,
};

std::string said(Saying saying, const std::vector<std::string>& places = {});
std::vector<const char*> sayings();

} // namespace farol::session
