#pragma once
// Where a slow look at a frame is taken: on the spot, or on a thread of its own. One look at a time: who asks
// takes the newest frame when it is free, so that no frame ever waits in a queue.

#include "core/recognition/detection.h"
#include "core/session/percept.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace farol::session {

/// What a look at one frame found.
struct Sight {
    std::uint64_t frame = 0;
    double time = 0.0, sharpness = 0.0;
    std::chrono::steady_clock::time_point arrivedAt; ///< of the frame; to measure only
    recognition::DetectorResult result;
    HopTimes times;
    std::string trouble; ///< why nothing could be looked at; empty: nothing went wrong
};

using Look = std::function<Sight()>;

class Lookout {
public:
    virtual ~Lookout() = default;
    /// No look is under way and no answer waits to be fetched.
    virtual bool free() const = 0;
    /// Only when free.
    virtual void begin(Look look) = 0;
    /// The answer, once.
    virtual std::optional<Sight> finished() = 0;
    /// Until an answer can be fetched; returns at once when nothing is under way.
    virtual void wait() = 0;
};

using LookoutMaker = std::function<std::unique_ptr<Lookout>()>;

/// Looks within begin().
std::unique_ptr<Lookout> lookOnTheSpot();
/// Looks on a thread of its own, which gives way to the threads that take and carry the frames.
std::unique_ptr<Lookout> lookOnAThread();

} // namespace farol::session
