#include "tests/recognition/corridor_camera.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace farol::recognition::test {

namespace {

double hashed(int x, int y, int seed) {
    auto mix = static_cast<std::uint32_t>(x) * 0x9E3779B1U ^ static_cast<std::uint32_t>(y) * 0x85EBCA77U ^
               static_cast<std::uint32_t>(seed) * 0xC2B2AE3DU;
    mix ^= mix >> 15;
    mix *= 0x2C1B3C6DU;
    mix ^= mix >> 12;
    mix *= 0x297A2D39U;
    mix ^= mix >> 15;
    return static_cast<double>(mix) / 4294967295.0;
}

/// Smooth noise of cells of 1 unit.
double noise(double u, double v, int seed) {
    int x = static_cast<int>(std::floor(u)), y = static_cast<int>(std::floor(v));
    double fx = u - x, fy = v - y;
    fx = fx * fx * (3.0 - 2.0 * fx);
    fy = fy * fy * (3.0 - 2.0 * fy);
    double top = hashed(x, y, seed) * (1.0 - fx) + hashed(x + 1, y, seed) * fx;
    double bottom = hashed(x, y + 1, seed) * (1.0 - fx) + hashed(x + 1, y + 1, seed) * fx;
    return top * (1.0 - fy) + bottom * fy;
}

/// Panels with hard edges (boards, doors) over a grain.
double texture(double u, double v, int face, int seed) {
    int cellU = static_cast<int>(std::floor(u / 0.7)), cellV = static_cast<int>(std::floor(v / 0.6));
    double panel = hashed(cellU, cellV, seed * 31 + face);
    double inner = hashed(static_cast<int>(std::floor(u / 0.17)), static_cast<int>(std::floor(v / 0.15)),
                          seed * 57 + face);
    double grain = noise(u * 9.0, v * 9.0, seed * 7 + face);
    return 0.5 * panel + 0.25 * (panel > 0.45 ? inner : 0.5) + 0.25 * grain;
}

} // namespace

cv::Mat corridorView(const CameraPose& pose, const CorridorLook& look, cv::Size size) {
    double focal = 0.5 * size.width / std::tan(0.5 * look.horizontalViewDegrees * CV_PI / 180.0);
    double cy = std::cos(pose.yaw), sy = std::sin(pose.yaw), cp = std::cos(pose.pitch),
           sp = std::sin(pose.pitch), cr = std::cos(pose.roll), sr = std::sin(pose.roll);
    cv::Vec3d forward(cy * cp, sy * cp, sp), left(-sy, cy, 0.0), up = forward.cross(left);
    cv::Mat image(size, CV_8U);
    for (int row = 0; row < size.height; ++row)
        for (int column = 0; column < size.width; ++column) {
            double px = (column - 0.5 * (size.width - 1)) / focal,
                   py = (row - 0.5 * (size.height - 1)) / focal;
            double x = cr * px - sr * py, y = sr * px + cr * py;
            cv::Vec3d ray = forward - x * left - y * up;
            double nearest = std::numeric_limits<double>::max();
            int face = 0;
            auto meet = [&](double from, double along, double wall, int which) {
                if (std::abs(along) < 1e-12) return;
                double t = (wall - from) / along;
                if (t > 1e-6 && t < nearest) {
                    nearest = t;
                    face = which;
                }
            };
            meet(pose.y, ray[1], ray[1] > 0.0 ? look.halfWidth : -look.halfWidth, ray[1] > 0.0 ? 1 : 2);
            meet(pose.z, ray[2], ray[2] > 0.0 ? look.height : 0.0, ray[2] > 0.0 ? 3 : 4);
            meet(pose.x, ray[0], ray[0] > 0.0 ? look.length : 0.0, ray[0] > 0.0 ? 5 : 6);
            cv::Vec3d hit = cv::Vec3d(pose.x, pose.y, pose.z) + nearest * ray;
            double u = face >= 5 ? hit[1] : hit[0], v = face == 3 || face == 4 ? hit[1] : hit[2];
            double value = 0.5 + look.contrast * (texture(u, v, face, look.seed) - 0.5);
            image.at<unsigned char>(row, column) =
                static_cast<unsigned char>(std::clamp(value * 255.0, 0.0, 255.0));
        }
    return image;
}

} // namespace farol::recognition::test
