#include "core/recognition/byte_index.h"

#include <opencv2/flann/defines.h> // matrix.h forgets it
#include <opencv2/flann/kdtree_index.h>

#include <cmath>
#include <limits>

// The distance is nearly all the time of recognition: the compiler writes it for the newest processors as
// well, and the right one is chosen at start. Sanitizers cannot instrument that choice.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) &&     \
    !defined(__SANITIZE_THREAD__)
#define FAROL_FAST_DISTANCE __attribute__((target_clones("avx2", "default")))
#else
#define FAROL_FAST_DISTANCE
#endif

namespace farol::recognition {

namespace {

constexpr int kBytes = 128;

FAROL_FAST_DISTANCE int squaredDistance(const unsigned char* a, const unsigned char* b) {
    int sum = 0;
    for (int i = 0; i < kBytes; ++i) {
        auto difference = static_cast<short>(a[i] - b[i]);
        sum += difference * difference;
    }
    return sum;
}

/// Of one query to many rows at once, so that the choice of the processor's version is paid once.
FAROL_FAST_DISTANCE void squaredDistances(const unsigned char* query, const unsigned char* rows, int count,
                                          int* out) {
    for (int row = 0; row < count; ++row) {
        const unsigned char* b = rows + static_cast<std::ptrdiff_t>(row) * kBytes;
        int sum = 0;
        for (int i = 0; i < kBytes; ++i) {
            auto difference = static_cast<short>(query[i] - b[i]);
            sum += difference * difference;
        }
        out[row] = sum;
    }
}

/// What cvflann wants of a distance.
struct ByteL2 {
    using is_kdtree_distance = cvflann::True;
    using is_vector_space_distance = cvflann::True;
    using ElementType = unsigned char;
    using ResultType = float;
    using CentersType = float;

    template <class First, class Second>
    float operator()(First a, Second b, std::size_t size, float = -1) const {
        if constexpr (std::is_convertible_v<First, const unsigned char*> &&
                      std::is_convertible_v<Second, const unsigned char*>) {
            if (size == kBytes) return static_cast<float>(squaredDistance(a, b));
        }
        float sum = 0.0F;
        for (std::size_t i = 0; i < size; ++i) {
            float difference = static_cast<float>(a[i]) - static_cast<float>(b[i]);
            sum += difference * difference;
        }
        return sum;
    }
    float accum_dist(float a, float b, int) const { return (a - b) * (a - b); }
};

} // namespace

int byteDistance(const unsigned char* a, const unsigned char* b) {
    return squaredDistance(a, b);
}

struct ByteIndex::Trees {
    cvflann::Matrix<unsigned char> rows;
    cvflann::KDTreeIndex<ByteL2> index;

    explicit Trees(const cv::Mat& descriptors)
        : rows(const_cast<unsigned char*>(descriptors.ptr()), static_cast<std::size_t>(descriptors.rows),
               kBytes),
          index(rows, cvflann::KDTreeIndexParams(4)) {
        cv::RNG& generator = cv::theRNG(); // the trees draw from it
        cv::RNG before = generator;
        generator.state = 0x5EEDF00DU;
        index.buildIndex();
        generator = before;
    }
};

ByteIndex::ByteIndex(cv::Mat descriptors)
    : m_descriptors(descriptors.isContinuous() ? std::move(descriptors) : descriptors.clone()),
      m_trees(std::make_unique<Trees>(m_descriptors)) {}

ByteIndex::~ByteIndex() = default;

Neighbours ByteIndex::search(const cv::Mat& queries, int neighbours, int checks) const {
    Neighbours found;
    found.each = neighbours;
    auto total = static_cast<std::size_t>(queries.rows) * static_cast<std::size_t>(neighbours);
    found.rows.assign(total, -1);
    found.distances.assign(total, std::numeric_limits<float>::max());
    cvflann::SearchParams parameters(checks);
    for (int query = 0; query < queries.rows; ++query) {
        std::size_t at = static_cast<std::size_t>(query) * static_cast<std::size_t>(neighbours);
        cvflann::KNNUniqueResultSet<float> best(static_cast<unsigned>(neighbours));
        m_trees->index.findNeighbors(best, queries.ptr(query), parameters);
        std::size_t count = std::min(best.size(), static_cast<std::size_t>(neighbours));
        best.sortAndCopy(found.rows.data() + at, found.distances.data() + at, static_cast<int>(count));
    }
    return found;
}

std::vector<RowMatch> ratioMatches(const cv::Mat& queries, const cv::Mat& rows, double ratio) {
    std::vector<RowMatch> matches;
    if (queries.empty() || rows.rows < 2) return matches;
    cv::Mat table = rows.isContinuous() ? rows : rows.clone();
    std::vector<int> distances(static_cast<std::size_t>(table.rows));
    for (int query = 0; query < queries.rows; ++query) {
        squaredDistances(queries.ptr(query), table.ptr(), table.rows, distances.data());
        int best = std::numeric_limits<int>::max();
        int second = best;
        int row = -1;
        for (int i = 0; i < table.rows; ++i) {
            int distance = distances[static_cast<std::size_t>(i)];
            if (distance < best) {
                second = best;
                best = distance;
                row = i;
            } else if (distance < second) {
                second = distance;
            }
        }
        double share = std::sqrt(static_cast<double>(best) / std::max(second, 1));
        if (share < ratio) matches.push_back({query, row, static_cast<float>(share)});
    }
    return matches;
}

} // namespace farol::recognition
