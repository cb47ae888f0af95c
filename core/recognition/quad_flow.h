#pragma once
// A quadrilateral carried from one frame to the next by sparse flow: points that are found again forwards and
// backwards, one plane's motion for all of them, and a look that stays what it was when recognition saw it.

#include "core/base/error.h"
#include "core/base/geometry.h"

#include <opencv2/core.hpp>

#include <optional>
#include <vector>

namespace farol::recognition {

struct QuadFlowOptions {
    int workingLongSide = 480;
    int maxPoints = 24, minPoints = 5; ///< followed on one thing
    double maxBackErrorPx = 0.7;       ///< forwards and backwards again, in the working picture
    double fitPx = 1.5;                ///< from the common motion, in the working picture
    double minInlierShare = 0.6;
    double minPointShare = 0.3;   ///< of those that were followed at first
    double minCorrelation = 0.55; ///< with how it looked at first
    double minInView = 0.4;       ///< share of it that is inside the picture

    Result<void> check() const;
};

/// A frame made ready for flow. The pyramid is built when it is first wanted: most frames need none.
class FlowPicture {
public:
    FlowPicture() = default;
    FlowPicture(const cv::Mat& image, const QuadFlowOptions& options);

    const cv::Mat& grey() const { return m_grey; }
    bool empty() const { return m_grey.empty(); }
    const std::vector<cv::Mat>& pyramid() const;
    Quad toWorking(const Quad& full) const;
    Quad toFull(const Quad& working) const;

private:
    cv::Mat m_grey;
    double m_scale = 1.0;
    mutable std::vector<cv::Mat> m_pyramid;
};

/// How a thing looked when recognition saw it; pixels of the working picture.
struct QuadAnchor {
    Quad quad{};
    std::vector<cv::Point2f> points;
    std::vector<cv::Point2f> samples; ///< where its look is taken
    std::vector<float> look;          ///< grey there; empty: too even to tell by
    int level = 0;                    ///< of the pyramid the look is taken from
};

/// Where it is in some later frame.
struct QuadState {
    Quad quad{};
    std::vector<cv::Point2f> points;
    std::vector<int> origins; ///< index of each in QuadAnchor::points
};

enum class FlowEnd { None, PointsLost, Inconsistent, LooksDifferent, LeftView };
const char* flowEndName(FlowEnd end); ///< a stable word, such as "points_lost"

QuadAnchor anchorAt(const FlowPicture& picture, const Quad& quad, const QuadFlowOptions& options);
QuadState stateAt(const QuadAnchor& anchor);
/// From the frame of `state` to the next. Empty when it cannot be told where the thing is now; `end` says
/// why.
std::optional<QuadState> carried(const QuadAnchor& anchor, const QuadState& state, const FlowPicture& from,
                                 const FlowPicture& to, const QuadFlowOptions& options, FlowEnd& end);

} // namespace farol::recognition
