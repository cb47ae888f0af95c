#include "tests/bench/composed_planes.h"

#include "app/farol-cli/evaluate/data_set.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace farol::bench {

namespace {

namespace fs = std::filesystem;

const cv::Size kFrame(640, 480);
constexpr double kFocal = 600.0;
constexpr double kPi = 3.14159265358979323846;
constexpr int kMostTemplates = 100;
constexpr int kTries = 60; // of finding room for a poster

struct Pose {
    double distance = 1.0, yaw = 0.0, pitch = 0.0, roll = 0.0; ///< metres, degrees
};

/// What a difficulty draws from.
struct Conditions {
    double near, far, leastTurn, mostTurn, leastHidden, mostHidden, darkest, brightest, motionPx;
};
constexpr std::array<Conditions, 3> kConditions{{{1.0, 1.5, 0, 20, 0.0, 0.0, 0.75, 1.2, 2.5},
                                                 {1.5, 2.2, 15, 38, 0.0, 0.2, 0.65, 1.2, 3.5},
                                                 {2.2, 3.0, 35, 50, 0.2, 0.4, 0.4, 0.9, 3.5}}};

/// Poster, in metres from its middle, to a frame whose optical axis goes through `at`.
cv::Matx33d projection(const Pose& pose, cv::Point2d at) {
    auto radians = [](double degrees) { return degrees * kPi / 180.0; };
    double yaw = radians(pose.yaw), pitch = radians(pose.pitch), roll = radians(pose.roll);
    cv::Matx33d turn(std::cos(yaw), 0, std::sin(yaw), 0, 1, 0, -std::sin(yaw), 0, std::cos(yaw));
    cv::Matx33d nod(1, 0, 0, 0, std::cos(pitch), -std::sin(pitch), 0, std::sin(pitch), std::cos(pitch));
    cv::Matx33d lean(std::cos(roll), -std::sin(roll), 0, std::sin(roll), std::cos(roll), 0, 0, 0, 1);
    cv::Matx33d r = lean * nod * turn;
    cv::Matx33d place(r(0, 0), r(0, 1), 0, r(1, 0), r(1, 1), 0, r(2, 0), r(2, 1), pose.distance);
    return cv::Matx33d(kFocal, 0, at.x, 0, kFocal, at.y, 0, 0, 1) * place;
}

Quad quadThrough(const cv::Matx33d& h, double width, double height) {
    const std::array<cv::Point2d, 4> corners{{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}};
    Quad quad;
    for (std::size_t i = 0; i < 4; ++i) {
        cv::Vec3d p = h * cv::Vec3d(corners[i].x * width, corners[i].y * height, 1.0);
        quad[i] = {p[0] / p[2], p[1] / p[2]};
    }
    return quad;
}

std::vector<cv::Point2f> outlineOf(const Quad& quad) {
    std::vector<cv::Point2f> points;
    for (const ImagePoint& p : quad) points.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y));
    return points;
}

/// Draws the picture into the quad from nine samples a pixel, so that nothing aliases.
void hang(cv::Mat& frame, const cv::Mat& picture, const Quad& quad) {
    constexpr int kFiner = 3;
    cv::Rect box = cv::boundingRect(outlineOf(quad));
    box = cv::Rect(box.x - 1, box.y - 1, box.width + 2, box.height + 2) & cv::Rect({}, frame.size());
    if (box.empty()) return;
    cv::Mat part = frame(box);
    std::vector<cv::Point2f> from{{0, 0},
                                  {static_cast<float>(picture.cols), 0},
                                  {static_cast<float>(picture.cols), static_cast<float>(picture.rows)},
                                  {0, static_cast<float>(picture.rows)}};
    std::vector<cv::Point2f> to = outlineOf(quad);
    for (cv::Point2f& p : to) p = (p - cv::Point2f(box.tl())) * static_cast<float>(kFiner);
    cv::Matx33d h = cv::getPerspectiveTransform(from, to);
    cv::Matx33d half(1, 0, -0.5, 0, 1, -0.5, 0, 0, 1);
    cv::Mat warped, cover;
    cv::Size fine(part.cols * kFiner, part.rows * kFiner);
    cv::warpPerspective(picture, warped, half * h * half.inv(), fine, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    cv::Mat inside = cv::Mat::zeros(fine, CV_8U);
    std::vector<cv::Point> border(to.begin(), to.end());
    cv::fillConvexPoly(inside, border, cv::Scalar::all(255));
    cv::resize(warped, warped, part.size(), 0, 0, cv::INTER_AREA);
    cv::resize(inside, cover, part.size(), 0, 0, cv::INTER_AREA);
    for (int y = 0; y < part.rows; ++y)
        for (int x = 0; x < part.cols; ++x) {
            double share = cover.at<unsigned char>(y, x) / 255.0;
            auto& out = part.at<cv::Vec3b>(y, x);
            for (int c = 0; c < 3; ++c)
                out[c] = cv::saturate_cast<unsigned char>((1 - share) * out[c] +
                                                          share * warped.at<cv::Vec3b>(y, x)[c]);
        }
}

/// Hides a share of the quad behind a piece of another room: a strip from one side, as a passer-by or a shelf
/// does.
void hide(cv::Mat& frame, const cv::Mat& other, const Quad& quad, double share, cv::RNG& draw) {
    auto side = static_cast<std::size_t>(draw.uniform(0, 4));
    auto between = [&](std::size_t from, std::size_t towards, double part) {
        const ImagePoint &a = quad[from % 4], &b = quad[towards % 4];
        return cv::Point(cvRound(a.x + part * (b.x - a.x)), cvRound(a.y + part * (b.y - a.y)));
    };
    std::vector<cv::Point> strip{between(side, side + 1, -0.05), between(side + 1, side, -0.05),
                                 between(side + 1, side + 2, share), between(side, side + 3, share)};
    cv::Mat mask = cv::Mat::zeros(frame.size(), CV_8U);
    cv::fillConvexPoly(mask, strip, cv::Scalar::all(255), cv::LINE_AA);
    other.copyTo(frame, mask);
}

/// Light, blur, noise and compression of a hand-held camera.
cv::Mat photographed(const cv::Mat& scene, const Conditions& conditions, PlaneComposer::Material material,
                     cv::RNG& draw) {
    bool poor = material == PlaneComposer::Material::Poor;
    cv::Mat picture;
    scene.convertTo(picture, CV_32FC3, draw.uniform(conditions.darkest, conditions.brightest),
                    draw.uniform(-12.0, 12.0));
    double left = draw.uniform(0.8, 1.15), right = draw.uniform(0.8, 1.15);
    for (int y = 0; y < picture.rows; ++y)
        for (int x = 0; x < picture.cols; ++x)
            picture.at<cv::Vec3f>(y, x) *=
                static_cast<float>(left + (right - left) * x / static_cast<double>(picture.cols));
    cv::GaussianBlur(picture, picture, {}, draw.uniform(0.3, poor ? 1.6 : 1.1));
    double motion = draw.uniform(0.0, conditions.motionPx), angle = draw.uniform(0.0, kPi);
    if (motion > 1.0) {
        constexpr int kSide = 9;
        cv::Mat kernel = cv::Mat::zeros(kSide, kSide, CV_32F);
        for (double t = -0.5; t <= 0.5; t += 0.05)
            kernel.at<float>(cvRound(kSide / 2 + t * motion * std::sin(angle)),
                             cvRound(kSide / 2 + t * motion * std::cos(angle))) += 1.0F;
        kernel /= cv::sum(kernel)[0];
        cv::filter2D(picture, picture, -1, kernel);
    }
    cv::Mat noise(picture.size(), CV_32FC3);
    draw.fill(noise, cv::RNG::NORMAL, 0.0, draw.uniform(poor ? 0.5 : 1.5, 6.0));
    picture += noise;
    picture.convertTo(picture, CV_8UC3);
    std::vector<unsigned char> jpeg;
    cv::imencode(".jpg", picture, jpeg, {cv::IMWRITE_JPEG_QUALITY, draw.uniform(60, 93)});
    return cv::imdecode(jpeg, cv::IMREAD_COLOR);
}

double signedTurn(cv::RNG& draw, double most) {
    return draw.uniform(-most, most);
}

Pose drawnPose(const Conditions& conditions, cv::RNG& draw) {
    Pose pose;
    pose.distance = draw.uniform(conditions.near, conditions.far);
    pose.roll = draw.uniform(-8.0, 8.0);
    do {
        pose.yaw = signedTurn(draw, conditions.mostTurn);
        pose.pitch = signedTurn(draw, conditions.mostTurn);
    } while (std::max(std::abs(pose.yaw), std::abs(pose.pitch)) < conditions.leastTurn);
    return pose;
}

bool mostlyInside(const Quad& quad) {
    double outside = 0.0;
    for (const ImagePoint& p : quad)
        outside = std::max({outside, -p.x, -p.y, p.x - kFrame.width, p.y - kFrame.height});
    return outside < 15.0;
}

bool apart(const Quad& a, const Quad& b) {
    std::vector<cv::Point2f> common;
    return cv::intersectConvexConvex(outlineOf(a), outlineOf(b), common) <= 0.0F;
}

std::vector<fs::path> photographs(const fs::path& data, const std::vector<const char*>& folders,
                                  cv::RNG& draw) {
    std::vector<fs::path> all;
    for (const char* folder : folders)
        for (const fs::path& file : cli::picturesOf(data / "images" / folder)) all.push_back(file);
    for (std::size_t i = all.size(); i > 1; --i)
        std::swap(all[i - 1], all[static_cast<std::size_t>(draw.uniform(0, static_cast<int>(i)))]);
    return all;
}

/// Nobody trains a blank door: seen from 2 m a poster must have so many corners.
bool worthTraining(const cv::Mat& picture, std::size_t fewest) {
    cv::Mat grey;
    cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
    cv::resize(grey, grey, {}, 0.4, 0.4, cv::INTER_AREA);
    std::vector<cv::Point2f> corners;
    cv::goodFeaturesToTrack(grey, corners, static_cast<int>(fewest), 0.02, 4.0);
    return corners.size() >= fewest;
}

} // namespace

cv::Mat asFrame(const cv::Mat& photograph) {
    double scale = std::max(static_cast<double>(kFrame.width) / photograph.cols,
                            static_cast<double>(kFrame.height) / photograph.rows);
    cv::Mat sized;
    cv::resize(photograph, sized, {}, scale, scale, scale < 1.0 ? cv::INTER_AREA : cv::INTER_CUBIC);
    cv::Rect middle((sized.cols - kFrame.width) / 2, (sized.rows - kFrame.height) / 2, kFrame.width,
                    kFrame.height);
    return sized(middle & cv::Rect(0, 0, sized.cols, sized.rows)).clone();
}

PlaneComposer::Poster PlaneComposer::cut(const cv::Mat& photograph, cv::RNG& draw) {
    double share = draw.uniform(0.7, 1.0);
    double aspect = draw.uniform(0.66, 1.5); // width to height
    double height = share * std::min(static_cast<double>(photograph.rows), photograph.cols / aspect);
    double width = height * aspect;
    cv::Rect part(draw.uniform(0, photograph.cols - static_cast<int>(width) + 1),
                  draw.uniform(0, photograph.rows - static_cast<int>(height) + 1), static_cast<int>(width),
                  static_cast<int>(height));
    Poster poster;
    double scale = 500.0 / std::max(part.width, part.height);
    cv::resize(photograph(part), poster.picture, {}, scale, scale, cv::INTER_AREA);
    double longer = draw.uniform(0.5, 0.8) / std::max(width, height);
    poster.widthM = longer * width;
    poster.heightM = longer * height;
    return poster;
}

Result<PlaneComposer> PlaneComposer::open(const fs::path& data, std::uint64_t seed, Material material) {
    if (auto found = cli::dataSet(data, "images"); !found) return found.error();
    PlaneComposer composer(seed, material);
    const bool poor = material == Material::Poor;
    std::vector<const char*> folders{"doors/images", "stairs/img", "corridor_walk"};
    if (poor)
        for (const char* more : {"scene_text/icdar2015_sharp", "scene_text/icdar2015_motion_blurred"})
            folders.push_back(more);
    cv::RNG draw(0x9E3779B97F4A7C15ULL * (seed + 1U));
    for (const fs::path& file : photographs(data, folders, draw)) {
        cv::Mat photograph = cv::imread(file.string(), cv::IMREAD_COLOR);
        if (photograph.empty()) continue;
        bool corridor = file.parent_path().filename() == "corridor_walk";
        int share = (cli::shareOf(file.filename().string(), 5) + static_cast<int>(seed % 5)) % 5;
        if (corridor || share == 4) {
            composer.m_rooms.push_back(asFrame(photograph));
            continue;
        }
        auto& posters = share == 3 ? composer.m_unknown : composer.m_posters;
        int parts = photograph.cols > photograph.rows ? 2 : 1; // side by side, so that none shows another's
        int width = photograph.cols / parts;
        for (int part = 0; part < parts && posters.size() < kMostTemplates; ++part) {
            Poster poster = cut(photograph(cv::Rect(part * width, 0, width, photograph.rows)), draw);
            if (worthTraining(poster.picture, poor ? 30 : 80)) posters.push_back(std::move(poster));
        }
    }
    if (composer.m_posters.size() < 2 || composer.m_unknown.empty() || composer.m_rooms.size() < 2)
        return Error{ErrorCode::NotFound, "there are not enough photographs to compose frames from",
                     (data / "images").string()};
    return composer;
}

cv::Mat PlaneComposer::room(cv::RNG& draw) const {
    cv::Mat frame =
        m_rooms[static_cast<std::size_t>(draw.uniform(0, static_cast<int>(m_rooms.size())))].clone();
    if (draw.uniform(0, 2) == 0) cv::flip(frame, frame, 1);
    double share = draw.uniform(0.75, 1.0);
    cv::Size size(static_cast<int>(share * frame.cols), static_cast<int>(share * frame.rows));
    cv::Rect part(draw.uniform(0, frame.cols - size.width + 1), draw.uniform(0, frame.rows - size.height + 1),
                  size.width, size.height);
    cv::Mat near;
    cv::resize(frame(part), near, kFrame, 0, 0, cv::INTER_CUBIC);
    return near;
}

ComposedTemplate PlaneComposer::templateAt(int number) const {
    const Poster& poster = m_posters.at(static_cast<std::size_t>(number));
    ComposedTemplate entry{"photo-" + std::to_string(number), poster.widthM, poster.heightM, {}};
    for (const Pose& pose : {Pose{1.0, 0, 0, 0}, Pose{2.0, 0, 0, 0}, Pose{1.5, 35, 0, 0},
                             Pose{1.5, -35, 0, 0}, Pose{1.5, 0, 28, 0}}) {
        Quad quad = quadThrough(projection(pose, {0, 0}), poster.widthM, poster.heightM);
        ImageBox box = boundingBox(quad);
        double left = std::floor(box.x) - 1.0, top = std::floor(box.y) - 1.0;
        for (ImagePoint& p : quad) p = {p.x - left, p.y - top};
        ComposedView view;
        view.image = cv::Mat(static_cast<int>(box.height) + 3, static_cast<int>(box.width) + 3, CV_8UC3,
                             cv::Scalar::all(127));
        hang(view.image, poster.picture, quad);
        view.outline = quad;
        entry.views.push_back(std::move(view));
    }
    return entry;
}

ComposedFrame PlaneComposer::frameAt(int number) const {
    cv::RNG draw(0x9E3779B97F4A7C15ULL * (m_seed * 1000003U + static_cast<std::uint64_t>(number) + 7U));
    ComposedFrame frame;
    frame.difficulty = number % 3;
    const Conditions& conditions = kConditions[static_cast<std::size_t>(frame.difficulty)];
    cv::Mat scene = room(draw);
    int sort = number / 3 % 6; // 4 empty, 5 unknown
    int wanted = sort == 4 ? 0 : sort == 5 ? 1 : frame.difficulty == 0 ? 1 : draw.uniform(1, 3);
    const std::vector<Poster>& choice = sort == 5 ? m_unknown : m_posters;
    std::vector<Quad> hung;
    for (int tries = 0; tries < kTries && static_cast<int>(hung.size()) < wanted; ++tries) {
        int which = draw.uniform(0, static_cast<int>(choice.size()));
        const Poster& poster = choice[static_cast<std::size_t>(which)];
        Pose pose = drawnPose(conditions, draw);
        cv::Point2d at(draw.uniform(60.0, 580.0), draw.uniform(60.0, 420.0));
        Quad quad = quadThrough(projection(pose, at), poster.widthM, poster.heightM);
        std::string name = "photo-" + std::to_string(which);
        bool again = std::any_of(frame.shown.begin(), frame.shown.end(),
                                 [&](const ComposedFrame::Shown& one) { return one.name == name; });
        if (!mostlyInside(quad) || again ||
            !std::all_of(hung.begin(), hung.end(), [&](const Quad& other) { return apart(quad, other); }))
            continue;
        hang(scene, poster.picture, quad);
        double hidden = draw.uniform(conditions.leastHidden, conditions.mostHidden + 1e-9);
        if (hidden > 0.02) hide(scene, room(draw), quad, hidden, draw);
        hung.push_back(quad);
        if (sort != 5) frame.shown.push_back({name, quad});
    }
    frame.image = photographed(scene, conditions, m_material, draw);
    return frame;
}

} // namespace farol::bench
