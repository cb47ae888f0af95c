#pragma once
// Keypoints and descriptors as they stand in a library file: little-endian bytes, checked on the way in, so
// that no damaged file can do more than be refused.

#include "core/base/error.h"
#include "core/recognition/feature_extractor.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace farol::recognition {

struct FeatureBlobs {
    std::string keypoints;
    std::string descriptors;
};

FeatureBlobs encodeFeatures(const Features& features);
/// Corrupt with a reason; the caller adds the template and the view.
Result<Features> decodeFeatures(std::string_view keypoints, std::string_view descriptors);

/// CRC-32 (the one of zip), continued from `seed`.
std::uint32_t checksum(std::string_view bytes, std::uint32_t seed = 0);

} // namespace farol::recognition
