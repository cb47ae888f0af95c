#include "core/base/file.h"
#include "core/base/ogr.h"
#include "core/recognition/feature_blobs.h"
#include "core/recognition/landmark_library.h"
#include "tests/support/temporary_folder.h"

#include <ogrsf_frmts.h>

#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drawn_pictures.h"

namespace farol::recognition {
namespace {

using testing::HasSubstr;

LandmarkLibrary twoPosters() {
    LandmarkLibrary library;
    test::trainPoster(library, 1);
    test::trainPoster(library, 2, Kind::Sign);
    library.templates[0].name = "Cartaz do átrio";
    library.templates[0].widthM = 0.8;
    return library;
}

void expectSame(const LandmarkLibrary& a, const LandmarkLibrary& b) {
    EXPECT_EQ(a.extractor, b.extractor);
    ASSERT_EQ(a.templates.size(), b.templates.size());
    for (std::size_t i = 0; i < a.templates.size(); ++i) {
        const Template& x = a.templates[i];
        const Template& y = b.templates[i];
        EXPECT_EQ(x.id, y.id);
        EXPECT_EQ(x.kind, y.kind);
        EXPECT_EQ(x.name, y.name);
        EXPECT_EQ(x.widthM, y.widthM);
        EXPECT_EQ(x.heightM, y.heightM);
        ASSERT_EQ(x.views.size(), y.views.size());
        for (std::size_t v = 0; v < x.views.size(); ++v) {
            EXPECT_EQ(x.views[v].jpeg, y.views[v].jpeg);
            EXPECT_EQ(x.views[v].outline, y.views[v].outline);
            EXPECT_EQ(x.views[v].size, y.views[v].size);
            auto one = encodeFeatures(x.views[v].features);
            auto two = encodeFeatures(y.views[v].features);
            EXPECT_EQ(one.keypoints, two.keypoints);
            EXPECT_EQ(one.descriptors, two.descriptors);
        }
    }
}

TEST(LibraryStore, ALibraryReadsBackAsItWasSaved) {
    farol::test::TemporaryFolder folder;
    std::string path = (folder / "library.gpkg").string();
    LandmarkLibrary library = twoPosters();
    ASSERT_TRUE(saveLibrary(library, path));
    auto again = loadLibrary(path);
    ASSERT_TRUE(again) << again.error().text();
    expectSame(library, *again);
    library.templates.pop_back();
    ASSERT_TRUE(saveLibrary(library, path));
    again = loadLibrary(path);
    ASSERT_TRUE(again);
    expectSame(library, *again);
}

TEST(LibraryStore, AnEmptyLibraryIsALibrary) {
    farol::test::TemporaryFolder folder;
    std::string path = (folder / "library.gpkg").string();
    ASSERT_TRUE(saveLibrary({}, path));
    auto again = loadLibrary(path);
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_TRUE(again->templates.empty());
}

TEST(LibraryStore, OtherLayersOfAMapStayAsTheyAre) {
    farol::test::TemporaryFolder folder;
    std::string path = (folder / "map.gpkg").string();
    {
        auto map = createGeoPackage(path);
        ASSERT_TRUE(map);
        OGRLayer* regions = (*map)->CreateLayer("regions", nullptr, wkbPoint);
        OGRFieldDefn name("name", OFTString);
        ASSERT_EQ(regions->CreateField(&name), OGRERR_NONE);
        OGRFeature feature(regions->GetLayerDefn());
        feature.SetField("name", "Bar");
        OGRPoint point(3.0, 4.0);
        feature.SetGeometry(&point);
        ASSERT_EQ(regions->CreateFeature(&feature), OGRERR_NONE);
        OGRLayer* properties = (*map)->CreateLayer("farol", nullptr, wkbNone);
        OGRFieldDefn key("key", OFTString), value("value", OFTString);
        ASSERT_EQ(properties->CreateField(&key), OGRERR_NONE);
        ASSERT_EQ(properties->CreateField(&value), OGRERR_NONE);
        OGRFeature title(properties->GetLayerDefn());
        title.SetField("key", "title");
        title.SetField("value", "Campus");
        ASSERT_EQ(properties->CreateFeature(&title), OGRERR_NONE);
        ASSERT_TRUE(closeVector(std::move(*map), path));
    }
    EXPECT_EQ(loadLibrary(path).error().code, ErrorCode::NotFound) << "a map without a library says so";
    ASSERT_TRUE(saveLibrary(twoPosters(), path));
    ASSERT_TRUE(saveLibrary(twoPosters(), path));
    expectSame(twoPosters(), *loadLibrary(path));
    auto map = openVector(path);
    ASSERT_TRUE(map);
    OGRLayer* regions = (*map)->GetLayerByName("regions");
    ASSERT_NE(regions, nullptr);
    ASSERT_EQ(regions->GetFeatureCount(), 1);
    std::unique_ptr<OGRFeature> bar(regions->GetNextFeature());
    EXPECT_STREQ(bar->GetFieldAsString("name"), "Bar");
    EXPECT_EQ((*map)->GetLayerByName("farol")->GetFeatureCount(), 2)
        << "the title, and the library's version once";
}

TEST(LibraryStore, AnotherExtractorIsRefusedWithBothNames) {
    farol::test::TemporaryFolder folder;
    std::string path = (folder / "library.gpkg").string();
    ASSERT_TRUE(saveLibrary(twoPosters(), path));
    ExtractorOptions other;
    other.workingLongSide = 320;
    auto refused = loadLibrary(path, other);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Conflict);
    EXPECT_THAT(refused.error().text(), HasSubstr(other.description()));
    EXPECT_THAT(refused.error().text(), HasSubstr(ExtractorOptions{}.description()));
}

TEST(LibraryStore, ALibraryOpensWithItsOwnExtractorWhereNoneIsWanted) {
    for (const std::string& name : extractorNames()) {
        farol::test::TemporaryFolder folder;
        std::string path = (folder / "library.gpkg").string();
        LandmarkLibrary library;
        library.extractor = *ExtractorOptions::named(name);
        test::trainPoster(library, 1);
        ASSERT_TRUE(saveLibrary(library, path)) << name;
        auto read = loadLibrary(path);
        ASSERT_TRUE(read) << name << ": " << read.error().text();
        EXPECT_EQ(read->extractor, library.extractor) << name;
        ASSERT_EQ(read->templates.size(), 1U);
        EXPECT_EQ(read->templates[0].views[0].features.descriptors.cols, descriptorBytes(name)) << name;
    }
}

/// Runs SQL on the file as a curator's tool might.
void sql(const std::string& path, const std::string& statement) {
    auto dataset = openVector(path, OpenMode::Update);
    ASSERT_TRUE(dataset);
    (*dataset)->ReleaseResultSet((*dataset)->ExecuteSQL(statement.c_str(), nullptr, nullptr));
    ASSERT_TRUE(closeVector(std::move(*dataset), path));
}

TEST(LibraryStore, AnUnknownExtractorIsRefusedAndItsPhotographsAreTrainedAgain) {
    farol::test::TemporaryFolder folder;
    std::string path = (folder / "library.gpkg").string();
    LandmarkLibrary before = twoPosters();
    ASSERT_TRUE(saveLibrary(before, path));
    for (const char* change : {"UPDATE views SET extractor = 'superpoint'",
                               "UPDATE views SET extractor_parameters = replace(extractor_parameters, "
                               "'version=2', 'version=1')"}) {
        sql(path, change);
        auto refused = loadLibrary(path);
        ASSERT_FALSE(refused) << change;
        EXPECT_EQ(refused.error().code, ErrorCode::Conflict) << change;
        EXPECT_THAT(refused.error().text(), HasSubstr("train it again from its photographs")) << change;
        auto photographs = loadPhotographs(path);
        ASSERT_TRUE(photographs) << change;
        auto again = retrain(*photographs, {});
        ASSERT_TRUE(again) << change;
        EXPECT_THAT(again->refused, testing::IsEmpty());
        ASSERT_TRUE(saveLibrary(again->library, path));
        auto read = loadLibrary(path);
        ASSERT_TRUE(read) << change;
        ASSERT_EQ(read->templates.size(), before.templates.size());
        for (std::size_t i = 0; i < before.templates.size(); ++i) {
            EXPECT_EQ(read->templates[i].id, before.templates[i].id);
            EXPECT_EQ(read->templates[i].views.size(), before.templates[i].views.size());
            EXPECT_EQ(read->templates[i].views[0].features.keypoints.size(),
                      before.templates[i].views[0].features.keypoints.size());
        }
    }
}

TEST(LibraryStore, DescriptorsOfAnotherWidthAreDamage) {
    farol::test::TemporaryFolder folder;
    std::string path = (folder / "library.gpkg").string();
    LandmarkLibrary library = twoPosters();
    library.templates[0].views[0].features.descriptors =
        library.templates[0].views[0].features.descriptors.colRange(0, 64).clone();
    ASSERT_TRUE(saveLibrary(library, path));
    auto refused = loadLibrary(path);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Corrupt);
}

TEST(LibraryStore, DamageIsNamedByTemplateAndView) {
    farol::test::TemporaryFolder folder;
    const std::pair<const char*, const char*> damages[] = {
        {"UPDATE views SET descriptors = X'00' WHERE template = 'poster-2'", "poster-2, view 0"},
        {"UPDATE views SET keypoints = NULL WHERE template = 'poster-2'", "poster-2, view 0"},
        {"UPDATE views SET jpeg = X'FFD8' WHERE template = 'poster-1'", "poster-1, view 0"},
        {"UPDATE views SET outline = '1,2,3' WHERE template = 'poster-1'", "poster-1, view 0"},
        {"UPDATE views SET outline = '0,0,1,0,1,1,0,1' WHERE template = 'poster-1'", "checksum"},
        {"UPDATE views SET extractor_parameters = 'version=' WHERE template = 'poster-1'",
         "poster-1, view 0"},
        {"UPDATE views SET template = 'ghost' WHERE template = 'poster-1'", "ghost"},
        {"UPDATE templates SET template = '' WHERE template = 'poster-1'", "layer templates"},
        {"UPDATE templates SET template = 'poster-2'", "twice"},
    };
    for (const auto& [statement, words] : damages) {
        std::string path = (folder / "library.gpkg").string();
        std::filesystem::remove(path);
        ASSERT_TRUE(saveLibrary(twoPosters(), path));
        sql(path, statement);
        auto loaded = loadLibrary(path);
        ASSERT_FALSE(loaded) << statement;
        EXPECT_EQ(loaded.error().code, ErrorCode::Corrupt) << statement;
        EXPECT_THAT(loaded.error().text(), HasSubstr(words)) << statement;
    }
}

TEST(LibraryStore, ALaterVersionIsRefusedAndAnUnknownKindIsKept) {
    farol::test::TemporaryFolder folder;
    std::string path = (folder / "library.gpkg").string();
    ASSERT_TRUE(saveLibrary(twoPosters(), path));
    sql(path, "UPDATE templates SET kind = 'hologram' WHERE template = 'poster-1'");
    auto library = loadLibrary(path);
    ASSERT_TRUE(library);
    EXPECT_EQ(library->templates[0].kind, Kind::Other);
    ASSERT_TRUE(saveLibrary(*library, path));
    EXPECT_EQ(loadLibrary(path)->templates[0].unknownKind, "hologram")
        << "a save must not lose what it does not know";
    sql(path, "UPDATE farol SET value = '2' WHERE key = 'library_schema'");
    auto later = loadLibrary(path);
    ASSERT_FALSE(later);
    EXPECT_EQ(later.error().code, ErrorCode::UnsupportedFormat);
}

TEST(LibraryStore, FilesThatAreNoLibraryAreRefusedAndLeftAlone) {
    farol::test::TemporaryFolder folder;
    folder.write("notes.gpkg", "shopping list");
    std::string path = (folder / "notes.gpkg").string();
    EXPECT_FALSE(loadLibrary(path));
    EXPECT_FALSE(saveLibrary(twoPosters(), path));
    EXPECT_EQ(*readFile(path), "shopping list");
    EXPECT_EQ(loadLibrary((folder / "none.gpkg").string()).error().code, ErrorCode::NotFound);
    EXPECT_FALSE(saveLibrary(twoPosters(), (folder / "no/such/folder/x.gpkg").string()));
}

TEST(LibraryStore, BytesChangedAnywhereInTheFileNeverCrash) {
    farol::test::TemporaryFolder folder;
    std::string path = (folder / "library.gpkg").string();
    LandmarkLibrary library = twoPosters();
    ASSERT_TRUE(saveLibrary(library, path));
    std::string whole = *readFile(path);
    int refused = 0;
    cv::RNG random(11);
    for (int trial = 0; trial < 60; ++trial) {
        std::string bytes = whole;
        for (int i = 0; i < 4; ++i) {
            auto at = static_cast<std::size_t>(random.uniform(0, static_cast<int>(bytes.size())));
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.uniform(0, 8)));
        }
        std::string damaged = (folder / "damaged.gpkg").string();
        folder.write("damaged.gpkg", bytes);
        auto loaded = loadLibrary(damaged);
        if (!loaded) {
            ++refused;
            continue;
        }
        for (const Template& entry : loaded->templates)
            for (const View& view : entry.views) {
                const Template* before = library.find(entry.id);
                ASSERT_NE(before, nullptr);
                EXPECT_EQ(view.jpeg, before->views[0].jpeg) << "what is accepted is what was saved";
            }
    }
    EXPECT_GT(refused, 20) << "most of the file is pictures and descriptors, which have a checksum";
}

TEST(FeatureBlobs, EveryByteChangedIsRefusedOrHarmless) {
    LandmarkLibrary library;
    test::trainPoster(library, 1);
    Features features = library.templates[0].views[0].features;
    features.keypoints.resize(3);
    features.descriptors = features.descriptors.rowRange(0, 3).clone();
    FeatureBlobs blobs = encodeFeatures(features);
    ASSERT_TRUE(decodeFeatures(blobs.keypoints, blobs.descriptors));
    for (std::size_t at = 0; at < blobs.keypoints.size(); ++at)
        for (int bit : {0, 6, 7}) {
            std::string bytes = blobs.keypoints;
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << bit));
            auto decoded = decodeFeatures(bytes, blobs.descriptors);
            EXPECT_TRUE(!decoded || decoded->keypoints.size() == 3U);
        }
    for (std::size_t length = 0; length < blobs.descriptors.size(); ++length)
        EXPECT_FALSE(decodeFeatures(blobs.keypoints, std::string_view(blobs.descriptors).substr(0, length)));
    for (std::size_t length = 0; length < blobs.keypoints.size(); ++length)
        EXPECT_FALSE(decodeFeatures(std::string_view(blobs.keypoints).substr(0, length), blobs.descriptors));
    EXPECT_FALSE(decodeFeatures(blobs.keypoints, blobs.descriptors + "x"));
    EXPECT_EQ(checksum("123456789"), 0xCBF43926U);
}

} // namespace
} // namespace farol::recognition
