#pragma once
// A building from a drawing. Every character is one cell (1 m unless said otherwise); walls are lines through
// the middle of their characters, so two rooms share the wall between them and a door lies exactly on it.
//
//     auto map = AsciiMap()
//         .floor(R"(
//             +-----+-----+
//             |A    |B   e|
//             |  1  /     |
//             +--/--+-----+
//             |C          |
//             +-----------+
//         )")
//         .landmark('e', {Kind::Extinguisher});
//     auto building = map.build();         // regions "A", "B", "C"; accesses "A-B", "A-C"; landmark "e"
//     auto start = map.spot('1');          // region "A" and the position of the 1
//
//   A..Z        a region: one letter anywhere inside, or as many of the same as one likes. Its id and name
//   are the letter.
//   + - | #     wall. Two by two # (or more) within a room stand for a column of 1 m x 1 m.
//   /           door        *  closed door      %  window
//   :           opening; several in a row are one wide opening (so are several of the other characters)
//   > < ^ v     door that can be passed one way only (v is therefore no landmark)
//   a..z 0..9   a spot within a room: a landmark once landmark() describes it, else only a place for spot()
//   space       floor within a room, nothing outside
//
// Access ids are "A-B", letters in alphabetical order (regionA is the first), then "A-B2", "A-B3" from top to
// bottom and left to right. Repeated landmarks are "e", "e2", ... The lower left character of a drawing
// stands at (0, 0), y is up (north). Wrong drawings (a room that leaks, two letters in one room) throw
// std::invalid_argument with the reason.

#include "core/building/building.h"
#include "core/building/info.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace farol::test {

// Default initialisers everywhere, so that tests may leave members out.
struct AsciiRegion {
    std::string name{};
    building::RegionKind kind = building::RegionKind::Room;
    std::string ref{};
    bool restricted = false;
};

struct AsciiLandmark {
    Kind kind = Kind::Sign;
    std::string text{};
    std::string templateId{}; ///< empty: known by kind or text
    std::optional<double> headingDeg{};
};

class AsciiMap {
public:
    explicit AsciiMap(double cellM = 1.0) : m_cellM(cellM) {}

    /// Adds a level. Letters of regions are used once in the whole building.
    AsciiMap& floor(std::string_view drawing, double level = 0.0);
    /// Says more about a region that is drawn.
    AsciiMap& region(char letter, AsciiRegion about);
    AsciiMap& landmark(char character, AsciiLandmark about);
    /// Joins two regions of different levels, at the middle of the lower letter's region. Id "S-T" as for
    /// doors.
    AsciiMap& join(building::AccessKind kind, char a, char b, const std::string& shaft = {},
                   std::optional<int> steps = std::nullopt);

    building::BuildingData data() const;
    std::shared_ptr<const building::Building> build() const;
    /// Where a lower-case letter or digit (the first of several) stands; throws when it is not drawn.
    building::Location spot(char character) const;

private:
    struct Spot {
        char character;
        building::Location location;
        double level;
    };

    building::Region& regionOf(char letter);

    double m_cellM;
    building::BuildingData m_data; ///< without landmarks: these are made from m_spots
    std::vector<Spot> m_spots;
    std::map<char, AsciiLandmark> m_landmarks;
};

/// The short form for one level.
std::shared_ptr<const building::Building> asciiMap(std::string_view drawing,
                                                   const std::map<char, AsciiLandmark>& landmarks = {});

} // namespace farol::test
