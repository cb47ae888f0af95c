// The description of a user's own detector: any bytes are a description whose numbers are within their
// limits, or an error that says something.

#include "core/recognition/network_detector.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using farol::recognition::DetectorDescription;
    std::string_view bytes(reinterpret_cast<const char*>(data), size);
    auto description = DetectorDescription::parse(bytes, "folder/detector.json");
    if (!description) {
        if (description.error().message.empty() || description.error().context.empty()) std::abort();
        return 0;
    }
    bool sane = description->width >= 16 && description->width <= 2048 && description->height >= 16 &&
                description->height <= 2048 && description->scale > 0.0 && description->minScore > 0.0 &&
                description->minScore <= 1.0 && description->maxOverlap >= 0.0 &&
                description->maxOverlap <= 1.0 && !description->classes.empty();
    if (!sane) std::abort();
    return 0;
}
