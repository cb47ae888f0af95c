#pragma once
// Development material for trained planes: crops of real photographs are hung as posters by known
// homographies into other real photographs, from near and square to far, oblique, dim and partly hidden. Made
// anew from a seed each time; nothing of it is images/planar_landmarks, which only judges.

#include "core/base/error.h"
#include "core/base/geometry.h"

#include <opencv2/core.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace farol::bench {

struct ComposedView {
    cv::Mat image;
    Quad outline{};
};

struct ComposedTemplate {
    std::string name;
    double widthM = 0.0, heightM = 0.0;
    std::vector<ComposedView> views; ///< 1 m and 2 m square, 1.5 m turned and nodding
};

struct ComposedFrame {
    struct Shown {
        std::string name; ///< of the template
        Quad quad{};
    };
    cv::Mat image;
    int difficulty = 0; ///< 0 easy, 1 medium, 2 hard
    std::vector<Shown> shown;
};

/// Templates, unknown pictures and rooms come from photographs of their own; which serves as what turns with
/// the seed.
class PlaneComposer {
public:
    /// Poor: posters with little on them, from more sets, and blurred frames with little noise, too.
    enum class Material { Usual, Poor };

    static Result<PlaneComposer> open(const std::filesystem::path& data, std::uint64_t seed,
                                      Material material = Material::Usual);

    int templateCount() const { return static_cast<int>(m_posters.size()); }
    ComposedTemplate templateAt(int number) const;
    /// Every sixth frame is an empty room, every sixth has an unknown picture; the others show one or two
    /// templates.
    ComposedFrame frameAt(int number) const;

private:
    struct Poster {
        cv::Mat picture;
        double widthM = 0.0, heightM = 0.0;
    };

    PlaneComposer(std::uint64_t seed, Material material) : m_seed(seed), m_material(material) {}
    static Poster cut(const cv::Mat& photograph, cv::RNG& draw);
    cv::Mat room(cv::RNG& draw) const;

    std::uint64_t m_seed;
    Material m_material;
    std::vector<Poster> m_posters, m_unknown;
    std::vector<cv::Mat> m_rooms;
};

/// A frame of 640 x 480 from the middle of any photograph.
cv::Mat asFrame(const cv::Mat& photograph);

} // namespace farol::bench
