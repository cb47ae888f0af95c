#include "tests/recognition/drawn_scenes.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace farol::recognition::test {

namespace {

constexpr double kPixelsPerMetre = 160.0;
constexpr double kDegree = 3.14159265358979323846 / 180.0;

cv::Scalar shaded(const cv::Scalar& colour, double factor) {
    return {std::min(255.0, colour[0] * factor), std::min(255.0, colour[1] * factor),
            std::min(255.0, colour[2] * factor)};
}

} // namespace

PaintedWall::PaintedWall(double widthM, double heightM, const cv::Scalar& colour)
    : m_widthM(widthM),
      m_heightM(heightM),
      m_picture(cvRound(heightM * kPixelsPerMetre), cvRound(widthM * kPixelsPerMetre), CV_8UC3, colour) {}

void PaintedWall::fill(double x, double y, double width, double height, const cv::Scalar& colour) {
    cv::Rect box(cvRound(x * kPixelsPerMetre), cvRound((m_heightM - y - height) * kPixelsPerMetre),
                 std::max(1, cvRound(width * kPixelsPerMetre)),
                 std::max(1, cvRound(height * kPixelsPerMetre)));
    cv::rectangle(m_picture, box, colour, cv::FILLED);
}

void PaintedWall::outline(double x, double y, double width, double height, double line,
                          const cv::Scalar& colour) {
    fill(x, y, width, line, colour);
    fill(x, y + height - line, width, line, colour);
    fill(x, y, line, height, colour);
    fill(x + width - line, y, line, height, colour);
}

void PaintedWall::roughen(std::uint64_t seed, double amount) {
    cv::RNG random(seed);
    cv::Mat coarse(std::max(2, m_picture.rows / 60), std::max(2, m_picture.cols / 60), CV_32F),
        fine(m_picture.size(), CV_32F);
    random.fill(coarse, cv::RNG::NORMAL, 0.0, 2.0 * amount);
    random.fill(fine, cv::RNG::NORMAL, 0.0, amount);
    cv::Mat light, channels[3];
    cv::resize(coarse, light, m_picture.size(), 0.0, 0.0, cv::INTER_CUBIC);
    light += fine;
    cv::split(m_picture, channels);
    for (cv::Mat& channel : channels) cv::add(channel, light, channel, cv::noArray(), CV_8U);
    cv::merge(channels, 3, m_picture);
}

void paintDoor(PaintedWall& wall, double x, const DoorLook& look) {
    wall.fill(x - look.frame, 0.0, look.width + 2.0 * look.frame, look.height + look.frame, look.trim);
    wall.fill(x, 0.0, look.width, look.height, look.leaf);
    wall.outline(x, 0.0, look.width, look.height, 0.012, shaded(look.leaf, 0.55)); // the gap round the leaf
    wall.fill(x, 0.0, look.width, 0.015, cv::Scalar::all(15));                     // and above the floor
    if (look.window)
        wall.fill(x + (look.handleLeft ? 0.15 : 0.6) * look.width, 1.1, 0.18 * look.width, 0.65,
                  {190, 190, 180});
    if (look.plate) wall.fill(x + 0.02, 0.03, look.width - 0.04, 0.2, {150, 155, 160});
    if (look.panels)
        for (double y : {0.25, 1.15})
            for (double u : {0.12, 0.56})
                wall.outline(x + u * look.width, y, 0.32 * look.width, 0.7, 0.015, shaded(look.leaf, 0.75));
    double handle = look.handleLeft ? x + 0.05 : x + look.width - 0.17;
    wall.fill(handle, 1.03, 0.12, 0.025, cv::Scalar::all(200));
    wall.fill(look.handleLeft ? x + 0.04 : x + look.width - 0.075, 0.95, 0.035, 0.16, cv::Scalar::all(170));
}

void paintCupboard(PaintedWall& wall, double x, double width, double height, const cv::Scalar& colour,
                   int leaves) {
    wall.fill(x, 0.0, width, height, shaded(colour, 0.9));
    wall.fill(x, 0.0, width, 0.08, shaded(colour, 0.5));
    double each = width / leaves;
    for (int i = 0; i < leaves; ++i) {
        wall.fill(x + i * each + 0.01, 0.1, each - 0.02, height - 0.14, colour);
        wall.outline(x + i * each + 0.01, 0.1, each - 0.02, height - 0.14, 0.008, shaded(colour, 0.6));
        wall.fill(x + i * each + (i % 2 == 0 ? each - 0.07 : 0.05), 0.9, 0.02, 0.15, cv::Scalar::all(70));
    }
}

void paintRefrigerator(PaintedWall& wall, double x, double height, const cv::Scalar& colour, double splitAt) {
    wall.fill(x, 0.04, 0.7, height, colour);
    wall.outline(x, 0.04, 0.7, height, 0.01, shaded(colour, 0.65));
    wall.fill(x, 0.0, 0.7, 0.05, cv::Scalar::all(30));
    wall.fill(x, splitAt * height, 0.7, 0.02, shaded(colour, 0.45));
    wall.fill(x + 0.05, splitAt * height + 0.06, 0.03, 0.3, shaded(colour, 0.6));
    wall.fill(x + 0.05, splitAt * height - 0.4, 0.03, 0.33, shaded(colour, 0.6));
}

void paintPoster(PaintedWall& wall, double x, double y, double width, double height, std::uint64_t seed) {
    cv::RNG random(seed);
    auto any = [&] {
        return cv::Scalar(random.uniform(20, 240), random.uniform(20, 240), random.uniform(20, 240));
    };
    wall.fill(x, y, width, height, cv::Scalar::all(40));
    wall.fill(x + 0.02, y + 0.02, width - 0.04, height - 0.04, any());
    for (int i = 0; i < 8; ++i) {
        double w = random.uniform(0.1, 0.4) * width, h = random.uniform(0.05, 0.25) * height;
        wall.fill(x + 0.03 + random.uniform(0.0, 0.9) * (width - w - 0.06),
                  y + 0.03 + random.uniform(0.0, 1.0) * (height - h - 0.06), w, h, any());
    }
}

void paintShelves(PaintedWall& wall, double x, double width, double height, int boards, std::uint64_t seed) {
    cv::RNG random(seed);
    wall.fill(x, 0.0, width, height, {60, 90, 120});
    double each = height / boards;
    for (int i = 0; i < boards; ++i) {
        wall.fill(x + 0.03, i * each + 0.03, width - 0.06, each - 0.03, {40, 55, 70});
        for (double at = x + 0.04; at < x + width - 0.12;) {
            double w = random.uniform(0.03, 0.09);
            wall.fill(at, i * each + 0.03, w, random.uniform(0.5, 0.9) * (each - 0.04),
                      {random.uniform(30., 230.), random.uniform(30., 230.), random.uniform(30., 230.)});
            at += w + 0.005;
        }
    }
}

void paintLockers(PaintedWall& wall, double x, int columns, const cv::Scalar& colour) {
    for (int c = 0; c < columns; ++c)
        for (int r = 0; r < 6; ++r) {
            wall.fill(x + 0.3 * c, 0.1 + 0.3 * r, 0.3, 0.3, colour);
            wall.outline(x + 0.3 * c, 0.1 + 0.3 * r, 0.3, 0.3, 0.012, shaded(colour, 0.5));
            wall.fill(x + 0.3 * c + 0.23, 0.23 + 0.3 * r, 0.025, 0.06, cv::Scalar::all(40));
        }
}

void paintBlinds(PaintedWall& wall, double x, double y, double width, double height, int slats) {
    double each = height / slats;
    for (int i = 0; i < slats; ++i) {
        wall.fill(x, y + i * each, width, 0.72 * each, {225, 230, 230});
        wall.fill(x, y + (i + 0.72) * each, width, 0.28 * each, {110, 115, 115});
    }
}

cv::Point3d SceneCamera::toCamera(const cv::Point3d& p) const {
    cv::Point3d d(p.x - x, height - p.y, p.z - z); // y down
    double c = std::cos(yaw * kDegree), s = std::sin(yaw * kDegree);
    d = {c * d.x - s * d.z, d.y, s * d.x + c * d.z};
    c = std::cos(pitch * kDegree);
    s = std::sin(pitch * kDegree);
    d = {d.x, c * d.y - s * d.z, s * d.y + c * d.z};
    c = std::cos(roll * kDegree);
    s = std::sin(roll * kDegree);
    return {c * d.x + s * d.y, -s * d.x + c * d.y, d.z};
}

ImagePoint SceneCamera::project(const cv::Point3d& p) const {
    cv::Point3d d = toCamera(p);
    double depth = std::max(d.z, 1e-3);
    return {focal * d.x / depth + size.width / 2.0, focal * d.y / depth + size.height / 2.0};
}

void DrawnScene::add(const cv::Mat& picture, const cv::Point3d& corner, const cv::Point3d& right,
                     const cv::Point3d& down) {
    m_sheets.push_back({picture, corner, right, down});
}

void DrawnScene::add(const cv::Scalar& colour, const cv::Point3d& corner, const cv::Point3d& right,
                     const cv::Point3d& down) {
    m_sheets.push_back({cv::Mat(1, 1, CV_8UC3, colour), corner, right, down});
}

void DrawnScene::addWall(const PaintedWall& wall, double x, double z) {
    add(wall.picture(), {x, wall.heightM(), z}, {wall.widthM(), 0.0, 0.0}, {0.0, -wall.heightM(), 0.0});
}

void DrawnScene::addSideWall(const PaintedWall& wall, double x, double z, bool onTheLeft) {
    double far = z + wall.widthM();
    add(wall.picture(), {x, wall.heightM(), onTheLeft ? z : far},
        {0.0, 0.0, onTheLeft ? wall.widthM() : -wall.widthM()}, {0.0, -wall.heightM(), 0.0});
}

void DrawnScene::addFloor(const cv::Scalar& colour, double tileM, const cv::Scalar& joint) {
    cv::Mat picture(1, 1, CV_8UC3, colour);
    if (tileM > 0.0) {
        picture = cv::Mat(1600, 1600, CV_8UC3, colour);
        double step = tileM * 1600.0 / 16.0;
        for (double at = 0.0; at < 1600.0; at += step) {
            cv::line(picture, {cvRound(at), 0}, {cvRound(at), 1600}, joint, 2);
            cv::line(picture, {0, cvRound(at)}, {1600, cvRound(at)}, joint, 2);
        }
    }
    add(picture, {-8.0, 0.0, 12.0}, {16.0, 0.0, 0.0}, {0.0, 0.0, -16.0});
}

void DrawnScene::addCeiling(const cv::Scalar& colour, double height) {
    add(colour, {-20.0, height, -5.0}, {40.0, 0.0, 0.0}, {0.0, 0.0, 45.0});
}

void DrawnScene::addStairs(double x, double z, double width, int steps, const cv::Scalar& tread,
                           const cv::Scalar& riser) {
    constexpr double rise = 0.17, run = 0.29;
    for (int i = 0; i < steps; ++i) {
        add(riser, {x, (i + 1) * rise, z + i * run}, {width, 0.0, 0.0}, {0.0, -rise, 0.0});
        add(tread, {x, (i + 1) * rise, z + (i + 1) * run}, {width, 0.0, 0.0}, {0.0, 0.0, -run});
        add(shaded(tread, 1.15), {x, (i + 1) * rise, z + i * run - 0.005}, {width, 0.0, 0.0},
            {0.0, -0.02, 0.0});
    }
}

cv::Mat DrawnScene::render(const SceneCamera& camera, std::uint64_t seed, double noise, double gain) const {
    cv::Mat picture(camera.size, CV_8UC3, cv::Scalar(200, 200, 200));
    cv::Mat depth(camera.size, CV_32F, cv::Scalar(1e9));
    for (const Sheet& sheet : m_sheets) {
        cv::Point3d o = camera.toCamera(sheet.corner);
        cv::Point3d u = camera.toCamera(sheet.corner + sheet.right) - o,
                    v = camera.toCamera(sheet.corner + sheet.down) - o;
        cv::Point3d normal = u.cross(v);
        double offset = normal.dot(o), uu = u.dot(u), vv = v.dot(v);
        for (int y = 0; y < picture.rows; ++y) {
            for (int x = 0; x < picture.cols; ++x) {
                cv::Point3d ray((x + 0.5 - picture.cols / 2.0) / camera.focal,
                                (y + 0.5 - picture.rows / 2.0) / camera.focal, 1.0);
                double along = normal.dot(ray);
                if (std::abs(along) < 1e-12) continue;
                double t = offset / along;
                if (t < 0.05 || t >= static_cast<double>(depth.at<float>(y, x))) continue;
                cv::Point3d at = ray * t - o;
                double a = at.dot(u) / uu, b = at.dot(v) / vv;
                if (a < 0.0 || a >= 1.0 || b < 0.0 || b >= 1.0) continue;
                depth.at<float>(y, x) = static_cast<float>(t);
                cv::Vec3b colour = sheet.picture.at<cv::Vec3b>(static_cast<int>(b * sheet.picture.rows),
                                                               static_cast<int>(a * sheet.picture.cols));
                double light = gain * (1.05 - 0.03 * std::min(t, 10.0));
                for (int c = 0; c < 3; ++c) colour[c] = cv::saturate_cast<uchar>(colour[c] * light);
                picture.at<cv::Vec3b>(y, x) = colour;
            }
        }
    }
    cv::GaussianBlur(picture, picture, cv::Size(), 0.8);
    cv::Mat grain(picture.size(), CV_16SC3);
    cv::RNG(seed).fill(grain, cv::RNG::NORMAL, 0.0, noise);
    cv::add(picture, grain, picture, cv::noArray(), CV_8UC3);
    return picture;
}

Quad doorOutline(const SceneCamera& camera, double wallX, double z, double x, const DoorLook& look) {
    double left = wallX + x, right = left + look.width;
    return {camera.project({left, look.height, z}), camera.project({right, look.height, z}),
            camera.project({right, 0.0, z}), camera.project({left, 0.0, z})};
}

namespace {

cv::Scalar tint(cv::RNG& random, int low, int high) {
    int base = random.uniform(low, high);
    return {static_cast<double>(std::clamp(base + random.uniform(-25, 25), 0, 255)),
            static_cast<double>(std::clamp(base + random.uniform(-12, 12), 0, 255)),
            static_cast<double>(std::clamp(base + random.uniform(-25, 25), 0, 255))};
}

DoorLook anyDoor(cv::RNG& random) {
    DoorLook look;
    look.width = random.uniform(0.75, 1.0);
    look.height = random.uniform(1.95, 2.15);
    look.frame = random.uniform(0.03, 0.11);
    look.leaf = tint(random, 30, 235);
    look.trim = tint(random, 30, 235);
    look.window = random.uniform(0, 3) == 0;
    look.handleLeft = random.uniform(0, 2) == 0;
    look.plate = random.uniform(0, 4) == 0;
    look.panels = random.uniform(0, 4) == 0;
    return look;
}

/// What is no door but has a door's shape.
void paintOther(PaintedWall& wall, double x, cv::RNG& random) {
    std::uint64_t seed = static_cast<std::uint64_t>(random.uniform(1, 100000));
    switch (random.uniform(0, 7)) {
    case 0:
        paintCupboard(wall, x, random.uniform(0.8, 1.6), random.uniform(1.6, 2.3), tint(random, 60, 240),
                      random.uniform(2, 4));
        break;
    case 1:
        paintRefrigerator(wall, x, random.uniform(1.4, 1.9), tint(random, 40, 245),
                          random.uniform(0.35, 0.75));
        break;
    case 2:
        paintPoster(wall, x, random.uniform(0.5, 1.0), random.uniform(0.6, 1.2), random.uniform(0.8, 1.6),
                    seed);
        break;
    case 3:
        paintShelves(wall, x, random.uniform(0.7, 1.4), random.uniform(1.6, 2.2), random.uniform(4, 8), seed);
        break;
    case 4:
        paintLockers(wall, x, random.uniform(2, 6), tint(random, 60, 200));
        break;
    case 5: // a window, a board
        wall.fill(x, random.uniform(0.6, 1.0), random.uniform(0.7, 1.3), random.uniform(0.9, 1.6),
                  tint(random, 150, 255));
        break;
    default: // a pillar or a strip of other paint
        wall.fill(x, 0.0, random.uniform(0.4, 1.1), wall.heightM(), tint(random, 40, 230));
    }
}

} // namespace

KnownScene randomDoorScene(std::uint64_t seed) {
    cv::RNG random(seed * 2654435761U + 17U);
    PaintedWall wall(9.0, random.uniform(2.4, 3.0), tint(random, 120, 240));
    wall.skirting(tint(random, 30, 200));
    bool withDoor = random.uniform(0, 2) == 0;
    DoorLook look = anyDoor(random);
    double x = random.uniform(3.6, 4.6), z = random.uniform(1.5, 3.6);
    if (withDoor)
        paintDoor(wall, x, look);
    else if (random.uniform(0, 5) != 0)
        paintOther(wall, x, random);
    for (double at : {x - 2.0, x + 1.5})
        if (random.uniform(0, 2) == 0) paintOther(wall, at, random);
    wall.roughen(seed, random.uniform(0.5, 5.0));
    SceneCamera camera;
    double heading = random.uniform(-40.0, 40.0);
    // Turned towards the wall's middle from the side, so that the thing is in view.
    camera.x = -std::tan(heading * kDegree) * z * 0.9 + random.uniform(-0.2, 0.2);
    camera.yaw = heading + random.uniform(-6.0, 6.0);
    camera.pitch = random.uniform(-6.0, 14.0);
    camera.roll = random.uniform(-4.0, 4.0);
    camera.height = random.uniform(1.2, 1.65);
    camera.focal = random.uniform(330.0, 520.0);
    camera.size = random.uniform(0, 3) == 0 ? cv::Size(360, 480) : cv::Size(480, 360);
    DrawnScene scene;
    double wallX = -(x + look.width / 2.0);
    scene.addWall(wall, wallX, z);
    scene.addFloor(tint(random, 60, 190), random.uniform(0, 2) == 0 ? random.uniform(0.3, 0.6) : 0.0,
                   tint(random, 60, 150));
    scene.addCeiling(tint(random, 190, 250), wall.heightM());
    KnownScene known;
    known.picture = scene.render(camera, seed, random.uniform(1.0, 6.0), random.uniform(0.5, 1.1));
    Quad quad = doorOutline(camera, wallX, z, x, look);
    ImagePoint centre = boundingBox(quad).centre();
    if (withDoor && centre.x > 0.0 && centre.x < camera.size.width) known.doors.push_back(quad);
    return known;
}

} // namespace farol::recognition::test
