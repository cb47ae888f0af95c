#pragma once
// Visual gyroscope and pace: what the picture's own flow tells of the user's turning and walking, from sparse
// points followed between two frames; where these are lost, the turn alone from the pictures as wholes. It
// says nothing rather than guess: covered or dark pictures, gaps between frames, views full of people who
// move.

#include "core/base/error.h"
#include "core/recognition/detection.h"
#include "core/recognition/flow_model.h"
#include "core/recognition/whole_turn.h"

#include <opencv2/core.hpp>

#include <deque>
#include <optional>
#include <vector>

namespace farol::recognition {

struct VisualMotionOptions {
    /// Of the whole picture's width; a usual web camera or telephone held upright in its wide direction.
    double horizontalViewDegrees = 60.0;
    int workingLongSide = 320;
    int maxPoints = 140;
    /// Frames further apart in time show too little in common.
    double maxGapSeconds = 0.35;
    /// Faster turns smear the picture and outrun the search.
    double maxTurnDegreesPerSecond = 220.0;
    /// Between these speeds the state stays what it was, so that it does not flicker.
    double standingBelow = 0.15, walkingAbove = 0.31;
    FlowModelOptions flow;
    WholeTurnOptions whole;
    /// A turn as a whole whose parts agree this well is one on the spot: who walks sees near things pass by
    /// quicker than far ones.
    double onTheSpotDegrees = 0.24;

    Result<void> check() const;
};

/// One thread; deterministic. Times are those of the frames.
class VisualMotion {
public:
    explicit VisualMotion(VisualMotionOptions options = {});

    /// `image` 8-bit BGR or grey. What happened since the frame before; the first frame, one of another size,
    /// and one that comes too late or out of order tell nothing and begin anew.
    Motion observe(const cv::Mat& image, double time);
    void reset();

private:
    struct PaceSample {
        double time = 0.0, pitchRate = 0.0;
    };

    Motion measure(const cv::Mat& grey, double seconds);
    std::size_t enough() const;
    std::vector<PointFlow> followed(const cv::Mat& grey) const;
    Motion byPoints(const std::vector<PointFlow>& flows, double seconds);
    Motion byWhole(const cv::Mat& grey, bool disagree);
    void keepSpeed(Motion& motion, double speed);
    double focalPx(const cv::Mat& grey) const;
    std::vector<PointFlow> follow(const cv::Mat& grey, cv::Point2f guess) const;
    void remember(const cv::Mat& grey, double time);
    std::optional<double> stepRhythm() const;

    VisualMotionOptions m_options;
    PictureCompass m_compass;
    cv::Mat m_before;
    double m_time = 0.0;
    std::vector<cv::Point2f> m_points; ///< in m_before, to be followed into the next frame
    std::deque<double> m_speeds;       ///< the last few, for the standing or walking state
    std::optional<bool> m_walking;
    std::deque<PaceSample> m_pace;
};

} // namespace farol::recognition
