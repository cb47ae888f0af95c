#include "core/base/file.h"
#include "core/building/geopackage.h"
#include "core/session/recorder.h"
#include "tests/session/walk_fixture.h"

#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace farol::session {
namespace {

using testing::HasSubstr;

/// Commands and warnings between the frames, as a session writes them.
std::vector<RecordEntry> eventfulWalk() {
    std::vector<RecordEntry> entries{
        Command(MessageCommand{"no trained landmarks"}), Command(StartCommand{0.0, RegionId("A")}),
        Command(DestinationCommand{building::Location{RegionId("C"), Point2{25.0 + 1.0 / 3.0, 2.0}}})};
    for (Percept& percept : test::walkThroughTheRooms()) {
        std::uint64_t frame = percept.frame;
        entries.emplace_back(std::move(percept));
        if (frame == 3)
            entries.emplace_back(
                Command(WarningCommand{guidance::CueReason::CameraLost, "the cable \"fell\" out"}));
        if (frame == 4) entries.emplace_back(Command(WarningCommand{guidance::CueReason::CameraBack, ""}));
        if (frame == 6) entries.emplace_back(Command(VerbosityCommand{guidance::Verbosity::ObjectsAndTexts}));
        if (frame == 5) entries.emplace_back(Command(HeardCommand{2}));
        if (frame == 7) entries.emplace_back(Command(LanguageCommand{"pt"}));
        if (frame == 8)
            entries.emplace_back(
                Command(MessageCommand{"9.jpg cannot be read as a picture; skipped (1 so far)"}));
        if (frame == 10)
            entries.emplace_back(
                Command(DestinationCommand{building::Location{RegionId("D"), std::nullopt}}));
        if (frame == 12) entries.emplace_back(Command(DestinationCommand{}));
        if (frame == 14) entries.emplace_back(Command(StartCommand{5.0, std::nullopt}));
    }
    return entries;
}

class RecorderTest : public testing::Test {
protected:
    std::vector<std::string> walkAndRecord(const NavigatorOptions& options = {}) {
        auto building = test::threeRooms();
        auto recorder = Recorder::create(folder, {1, "a test", "rooms.gpkg", "", options}, *building);
        EXPECT_TRUE(recorder) << recorder.error().text();
        auto navigator = Navigator::create(building, options);
        EXPECT_TRUE(navigator);
        test::Lines lines;
        for (const RecordEntry& entry : eventfulWalk()) {
            if (const auto* command = std::get_if<Command>(&entry)) {
                EXPECT_TRUE((*recorder)->write(*command));
                apply(*command, **navigator, lines.handlers());
            } else {
                const auto& percept = std::get<Percept>(entry);
                EXPECT_TRUE((*recorder)->write(percept, test::drawnFrame(percept.frame)));
                lines.step((*navigator)->advance(percept));
            }
        }
        return lines.text;
    }

    std::vector<std::string> replayed(const std::optional<NavigatorOptions>& options = {}) {
        auto recording = loadRecording(folder);
        EXPECT_TRUE(recording) << recording.error().text();
        auto map = building::loadBuilding((folder / "map.gpkg").string());
        EXPECT_TRUE(map) << map.error().text();
        test::Lines lines;
        auto done = replay(*recording, map->building, options, lines.handlers());
        EXPECT_TRUE(done) << done.error().text();
        return lines.text;
    }

    void writeWalk(const std::string& bytes) {
        std::ofstream(folder / "walk.jsonl", std::ios::binary) << bytes;
    }

    test::TemporaryFolder temporary;
    std::filesystem::path folder = temporary.path / "recording";
};

TEST_F(RecorderTest, AReplayGivesTheSameLinesTwice) {
    std::vector<std::string> walked = walkAndRecord();
    EXPECT_GT(walked.size(), 40U);
    EXPECT_EQ(replayed(), walked);
    EXPECT_EQ(replayed(), walked);
}

TEST_F(RecorderTest, TheOptionsOfTheWalkAreThoseOfItsReplay) {
    NavigatorOptions options;
    options.localiser = "voting-literal";
    options.planner = "greedy";
    options.history.capacity = 2;
    options.tracker.offRouteFixes = 3;
    options.guidance.reassureEverySeconds = 1.0 / 3.0;
    options.guidance.verbosity = guidance::Verbosity::Directions;
    options.guidance.language = "pt";
    options.routing.avoidStairs = true;
    options.heardIsReported = true;
    std::vector<std::string> walked = walkAndRecord(options);
    EXPECT_EQ(replayed(), walked);
    auto recording = loadRecording(folder);
    ASSERT_TRUE(recording);
    EXPECT_EQ(recording->header.options.guidance.reassureEverySeconds, 1.0 / 3.0);
    EXPECT_EQ(recording->header.options.history.capacity, 2U);
    EXPECT_EQ(recording->header.options.planner, "greedy");
    EXPECT_TRUE(recording->header.options.routing.avoidStairs);
    EXPECT_TRUE(recording->header.options.heardIsReported);
    EXPECT_NE(replayed(NavigatorOptions{}), walked) << "other settings vote anew";
}

TEST_F(RecorderTest, WhatWasHeardIsInTheRecording) {
    walkAndRecord();
    auto recording = loadRecording(folder);
    ASSERT_TRUE(recording);
    int heard = 0;
    for (const RecordEntry& entry : recording->entries)
        if (const auto* command = std::get_if<Command>(&entry))
            if (const auto* cue = std::get_if<HeardCommand>(command)) heard += cue->cue == 2 ? 1 : 0;
    EXPECT_EQ(heard, 1);
}

TEST_F(RecorderTest, PicturesLieBesideTheWalk) {
    walkAndRecord();
    EXPECT_TRUE(std::filesystem::exists(folder / "frames" / "000013.jpg"));
    auto recording = loadRecording(folder);
    ASSERT_TRUE(recording);
    EXPECT_TRUE(recording->warnings.empty());
    std::filesystem::remove(folder / "frames" / "000013.jpg");
    recording = loadRecording(folder);
    ASSERT_TRUE(recording);
    ASSERT_EQ(recording->warnings.size(), 1U);
    EXPECT_THAT(recording->warnings[0], HasSubstr("frames/000013.jpg"));
}

TEST_F(RecorderTest, ATornLastLineIsLeftOutWithAWarning) {
    std::vector<std::string> walked = walkAndRecord();
    std::string walk = *readFile(folder / "walk.jsonl");
    std::size_t lastLine = walk.rfind('\n', walk.size() - 2) + 1;
    writeWalk(walk.substr(0, lastLine + 20));
    auto recording = loadRecording(folder);
    ASSERT_TRUE(recording);
    ASSERT_EQ(recording->warnings.size(), 1U);
    EXPECT_THAT(recording->warnings[0], HasSubstr("not written to its end"));
    std::vector<std::string> lines = replayed();
    ASSERT_LT(lines.size(), walked.size());
    EXPECT_TRUE(std::equal(lines.begin(), lines.end(), walked.begin())) << "all before it is as it was";
}

TEST_F(RecorderTest, EveryPrefixOfARecordingLoads) {
    walkAndRecord();
    std::string header = *readFile(folder / "recording.json");
    std::string walk = *readFile(folder / "walk.jsonl");
    for (std::size_t length = 0; length < walk.size(); length += 13) {
        auto recording = parseRecording(header, walk.substr(0, length));
        EXPECT_TRUE(recording) << length << ": " << recording.error().text();
    }
}

TEST_F(RecorderTest, DamageInTheMiddleIsToldWithItsLine) {
    walkAndRecord();
    std::string walk = *readFile(folder / "walk.jsonl");
    std::size_t second = walk.find('\n') + 1;
    writeWalk(walk.substr(0, second) + "{\"percept\":{}}\n" + walk.substr(second));
    auto recording = loadRecording(folder);
    ASSERT_FALSE(recording);
    EXPECT_EQ(recording.error().code, ErrorCode::Corrupt);
    EXPECT_THAT(recording.error().text(), HasSubstr("line 2"));
    writeWalk("rubbish\n");
    EXPECT_EQ(loadRecording(folder).error().code, ErrorCode::Corrupt);
    writeWalk("");
    EXPECT_TRUE(loadRecording(folder)) << "a walk that ended before its first frame";
}

TEST_F(RecorderTest, ForeignAndLaterRecordingsAreRefused) {
    EXPECT_EQ(loadRecording(temporary.path / "nowhere").error().code, ErrorCode::NotFound);
    EXPECT_EQ(loadRecording(temporary.path).error().code, ErrorCode::NotFound);
    walkAndRecord();
    std::ofstream(folder / "recording.json") << R"({"farol_recording":99})";
    EXPECT_EQ(loadRecording(folder).error().code, ErrorCode::UnsupportedFormat);
    std::ofstream(folder / "recording.json") << R"({"something":"else"})";
    EXPECT_EQ(loadRecording(folder).error().code, ErrorCode::UnsupportedFormat);
    std::ofstream(folder / "recording.json") << "{";
    EXPECT_EQ(loadRecording(folder).error().code, ErrorCode::Corrupt);
    std::ofstream(folder / "recording.json")
        << R"({"farol_recording":1,"options":{"guidance":{"verbosity":"loud"}}})";
    EXPECT_EQ(loadRecording(folder).error().code, ErrorCode::Corrupt);
}

TEST_F(RecorderTest, AFolderThatHoldsSomethingIsNeverWrittenInto) {
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "thesis.txt") << "years of work";
    auto recorder = Recorder::create(folder, {}, *test::threeRooms());
    ASSERT_FALSE(recorder);
    EXPECT_EQ(recorder.error().code, ErrorCode::Conflict);
    EXPECT_FALSE(std::filesystem::exists(folder / "recording.json"));
    EXPECT_FALSE(Recorder::create(folder / "thesis.txt", {}, *test::threeRooms()));
    EXPECT_FALSE(Recorder::create("/dev/null/nowhere", {}, *test::threeRooms()));
    std::filesystem::create_directories(temporary.path / "empty");
    EXPECT_TRUE(Recorder::create(temporary.path / "empty", {}, *test::threeRooms()));
}

TEST_F(RecorderTest, AFullDiskIsToldOnceAndTheRestReplays) {
    auto building = test::threeRooms();
    auto recorder = Recorder::create(folder, {}, *building);
    ASSERT_TRUE(recorder);
    std::size_t failures = 0;
    {
        test::SmallFilesOnly full(3000);
        for (const Percept& percept : test::walkThroughTheRooms())
            if (!(*recorder)->write(percept, cv::Mat())) ++failures;
    }
    EXPECT_EQ(failures, 1U);
    EXPECT_TRUE((*recorder)->failed());
    auto recording = loadRecording(folder);
    ASSERT_TRUE(recording) << recording.error().text();
    EXPECT_FALSE(recording->entries.empty());
    EXPECT_LT(recording->entries.size(), test::walkThroughTheRooms().size());
    EXPECT_FALSE(replayed().empty());
}

TEST_F(RecorderTest, ADiskTooFullForPicturesLeavesNoHalfOnes) {
    auto recorder = Recorder::create(folder, {}, *test::threeRooms());
    ASSERT_TRUE(recorder);
    {
        test::SmallFilesOnly full(200);
        auto written = (*recorder)->write(test::walkThroughTheRooms().front(), test::drawnFrame(0));
        ASSERT_FALSE(written);
        EXPECT_THAT(written.error().text(), HasSubstr("frames"));
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder / "frames"));
    EXPECT_TRUE(loadRecording(folder));
}

} // namespace
} // namespace farol::session
