#pragma once
// Straight edges near the vertical or the horizontal: what doors and stairs are made of. Edge pixels are
// followed from row to row, which is several times cheaper than a general line detector. Only this folder
// includes it.

#include <opencv2/core.hpp>

#include <vector>

namespace farol::recognition {

struct EdgeOptions {
    double maxTiltDegrees = 20.0; ///< from the vertical, or from the horizontal
    double minContrast = 6.0;     ///< grey levels across the edge
    int minLength = 10;           ///< pixels along the main axis
};

/// An edge as a straight line along its main axis t (y of a near-vertical one, x of a near-horizontal one).
struct EdgeLine {
    double offset = 0.0, slope = 0.0; ///< the other coordinate is offset + slope t
    double from = 0.0, to = 0.0;      ///< along t
    double drawn = 0.0;               ///< how much of that is really edge
    double contrast = 0.0;            ///< mean, grey levels
    bool brighter = false;            ///< to the right, or below

    double at(double t) const { return offset + slope * t; }
    double length() const { return to - from; }
};

/// The picture's edges, derived once and asked for lines, for support along a line, and for their density.
class EdgeField {
public:
    explicit EdgeField(const cv::Mat& grey);

    std::vector<EdgeLine> verticals(const EdgeOptions& options) const;
    std::vector<EdgeLine> horizontals(const EdgeOptions& options) const;

    /// Share of the way from `a` to `b` (strictly inside the picture) where an edge across the vertical
    /// (`upright`) or horizontal runs within `tolerance` pixels; 0 where less than half of the way is inside.
    double support(cv::Point2d a, cv::Point2d b, bool upright, int tolerance = 2,
                   double minContrast = 6.0) const;

    const cv::Mat& dx() const { return m_dx; } ///< CV_16S, four times the grey levels of a step
    const cv::Mat& dy() const { return m_dy; }

private:
    cv::Mat m_dx, m_dy;
};

/// Handles, hinges and signs cut an edge into pieces: those in line are one. Longest first.
std::vector<EdgeLine> joinedLines(std::vector<EdgeLine> pieces, double mostGap, double tolerance = 2.5);

} // namespace farol::recognition
