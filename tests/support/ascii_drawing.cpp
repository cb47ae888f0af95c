#include "tests/support/ascii_drawing.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <utility>

namespace farol::test {

namespace {

constexpr std::string_view kWalls = "+-|#";
constexpr std::string_view kAccesses = "/*%:><^v";

bool isUpper(char c) {
    return c >= 'A' && c <= 'Z';
}
bool isSpot(char c) {
    return (c >= 'a' && c <= 'z' && c != 'v') || (c >= '0' && c <= '9');
}

[[noreturn]] void wrong(const std::string& reason) {
    throw std::invalid_argument("ASCII map: " + reason);
}

std::string place(AsciiDrawing::Cell cell) {
    return " (line " + std::to_string(cell.row + 1) + ", column " + std::to_string(cell.column + 1) + ")";
}

} // namespace

AsciiDrawing::AsciiDrawing(std::string_view drawing, double cellM) : m_cellM(cellM) {
    readRows(drawing);
    m_rooms.assign(m_rows.size(), std::string(m_rows.front().size(), '\0'));
    for (int row = 0; row < static_cast<int>(m_rows.size()); ++row)
        for (int column = 0; column < static_cast<int>(m_rows.front().size()); ++column)
            if (isUpper(character({column, row})) && roomAt({column, row}) == '\0') fill({column, row});
}

void AsciiDrawing::readRows(std::string_view drawing) {
    std::vector<std::string> lines(1);
    for (char c : drawing) {
        if (c == '\n')
            lines.emplace_back();
        else
            lines.back().push_back(c);
    }
    std::size_t indent = std::string::npos;
    std::size_t width = 0;
    for (std::string& line : lines) {
        line.erase(line.find_last_not_of(' ') + 1);
        if (line.empty()) continue;
        indent = std::min(indent, line.find_first_not_of(' '));
        width = std::max(width, line.size());
    }
    if (width == 0) wrong("the drawing is empty");
    auto first =
        std::find_if(lines.begin(), lines.end(), [](const std::string& line) { return !line.empty(); });
    auto last =
        std::find_if(lines.rbegin(), lines.rend(), [](const std::string& line) { return !line.empty(); });
    for (auto it = first; it != last.base(); ++it) {
        it->resize(width, ' ');
        m_rows.push_back(it->substr(indent));
    }
}

char AsciiDrawing::character(Cell cell) const {
    if (cell.row < 0 || cell.column < 0 || cell.row >= static_cast<int>(m_rows.size())) return '\0';
    const std::string& row = m_rows[static_cast<std::size_t>(cell.row)];
    return cell.column < static_cast<int>(row.size()) ? row[static_cast<std::size_t>(cell.column)] : '\0';
}

char AsciiDrawing::roomAt(Cell cell) const {
    if (character(cell) == '\0') return '\0';
    return m_rooms[static_cast<std::size_t>(cell.row)][static_cast<std::size_t>(cell.column)];
}

Point2 AsciiDrawing::position(Cell cell) const {
    return {m_cellM * cell.column, m_cellM * (static_cast<double>(m_rows.size()) - 1.0 - cell.row)};
}

bool AsciiDrawing::isFloor(Cell cell) const {
    char c = character(cell);
    if (c == '\0' || kWalls.find(c) != std::string_view::npos || kAccesses.find(c) != std::string_view::npos)
        return false;
    if (c != ' ' && !isUpper(c) && !isSpot(c))
        wrong(std::string("unknown character '") + c + "'" + place(cell));
    return true;
}

void AsciiDrawing::fill(Cell start) {
    char letter = character(start);
    if (std::find(m_letters.begin(), m_letters.end(), letter) != m_letters.end())
        wrong(std::string("two rooms are called ") + letter + place(start));
    m_letters.push_back(letter);
    std::vector<Cell> open{start};
    while (!open.empty()) {
        Cell cell = open.back();
        open.pop_back();
        if (character(cell) == '\0') wrong(std::string("room ") + letter + " is not closed" + place(cell));
        if (!isFloor(cell) || roomAt(cell) == letter) continue;
        if (isUpper(character(cell)) && character(cell) != letter)
            wrong(std::string("no wall between ") + letter + " and " + character(cell) + place(cell));
        m_rooms[static_cast<std::size_t>(cell.row)][static_cast<std::size_t>(cell.column)] = letter;
        open.insert(open.end(), {{cell.column + 1, cell.row},
                                 {cell.column - 1, cell.row},
                                 {cell.column, cell.row + 1},
                                 {cell.column, cell.row - 1}});
    }
}

/// The room of the square between the characters (column, row) and (column + 1, row + 1), or 0 in solid wall.
char AsciiDrawing::squareRoom(int column, int row) const {
    char room = '\0';
    for (Cell cell : {Cell{column, row}, {column + 1, row}, {column, row + 1}, {column + 1, row + 1}}) {
        char found = roomAt(cell);
        if (found == '\0' || found == room) continue;
        if (room != '\0')
            wrong(std::string("rooms ") + room + " and " + found + " meet at a corner" + place(cell));
        room = found;
    }
    return room;
}

std::vector<Ring> AsciiDrawing::trace(char letter) const {
    using Corner = std::pair<int, int>;        // column, row up
    std::set<std::pair<Corner, Corner>> edges; // counter-clockwise round each square; inner ones cancel out
    int height = static_cast<int>(m_rows.size());
    for (int row = 0; row + 1 < height; ++row) {
        for (int column = 0; column + 1 < static_cast<int>(m_rows.front().size()); ++column) {
            if (squareRoom(column, row) != letter) continue;
            int low = height - 2 - row;
            Corner corners[] = {{column, low}, {column + 1, low}, {column + 1, low + 1}, {column, low + 1}};
            for (std::size_t i = 0; i < 4; ++i) {
                Corner from = corners[i];
                Corner to = corners[(i + 1) % 4];
                if (edges.erase({to, from}) == 0) edges.insert({from, to});
            }
        }
    }
    std::vector<Ring> rings;
    while (!edges.empty()) {
        std::vector<Corner> corners;
        auto edge = edges.begin();
        while (edge != edges.end()) {
            Corner at = edge->second;
            corners.push_back(edge->first);
            edges.erase(edge);
            edge = edges.lower_bound({at, Corner{-1, -1}});
            if (edge != edges.end() && edge->first != at) edge = edges.end();
        }
        Ring ring;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            Corner before = corners[(i + corners.size() - 1) % corners.size()];
            Corner after = corners[(i + 1) % corners.size()];
            bool straight = (before.first == after.first) || (before.second == after.second);
            if (!straight) ring.push_back({m_cellM * corners[i].first, m_cellM * corners[i].second});
        }
        rings.push_back(ring);
    }
    return rings;
}

Polygon AsciiDrawing::outline(char letter) const {
    Polygon polygon;
    for (Ring& ring : trace(letter)) {
        if (signedArea(ring) < 0.0)
            polygon.holes.push_back(std::move(ring));
        else if (polygon.outer.empty())
            polygon.outer = std::move(ring);
        else
            wrong(std::string("room ") + letter + " falls into two parts");
    }
    return polygon;
}

std::vector<AsciiDrawing::Opening> AsciiDrawing::openings() const {
    std::vector<Opening> found;
    auto scan = [&](Cell cell, bool vertical) { // vertical: rooms to the west and east, the run goes down
        auto sides = [&](Cell at) {
            Cell before = vertical ? Cell{at.column - 1, at.row} : Cell{at.column, at.row - 1};
            Cell after = vertical ? Cell{at.column + 1, at.row} : Cell{at.column, at.row + 1};
            return std::pair(roomAt(before), roomAt(after));
        };
        auto next = [&](Cell at, int step) {
            return vertical ? Cell{at.column, at.row + step} : Cell{at.column + step, at.row};
        };
        char c = character(cell);
        auto rooms = sides(cell);
        if (rooms.first == '\0' || rooms.second == '\0' || rooms.first == rooms.second) return;
        auto same = [&](Cell at) { return character(at) == c && sides(at) == rooms; };
        if (same(next(cell, -1))) return; // part of a run that has been seen
        Cell last = cell;
        while (same(next(last, 1))) last = next(last, 1);
        Point2 half = vertical ? Point2{0.0, 0.45 * m_cellM} : Point2{-0.45 * m_cellM, 0.0};
        found.push_back({c, rooms.first, rooms.second, {position(cell) + half, position(last) - half}});
    };
    for (int row = 0; row < static_cast<int>(m_rows.size()); ++row) {
        for (int column = 0; column < static_cast<int>(m_rows.front().size()); ++column) {
            if (kAccesses.find(character({column, row})) == std::string_view::npos) continue;
            scan({column, row}, true);
            scan({column, row}, false);
        }
    }
    return found;
}

std::vector<AsciiDrawing::Cell> AsciiDrawing::spots() const {
    std::vector<Cell> cells;
    for (int row = 0; row < static_cast<int>(m_rows.size()); ++row)
        for (int column = 0; column < static_cast<int>(m_rows.front().size()); ++column)
            if (isSpot(character({column, row}))) cells.push_back({column, row});
    return cells;
}

} // namespace farol::test
