#pragma once
// The drawing behind AsciiMap: characters on a grid, rooms by flood fill, outlines by tracing.

#include "core/base/geometry.h"

#include <string>
#include <string_view>
#include <vector>

namespace farol::test {

class AsciiDrawing {
public:
    struct Cell {
        int column;
        int row;
    };
    /// One run of equal access characters; `first` and `second` are the letters of the rooms on both sides,
    /// west or north first.
    struct Opening {
        char character;
        char first;
        char second;
        Polyline line;
    };

    AsciiDrawing(std::string_view drawing, double cellM);

    const std::vector<char>& letters() const { return m_letters; } ///< in the order of the drawing
    Polygon outline(char letter) const;
    std::vector<Opening> openings() const;
    std::vector<Cell> spots() const; ///< lower-case letters and digits
    char character(Cell cell) const;
    char roomAt(Cell cell) const; ///< the letter, or 0
    Point2 position(Cell cell) const;

private:
    bool isFloor(Cell cell) const;
    void readRows(std::string_view drawing);
    void fill(Cell start);
    char squareRoom(int column, int row) const;
    std::vector<Ring> trace(char letter) const;

    double m_cellM;
    std::vector<std::string> m_rows;
    std::vector<std::string> m_rooms; ///< the letter of the room each floor character belongs to
    std::vector<char> m_letters;
};

} // namespace farol::test
