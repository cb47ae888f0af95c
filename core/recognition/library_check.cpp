#include "core/recognition/library_check.h"

#include "core/capture/picture.h"
#include "core/recognition/grey.h"
#include "core/recognition/view_poses.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace farol::recognition {

namespace {

/// The library without view `held` of every template that has others.
std::shared_ptr<const LandmarkLibrary> without(const LandmarkLibrary& library, std::size_t held) {
    auto rest = std::make_shared<LandmarkLibrary>(library);
    for (Template& entry : rest->templates)
        if (entry.views.size() > 1 && held < entry.views.size())
            entry.views.erase(entry.views.begin() + static_cast<std::ptrdiff_t>(held));
    return rest;
}

void look(const LandmarkRecogniser& recogniser, const View& view, bool heldBack, TemplateCheck& check) {
    auto image = capture::decodePicture(view.jpeg, check.id.value);
    if (!image) return;
    bool found = false;
    for (const Detection& detection : recogniser.recognise(*image).detections) {
        if (detection.templateId == check.id)
            found = true;
        else
            ++check.confusedWith[detection.templateId.value];
    }
    if (!heldBack) return;
    ++check.tested;
    if (found) ++check.found;
}

constexpr std::array<double, 6> kSizes{300, 200, 100, 64, 44, 32}; // pixels of the longer side
constexpr std::array<double, 4> kTurns{40, 52, 62, 70};            // degrees, at the second size
constexpr std::size_t kShown = kSizes.size() + kTurns.size();
constexpr double kFocal = 600.0; // of a frame 640 wide
const cv::Size kFrame(640, 480);

/// The photograph's object in the middle of a plain frame, `longSide` pixels long and turned about the
/// upright.
cv::Mat shownAt(const cv::Mat& grey, const View& view, const Plane& plane, double longSide, double degrees) {
    cv::Matx33d toFrame =
        seenFrom(plane, longSide, degrees, kFocal, kFrame) * planeToQuad(plane, view.outline).inv();
    ImageBox box = boundingBox(view.outline);
    double reduction = std::max(box.width, box.height) / longSide;
    cv::Mat soft, mask, frame(kFrame, CV_8U), noise(kFrame, CV_16S);
    cv::GaussianBlur(grey, soft, cv::Size(), std::max(0.4, 0.45 * reduction));
    cv::Matx33d half(1, 0, -0.5, 0, 1, -0.5, 0, 0, 1);
    cv::warpPerspective(soft, frame, half * toFrame * half.inv(), kFrame, cv::INTER_LINEAR,
                        cv::BORDER_REPLICATE);
    auto corners = mapped(seenFrom(plane, longSide, degrees, kFocal, kFrame), plane.corners());
    std::vector<cv::Point> border(corners.begin(), corners.end());
    mask = cv::Mat(kFrame, CV_8U, cv::Scalar::all(255));
    cv::fillConvexPoly(mask, border, cv::Scalar::all(0));
    frame.setTo(127, mask);
    cv::RNG draw(7); // the sensor's noise
    draw.fill(noise, cv::RNG::NORMAL, 0.0, 3.0);
    cv::add(frame, noise, frame, cv::noArray(), CV_8U);
    return frame;
}

const View* squarest(const Template& entry) {
    auto size = [](const View& view) { return boundingBox(view.outline).area(); };
    const View* best = nullptr;
    for (const View& view : entry.views)
        if (nearlyFrontal(view.outline) && (best == nullptr || size(view) > size(*best))) best = &view;
    return best;
}

/// Smaller and smaller, then further and further aside; what comes after the first miss counts no more.
void show(const LandmarkRecogniser& recogniser, const Template& entry, TemplateCheck& check) {
    const View* view = entry.kind == Kind::Place ? nullptr : squarest(entry);
    auto image = view != nullptr ? capture::decodePicture(view->jpeg, check.id.value)
                                 : Result<cv::Mat>(Error{ErrorCode::NotFound, "", ""});
    if (!image) return;
    cv::Mat grey = greyOf(*image);
    Plane plane = planeOf(view->outline, entry.widthM, entry.heightM);
    auto seen = [&](double longSide, double degrees) {
        bool found = false;
        for (const Detection& detection :
             recogniser.recognise(shownAt(grey, *view, plane, longSide, degrees)).detections) {
            if (detection.templateId == check.id)
                found = true;
            else
                ++check.confusedWith[detection.templateId.value];
        }
        ++check.shown;
        if (found) ++check.shownFound;
        return found;
    };
    bool holds = true;
    for (double size : kSizes)
        if (seen(size, 0.0) && holds)
            check.smallestPx = size;
        else
            holds = holds && check.smallestPx == 0.0; // nearest views may be too near
    check.widestDegrees = check.smallestPx > 0.0 && check.smallestPx <= kSizes[1] ? 0.0 : -1.0;
    holds = check.widestDegrees == 0.0;
    for (double turn : kTurns) {
        holds = seen(kSizes[1], turn) && holds;
        if (holds) check.widestDegrees = turn;
    }
    if (check.smallestPx > 0.0 && (entry.widthM || entry.heightM)) {
        double longer = std::max(plane.width, plane.height);
        double metres =
            entry.widthM ? *entry.widthM * longer / plane.width : *entry.heightM * longer / plane.height;
        check.farthestM = kFocal * metres / check.smallestPx;
    }
}

} // namespace

std::vector<TemplateCheck> checkLibrary(const LandmarkLibrary& library, const RecogniserOptions& options,
                                        const std::function<void(std::size_t, std::size_t)>& progress,
                                        const std::atomic<bool>* stop) {
    const auto stopped = [stop] { return stop != nullptr && stop->load(); };
    std::vector<TemplateCheck> checks;
    std::size_t rounds = 0;
    for (const Template& entry : library.templates) {
        TemplateCheck check;
        check.id = entry.id;
        check.views = static_cast<int>(entry.views.size());
        checks.push_back(std::move(check));
        rounds = std::max(rounds, entry.views.size());
    }
    std::size_t done = 0, all = library.viewCount() + library.templates.size() * kShown;
    // One view of every template at a time: as many indexes as the richest template has views, not one for
    // each.
    for (std::size_t held = 0; held < rounds; ++held) {
        LandmarkRecogniser recogniser(without(library, held), options);
        for (std::size_t i = 0; i < library.templates.size(); ++i) {
            const Template& entry = library.templates[i];
            if (stopped()) return checks;
            if (held >= entry.views.size()) continue;
            look(recogniser, entry.views[held], entry.views.size() > 1, checks[i]);
            if (progress) progress(++done, all);
        }
    }
    LandmarkRecogniser whole(std::make_shared<const LandmarkLibrary>(library), options);
    for (std::size_t i = 0; i < library.templates.size() && !stopped(); ++i) {
        show(whole, library.templates[i], checks[i]);
        done += kShown;
        if (progress) progress(done, all);
    }
    return checks;
}

std::optional<TemplateCheck> checkTemplate(const LandmarkLibrary& library, const TemplateId& id,
                                           const RecogniserOptions& options, const std::atomic<bool>* stop) {
    const auto stopped = [stop] { return stop != nullptr && stop->load(); };
    const Template* entry = library.find(id);
    if (entry == nullptr) return std::nullopt;
    TemplateCheck check;
    check.id = id;
    check.views = static_cast<int>(entry->views.size());
    for (std::size_t held = 0; held < entry->views.size() && entry->views.size() > 1; ++held) {
        if (stopped()) return std::nullopt;
        auto rest = std::make_shared<LandmarkLibrary>(library);
        for (Template& other : rest->templates)
            if (other.id == id) other.views.erase(other.views.begin() + static_cast<std::ptrdiff_t>(held));
        look(LandmarkRecogniser(std::move(rest), options), entry->views[held], true, check);
    }
    const LandmarkRecogniser whole(std::make_shared<const LandmarkLibrary>(library), options);
    if (entry->views.size() == 1) look(whole, entry->views.front(), false, check);
    show(whole, *entry, check);
    for (const Template& other : library.templates) {
        if (other.id == id) continue;
        for (const View& view : other.views) {
            if (stopped()) return std::nullopt;
            auto image = capture::decodePicture(view.jpeg, other.id.value);
            if (!image) continue;
            for (const Detection& detection : whole.recognise(*image).detections)
                if (detection.templateId == id) ++check.seenIn[other.id.value];
        }
    }
    return check;
}

} // namespace farol::recognition
