// What the detectors are worth on real pictures (the sets beside the checkout, see tests/CMakeLists.txt).

#include "core/base/file.h"
#include "core/capture/frame_source.h"
#include "core/capture/picture.h"
#include "core/recognition/door_detector.h"
#include "core/recognition/landmark_recogniser.h"
#include "core/recognition/stairs_detector.h"
#include "core/recognition/text_reader.h"
#include "core/recognition/training.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace farol::recognition {
namespace {

namespace fs = std::filesystem;

/// The folder of a set; empty where it is absent.
fs::path set(const std::string& name) {
    const char* data = std::getenv("FAROL_DATA");
    fs::path folder = fs::path(data != nullptr ? data : "") / "images" / name;
    return data != nullptr && fs::exists(folder) ? folder : fs::path();
}

#define FAROL_NEEDS_SET(folder, name)                                                                        \
    fs::path folder = set(name);                                                                             \
    if (folder.empty()) GTEST_SKIP() << "images/" << name << " is not in FAROL_DATA"

cv::Mat picture(const fs::path& path) {
    auto image = capture::readPicture(path);
    EXPECT_TRUE(image) << image.error().text();
    return image ? *image : cv::Mat();
}

std::vector<std::vector<std::string>> table(const fs::path& path) {
    std::vector<std::vector<std::string>> rows;
    std::ifstream in(path);
    std::string line;
    std::getline(in, line);
    while (std::getline(in, line)) {
        std::vector<std::string> row;
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
        rows.push_back(row);
    }
    return rows;
}

/// The legs of the corridor by frame number: see the set's description.
char leg(int frame) {
    if (frame <= 6 || (frame >= 40 && frame <= 46) || frame >= 81) return 'A';
    if (frame <= 19 || (frame >= 47 && frame <= 59)) return 'B';
    return frame <= 25 || (frame >= 60 && frame <= 65) ? 'C' : 'D';
}

std::shared_ptr<LandmarkLibrary> firstLap(const fs::path& walk) {
    auto library = std::make_shared<LandmarkLibrary>();
    for (int frame = 1; frame <= 40; ++frame) {
        TrainingRequest request;
        request.id = TemplateId(std::to_string(frame));
        request.kind = Kind::Place;
        auto bytes = readFile(walk / (std::to_string(frame) + ".jpg"));
        EXPECT_TRUE(bytes);
        auto trained = addView(*library, request, *bytes, {});
        EXPECT_EQ(trained.ok(), frame != 19) << "only the blank wall cannot be learnt, not " << frame;
    }
    return library;
}

TEST(RealPictures, TheSecondLapKnowsThePlacesOfTheFirst) {
    FAROL_NEEDS_SET(walk, "corridor_walk");
    LandmarkRecogniser recogniser(firstLap(walk));
    int named = 0;
    for (int frame = 41; frame <= 84; ++frame) {
        auto found = recogniser.recognise(picture(walk / (std::to_string(frame) + ".jpg"))).detections;
        ASSERT_LE(found.size(), 1U);
        if (found.empty()) continue;
        EXPECT_NE(frame, 46) << "a blank wall is nowhere";
        EXPECT_EQ(leg(std::stoi(found[0].templateId.value)), leg(frame))
            << "frame " << frame << " is not at " << found[0].templateId.value;
        if (frame <= 80) ++named;
    }
    EXPECT_GE(named, 32) << "of 40 frames";
}

TEST(RealPictures, OtherBuildingsAreNotTheCorridor) {
    FAROL_NEEDS_SET(walk, "corridor_walk");
    FAROL_NEEDS_SET(tower, "tower");
    FAROL_NEEDS_SET(doors, "doors");
    LandmarkRecogniser recogniser(firstLap(walk));
    int looked = 0, named = 0;
    auto look = [&](const fs::path& path) {
        ++looked;
        named += recogniser.recognise(picture(path)).detections.empty() ? 0 : 1;
    };
    int row = 0;
    for (const auto& cells : table(tower / "frames.csv"))
        if (cells.at(2) == "hallway" && row++ % 12 == 0) look(tower / cells.at(0));
    for (const auto& cells : table(doors / "index.csv"))
        if (cells.at(1) == "no_door" && row++ % 2 == 0) look(doors / "images" / cells.at(0));
    EXPECT_GE(looked, 50);
    EXPECT_EQ(named, 0) << "of " << looked;
}

TEST(RealPictures, FrontalDoorsOfTheCorridorAreFoundAndNothingElse) {
    FAROL_NEEDS_SET(walk, "corridor_walk");
    int yes = 0, found = 0, none = 0, wrong = 0;
    for (const auto& cells : table(walk / "helper_labels.csv")) {
        bool any = !detectDoors(picture(walk / cells.at(0))).detections.empty();
        if (cells.at(1) == "yes") {
            ++yes;
            found += any ? 1 : 0;
        } else if (cells.at(1) == "no") {
            ++none;
            wrong += any ? 1 : 0;
        }
    }
    EXPECT_EQ(yes, 12);
    EXPECT_GE(found, 11);
    EXPECT_LE(wrong, 2) << "of " << none;
}

/// YOLO form; class 0 is a door.
std::vector<ImageBox> doorBoxes(const fs::path& labels, cv::Size size) {
    std::vector<ImageBox> boxes;
    std::ifstream in(labels);
    int kind = 0;
    double x = 0.0, y = 0.0, w = 0.0, h = 0.0;
    while (in >> kind >> x >> y >> w >> h)
        if (kind == 0)
            boxes.push_back(
                {(x - w / 2) * size.width, (y - h / 2) * size.height, w * size.width, h * size.height});
    return boxes;
}

TEST(RealPictures, OfficeDoorsAreFoundWhereTheyAreAndCupboardsAreNot) {
    FAROL_NEEDS_SET(doors, "doors");
    int office = 0, found = 0, wrong = 0, none = 0, mistaken = 0;
    for (const auto& cells : table(doors / "index.csv")) {
        if (cells.at(1) == "indoor_home") continue;
        cv::Mat image = picture(doors / "images" / cells.at(0));
        auto detections = detectDoors(image).detections;
        if (cells.at(1) == "no_door") {
            ++none;
            mistaken += static_cast<int>(detections.size());
            continue;
        }
        fs::path labels = doors / "labels" / fs::path(cells.at(0)).replace_extension(".txt");
        for (const ImageBox& box : doorBoxes(labels, image.size())) {
            ++office;
            bool hit = std::any_of(detections.begin(), detections.end(), [&](const Detection& d) {
                return overlap(boundingBox(d.quad), box) >= 0.5;
            });
            found += hit ? 1 : 0;
            wrong += static_cast<int>(detections.size()) - (hit ? 1 : 0);
        }
    }
    EXPECT_GE(found, office * 85 / 100) << "of " << office;
    EXPECT_LE(wrong, 1);
    EXPECT_LE(mistaken, none * 3 / 100) << "in " << none << " (refrigerators and cupboards)";
}

TEST(RealPictures, StairsAreFoundAndHallwaysAreNone) {
    FAROL_NEEDS_SET(stairs, "stairs");
    FAROL_NEEDS_SET(doors, "doors");
    FAROL_NEEDS_SET(tower, "tower");
    int flights = 0, found = 0, none = 0, wrong = 0;
    for (const auto& cells : table(stairs / "stairs.csv")) {
        ++flights;
        found += detectStairs(picture(stairs / "img" / cells.at(0))).detections.empty() ? 0 : 1;
    }
    auto look = [&](const fs::path& path) {
        ++none;
        wrong += detectStairs(picture(path)).detections.empty() ? 0 : 1;
    };
    int row = 0;
    for (const auto& cells : table(doors / "index.csv"))
        if (cells.at(1) == "no_door") look(doors / "images" / cells.at(0));
    for (const auto& cells : table(tower / "frames.csv"))
        if (cells.at(2) == "hallway" && row++ % 5 == 0) look(tower / cells.at(0));
    EXPECT_GE(found, flights * 80 / 100) << "of " << flights;
    EXPECT_GE(none, 150);
    EXPECT_LE(wrong, none * 2 / 100) << "of " << none;
}

TEST(RealPictures, BlurredTextIsNotGuessedAt) {
    FAROL_NEEDS_SET(scene, "scene_text");
    auto reader = TextReader::create();
    ASSERT_TRUE(reader) << reader.error().text();
    auto source = capture::openSource((scene / "icdar2015_motion_blurred").string());
    ASSERT_TRUE(source);
    int looked = 0, read = 0;
    while (auto frame = (*source)->next()) {
        if (looked++ % 2 == 0) read += reader->read(frame->image).detections.empty() ? 0 : 1;
    }
    EXPECT_GE(looked, 40);
    EXPECT_EQ(read, 0);
}

} // namespace
} // namespace farol::recognition
