#include "tests/guidance/golden_buildings.h"

#include "tests/support/ascii_map.h"

#include <map>
#include <utility>

namespace farol::test {

namespace {

using building::AccessKind;
using building::RegionKind;

class Sketch {
public:
    Sketch(std::string name, std::string title) {
        m_golden.name = std::move(name);
        m_golden.title = std::move(title);
    }
    Sketch& level(double ordinal, const char* drawing) {
        m_map.floor(drawing, ordinal);
        m_golden.drawings.emplace_back(drawing);
        return *this;
    }
    Sketch& called(const std::map<char, std::string>& names, RegionKind kind = RegionKind::Room) {
        for (const auto& [letter, name] : names) m_map.region(letter, {name, kind});
        return *this;
    }
    Sketch& unnamed(char letter, RegionKind kind) {
        m_map.region(letter, {{}, kind});
        m_unnamed.push_back(letter);
        return *this;
    }
    Sketch& landmark(char spot, Kind kind, const std::string& text = {}) {
        m_map.landmark(spot, {kind, text});
        return *this;
    }
    Sketch& join(AccessKind kind, char a, char b, const std::string& shaft, std::optional<int> steps = {}) {
        m_map.join(kind, a, b, shaft, steps);
        return *this;
    }
    /// The last join is at this spot.
    Sketch& at(char spot) {
        m_moved[m_map.data().accesses.size() - 1] = *m_map.spot(spot).position;
        return *this;
    }
    Sketch& withObjects() {
        m_golden.seesObjects = true;
        return *this;
    }
    GoldenBuilding walk(char from, char to) {
        building::BuildingData data = m_map.data();
        for (building::Region& region : data.regions)
            for (char letter : m_unnamed)
                if (region.id.value == std::string(1, letter)) region.name.clear();
        for (const auto& [access, position] : m_moved) data.accesses[access].line = {position};
        m_golden.building = std::make_shared<const building::Building>(std::move(data));
        m_golden.from = m_map.spot(from);
        m_golden.to = m_map.spot(to);
        return std::move(m_golden);
    }

private:
    GoldenBuilding m_golden;
    AsciiMap m_map;
    std::string m_unnamed;
    std::map<std::size_t, Point2> m_moved;
};

GoldenBuilding corridor() {
    return Sketch("corridor", "a straight corridor with many doors")
        .level(0, R"(
+-----+-----+-----+-----+-----+-----+
|A    |B    |C    |D    |E    |F    |
|  1  |     |     |     |     |     |
|     |     |     |     |     |     |
+--/--+--/--+--/--+--/--+--/--+--/--+
|K                                  |
|                            e      |
+--/--+--/--+--/--+--/--+--/--+--/--+
|G    |H    |I    |J    |L    |M    |
|     |     |     |     |     |  2  |
+-----+-----+-----+-----+-----+-----+
)")
        .called({{'A', "Reception"}, {'M', "Archive"}, {'H', "Office 1"}, {'I', "Office 2"}})
        .called({{'K', "Corridor"}}, RegionKind::Corridor)
        .landmark('e', Kind::Extinguisher)
        .walk('1', '2');
}

GoldenBuilding ring() {
    return Sketch("ring", "a corridor all round a core")
        .level(0, R"(
+------+------+------+------+
|A     |B     |C     |D     |
|  1   |      |      |      |
+--/---+--/---+--/---+---/--+
|K                          |
|                           |
|  +---------------------+  |
|  |X                    |  |
|  |                     |  |
|  |                     |  |
|  +---------------------+  |
|                           |
|                f          |
+--/---+--/---+--/---+--/---+
|E     |F     |G     |H     |
|      |      |  2   |      |
+------+------+------+------+
)")
        .called({{'A', "Entrance"}, {'G', "Library"}, {'X', "Shafts"}})
        .called({{'K', "Round corridor"}}, RegionKind::Corridor)
        .landmark('f', Kind::Fountain)
        .walk('1', '2');
}

GoldenBuilding stairs() {
    return Sketch("stairs", "up long stairs, and down short ones at the other end")
        .level(0, R"(
+-------+------+
|A      |S     |
|  1    :   s  |
|       |      |
+-------+------+
)")
        .level(1, R"(
               +-------------+
               |C            |
               |             |
        +------+------/------+----+
        |T     |K            |U   |
        |      /             :    |
        |      |             |    |
+       +------+-------------+----+
)")
        .level(0.5, R"(
                             +-------+
                             |W      |
                             |     2 |
                             |       |
+                            +-------+
)")
        .called({{'A', "Lobby"}, {'K', "Gallery"}, {'C', "Office"}, {'W', "Reading room"}})
        .called({{'S', "Stairwell"}, {'T', "Stairwell"}, {'U', "Landing"}}, RegionKind::Stairwell)
        .join(AccessKind::Stairs, 'S', 'T', "main", 22)
        .join(AccessKind::Stairs, 'U', 'W', "side", 6)
        .landmark('s', Kind::Stairs)
        .walk('1', '2');
}

GoldenBuilding lift() {
    return Sketch("lift", "three floors in a lift")
        .level(-1, R"(
+---------------+---+
|P              |X  |
| 1             /   |
|               |   |
+---------------+---+
)")
        .level(0, R"(
+---------------+---+
|H              |Y  |
|               /   |
|               |   |
+---------------+---+
)")
        .level(2, R"(
+-------+-------+---+
|B      |K      |Z  |
|  2    /       /   |
|       |       |   |
+-------+-------+---+
)")
        .called({{'P', "Garage"}, {'H', "Hall"}, {'K', "Corridor"}, {'B', "Room 2.14"}})
        .called({{'X', "Lift"}, {'Y', "Lift"}, {'Z', "Lift"}}, RegionKind::Elevator)
        .join(AccessKind::Elevator, 'X', 'Y', "one")
        .join(AccessKind::Elevator, 'Y', 'Z', "one")
        .walk('1', '2');
}

GoldenBuilding wings() {
    return Sketch("wings", "from one wing through the hall to the other")
        .level(0, R"(
+----+----+----+           +----+----+----+
|A   |B   |C   |           |D   |E   |F   |
| 1  |    |    |           |    |    |  2 |
+-/--+--/-+--/-+-----------+--/-+-/--+-/--+
|W             :H          :Z             |
|              :           :              |
+--------------+           +--------------+
               |     b     |
               |           |
               +-----------+
)")
        .called({{'A', "Nurses"}, {'F', "X-ray"}})
        .called({{'W', "West wing"}, {'Z', "East wing"}}, RegionKind::Corridor)
        .called({{'H', "Main hall"}}, RegionKind::Hall)
        .landmark('b', Kind::VendingMachine)
        .walk('1', '2');
}

GoldenBuilding atrium() {
    return Sketch("atrium", "across a wide hall with doors on all sides")
        .level(0, R"(
+---------+---------+---------+
|A        |B        |C        |
|   1     |         |         |
+----/----+----/----+----/----+
|H                            |
|                             |
|                             |
|                   p         |
|                             |
|                             |
|                             |
|                             |
+----/----+----/----+----/----+
|D        |E        |F        |
|         |         |    2    |
+---------+---------+---------+
)")
        .called({{'A', "Cloakroom"}, {'F', "Auditorium"}})
        .called({{'H', "Atrium"}}, RegionKind::Hall)
        .landmark('p', Kind::Plant)
        .walk('1', '2');
}

GoldenBuilding deadEnd() {
    return Sketch("dead_end", "out of the blind end of a corridor")
        .level(0, R"(
+-----------------------+-----+
|K                      |A    |
|  1                    /     |
|                       |     |
+---/---+---/---+---/---+-----+
|B      |C      |D      |
|       |       |   2   |
+-------+-------+-------+
)")
        .called({{'A', "Foyer"}, {'D', "Meeting room"}})
        .called({{'K', "Corridor"}}, RegionKind::Corridor)
        .walk('1', '2');
}

GoldenBuilding bend() {
    return Sketch("bend", "a corridor that bends, with objects and texts on its walls")
        .level(0, R"(
+------+------+------+
|A     |B     |C     |
|   1  |      |      |
+---/--+---/--+---/--+---+
|K                       |
|                        |
+---------------------+  |
                      |  |
                      |  |
                 +----+  |
                 |D   |e |
                 | 2  /  |
                 |    |  |
                 +----+  |
                      |  |
                      |  |
                      +--+
)")
        .called({{'A', "Post room"}, {'D', "Copy room"}})
        .called({{'K', "Corridor"}}, RegionKind::Corridor)
        .landmark('e', Kind::Extinguisher)
        .withObjects()
        .walk('1', '2');
}

GoldenBuilding tee() {
    return Sketch("tee", "a corridor that ends on another one")
        .level(0, R"(
+------+-----+--------+
|A     |B    |C       |
|  2   |     |        |
+--/---+--/--+---/----+
|L                    |
|                     |
+--------+:-:+--------+
         |K  |
         |   |
         |   |
         |   |
         |   |
         |   |
      +--+   |
      |D /   |
      |1 |   |
      +--+---+
)")
        .called({{'A', "Chapel"}, {'D', "Porter"}})
        .called({{'K', "South corridor"}, {'L', "Cross corridor"}}, RegionKind::Corridor)
        .walk('1', '2');
}

GoldenBuilding crossing() {
    return Sketch("crossing", "straight on over the crossing of two corridors, then left")
        .level(0, R"(
            +--+
            |N |
            |  |
            |  |
            |  |
+---+-------+  +-------+---+
|A  |W      :  :E      |B  |
| 1 /       :  :       /   |
|   |       :  :       |   |
+---+-------+  +--/----+---+
            |  |C      |
            |  |  2    |
            |  +-------+
            +--+
)")
        .called({{'A', "Workshop"}, {'C', "Tool store"}, {'B', "Yard office"}})
        .called({{'W', "West corridor"}, {'E', "East corridor"}, {'N', "North corridor"}},
                RegionKind::Corridor)
        .walk('1', '2');
}

GoldenBuilding nested() {
    return Sketch("nested", "a room within a room, some without names")
        .level(0, R"(
+-----------------+------+
|A                |K     |
|  +-------+      |      |
|  |B      |      |      |
|  |   2   /      /      |
|  |       |      |      |
|  +-------+      |   1  |
|                 |      |
+-----------------+------+
)")
        .called({{'B', "Strong room"}})
        .unnamed('A', RegionKind::Room)
        .unnamed('K', RegionKind::Corridor)
        .walk('1', '2');
}

GoldenBuilding mezzanine() {
    return Sketch("mezzanine", "from a hall up to its mezzanine")
        .level(0, R"(
+---------------------+
|H                    |
|                     |
|   1                 |
|            e    s   |
|                     |
+---------------------+
)")
        .level(0.5, R"(
                +-----+---------+
                |M    |R        |
                |     :         |
                |     :     2   |
+               +-----+---------+
)")
        .called({{'H', "Hall"}}, RegionKind::Hall)
        .called({{'M', "Mezzanine"}, {'R', "Café"}})
        .join(AccessKind::Stairs, 'H', 'M', "half", 9)
        .at('s')
        .landmark('e', Kind::Extinguisher)
        .walk('1', '2');
}

} // namespace

std::vector<GoldenBuilding> goldenBuildings() {
    return {corridor(), ring(), stairs(), lift(),     wings(),  atrium(),
            deadEnd(),  bend(), tee(),    crossing(), nested(), mezzanine()};
}

} // namespace farol::test
