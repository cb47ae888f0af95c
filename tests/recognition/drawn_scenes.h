#pragma once
// Rooms and stairs with known truth: rectangles in space, seen through a camera. Used by the tests and by the
// program that trains the classifiers (with other seeds).

#include "core/base/geometry.h"

#include <opencv2/core.hpp>

#include <cstdint>
#include <vector>

namespace farol::recognition::test {

/// A wall to paint on: metres, x from its left end, y up from the floor.
class PaintedWall {
public:
    PaintedWall(double widthM, double heightM, const cv::Scalar& colour);

    void fill(double x, double y, double width, double height, const cv::Scalar& colour);
    void outline(double x, double y, double width, double height, double line, const cv::Scalar& colour);
    void skirting(const cv::Scalar& colour) { fill(0.0, 0.0, m_widthM, 0.1, colour); }
    /// Uneven light and a weak texture, as on plaster or wood.
    void roughen(std::uint64_t seed, double amount);

    const cv::Mat& picture() const { return m_picture; }
    double widthM() const { return m_widthM; }
    double heightM() const { return m_heightM; }

private:
    double m_widthM, m_heightM;
    cv::Mat m_picture;
};

struct DoorLook {
    double width = 0.9, height = 2.05, frame = 0.08;
    cv::Scalar leaf{60, 60, 65}, trim{110, 115, 120};
    bool window = false, handleLeft = false, plate = false, panels = false;
};

void paintDoor(PaintedWall& wall, double x, const DoorLook& look);
void paintCupboard(PaintedWall& wall, double x, double width, double height, const cv::Scalar& colour,
                   int leaves);
void paintRefrigerator(PaintedWall& wall, double x, double height, const cv::Scalar& colour, double splitAt);
void paintPoster(PaintedWall& wall, double x, double y, double width, double height, std::uint64_t seed);
void paintShelves(PaintedWall& wall, double x, double width, double height, int boards, std::uint64_t seed);
void paintLockers(PaintedWall& wall, double x, int columns, const cv::Scalar& colour);
void paintBlinds(PaintedWall& wall, double x, double y, double width, double height, int slats);

/// Looks along +z; x right, y up, z forward, metres. Angles in degrees: yaw to the right, pitch down, roll
/// clockwise.
struct SceneCamera {
    double x = 0.0, height = 1.5, z = 0.0;
    double yaw = 0.0, pitch = 0.0, roll = 0.0;
    double focal = 560.0;
    cv::Size size{640, 480};

    cv::Point3d toCamera(const cv::Point3d& p) const;
    ImagePoint project(const cv::Point3d& p) const;
};

class DrawnScene {
public:
    /// A picture in space: `corner` is its top left, `right` and `down` its sides.
    void add(const cv::Mat& picture, const cv::Point3d& corner, const cv::Point3d& right,
             const cv::Point3d& down);
    /// One colour, as a box's side.
    void add(const cv::Scalar& colour, const cv::Point3d& corner, const cv::Point3d& right,
             const cv::Point3d& down);
    /// A wall across the view at z, its left end at x.
    void addWall(const PaintedWall& wall, double x, double z);
    /// Along the view: a side wall from z onwards, on the left seen from its right face.
    void addSideWall(const PaintedWall& wall, double x, double z, bool onTheLeft);
    void addFloor(const cv::Scalar& colour, double tileM = 0.0, const cv::Scalar& joint = {});
    void addCeiling(const cv::Scalar& colour, double height);
    /// Up and away from the camera: the first riser at z.
    void addStairs(double x, double z, double width, int steps, const cv::Scalar& tread,
                   const cv::Scalar& riser);

    cv::Mat render(const SceneCamera& camera, std::uint64_t seed = 1, double noise = 3.0,
                   double gain = 1.0) const;

private:
    struct Sheet {
        cv::Mat picture; ///< 1x1 for one colour
        cv::Point3d corner, right, down;
    };
    std::vector<Sheet> m_sheets;
};

/// Where a door painted at x on a wall (whose left end is at wallX, across the view at z) is in the picture.
Quad doorOutline(const SceneCamera& camera, double wallX, double z, double x, const DoorLook& look);

struct KnownScene {
    cv::Mat picture;
    std::vector<Quad> doors; ///< those that are wholly or mostly in the picture
};

/// A wall at 1.5 to 4 m with a door, or with something like one, or with neither.
KnownScene randomDoorScene(std::uint64_t seed);

} // namespace farol::recognition::test
