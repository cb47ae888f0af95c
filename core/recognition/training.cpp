#include "core/recognition/training.h"

#include "core/capture/picture.h"
#include "core/recognition/grey.h"
#include "core/recognition/sayings.h"
#include "core/recognition/view_poses.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace farol::recognition {

namespace {

constexpr int kObjectKeypoints = 300; // a view; more add cost and no recall
constexpr int kFewestObjectFeatures = 15;
constexpr int kFewestPlaceFeatures = 30;
/// Pixels around an object, so that its border has features too. SURF and ORB keep away from a picture's
/// edge.
int marginOf(const FeatureExtractor& extractor) {
    return extractor.options().name == "rootsift" ? 16 : 40;
}

Error wrong(const std::string& message, const TrainingRequest& request) {
    return {ErrorCode::InvalidArgument, message, said(Saying::TemplateNamed, {request.id.value})};
}

Quad wholePicture(const cv::Mat& image) {
    return quadOf({0.0, 0.0, static_cast<double>(image.cols), static_cast<double>(image.rows)});
}

/// Convex, clockwise, not a sliver, and inside the picture up to a pixel of rounding (clipped there).
Result<Quad> checkedOutline(Quad outline, const cv::Mat& image, const TrainingRequest& request) {
    constexpr double kSlack = 2.0;
    for (ImagePoint& p : outline) {
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) return wrong(said(Saying::OutlineNumbers), request);
        if (p.x < -kSlack || p.y < -kSlack || p.x > image.cols + kSlack || p.y > image.rows + kSlack)
            return wrong(
                said(Saying::OutlineLeaves, {std::to_string(image.cols), std::to_string(image.rows)}),
                request);
        p.x = std::clamp(p.x, 0.0, static_cast<double>(image.cols));
        p.y = std::clamp(p.y, 0.0, static_cast<double>(image.rows));
    }
    double turns = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        const ImagePoint& a = outline[i];
        const ImagePoint& b = outline[(i + 1) % 4];
        const ImagePoint& c = outline[(i + 2) % 4];
        double z = (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
        if (std::abs(z) < 1e-6 || z * turns < 0.0) return wrong(said(Saying::OutlineOrder), request);
        turns = z;
    }
    if (turns < 0.0) return wrong(said(Saying::OutlineTurned), request);
    ImageBox box = boundingBox(outline);
    if (box.width < 16.0 || box.height < 16.0)
        return wrong(said(Saying::OutlineSmall, {std::to_string(static_cast<int>(box.width)),
                                                 std::to_string(static_cast<int>(box.height))}),
                     request);
    return outline;
}

void keepRows(Features& features, const std::vector<int>& rows) {
    Features kept;
    kept.descriptors =
        cv::Mat(static_cast<int>(rows.size()), features.descriptors.cols, features.descriptors.type());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        kept.keypoints.push_back(features.keypoints[static_cast<std::size_t>(rows[i])]);
        features.descriptors.row(rows[i]).copyTo(kept.descriptors.row(static_cast<int>(i)));
    }
    features = std::move(kept);
}

/// The strongest features inside the quad, in a fixed order.
void keepInside(Features& features, const std::array<cv::Point2f, 4>& quad, int most) {
    std::vector<cv::Point2f> border(quad.begin(), quad.end());
    std::vector<int> rows;
    for (std::size_t i = 0; i < features.keypoints.size(); ++i)
        if (cv::pointPolygonTest(border, features.keypoints[i].pt, false) >= 0.0)
            rows.push_back(static_cast<int>(i));
    std::stable_sort(rows.begin(), rows.end(), [&](int a, int b) {
        return features.keypoints[static_cast<std::size_t>(a)].response >
               features.keypoints[static_cast<std::size_t>(b)].response;
    });
    if (rows.size() > static_cast<std::size_t>(most)) rows.resize(static_cast<std::size_t>(most));
    keepRows(features, rows);
}

void shift(Features& features, double x, double y) {
    for (cv::KeyPoint& point : features.keypoints) {
        point.pt.x += static_cast<float>(x);
        point.pt.y += static_cast<float>(y);
    }
}

std::array<cv::Point2f, 4> corners(const Quad& quad) {
    std::array<cv::Point2f, 4> out;
    for (std::size_t i = 0; i < 4; ++i)
        out[i] = cv::Point2f(static_cast<float>(quad[i].x), static_cast<float>(quad[i].y));
    return out;
}

/// From the part of the photograph that holds the object, so that a small object is not reduced away.
Features objectFeatures(const cv::Mat& grey, const Quad& outline, const FeatureExtractor& extractor) {
    ImageBox box = boundingBox(outline);
    cv::Rect part(static_cast<int>(box.x), static_cast<int>(box.y),
                  static_cast<int>(std::ceil(box.width)) + 1, static_cast<int>(std::ceil(box.height)) + 1);
    part &= cv::Rect(0, 0, grey.cols, grey.rows);
    cv::Mat padded;
    const int margin = marginOf(extractor);
    // The margin shows what really surrounds the object where the photograph has it, and where it ends no
    // edge.
    cv::Rect wide(part.x - margin, part.y - margin, part.width + 2 * margin, part.height + 2 * margin);
    cv::Rect inside = wide & cv::Rect(0, 0, grey.cols, grey.rows);
    cv::copyMakeBorder(grey(inside), padded, inside.y - wide.y, wide.br().y - inside.br().y,
                       inside.x - wide.x, wide.br().x - inside.br().x,
                       cv::BORDER_REPLICATE | cv::BORDER_ISOLATED);
    Features features = extractor.extract(padded);
    shift(features, wide.x, wide.y);
    keepInside(features, corners(outline), kObjectKeypoints);
    return features;
}

/// Adds what would be seen of the plane from the pose. Positions are in the photograph, sizes and angles in
/// the pose.
void addPose(Features& features, const cv::Mat& grey, const Quad& outline, const Plane& plane, int pose,
             const FeatureExtractor& extractor) {
    auto view = posedView(plane, pose, posedLongSide(outline));
    if (!view) return;
    cv::Matx33d toPhoto = planeToQuad(plane, outline);
    cv::Matx33d photoToPicture = view->planeToPicture * toPhoto.inv();
    // Reducing by a warp aliases: the photograph is blurred first, in proportion.
    ImageBox box = boundingBox(outline);
    double reduction = std::max(box.width, box.height) / posedLongSide(outline);
    cv::Mat soft;
    cv::GaussianBlur(grey, soft, cv::Size(), std::max(0.4, view->blur * reduction));
    cv::Matx33d half(1, 0, -0.5, 0, 1, -0.5, 0, 0,
                     1); // pixel centres stand at +0.5 with us, at 0 in warpPerspective
    const int margin = marginOf(extractor);
    cv::Matx33d inwards(1, 0, margin, 0, 1, margin, 0, 0, 1);
    cv::Mat picture;
    cv::warpPerspective(soft, picture, half * inwards * photoToPicture * half.inv(),
                        cv::Size(view->size.width + 2 * margin, view->size.height + 2 * margin),
                        cv::INTER_LINEAR, cv::BORDER_CONSTANT, cv::Scalar(127));
    if (view->afterBlur > 0.0) cv::GaussianBlur(picture, picture, cv::Size(), view->afterBlur);
    Features seen = extractor.extract(picture);
    shift(seen, -margin, -margin);
    keepInside(seen, mapped(view->planeToPicture, plane.corners()), kObjectKeypoints);
    cv::Matx33d back = photoToPicture.inv();
    for (cv::KeyPoint& point : seen.keypoints) {
        point.pt = mapped(back, cv::Point2d(point.pt));
        point.class_id = pose;
    }
    features.keypoints.insert(features.keypoints.end(), seen.keypoints.begin(), seen.keypoints.end());
    features.descriptors.push_back(seen.descriptors);
}

bool hasPoses(const View& view) {
    return std::any_of(view.features.keypoints.begin(), view.features.keypoints.end(),
                       [](const cv::KeyPoint& point) { return point.class_id > 0; });
}

/// Poses are made from the first frontal photograph; others would repeat them.
bool wantsPoses(const Template* known, const Quad& outline) {
    if (!nearlyFrontal(outline)) return false;
    return known == nullptr || std::none_of(known->views.begin(), known->views.end(), hasPoses);
}

Result<void> checkRequest(const TrainingRequest& request, const Template* known) {
    if (request.id.empty()) return wrong(said(Saying::NameNeeded), request);
    for (const auto& size : {request.widthM, request.heightM})
        if (size && !(std::isfinite(*size) && *size > 0.0 && *size < 1000.0))
            return wrong(said(Saying::SizeNotPositive), request);
    if (known != nullptr && known->kind != request.kind)
        return wrong(said(Saying::KindOther,
                          {std::string(kindName(known->kind)), std::string(kindName(request.kind))}),
                     request);
    return {};
}

Result<void> checkCount(std::size_t found, std::size_t wanted, const TrainingRequest& request) {
    if (found >= wanted) return {};
    Error few = wrong(said(request.kind == Kind::Place ? Saying::FewInPicture : Saying::FewInOutline,
                           {std::to_string(found), std::to_string(wanted)}),
                      request);
    few.code = ErrorCode::NotFound;
    return few;
}

/// JPEG stays as it came; other formats are stored as JPEG too, once and at high quality.
std::string asJpeg(const std::string& bytes, const cv::Mat& image) {
    if (bytes.size() > 3 && bytes.compare(0, 3, "\xFF\xD8\xFF") == 0) return bytes;
    std::vector<unsigned char> jpeg;
    cv::imencode(".jpg", image, jpeg, {cv::IMWRITE_JPEG_QUALITY, 95});
    return {jpeg.begin(), jpeg.end()};
}

Result<View> makeView(const LandmarkLibrary& library, const TrainingRequest& request, const Template* known,
                      const std::string& pictureBytes, const std::optional<Quad>& outline) {
    auto image = capture::decodePicture(pictureBytes, said(Saying::TemplateNamed, {request.id.value}));
    if (!image)
        return Error{ErrorCode::Corrupt, said(Saying::PhotographNoPicture),
                     said(Saying::TemplateNamed, {request.id.value})};
    View view;
    view.size = {image->cols, image->rows};
    view.outline = wholePicture(*image);
    bool place = request.kind == Kind::Place;
    if (outline && !place) {
        auto checked = checkedOutline(*outline, *image, request);
        if (!checked) return checked.error();
        view.outline = *checked;
    }
    FeatureExtractor extractor(library.extractor);
    view.features =
        place ? extractor.extract(*image) : objectFeatures(greyOf(*image), view.outline, extractor);
    auto enough = checkCount(view.features.keypoints.size(),
                             place ? kFewestPlaceFeatures : kFewestObjectFeatures, request);
    if (!enough) return enough.error();
    if (!place && wantsPoses(known, view.outline)) {
        Plane plane = planeOf(view.outline, {}, {});
        for (int pose = 1; pose <= kPoseCount; ++pose)
            addPose(view.features, greyOf(*image), view.outline, plane, pose, extractor);
    }
    view.jpeg = asJpeg(pictureBytes, *image);
    return view;
}

} // namespace

Result<void> addView(LandmarkLibrary& library, const TrainingRequest& request,
                     const std::string& pictureBytes, const std::optional<Quad>& outline) {
    if (auto checked = library.extractor.check(); !checked) return checked;
    auto known = std::find_if(library.templates.begin(), library.templates.end(),
                              [&](const Template& t) { return t.id == request.id; });
    const Template* old = known == library.templates.end() ? nullptr : &*known;
    if (auto checked = checkRequest(request, old); !checked) return checked;
    try {
        auto view = makeView(library, request, old, pictureBytes, outline);
        if (!view) return view.error();
        if (old == nullptr) {
            Template fresh;
            fresh.id = request.id;
            fresh.kind = request.kind;
            known = library.templates.insert(library.templates.end(), std::move(fresh));
        }
        if (!request.name.empty()) known->name = request.name;
        if (request.widthM) known->widthM = request.widthM;
        if (request.heightM) known->heightM = request.heightM;
        known->views.push_back(std::move(*view));
        return {};
    } catch (const std::exception& problem) {
        return wrong(said(Saying::PhotographUnusable, {problem.what()}), request);
    }
}

bool removeTemplate(LandmarkLibrary& library, const TemplateId& id) {
    return std::erase_if(library.templates, [&](const Template& t) { return t.id == id; }) > 0;
}

Result<Retrained> retrain(const LandmarkLibrary& photographs, const ExtractorOptions& extractor,
                          const std::function<void(std::size_t, std::size_t)>& progress) {
    if (auto checked = extractor.check(); !checked) return checked.error();
    Retrained fresh;
    fresh.library.extractor = extractor;
    std::size_t done = 0;
    for (const Template& entry : photographs.templates) {
        TrainingRequest request{entry.id, entry.kind, entry.name, entry.widthM, entry.heightM};
        for (std::size_t i = 0; i < entry.views.size(); ++i) {
            const View& view = entry.views[i];
            if (auto added = addView(fresh.library, request, view.jpeg, view.outline); !added)
                fresh.refused.push_back({added.error().code, added.error().message,
                                         said(Saying::ViewOf, {said(Saying::TemplateNamed, {entry.id.value}),
                                                               std::to_string(i)})});
            if (progress) progress(++done, photographs.viewCount());
        }
        if (fresh.library.find(entry.id) != nullptr)
            fresh.library.templates.back().unknownKind = entry.unknownKind;
    }
    return fresh;
}

} // namespace farol::recognition
