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
    /// What the same places are called in a language; '0' to '9' are the levels in the order of the drawings.
    Sketch& in(const std::string& language, const std::map<char, std::string>& names) {
        for (const auto& [letter, name] : names) m_names.push_back({language, letter, name});
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
        for (const Name& each : m_names) {
            const std::string field = "name_" + each.language;
            if (each.letter >= '0' && each.letter <= '9')
                data.levels.at(static_cast<std::size_t>(each.letter - '0')).extra[field] = each.name;
            for (building::Region& region : data.regions)
                if (region.id.value == std::string(1, each.letter)) region.extra[field] = each.name;
        }
        for (const auto& [access, position] : m_moved) data.accesses[access].line = {position};
        m_golden.building = std::make_shared<const building::Building>(std::move(data));
        m_golden.from = m_map.spot(from);
        m_golden.to = m_map.spot(to);
        return std::move(m_golden);
    }

private:
    struct Name {
        std::string language;
        char letter;
        std::string name;
    };
    GoldenBuilding m_golden;
    AsciiMap m_map;
    std::vector<Name> m_names;
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
        .in("pt", {{'A', "Receção"}, {'M', "Arquivo"}, {'H', "Gabinete 1"}, {'I', "Gabinete 2"}})
        .in("pt", {{'K', "Corredor"}})
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
        .in("pt", {{'A', "Entrada"}, {'G', "Biblioteca"}, {'X', "Ductos"}, {'K', "Corredor circular"}})
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
        .in("pt", {{'A', "Entrada"}, {'K', "Galeria"}, {'C', "Gabinete"}, {'W', "Sala de leitura"}})
        .in("pt", {{'S', "Escadas"}, {'T', "Escadas"}, {'U', "Patamar"}})
        .in("pt", {{'0', "Rés-do-chão"}, {'1', "Piso 1"}, {'2', "Sobreloja"}})
        .in("es", {{'A', "Vestíbulo"}, {'K', "Galería"}, {'C', "Despacho"}, {'W', "Sala de lectura"}})
        .in("es", {{'S', "Escaleras"}, {'T', "Escaleras"}, {'U', "Rellano"}})
        .in("es", {{'0', "Planta baja"}, {'1', "Planta 1"}, {'2', "Entreplanta"}})
        .in("fr", {{'A', "Hall d'entrée"}, {'K', "Galerie"}, {'C', "Bureau"}, {'W', "Salle de lecture"}})
        .in("fr", {{'S', "Escalier"}, {'T', "Escalier"}, {'U', "Palier"}})
        .in("fr", {{'0', "Rez-de-chaussée"}, {'1', "Premier étage"}, {'2', "Entresol"}})
        .in("de", {{'A', "Eingangshalle"}, {'K', "Galerie"}, {'C', "Büro"}, {'W', "Lesesaal"}})
        .in("de", {{'S', "Treppenhaus"}, {'T', "Treppenhaus"}, {'U', "Treppenabsatz"}})
        .in("de", {{'0', "Erdgeschoss"}, {'1', "Erster Stock"}, {'2', "Zwischengeschoss"}})
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
        .in("pt", {{'P', "Garagem"}, {'H', "Átrio"}, {'K', "Corredor"}, {'B', "Sala 2.14"}})
        .in("pt", {{'X', "Elevador"}, {'Y', "Elevador"}, {'Z', "Elevador"}})
        .in("pt", {{'0', "Piso -1"}, {'1', "Piso 0"}, {'2', "Piso 2"}})
        .in("es", {{'P', "Garaje"}, {'H', "Vestíbulo"}, {'K', "Pasillo"}, {'B', "Aula 2.14"}})
        .in("es", {{'X', "Ascensor"}, {'Y', "Ascensor"}, {'Z', "Ascensor"}})
        .in("es", {{'0', "Planta -1"}, {'1', "Planta 0"}, {'2', "Planta 2"}})
        .in("fr", {{'P', "Parking"}, {'H', "Hall"}, {'K', "Couloir"}, {'B', "Salle 2.14"}})
        .in("fr", {{'X', "Ascenseur"}, {'Y', "Ascenseur"}, {'Z', "Ascenseur"}})
        .in("fr", {{'0', "Niveau -1"}, {'1', "Niveau 0"}, {'2', "Niveau 2"}})
        .in("de", {{'P', "Tiefgarage"}, {'H', "Halle"}, {'K', "Flur"}, {'B', "Raum 2.14"}})
        .in("de", {{'X', "Aufzug"}, {'Y', "Aufzug"}, {'Z', "Aufzug"}})
        .in("de", {{'0', "Ebene -1"}, {'1', "Ebene 0"}, {'2', "Ebene 2"}})
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
        .in("pt", {{'A', "Enfermagem"}, {'F', "Raios X"}, {'W', "Ala oeste"}, {'Z', "Ala este"}})
        .in("pt", {{'H', "Átrio principal"}})
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
        .in("pt", {{'A', "Bengaleiro"}, {'F', "Auditório"}, {'H', "Átrio"}})
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
        .in("pt", {{'A', "Foyer"}, {'D', "Sala de reuniões"}, {'K', "Corredor"}})
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
                 |D   | e|
                 | 2  /  |
                 |    |  |
                 +----+  |
                      |  |
                      |  |
                      +--+
)")
        .called({{'A', "Post room"}, {'D', "Copy room"}})
        .called({{'K', "Corridor"}}, RegionKind::Corridor)
        .in("pt", {{'A', "Correio"}, {'D', "Sala de cópias"}, {'K', "Corredor"}})
        .in("es", {{'A', "Correo"}, {'D', "Sala de copias"}, {'K', "Pasillo"}})
        .in("fr", {{'A', "Courrier"}, {'D', "Salle de copie"}, {'K', "Couloir"}})
        .in("de", {{'A', "Poststelle"}, {'D', "Kopierraum"}, {'K', "Flur"}})
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
        .in("pt", {{'A', "Capela"}, {'D', "Portaria"}, {'K', "Corredor sul"}, {'L', "Corredor transversal"}})
        .in("es", {{'A', "Capilla"}, {'D', "Portería"}, {'K', "Pasillo sur"}, {'L', "Pasillo transversal"}})
        .in("fr", {{'A', "Chapelle"}, {'D', "Loge"}, {'K', "Couloir sud"}, {'L', "Couloir transversal"}})
        .in("de", {{'A', "Kapelle"}, {'D', "Pforte"}, {'K', "Südflur"}, {'L', "Querflur"}})
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
        .in("pt", {{'A', "Oficina"}, {'C', "Ferramentaria"}, {'B', "Escritório do pátio"}})
        .in("pt", {{'W', "Corredor oeste"}, {'E', "Corredor este"}, {'N', "Corredor norte"}})
        .in("es", {{'A', "Taller"}, {'C', "Herramientas"}, {'B', "Oficina del patio"}})
        .in("es", {{'W', "Pasillo oeste"}, {'E', "Pasillo este"}, {'N', "Pasillo norte"}})
        .in("fr", {{'A', "Atelier"}, {'C', "Outillage"}, {'B', "Bureau de la cour"}})
        .in("fr", {{'W', "Couloir ouest"}, {'E', "Couloir est"}, {'N', "Couloir nord"}})
        .in("de", {{'A', "Werkstatt"}, {'C', "Werkzeuglager"}, {'B', "Hofbüro"}})
        .in("de", {{'W', "Westflur"}, {'E', "Ostflur"}, {'N', "Nordflur"}})
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
        .in("pt", {{'B', "Casa-forte"}})
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
        .in("pt", {{'H', "Átrio"}, {'M', "Mezanino"}, {'R', "Café"}})
        .in("pt", {{'0', "Piso 0"}, {'1', "Piso intermédio"}})
        .called({{'M', "Mezzanine"}, {'R', "Café"}})
        .join(AccessKind::Stairs, 'H', 'M', "half", 9)
        .at('s')
        .landmark('e', Kind::Extinguisher)
        .walk('1', '2');
}

/// Five doors around a few square metres.
GoldenBuilding lobby() {
    return Sketch("lobby", "through a lobby with a door on every side, to the one beside the one ahead")
        .level(0.0, R"(
            +----+----+------+
            |W   |N   |E     |
            |    |    |      |
            |    +-/--+      |
            |    |L   /      |
            |1   /    +------+
            |    |    |F     |
            |    |    /    2 |
            |    +--/-+      |
            |    |S   |      |
            +----+----+------+
        )")
        .called({{'W', "Workshop"},
                 {'N', "Paint store"},
                 {'E', "Kitchen"},
                 {'F', "Darkroom"},
                 {'S', "Tool store"}})
        .called({{'L', "Lobby"}}, RegionKind::Corridor)
        .in("pt", {{'W', "Oficina"},
                   {'N', "Depósito de tintas"},
                   {'E', "Copa"},
                   {'F', "Câmara escura"},
                   {'S', "Depósito de ferramentas"},
                   {'L', "Vestíbulo"}})
        .walk('1', '2');
}

} // namespace

std::vector<GoldenBuilding> goldenBuildings() {
    return {corridor(), ring(), stairs(),   lift(),   wings(),     atrium(), deadEnd(),
            bend(),     tee(),  crossing(), nested(), mezzanine(), lobby()};
}

} // namespace farol::test
