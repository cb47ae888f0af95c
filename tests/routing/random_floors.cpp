#include "tests/routing/random_floors.h"

#include "tests/support/ascii_map.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace farol::test {

using building::AccessKind;

namespace {

constexpr int kWide = 5, kHigh = 4; // floor cells of a block

class Drawer {
public:
    Drawer(std::mt19937& random, const RandomFloors& options, char& letter)
        : m_random(random), m_options(options), m_letter(letter) {
        m_label.assign(static_cast<std::size_t>(options.columns * options.rows), 0);
        for (std::size_t i = 0; i < m_label.size(); ++i) m_label[i] = static_cast<int>(i);
        for (std::size_t i = 0; i < m_label.size(); ++i) merge();
    }

    std::string drawing() {
        std::size_t width = static_cast<std::size_t>(m_options.columns * (kWide + 1) + 1);
        m_lines.assign(static_cast<std::size_t>(m_options.rows * (kHigh + 1) + 1), std::string(width, ' '));
        for (int row = 0; row < m_options.rows; ++row)
            for (int column = 0; column < m_options.columns; ++column) drawBlock(column, row);
        std::string text;
        for (const std::string& line : m_lines) text += line + "\n";
        return text;
    }

private:
    int whole(int low, int high) {
        return low + static_cast<int>(m_random() % static_cast<unsigned>(high - low + 1));
    }
    bool chance(double share) { return static_cast<double>(m_random()) < share * 4294967296.0; }
    int& label(int column, int row) {
        return m_label[static_cast<std::size_t>(row * m_options.columns + column)];
    }
    int labelOr(int column, int row) {
        bool inside = column >= 0 && row >= 0 && column < m_options.columns && row < m_options.rows;
        return inside ? label(column, row) : -1;
    }
    char& at(int column, int row) {
        return m_lines[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
    }

    /// Joins two neighbouring blocks, unless a region would then meet itself in a point.
    void merge() {
        int column = whole(0, m_options.columns - 1), row = whole(0, m_options.rows - 1);
        bool east = chance(0.5);
        int other = labelOr(column + (east ? 1 : 0), row + (east ? 0 : 1));
        if (other < 0 || !chance(0.6)) return;
        std::vector<int> before = m_label;
        int mine = label(column, row);
        for (int& each : m_label)
            if (each == other) each = mine;
        for (int r = 0; r + 1 < m_options.rows; ++r)
            for (int c = 0; c + 1 < m_options.columns; ++c) {
                bool falling = label(c, r) == label(c + 1, r + 1),
                     rising = label(c + 1, r) == label(c, r + 1);
                if (falling != rising) {
                    int corner = falling ? label(c, r) : label(c + 1, r);
                    int first = falling ? label(c + 1, r) : label(c, r);
                    int second = falling ? label(c, r + 1) : label(c + 1, r + 1);
                    if (first != corner && second != corner) m_label = before;
                } else if (falling && rising && label(c, r) != label(c + 1, r)) {
                    m_label = before;
                }
            }
    }

    void drawBlock(int column, int row) {
        int x = column * (kWide + 1), y = row * (kHigh + 1);
        int mine = label(column, row);
        for (auto [dx, dy] : {std::pair(0, 0), std::pair(kWide + 1, 0), std::pair(0, kHigh + 1),
                              std::pair(kWide + 1, kHigh + 1)})
            at(x + dx, y + dy) = '+';
        drawWall(x, y, true, mine, labelOr(column - 1, row));
        drawWall(x, y, false, mine, labelOr(column, row - 1));
        if (column + 1 == m_options.columns) drawWall(x + kWide + 1, y, true, mine, -1);
        if (row + 1 == m_options.rows) drawWall(x, y + kHigh + 1, false, mine, -1);
        if (std::find(m_named.begin(), m_named.end(), mine) == m_named.end()) {
            m_named.push_back(mine);
            at(x + 1, y + 1) = m_letter++;
        }
        if (!chance(0.5)) return;
        int across = whole(2, 3), down = 2;
        int left = whole(2, kWide - across), top = whole(2, kHigh - down);
        for (int i = 0; i < across; ++i)
            for (int k = 0; k < down; ++k) at(x + left + i, y + top + k) = '#';
    }

    /// The wall to the west or north of a block; none within a region.
    void drawWall(int x, int y, bool west, int mine, int other) {
        if (mine == other) return;
        int size = west ? kHigh : kWide;
        auto cell = [&](int i) -> char& { return west ? at(x, y + 1 + i) : at(x + 1 + i, y); };
        for (int i = 0; i < size; ++i) cell(i) = west ? '|' : '-';
        if (other < 0 || chance(0.15)) return;
        if (chance(m_options.openness)) {
            int from = whole(0, size - 2), run = whole(1, size - from);
            for (int i = 0; i < run; ++i) cell(from + i) = ':';
            return;
        }
        const std::string kinds = west ? "////*<>%" : "////*^v%";
        cell(whole(0, size - 1)) = kinds[static_cast<std::size_t>(whole(0, 7))];
    }

    std::mt19937& m_random;
    const RandomFloors& m_options;
    char& m_letter;
    std::vector<int> m_label, m_named;
    std::vector<std::string> m_lines;
};

/// One shaft through all levels, at a point that lies in a region of each.
void addLift(building::BuildingData& data, std::mt19937& random) {
    std::vector<const building::Region*> stops;
    Point2 shaft;
    while (stops.size() != data.levels.size()) {
        const building::Region& first = data.regions[random() % data.regions.size()];
        Box2 box = *boundingBox(first.polygon.outer);
        shaft = box.low + Point2{box.width() * 0.4, box.height() * 0.3};
        stops.clear();
        for (const building::Region& region : data.regions)
            if (contains(region.polygon, shaft)) stops.push_back(&region);
    }
    for (std::size_t i = 1; i < stops.size(); ++i) {
        building::Access lift;
        lift.id = AccessId("L" + std::to_string(i));
        lift.kind = AccessKind::Elevator;
        lift.level = stops[i - 1]->level;
        lift.regionA = stops[i - 1]->id;
        lift.regionB = stops[i]->id;
        lift.shaft = ShaftId("L");
        lift.line = {shaft};
        data.accesses.push_back(std::move(lift));
    }
}

} // namespace

std::shared_ptr<const building::Building> randomFloors(std::uint32_t seed, const RandomFloors& options) {
    std::mt19937 random(seed);
    AsciiMap map;
    char letter = 'A';
    std::vector<std::pair<char, char>> floors;
    for (int level = 0; level < options.levels; ++level) {
        char first = letter;
        Drawer drawer(random, options, letter);
        map.floor(drawer.drawing(), level);
        floors.emplace_back(first, static_cast<char>(letter - 1));
    }
    auto letterOf = [&](std::pair<char, char> floor) {
        return static_cast<char>(
            floor.first + static_cast<int>(random() % static_cast<unsigned>(floor.second - floor.first + 1)));
    };
    for (std::size_t level = 1; level < floors.size(); ++level)
        map.join(AccessKind::Stairs, letterOf(floors[level - 1]), letterOf(floors[level]), "S", 18);
    building::BuildingData data = map.data();
    addLift(data, random);
    double angle = static_cast<double>(random() % 628) / 100.0;
    Point2 origin = random() % 2 == 0 ? Point2{} : Point2{592000.0, 4098000.0};
    auto place = [&](std::vector<Point2>& points) {
        for (Point2& p : points)
            p = Point2{std::cos(angle) * p.x - std::sin(angle) * p.y,
                       std::sin(angle) * p.x + std::cos(angle) * p.y} +
                origin;
    };
    for (building::Region& region : data.regions) {
        place(region.polygon.outer);
        for (Ring& hole : region.polygon.holes) place(hole);
    }
    for (building::Access& access : data.accesses) place(access.line);
    return std::make_shared<const building::Building>(std::move(data));
}

building::Location randomSpot(const building::Building& building, std::mt19937& random) {
    const building::Region& region = building.regions()[random() % building.regions().size()];
    Box2 box = *boundingBox(region.polygon.outer);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    while (true) {
        Point2 p{box.low.x + box.width() * share(random), box.low.y + box.height() * share(random)};
        if (contains(region.polygon, p)) return {region.id, p};
    }
}

} // namespace farol::test
