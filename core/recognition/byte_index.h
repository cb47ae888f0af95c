#pragma once
// Nearest neighbours among byte descriptors. Only this folder includes it.

#include <opencv2/core.hpp>

#include <memory>
#include <vector>

namespace farol::recognition {

/// Squared Euclidean distance of two descriptors of 128 bytes.
int byteDistance(const unsigned char* a, const unsigned char* b);

struct Neighbours {
    int each = 0;                 ///< neighbours of one query
    std::vector<int> rows;        ///< each * queries; -1 where there is none
    std::vector<float> distances; ///< squared
};

/// Randomised KD-trees, built from a fixed seed so that two programs answer the same.
class ByteIndex {
public:
    /// `descriptors` CV_8U x 128, not empty; kept.
    explicit ByteIndex(cv::Mat descriptors);
    ~ByteIndex();
    ByteIndex(const ByteIndex&) = delete;
    ByteIndex& operator=(const ByteIndex&) = delete;

    Neighbours search(const cv::Mat& queries, int neighbours, int checks) const;

private:
    struct Trees;
    cv::Mat m_descriptors;
    std::unique_ptr<Trees> m_trees;
};

struct RowMatch {
    int query = 0;
    int row = 0;
    float ratio = 0.0F; ///< of distances, nearest to second
};

/// Exact nearest neighbours with the ratio test, each query once.
std::vector<RowMatch> ratioMatches(const cv::Mat& queries, const cv::Mat& rows, double ratio);

} // namespace farol::recognition
