// Imports what it is told to and says whether the answer can be trusted: see mutate_maps.py.
//   import_check --seeds MAP FOLDER   the map as Shapefiles, GeoJSON and GeoPackages that are no building
//   files import_check OUT.gpkg             reads paths from standard input, answers each with a line of JSON
// An answer is an error with words, or a building that can be saved, read again and saved again to the same
// bytes.
#include "core/base/ogr.h"
#include "core/building/geopackage.h"
#include "core/building/import/importer.h"

#include <cpl_conv.h>
#include <gdal_priv.h>
#include <gdal_utils.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sys/resource.h>

namespace {

using namespace farol;
using namespace farol::building;
using Json = nlohmann::json;

std::string bytesOf(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Empty when the building holds what it promises.
std::string faultOf(const ImportedBuilding& imported, const std::string& out) {
    if (imported.building->regions().empty()) return "a building without regions";
    for (const Finding& finding : imported.findings)
        if (finding.rule.empty() || finding.message.empty()) return "a finding without words";
    std::filesystem::remove(out);
    if (auto saved = saveBuilding(*imported.building, out); !saved)
        return "not saved: " + saved.error().text();
    std::string first = bytesOf(out);
    auto loaded = loadBuilding(out);
    if (!loaded) return "not read again: " + loaded.error().text();
    const BuildingData &a = imported.building->data(), &b = loaded->building->data();
    if (a.regions.size() != b.regions.size() || a.accesses.size() != b.accesses.size() ||
        a.landmarks.size() != b.landmarks.size() || a.levels.size() != b.levels.size())
        return "something was lost in saving";
    (void)checkBuilding(*loaded->building);
    std::filesystem::remove(out);
    if (auto again = saveBuilding(*loaded->building, out); !again)
        return "not saved again: " + again.error().text();
    return bytesOf(out) == first ? "" : "saved again, it differs";
}

Json answerFor(const std::string& source, const std::string& out) {
    Json answer;
    auto imported = importBuilding(source);
    answer["ok"] = imported.ok();
    if (imported.ok()) {
        answer["regions"] = imported->building->regions().size();
        answer["fault"] = faultOf(*imported, out);
    } else {
        answer["message"] = imported.error().text();
        answer["fault"] = imported.error().message.empty() ? "an error without words" : "";
    }
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    answer["peak_mb"] = used.ru_maxrss / 1024;
    return answer;
}

int writeSeeds(const std::string& map, const std::string& folder) {
    auto imported = importBuilding(map);
    if (!imported) {
        std::fprintf(stderr, "%s\n", imported.error().text().c_str());
        return 1;
    }
    std::string own = folder + "/building.gpkg";
    if (auto saved = saveBuilding(*imported->building, own); !saved) {
        std::fprintf(stderr, "%s\n", saved.error().text().c_str());
        return 1;
    }
    auto source = openVector(own);
    const std::pair<const char*, const char*> kinds[] = {
        {"ESRI Shapefile", "shapefiles"}, {"GeoJSON", "regions.geojson"}, {"GPKG", "tables.gpkg"}};
    for (const auto& [driver, name] : kinds) {
        std::vector<const char*> words{"-f", driver, "-nlt", "PROMOTE_TO_MULTI"};
        if (driver == std::string("GeoJSON")) words = {"-f", driver, "regions"};
        if (driver == std::string("ESRI Shapefile"))
            words = {"-f", driver, "-skipfailures", "regions", "landmarks", "walls"};
        if (driver == std::string("GPKG")) words = {"-f", driver, "regions", "accesses", "landmarks"};
        words.push_back(nullptr);
        GdalMessages quiet;
        GDALVectorTranslateOptions* options =
            GDALVectorTranslateOptionsNew(const_cast<char**>(words.data()), nullptr);
        GDALDatasetH input = source->get();
        GDALClose(GDALVectorTranslate((folder + "/" + name).c_str(), nullptr, 1, &input, options, nullptr));
        GDALVectorTranslateOptionsFree(options);
    }
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    if (argc == 4 && std::string(argv[1]) == "--seeds") return writeSeeds(argv[2], argv[3]);
    if (argc != 2) return 2;
    CPLSetConfigOption("OGR_CURRENT_DATE", "2026-01-01T00:00:00.000Z"); // else no two files are alike
    (void)openVector(""); // sets what maps are saved with; here no power cut is to be survived
    CPLSetConfigOption("OGR_SQLITE_SYNCHRONOUS", "OFF");
    for (std::string source; std::getline(std::cin, source);) {
        Json answer = answerFor(source, argv[1]);
        std::printf("%s\n", answer.dump(-1, ' ', false, Json::error_handler_t::replace).c_str());
        std::fflush(stdout);
    }
    return 0;
}
