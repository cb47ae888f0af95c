#include "core/recognition/visual_motion.h"
#include "tests/recognition/corridor_camera.h"

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <vector>

namespace farol::recognition::test {
namespace {

constexpr double kFps = 15.0;

struct Walked {
    double turnDegrees = 0.0;  ///< summed over the frames that told
    double truthDegrees = 0.0; ///< over the same frames
    double worstDegrees = 0.0; ///< of a single frame
    double meanSpeed = 0.0;
    int told = 0, silent = 0, walking = 0, standing = 0;
    std::vector<Motion> motions;
};

using Path = std::function<CameraPose(double)>;
using Treatment = std::function<void(cv::Mat&, int)>;

Walked walk(const Path& path, double seconds, const CorridorLook& look = {}, const Treatment& treat = {}) {
    VisualMotion motion;
    Walked walked;
    int frames = static_cast<int>(seconds * kFps);
    for (int i = 0; i <= frames; ++i) {
        double t = i / kFps;
        cv::Mat image = corridorView(path(t), look);
        if (treat) treat(image, i);
        Motion told = motion.observe(image, t);
        walked.motions.push_back(told);
        if (i == 0) continue;
        if (!told.turn) {
            ++walked.silent;
            continue;
        }
        ++walked.told;
        double truth = (path(t).yaw - path(t - 1.0 / kFps).yaw) * 180.0 / CV_PI;
        double error = told.turn->value * 180.0 / CV_PI - truth;
        walked.turnDegrees += told.turn->value * 180.0 / CV_PI;
        walked.truthDegrees += truth;
        walked.worstDegrees = std::max(walked.worstDegrees, std::abs(error));
        walked.meanSpeed += told.speed.value_or(0.0);
        if (told.walking) ++(*told.walking ? walked.walking : walked.standing);
    }
    if (walked.told > 0) walked.meanSpeed /= walked.told;
    return walked;
}

/// A person's walk: nods and sways with the steps.
CameraPose stepping(double t, double speed, double stepsPerSecond = 1.8) {
    CameraPose pose;
    double phase = 2.0 * CV_PI * stepsPerSecond * t;
    pose.x = 5.0 + speed * t;
    pose.y = 0.04 * std::sin(phase / 2.0);
    pose.z = 1.4 + 0.02 * std::sin(phase);
    pose.pitch = 0.012 * std::sin(phase + 0.6);
    pose.yaw = 0.02 * std::sin(phase / 2.0 + 0.3);
    pose.roll = 0.01 * std::sin(phase / 2.0);
    return pose;
}

TEST(VisualMotion, StandingStillIsStandingAndNoTurn) {
    Walked walked = walk([](double) { return CameraPose{10.0}; }, 2.0);
    EXPECT_EQ(walked.silent, 0);
    EXPECT_LT(std::abs(walked.turnDegrees), 0.5);
    EXPECT_LT(walked.meanSpeed, 0.02);
    EXPECT_EQ(walked.walking, 0);
}

TEST(VisualMotion, AQuarterTurnOnTheSpotIsMeasuredWithItsSign) {
    for (double rate : {45.0, -45.0, 90.0, -120.0}) {
        SCOPED_TRACE(rate);
        Walked walked = walk(
            [&](double t) {
                CameraPose pose{10.0};
                pose.yaw = rate * t * CV_PI / 180.0;
                return pose;
            },
            90.0 / std::abs(rate));
        EXPECT_LE(5 * walked.silent, walked.told + walked.silent);
        EXPECT_NEAR(walked.turnDegrees, walked.truthDegrees, 4.0);
        EXPECT_LT(walked.walking, walked.told / 5) << "turning on the spot is not walking";
    }
}

TEST(VisualMotion, AStraightWalkDoesNotTurn) {
    Walked walked = walk([](double t) { return stepping(t, 1.0); }, 6.0);
    EXPECT_LE(walked.silent, walked.told / 10);
    EXPECT_NEAR(walked.turnDegrees, walked.truthDegrees, 4.0);
    EXPECT_GT(walked.walking, walked.told * 8 / 10);
}

TEST(VisualMotion, SpeedFollowsThePace) {
    Walked slow = walk([](double t) { return stepping(t, 0.5); }, 5.0);
    Walked fast = walk([](double t) { return stepping(t, 1.0); }, 5.0);
    ASSERT_GT(slow.meanSpeed, 0.0);
    EXPECT_NEAR(fast.meanSpeed / slow.meanSpeed, 2.0, 0.4);
}

TEST(VisualMotion, SpeedIsTheSameInAnotherCorridorOfTheSameWidth) {
    CorridorLook other;
    other.seed = 5;
    Walked one = walk([](double t) { return stepping(t, 0.8); }, 5.0);
    Walked two = walk([](double t) { return stepping(t, 0.8); }, 5.0, other);
    EXPECT_NEAR(one.meanSpeed / two.meanSpeed, 1.0, 0.25);
}

TEST(VisualMotion, WhoWalksTowardsAWallOfALongCorridorWalks) {
    constexpr double kOff = 0.4; // the camera looks along the corridor, the feet go towards its wall
    auto oblique = [](double t) {
        CameraPose pose = stepping(t, 0.75 * std::cos(kOff));
        pose.y += 0.9 - 0.75 * std::sin(kOff) * t;
        return pose;
    };
    CorridorLook wide{.halfWidth = 1.1, .height = 2.6, .length = 30.0};
    Walked straight = walk([](double t) { return stepping(t, 0.75); }, 3.0, wide);
    Walked along = walk(oblique, 3.0, wide);
    EXPECT_EQ(along.standing, 0);
    EXPECT_GT(along.meanSpeed, 0.6 * straight.meanSpeed);
    EXPECT_LT(along.meanSpeed, 1.6 * straight.meanSpeed);
}

TEST(VisualMotion, AWalkedBendIsMeasured) {
    CorridorLook hall;
    hall.halfWidth = 6.0;
    for (double side : {1.0, -1.0}) {
        SCOPED_TRACE(side);
        // A quarter circle of 1.2 m at 0.8 m/s between two straights.
        auto path = [side](double t) {
            constexpr double kRadius = 1.2, kSpeed = 0.8;
            double bend = 0.5 * CV_PI * kRadius / kSpeed, at = std::clamp(t - 1.5, 0.0, bend);
            double yaw = kSpeed * at / kRadius, after = std::max(0.0, t - 1.5 - bend);
            CameraPose pose = stepping(t, 0.0);
            pose.x = 10.0 + kSpeed * std::min(t, 1.5) + kRadius * std::sin(yaw);
            pose.y += side * (-3.0 + kRadius * (1.0 - std::cos(yaw)) + kSpeed * after);
            pose.yaw += side * yaw;
            return pose;
        };
        Walked walked = walk(path, 5.0, hall);
        EXPECT_LE(walked.silent, walked.told / 5);
        EXPECT_NEAR(walked.turnDegrees, walked.truthDegrees, 8.0);
    }
}

TEST(VisualMotion, StopAndGoAreTold) {
    Walked walked = walk(
        [](double t) {
            CameraPose pose = stepping(std::min(t, 3.0), 0.9);
            return pose;
        },
        5.0);
    ASSERT_TRUE(walked.motions[40].walking);
    EXPECT_TRUE(*walked.motions[40].walking);
    ASSERT_TRUE(walked.motions.back().walking);
    EXPECT_FALSE(*walked.motions.back().walking);
    EXPECT_EQ(walked.motions.back().speed, 0.0);
}

TEST(VisualMotion, TheRhythmOfTheStepsIsHeard) {
    Walked walked = walk([](double t) { return stepping(t, 0.9, 1.8); }, 6.0);
    ASSERT_TRUE(walked.motions.back().stepsPerSecond);
    EXPECT_NEAR(*walked.motions.back().stepsPerSecond, 1.8, 0.2);
    Walked standing = walk([](double) { return CameraPose{10.0}; }, 5.0);
    EXPECT_FALSE(standing.motions.back().stepsPerSecond);
}

TEST(VisualMotion, NoiseAndDimLightDoNotTurnIt) {
    cv::RNG rng(7);
    Walked walked = walk([](double t) { return stepping(t, 0.8); }, 4.0, {},
                         [&](cv::Mat& image, int) {
                             cv::Mat noise(image.size(), CV_16S);
                             rng.fill(noise, cv::RNG::NORMAL, 0.0, 4.0);
                             cv::Mat dim;
                             image.convertTo(dim, CV_16S, 0.5, 10.0);
                             dim += noise;
                             dim.convertTo(image, CV_8U);
                         });
    EXPECT_LE(walked.silent, walked.told / 3);
    EXPECT_NEAR(walked.turnDegrees, walked.truthDegrees, 5.0);
}

TEST(VisualMotion, ACoveredCameraSaysNothing) {
    Walked walked = walk([](double t) { return stepping(t, 0.8); }, 2.0, {},
                         [](cv::Mat& image, int) { image.setTo(12); });
    EXPECT_EQ(walked.told, 0);
    cv::RNG rng(3);
    Walked grain = walk([](double t) { return stepping(t, 0.8); }, 2.0, {},
                        [&](cv::Mat& image, int) { rng.fill(image, cv::RNG::NORMAL, 20.0, 5.0); });
    EXPECT_EQ(grain.told, 0);
}

TEST(VisualMotion, ABlankWallAndASmearedPictureSayNothing) {
    CorridorLook blank;
    blank.contrast = 0.0;
    EXPECT_EQ(walk([](double t) { return stepping(t, 0.8); }, 2.0, blank).told, 0);
    Walked smeared = walk(
        [](double t) {
            CameraPose pose{10.0};
            pose.yaw = 3.0 * t;
            return pose;
        },
        1.0, {},
        [](cv::Mat& image, int) {
            cv::blur(image, image, {75, 5});
        });
    EXPECT_LT(std::abs(smeared.turnDegrees - smeared.truthDegrees),
              0.15 * std::abs(smeared.truthDegrees) + 3.0);
}

TEST(VisualMotion, PeopleWhoCrossDoNotTurnTheCamera) {
    auto people = [](int count, cv::Size size) {
        return [count, size](cv::Mat& image, int frame) {
            for (int person = 0; person < count; ++person) {
                int speed = person % 2 == 0 ? 6 : -7;
                int x = ((frame * speed + person * 97) % 360 + 360) % 360 - 40;
                cv::Mat figure(size, CV_8U);
                cv::RNG rng(static_cast<std::uint64_t>(person) + 11);
                cv::Mat cells(20, 7, CV_8U);
                rng.fill(cells, cv::RNG::UNIFORM, 0, 255);
                cv::resize(cells, figure, figure.size(), 0, 0, cv::INTER_NEAREST);
                cv::Rect place(x, 230 - size.height, size.width, size.height),
                    seen = place & cv::Rect(0, 0, image.cols, image.rows);
                if (seen.area() > 0) figure(seen - place.tl()).copyTo(image(seen));
            }
        };
    };
    Walked one = walk([](double t) { return stepping(t, 0.8); }, 3.0, {}, people(1, {46, 150}));
    EXPECT_NEAR(one.turnDegrees, one.truthDegrees, 5.0);
    EXPECT_GT(one.told, one.silent) << "one person";
    Walked crowd = walk([](double) { return CameraPose{10.0}; }, 3.0, {}, people(3, {70, 200}));
    EXPECT_NEAR(crowd.turnDegrees, crowd.truthDegrees, 6.0) << "silent in " << crowd.silent;
}

TEST(VisualMotion, GapsOtherSizesAndDisorderBeginAnew) {
    VisualMotion motion;
    cv::Mat image = corridorView(CameraPose{10.0});
    EXPECT_FALSE(motion.observe(image, 0.0).turn);
    EXPECT_TRUE(motion.observe(image, 0.1).turn);
    EXPECT_FALSE(motion.observe(image, 5.0).turn) << "a gap";
    EXPECT_TRUE(motion.observe(image, 5.1).turn);
    EXPECT_FALSE(motion.observe(image, 5.0).turn) << "backwards";
    EXPECT_FALSE(
        motion.observe(corridorView(CameraPose{10.0}, {}, {400, 300})(cv::Rect(0, 0, 300, 300)), 5.1).turn);
    EXPECT_FALSE(motion.observe({}, 5.2).turn);
    EXPECT_FALSE(motion.observe(cv::Mat(4, 4, CV_8U, cv::Scalar(0)), 5.3).turn);
}

TEST(VisualMotion, TheSameFramesTellTheSame) {
    Walked one = walk([](double t) { return stepping(t, 0.8); }, 2.0);
    Walked two = walk([](double t) { return stepping(t, 0.8); }, 2.0);
    ASSERT_EQ(one.motions.size(), two.motions.size());
    for (std::size_t i = 0; i < one.motions.size(); ++i) {
        EXPECT_EQ(one.motions[i].turn.has_value(), two.motions[i].turn.has_value());
        EXPECT_EQ(one.motions[i].turn.value_or(Radians{9.0}).value,
                  two.motions[i].turn.value_or(Radians{9.0}).value);
    }
}

TEST(VisualMotion, OptionsAreChecked) {
    EXPECT_TRUE(VisualMotionOptions{}.check());
    VisualMotionOptions wrong;
    wrong.horizontalViewDegrees = 0.0;
    EXPECT_FALSE(wrong.check());
    wrong = {};
    wrong.maxPoints = 3;
    EXPECT_FALSE(wrong.check());
}

} // namespace
} // namespace farol::recognition::test
