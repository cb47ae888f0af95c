// What the landmark curator leans on: changes to a library as steps that can be taken back, and advice on
// photographs.

#include "core/capture/picture.h"
#include "core/recognition/library_check.h"
#include "core/recognition/library_edit.h"
#include "core/recognition/training.h"
#include "core/recognition/view_coach.h"

#include <opencv2/imgproc.hpp>

#include <cstdlib>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drawn_pictures.h"

namespace farol::recognition {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

LandmarkLibrary posters() {
    LandmarkLibrary library;
    for (std::uint64_t seed : {1U, 2U, 3U}) test::trainPoster(library, seed);
    test::trainPoster(library, 1);
    return library;
}

std::vector<std::string> ids(const LandmarkLibrary& library) {
    std::vector<std::string> names;
    for (const Template& entry : library.templates)
        names.push_back(entry.id.value + "/" + std::to_string(entry.views.size()));
    return names;
}

TEST(LibraryEdit, EveryStepCanBeTakenBack) {
    const LandmarkLibrary before = posters();
    Template renamed = before.templates[1];
    renamed.id = TemplateId("notice");
    const std::vector<Result<LibraryStep>> steps{
        change(before, 1, renamed),   merged(before, 0, 2),
        merged(before, 2, 0),         split(before, 0, {1}, TemplateId("second")),
        withoutViews(before, 0, {0}), removal(before, 1),
    };
    const std::vector<std::vector<std::string>> wanted{
        {"poster-1/2", "notice/1", "poster-3/1"},
        {"poster-1/3", "poster-2/1"},
        {"poster-2/1", "poster-3/3"},
        {"poster-1/1", "poster-2/1", "poster-3/1", "second/1"},
        {"poster-1/1", "poster-2/1", "poster-3/1"},
        {"poster-1/2", "poster-3/1"},
    };
    for (std::size_t i = 0; i < steps.size(); ++i) {
        ASSERT_TRUE(steps[i].ok()) << i << steps[i].error().text();
        LandmarkLibrary library = before;
        recognition::apply(library, *steps[i]);
        EXPECT_EQ(ids(library), wanted[i]) << i;
        recognition::apply(library, reversed(*steps[i]));
        EXPECT_EQ(ids(library), ids(before)) << i;
    }
}

TEST(LibraryEdit, WhatMakesNoSenseIsRefused) {
    LandmarkLibrary library = posters();
    test::trainPoster(library, 9, Kind::Place);
    Template taken = library.templates[1];
    taken.id = TemplateId("poster-1");
    EXPECT_EQ(change(library, 1, taken).error().code, ErrorCode::Conflict);
    taken.id = TemplateId("");
    EXPECT_FALSE(change(library, 1, taken).ok());
    EXPECT_FALSE(merged(library, 1, 1).ok());
    EXPECT_FALSE(merged(library, 0, 3).ok()) << "an object and a place";
    EXPECT_FALSE(split(library, 0, {}, TemplateId("new")).ok());
    EXPECT_FALSE(split(library, 0, {0, 1}, TemplateId("new")).ok()) << "nothing would be left";
    EXPECT_EQ(split(library, 0, {1}, TemplateId("poster-2")).error().code, ErrorCode::Conflict);
    EXPECT_FALSE(withoutViews(library, 1, {0}).ok());
    EXPECT_EQ(insertion(library, library.templates[0]).error().code, ErrorCode::Conflict);
}

// The first frontal photograph carries the views that are computed from it.
TEST(LibraryEdit, WhatIsLeftAfterTheFirstViewIsStillRecognisedFromAside) {
    LandmarkLibrary library = posters();
    const auto rich = [&](const Template& entry) {
        return std::any_of(entry.views[0].features.keypoints.begin(), entry.views[0].features.keypoints.end(),
                           [](const cv::KeyPoint& point) { return point.class_id > 0; });
    };
    const auto step = withoutViews(library, 0, {0});
    ASSERT_TRUE(step.ok());
    recognition::apply(library, *step);
    EXPECT_TRUE(rich(library.templates[0]));
}

TEST(TemplateCheck, TellsWhoIsTakenForIt) {
    LandmarkLibrary library = posters();
    TrainingRequest copy;
    copy.id = TemplateId("copy");
    copy.kind = Kind::Poster;
    ASSERT_TRUE(addView(library, copy, test::jpeg(test::poster(2)), {}));
    const auto fine = checkTemplate(library, TemplateId("poster-1"));
    ASSERT_TRUE(fine);
    EXPECT_EQ(fine->tested, 2);
    EXPECT_EQ(fine->found, 2);
    EXPECT_THAT(fine->seenIn, IsEmpty());
    EXPECT_THAT(fine->confusedWith, IsEmpty());
    EXPECT_FALSE(checkTemplate(library, TemplateId("nobody")));
    const std::atomic<bool> stop{true};
    EXPECT_FALSE(checkTemplate(library, TemplateId("poster-1"), {}, &stop));
}

TEST(ViewCoach, SaysWhatIsWrongWithAPhotograph) {
    const Quad quad = quadOf({160, 120, 320, 240});
    cv::Mat good = test::room(1);
    test::hang(good, test::poster(1), quad);
    const ExtractorOptions extractor;
    const auto problems = [&](const cv::Mat& image, const Quad& outline) {
        return judgePicture(image, Kind::Poster, outline, extractor).problems;
    };
    EXPECT_THAT(problems(good, quad), IsEmpty());
    EXPECT_GT(judgePicture(good, Kind::Poster, quad, extractor).keypoints.size(), 30U);
    cv::Mat dark, bright, soft;
    good.convertTo(dark, -1, 0.15);
    good.convertTo(bright, -1, 2.0, 200.0);
    cv::GaussianBlur(good, soft, cv::Size(), 6.0);
    EXPECT_THAT(problems(dark, quad), Contains(Advice::TooDark));
    EXPECT_THAT(problems(bright, quad), Contains(Advice::TooBright));
    EXPECT_THAT(problems(soft, quad), Contains(Advice::Blurred));
    EXPECT_THAT(problems(cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(128)), quad),
                Contains(Advice::FewFeatures));
    cv::Mat far = test::room(1);
    test::hang(far, test::poster(1), quadOf({300, 200, 60, 45}));
    EXPECT_THAT(problems(far, quadOf({300, 200, 60, 45})), Contains(Advice::Nearer));
    Quad crossed = quad;
    std::swap(crossed[0], crossed[1]);
    EXPECT_THAT(problems(good, crossed), ElementsAre(Advice::BadOutline));
    EXPECT_THAT(problems(good, quadOf({160, 120, 900, 240})), ElementsAre(Advice::BadOutline));
    EXPECT_THAT(problems(good, quadOf({160, 120, 0.4, 0.4})), Not(IsEmpty()));
    EXPECT_THAT(judgePicture(good, Kind::Place, std::nullopt, extractor).problems, IsEmpty());
}

// Photographs of a real, dim corridor, of which a library is trained: the coach must not talk people out of
// them.
TEST(ViewCoach, AcceptsRealPhotographsOfADimCorridor) {
    const char* data = std::getenv("FAROL_DATA");
    const std::filesystem::path folder =
        std::filesystem::path(data != nullptr ? data : "") / "images/corridor_walk";
    if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "no " << folder.string();
    int seen = 0, good = 0;
    for (int i = 1; i <= 80; i += 4) {
        auto picture = capture::readPicture(folder / (std::to_string(i) + ".jpg"));
        if (!picture) continue;
        ++seen;
        const PictureQuality quality = judgePicture(*picture, Kind::Place, std::nullopt, {});
        if (quality.problems.empty()) ++good;
    }
    RecordProperty("good", good);
    ASSERT_GE(seen, 15);
    EXPECT_GE(good, seen * 8 / 10) << good << " of " << seen;
}

TEST(ViewCoach, AsksForWhatTheViewsLack) {
    const auto view = [](const Quad& outline) {
        View made;
        made.size = {640, 480};
        made.outline = outline;
        return made;
    };
    std::vector<View> views;
    EXPECT_EQ(nextView(views, Kind::Poster), Advice::Squarely);
    views.push_back(view(quadOf({160, 120, 320, 240})));
    EXPECT_EQ(nextView(views, Kind::Poster), Advice::FromLeft);
    // From the left its left edge is nearer, so longer.
    views.push_back(view({{{160, 100}, {400, 140}, {400, 340}, {160, 380}}}));
    EXPECT_EQ(nextView(views, Kind::Poster), Advice::FromRight);
    views.push_back(view({{{160, 140}, {400, 100}, {400, 380}, {160, 340}}}));
    EXPECT_EQ(nextView(views, Kind::Poster), Advice::FromFarther);
    views.push_back(view(quadOf({260, 200, 120, 90})));
    EXPECT_EQ(nextView(views, Kind::Poster), Advice::Enough);
    EXPECT_EQ(nextView({views[0]}, Kind::Place), Advice::AnotherSpot);
    EXPECT_EQ(nextView(views, Kind::Place), Advice::Enough);
}

TEST(ViewCoach, FindsTheOutlineByItself) {
    const Quad quad{ImagePoint{200, 100}, {430, 150}, {430, 330}, {200, 380}};
    cv::Mat picture = test::room(2);
    test::hang(picture, test::poster(2), quad);
    LandmarkLibrary library;
    test::trainPoster(library, 2);
    const auto again = findOutline(picture, library, &library.templates[0]);
    ASSERT_TRUE(again);
    EXPECT_GT(test::sharedArea(*again, quad), 0.85);
    EXPECT_FALSE(findOutline(cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(128)), library, nullptr));
    EXPECT_FALSE(findOutline(cv::Mat(), library, nullptr));
    cv::Mat board(480, 640, CV_8UC3, cv::Scalar::all(90));
    cv::rectangle(board, cv::Rect(200, 150, 220, 160), cv::Scalar::all(230), cv::FILLED);
    const auto rectangle = findOutline(board, library, nullptr);
    ASSERT_TRUE(rectangle);
    EXPECT_GT(test::sharedArea(*rectangle, quadOf({200, 150, 220, 160})), 0.85);
}

} // namespace
} // namespace farol::recognition
