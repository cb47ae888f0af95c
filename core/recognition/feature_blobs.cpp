#include "core/recognition/feature_blobs.h"

#include "core/recognition/sayings.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace farol::recognition {

namespace {

constexpr std::string_view kKeypointMark = "FKP1";
constexpr std::string_view kDescriptorMark = "FDS1";
constexpr std::size_t kKeypointBytes = 7 * 4;
constexpr std::size_t kHead = 12; // mark, rows, bytes a row
constexpr std::uint32_t kMostRows = 1'000'000;
constexpr std::uint32_t kMostColumns = 4096;
constexpr std::uint32_t kWidest = 512; // of a descriptor

void put(std::string& out, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8)
        out.push_back(static_cast<char>(static_cast<unsigned char>(value >> shift)));
}

void put(std::string& out, float value) {
    put(out, std::bit_cast<std::uint32_t>(value));
}

std::uint32_t number(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    return value;
}

float real(std::string_view bytes, std::size_t at) {
    return std::bit_cast<float>(number(bytes, at));
}

Error damaged(Saying what) {
    return {ErrorCode::Corrupt, said(what), {}};
}

/// What may be wrong with the one blob or the other.
struct BlobSayings {
    Saying begin, size, length;
};

constexpr BlobSayings kOfKeypoints{Saying::KeypointsBegin, Saying::KeypointsSize, Saying::KeypointsLength};
constexpr BlobSayings kOfDescriptors{Saying::DescriptorsBegin, Saying::DescriptorsSize,
                                     Saying::DescriptorsLength};

/// The number of rows, once mark, width and length fit together.
Result<std::uint32_t> checkedRows(std::string_view bytes, std::string_view mark, const BlobSayings& wrong) {
    if (bytes.size() < kHead || bytes.substr(0, 4) != mark) return damaged(wrong.begin);
    std::uint64_t rows = number(bytes, 4);
    std::uint64_t width = number(bytes, 8);
    if (rows > kMostRows || width > kMostColumns) return damaged(wrong.size);
    if (bytes.size() != kHead + rows * width) return damaged(wrong.length);
    return static_cast<std::uint32_t>(rows);
}

Result<cv::KeyPoint> keypointAt(std::string_view bytes, std::size_t at) {
    cv::KeyPoint point;
    point.pt = {real(bytes, at), real(bytes, at + 4)};
    point.size = real(bytes, at + 8);
    point.angle = real(bytes, at + 12);
    point.response = real(bytes, at + 16);
    point.octave = std::bit_cast<std::int32_t>(number(bytes, at + 20));
    point.class_id = std::bit_cast<std::int32_t>(number(bytes, at + 24));
    constexpr float kFar = 1e6F;
    bool sane = std::abs(point.pt.x) < kFar && std::abs(point.pt.y) < kFar && point.size > 0.0F &&
                point.size < kFar && std::abs(point.angle) <= 720.0F && std::isfinite(point.response) &&
                point.class_id >= 0 && point.class_id < 256;
    if (!sane) return damaged(Saying::KeypointValue);
    return point;
}

} // namespace

FeatureBlobs encodeFeatures(const Features& features) {
    FeatureBlobs blobs;
    blobs.keypoints = kKeypointMark;
    put(blobs.keypoints, static_cast<std::uint32_t>(features.keypoints.size()));
    put(blobs.keypoints, static_cast<std::uint32_t>(kKeypointBytes));
    for (const cv::KeyPoint& point : features.keypoints) {
        for (float value : {point.pt.x, point.pt.y, point.size, point.angle, point.response})
            put(blobs.keypoints, value);
        put(blobs.keypoints, std::bit_cast<std::uint32_t>(static_cast<std::int32_t>(point.octave)));
        put(blobs.keypoints, std::bit_cast<std::uint32_t>(static_cast<std::int32_t>(point.class_id)));
    }
    blobs.descriptors = kDescriptorMark;
    put(blobs.descriptors, static_cast<std::uint32_t>(features.descriptors.rows));
    put(blobs.descriptors, static_cast<std::uint32_t>(features.descriptors.cols));
    for (int row = 0; row < features.descriptors.rows; ++row)
        blobs.descriptors.append(reinterpret_cast<const char*>(features.descriptors.ptr(row)),
                                 static_cast<std::size_t>(features.descriptors.cols));
    return blobs;
}

Result<Features> decodeFeatures(std::string_view keypoints, std::string_view descriptors) {
    auto points = checkedRows(keypoints, kKeypointMark, kOfKeypoints);
    if (!points) return points.error();
    auto rows = checkedRows(descriptors, kDescriptorMark, kOfDescriptors);
    if (!rows) return rows.error();
    if (*points != *rows) return damaged(Saying::DescriptorsCount);
    if (*points > 0 && number(keypoints, 8) != kKeypointBytes) return damaged(Saying::KeypointsOther);
    std::uint32_t width = number(descriptors, 8);
    if (width < 1 || width > kWidest) return damaged(Saying::DescriptorsOther);
    Features features;
    features.keypoints.reserve(*points);
    for (std::size_t i = 0; i < *points; ++i) {
        auto point = keypointAt(keypoints, kHead + i * kKeypointBytes);
        if (!point) return point.error();
        features.keypoints.push_back(*point);
    }
    features.descriptors = cv::Mat(static_cast<int>(*rows), static_cast<int>(width), CV_8U);
    if (*rows > 0)
        std::memcpy(features.descriptors.data, descriptors.data() + kHead, descriptors.size() - kHead);
    return features;
}

std::uint32_t checksum(std::string_view bytes, std::uint32_t seed) {
    static const std::array<std::uint32_t, 256> kTable = [] {
        std::array<std::uint32_t, 256> table{};
        for (std::uint32_t i = 0; i < 256; ++i) {
            std::uint32_t value = i;
            for (int bit = 0; bit < 8; ++bit)
                value = (value & 1U) != 0 ? 0xEDB88320U ^ (value >> 1U) : value >> 1U;
            table[i] = value;
        }
        return table;
    }();
    std::uint32_t value = ~seed;
    for (char byte : bytes)
        value = kTable[(value ^ static_cast<unsigned char>(byte)) & 0xFFU] ^ (value >> 8U);
    return ~value;
}

} // namespace farol::recognition
