#pragma once
// Nearest neighbours among byte descriptors. Only this folder includes it.

#include <opencv2/core.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace farol::recognition {

struct Neighbours {
    int each = 0;                 ///< neighbours of one query
    std::vector<int> rows;        ///< each * queries; -1 where there is none
    std::vector<float> distances; ///< squared
};

/// Lists of like descriptors, two levels deep: a query looks only into the lists whose middles are nearest.
/// The lists lie in memory in one piece each, which is what makes it fast. Adding appends; the middles are
/// found anew only when the index has doubled. Fixed seeds: two programs answer the same.
class ByteIndex {
public:
    ByteIndex() = default;
    /// On their own from then on.
    ByteIndex(const ByteIndex& other) { *this = other; }
    ByteIndex& operator=(const ByteIndex& other);
    ByteIndex(ByteIndex&&) noexcept = default;
    ByteIndex& operator=(ByteIndex&&) noexcept = default;
    ~ByteIndex() = default;
    /// `descriptors` CV_8U, all of one width; numbered on from the rows already there.
    void add(const cv::Mat& descriptors);
    /// These rows are not found any more; the numbers of the others stay.
    void remove(int first, int count);
    int size() const { return m_rows.rows; } ///< with those removed
    int living() const { return m_rows.rows - m_removedCount; }
    /// Squared Euclidean distance.
    int distance(const unsigned char* query, int row) const;

    /// `checks`: rows compared at most, of the nearest lists; at least one list is looked through.
    Neighbours search(const cv::Mat& queries, int neighbours, int checks) const;

private:
    static constexpr std::size_t kGroupsLooked = 6;
    struct List {
        std::vector<unsigned char> bytes;
        std::vector<int> numbers;
    };
    /// A query and the groups whose middles are nearest to it; -1 where there are fewer.
    struct Visit {
        int query = 0;
        std::array<int, kGroupsLooked> groups{};
    };
    struct Best;
    struct Scratch {
        std::vector<int> distances;
        std::vector<std::uint64_t> lists;
    };

    bool removed(int row) const;
    void rebuild();
    void append(int first);
    std::vector<Visit> visits(const cv::Mat& queries) const;
    void searchOne(const unsigned char* wanted, const std::array<int, kGroupsLooked>& groups, int checks,
                   Scratch& scratch, Best best) const;
    std::size_t nearestList(const unsigned char* row) const;

    cv::Mat m_rows;
    cv::Mat m_groups;               ///< middles of groups of middles
    std::vector<cv::Mat> m_middles; ///< of the lists, by group
    std::vector<std::size_t> m_firstList;
    std::vector<List> m_lists;
    int m_builtFor = 0;
    std::vector<bool> m_removed; ///< by row; shorter than the rows where none of the last is
    int m_removedCount = 0;
};

struct RowMatch {
    int query = 0;
    int row = 0;
    float ratio = 0.0F; ///< of distances, nearest to second
};

/// Exact nearest neighbours with the ratio test, each query once.
std::vector<RowMatch> ratioMatches(const cv::Mat& queries, const cv::Mat& rows, double ratio);

} // namespace farol::recognition
