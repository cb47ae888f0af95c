#include "core/simulation/hash.h"
#include "core/simulation/scene_parts.h"

#include <array>
#include <string>

namespace farol::simulation {

namespace {

using building::RegionKind;

Vec3 pick(Draw& draw, const std::vector<std::array<int, 3>>& colours) {
    const auto& colour = colours[static_cast<std::size_t>(draw.below(static_cast<int>(colours.size())))];
    return linearOf(colour[0], colour[1], colour[2]);
}

const std::vector<std::array<int, 3>> kWalls{{250, 248, 240}, {246, 240, 222}, {232, 240, 232},
                                             {230, 238, 246}, {250, 236, 220}, {240, 240, 240},
                                             {244, 232, 226}, {236, 232, 214}};
const std::vector<std::array<int, 3>> kDadoes{{150, 178, 190}, {176, 196, 160}, {206, 180, 140},
                                              {190, 150, 140}, {140, 156, 186}, {200, 196, 182},
                                              {166, 150, 130}};
const std::vector<std::array<int, 3>> kFloors{{206, 196, 176}, {170, 182, 190}, {188, 168, 146},
                                              {160, 176, 160}, {214, 210, 204}, {150, 150, 160},
                                              {190, 150, 130}};
const std::vector<std::array<int, 3>> kCarpets{
    {96, 110, 150}, {120, 104, 100}, {90, 120, 110}, {130, 130, 136}, {140, 90, 84}};
const std::vector<std::array<int, 3>> kDoors{{236, 236, 232}, {112, 140, 168}, {150, 62, 54},
                                             {74, 104, 90},   {206, 200, 180}, {92, 98, 112}};

/// Corridors of one level are mostly alike, as they are in real buildings; rooms are not.
std::uint64_t styleSeed(const building::Region& region, std::uint64_t seed) {
    auto given = region.extra.find("style"); // a map may ask for one look in two places
    if (given != region.extra.end()) {
        if (const auto* text = std::get_if<std::string>(&given->second)) return hashOf(seed, *text);
        if (const auto* number = std::get_if<std::int64_t>(&given->second))
            return hashOf(seed, static_cast<std::uint64_t>(*number));
    }
    bool shared = region.kind == RegionKind::Corridor || region.kind == RegionKind::Stairwell;
    std::uint64_t own = hashOf(seed, region.id.value);
    if (!shared || own % 4 == 0) return own;
    return hashOf(seed, building::regionKindName(region.kind) + std::to_string(region.level));
}

void floorOf(RegionStyle& style, RegionKind kind, Draw& draw) {
    Material material = Material::Lino;
    Vec3 tint = pick(draw, kFloors);
    double choice = draw.unit();
    if (kind == RegionKind::Toilet || (kind == RegionKind::Hall && choice < 0.5)) {
        material = Material::FloorTiles;
    } else if (kind == RegionKind::Stairwell || (kind == RegionKind::Hall)) {
        material = Material::Terrazzo;
    } else if (kind == RegionKind::Corridor) {
        material = choice < 0.45 ? Material::Lino : choice < 0.75 ? Material::FloorTiles : Material::Terrazzo;
    } else if (choice < 0.4) {
        material = Material::Carpet;
        tint = pick(draw, kCarpets);
    } else if (choice < 0.65) {
        material = Material::Parquet;
        tint = {1.0F, 1.0F, 1.0F};
    }
    style.floor = paintOf(material, tint);
    bool shines =
        material == Material::Lino || material == Material::Terrazzo || material == Material::FloorTiles;
    style.floor.gloss = shines ? 0.16F : material == Material::Parquet ? 0.08F : 0.0F;
}

void wallsOf(RegionStyle& style, RegionKind kind, Draw& draw) {
    bool blocks = kind == RegionKind::Stairwell || draw.chance(0.15);
    style.wall = paintOf(blocks ? Material::Blocks : Material::Plaster, pick(draw, kWalls));
    style.lowerWall = style.wall;
    if (kind == RegionKind::Toilet) {
        style.lowerWall = paintOf(Material::FloorTiles, linearOf(250, 250, 250));
        style.lowerWall.tileU = style.lowerWall.tileV = 0.8F;
        style.dadoM = 1.6;
    } else if ((kind == RegionKind::Corridor && draw.chance(0.5)) ||
               (kind == RegionKind::Stairwell && draw.chance(0.6))) {
        style.lowerWall.tint = pick(draw, kDadoes);
        style.dadoM = draw.between(0.95, 1.25);
    }
    style.skirting = paintOf(draw.chance(0.5) ? Material::DoorWood : Material::Plain,
                             draw.chance(0.5) ? linearOf(150, 140, 130) : linearOf(90, 86, 84));
    style.skirting.tileU = 2.0F;
}

RegionStyle styleOf(const building::Region& region, std::uint64_t seed, std::uint64_t doorSeed) {
    RegionStyle style;
    style.seed = styleSeed(region, seed);
    Draw draw(style.seed);
    if (region.kind == RegionKind::Elevator) {
        style.wall = paintOf(Material::Metal, linearOf(236, 236, 240));
        style.lowerWall = style.wall;
        style.floor = paintOf(Material::Lino, linearOf(90, 90, 96));
        style.ceiling = paintOf(Material::CeilingPlain);
        style.skirting = paintOf(Material::Metal, linearOf(150, 150, 155));
        style.lampKind = 0;
        style.lampColour = {1.0F, 0.97F, 0.92F};
        return style;
    }
    wallsOf(style, region.kind, draw);
    floorOf(style, region.kind, draw);
    if (region.kind == RegionKind::Outside) {
        bool paved = draw.chance(0.6);
        style.floor = paintOf(paved ? Material::Concrete : Material::Asphalt);
    }
    bool grid = region.kind != RegionKind::Stairwell && draw.chance(0.6);
    style.ceiling = paintOf(grid ? Material::CeilingGrid : Material::CeilingPlain);
    style.lampKind = grid ? (draw.chance(0.7) ? 0 : 1) : draw.chance(0.6) ? 1 : 2;
    double warm = draw.between(0.0, 1.0);
    style.lampColour = {1.0F, static_cast<float>(0.97 - 0.09 * warm), static_cast<float>(0.94 - 0.24 * warm)};
    Draw doors(
        hashOf(doorSeed, draw.chance(0.75) ? 1U : style.seed)); // one sort of door through most of a building
    bool wooden = doors.chance(0.6);
    style.doorMaterial = wooden ? Material::DoorWood : Material::Plain;
    style.doorTint = wooden ? linearOf(190 + doors.below(60), 180 + doors.below(60), 170 + doors.below(60))
                            : pick(doors, kDoors);
    return style;
}

} // namespace

Paint paintOf(Material material, Vec3 tint) {
    Paint paint;
    paint.texture = static_cast<std::uint32_t>(material);
    paint.tint = tint;
    paint.tileU = paint.tileV = tileOf(material);
    return paint;
}

std::vector<RegionStyle> makeStyles(const building::Building& building, std::uint64_t seed) {
    std::vector<RegionStyle> styles;
    for (const building::Region& region : building.regions())
        styles.push_back(styleOf(region, hashOf(seed, 21), hashOf(seed, 22)));
    return styles;
}

} // namespace farol::simulation
