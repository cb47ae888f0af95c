// The blobs of a landmark library file, which anybody may hand to us: any bytes are decoded or refused, and
// what is decoded is encoded to the same bytes again.

#include "core/recognition/feature_blobs.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace farol::recognition;
    if (size < 2) return 0;
    std::string_view bytes(reinterpret_cast<const char*>(data) + 2, size - 2);
    // The first two bytes say where the keypoints end and the descriptors begin.
    std::size_t cut = (static_cast<std::size_t>(data[0]) * 256U + data[1]) % (bytes.size() + 1);
    auto features = decodeFeatures(bytes.substr(0, cut), bytes.substr(cut));
    if (!features) return 0;
    FeatureBlobs again = encodeFeatures(*features);
    auto second = decodeFeatures(again.keypoints, again.descriptors);
    if (!second || second->keypoints.size() != features->keypoints.size()) std::abort();
    return 0;
}
