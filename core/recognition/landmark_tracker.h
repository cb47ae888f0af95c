#pragma once
// What recognition sees now and then, followed from frame to frame with an identity. Recognition may take its
// time: what it found in an earlier frame is carried to the present through the frames between, so the answer
// does not depend on when it came.

#include "core/recognition/quad_flow.h"
#include "core/recognition/track.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace farol::recognition {

/// Who saw it. A track is confirmed or denied only by the sense that found it.
enum class Sense { Landmarks, Structures, Text };

struct TrackerOptions {
    QuadFlowOptions flow;
    double maxGapSeconds = 0.35;     ///< frames further apart show too little in common
    double sameOverlap = 0.3;        ///< of boxes, that makes two sights of one kind the same thing
    int maxMisses = 4;               ///< looks in a row without a thing that was seen once only
    double unconfirmedSeconds = 2.0; ///< without a sight, though looked for: it is not followed any more
    double blindSeconds = 5.0;       ///< the same, where nobody looked
    double rejoinSeconds = 4.0;      ///< in one scene a lost thing that is trained or read is known again
    double rejoinUntrainedSeconds = 1.0;
    double horizontalViewDegrees = 60.0; ///< of the whole picture's width: carries bearings

    Result<void> check() const;
};

/// One thread; deterministic. Times are those of the frames.
class LandmarkTracker {
public:
    explicit LandmarkTracker(TrackerOptions options = {});

    /// The next frame. `cut`: it shows something else than the frame before, so nothing is followed into it.
    /// Frames before `oldestNeeded` are forgotten: nobody is still looking at them.
    void advance(const cv::Mat& image, std::uint64_t frame, double time, int scene, bool cut,
                 std::uint64_t oldestNeeded);

    /// What one look at an earlier frame (or the newest) found, in the order of the frames for each sense.
    /// Answers the same as it is now, each with its track. `complete`: what is not there was not seen (else
    /// only part of the picture was looked at).
    std::vector<Detection> join(Sense sense, std::uint64_t frame, std::vector<Detection> found,
                                bool complete);

    /// Things that are followed now, by their identity.
    std::vector<Track> tracks() const;
    /// Where the things of a sense are now, in pixels of the full frame.
    std::vector<Quad> quadsOf(Sense sense) const;
    /// Did frames come so far apart, up to this one, that nothing can be followed into it?
    bool sparse(std::uint64_t frame) const;
    /// What is not followed any more since the last call, and why.
    std::vector<Rejection> takeEnded();

private:
    struct Picture {
        std::uint64_t frame = 0;
        double time = 0.0;
        int scene = 0;
        bool follows = false, sparse = true;
        ImageSize size;
        FlowPicture flow;
    };
    struct Past {
        std::uint64_t frame = 0;
        QuadState state;
    };
    struct Sized {
        double time = 0.0, logSize = 0.0;
    };
    struct Followed {
        Track track;
        Sense sense = Sense::Landmarks;
        Detection seen; ///< as recognition saw it last
        QuadAnchor anchor;
        std::deque<Past> past; ///< from the anchor's frame on, as far as it was followed
        std::deque<Sized> sizes;
        int misses = 0;
        bool alive = true, leftView = false;
        double lastTime = 0.0; ///< of the newest frame it was in
        int lastScene = 0;
    };
    struct Match {
        std::size_t found = 0, followed = 0;
        double overlap = 0.0;
    };

    std::optional<std::size_t> pictureOf(std::uint64_t frame) const;
    const QuadState* stateIn(const Followed& one, std::uint64_t frame) const;
    Quad quadIn(const Followed& one, const Picture& picture) const;
    std::vector<int> matched(Sense sense, const Picture& picture, const std::vector<Detection>& found) const;
    std::optional<std::size_t> lostOne(Sense sense, const Picture& picture, const Detection& seen,
                                       const std::vector<int>& taken) const;
    std::size_t begin(Sense sense, const Picture& picture, const Detection& seen);
    void see(Followed& one, std::size_t picture, const Detection& seen);
    void carry(Followed& one, std::size_t firstPicture);
    bool step(Followed& one, const Picture& from, const Picture& to);
    void deny(Sense sense, const Picture& picture, const std::vector<Detection>& found,
              const std::vector<int>& owners);
    void end(Followed& one, const char* reason, double value);
    void endAt(Followed& one, const Picture& picture, const char* reason, double value);
    double yawOf(double x, int width) const;
    void present(Followed& one) const;
    void forget(std::uint64_t oldestNeeded);

    TrackerOptions m_options;
    std::deque<Picture> m_pictures; ///< the newest last
    std::vector<Followed> m_followed;
    std::vector<Rejection> m_ended;
    std::uint64_t m_nextTrack = 1;
};

} // namespace farol::recognition
