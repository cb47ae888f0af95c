#pragma once
// Objects that stand on floors and hang on walls, each built about a spot of its own.

#include "core/simulation/scene_data.h"

#include <opencv2/core.hpp>

#include <array>
#include <cstdint>

namespace farol::simulation {

/// Where an object is: `middle` of its back, which touches the wall; it looks along `front`, and `right` is
/// right for who looks at it. Both of unit length and level.
struct Spot {
    Vec3 middle, right, front;

    Vec3 at(double toRight, double up, double out) const {
        return middle + right * static_cast<float>(toRight) + kUp * static_cast<float>(up) +
               front * static_cast<float>(out);
    }
};
Spot spotAt(Vec3 middle, Point2 front);

struct Measures {
    double width = 0.5, tall = 0.5, deep = 0.02;
};

std::uint32_t addTexture(SceneData& scene, const cv::Mat& picture);

/// A box with a picture on its front; the corners of the front, clockwise from the top left.
std::array<Vec3, 4> addBoard(MeshBuilder& builder, const Spot& spot, const Measures& size,
                             std::uint32_t texture, Vec3 sides, float glow = 0.0F);
/// Spots of these are at the middle of the object's height.
void addExtinguisher(SceneData& scene, MeshBuilder& builder, const Spot& spot, const Measures& size,
                     std::uint64_t seed);
void addFountain(MeshBuilder& builder, const Spot& spot, const Measures& size);
/// Spots of these are at the floor.
void addBin(MeshBuilder& builder, const Spot& spot, const Measures& size, std::uint64_t seed);
void addPlant(MeshBuilder& builder, const Spot& spot, const Measures& size, std::uint64_t seed);
void addFurniture(MeshBuilder& builder, const Spot& spot, const Measures& size, std::uint64_t seed);
void addBag(MeshBuilder& builder, const Spot& spot, std::uint64_t seed);
void addPerson(MeshBuilder& builder, const Spot& spot, std::uint64_t seed);
void addRadiator(MeshBuilder& builder, const Spot& spot, double width);

} // namespace farol::simulation
