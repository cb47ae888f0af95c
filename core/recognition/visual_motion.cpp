#include "core/recognition/visual_motion.h"

#include "core/recognition/grey.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include <algorithm>
#include <cmath>

namespace farol::recognition {

namespace {

constexpr int kMinSide = 48;
constexpr double kPaceSeconds = 4.0;
constexpr std::size_t kSpeedsKept = 5;

std::vector<cv::Point2f> freshPoints(const cv::Mat& grey, int count) {
    // Cell by cell, so that one poster does not take all points.
    constexpr int kColumns = 4, kRows = 3;
    std::vector<cv::Point2f> points;
    for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < kColumns; ++column) {
            cv::Rect cell(column * grey.cols / kColumns, row * grey.rows / kRows, grey.cols / kColumns,
                          grey.rows / kRows);
            std::vector<cv::Point2f> found;
            cv::goodFeaturesToTrack(grey(cell), found, count / (kColumns * kRows) + 1, 0.03, 6.0);
            for (cv::Point2f p : found) {
                // What is a corner in a nearly even cell is noise: goodFeaturesToTrack only compares within
                // one.
                cv::Rect patch(cell.x + cvRound(p.x) - 5, cell.y + cvRound(p.y) - 5, 11, 11);
                patch &= cv::Rect(0, 0, grey.cols, grey.rows);
                cv::Scalar mean, deviation;
                cv::meanStdDev(grey(patch), mean, deviation);
                if (deviation[0] < 4.0) continue;
                points.emplace_back(p.x + static_cast<float>(cell.x), p.y + static_cast<float>(cell.y));
            }
        }
    return points;
}

/// How far the picture as a whole moved; empty where most of it did not move alike.
std::optional<cv::Point2f> wholeShift(const cv::Mat& before, const cv::Mat& after) {
    constexpr double kLeastResponse = 0.08;
    constexpr int kSmallSide = 80;
    double scale = double(kSmallSide) / before.cols;
    cv::Mat a, b, window;
    cv::resize(before, a, {}, scale, scale, cv::INTER_AREA);
    cv::resize(after, b, {}, scale, scale, cv::INTER_AREA);
    a.convertTo(a, CV_32F);
    b.convertTo(b, CV_32F);
    cv::createHanningWindow(window, a.size(), CV_32F);
    double response = 0.0;
    cv::Point2d shift = cv::phaseCorrelate(a, b, window, &response);
    if (response < kLeastResponse || !std::isfinite(shift.x) || !std::isfinite(shift.y)) return std::nullopt;
    return cv::Point2f(static_cast<float>(shift.x / scale), static_cast<float>(shift.y / scale));
}

double median(std::vector<double> values) {
    auto mid = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), mid, values.end());
    return *mid;
}

} // namespace

Result<void> VisualMotionOptions::check() const {
    auto wrong = [](const char* what, const char* which) {
        return Error{ErrorCode::InvalidArgument, what, which};
    };
    if (!(horizontalViewDegrees > 10.0 && horizontalViewDegrees < 150.0))
        return wrong("the camera's view is not an angle from 10 to 150 degrees", "horizontalViewDegrees");
    if (workingLongSide < 64 || workingLongSide > 4096)
        return wrong("the working size is not from 64 to 4096 pixels", "workingLongSide");
    if (maxPoints < flow.minPoints) return wrong("fewer points are followed than the fit needs", "maxPoints");
    if (!(maxGapSeconds > 0.0)) return wrong("the gap between frames is not a time above 0", "maxGapSeconds");
    if (!(standingBelow >= 0.0 && walkingAbove >= standingBelow))
        return wrong("walking begins at a lower speed than standing ends", "walkingAbove");
    return {};
}

VisualMotion::VisualMotion(VisualMotionOptions options) : m_options(options), m_compass(options.whole) {}

void VisualMotion::reset() {
    m_before.release();
    m_points.clear();
    m_speeds.clear();
    m_walking.reset();
    m_pace.clear();
}

void VisualMotion::remember(const cv::Mat& grey, double time) {
    m_before = grey;
    m_time = time;
    m_points = freshPoints(grey, m_options.maxPoints);
}

Motion VisualMotion::observe(const cv::Mat& image, double time) {
    if (image.empty() || !std::isfinite(time)) {
        reset();
        return {};
    }
    double scale = 1.0;
    cv::Mat grey = reduced(greyOf(image), m_options.workingLongSide, scale).clone();
    if (grey.cols < kMinSide || grey.rows < kMinSide) {
        reset();
        return {};
    }
    double seconds = time - m_time;
    bool follows = !m_before.empty() && m_before.size() == grey.size() && seconds > 1e-6 &&
                   seconds <= m_options.maxGapSeconds;
    if (!follows) reset();
    Motion motion;
    if (follows) {
        motion = measure(grey, seconds);
        if (!motion.speed) {
            m_speeds.clear();
            m_walking.reset();
        }
    }
    remember(grey, time);
    return motion;
}

std::vector<PointFlow> VisualMotion::follow(const cv::Mat& grey, cv::Point2f guess) const {
    if (m_points.empty()) return {};
    std::vector<cv::Point2f> there, back;
    std::vector<unsigned char> found, foundBack;
    std::vector<float> errors;
    const cv::Size window(15, 15);
    constexpr int kPyramidLevels = 3;
    const cv::TermCriteria stop(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 20, 0.01);
    int flags = 0;
    if (guess != cv::Point2f()) {
        flags = cv::OPTFLOW_USE_INITIAL_FLOW;
        for (cv::Point2f p : m_points) there.push_back(p + guess);
        back = m_points;
    }
    cv::calcOpticalFlowPyrLK(m_before, grey, m_points, there, found, errors, window, kPyramidLevels, stop,
                             flags);
    cv::calcOpticalFlowPyrLK(grey, m_before, there, back, foundBack, errors, window, kPyramidLevels, stop,
                             flags);
    double focal = focalPx(grey);
    cv::Point2d centre(0.5 * (grey.cols - 1), 0.5 * (grey.rows - 1));
    std::vector<PointFlow> flows;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        if (!found[i] || !foundBack[i]) continue;
        cv::Point2f miss = back[i] - m_points[i];
        if (miss.dot(miss) > 0.5F * 0.5F) continue;
        cv::Point2d before(m_points[i]), after(there[i]);
        flows.push_back({(before - centre) / focal, (after - centre) / focal});
    }
    return flows;
}

double VisualMotion::focalPx(const cv::Mat& grey) const {
    return 0.5 * grey.cols / std::tan(0.5 * m_options.horizontalViewDegrees * CV_PI / 180.0);
}

Motion VisualMotion::measure(const cv::Mat& grey, double seconds) {
    std::vector<PointFlow> flows = followed(grey);
    Motion motion = byPoints(flows, seconds);
    if (!motion.turn) motion = byWhole(grey, flows.size() >= enough());
    double limit = m_options.maxTurnDegreesPerSecond * CV_PI / 180.0 * seconds;
    if (motion.turn && std::abs(motion.turn->value) > limit) return {};
    return motion;
}

void VisualMotion::keepSpeed(Motion& motion, double speed) {
    m_speeds.push_back(std::max(0.0, speed));
    if (m_speeds.size() > kSpeedsKept) m_speeds.pop_front();
    double usual = median({m_speeds.begin(), m_speeds.end()});
    if (usual < m_options.standingBelow) m_walking = false;
    if (usual > m_options.walkingAbove) m_walking = true;
    motion.speed = m_walking.value_or(true) ? usual : 0.0;
    motion.walking = m_walking;
}

/// With most points lost the view was covered or smeared; the few that are left fit anything.
std::size_t VisualMotion::enough() const {
    return std::max((m_points.size() + 1) / 2, static_cast<std::size_t>(m_options.flow.minPoints));
}

std::vector<PointFlow> VisualMotion::followed(const cv::Mat& grey) const {
    std::vector<PointFlow> flows = follow(grey, {});
    if (flows.size() >= enough()) return flows;
    // A quick turn moves everything farther than points are looked for: how far, the whole picture tells.
    if (auto shift = wholeShift(m_before, grey)) return follow(grey, *shift);
    return flows;
}

Motion VisualMotion::byPoints(const std::vector<PointFlow>& flows, double seconds) {
    Motion motion;
    if (flows.size() < enough()) return motion;
    std::optional<FlowFit> fit = fitFlow(flows, m_options.flow);
    if (!fit) return motion;
    motion.turn = Radians{-fit->rotation[1]}; // the camera's y axis points down: positive is to the right
    keepSpeed(motion, fit->advance / seconds);
    m_pace.push_back({m_time + seconds, fit->rotation[0] / seconds});
    while (m_pace.front().time < m_time + seconds - kPaceSeconds) m_pace.pop_front();
    if (m_walking.value_or(false)) motion.stepsPerSecond = stepRhythm();
    return motion;
}

/// `disagree`: there are points enough, and they do not move alike. Where people cross the view, the whole is
/// believed only if its parts say the same.
Motion VisualMotion::byWhole(const cv::Mat& grey, bool disagree) {
    constexpr int kEnoughParts = 3;
    std::optional<WholeTurn> whole = m_compass.turn(m_before, grey, focalPx(grey));
    if (!whole) return {};
    bool agrees = whole->parts >= kEnoughParts && whole->spread < m_options.onTheSpotDegrees * CV_PI / 180.0;
    if (disagree && !agrees) return {};
    Motion motion;
    motion.turn = Radians{whole->yaw};
    if (agrees && !disagree) keepSpeed(motion, 0.0);
    return motion;
}

std::optional<double> VisualMotion::stepRhythm() const {
    // A camera on the chest nods once a step: the rhythm is the lag at which the nodding repeats itself.
    constexpr double kGrid = 1.0 / 30.0, kMinLag = 0.36, kMaxLag = 0.9, kMinCorrelation = 0.45;
    if (m_pace.size() < 20 || m_pace.back().time - m_pace.front().time < 0.75 * kPaceSeconds)
        return std::nullopt;
    std::vector<double> signal;
    std::size_t next = 1;
    for (double t = m_pace.front().time; t <= m_pace.back().time; t += kGrid) {
        while (next + 1 < m_pace.size() && m_pace[next].time < t) ++next;
        const PaceSample &a = m_pace[next - 1], &b = m_pace[next];
        double share = std::clamp((t - a.time) / (b.time - a.time), 0.0, 1.0);
        signal.push_back(a.pitchRate + share * (b.pitchRate - a.pitchRate));
    }
    double mean = 0.0;
    for (double value : signal) mean += value / static_cast<double>(signal.size());
    for (double& value : signal) value -= mean;
    auto correlation = [&](std::size_t lag) {
        double product = 0.0, first = 1e-12, second = 1e-12;
        for (std::size_t i = 0; i + lag < signal.size(); ++i) {
            product += signal[i] * signal[i + lag];
            first += signal[i] * signal[i];
            second += signal[i + lag] * signal[i + lag];
        }
        return product / std::sqrt(first * second);
    };
    auto lagOf = [&](double seconds) { return static_cast<std::size_t>(std::lround(seconds / kGrid)); };
    for (std::size_t lag = lagOf(kMinLag); lag <= lagOf(kMaxLag); ++lag) {
        double here = correlation(lag);
        // The first peak, not the highest: every second step fits as well.
        if (here >= kMinCorrelation && here >= correlation(lag - 1) && here >= correlation(lag + 1))
            return 1.0 / (static_cast<double>(lag) * kGrid);
    }
    return std::nullopt;
}

} // namespace farol::recognition
