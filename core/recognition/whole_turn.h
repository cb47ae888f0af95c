#pragma once
// The camera's turn between two pictures from the pictures as wholes: edges laid over edges on a cylinder, on
// which a turn shifts everything alike. It tells where points cannot be followed: in quick turns, in smeared
// pictures, before doors and walls that show edges but no corners. A near wall that slides by can look like a
// turn: what is told has a spread, and where the parts of the picture disagree nothing is told.

#include <opencv2/core.hpp>

#include <optional>
#include <vector>

namespace farol::recognition {

struct WholeTurnOptions {
    double mostYawDegrees = 28.0, mostPitchDegrees = 3.0;
    /// How well the edges have to lie on each other (normalised correlation), and how much better than where
    /// they lie next best.
    double leastFit = 0.6, leastLead = 0.12;
    /// Mean square of the edges (0 to 1 each) where the pictures overlap: less is grain.
    double leastEdges = 0.01;
    /// How far the parts of the picture may be from the whole.
    double mostSpreadDegrees = 2.5;
};

struct WholeTurn {
    double yaw = 0.0;    ///< of the camera, radians, left positive
    double spread = 0.0; ///< standard deviation of `yaw`, from how far the parts disagree
    int parts = 0;       ///< quarters of the picture that told it by themselves
    double fit = 0.0, lead = 0.0;
};

/// Keeps what depends on the picture's size only. One thread; deterministic.
class PictureCompass {
public:
    explicit PictureCompass(WholeTurnOptions options = {}) : m_options(options) {}

    /// Both grey (8-bit), of one size; `focalPx` in their pixels. Empty where the pictures do not tell.
    std::optional<WholeTurn> turn(const cv::Mat& before, const cv::Mat& after, double focalPx);

private:
    /// Edges of a picture rolled out on a cylinder, columns and rows of equal angle.
    struct Edges {
        cv::Mat picture;  ///< CV_32FC2: across and down, -1 to 1 each
        cv::Mat energies; ///< sums of their squares, as cv::integral has them
    };
    struct Match {
        double fit = 0.0;
        int dx = 0, dy = 0;
    };
    struct Window {
        int firstDx, lastDx, firstDy, lastDy, firstColumn, lastColumn;
    };

    void prepare(cv::Size size, double focalPx);
    Edges edgesOf(const cv::Mat& grey) const;
    static Edges withSums(cv::Mat picture);
    double fitAt(const Edges& before, const Edges& after, const Window& window, int dx, int dy) const;
    /// For each shift to the side the best of the shifts up or down.
    std::vector<Match> profile(const Edges& before, const Edges& after, const Window& window) const;

    WholeTurnOptions m_options;
    cv::Size m_size;
    double m_focalPx = 0.0, m_step = 0.0; ///< radians a column
    cv::Mat m_mapX, m_mapY;
};

} // namespace farol::recognition
