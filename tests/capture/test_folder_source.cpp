#include "core/capture/frame_source.h"
#include "tests/support/temporary_folder.h"

#include <opencv2/imgcodecs.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace farol::capture {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

void writePicture(const test::TemporaryFolder& folder, const std::string& name) {
    cv::imwrite((folder / name).string(), cv::Mat(8, 12, CV_8UC3, cv::Scalar(10, 20, 30)));
}

struct Walk {
    std::vector<std::string> names;
    std::vector<double> times;
    std::vector<std::uint64_t> indices;
    std::vector<std::string> events;
};

Walk walkThrough(FrameSource& source) {
    Walk walk;
    source.onEvent([&](const SourceEvent& event) { walk.events.push_back(event.message); });
    while (auto frame = source.next()) {
        walk.names.push_back(frame->name);
        walk.times.push_back(frame->capturedAt);
        walk.indices.push_back(frame->index);
    }
    return walk;
}

TEST(FolderSource, PicturesComeInNaturalOrderWithTheTimesAskedFor) {
    test::TemporaryFolder folder;
    for (const char* name : {"10.jpg", "2.jpg", "1.png", "note.txt"}) {
        if (std::string(name) == "note.txt")
            folder.write(name, "not a picture");
        else
            writePicture(folder, name);
    }
    std::filesystem::create_directory(folder / "folder.jpg");
    SourceOptions options;
    options.framesPerSecond = 4.0;
    auto source = openSource(folder.string(), options);
    ASSERT_TRUE(source) << source.error().text();
    EXPECT_FALSE((*source)->live());
    EXPECT_EQ((*source)->frameCount(), 3U);
    EXPECT_DOUBLE_EQ((*source)->framePeriod(), 0.25);
    EXPECT_THAT((*source)->description(), HasSubstr("(3 pictures)"));
    Walk walk = walkThrough(**source);
    EXPECT_THAT(walk.names, ElementsAre("1.png", "2.jpg", "10.jpg"));
    EXPECT_THAT(walk.times, ElementsAre(0.0, 0.25, 0.5));
    EXPECT_THAT(walk.indices, ElementsAre(0U, 1U, 2U));
    EXPECT_TRUE(walk.events.empty());
}

TEST(FolderSource, APictureThatCannotBeReadIsSkippedCountedAndTold) {
    test::TemporaryFolder folder;
    writePicture(folder, "1.jpg");
    folder.write("2.jpg", "broken");
    folder.write("3.jpg", "");
    writePicture(folder, "4.jpg");
    auto source = openSource(folder.string());
    ASSERT_TRUE(source);
    Walk walk = walkThrough(**source);
    EXPECT_THAT(walk.names, ElementsAre("1.jpg", "4.jpg"));
    EXPECT_THAT(walk.times, ElementsAre(0.0, 3.0)) << "the gap stays a gap";
    EXPECT_THAT(walk.indices, ElementsAre(0U, 1U));
    EXPECT_THAT(walk.events, ElementsAre(HasSubstr("2.jpg"), HasSubstr("3.jpg")));
    EXPECT_THAT(walk.events.back(), HasSubstr("2 so far"));
    EXPECT_EQ((*source)->skippedFrames(), 2U);
}

TEST(FolderSource, OnePictureIsASourceToo) {
    test::TemporaryFolder folder;
    writePicture(folder, "door.jpg");
    auto source = openSource((folder / "door.jpg").string());
    ASSERT_TRUE(source);
    EXPECT_THAT(walkThrough(**source).names, ElementsAre("door.jpg"));
    EXPECT_EQ((*source)->description(), "door.jpg (1 picture)");
}

TEST(FolderSource, WhatCannotBeOpenedIsNamed) {
    test::TemporaryFolder folder;
    folder.write("readme.txt", "no pictures here");
    auto empty = openSource(folder.string());
    ASSERT_FALSE(empty);
    EXPECT_THAT(empty.error().text(), HasSubstr(folder.string()));
    auto missing = openSource((folder / "nowhere").string());
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ErrorCode::NotFound);
    EXPECT_THAT(missing.error().text(), HasSubstr("nowhere"));
    EXPECT_EQ(openSource("").error().code, ErrorCode::InvalidArgument);
    EXPECT_EQ(openSource("camera:").error().code, ErrorCode::InvalidArgument);
    EXPECT_EQ(openSource("camera:front").error().code, ErrorCode::InvalidArgument);
    EXPECT_EQ(openSource("camera:987").error().code, ErrorCode::Unavailable);
}

TEST(FolderSource, OptionsOutOfRangeAreRefused) {
    test::TemporaryFolder folder;
    writePicture(folder, "1.jpg");
    SourceOptions options;
    options.framesPerSecond = -1.0;
    EXPECT_EQ(openSource(folder.string(), options).error().code, ErrorCode::InvalidArgument);
    options = {};
    options.readTimeoutMs = 0;
    EXPECT_EQ(openSource(folder.string(), options).error().code, ErrorCode::InvalidArgument);
}

TEST(FolderSource, StopsWhenAsked) {
    test::TemporaryFolder folder;
    writePicture(folder, "1.jpg");
    writePicture(folder, "2.jpg");
    auto source = openSource(folder.string());
    ASSERT_TRUE((*source)->next());
    (*source)->requestStop();
    EXPECT_FALSE((*source)->next());
}

} // namespace
} // namespace farol::capture
