#include "core/recognition/byte_index.h"

#include "core/recognition/wide_code.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace farol::recognition {

namespace {

constexpr int kBytes = 128;
constexpr int kRounds = 6;      // of moving the middles
constexpr int kRowsOfList = 64; // wanted on average
constexpr int kMostMiddles = 16384;
constexpr int kSamplesOfMiddle = 24; // rows that place it
constexpr std::size_t kGroupsLooked = 6;

FAROL_WIDE int squaredDistance(const unsigned char* a, const unsigned char* b) {
    int sum = 0;
    for (int i = 0; i < kBytes; ++i) {
        auto difference = static_cast<short>(a[i] - b[i]);
        sum += difference * difference;
    }
    return sum;
}

/// Of one query to many rows at once, so that the choice of the processor's version is paid once.
FAROL_WIDE void squaredDistances(const unsigned char* query, const unsigned char* rows, int count, int* out) {
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

int nearest(const cv::Mat& middles, const unsigned char* row, std::vector<int>& distances) {
    distances.resize(static_cast<std::size_t>(middles.rows));
    squaredDistances(row, middles.ptr(), middles.rows, distances.data());
    return static_cast<int>(std::min_element(distances.begin(), distances.end()) - distances.begin());
}

/// Middles of the rows by k-means, begun from rows evenly picked. A middle that loses all its rows stays.
cv::Mat middlesOf(const cv::Mat& rows, int count) {
    cv::Mat middles(count, kBytes, CV_8U);
    for (int i = 0; i < count; ++i)
        rows.row(static_cast<int>(static_cast<std::int64_t>(i) * rows.rows / count)).copyTo(middles.row(i));
    std::vector<int> distances;
    for (int round = 0; round < kRounds; ++round) {
        cv::Mat sums = cv::Mat::zeros(count, kBytes, CV_32S);
        std::vector<int> members(static_cast<std::size_t>(count), 0);
        for (int row = 0; row < rows.rows; ++row) {
            int at = nearest(middles, rows.ptr(row), distances);
            ++members[static_cast<std::size_t>(at)];
            int* sum = sums.ptr<int>(at);
            for (int i = 0; i < kBytes; ++i) sum[i] += rows.ptr(row)[i];
        }
        for (int at = 0; at < count; ++at) {
            int n = members[static_cast<std::size_t>(at)];
            for (int i = 0; i < kBytes && n > 0; ++i)
                middles.at<unsigned char>(at, i) =
                    static_cast<unsigned char>((sums.at<int>(at, i) + n / 2) / n);
        }
    }
    return middles;
}

cv::Mat evenly(const cv::Mat& rows, int most) {
    if (rows.rows <= most) return rows;
    cv::Mat some(most, kBytes, CV_8U);
    for (int i = 0; i < most; ++i)
        rows.row(static_cast<int>(static_cast<std::int64_t>(i) * rows.rows / most)).copyTo(some.row(i));
    return some;
}

/// The nearest few so far, nearest first.
struct Best {
    int* rows;
    float* distances;
    int most;
    int count = 0;
    int limit = std::numeric_limits<int>::max();

    void offer(int row, int distance) {
        int at = count < most ? count++ : most - 1;
        auto d = static_cast<float>(distance);
        for (; at > 0 && distances[at - 1] > d; --at) {
            rows[at] = rows[at - 1];
            distances[at] = distances[at - 1];
        }
        rows[at] = row;
        distances[at] = d;
        if (count == most) limit = static_cast<int>(distances[most - 1]);
    }
};

} // namespace

int byteDistance(const unsigned char* a, const unsigned char* b) {
    return squaredDistance(a, b);
}

void ByteIndex::add(const cv::Mat& descriptors) {
    if (descriptors.empty()) return;
    int first = m_rows.rows;
    if (m_rows.empty()) m_rows = cv::Mat(0, kBytes, CV_8U);
    m_rows.push_back(descriptors);
    if (m_rows.rows >= 2 * m_builtFor)
        rebuild();
    else
        append(first);
}

void ByteIndex::rebuild() {
    m_builtFor = m_rows.rows;
    int count = std::clamp(m_rows.rows / kRowsOfList, 1, kMostMiddles);
    int groups = std::max(1, static_cast<int>(std::lround(std::sqrt(static_cast<double>(count)))));
    // Two levels of k-means: the middles of each group are placed by its own rows only.
    cv::Mat samples = evenly(m_rows, count * kSamplesOfMiddle);
    m_groups = middlesOf(evenly(samples, groups * 4 * kSamplesOfMiddle), groups);
    std::vector<cv::Mat> parts(static_cast<std::size_t>(groups));
    std::vector<int> distances;
    for (int row = 0; row < samples.rows; ++row)
        parts[static_cast<std::size_t>(nearest(m_groups, samples.ptr(row), distances))].push_back(
            samples.row(row));
    m_middles.clear();
    m_firstList.clear();
    std::size_t lists = 0;
    for (int group = 0; group < groups; ++group) {
        const cv::Mat& part = parts[static_cast<std::size_t>(group)];
        int wanted =
            std::max(1, static_cast<int>(static_cast<std::int64_t>(part.rows) * count / samples.rows));
        m_middles.push_back(part.empty() ? m_groups.row(group).clone() : middlesOf(part, wanted));
        m_firstList.push_back(lists);
        lists += static_cast<std::size_t>(m_middles.back().rows);
    }
    m_lists.assign(lists, {});
    append(0);
}

std::size_t ByteIndex::nearestList(const unsigned char* row) const {
    std::vector<int> distances;
    auto group = static_cast<std::size_t>(nearest(m_groups, row, distances));
    return m_firstList[group] + static_cast<std::size_t>(nearest(m_middles[group], row, distances));
}

void ByteIndex::append(int first) {
    for (int number = first; number < m_rows.rows; ++number) {
        List& list = m_lists[nearestList(m_rows.ptr(number))];
        list.bytes.insert(list.bytes.end(), m_rows.ptr(number), m_rows.ptr(number) + kBytes);
        list.numbers.push_back(number);
    }
}

Neighbours ByteIndex::search(const cv::Mat& queries, int neighbours, int checks) const {
    Neighbours found;
    found.each = neighbours;
    auto total = static_cast<std::size_t>(queries.rows) * static_cast<std::size_t>(neighbours);
    found.rows.assign(total, -1);
    found.distances.assign(total, std::numeric_limits<float>::max());
    if (m_rows.empty()) return found;
    std::vector<int> distances;
    std::vector<std::pair<int, std::size_t>> groups, lists;
    for (int query = 0; query < queries.rows; ++query) {
        const unsigned char* wanted = queries.ptr(query);
        distances.resize(static_cast<std::size_t>(m_groups.rows));
        squaredDistances(wanted, m_groups.ptr(), m_groups.rows, distances.data());
        groups.clear();
        for (std::size_t i = 0; i < distances.size(); ++i) groups.emplace_back(distances[i], i);
        std::size_t looked = std::min(kGroupsLooked, groups.size());
        std::partial_sort(groups.begin(), groups.begin() + static_cast<std::ptrdiff_t>(looked), groups.end());
        lists.clear();
        for (std::size_t g = 0; g < looked; ++g) {
            const cv::Mat& middles = m_middles[groups[g].second];
            distances.resize(static_cast<std::size_t>(middles.rows));
            squaredDistances(wanted, middles.ptr(), middles.rows, distances.data());
            for (std::size_t i = 0; i < distances.size(); ++i)
                lists.emplace_back(distances[i], m_firstList[groups[g].second] + i);
        }
        std::size_t at = static_cast<std::size_t>(query) * static_cast<std::size_t>(neighbours);
        Best best{found.rows.data() + at, found.distances.data() + at, neighbours};
        int left = checks;
        auto nearer = [](const auto& a, const auto& b) { return a > b; };
        std::make_heap(lists.begin(), lists.end(), nearer);
        while (left > 0 && !lists.empty()) {
            std::pop_heap(lists.begin(), lists.end(), nearer);
            const List& list = m_lists[lists.back().second];
            lists.pop_back();
            int count = static_cast<int>(list.numbers.size());
            distances.resize(list.numbers.size());
            squaredDistances(wanted, list.bytes.data(), count, distances.data());
            for (std::size_t i = 0; i < list.numbers.size(); ++i)
                if (distances[i] < best.limit) best.offer(list.numbers[i], distances[i]);
            left -= std::max(count, 1);
        }
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
