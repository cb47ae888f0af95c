#include "core/building/plan_picture.h"

#include "core/base/ogr.h"
#include "core/building/sentence.h"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <mutex>
#include <system_error>
#include <utility>

namespace farol::building {

namespace {

using Place = std::array<double, 6>;

struct TransformationEnd {
    void operator()(OGRCoordinateTransformation* transformation) const {
        OCTDestroyCoordinateTransformation(transformation);
    }
};

/// The place in the reference system of the map, as the three corners tell it; a floor is too small for the
/// bend between two systems to be seen.
std::optional<Place> inSystem(const Place& place, const OGRSpatialReference& own, const std::string& crs,
                              double width, double height) {
    OGRSpatialReference map;
    if (map.importFromWkt(crs.c_str()) != OGRERR_NONE) return std::nullopt;
    OGRSpatialReference from(own);
    from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    map.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation, TransformationEnd> to(
        OGRCreateCoordinateTransformation(&from, &map));
    if (!to) return std::nullopt;
    const std::array<std::pair<double, double>, 3> corners{{{0.0, 0.0}, {width, 0.0}, {0.0, height}}};
    std::array<double, 3> x{};
    std::array<double, 3> y{};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto& [column, line] = corners[i];
        x[i] = place[0] + place[1] * column + place[2] * line;
        y[i] = place[3] + place[4] * column + place[5] * line;
    }
    if (!to->Transform(3, x.data(), y.data())) return std::nullopt;
    return Place{x[0], (x[1] - x[0]) / width, (x[2] - x[0]) / height,
                 y[0], (y[1] - y[0]) / width, (y[2] - y[0]) / height};
}

std::optional<Place> placeOf(GDALDataset& dataset, const std::string& crs) {
    Place place{};
    if (dataset.GetGeoTransform(place.data()) != CE_None) return std::nullopt;
    const OGRSpatialReference* own = dataset.GetSpatialRef();
    if (!own) return place; // a world file: metres of the map
    if (crs.empty()) return std::nullopt;
    return inSystem(place, *own, crs, dataset.GetRasterXSize(), dataset.GetRasterYSize());
}

/// One channel of all pixels; palettes are looked up.
bool readChannel(GDALDataset& dataset, int channel, PlanPicture& picture) {
    const int bands = dataset.GetRasterCount();
    GDALRasterBand* band = dataset.GetRasterBand(bands >= 3 ? channel + 1 : 1);
    if (channel == 3) band = bands == 4 || bands == 2 ? dataset.GetRasterBand(bands) : nullptr;
    if (!band) return true; // opaque, as it is
    const bool read = band->RasterIO(GF_Read, 0, 0, dataset.GetRasterXSize(), dataset.GetRasterYSize(),
                                     picture.rgba.data() + channel, picture.width, picture.height, GDT_Byte,
                                     4, static_cast<GSpacing>(4) * picture.width) == CE_None;
    const GDALColorTable* table = bands < 3 && channel < 3 ? band->GetColorTable() : nullptr;
    for (std::size_t at = static_cast<std::size_t>(channel); read && table && at < picture.rgba.size();
         at += 4) {
        const GDALColorEntry* colour = table->GetColorEntry(picture.rgba[at]);
        if (!colour) continue;
        const short value = channel == 0 ? colour->c1 : channel == 1 ? colour->c2 : colour->c3;
        picture.rgba[at] = static_cast<std::uint8_t>(value);
    }
    return read;
}

} // namespace

Result<PlanPicture> loadPlanPicture(const std::string& path, const std::string& crs, int mostPixels) {
    static std::once_flag once;
    std::call_once(once, [] { GDALAllRegister(); });
    std::error_code wrong;
    if (!std::filesystem::is_regular_file(path, wrong))
        return Error{ErrorCode::NotFound, english(Sentence::NoSuchFile), path};
    GdalMessages messages;
    const DatasetPtr dataset(static_cast<GDALDataset*>(
        GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr)));
    if (!dataset || dataset->GetRasterCount() == 0 || dataset->GetRasterXSize() < 1)
        return Error{ErrorCode::UnsupportedFormat, english(Sentence::PlanNoPicture), path};
    const int longest = std::max(dataset->GetRasterXSize(), dataset->GetRasterYSize());
    const double smaller = std::min(1.0, static_cast<double>(mostPixels) / longest);
    PlanPicture picture;
    picture.width = std::max(1, static_cast<int>(dataset->GetRasterXSize() * smaller));
    picture.height = std::max(1, static_cast<int>(dataset->GetRasterYSize() * smaller));
    picture.rgba.assign(
        static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height) * 4, 255);
    for (int channel = 0; channel < 4; ++channel)
        if (!readChannel(*dataset, channel, picture))
            return messages.error(ErrorCode::Corrupt, english(Sentence::PlanDamaged), path);
    picture.toMap = placeOf(*dataset, crs);
    if (picture.toMap) { // in pixels of what was read
        const double across = static_cast<double>(dataset->GetRasterXSize()) / picture.width;
        const double down = static_cast<double>(dataset->GetRasterYSize()) / picture.height;
        for (const std::size_t i : {1U, 4U}) (*picture.toMap)[i] *= across;
        for (const std::size_t i : {2U, 5U}) (*picture.toMap)[i] *= down;
    }
    return picture;
}

} // namespace farol::building
