#include "core/session/survey.h"

#include "core/recognition/camera_model.h"
#include "core/recognition/sharpness.h"
#include "core/recognition/training.h"

#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace farol::session {

namespace {

using building::Building;
using building::Landmark;

/// An object of unknown size may be recognised along half a corridor; a place from where it was taken.
constexpr double kObjectRangeM = 10.0, kPlaceRangeM = 1.0;

/// The way through all places, one after the other.
Result<std::vector<routing::PathPoint>> wayThrough(const std::shared_ptr<const Building>& building,
                                                   const std::vector<building::Location>& along) {
    if (along.size() < 2)
        return Error{ErrorCode::InvalidArgument,
                     "a survey needs at least where the walk begins and where it ends", "survey"};
    auto planner = routing::makeOptimalPlanner(building);
    std::vector<routing::PathPoint> way;
    for (std::size_t i = 1; i < along.size(); ++i) {
        auto leg = planner->plan(along[i - 1], along[i]);
        if (!leg) return leg.error();
        way.insert(way.end(), leg->path.begin(), leg->path.end());
    }
    return way;
}

/// What the first reading of the recording tells of each frame.
struct Reading {
    std::vector<WalkedFrame> frames;
    std::vector<double> sharpness;
    std::vector<std::optional<Radians>> headings; ///< turned since the first frame; empty after a gap
};

Anchor anchorOf(const Landmark& landmark, recognition::Detection detection,
                const recognition::Template* trained, const recognition::CameraModel& camera) {
    if (detection.kind == Kind::Place) return {landmark.position, landmark.level, kPlaceRangeM, {}, false};
    if (trained != nullptr) recognition::place(detection, camera, trained->widthM, trained->heightM);
    if (!detection.rangeM) return {landmark.position, landmark.level, kObjectRangeM, {}, true};
    double spread = detection.rangeSpread.value_or(0.0) * *detection.rangeM;
    return {landmark.position, landmark.level, *detection.rangeM, spread, true};
}

std::vector<Anchor> anchorsOf(const Building& building, const recognition::DetectorResult& seen,
                              const recognition::LandmarkLibrary& library,
                              const recognition::CameraModel& camera) {
    std::vector<Anchor> anchors;
    for (const recognition::Detection& detection : seen.detections) {
        const Landmark* only = nullptr;
        int count = 0;
        for (const Landmark& landmark : building.landmarks()) {
            if (detection.templateId.empty() || landmark.templateId != detection.templateId) continue;
            only = &landmark;
            ++count;
        }
        // What hangs in several places does not tell where one is.
        if (count != 1) continue;
        anchors.push_back(anchorOf(*only, detection, library.find(detection.templateId), camera));
    }
    return anchors;
}

Reading readWalk(const Building& building, std::shared_ptr<const recognition::LandmarkLibrary> library,
                 capture::FrameSource& source, const SurveyOptions& options, Survey& survey) {
    Reading reading;
    recognition::VisualMotion motion(options.motion);
    std::optional<recognition::LandmarkRecogniser> recogniser;
    if (library->viewCount() > 0) recogniser.emplace(library, options.recogniser);
    std::optional<Radians> turned = Radians{0.0};
    while (auto frame = source.next()) {
        WalkedFrame walked{frame->capturedAt, motion.observe(frame->image, frame->capturedAt), {}};
        if (recogniser)
            walked.anchors = anchorsOf(building, recogniser->recognise(frame->image), *library,
                                       recognition::CameraModel::assumed(frame->size(), options.viewDegrees));
        if (!reading.frames.empty())
            turned =
                turned && walked.motion.turn ? std::optional(*turned + *walked.motion.turn) : std::nullopt;
        survey.framesWithMotion += walked.motion.turn ? 1 : 0;
        survey.framesWithLandmarks += walked.anchors.empty() ? 0 : 1;
        reading.headings.push_back(turned);
        reading.sharpness.push_back(recognition::sharpness(frame->image));
        survey.blurred += reading.sharpness.back() < options.minSharpness ? 1 : 0;
        reading.frames.push_back(std::move(walked));
    }
    survey.frames = reading.frames.size();
    return reading;
}

/// For each spot of the way the frame to train there: the sharpest within half the spacing.
std::vector<std::size_t> framesToTrain(const Reading& reading, const std::vector<double>& metres,
                                       double lengthM, const SurveyOptions& options) {
    std::vector<std::size_t> chosen;
    for (double spot = 0.0; spot <= lengthM; spot += options.spacingM) {
        std::optional<std::size_t> best;
        for (std::size_t i = 0; i < metres.size(); ++i) {
            if (std::abs(metres[i] - spot) > 0.5 * options.spacingM) continue;
            if (reading.sharpness[i] < options.minSharpness) continue;
            if (!best || reading.sharpness[i] > reading.sharpness[*best]) best = i;
        }
        if (best && (chosen.empty() || chosen.back() != *best)) chosen.push_back(*best);
    }
    return chosen;
}

class Places {
public:
    Places(const Building& building, const recognition::LandmarkLibrary& library,
           const SurveyOptions& options)
        : m_building(building), m_prefix(options.prefix) {
        for (const Landmark& landmark : building.landmarks()) m_taken.insert(landmark.id.value);
        for (const recognition::Template& known : library.templates) m_taken.insert(known.id.value);
    }

    /// Empty outside every region of the map.
    std::optional<Landmark> make(const routing::PathPoint& spot, std::optional<Radians> heading) {
        auto region = m_building.regionAt(spot.position, spot.level);
        if (!region) return std::nullopt;
        Landmark place;
        place.region = m_building.regions()[*region].id;
        std::string stem = m_prefix + "-" + place.region.value + "-", id;
        do id = stem + std::to_string(++m_last[place.region]);
        while (!m_taken.insert(id).second);
        place.id = LandmarkId(id);
        place.templateId = TemplateId(id);
        place.kind = Kind::Place;
        place.level = spot.level;
        place.position = spot.position;
        if (heading) place.heading = wrapped(*heading);
        return place;
    }

private:
    const Building& m_building;
    std::string m_prefix;
    std::set<std::string> m_taken;
    std::map<RegionId, int> m_last;
};

/// The way of walking there; near a bend what the gyroscope says, and nothing where that was blind.
std::optional<Radians> headingAt(const WalkedPath& path, const Reading& reading, std::size_t frame,
                                 double metres, const SurveyOptions& options) {
    bool bends = path.bends(metres, fromDegrees(options.maxBendDegrees));
    if (!bends) return path.heading(metres);
    auto begin = path.heading(0.0);
    if (!begin || !reading.headings[frame]) return std::nullopt;
    return *begin + *reading.headings[frame];
}

} // namespace

Result<void> SurveyOptions::check() const {
    auto wrong = [](const char* message, const char* which) {
        return Error{ErrorCode::InvalidArgument, message, std::string("survey.") + which};
    };
    if (!(std::isfinite(spacingM) && spacingM > 0.0)) return wrong("must be above 0 metres", "spacingM");
    if (!(maxBendDegrees > 0.0)) return wrong("must be above 0 degrees", "maxBendDegrees");
    if (!(viewDegrees >= 20.0 && viewDegrees <= 140.0))
        return wrong("a camera sees 20 to 140 degrees across", "viewDegrees");
    if (prefix.empty()) return wrong("the places need a name to begin with", "prefix");
    for (const Result<void>& checked : {alignment.check(), motion.check(), recogniser.check()})
        if (!checked) return checked;
    return {};
}

Result<Survey> surveyWalk(const std::shared_ptr<const Building>& building,
                          recognition::LandmarkLibrary& library,
                          const std::function<Result<std::unique_ptr<capture::FrameSource>>()>& open,
                          const std::vector<building::Location>& along, const SurveyOptions& options) {
    if (auto checked = options.check(); !checked) return checked.error();
    auto way = wayThrough(building, along);
    if (!way) return way.error();
    WalkedPath path(*std::move(way));
    auto source = open();
    if (!source) return source.error();
    Survey survey;
    survey.lengthM = path.lengthM();
    auto known = std::make_shared<const recognition::LandmarkLibrary>(library);
    Reading reading = readWalk(*building, known, **source, options, survey);
    auto metres = alignWalk(path, reading.frames, options.alignment);
    if (!metres) return metres.error();
    survey.frameAtM = *metres;
    std::vector<std::size_t> chosen = framesToTrain(reading, *metres, path.lengthM(), options);
    Places places(*building, library, options);
    recognition::LandmarkLibrary grown = library;
    auto again = open();
    if (!again) return again.error();
    std::size_t next = 0;
    for (std::size_t i = 0; next < chosen.size(); ++i) {
        auto frame = (*again)->next();
        if (!frame) break;
        if (i != chosen[next]) continue;
        ++next;
        double at = (*metres)[i];
        auto place = places.make(path.at(at), headingAt(path, reading, i, at, options));
        std::vector<unsigned char> jpeg;
        bool encoded = place && cv::imencode(".jpg", frame->image, jpeg, {cv::IMWRITE_JPEG_QUALITY, 92});
        recognition::TrainingRequest request;
        if (place) request.id = place->templateId;
        request.kind = Kind::Place;
        if (!encoded || !addView(grown, request, std::string(jpeg.begin(), jpeg.end()), std::nullopt)) {
            ++survey.leftOut;
            continue;
        }
        survey.places.push_back({*std::move(place), frame->index, frame->capturedAt, at});
    }
    if (survey.places.empty())
        return Error{ErrorCode::NotFound,
                     "no frame of the walk is fit to be trained as a place: " +
                         std::to_string(survey.blurred) + " of " + std::to_string(survey.frames) +
                         " are blurred or blank; walk slower, in better light",
                     "survey"};
    library = std::move(grown);
    return survey;
}

} // namespace farol::session
