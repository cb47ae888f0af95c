#include "core/recognition/byte_index.h"

#include "core/recognition/wide_code.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>

namespace farol::recognition {

namespace {

constexpr int kBytes = 128;     // of the usual descriptor, whose loops the compiler unrolls
constexpr int kRounds = 6;      // of moving the middles
constexpr int kRowsOfList = 64; // wanted on average
constexpr int kMostMiddles = 16384;
constexpr int kSamplesOfMiddle = 24; // rows that place it

FAROL_WIDE int squaredDistance(const unsigned char* a, const unsigned char* b, int bytes) {
    int sum = 0;
    for (int i = 0; i < bytes; ++i) {
        auto difference = static_cast<short>(a[i] - b[i]);
        sum += difference * difference;
    }
    return sum;
}

/// Of one query to many rows at once, so that the choice of the processor's version is paid once; four rows
/// side by side keep its units busy.
FAROL_WIDE void usualDistances(const unsigned char* query, const unsigned char* rows, int count, int* out) {
    int row = 0;
    for (; row + 4 <= count; row += 4) {
        const unsigned char* b = rows + static_cast<std::ptrdiff_t>(row) * kBytes;
        int sum0 = 0, sum1 = 0, sum2 = 0, sum3 = 0;
        for (int i = 0; i < kBytes; ++i) {
            auto d0 = static_cast<short>(query[i] - b[i]);
            auto d1 = static_cast<short>(query[i] - b[i + kBytes]);
            auto d2 = static_cast<short>(query[i] - b[i + 2 * kBytes]);
            auto d3 = static_cast<short>(query[i] - b[i + 3 * kBytes]);
            sum0 += d0 * d0;
            sum1 += d1 * d1;
            sum2 += d2 * d2;
            sum3 += d3 * d3;
        }
        out[row] = sum0;
        out[row + 1] = sum1;
        out[row + 2] = sum2;
        out[row + 3] = sum3;
    }
    for (; row < count; ++row) {
        const unsigned char* b = rows + static_cast<std::ptrdiff_t>(row) * kBytes;
        int sum = 0;
        for (int i = 0; i < kBytes; ++i) {
            auto difference = static_cast<short>(query[i] - b[i]);
            sum += difference * difference;
        }
        out[row] = sum;
    }
}

void squaredDistances(const unsigned char* query, const unsigned char* rows, int bytes, int count, int* out) {
    if (bytes == kBytes) return usualDistances(query, rows, count, out);
    for (int row = 0; row < count; ++row)
        out[row] = squaredDistance(query, rows + static_cast<std::ptrdiff_t>(row) * bytes, bytes);
}

int nearest(const cv::Mat& middles, const unsigned char* row, std::vector<int>& distances) {
    distances.resize(static_cast<std::size_t>(middles.rows));
    squaredDistances(row, middles.ptr(), middles.cols, middles.rows, distances.data());
    return static_cast<int>(std::min_element(distances.begin(), distances.end()) - distances.begin());
}

/// Middles of the rows by k-means, begun from rows evenly picked. A middle that loses all its rows stays.
cv::Mat middlesOf(const cv::Mat& rows, int count) {
    const int bytes = rows.cols;
    cv::Mat middles(count, bytes, CV_8U);
    for (int i = 0; i < count; ++i)
        rows.row(static_cast<int>(static_cast<std::int64_t>(i) * rows.rows / count)).copyTo(middles.row(i));
    std::vector<int> distances;
    for (int round = 0; round < kRounds; ++round) {
        cv::Mat sums = cv::Mat::zeros(count, bytes, CV_32S);
        std::vector<int> members(static_cast<std::size_t>(count), 0);
        for (int row = 0; row < rows.rows; ++row) {
            int at = nearest(middles, rows.ptr(row), distances);
            ++members[static_cast<std::size_t>(at)];
            int* sum = sums.ptr<int>(at);
            for (int i = 0; i < bytes; ++i) sum[i] += rows.ptr(row)[i];
        }
        for (int at = 0; at < count; ++at) {
            int n = members[static_cast<std::size_t>(at)];
            for (int i = 0; i < bytes && n > 0; ++i)
                middles.at<unsigned char>(at, i) =
                    static_cast<unsigned char>((sums.at<int>(at, i) + n / 2) / n);
        }
    }
    return middles;
}

cv::Mat evenly(const cv::Mat& rows, int most) {
    if (rows.rows <= most) return rows;
    cv::Mat some(most, rows.cols, CV_8U);
    for (int i = 0; i < most; ++i)
        rows.row(static_cast<int>(static_cast<std::int64_t>(i) * rows.rows / most)).copyTo(some.row(i));
    return some;
}

int* room(std::vector<int>& distances, int count) {
    if (distances.size() < static_cast<std::size_t>(count)) distances.resize(static_cast<std::size_t>(count));
    return distances.data();
}

/// Distance and number in one word, which sorts faster than a pair.
void appendWords(const int* distances, int count, std::size_t first, std::vector<std::uint64_t>& words) {
    std::size_t at = words.size();
    words.resize(at + static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        words[at + static_cast<std::size_t>(i)] =
            (static_cast<std::uint64_t>(distances[i]) << 32U) | (first + static_cast<std::size_t>(i));
}

std::size_t whichOf(std::uint64_t word) {
    return word & 0xFFFFFFFFU;
}

/// A few more words in their place; answers how many are now. Seldom is more than the first handful wanted.
std::size_t sortedFurther(std::vector<std::uint64_t>& words, std::size_t sorted) {
    constexpr std::size_t kAtOnce = 12;
    auto begin = words.begin() + static_cast<std::ptrdiff_t>(sorted);
    std::size_t end = std::min(sorted + kAtOnce, words.size());
    auto middle = words.begin() + static_cast<std::ptrdiff_t>(end);
    if (middle != words.end()) std::nth_element(begin, middle, words.end());
    std::sort(begin, middle);
    return end;
}

} // namespace

/// The nearest few so far, nearest first.
struct ByteIndex::Best {
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

int ByteIndex::distance(const unsigned char* query, int row) const {
    return squaredDistance(query, m_rows.ptr(row), m_rows.cols);
}

void ByteIndex::add(const cv::Mat& descriptors) {
    if (descriptors.empty()) return;
    int first = m_rows.rows;
    if (m_rows.empty()) m_rows = cv::Mat(0, descriptors.cols, CV_8U);
    m_rows.push_back(descriptors);
    if (m_rows.rows >= 2 * m_builtFor)
        rebuild();
    else
        append(first);
}

ByteIndex& ByteIndex::operator=(const ByteIndex& other) {
    m_rows = other.m_rows.clone(); // to which both may append
    m_groups = other.m_groups;
    m_middles = other.m_middles;
    m_firstList = other.m_firstList;
    m_lists = other.m_lists;
    m_builtFor = other.m_builtFor;
    m_removed = other.m_removed;
    m_removedCount = other.m_removedCount;
    return *this;
}

bool ByteIndex::removed(int row) const {
    auto at = static_cast<std::size_t>(row);
    return at < m_removed.size() && m_removed[at];
}

void ByteIndex::remove(int first, int count) {
    const int end = std::clamp(first + std::max(count, 0), 0, m_rows.rows);
    first = std::clamp(first, 0, end);
    if (first == end) return;
    if (m_removed.size() < static_cast<std::size_t>(end))
        m_removed.resize(static_cast<std::size_t>(end), false);
    std::set<std::size_t> touched;
    for (int row = first; row < end; ++row) {
        if (removed(row)) continue;
        m_removed[static_cast<std::size_t>(row)] = true;
        ++m_removedCount;
        touched.insert(nearestList(m_rows.ptr(row)));
    }
    const auto width = static_cast<std::size_t>(m_rows.cols);
    for (std::size_t number : touched) {
        List& list = m_lists[number];
        std::size_t kept = 0;
        for (std::size_t i = 0; i < list.numbers.size(); ++i) {
            if (removed(list.numbers[i])) continue;
            if (kept != i) {
                list.numbers[kept] = list.numbers[i];
                std::copy_n(list.bytes.data() + i * width, width, list.bytes.data() + kept * width);
            }
            ++kept;
        }
        list.numbers.resize(kept);
        list.bytes.resize(kept * width);
    }
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
        if (removed(number)) continue;
        List& list = m_lists[nearestList(m_rows.ptr(number))];
        list.bytes.insert(list.bytes.end(), m_rows.ptr(number), m_rows.ptr(number) + m_rows.cols);
        list.numbers.push_back(number);
    }
}

Neighbours ByteIndex::search(const cv::Mat& queries, int neighbours, int checks) const {
    Neighbours found;
    found.each = neighbours;
    auto total = static_cast<std::size_t>(queries.rows) * static_cast<std::size_t>(neighbours);
    found.rows.assign(total, -1);
    found.distances.assign(total, std::numeric_limits<float>::max());
    if (m_rows.empty() || queries.cols != m_rows.cols) return found;
    Scratch scratch;
    for (const Visit& visit : visits(queries)) {
        std::size_t at = static_cast<std::size_t>(visit.query) * static_cast<std::size_t>(neighbours);
        searchOne(queries.ptr(visit.query), visit.groups, checks, scratch,
                  {found.rows.data() + at, found.distances.data() + at, neighbours});
    }
    return found;
}

std::vector<ByteIndex::Visit> ByteIndex::visits(const cv::Mat& queries) const {
    std::vector<Visit> all(static_cast<std::size_t>(queries.rows));
    std::vector<int> distances;
    std::vector<std::uint64_t> groups;
    for (int query = 0; query < queries.rows; ++query) {
        squaredDistances(queries.ptr(query), m_groups.ptr(), m_groups.cols, m_groups.rows,
                         room(distances, m_groups.rows));
        groups.clear();
        appendWords(distances.data(), m_groups.rows, 0, groups);
        std::size_t looked = std::min(kGroupsLooked, groups.size());
        std::partial_sort(groups.begin(), groups.begin() + static_cast<std::ptrdiff_t>(looked), groups.end());
        Visit& visit = all[static_cast<std::size_t>(query)];
        visit.query = query;
        visit.groups.fill(-1);
        for (std::size_t g = 0; g < looked; ++g) visit.groups[g] = static_cast<int>(whichOf(groups[g]));
    }
    // Like queries one after the other find their lists still in the processor's cache.
    std::stable_sort(all.begin(), all.end(),
                     [](const Visit& a, const Visit& b) { return a.groups < b.groups; });
    return all;
}

void ByteIndex::searchOne(const unsigned char* wanted, const std::array<int, kGroupsLooked>& groups,
                          int checks, Scratch& scratch, Best best) const {
    auto& [distances, lists] = scratch;
    lists.clear();
    for (int number : groups) {
        if (number < 0) break;
        auto group = static_cast<std::size_t>(number);
        const cv::Mat& middles = m_middles[group];
        squaredDistances(wanted, middles.ptr(), middles.cols, middles.rows, room(distances, middles.rows));
        appendWords(distances.data(), middles.rows, m_firstList[group], lists);
    }
    std::size_t sorted = 0;
    for (std::size_t next = 0; checks > 0 && next < lists.size(); ++next) {
        if (next == sorted) sorted = sortedFurther(lists, sorted);
        const List& list = m_lists[whichOf(lists[next])];
        int count = static_cast<int>(list.numbers.size());
        squaredDistances(wanted, list.bytes.data(), m_rows.cols, count, room(distances, count));
        for (std::size_t i = 0; i < list.numbers.size(); ++i)
            if (distances[i] < best.limit) best.offer(list.numbers[i], distances[i]);
        checks -= std::max(count, 1);
    }
}

std::vector<RowMatch> ratioMatches(const cv::Mat& queries, const cv::Mat& rows, double ratio) {
    std::vector<RowMatch> matches;
    if (queries.empty() || rows.rows < 2 || queries.cols != rows.cols) return matches;
    cv::Mat table = rows.isContinuous() ? rows : rows.clone();
    std::vector<int> distances(static_cast<std::size_t>(table.rows));
    for (int query = 0; query < queries.rows; ++query) {
        squaredDistances(queries.ptr(query), table.ptr(), table.cols, table.rows, distances.data());
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
