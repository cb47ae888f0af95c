#pragma once
// The survey walk of a curator: a recorded walk along known regions becomes trained places, a view every
// metre or so with its position and heading (kind place).

#include "core/building/info.h"
#include "core/capture/frame_source.h"
#include "core/recognition/landmark_library.h"
#include "core/recognition/landmark_recogniser.h"
#include "core/recognition/visual_motion.h"
#include "core/session/walk_alignment.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace farol::session {

struct SurveyOptions {
    double spacingM = 1.0;
    /// Of views nearer than this to a bend the heading is not known where the gyroscope was blind: they are
    /// places without one.
    double maxBendDegrees = 25.0;
    double minSharpness = 3.0; ///< see sharpness.h
    std::string prefix = "place";
    double viewDegrees = 60.0; ///< of the camera, along the longer side; for ranges
    AlignmentOptions alignment;
    recognition::VisualMotionOptions motion;
    recognition::RecogniserOptions recogniser;

    Result<void> check() const;
};

struct SurveyedPlace {
    building::Landmark landmark; ///< id and template are the same
    std::uint64_t frame = 0;
    double time = 0.0;
    double atM = 0.0; ///< along the way
};

struct Survey {
    std::vector<SurveyedPlace> places;
    double lengthM = 0.0;
    std::size_t frames = 0, framesWithMotion = 0, framesWithLandmarks = 0, blurred = 0, leftOut = 0;
    std::vector<double> frameAtM; ///< of every frame read
};

/// Reads the source twice (`open` is called for each), lays the walk along the shortest way through `along`
/// (the first is where it begins, the last where it ends), and adds the places to `library`. The map is not
/// changed: `places` holds what is to be added to it. On an error the library is as it was. InvalidArgument
/// when the walk does not fit the way; NotFound when there is no way, or no frame is fit to be trained.
Result<Survey> surveyWalk(const std::shared_ptr<const building::Building>& building,
                          recognition::LandmarkLibrary& library,
                          const std::function<Result<std::unique_ptr<capture::FrameSource>>()>& open,
                          const std::vector<building::Location>& along, const SurveyOptions& options = {});

} // namespace farol::session
