#pragma once
// What is said of a source of pictures that does not open, or ends: the module's table of sentences
// (core/base/saying.h).

#include <string>
#include <vector>

namespace farol::capture {

enum class Saying {
    NoPicture,
    SourceUnnamed,
    SourceMissing,
    FolderNotRead,
    FolderEmpty,
    NoVideo,
    AddressSilent,
    CameraUnnamed,
    CameraNotOpened,
    // While it is read.
    StreamEnded,
    StreamLost,
    StreamTried,
    StreamBack,
    SourceBroke,
    PictureSkipped,
    NoPictureNamed,
};

std::string said(Saying saying, const std::vector<std::string>& places = {});
std::vector<const char*> sayings();

} // namespace farol::capture
