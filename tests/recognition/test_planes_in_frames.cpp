// Trained planes where frames are awkward: several of one template, cut off by the frame's edge, half hidden,
// upside down, absurdly large.

#include "core/recognition/landmark_recogniser.h"
#include "core/recognition/root_sift.h"
#include "core/recognition/scale_space.h"
#include "core/recognition/training.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drawn_pictures.h"

namespace farol::recognition {
namespace {

const LandmarkRecogniser& recogniser() {
    static const LandmarkRecogniser kOne = [] {
        auto library = std::make_shared<LandmarkLibrary>();
        for (std::uint64_t seed = 1; seed <= 6; ++seed) test::trainPoster(*library, seed);
        return LandmarkRecogniser(library);
    }();
    return kOne;
}

std::vector<Detection> foundIn(const cv::Mat& picture) {
    return recogniser().recognise(picture).detections;
}

TEST(PlanesInFrames, TwoOfOneTemplateAreTwo) {
    const Quad left = quadOf({30, 120, 240, 180}), right = quadOf({360, 150, 200, 150});
    cv::Mat picture = test::room(4);
    test::hang(picture, test::poster(5), left);
    test::hang(picture, test::poster(5), right);
    auto found = foundIn(picture);
    ASSERT_EQ(found.size(), 2U);
    std::sort(found.begin(), found.end(),
              [](const Detection& a, const Detection& b) { return a.quad[0].x < b.quad[0].x; });
    EXPECT_EQ(found[0].templateId.value, "poster-5");
    EXPECT_EQ(found[1].templateId.value, "poster-5");
    EXPECT_GT(test::sharedArea(found[0].quad, left), 0.8);
    EXPECT_GT(test::sharedArea(found[1].quad, right), 0.8);
}

/// A picture that shows the same thing twice is like itself shifted by half.
TEST(PlanesInFrames, APosterThatShowsAThingTwiceHangsThereOnce) {
    cv::Mat half = test::poster(9), twice;
    cv::vconcat(half, half, twice);
    LandmarkLibrary library;
    std::vector<unsigned char> bytes;
    cv::imencode(".png", twice, bytes);
    ASSERT_TRUE(
        addView(library, {TemplateId("twice"), Kind::Poster, "", {}, {}}, {bytes.begin(), bytes.end()}, {}));
    LandmarkRecogniser one(std::make_shared<const LandmarkLibrary>(std::move(library)));
    const Quad quad = quadOf({210, 60, 200, 200.0 * twice.rows / twice.cols});
    cv::Mat picture = test::room(3);
    test::hang(picture, twice, quad);
    auto found = one.recognise(picture).detections;
    ASSERT_EQ(found.size(), 1U);
    EXPECT_GT(test::sharedArea(found[0].quad, quad), 0.8);
}

TEST(PlanesInFrames, APosterCutOffByTheFrameIsFoundWithItsWholeOutline) {
    for (const Quad& quad : {quadOf({-110, 130, 300, 225}), quadOf({450, 130, 300, 225}),
                             quadOf({170, -90, 300, 225}), quadOf({170, 345, 300, 225})}) {
        cv::Mat picture = test::room(2);
        test::hang(picture, test::poster(3), quad);
        auto found = foundIn(picture);
        ASSERT_EQ(found.size(), 1U) << quad[0].x << " " << quad[0].y;
        EXPECT_EQ(found[0].templateId.value, "poster-3");
        EXPECT_GT(test::sharedArea(found[0].quad, quad), 0.75) << quad[0].x << " " << quad[0].y;
    }
}

TEST(PlanesInFrames, APosterThatIsHalfHiddenIsFoundAndAScrapOfItIsNot) {
    const Quad quad = quadOf({150, 110, 340, 255});
    for (double hidden : {0.5, 0.94}) {
        cv::Mat picture = test::room(5), empty = test::room(6);
        test::hang(picture, test::poster(1), quad);
        cv::Rect cover(140, 100, static_cast<int>(10 + 340 * hidden), 280);
        empty(cover).copyTo(picture(cover));
        EXPECT_EQ(foundIn(picture).size(), hidden < 0.6 ? 1U : 0U) << hidden;
    }
}

TEST(PlanesInFrames, UpsideDownAndOnItsSideItIsTheSamePoster) {
    for (int turn : {cv::ROTATE_90_CLOCKWISE, cv::ROTATE_180, cv::ROTATE_90_COUNTERCLOCKWISE}) {
        cv::Mat picture = test::room(1), turned;
        test::hang(picture, test::poster(2), quadOf({200, 140, 240, 180}));
        cv::rotate(picture, turned, turn);
        auto found = foundIn(turned);
        ASSERT_EQ(found.size(), 1U) << turn;
        EXPECT_EQ(found[0].templateId.value, "poster-2");
    }
}

TEST(PlanesInFrames, EveryMirroringIsRefused) {
    for (int axis : {0, 1})
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
            cv::Mat mirrored, picture = test::room(seed);
            cv::flip(test::poster(seed), mirrored, axis);
            test::hang(picture, mirrored, quadOf({160, 100, 320, 240}));
            EXPECT_THAT(foundIn(picture), testing::IsEmpty()) << seed << " axis " << axis;
        }
}

TEST(PlanesInFrames, PosterMadeOfPiecesOfTwoIsNotBoth) {
    cv::Mat picture = test::room(3), mixed = test::poster(1).clone();
    cv::Rect corner(0, 0, mixed.cols / 4, mixed.rows / 4);
    test::poster(4)(corner).copyTo(mixed(corner));
    test::hang(picture, mixed, quadOf({160, 100, 320, 240}));
    auto found = foundIn(picture);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].templateId.value, "poster-1");
}

TEST(PlanesInFrames, EveryExtractorFindsItsOwnPostersAndNoOthers) {
    for (const std::string& name : extractorNames()) {
        auto library = std::make_shared<LandmarkLibrary>();
        library->extractor = *ExtractorOptions::named(name);
        for (std::uint64_t seed = 1; seed <= 4; ++seed) test::trainPoster(*library, seed);
        LandmarkRecogniser own(library);
        const Quad quad{ImagePoint{200, 100}, {430, 130}, {430, 310}, {200, 320}};
        cv::Mat shown = test::room(1), strange = test::room(2);
        test::hang(shown, test::poster(3), quad);
        test::hang(strange, test::poster(60), quad);
        auto found = own.recognise(shown).detections;
        ASSERT_EQ(found.size(), 1U) << name;
        EXPECT_EQ(found[0].templateId.value, "poster-3") << name;
        EXPECT_GT(test::sharedArea(found[0].quad, quad), 0.8) << name;
        EXPECT_THAT(own.recognise(strange).detections, testing::IsEmpty()) << name;
    }
}

TEST(PlanesInFrames, APictureOfTwentyThousandPixelsIsAnswered) {
    cv::Mat picture = test::room(1), wide, tall;
    test::hang(picture, test::poster(2), quadOf({180, 120, 280, 210}));
    cv::resize(picture, wide, {20000, 15000}, 0, 0, cv::INTER_LINEAR);
    EXPECT_EQ(foundIn(wide).size(), 1U);
    cv::resize(picture, tall, {60, 20000}, 0, 0, cv::INTER_LINEAR);
    EXPECT_THAT(foundIn(tall), testing::IsEmpty());
}

TEST(Keypoints, ABusyPartLeavesSomeForThePlainPart) {
    cv::Mat picture(480, 640, CV_8U, cv::Scalar(120));
    cv::RNG draw(7);
    for (int i = 0; i < 2500; ++i) // hard dots on the left, faint ones on the right
        cv::circle(picture, {draw.uniform(0, 420), draw.uniform(0, 480)}, draw.uniform(2, 5),
                   cv::Scalar(draw.uniform(0, 255)), cv::FILLED);
    for (int i = 0; i < 120; ++i)
        cv::circle(picture, {draw.uniform(440, 635), draw.uniform(5, 475)}, draw.uniform(3, 6),
                   cv::Scalar(120 + draw.uniform(6, 12)), cv::FILLED);
    ScaleSpace space;
    std::vector<cv::KeyPoint> keypoints;
    cv::Mat descriptors;
    rootSift(picture, {}, space, keypoints, descriptors);
    auto plain =
        std::count_if(keypoints.begin(), keypoints.end(), [](const auto& one) { return one.pt.x > 440.0F; });
    EXPECT_GE(plain, 60);
    EXPECT_TRUE(std::is_sorted(keypoints.begin(), keypoints.end(),
                               [](const auto& a, const auto& b) { return a.response > b.response; }));
}

} // namespace
} // namespace farol::recognition
