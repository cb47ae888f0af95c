#include "resources/demo/demo_building.h"

#include <string>
#include <utility>
#include <vector>

#include "resources/demo/draughtsman.h"

namespace farol::demo {

using building::AccessKind;
using building::RegionKind;

namespace {

constexpr double kEast = 0.0, kNorth = 90.0, kWest = 180.0, kSouth = 270.0;
/// The wings' corridors, and how far a sign hangs from its door's middle.
constexpr double kCorridorSouth = 16.0, kCorridorNorth = 18.4, kSignAside = 0.8;

Thing roomSign(const std::string& ref) {
    return {Kind::Text, "", ref, 1.6, 0.34, 0.2};
}
Thing words(const std::string& text, double wideM) {
    return {Kind::Text, "", text, 1.9, wideM, 0.3};
}
Thing poster(const std::string& name) {
    return {Kind::Poster, name, "", 1.55, 0.7, 1.0};
}
Thing board(const std::string& name) {
    return {Kind::Poster, name, "", 1.55, 1.2, 0.9};
}
Thing picture(const std::string& name) {
    return {Kind::Picture, name, "", 1.6, 0.95, 0.68};
}
Thing extinguisher() {
    return {Kind::Extinguisher, "extinguisher", "", 1.0, 0.2, 0.6};
}
Thing exitSign() {
    return {Kind::ExitSign, "exit", "", 2.35, 0.4, 0.2};
}
Thing window() {
    return {Kind::Window, "", "", 1.5, 1.4, 1.2};
}
Thing bin() {
    return {Kind::Bin, "bin", "", 0.35, 0.35, 0.7};
}
Thing plant() {
    return {Kind::Plant, "", "", 0.6, 0.6, 1.2};
}
Thing lockers() {
    return {Kind::Locker, "lockers", "", 0.95, 1.2, 1.9};
}
Thing fountain() {
    return {Kind::Fountain, "fountain", "", 0.6, 0.45, 0.9};
}
Thing vendingMachine(const std::string& name) {
    return {Kind::VendingMachine, name, "", 0.92, 0.9, 1.83};
}

/// Doors with the number of the room beside them, on the left as one stands before the door, and on the plan
/// of the ways out that hangs beside it within.
void numberedDoor(Draughtsman& draw, const RegionId& corridor, const RegionId& room, const std::string& ref,
                  Point2 at, double facing, double widthM = 0.9) {
    draw.door(corridor, room, at, facing, widthM);
    Point2 aside = facing == kNorth || facing == kSouth
                       ? Point2{facing == kNorth ? kSignAside : -kSignAside, 0.0}
                       : Point2{0.0, facing == kEast ? -kSignAside : kSignAside};
    draw.landmark(corridor, roomSign(ref), at + aside, facing);
    draw.landmark(room, roomSign(ref), at + aside, facing + 180.0);
}

struct Wing {
    std::string name, english, portuguese;
    double west;     ///< where its five pairs of rooms begin
    double small;    ///< where its two small rooms, beside the middle of the house, begin
    int firstNumber; ///< of its rooms
    bool lift;       ///< the northern small room is the lift
};

const Wing kWestWing{"west", "west", "oeste", 2.0, 22.0, 1, true};
const Wing kEastWing{"east", "east", "leste", 38.0, 36.0, 21, false};

std::string roomKey(const Wing& wing, int number) {
    return wing.name + "-room-" + std::to_string(number);
}

void drawRoom(Draughtsman& draw, const Wing& wing, const RegionId& corridor, int k, bool north) {
    int number = k + (north ? 1 : 6);
    double west = wing.west + 4.0 * k;
    std::string ref = draw.ref(wing.firstNumber - 1 + number);
    bool toilet = !north && k == 2, class_ = draw.level() == 1.0 && !wing.lift && north;
    Names names = toilet   ? Names{"Toilets " + ref, "Casas de banho " + ref, ref}
                  : class_ ? Names{"Classroom " + ref, "Sala de aula " + ref, ref}
                           : Names{"Office " + ref, "Gabinete " + ref, ref};
    Box box =
        north ? Box{west, kCorridorNorth, west + 4.0, 23.4} : Box{west, 11.0, west + 4.0, kCorridorSouth};
    RegionId room =
        draw.region(roomKey(wing, number), toilet ? RegionKind::Toilet : RegionKind::Room, names, box);
    Point2 door = north ? Point2{west + 1.45, kCorridorNorth} : Point2{west + 2.55, kCorridorSouth};
    numberedDoor(draw, corridor, room, ref, door, north ? kSouth : kNorth);
    double outside = north ? 23.4 : 11.0, inward = north ? kSouth : kNorth;
    draw.landmark(room, window(), {west + 2.0, outside}, inward);
    if (toilet) return;
    int look = (wing.firstNumber + number + static_cast<int>(draw.level()) * 7) % 6;
    draw.landmark(room, picture("picture-" + std::to_string(look + 1)), {west + 4.0, north ? 21.0 : 13.4},
                  kWest);
    if (number % 3 == 0) draw.landmark(room, plant(), {west + 0.4, north ? 22.9 : 11.5}, kEast);
    if (number % 3 == 1) draw.landmark(room, bin(), {west, north ? 19.6 : 14.8}, kEast);
}

/// What hangs in a wing's corridor is at the same places in both wings and on every level; only the posters
/// and the numbers tell them apart.
void furnishCorridor(Draughtsman& draw, const Wing& wing, const RegionId& corridor) {
    std::string which = wing.name + "-" + std::to_string(static_cast<int>(draw.level()));
    for (int k : {0, 2, 4})
        draw.landmark(corridor, extinguisher(), {wing.west + 4.0 * k + 2.9, kCorridorNorth}, kSouth);
    draw.landmark(corridor, extinguisher(), {wing.west + 5.2, kCorridorSouth}, kNorth);
    draw.landmark(corridor, poster("poster-" + which + "a"), {wing.west + 7.2, kCorridorNorth}, kSouth);
    draw.landmark(corridor, poster("poster-" + which + "b"), {wing.west + 15.2, kCorridorNorth}, kSouth);
    draw.landmark(corridor, poster("poster-" + which + "c"), {wing.west + 13.0, kCorridorSouth}, kNorth);
    draw.landmark(corridor, fountain(), {wing.west + 9.0, kCorridorSouth}, kNorth);
    draw.landmark(corridor, board("board-" + which), {wing.west + 17.1, kCorridorSouth}, kNorth);
    draw.landmark(corridor, bin(), {wing.west + 0.9, kCorridorSouth}, kNorth);
}

void drawSmallRooms(Draughtsman& draw, const Wing& wing, const RegionId& corridor) {
    double from = wing.small, middle = from + 1.0;
    std::string ref = draw.ref(wing.firstNumber + 10);
    RegionId south =
        draw.region(wing.name + "-closet", RegionKind::Room, {"Storage " + ref, "Arrumos " + ref, ref},
                    {from, 13.6, from + 2.0, kCorridorSouth});
    draw.door(corridor, south, {middle - 0.3, kCorridorSouth}, kNorth, 0.8);
    draw.landmark(corridor, roomSign(ref), {middle + 0.5, kCorridorSouth}, kNorth);
    draw.landmark(south, roomSign(ref), {middle + 0.5, kCorridorSouth}, kSouth);
    if (wing.lift) return;
    std::string next = draw.ref(wing.firstNumber + 11);
    RegionId north = draw.region(wing.name + "-copies", RegionKind::Room,
                                 {"Copy room " + next, "Reprografia " + next, next},
                                 {from, kCorridorNorth, from + 2.0, 20.8});
    draw.door(corridor, north, {middle + 0.3, kCorridorNorth}, kSouth, 0.8);
    draw.landmark(corridor, roomSign(next), {middle - 0.5, kCorridorNorth}, kSouth);
    draw.landmark(north, roomSign(next), {middle - 0.5, kCorridorNorth}, kNorth);
}

RegionId drawStairwell(Draughtsman& draw, const Wing& wing, const RegionId& corridor) {
    bool west = wing.lift;
    double from = west ? -4.0 : 58.0, door = west ? 2.0 : 58.0, far = west ? -4.0 : 64.0;
    double inward = west ? kEast : kWest;
    RegionId stairs = draw.region("stairs-" + wing.name, RegionKind::Stairwell,
                                  {"Stairs " + wing.english, "Escadas " + wing.portuguese, ""},
                                  {from, 15.2, from + 6.0, 19.2});
    draw.door(corridor, stairs, {door, 17.2}, inward, 1.0);
    draw.landmark(corridor, exitSign(), {door, 17.2}, inward);
    std::string level = std::to_string(static_cast<int>(draw.level()));
    draw.landmark(stairs, words("FLOOR " + level, 0.9), {door, 18.5}, west ? kWest : kEast);
    draw.landmark(stairs, extinguisher(), {door + (west ? -1.0 : 1.0), 15.2}, kNorth);
    draw.landmark(stairs, window(), {far, 17.2}, inward);
    return stairs;
}

RegionId drawWing(Draughtsman& draw, const Wing& wing) {
    double end = wing.lift ? 24.0 : 58.0;
    RegionId corridor = draw.region(
        wing.name + "-corridor", RegionKind::Corridor,
        {"Corridor " + wing.english + " " + std::to_string(static_cast<int>(draw.level())),
         "Corredor " + wing.portuguese + " " + std::to_string(static_cast<int>(draw.level())), ""},
        {end - 22.0, kCorridorSouth, end, kCorridorNorth});
    for (int k = 0; k < 5; ++k) {
        drawRoom(draw, wing, corridor, k, true);
        drawRoom(draw, wing, corridor, k, false);
    }
    drawSmallRooms(draw, wing, corridor);
    furnishCorridor(draw, wing, corridor);
    drawStairwell(draw, wing, corridor);
    return corridor;
}

RegionId drawLift(Draughtsman& draw, const RegionId& before) {
    RegionId lift = draw.region("lift", RegionKind::Elevator, {"Lift", "Elevador", ""},
                                {22.0, kCorridorNorth, 24.0, 20.8});
    draw.door(before, lift, {24.0, 19.7}, kEast, 1.0).automatic = true;
    draw.landmark(before, {Kind::Elevator, "lift-door", "", 1.05, 1.0, 2.1}, {24.0, 19.7}, kEast);
    draw.landmark(before, words("LIFT", 0.6), {24.0, 20.6}, kEast);
    draw.landmark(lift, words("FLOOR " + std::to_string(static_cast<int>(draw.level())), 0.6), {22.0, 19.7},
                  kEast);
    return lift;
}

void joinWings(Draughtsman& draw, const RegionId& west, const RegionId& westHall, const RegionId& east,
               const RegionId& eastHall) {
    draw.opening(west, westHall, {24.0, kCorridorSouth}, {24.0, kCorridorNorth});
    draw.opening(eastHall, east, {36.0, kCorridorSouth}, {36.0, kCorridorNorth});
}

void drawBar(Draughtsman& draw, const RegionId& atrium) {
    RegionId bar = draw.region("bar", RegionKind::Room, {"Bar", "Bar", ""}, {24, 24, 36, 32});
    RegionId kitchen = draw.region("kitchen", RegionKind::Room, {"Kitchen", "Cozinha", ""}, {36, 24, 42, 30});
    RegionId cellar =
        draw.region("bar-store", RegionKind::Room, {"Bar store", "Armazém do bar", ""}, {18, 24, 24, 30});
    RegionId terrace =
        draw.region("terrace", RegionKind::Outside, {"Terrace", "Esplanada", ""}, {24, 32, 36, 36});
    draw.door(atrium, bar, {27.6, 24}, kSouth, 1.2);
    draw.door(atrium, bar, {33.4, 24}, kSouth, 1.2);
    draw.door(bar, kitchen, {36, 26.5}, kWest);
    draw.door(bar, cellar, {24, 26.5}, kEast);
    draw.door(bar, terrace, {30, 32}, kSouth, 1.4);
    draw.landmark(atrium, words("BAR", 0.7), {30.5, 24}, kSouth);
    draw.landmark(bar, board("menu"), {24, 29}, kEast);
    draw.landmark(bar, poster("poster-bar"), {36, 29.5}, kWest);
    draw.landmark(bar, vendingMachine("drinks"), {30.5, 24}, kNorth);
    draw.landmark(bar, plant(), {24.4, 31.5}, kEast);
    draw.landmark(bar, window(), {27, 32}, kSouth);
    draw.landmark(bar, window(), {33, 32}, kSouth);
    draw.landmark(bar, extinguisher(), {35.2, 24}, kNorth);
    draw.landmark(kitchen, extinguisher(), {36, 28}, kEast);
    draw.landmark(kitchen, lockers(), {40, 24}, kNorth);
    draw.landmark(cellar, lockers(), {20, 24}, kNorth);
    draw.landmark(cellar, bin(), {18, 28}, kEast);
    draw.landmark(terrace, plant(), {25, 32.4}, kNorth);
    draw.landmark(terrace, board("menu"), {32, 32}, kNorth);
}

RegionId drawGround(Draughtsman& draw) {
    draw.beginLevel(0, {"Ground floor", "Rés-do-chão", "0"});
    RegionId atrium = draw.region("atrium", RegionKind::Hall, {"Atrium", "Átrio", ""}, {24, 10, 36, 24});
    RegionId foyer =
        draw.region("foyer", RegionKind::Hall, {"Entrance hall", "Hall de entrada", ""}, {27, 4, 33, 10});
    RegionId yard =
        draw.region("forecourt", RegionKind::Outside, {"Forecourt", "Largo de entrada", ""}, {25, 0, 35, 4});
    draw.opening(atrium, foyer, {28.5, 10}, {31.5, 10});
    draw.door(foyer, yard, {30, 4}, kNorth, 1.8).automatic = true;
    draw.landmark(foyer, board("welcome"), {27, 7}, kEast);
    draw.landmark(foyer, board("house-map"), {33, 7}, kWest);
    draw.landmark(foyer, exitSign(), {30, 4}, kNorth);
    draw.landmark(foyer, plant(), {27.4, 9.5}, kEast);
    draw.landmark(yard, words("FAROL", 1.4), {32.5, 4}, kSouth);
    draw.landmark(yard, plant(), {27, 3.5}, kSouth);
    draw.landmark(atrium, words("INFORMATION", 1.4), {26, 10}, kNorth);
    draw.landmark(atrium, board("house-map"), {34, 10}, kNorth);
    draw.landmark(atrium, vendingMachine("snacks"), {24, 13}, kEast);
    draw.landmark(atrium, vendingMachine("drinks"), {24, 14}, kEast);
    draw.landmark(atrium, board("events"), {36, 13}, kWest);
    draw.landmark(atrium, poster("poster-atrium-a"), {36, 21}, kWest);
    draw.landmark(atrium, poster("poster-atrium-b"), {24, 22.5}, kEast);
    draw.landmark(atrium, extinguisher(), {36, 15}, kWest);
    draw.landmark(atrium, plant(), {35.4, 23.4}, kSouth);
    drawBar(draw, atrium);
    RegionId west = drawWing(draw, kWestWing), east = drawWing(draw, kEastWing);
    joinWings(draw, west, atrium, east, atrium);
    return drawLift(draw, atrium);
}

RegionId drawRing(Draughtsman& draw) {
    draw.beginLevel(1, {"First floor", "Primeiro piso", "1"});
    auto side = [&](const std::string& english, const std::string& portuguese, const Box& box) {
        return draw.region("ring-" + english, RegionKind::Corridor,
                           {"Ring corridor " + english, "Corredor do anel, " + portuguese, ""}, box);
    };
    RegionId north = side("north", "norte", {24, 23.6, 36, 26}),
             south = side("south", "sul", {24, 6, 36, 8.4});
    RegionId west = side("west", "oeste", {24, 8.4, 26.4, 23.6}),
             east = side("east", "leste", {33.6, 8.4, 36, 23.6});
    draw.opening(north, west, {24, 23.6}, {26.4, 23.6});
    draw.opening(north, east, {33.6, 23.6}, {36, 23.6});
    draw.opening(west, south, {24, 8.4}, {26.4, 8.4});
    draw.opening(east, south, {33.6, 8.4}, {36, 8.4});
    struct Room {
        Names names;
        Box box;
        RegionId corridor;
        Point2 door;
        double facing;
    };
    std::vector<Room> rooms{
        {{"Library", "Biblioteca", "1.41"}, {24, 26, 30, 31}, north, {28.2, 26}, kSouth},
        {{"Reading room", "Sala de leitura", "1.42"}, {30, 26, 36, 31}, north, {32.6, 26}, kSouth},
        {{"Physics laboratory", "Laboratório de física", "1.43"}, {24, 1, 30, 6}, south, {27, 6}, kNorth},
        {{"Chemistry laboratory", "Laboratório de química", "1.44"}, {30, 1, 36, 6}, south, {33, 6}, kNorth}};
    for (const Room& room : rooms) {
        RegionId id = draw.region("room-" + room.names.ref.substr(2), RegionKind::Room, room.names, room.box);
        numberedDoor(draw, room.corridor, id, room.names.ref, room.door, room.facing);
        bool upper = room.facing == kSouth;
        draw.landmark(id, window(), {room.box.west + 3.0, upper ? room.box.north : room.box.south},
                      room.facing);
        draw.landmark(id, poster("poster-room-" + room.names.ref.substr(2)),
                      {room.box.west, upper ? 28.5 : 3.5}, kEast);
        draw.landmark(id, extinguisher(), {room.box.east, upper ? 27.0 : 5.0}, kWest);
    }
    draw.landmark(north, lockers(), {25.4, 26}, kSouth);
    draw.landmark(north, poster("poster-ring-a"), {30, 23.6}, kNorth);
    draw.landmark(north, extinguisher(), {34.6, 26}, kSouth);
    draw.landmark(south, lockers(), {30.4, 6}, kNorth);
    draw.landmark(south, poster("poster-ring-b"), {30, 8.4}, kSouth);
    draw.landmark(south, extinguisher(), {25.2, 6}, kNorth);
    for (double y : {11.0, 21.6}) draw.landmark(east, extinguisher(), {36, y}, kWest);
    draw.landmark(east, poster("poster-ring-c"), {33.6, 14}, kEast);
    draw.landmark(east, board("board-ring-east"), {36, 13.4}, kWest);
    draw.landmark(west, extinguisher(), {24, 11}, kEast);
    draw.landmark(west, poster("poster-ring-d"), {26.4, 14}, kWest);
    draw.landmark(west, board("board-ring-west"), {24, 13.4}, kEast);
    draw.landmark(west, words("FLOOR 1", 0.9), {26.4, 19.7}, kWest);
    RegionId westWing = drawWing(draw, kWestWing), eastWing = drawWing(draw, kEastWing);
    joinWings(draw, westWing, west, eastWing, east);
    return drawLift(draw, west);
}

RegionId drawTop(Draughtsman& draw) {
    draw.beginLevel(2, {"Second floor", "Segundo piso", "2"});
    RegionId lobby =
        draw.region("lobby", RegionKind::Hall, {"Upper hall", "Hall superior", ""}, {24, 12, 36, 22});
    RegionId lecture = draw.region("lecture-hall", RegionKind::Room, {"Lecture hall", "Anfiteatro", "2.41"},
                                   {24, 22, 36, 32});
    RegionId office =
        draw.region("secretariat", RegionKind::Room, {"Secretariat", "Secretaria", "2.42"}, {24, 6, 30, 12});
    RegionId director =
        draw.region("director", RegionKind::Room, {"Director", "Direção", "2.43"}, {30, 6, 36, 12});
    numberedDoor(draw, lobby, lecture, "2.41", {27, 22}, kSouth, 1.2);
    draw.door(lobby, lecture, {33, 22}, kSouth, 1.2);
    numberedDoor(draw, lobby, office, "2.42", {26.4, 12}, kNorth);
    numberedDoor(draw, lobby, director, "2.43", {33, 12}, kNorth);
    draw.door(office, director, {30, 9}, kWest);
    draw.landmark(lobby, words("FLOOR 2", 0.9), {30, 22}, kSouth);
    draw.landmark(lobby, board("board-lobby"), {29, 12}, kNorth);
    draw.landmark(lobby, vendingMachine("snacks"), {36, 13.2}, kWest);
    draw.landmark(lobby, poster("poster-lobby-a"), {36, 20.4}, kWest);
    draw.landmark(lobby, extinguisher(), {24, 13.5}, kEast);
    draw.landmark(lobby, plant(), {35.5, 21.5}, kSouth);
    draw.landmark(lecture, picture("picture-lecture"), {24, 27}, kEast);
    draw.landmark(lecture, exitSign(), {27, 22}, kNorth);
    draw.landmark(lecture, exitSign(), {33, 22}, kNorth);
    draw.landmark(lecture, extinguisher(), {36, 24}, kWest);
    draw.landmark(lecture, window(), {30, 32}, kSouth);
    draw.landmark(office, board("board-office"), {24, 9}, kEast);
    draw.landmark(office, window(), {27, 6}, kNorth);
    draw.landmark(director, picture("picture-director"), {36, 9}, kWest);
    draw.landmark(director, window(), {33, 6}, kNorth);
    RegionId west = drawWing(draw, kWestWing), east = drawWing(draw, kEastWing);
    joinWings(draw, west, lobby, east, lobby);
    return drawLift(draw, lobby);
}

/// Each stairwell has one flight up from its southern half and one down into its northern half, in turn, so
/// that the two flights of a landing lie side by side.
void joinLevels(Draughtsman& draw) {
    for (int low = 0; low < 2; ++low) {
        draw.returnToLevel(low);
        std::string from = std::to_string(low) + "-", to = std::to_string(low + 1) + "-";
        double south = low == 0 ? 15.4 : 17.4;
        for (const char* wing : {"west", "east"}) {
            double x = wing == kWestWing.name ? -1.2 : 61.2;
            std::string stairs = std::string("stairs-") + wing;
            draw.shaft(AccessKind::Stairs, stairs, RegionId(from + stairs), RegionId(to + stairs), {x, south},
                       {x, south + 1.6});
            Thing flight{Kind::Stairs, "", "", 0.5, 1.6, 1.0};
            double facing = wing == kWestWing.name ? kEast : kWest;
            draw.landmark(RegionId(from + stairs), flight, {x, south + 0.8}, facing);
        }
        draw.shaft(AccessKind::Elevator, "lift", RegionId(from + "lift"), RegionId(to + "lift"), {22.5, 19.6},
                   {23.5, 19.6});
    }
}

} // namespace

building::BuildingData demoBuilding() {
    Draughtsman draw;
    drawGround(draw);
    drawRing(draw);
    drawTop(draw);
    joinLevels(draw);
    building::BuildingData data = draw.take();
    data.title = "Farol demo building";
    data.languages = {"en", "pt"};
    return data;
}

} // namespace farol::demo
