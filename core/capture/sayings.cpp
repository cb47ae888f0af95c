#include "core/capture/sayings.h"

#include "core/base/saying.h"

namespace farol::capture {

namespace {

constexpr farol::Saying<Saying> kTable[]{
    {Saying::NoPicture, SAID("core", "cannot be read as a picture")},
    {Saying::SourceUnnamed,
     SAID("core", "no source was named: give camera:0, a video file, a folder of pictures or an address")},
    {Saying::SourceMissing, SAID("core", "there is no such file or folder (a source is camera:0, a video "
                                         "file, a folder of pictures, or an http or rtsp address)")},
    {Saying::FolderNotRead, SAID("core", "the folder cannot be read")},
    {Saying::FolderEmpty, SAID("core", "there are no pictures in this folder (jpg, png, bmp, webp or tif)")},
    {Saying::NoVideo,
     SAID("core", "is neither a picture nor a video that can be opened (tried FFmpeg and GStreamer)")},
    {Saying::AddressSilent, SAID("core", "the address does not answer with a video within %1 s (tried "
                                         "FFmpeg): is the camera on, and the address right?")},
    {Saying::CameraUnnamed, SAID("core", "a camera is named by its number or its device, such as camera:0")},
    {Saying::CameraNotOpened, SAID("core", "the camera cannot be opened (tried Video4Linux at %1): is it "
                                           "plugged in, and not in use by another program?")},
    // While it is read.
    {Saying::StreamEnded, SAID("core", "%1 delivers no more pictures")},
    {Saying::StreamLost, SAID("core", "%1 gives no more pictures")},
    {Saying::StreamTried, SAID("core", "%1 is tried again (attempt %2)")},
    {Saying::StreamBack, SAID("core", "%1 is back")},
    {Saying::SourceBroke, SAID("core", "%1 broke down: %2")},
    {Saying::PictureSkipped, SAID("core", "%1; skipped (%2 so far)")},
    {Saying::NoPictureNamed,
     SAID("core", "%1 cannot be read as a picture")}, // the commonest of its first places
};
static_assert(inOrder(kTable), "said() looks rows up by their number");

} // namespace

std::string said(Saying saying, const std::vector<std::string>& places) {
    return withPlaces(kTable[static_cast<std::size_t>(saying)].english, places);
}

std::vector<const char*> sayings() {
    return englishOf(kTable);
}

} // namespace farol::capture
