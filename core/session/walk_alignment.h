#pragma once
// Where on a known way a recorded walk was at each frame: the walk's own motion and what was recognised on
// it, laid along the way by dynamic programming.

#include "core/base/geometry.h"
#include "core/recognition/detection.h"
#include "core/routing/route.h"

#include <optional>
#include <vector>

namespace farol::session {

/// The way as a function of the walked distance. Map frame, metres.
class WalkedPath {
public:
    explicit WalkedPath(std::vector<routing::PathPoint> points);

    double lengthM() const { return m_at.empty() ? 0.0 : m_at.back(); }
    routing::PathPoint at(double metres) const;
    /// The way of walking, smoothed over a body's turn of 0.7 m before and after; empty on stairs and in
    /// lifts.
    std::optional<Radians> heading(double metres) const;
    /// Does the way bend by more than that within 0.7 m of this spot, or change the level?
    bool bends(double metres, Radians limit) const;

private:
    std::size_t segmentAt(double metres) const;

    std::vector<routing::PathPoint> m_points;
    std::vector<double> m_at;
};

/// Something at `position` that was seen from no further away than `rangeM`; or, where the range was
/// measured, from just there, give or take `rangeSpreadM`.
struct Anchor {
    Point2 position;
    double level = 0.0;
    double rangeM = 3.0;
    std::optional<double> rangeSpreadM = std::nullopt;
    bool ahead = false; ///< an object in the picture lies before whoever walks; a place is where one stands
};

/// One frame of the walk. `motion` is what happened since the frame before.
struct WalkedFrame {
    double time = 0.0;
    recognition::Motion motion;
    std::vector<Anchor> anchors;
};

struct AlignmentOptions {
    double cellM = 0.25;     ///< resolution along the way
    double paceSpread = 0.5; ///< of one step's length, relative: people do not walk evenly
    double headingSpreadRad =
        0.5; ///< of the camera around the way of walking, and of the visual gyroscope's drift
    double anchorSpreadM = 1.0;
    double maxSpeed = 2.0; ///< metres a second

    Result<void> check() const;
};

/// Metres along the way for each frame, never falling; the first frame stands at its beginning, the last at
/// its end. InvalidArgument when the walk is too short for the way (fewer than two frames, or faster than
/// maxSpeed), or the way has no length.
Result<std::vector<double>> alignWalk(const WalkedPath& path, const std::vector<WalkedFrame>& frames,
                                      const AlignmentOptions& options = {});

} // namespace farol::session
