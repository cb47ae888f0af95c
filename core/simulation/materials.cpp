#include "core/simulation/materials.h"

#include "core/simulation/hash.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace farol::simulation {

namespace {

constexpr int kPixels = 512;

/// Smooth random values in -1 to 1 that join at the edges, `cells` of them a side.
cv::Mat noise(int cellsX, int cellsY, std::uint64_t seed) {
    constexpr int kMargin = 3;
    cv::Mat grid(cellsY + 2 * kMargin, cellsX + 2 * kMargin, CV_32F);
    for (int y = 0; y < grid.rows; ++y) {
        for (int x = 0; x < grid.cols; ++x) {
            auto column = static_cast<std::uint64_t>((x - kMargin + cellsX) % cellsX);
            auto row = static_cast<std::uint64_t>((y - kMargin + cellsY) % cellsY);
            grid.at<float>(y, x) =
                static_cast<float>(Draw(hashOf(seed, row * 4096 + column)).between(-1.0, 1.0));
        }
    }
    cv::Mat map, smooth;
    double scaleX = static_cast<double>(cellsX) / kPixels, scaleY = static_cast<double>(cellsY) / kPixels;
    cv::Matx23d toGrid(scaleX, 0.0, kMargin + scaleX / 2, 0.0, scaleY, kMargin + scaleY / 2);
    cv::warpAffine(grid, smooth, toGrid, cv::Size(kPixels, kPixels), cv::INTER_CUBIC | cv::WARP_INVERSE_MAP,
                   cv::BORDER_REPLICATE);
    return smooth;
}

cv::Mat noise(int cells, std::uint64_t seed) {
    return noise(cells, cells, seed);
}

cv::Mat grain(std::uint64_t seed) {
    return noise(kPixels / 2, seed);
}

/// Grey values (screen, 0 to 255) from a middle and weighted layers.
cv::Mat grey(double middle, const std::vector<std::pair<double, cv::Mat>>& layers) {
    cv::Mat sum(kPixels, kPixels, CV_32F, cv::Scalar(middle));
    for (const auto& [weight, layer] : layers) sum += layer * weight;
    cv::Mat bytes, colour;
    sum.convertTo(bytes, CV_8U);
    cv::cvtColor(bytes, colour, cv::COLOR_GRAY2BGR);
    return colour;
}

void tinted(cv::Mat& picture, const cv::Vec3d& colour) { // BGR, 1 keeps
    cv::Mat scaled;
    cv::multiply(picture, cv::Scalar(colour[0], colour[1], colour[2]), scaled);
    picture = scaled;
}

/// Short scratches and rubber marks, wrapped at the edges.
void scuff(cv::Mat& picture, int count, double darkest, std::uint64_t seed) {
    Draw draw(seed);
    for (int i = 0; i < count; ++i) {
        cv::Point from(draw.below(kPixels), draw.below(kPixels));
        cv::Point to(from.x + draw.below(70) - 35, from.y + draw.below(24) - 12);
        cv::Mat over = picture.clone();
        cv::line(over, from, to, cv::Scalar::all(draw.between(40.0, 120.0)), 1 + draw.below(2), cv::LINE_AA);
        double share = draw.between(0.1, darkest);
        cv::addWeighted(over, share, picture, 1.0 - share, 0.0, picture);
    }
}

void spots(cv::Mat& picture, int count, int radius, double low, double high, std::uint64_t seed) {
    Draw draw(seed);
    for (int i = 0; i < count; ++i) {
        cv::Point at(draw.below(kPixels), draw.below(kPixels));
        cv::Scalar colour = cv::Scalar::all(draw.between(low, high));
        int size = 1 + draw.below(radius);
        for (int dy : {-kPixels, 0, kPixels}) {
            for (int dx : {-kPixels, 0, kPixels}) {
                cv::Point copy = at + cv::Point(dx, dy);
                if (cv::Rect(-8, -8, kPixels + 16, kPixels + 16).contains(copy))
                    cv::circle(picture, copy, size, colour, -1, cv::LINE_AA);
            }
        }
    }
}

/// Joints every `stepX`, `stepY` pixels; each field between them a little lighter or darker than the next.
void joints(cv::Mat& picture, int stepX, int stepY, bool bond, double jointGrey, int width, double vary,
            std::uint64_t seed) {
    for (int row = 0; row * stepY < kPixels; ++row) {
        int shift = bond && row % 2 == 1 ? stepX / 2 : 0;
        for (int column = -1; column * stepX < kPixels; ++column) {
            int name = (column + kPixels / stepX) % (kPixels / stepX);
            Draw draw(hashOf(seed, static_cast<std::uint64_t>(row * 977 + name)));
            cv::Rect field = cv::Rect(column * stepX + shift, row * stepY, stepX, stepY) &
                             cv::Rect(0, 0, kPixels, kPixels);
            if (field.area() == 0) continue;
            picture(field) *= 1.0 + draw.between(-vary, vary);
            cv::Rect left = cv::Rect(column * stepX + shift, row * stepY, width, stepY) &
                            cv::Rect(0, 0, kPixels, kPixels);
            if (left.area() > 0) picture(left).setTo(cv::Scalar::all(jointGrey));
        }
        picture(cv::Rect(0, row * stepY, kPixels, width)).setTo(cv::Scalar::all(jointGrey));
    }
}

cv::Mat plaster(std::uint64_t seed) {
    cv::Mat picture = grey(226.0, {{5.0, grain(seed)},
                                   {4.0, noise(128, seed + 1)},
                                   {3.5, noise(24, seed + 2)},
                                   {4.0, noise(5, seed + 3)}});
    scuff(picture, 22, 0.16, seed + 4);
    spots(picture, 26, 2, 185.0, 212.0, seed + 5);
    return picture;
}

cv::Mat blocks(std::uint64_t seed) {
    cv::Mat picture =
        grey(218.0, {{7.0, grain(seed)}, {6.0, noise(90, seed + 1)}, {4.0, noise(6, seed + 2)}});
    joints(picture, 128, 64, true, 186.0, 3, 0.03, seed + 3);
    return picture;
}

cv::Mat floorTiles(std::uint64_t seed) {
    cv::Mat picture =
        grey(198.0, {{5.0, grain(seed)}, {9.0, noise(40, seed + 1)}, {6.0, noise(9, seed + 2)}});
    spots(picture, 700, 2, 130.0, 225.0, seed + 3);
    joints(picture, 128, 128, false, 128.0, 3, 0.05, seed + 4);
    scuff(picture, 18, 0.3, seed + 5);
    return picture;
}

cv::Mat lino(std::uint64_t seed) {
    cv::Mat picture =
        grey(200.0, {{8.0, grain(seed)}, {9.0, noise(70, seed + 1)}, {7.0, noise(14, seed + 2)}});
    spots(picture, 900, 2, 140.0, 235.0, seed + 3);
    scuff(picture, 40, 0.3, seed + 4);
    return picture;
}

cv::Mat terrazzo(std::uint64_t seed) {
    cv::Mat picture = grey(196.0, {{4.0, grain(seed)}, {5.0, noise(12, seed + 1)}});
    spots(picture, 1500, 4, 90.0, 240.0, seed + 2);
    joints(picture, 256, 256, false, 120.0, 2, 0.02, seed + 3);
    return picture;
}

cv::Mat carpet(std::uint64_t seed) {
    cv::Mat picture =
        grey(168.0, {{26.0, grain(seed)}, {9.0, noise(120, seed + 1)}, {7.0, noise(8, seed + 2)}});
    joints(picture, 256, 256, false, 140.0, 1, 0.04, seed + 3);
    return picture;
}

cv::Mat wood(std::uint64_t seed, bool planks) {
    cv::Mat picture = grey(170.0, {{10.0, noise(128, 4, seed)},
                                   {14.0, noise(40, 2, seed + 1)},
                                   {6.0, noise(220, 16, seed + 2)},
                                   {8.0, noise(4, seed + 3)}});
    tinted(picture, {0.56, 0.82, 1.08});
    if (planks) joints(picture, 64, 256, true, 60.0, 1, 0.10, seed + 4);
    return picture;
}

cv::Mat ceilingGrid(std::uint64_t seed) {
    cv::Mat picture = grey(232.0, {{4.0, grain(seed)}, {3.0, noise(60, seed + 1)}});
    spots(picture, 2600, 1, 170.0, 205.0, seed + 2);
    joints(picture, 256, 256, false, 205.0, 7, 0.015, seed + 3);
    for (int i : {0, 256}) {
        cv::line(picture, {i + 7, 0}, {i + 7, kPixels - 1}, cv::Scalar::all(176.0), 1);
        cv::line(picture, {0, i + 7}, {kPixels - 1, i + 7}, cv::Scalar::all(176.0), 1);
    }
    return picture;
}

cv::Mat outdoors(double middle, const cv::Vec3d& colour, std::uint64_t seed) {
    cv::Mat picture =
        grey(middle, {{24.0, grain(seed)}, {12.0, noise(60, seed + 1)}, {8.0, noise(7, seed + 2)}});
    tinted(picture, colour);
    return picture;
}

cv::Mat brick(std::uint64_t seed) {
    cv::Mat picture = grey(150.0, {{12.0, grain(seed)}, {10.0, noise(50, seed + 1)}});
    tinted(picture, {0.62, 0.74, 1.15});
    joints(picture, 128, 32, true, 178.0, 3, 0.14, seed + 2);
    return picture;
}

cv::Mat leaves(std::uint64_t seed) {
    cv::Mat picture(kPixels, kPixels, CV_8UC3, cv::Scalar(38, 78, 44));
    Draw draw(seed);
    for (int i = 0; i < 260; ++i) {
        double green = draw.between(60.0, 150.0);
        cv::ellipse(picture, {draw.below(kPixels), draw.below(kPixels)},
                    {8 + draw.below(26), 5 + draw.below(8)}, draw.between(0.0, 180.0), 0.0, 360.0,
                    cv::Scalar(green * 0.35, green, green * 0.5), -1, cv::LINE_AA);
    }
    return picture;
}

cv::Mat lampPrism() {
    cv::Mat picture(kPixels, kPixels, CV_8UC3, cv::Scalar(236, 247, 250));
    for (int i = 0; i < kPixels; i += 16) {
        cv::line(picture, {i, 0}, {i, kPixels - 1}, cv::Scalar(222, 234, 238), 2);
        cv::line(picture, {0, i}, {kPixels - 1, i}, cv::Scalar(222, 234, 238), 2);
    }
    return picture;
}

cv::Mat pictureOf(Material material, std::uint64_t seed) {
    switch (material) {
    case Material::Plaster:
        return plaster(seed);
    case Material::Blocks:
        return blocks(seed);
    case Material::FloorTiles:
        return floorTiles(seed);
    case Material::Lino:
        return lino(seed);
    case Material::Terrazzo:
        return terrazzo(seed);
    case Material::Carpet:
        return carpet(seed);
    case Material::Parquet:
        return wood(seed, true);
    case Material::DoorWood:
        return wood(seed, false);
    case Material::CeilingGrid:
        return ceilingGrid(seed);
    case Material::CeilingPlain:
        return grey(236.0, {{3.0, grain(seed)}, {3.0, noise(90, seed + 1)}, {3.0, noise(6, seed + 2)}});
    case Material::Concrete:
        return outdoors(170.0, {0.98, 1.0, 1.0}, seed);
    case Material::Metal:
        return grey(178.0,
                    {{7.0, noise(4, 250, seed)}, {4.0, noise(8, 120, seed + 1)}, {4.0, noise(5, seed + 2)}});
    case Material::Asphalt:
        return outdoors(112.0, {1.02, 1.0, 0.98}, seed);
    case Material::Grass:
        return outdoors(112.0, {0.62, 0.98, 0.80}, seed);
    case Material::Brick:
        return brick(seed);
    case Material::Leaves:
        return leaves(seed);
    case Material::LampPrism:
        return lampPrism();
    case Material::Plain:
    case Material::Count:
        break;
    }
    return {8, 8, CV_8UC3, cv::Scalar::all(255)};
}

} // namespace

float tileOf(Material material) {
    switch (material) {
    case Material::Plaster:
    case Material::CeilingPlain:
        return 2.6F;
    case Material::FloorTiles:
        return 1.2F;
    case Material::CeilingGrid:
        return 1.2F;
    case Material::Blocks:
        return 1.6F;
    case Material::Brick:
        return 1.0F;
    case Material::Asphalt:
    case Material::Grass:
    case Material::Concrete:
    case Material::Lino:
        return 2.0F;
    case Material::DoorWood:
        return 1.1F;
    case Material::LampPrism:
        return 0.6F;
    default:
        return 1.5F;
    }
}

std::vector<Texture> makeMaterials(std::uint64_t seed) {
    std::vector<Texture> textures;
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(Material::Count); ++i)
        textures.emplace_back(pictureOf(static_cast<Material>(i), hashOf(seed, 1000 + i)), true);
    return textures;
}

} // namespace farol::simulation
