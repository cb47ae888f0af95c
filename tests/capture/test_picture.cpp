#include "core/capture/picture.h"
#include "tests/support/temporary_folder.h"

#include <opencv2/imgcodecs.hpp>

#include <gtest/gtest.h>

namespace farol::capture {

TEST(Picture, EveryKindOfPictureBecomesEightBitColour) {
    test::TemporaryFolder folder;
    cv::imwrite((folder / "grey.png").string(), cv::Mat(4, 6, CV_8UC1, cv::Scalar(80)));
    cv::imwrite((folder / "deep.png").string(), cv::Mat(4, 6, CV_16UC1, cv::Scalar(65535)));
    cv::imwrite((folder / "deep.tif").string(), cv::Mat(4, 6, CV_16UC3, cv::Scalar(0, 0, 65535)));
    cv::imwrite((folder / "clear.png").string(), cv::Mat(4, 6, CV_8UC4, cv::Scalar(1, 2, 3, 128)));
    cv::imwrite((folder / "dot.png").string(), cv::Mat(1, 1, CV_8UC3, cv::Scalar(1, 2, 3)));
    for (const char* name : {"grey.png", "deep.png", "deep.tif", "clear.png", "dot.png"}) {
        auto image = readPicture(folder / name);
        ASSERT_TRUE(image) << name;
        EXPECT_EQ(image->type(), CV_8UC3) << name;
    }
    EXPECT_EQ(readPicture(folder / "deep.png")->at<cv::Vec3b>(0, 0), cv::Vec3b(255, 255, 255));
}

TEST(Picture, BytesThatAreNoPictureAreAnErrorWithTheirName) {
    test::TemporaryFolder folder;
    folder.write("lie.jpg", "this is text");
    folder.write("empty.png", "");
    for (const char* name : {"lie.jpg", "empty.png"}) {
        auto image = readPicture(folder / name);
        ASSERT_FALSE(image);
        EXPECT_EQ(image.error().code, ErrorCode::Corrupt);
        EXPECT_NE(image.error().text().find(name), std::string::npos);
    }
    EXPECT_EQ(readPicture(folder / "none.jpg").error().code, ErrorCode::NotFound);
}

TEST(Picture, NamesOfPicturesInAnyCase) {
    EXPECT_TRUE(hasPictureName("a/B.JPG"));
    EXPECT_TRUE(hasPictureName("x.jpeg"));
    EXPECT_TRUE(hasPictureName("x.webp"));
    EXPECT_FALSE(hasPictureName("x.txt"));
    EXPECT_FALSE(hasPictureName("jpg"));
    EXPECT_FALSE(hasPictureName("x.jpg.bak"));
}

} // namespace farol::capture
