#include "core/base/log.h"
#include "core/recognition/text_reader.h"

#include <opencv2/imgproc.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drawn_pictures.h"

namespace farol::recognition {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A sign, 400 x 160, with a frame line, dark letters on light ground or the other way round.
cv::Mat sign(const std::vector<std::string>& lines, bool inverse = false) {
    int height = 40 + 110 * static_cast<int>(lines.size());
    cv::Mat plate(height, 520, CV_8UC3, cv::Scalar::all(inverse ? 40 : 235));
    cv::Scalar ink = cv::Scalar::all(inverse ? 240 : 20);
    cv::rectangle(plate, cv::Rect(4, 4, 512, height - 8), ink, 4);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        int base = 0;
        cv::Size size = cv::getTextSize(lines[i], cv::FONT_HERSHEY_DUPLEX, 2.2, 4, &base);
        cv::putText(plate, lines[i], {260 - size.width / 2, 105 + 110 * static_cast<int>(i)},
                    cv::FONT_HERSHEY_DUPLEX, 2.2, ink, 4, cv::LINE_AA);
    }
    return plate;
}

std::vector<std::string> texts(const DetectorResult& result) {
    std::vector<std::string> out;
    for (const Detection& d : result.detections) out.push_back(d.text);
    return out;
}

class Reading : public testing::Test {
protected:
    static void SetUpTestSuite() {
        auto made = TextReader::create();
        ASSERT_TRUE(made) << made.error().text();
        s_reader = std::make_unique<TextReader>(std::move(*made));
    }
    static void TearDownTestSuite() { s_reader.reset(); }
    static std::unique_ptr<TextReader> s_reader;
};
std::unique_ptr<TextReader> Reading::s_reader;

TEST_F(Reading, WhatIsKnownIsLeftOutAndSoManyLinesAreReadAtMost) {
    cv::Mat picture(480, 640, CV_8UC3, cv::Scalar::all(150));
    Quad upper = quadOf({140, 40, 300, 86}), lower = quadOf({140, 260, 300, 86});
    for (const auto& [quad, word] : {std::pair{upper, "SAIDA"}, {lower, "BAR"}})
        test::hang(picture, sign({word}), quad);
    TextPlaces places;
    EXPECT_THAT(texts(s_reader->readAt(picture, places)), testing::UnorderedElementsAre("SAIDA", "BAR"));
    places.known = {upper};
    EXPECT_THAT(texts(s_reader->readAt(picture, places)), ElementsAre("BAR"));
    places.known = {};
    places.maxLines = 1;
    EXPECT_EQ(s_reader->readAt(picture, places).detections.size(), 1U);
    places.maxLines = 0;
    EXPECT_THAT(s_reader->readAt(picture, places).detections, IsEmpty());
}

TEST_F(Reading, SignsOfSeveralSizesAreReadWhereTheyHang) {
    struct Case {
        const char* text;
        Quad quad;
    };
    const Case cases[] = {{"SAIDA", quadOf({100, 100, 440, 127})},
                          {"2.14", quadOf({200, 200, 260, 75})},
                          {"Sala 105", quadOf({240, 150, 180, 52})},
                          {"LAB 7", Quad{ImagePoint{200, 180}, {420, 200}, {420, 270}, {200, 245}}}};
    for (const Case& one : cases) {
        cv::Mat picture(480, 640, CV_8UC3, cv::Scalar::all(150));
        test::hang(picture, sign({one.text}), one.quad);
        auto given = s_reader->read(picture, {one.quad});
        EXPECT_THAT(texts(given), ElementsAre(one.text)) << "at a plate that was given";
        auto found = s_reader->read(picture);
        ASSERT_THAT(texts(found), ElementsAre(one.text)) << "found by itself";
        EXPECT_EQ(found.detections[0].kind, Kind::Text);
        EXPECT_GE(found.detections[0].score, 0.7);
        EXPECT_EQ(found.detections[0].image, (ImageSize{640, 480}));
        ImageBox ink = boundingBox(found.detections[0].quad), plate = boundingBox(one.quad);
        EXPECT_TRUE(ink.x > plate.x && ink.x + ink.width < plate.x + plate.width && ink.y > plate.y &&
                    ink.y + ink.height < plate.y + plate.height)
            << "the letters stand on the plate";
        EXPECT_GT(ink.height, plate.height * 0.2);
    }
}

TEST_F(Reading, LightLettersOnDarkGroundAreReadToo) {
    cv::Mat picture(480, 640, CV_8UC3, cv::Scalar::all(150));
    Quad quad = quadOf({150, 150, 340, 98});
    test::hang(picture, sign({"BAR"}, true), quad);
    EXPECT_THAT(texts(s_reader->read(picture, {quad})), ElementsAre("BAR"));
}

TEST_F(Reading, EveryLineOfAPlateIsOneReading) {
    cv::Mat picture(480, 640, CV_8UC3, cv::Scalar::all(150));
    Quad quad = quadOf({120, 120, 400, 200});
    test::hang(picture, sign({"Sala 210", "Secretaria"}), quad);
    EXPECT_THAT(texts(s_reader->read(picture, {quad})), ElementsAre("Sala 210", "Secretaria"));
}

TEST_F(Reading, ABlurredSignIsNotGuessedAt) {
    for (double blur : {6.0, 10.0}) {
        cv::Mat picture(480, 640, CV_8UC3, cv::Scalar::all(150));
        Quad quad = quadOf({200, 200, 220, 64});
        test::hang(picture, sign({"2.14"}), quad);
        cv::GaussianBlur(picture, picture, cv::Size(), blur);
        auto result = s_reader->read(picture, {quad});
        EXPECT_THAT(texts(result), IsEmpty());
    }
    cv::Mat smeared(480, 640, CV_8UC3, cv::Scalar::all(150));
    test::hang(smeared, sign({"SAIDA"}), quadOf({200, 200, 220, 64}));
    cv::blur(smeared, smeared, cv::Size(45, 1));
    EXPECT_THAT(texts(s_reader->read(smeared)), IsEmpty());
}

TEST_F(Reading, WhereNothingIsWrittenNothingIsRead) {
    for (std::uint64_t seed = 1; seed < 6; ++seed)
        EXPECT_THAT(texts(s_reader->read(test::room(seed))), IsEmpty()) << seed;
    for (const cv::Mat& picture :
         {cv::Mat(), cv::Mat(1, 1, CV_8UC3, cv::Scalar::all(5)), cv::Mat(9, 9, CV_8U, cv::Scalar(5)),
          cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(128))}) {
        EXPECT_THAT(texts(s_reader->read(picture)), IsEmpty());
        EXPECT_THAT(
            texts(s_reader->read(picture, {quadOf({0, 0, 5, 5}), quadOf({-50, -50, 900, 900}), Quad{}})),
            IsEmpty());
    }
}

/// A wall of coloured grain that swallows the outline of what hangs on it.
cv::Mat grainyWall(std::uint64_t seed) {
    cv::Mat wall(480, 640, CV_8UC3);
    cv::RNG noise(seed);
    noise.fill(wall, cv::RNG::NORMAL, cv::Scalar::all(128), cv::Scalar::all(90));
    cv::GaussianBlur(wall, wall, cv::Size(), 1.5);
    return wall;
}

TEST_F(Reading, WhatStandsBesideAPlateIsNoPartOfItsLine) {
    for (std::uint64_t seed = 1; seed < 4; ++seed) {
        cv::Mat picture = grainyWall(seed);
        cv::Mat plate(130, 300, CV_8UC3, cv::Scalar::all(235));
        cv::putText(plate, "12.64", {30, 100}, cv::FONT_HERSHEY_DUPLEX, 2.6, cv::Scalar::all(20), 5,
                    cv::LINE_AA);
        test::hang(picture, plate, quadOf({220, 180, 160, 70}));
        EXPECT_THAT(texts(s_reader->read(picture)), ElementsAre("12.64")) << seed;
    }
}

TEST_F(Reading, ColumnsOfATableAreNotOneLine) {
    cv::Mat picture(480, 640, CV_8UC3, cv::Scalar::all(120));
    cv::rectangle(picture, cv::Rect(60, 180, 520, 90), cv::Scalar::all(230), cv::FILLED);
    for (const auto& [text, x] : {std::pair{"LIFT", 90}, {"FLOOR", 400}})
        cv::putText(picture, text, {x, 240}, cv::FONT_HERSHEY_DUPLEX, 1.4, cv::Scalar::all(20), 3,
                    cv::LINE_AA);
    EXPECT_THAT(texts(s_reader->read(picture, {quadOf({60, 180, 520, 90})})),
                testing::UnorderedElementsAre("LIFT", "FLOOR"));
}

TEST(TextReader, ABoxOnTheWallIsNoFloorNumber) {
    TextReaderOptions options;
    options.words = {"0", "1", "2", "3", "4"};
    auto reader = TextReader::create(options);
    ASSERT_TRUE(reader);
    cv::Mat picture(480, 640, CV_8UC3, cv::Scalar::all(190));
    cv::rectangle(picture, cv::Rect(200, 200, 45, 63), cv::Scalar::all(90), cv::FILLED);
    cv::rectangle(picture, cv::Rect(222, 220, 12, 14), cv::Scalar::all(190), cv::FILLED);
    EXPECT_THAT(texts(reader->read(picture)), IsEmpty());
}

TEST_F(Reading, ANumberThatAPostMayHidePartOfIsNotTold) {
    cv::Mat picture(480, 640, CV_8UC3, cv::Scalar::all(200));
    cv::putText(picture, "13.03", {150, 260}, cv::FONT_HERSHEY_DUPLEX, 2.4, cv::Scalar::all(30), 5,
                cv::LINE_AA);
    cv::rectangle(picture, cv::Rect(120, 0, 75, 480), cv::Scalar::all(40), cv::FILLED);
    for (const std::string& text : texts(s_reader->read(picture))) EXPECT_EQ(text, "13.03");
}

TEST(TextReader, MissingLanguagesAreToldWithTheirPackages) {
    TextReaderOptions options;
    options.languages = "xxx+yyy";
    auto none = TextReader::create(options);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::Unavailable);
    EXPECT_THAT(none.error().text(), testing::HasSubstr("tesseract-ocr-xxx"));
    std::vector<std::string> warnings;
    setLogSink([&](LogLevel, const std::string& text) { warnings.push_back(text); });
    options.languages = "eng+xxx";
    EXPECT_TRUE(TextReader::create(options));
    setLogSink({});
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_THAT(warnings[0], testing::HasSubstr("tesseract-ocr-xxx"));
    options.languages = "";
    EXPECT_EQ(TextReader::create(options).error().code, ErrorCode::InvalidArgument);
}

} // namespace
} // namespace farol::recognition
