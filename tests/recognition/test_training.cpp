#include "core/recognition/training.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drawn_pictures.h"

namespace farol::recognition {
namespace {

using testing::HasSubstr;

TrainingRequest request(const char* name, Kind kind = Kind::Poster) {
    TrainingRequest r;
    r.id = TemplateId(name);
    r.kind = kind;
    return r;
}

TEST(Training, APhotographBecomesATemplateAndFurtherOnesItsViews) {
    LandmarkLibrary library;
    std::string picture = test::jpeg(test::poster(1));
    TrainingRequest first = request("board");
    first.name = "Notice board";
    first.widthM = 0.8;
    ASSERT_TRUE(addView(library, first, picture, {}));
    ASSERT_TRUE(addView(library, request("board"), picture, quadOf({50, 40, 300, 200})));
    ASSERT_EQ(library.templates.size(), 1U);
    const Template& board = library.templates[0];
    EXPECT_EQ(board.name, "Notice board") << "a later view without a name keeps the first";
    EXPECT_EQ(board.widthM, 0.8);
    ASSERT_EQ(board.views.size(), 2U);
    EXPECT_EQ(board.views[0].jpeg, picture) << "a JPEG is kept as it came";
    EXPECT_EQ(board.views[0].size, (ImageSize{400, 300}));
    EXPECT_EQ(board.views[1].outline[2], (ImagePoint{350, 240}));
    for (const View& view : board.views) {
        EXPECT_EQ(static_cast<int>(view.features.keypoints.size()), view.features.descriptors.rows);
        EXPECT_GT(view.features.keypoints.size(), 30U);
    }
    EXPECT_EQ(library.viewCount(), 2U);
}

TEST(Training, FeaturesOfAnObjectLieInsideItsOutline) {
    LandmarkLibrary library;
    cv::Mat photo = test::room(5);
    test::hang(photo, test::poster(2), quadOf({200, 120, 200, 150}));
    ASSERT_TRUE(addView(library, request("p"), test::jpeg(photo), quadOf({200, 120, 200, 150})));
    for (const cv::KeyPoint& point : library.templates[0].views[0].features.keypoints) {
        EXPECT_GE(point.pt.x, 199.0F);
        EXPECT_LE(point.pt.x, 401.0F);
        EXPECT_GE(point.pt.y, 119.0F);
        EXPECT_LE(point.pt.y, 271.0F);
    }
}

TEST(Training, GreyDeepAndPngPicturesAreTaken) {
    cv::Mat grey, deep;
    cv::extractChannel(test::poster(3), grey, 1);
    test::poster(3).convertTo(deep, CV_16UC3, 257.0);
    LandmarkLibrary library;
    EXPECT_TRUE(addView(library, request("grey"), test::png(grey), {}));
    EXPECT_TRUE(addView(library, request("deep"), test::png(deep), {}));
    EXPECT_TRUE(addView(library, request("colour"), test::png(test::poster(3)), {}));
    EXPECT_EQ(library.templates[2].views[0].jpeg.substr(0, 3), "\xFF\xD8\xFF")
        << "every view is stored as JPEG";
}

TEST(Training, AWrongOutlineIsToldAndNothingIsAdded) {
    LandmarkLibrary library;
    std::string picture = test::jpeg(test::poster(1));
    double nan = std::nan("");
    const std::pair<Quad, const char*> wrong[] = {
        {quadOf({300, 200, 200, 50}), "leaves the picture"},
        {Quad{ImagePoint{10, 10}, {300, 200}, {300, 10}, {10, 200}}, "crossing"},
        {Quad{ImagePoint{10, 10}, {10, 200}, {300, 200}, {300, 10}}, "clockwise"},
        {Quad{ImagePoint{10, 10}, {300, 10}, {150, 40}, {10, 200}}, "crossing"},
        {Quad{ImagePoint{10, 10}, {10, 10}, {10, 10}, {10, 10}}, "crossing"},
        {Quad{ImagePoint{nan, 10}, {300, 10}, {300, 200}, {10, 200}}, "no number"},
        {quadOf({10, 10, 9, 9}), "nearer"},
    };
    for (const auto& [outline, words] : wrong) {
        auto added = addView(library, request("board"), picture, outline);
        ASSERT_FALSE(added) << words;
        EXPECT_EQ(added.error().code, ErrorCode::InvalidArgument);
        EXPECT_THAT(added.error().text(), HasSubstr(words));
        EXPECT_THAT(added.error().text(), HasSubstr("board"));
    }
    EXPECT_TRUE(library.templates.empty());
}

TEST(Training, PicturesThatCannotServeAreToldWithWhatToDo) {
    LandmarkLibrary library;
    auto blank =
        addView(library, request("wall"), test::jpeg(cv::Mat(300, 400, CV_8UC3, cv::Scalar::all(180))), {});
    ASSERT_FALSE(blank);
    EXPECT_EQ(blank.error().code, ErrorCode::NotFound);
    EXPECT_THAT(blank.error().text(), HasSubstr("only 0 features"));
    EXPECT_EQ(addView(library, request("dot"), test::png(cv::Mat(1, 1, CV_8UC3, cv::Scalar::all(9))), {})
                  .error()
                  .code,
              ErrorCode::NotFound);
    EXPECT_EQ(addView(library, request("text"), "no picture", {}).error().code, ErrorCode::Corrupt);
    EXPECT_EQ(addView(library, request("none"), "", {}).error().code, ErrorCode::Corrupt);
    EXPECT_EQ(addView(library, request(""), test::jpeg(test::poster(1)), {}).error().code,
              ErrorCode::InvalidArgument);
    EXPECT_TRUE(library.templates.empty());
}

TEST(Training, AnotherKindOfTheSameNameIsRefused) {
    LandmarkLibrary library;
    std::string picture = test::jpeg(test::poster(1));
    ASSERT_TRUE(addView(library, request("a", Kind::Poster), picture, {}));
    auto other = addView(library, request("a", Kind::Place), picture, {});
    ASSERT_FALSE(other);
    EXPECT_THAT(other.error().text(), HasSubstr("poster"));
    EXPECT_EQ(library.viewCount(), 1U);
}

TEST(Training, APlaceTakesTheWholePictureWhateverTheOutline) {
    LandmarkLibrary library;
    ASSERT_TRUE(addView(library, request("here", Kind::Place), test::jpeg(test::poster(4)),
                        quadOf({50, 50, 100, 100})));
    EXPECT_EQ(library.templates[0].views[0].outline, quadOf({0, 0, 400, 300}));
}

TEST(Training, RemovingForgetsAllViews) {
    LandmarkLibrary library;
    test::trainPoster(library, 1);
    test::trainPoster(library, 2);
    EXPECT_FALSE(removeTemplate(library, TemplateId("poster-9")));
    EXPECT_TRUE(removeTemplate(library, TemplateId("poster-1")));
    EXPECT_EQ(library.find(TemplateId("poster-1")), nullptr);
    EXPECT_NE(library.find(TemplateId("poster-2")), nullptr);
}

} // namespace
} // namespace farol::recognition
