#include "core/simulation/furniture.h"

#include "core/simulation/hash.h"
#include "core/simulation/scene_parts.h"
#include "core/simulation/sign_pictures.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <numbers>

namespace farol::simulation {

namespace {

Vec3 anyColour(Draw& draw, int low, int high) {
    auto one = [&] { return low + draw.below(high - low); };
    int red = one(), green = one(), blue = one();
    return linearOf(red, green, blue);
}

/// A box in the spot's frame, given by its middle below and its size.
void block(MeshBuilder& builder, const Spot& spot, double right, double up, double out, double w, double h,
           double d, const Paint& paint) {
    builder.box(spot.at(right - w / 2, up, out + d), spot.right * static_cast<float>(w),
                spot.front * static_cast<float>(-d), kUp * static_cast<float>(h), paint);
}

} // namespace

Spot spotAt(Vec3 middle, Point2 front) {
    return {middle, flatVec({-front.y, front.x}), flatVec(front)};
}

std::uint32_t addTexture(SceneData& scene, const cv::Mat& picture) {
    if (scene.pictureScale < 1.0 && std::max(picture.cols, picture.rows) > 96) {
        cv::Mat smaller;
        cv::resize(picture, smaller, cv::Size(), scene.pictureScale, scene.pictureScale, cv::INTER_AREA);
        scene.textures.emplace_back(smaller, false);
    } else {
        scene.textures.emplace_back(picture, false);
    }
    return static_cast<std::uint32_t>(scene.textures.size() - 1);
}

std::array<Vec3, 4> addBoard(MeshBuilder& builder, const Spot& spot, const Measures& size,
                             std::uint32_t texture, Vec3 sides, float glow) {
    double w = size.width / 2, h = size.tall / 2, d = size.deep;
    std::array<Vec3, 4> corners{spot.at(-w, h, d), spot.at(w, h, d), spot.at(w, -h, d), spot.at(-w, -h, d)};
    Paint front;
    front.texture = texture;
    front.glow = glow;
    builder.picture(corners[0], corners[1] - corners[0], corners[3] - corners[0], front);
    // The truth knows a flat thing by its front: its edges are nobody's.
    std::int32_t thing = builder.thing();
    if (size.deep < 0.1) builder.setThing(-1);
    Paint rim = paintOf(Material::Plain, sides);
    builder.box(spot.at(-w, -h, d), spot.right * static_cast<float>(size.width),
                spot.front * static_cast<float>(-d), kUp * static_cast<float>(size.tall), rim, 0b000100U);
    builder.setThing(thing);
    return corners;
}

void addExtinguisher(SceneData& scene, MeshBuilder& builder, const Spot& spot, const Measures& size,
                     std::uint64_t seed) {
    auto radius = static_cast<float>(size.width * 0.46);
    auto tall = static_cast<float>(size.tall);
    Draw draw(seed);
    Paint red = paintOf(Material::Plain, linearOf(186 + draw.below(24), 22, 20));
    red.gloss = 0.12F;
    Paint black = paintOf(Material::Plain, linearOf(34, 34, 36));
    Paint metal = paintOf(Material::Metal, linearOf(190, 190, 190));
    Vec3 foot = spot.at(0.0, -size.tall / 2, radius + 0.02);
    builder.lathe(foot, {{0.0F, 0.0F}, {radius, 0.0F}, {radius, 0.03F * tall}}, 14, black);
    builder.lathe(foot,
                  {{radius, 0.03F * tall},
                   {radius, 0.74F * tall},
                   {0.86F * radius, 0.81F * tall},
                   {0.52F * radius, 0.86F * tall},
                   {0.28F * radius, 0.875F * tall}},
                  14, red);
    builder.lathe(foot,
                  {{0.28F * radius, 0.875F * tall}, {0.28F * radius, 0.93F * tall}, {0.0F, 0.935F * tall}}, 8,
                  metal);
    // Lever, gauge, hose and bracket.
    builder.beam(spot.at(-0.25 * size.width, 0.44 * size.tall, radius + 0.02),
                 spot.at(0.42 * size.width, 0.5 * size.tall, radius + 0.05), 0.02F, black);
    double out = radius * 1.75 + 0.02, side = -0.42 * size.width;
    builder.beam(spot.at(0.0, 0.42 * size.tall, radius + 0.03), spot.at(side, 0.3 * size.tall, out), 0.018F,
                 black);
    builder.beam(spot.at(side, 0.3 * size.tall, out), spot.at(side * 0.9, -0.2 * size.tall, out), 0.018F,
                 black);
    builder.box(spot.at(-0.05, -0.05, 0.02), spot.right * 0.1F, spot.front * -0.02F, kUp * 0.22F, metal);
    Paint label;
    label.texture = addTexture(scene, extinguisherLabel(seed));
    // The label bends round the cylinder in three strips.
    constexpr int kStrips = 4;
    std::uint32_t plane = 0;
    for (int i = 0; i < kStrips; ++i) {
        auto angle = [](int k) { return (static_cast<float>(k) / kStrips - 0.5F) * 1.5F; };
        auto rim = [&](int k, double up) {
            double r = radius * 1.012;
            return spot.at(r * std::sin(angle(k)), up, radius + 0.02 + r * std::cos(angle(k)));
        };
        Vec3 topLeft = rim(i, 0.16 * size.tall), topRight = rim(i + 1, 0.16 * size.tall);
        Vec3 lowRight = rim(i + 1, -0.3 * size.tall), lowLeft = rim(i, -0.3 * size.tall);
        Paint strip = label;
        strip.tileU = length(topRight - topLeft) * kStrips;
        strip.tileV = length(lowLeft - topLeft);
        plane = builder.surface(topLeft - unit(topRight - topLeft) *
                                              (strip.tileU * static_cast<float>(i) / kStrips),
                                topRight - topLeft, lowLeft - topLeft, strip);
        builder.quad(plane, topLeft, topRight, lowRight, lowLeft);
    }
}

void addFountain(MeshBuilder& builder, const Spot& spot, const Measures& size) {
    Paint steel = paintOf(Material::Metal, linearOf(214, 216, 220));
    steel.gloss = 0.15F;
    Paint dark = paintOf(Material::Plain, linearOf(60, 62, 66));
    double low = -size.tall / 2;
    block(builder, spot, 0.0, low, 0.0, size.width, size.tall * 0.82, size.deep, steel);
    block(builder, spot, 0.0, low + size.tall * 0.82, 0.0, size.width * 1.06, size.tall * 0.05,
          size.deep * 1.08, steel);
    block(builder, spot, 0.0, low + size.tall * 0.872, size.deep * 0.25, size.width * 0.7, 0.004,
          size.deep * 0.6, dark);
    block(builder, spot, 0.0, low + size.tall * 0.8, 0.0, size.width, size.tall * 0.2, 0.05, steel);
    builder.beam(spot.at(0.08, low + size.tall * 0.87, size.deep * 0.3),
                 spot.at(0.02, low + size.tall * 0.97, size.deep * 0.5), 0.025F, steel);
    block(builder, spot, 0.0, low + size.tall * 0.5, size.deep, size.width * 0.5, size.tall * 0.06, 0.02,
          dark);
}

void addBin(MeshBuilder& builder, const Spot& spot, const Measures& size, std::uint64_t seed) {
    Draw draw(seed);
    Paint body =
        draw.chance(0.4) ? paintOf(Material::Metal) : paintOf(Material::Plain, anyColour(draw, 30, 170));
    Paint dark = paintOf(Material::Plain, linearOf(28, 28, 30));
    auto radius = static_cast<float>(size.width / 2), tall = static_cast<float>(size.tall);
    Vec3 foot = spot.at(0.0, 0.0, radius + 0.03);
    if (draw.chance(0.6)) {
        builder.lathe(foot, {{radius * 0.85F, 0.0F}, {radius, tall}}, 16, body);
        builder.lathe(
            foot, {{radius, tall}, {radius * 0.94F, tall}, {radius * 0.9F, tall * 0.9F}, {0.0F, tall * 0.9F}},
            16, dark);
    } else {
        block(builder, spot, 0.0, 0.0, 0.03, size.width, size.tall * 0.86, size.width, body);
        block(builder, spot, 0.0, size.tall * 0.86, 0.02, size.width * 1.04, size.tall * 0.14,
              size.width * 1.04, dark);
    }
}

void addPlant(MeshBuilder& builder, const Spot& spot, const Measures& size, std::uint64_t seed) {
    Draw draw(seed);
    Paint pot = paintOf(Material::Plain, draw.chance(0.5) ? linearOf(150, 84, 60) : anyColour(draw, 60, 220));
    Paint soil = paintOf(Material::Asphalt, linearOf(120, 90, 60));
    Paint stem = paintOf(Material::DoorWood, linearOf(120, 130, 90));
    auto radius = static_cast<float>(std::min(0.22, size.width * 0.32)), tall = static_cast<float>(size.tall);
    float potTall = std::min(0.42F, tall * 0.35F);
    Vec3 foot = spot.at(0.0, 0.0, radius + 0.08);
    builder.lathe(foot,
                  {{radius * 0.75F, 0.0F},
                   {radius, potTall},
                   {radius * 0.9F, potTall},
                   {radius * 0.88F, potTall * 0.93F}},
                  14, pot);
    builder.lathe(foot, {{radius * 0.88F, potTall * 0.93F}, {0.0F, potTall * 0.95F}}, 14, soil);
    builder.beam(foot + kUp * (potTall * 0.9F), foot + kUp * (tall * 0.75F), 0.02F, stem);
    int leaves = 34;
    for (int i = 0; i < leaves; ++i) {
        Paint leaf =
            paintOf(Material::Leaves, Vec3{1.0F, 1.0F, 1.0F} * static_cast<float>(draw.between(0.5, 1.1)));
        leaf.tileU = leaf.tileV = 0.6F;
        double turn = draw.between(0.0, 2.0 * std::numbers::pi), rise = draw.between(-0.2, 0.9);
        Vec3 way{static_cast<float>(std::cos(turn) * std::cos(rise)),
                 static_cast<float>(std::sin(turn) * std::cos(rise)), static_cast<float>(std::sin(rise))};
        auto start = static_cast<float>(draw.between(potTall + 0.05, tall * 0.8));
        auto size1 = static_cast<float>(size.width * draw.between(0.25, 0.5));
        Vec3 root = foot + kUp * start, tip = root + way * size1;
        Vec3 side = unit(cross(way, kUp)) * (size1 * 0.16F),
             middle = root + way * (size1 * 0.55F) + kUp * (size1 * 0.08F);
        builder.flat(root, middle - side, tip, middle + side, leaf);
    }
}

void addFurniture(MeshBuilder& builder, const Spot& spot, const Measures& size, std::uint64_t seed) {
    Draw draw(seed);
    Paint wood = paintOf(Material::DoorWood, anyColour(draw, 150, 255));
    Paint frame = paintOf(Material::Metal, linearOf(90, 90, 94));
    Paint cloth = paintOf(Material::Carpet, anyColour(draw, 40, 190));
    double w = size.width, h = size.tall, d = size.deep;
    switch (draw.below(3)) {
    case 0: // bench
        block(builder, spot, 0.0, h * 0.5, 0.03, w, 0.06, d, cloth);
        block(builder, spot, 0.0, h * 0.58, 0.03, w, h * 0.42, 0.05, cloth);
        for (double x : {-0.42, 0.42}) block(builder, spot, x * w, 0.0, 0.06, 0.05, h * 0.5, d - 0.06, frame);
        break;
    case 1: // cupboard
        block(builder, spot, 0.0, 0.0, 0.01, w, h, d, wood);
        block(builder, spot, 0.0, h * 0.04, d + 0.01, 0.008, h * 0.92, 0.002, frame);
        for (double x : {-0.06, 0.06}) block(builder, spot, x, h * 0.5, d + 0.01, 0.015, 0.12, 0.02, frame);
        break;
    default: // table
        block(builder, spot, 0.0, h - 0.03, 0.03, w, 0.03, d, wood);
        for (double x : {-0.46, 0.46})
            for (double out : {0.05, d - 0.04})
                block(builder, spot, x * w, 0.0, out, 0.04, h - 0.03, 0.04, frame);
        break;
    }
}

void addBag(MeshBuilder& builder, const Spot& spot, std::uint64_t seed) {
    Draw draw(seed);
    Paint cloth = paintOf(Material::Carpet, anyColour(draw, 20, 160));
    double w = draw.between(0.25, 0.5), h = draw.between(0.25, 0.45), d = draw.between(0.14, 0.25);
    block(builder, spot, 0.0, 0.0, 0.05, w, h * 0.8, d, cloth);
    block(builder, spot, 0.0, h * 0.8, 0.05 + d * 0.15, w * 0.8, h * 0.2, d * 0.7, cloth);
    Paint strap = paintOf(Material::Plain, linearOf(30, 30, 34));
    builder.beam(spot.at(-w * 0.25, h, 0.05 + d / 2), spot.at(0.0, h + 0.1, 0.05 + d / 2), 0.025F, strap);
    builder.beam(spot.at(0.0, h + 0.1, 0.05 + d / 2), spot.at(w * 0.25, h, 0.05 + d / 2), 0.025F, strap);
}

void addPerson(MeshBuilder& builder, const Spot& spot, std::uint64_t seed) {
    Draw draw(seed);
    auto tall = static_cast<float>(draw.between(1.56, 1.88));
    Paint skin = paintOf(Material::Plain, draw.chance(0.6) ? linearOf(224, 176, 148) : linearOf(120, 84, 62));
    Paint hair = paintOf(Material::Carpet, anyColour(draw, 20, 110));
    Paint shirt = paintOf(Material::Carpet, anyColour(draw, 30, 230)),
          trousers = paintOf(Material::Carpet, anyColour(draw, 24, 110));
    Paint shoes = paintOf(Material::Plain, linearOf(30, 28, 28));
    Vec3 foot = spot.at(0.0, 0.0, 0.3);
    for (float side : {-0.1F, 0.1F}) {
        Vec3 leg = foot + spot.right * side;
        builder.lathe(leg, {{0.07F, 0.06F}, {0.075F, 0.26F * tall}, {0.092F, 0.48F * tall}}, 10, trousers);
        builder.box(leg - spot.right * 0.05F - spot.front * 0.08F + spot.front * 0.24F, spot.right * 0.1F,
                    spot.front * -0.24F, kUp * 0.07F, shoes);
        Vec3 shoulder = foot + spot.right * (side * 2.2F) + kUp * (0.81F * tall);
        Vec3 elbow = shoulder + spot.right * (side * 0.25F) - kUp * (0.19F * tall);
        Vec3 hand = elbow + spot.front * 0.16F - kUp * (0.11F * tall);
        builder.beam(shoulder, elbow, 0.085F, shirt);
        builder.beam(elbow, hand, 0.07F, draw.chance(0.5) ? shirt : skin);
    }
    builder.lathe(foot,
                  {{0.12F, 0.46F * tall},
                   {0.155F, 0.5F * tall},
                   {0.14F, 0.62F * tall},
                   {0.19F, 0.76F * tall},
                   {0.17F, 0.82F * tall},
                   {0.06F, 0.85F * tall}},
                  14, shirt);
    builder.lathe(
        foot, {{0.055F, 0.84F * tall}, {0.055F, 0.87F * tall}, {0.085F, 0.9F * tall}, {0.09F, 0.94F * tall}},
        12, skin);
    builder.lathe(foot,
                  {{0.095F, 0.94F * tall}, {0.085F, 0.975F * tall}, {0.05F, 0.995F * tall}, {0.0F, tall}}, 12,
                  hair);
}

void addRadiator(MeshBuilder& builder, const Spot& spot, double width) {
    Paint white = paintOf(Material::Plain, linearOf(238, 238, 234));
    int ribs = std::max(3, static_cast<int>(width / 0.09));
    block(builder, spot, 0.0, 0.14, 0.03, width, 0.5, 0.05, white);
    for (int i = 0; i < ribs; ++i)
        block(builder, spot, (i + 0.5) * width / ribs - width / 2, 0.13, 0.08, 0.045, 0.52, 0.025, white);
}

} // namespace farol::simulation
