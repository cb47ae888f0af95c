#include "core/building/import/finishing.h"
#include "core/building/level_regions.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace farol::building {

namespace {

constexpr double kSameBorderM = 0.1, kNarrowestM = 0.6, kParallelSine = 0.05;
constexpr std::size_t kMostOpeningsInside = 4;

struct Stretch {
    double from = 0.0, to = 0.0;
};

struct Segment {
    Point2 a, b;
};

void addEdges(const Ring& ring, std::vector<Segment>& edges) {
    for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
}

std::vector<Segment> edgesOf(const Polygon& polygon) {
    std::vector<Segment> edges;
    addEdges(polygon.outer, edges);
    for (const Ring& hole : polygon.holes) addEdges(hole, edges);
    return edges;
}

Box2 boxOf(const Segment& segment) {
    return {{std::min(segment.a.x, segment.b.x), std::min(segment.a.y, segment.b.y)},
            {std::max(segment.a.x, segment.b.x), std::max(segment.a.y, segment.b.y)}};
}

/// Where `other` runs along `edge`, in metres from edge.a.
std::optional<Stretch> alongside(const Segment& edge, const Segment& other) {
    double size = distance(edge.a, edge.b);
    Point2 along = (edge.b - edge.a) * (1.0 / size), way = other.b - other.a;
    if (std::abs(cross(along, way)) > std::max(kParallelSine * length(way), 1e-9)) return std::nullopt;
    if (std::abs(cross(along, other.a - edge.a)) > kSameBorderM ||
        std::abs(cross(along, other.b - edge.a)) > kSameBorderM)
        return std::nullopt;
    double first = dot(along, other.a - edge.a), last = dot(along, other.b - edge.a);
    Stretch stretch{std::max(0.0, std::min(first, last)), std::min(size, std::max(first, last))};
    if (stretch.to - stretch.from < 1e-3) return std::nullopt;
    return stretch;
}

/// `open` without `wall`.
std::vector<Stretch> without(const std::vector<Stretch>& open, Stretch wall) {
    std::vector<Stretch> rest;
    for (Stretch each : open) {
        if (wall.to <= each.from || wall.from >= each.to) {
            rest.push_back(each);
            continue;
        }
        if (wall.from > each.from) rest.push_back({each.from, wall.from});
        if (wall.to < each.to) rest.push_back({wall.to, each.to});
    }
    return rest;
}

class BorderOpener {
public:
    BorderOpener(BuildingData& data, FindingList& findings)
        : m_data(data), m_findings(findings), m_index(data.regions) {
        for (const Access& access : data.accesses) {
            m_joined.insert(pairOf(access.regionA.value, access.regionB.value));
            m_ids.insert(access.id.value);
        }
        std::map<double, std::vector<Box2>> boxes;
        for (const Wall& wall : data.walls)
            for (std::size_t i = 1; i < wall.line.size(); ++i) {
                m_walls[wall.level].push_back({wall.line[i - 1], wall.line[i]});
                boxes[wall.level].push_back(boxOf(m_walls[wall.level].back()));
            }
        for (auto& [level, each] : boxes) m_wallIndex[level] = BoxIndex(each);
    }

    void run() {
        for (std::size_t a = 0; a < m_data.regions.size(); ++a) {
            std::vector<Segment> edges = edgesOf(m_data.regions[a].polygon);
            BoxIndex edgeIndex = indexOf(edges);
            Box2 box = *boundingBox(m_data.regions[a].polygon.outer);
            for (std::size_t b : m_index.meeting(m_data.regions[a].level, grown(box, kSameBorderM)))
                if (b > a) open(a, b, edges, edgeIndex);
        }
    }

private:
    static std::pair<std::string, std::string> pairOf(const std::string& a, const std::string& b) {
        return {std::min(a, b), std::max(a, b)};
    }

    void open(std::size_t a, std::size_t b, const std::vector<Segment>& edges, const BoxIndex& edgeIndex) {
        const Region &one = m_data.regions[a], &other = m_data.regions[b];
        if (m_joined.count(pairOf(one.id.value, other.id.value)) != 0) return;
        std::size_t number = 0;
        std::vector<Segment> borders = edgesOf(other.polygon);
        for (const Segment& border : borders) {
            double size = distance(border.a, border.b);
            if (size < kNarrowestM) continue;
            for (std::size_t at : edgeIndex.meeting(boxOf(border))) {
                auto shared = alongside(border, edges[at]);
                if (!shared) continue;
                for (Stretch stretch : unwalled(one.level, border, *shared))
                    if (stretch.to - stretch.from >= kNarrowestM)
                        addOpening(one, other, border, stretch, ++number);
            }
        }
        if (number == 0 && isOpen(one) && isOpen(other)) {
            bool met = false; // a border that is all wall is none to be opened from the other side
            number = openInside(one, other, borders, edges, edgeIndex, met);
            if (!met) number = openInside(other, one, edges, borders, indexOf(borders), met);
        }
        if (number > 0)
            m_findings.add(Severity::Note, "border-open", Sentence::OpeningsAdded, "regions",
                           one.id.value + " - " + other.id.value);
    }

    static BoxIndex indexOf(const std::vector<Segment>& edges) {
        std::vector<Box2> boxes;
        for (const Segment& edge : edges) boxes.push_back(grown(boxOf(edge), kSameBorderM));
        return BoxIndex(boxes);
    }

    /// Nobody steps onto stairs, into a lift or onto a moving walkway from the side.
    static bool isOpen(const Region& region) {
        return !shaftKind(region) && region.kindText != "moving_walkway";
    }

    /// Areas that reach into one another: one steps from the one into the other where its border lies inside.
    std::size_t openInside(const Region& one, const Region& other, const std::vector<Segment>& borders,
                           const std::vector<Segment>& edges, const BoxIndex& edgeIndex, bool& met) {
        std::vector<std::pair<double, std::pair<Segment, Stretch>>> found;
        for (const Segment& border : borders) {
            double size = distance(border.a, border.b);
            if (size < kNarrowestM) continue;
            for (Stretch inside : insideOf(one.polygon, border, edges, edgeIndex)) {
                met = true;
                for (Stretch stretch : unwalled(one.level, border, inside))
                    if (stretch.to - stretch.from >= kNarrowestM)
                        found.push_back({stretch.to - stretch.from, {border, stretch}});
            }
        }
        std::stable_sort(found.begin(), found.end(),
                         [](const auto& a, const auto& b) { return a.first > b.first; });
        if (found.size() > kMostOpeningsInside) found.resize(kMostOpeningsInside);
        std::size_t number = 0;
        for (const auto& [width, place] : found) addOpening(one, other, place.first, place.second, ++number);
        return number;
    }

    /// The stretches of the segment that lie within the polygon and not along its border.
    static std::vector<Stretch> insideOf(const Polygon& polygon, const Segment& segment,
                                         const std::vector<Segment>& edges, const BoxIndex& edgeIndex) {
        double size = distance(segment.a, segment.b);
        Point2 along = (segment.b - segment.a) * (1.0 / size);
        std::vector<double> cuts{0.0, size};
        std::vector<std::size_t> near = edgeIndex.meeting(boxOf(segment));
        for (std::size_t at : near) {
            double slope = cross(along, edges[at].b - edges[at].a);
            if (slope == 0.0) continue;
            double where = cross(edges[at].a - segment.a, edges[at].b - edges[at].a) / slope;
            if (where > 0.0 && where < size) cuts.push_back(where);
        }
        std::sort(cuts.begin(), cuts.end());
        std::vector<Stretch> inside;
        for (std::size_t i = 1; i < cuts.size(); ++i) {
            if (cuts[i] - cuts[i - 1] < kNarrowestM) continue;
            Point2 middle = segment.a + along * ((cuts[i] + cuts[i - 1]) / 2);
            bool onBorder = std::any_of(near.begin(), near.end(), [&](std::size_t at) {
                return distanceToSegment(middle, edges[at].a, edges[at].b) <= kSameBorderM;
            });
            if (!onBorder && contains(polygon, middle)) inside.push_back({cuts[i - 1], cuts[i]});
        }
        return inside;
    }

    std::vector<Stretch> unwalled(double level, const Segment& border, Stretch shared) const {
        std::vector<Stretch> open{shared};
        auto index = m_wallIndex.find(level);
        if (index == m_wallIndex.end()) return open;
        for (std::size_t at : index->second.meeting(grown(boxOf(border), kSameBorderM)))
            if (auto wall = alongside(border, m_walls.at(level)[at])) open = without(open, *wall);
        return open;
    }

    void addOpening(const Region& a, const Region& b, const Segment& border, Stretch stretch,
                    std::size_t number) {
        double size = distance(border.a, border.b);
        Point2 along = (border.b - border.a) * (1.0 / size);
        Access access;
        std::string id =
            "open:" + a.id.value + "-" + b.id.value + (number > 1 ? "#" + std::to_string(number) : "");
        while (!m_ids.insert(id).second) id += "'";
        access.id = AccessId(id);
        access.kind = AccessKind::Opening;
        access.level = a.level;
        access.regionA = a.id;
        access.regionB = b.id;
        access.widthM = std::round((stretch.to - stretch.from) * 1000.0) / 1000.0;
        access.line = {border.a + along * stretch.from, border.a + along * stretch.to};
        m_data.accesses.push_back(std::move(access));
    }

    BuildingData& m_data;
    FindingList& m_findings;
    LevelRegions m_index;
    std::set<std::pair<std::string, std::string>> m_joined;
    std::unordered_set<std::string> m_ids;
    std::map<double, std::vector<Segment>> m_walls;
    std::map<double, BoxIndex> m_wallIndex;
};

} // namespace

void openSharedBorders(BuildingData& data, FindingList& findings) {
    BorderOpener(data, findings).run();
}

} // namespace farol::building
