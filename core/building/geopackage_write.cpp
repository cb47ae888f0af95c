#include "core/base/base_sayings.h"
#include "core/base/database_source.h"
#include "core/base/file.h"
#include "core/base/ogr.h"
#include "core/base/text.h"
#include "core/building/database_map.h"
#include "core/building/geopackage.h"
#include "core/building/layer_schema.h"
#include "core/building/layer_writer.h"
#include "core/building/layers_out.h"
#include "core/building/sentence.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <utility>

namespace farol::building {

namespace {

/// The features of one layer through `fill`, with their unknown fields.
template <class Items, class Key, class Fill>
Result<void> writeItems(LayerWriter& writer, const Items& items, Key key, Fill fill) {
    if (auto opened = writer.open(); !opened) return opened;
    // A null says nothing of the type: fields with a value somewhere come first.
    for (bool empty : {false, true})
        for (const auto& item : items)
            for (const auto& [name, value] : item.extra)
                if (std::holds_alternative<std::monostate>(value) == empty)
                    if (auto added = writer.addField(name, value); !added) return added;
    for (const auto& item : items) {
        writer.begin(key(item));
        fill(item);
        writer.set(item.extra);
        if (auto written = writer.finish(); !written) return written;
    }
    return writer.close(LayerWriter::Missing::Remove);
}

/// Degrees without the dust of the way through radians, so that saving again changes nothing.
std::optional<double> degreesOf(const std::optional<Radians>& angle) {
    if (!angle) return std::nullopt;
    return std::round(toDegrees(*angle) * 1e9) / 1e9;
}

template <class KindType>
std::string kindText(KindType kind, const std::string& text, const std::string& name) {
    return kind == KindType::Other && !text.empty() ? text : name;
}

Result<void> writeLevels(GDALDataset& dataset, const BuildingData& data, const std::string& context) {
    LayerWriter writer(dataset, levelsLayer(), data.crs, context);
    return writeItems(
        writer, data.levels, [](const Level& level) { return formatNumber(level.ordinal); },
        [&](const Level& level) {
            writer.set("level", std::optional<double>(level.ordinal));
            writer.set("name", level.name);
            writer.set("ref", level.ref);
            writer.set("elevation_m", level.elevationM);
            writer.set("height_m", level.heightM);
        });
}

Result<void> writeRegions(GDALDataset& dataset, const BuildingData& data, const std::string& context) {
    LayerWriter writer(dataset, regionsLayer(), data.crs, context);
    return writeItems(
        writer, data.regions, [](const Region& region) { return region.id.value; },
        [&](const Region& region) {
            writer.set("region_id", region.id.value);
            writer.set("level", std::optional<double>(region.level));
            writer.set("name", region.name);
            writer.set("ref", region.ref);
            writer.set("kind", kindText(region.kind, region.kindText, regionKindName(region.kind)));
            writer.set("restricted", region.restricted);
            writer.setPolygon(region.polygon);
        });
}

Result<void> writeAccesses(GDALDataset& dataset, const BuildingData& data, const std::string& context) {
    LayerWriter writer(dataset, accessesLayer(), data.crs, context);
    return writeItems(
        writer, data.accesses, [](const Access& access) { return access.id.value; },
        [&](const Access& access) {
            writer.set("access_id", access.id.value);
            writer.set("kind", kindText(access.kind, access.kindText, accessKindName(access.kind)));
            writer.set("level", std::optional<double>(access.level));
            writer.set("region_a", access.regionA.value);
            writer.set("region_b", access.regionB.value);
            writer.set("shaft", access.shaft.value);
            writer.set("oneway", std::string(access.oneWay == OneWay::AToB   ? "a_to_b"
                                             : access.oneWay == OneWay::BToA ? "b_to_a"
                                                                             : ""));
            writer.set("door_type", access.doorType);
            writer.set("automatic", access.automatic);
            writer.set("width_m", access.widthM);
            writer.set("steps", access.steps ? std::optional<double>(*access.steps) : std::nullopt);
            writer.set("closed", access.closed);
            writer.setLine(access.line);
        });
}

Result<void> writeLandmarks(GDALDataset& dataset, const BuildingData& data, const std::string& context) {
    LayerWriter writer(dataset, landmarksLayer(), data.crs, context);
    return writeItems(
        writer, data.landmarks, [](const Landmark& landmark) { return landmark.id.value; },
        [&](const Landmark& landmark) {
            writer.set("landmark_id", landmark.id.value);
            writer.set("kind",
                       kindText(landmark.kind, landmark.kindText, std::string(kindName(landmark.kind))));
            writer.set("template", landmark.templateId.value);
            writer.set("text", landmark.text);
            writer.set("region_id", landmark.region.value);
            writer.set("level", std::optional<double>(landmark.level));
            writer.set("heading_deg", degreesOf(landmark.heading));
            writer.set("height_m", landmark.heightM);
            writer.set("width_m", landmark.widthM);
            writer.set("tall_m", landmark.tallM);
            writer.setLine({landmark.position});
        });
}

Result<void> writeWalls(GDALDataset& dataset, const BuildingData& data, const std::string& context) {
    if (data.walls.empty() && dataset.GetLayerByName(wallsLayer().name) == nullptr) return {};
    LayerWriter writer(dataset, wallsLayer(), data.crs, context);
    return writeItems(
        writer, data.walls, [](const Wall& wall) { return wallKey(wall.level, wall.line); },
        [&](const Wall& wall) {
            writer.set("level", std::optional<double>(wall.level));
            writer.setLine(wall.line);
        });
}

/// Keys of others (the landmark library keeps its own here) stay.
Result<void> writeFarol(GDALDataset& dataset, const BuildingData& data, const std::string& context) {
    std::string languages;
    for (const std::string& language : data.languages) languages += (languages.empty() ? "" : ",") + language;
    std::map<std::string, std::string> rows = data.properties;
    rows["schema"] = std::to_string(kSchemaVersion);
    rows["title"] = data.title;
    rows["languages"] = languages;
    LayerWriter writer(dataset, farolLayer(), data.crs, context);
    if (auto opened = writer.open(); !opened) return opened;
    for (const auto& [key, value] : rows) {
        writer.begin(key);
        writer.set("key", key);
        writer.set("value", value);
        if (auto written = writer.finish(); !written) return written;
    }
    return writer.close(LayerWriter::Missing::Keep);
}

} // namespace

Result<void> checkNotLater(GDALDataset& dataset, const std::string& context) {
    OGRLayer* farol = dataset.GetLayerByName(farolLayer().name);
    if (farol == nullptr) return {};
    farol->ResetReading();
    while (OGRFeatureUniquePtr feature{farol->GetNextFeature()}) {
        int key = feature->GetFieldIndex("key");
        int value = feature->GetFieldIndex("value");
        if (key < 0 || value < 0 || std::string(feature->GetFieldAsString(key)) != "schema") continue;
        if (std::atoi(feature->GetFieldAsString(value)) > kSchemaVersion)
            return Error{ErrorCode::UnsupportedFormat, english(Sentence::SaveLaterFarol), context};
    }
    return {};
}

Result<void> checkWritable(const BuildingData& data, const std::string& context) {
    auto wrong = [&](const std::string& layer, const std::string& id, const std::string& why) {
        return Error{ErrorCode::InvalidArgument, why, context + ", layer " + layer + ", feature " + id};
    };
    auto finite = [](const std::vector<Point2>& points) {
        for (Point2 p : points)
            if (!isFinite(p)) return false;
        return true;
    };
    for (const Region& region : data.regions) {
        if (region.polygon.outer.size() < 3)
            return wrong("regions", region.id.value, english(Sentence::NoOutline));
        bool sound = finite(region.polygon.outer);
        for (const Ring& hole : region.polygon.holes) sound = sound && hole.size() >= 3 && finite(hole);
        if (!sound) return wrong("regions", region.id.value, english(Sentence::SaveOutlineNone));
    }
    for (const Access& access : data.accesses)
        if (access.line.empty() || !finite(access.line))
            return wrong("accesses", access.id.value, english(Sentence::SaveNoPosition));
    for (const Landmark& landmark : data.landmarks)
        if (!isFinite(landmark.position))
            return wrong("landmarks", landmark.id.value, english(Sentence::SaveNoPosition));
    for (const Wall& wall : data.walls)
        if (wall.line.size() < 2 || !finite(wall.line))
            return wrong("walls", "", english(Sentence::SaveWallNoLength));
    return {};
}

Result<void> writeLayers(GDALDataset& dataset, const BuildingData& data, const std::string& context) {
    using Write = Result<void> (*)(GDALDataset&, const BuildingData&, const std::string&);
    for (Write write :
         {&writeLevels, &writeRegions, &writeAccesses, &writeLandmarks, &writeWalls, &writeFarol})
        if (auto written = write(dataset, data, context); !written) return written;
    return {};
}

namespace {

Result<void> writeAll(GDALDataset& dataset, const BuildingData& data, const std::string& context) {
    GdalMessages messages;
    if (dataset.StartTransaction() != OGRERR_NONE)
        return messages.error(ErrorCode::Io, said(BaseSaying::NotBegun), context);
    if (auto written = writeLayers(dataset, data, context); !written) {
        dataset.RollbackTransaction();
        return written;
    }
    if (dataset.CommitTransaction() != OGRERR_NONE || messages.failed())
        return messages.error(ErrorCode::Io, said(BaseSaying::NotFinished), context);
    return {};
}

Result<void> checkMayWrite(GDALDataset& dataset, const std::string& context) {
    if (dataset.GetDriverName() != std::string("GPKG"))
        return Error{ErrorCode::UnsupportedFormat, english(Sentence::SaveOtherKind), context};
    return checkNotLater(dataset, context);
}

Result<void> fill(const std::filesystem::path& temporary, const BuildingData& data,
                  const std::string& context) {
    GdalMessages quiet; // a dataset given up half-way complains once more when it closes
    std::error_code ignored;
    bool exists = std::filesystem::exists(temporary, ignored);
    auto opened =
        exists ? openVector(temporary.string(), OpenMode::Update) : createGeoPackage(temporary.string());
    if (!opened) return Error{opened.error().code, opened.error().message, context};
    DatasetPtr dataset = std::move(*opened);
    if (exists)
        if (auto allowed = checkMayWrite(*dataset, context); !allowed) return allowed;
    if (auto written = writeAll(*dataset, data, context); !written) return written;
    return closeVector(std::move(dataset), context);
}

bool hasContent(const std::string& file) {
    std::error_code failure;
    auto size = std::filesystem::file_size(file, failure);
    return !failure && size > 0;
}

/// A database has what was written last beside it while a program uses it, or when one was killed. Copying
/// only the file would lose that; putting a new file beside it would spoil both.
Result<void> settle(const std::string& path) {
    const std::string log = path + "-wal", journal = path + "-journal";
    if (!hasContent(log) && !hasContent(journal)) return {};
    {
        GdalMessages quiet;
        auto opened = openVector(path, OpenMode::Update); // takes over what nobody holds
        if (opened && (*opened)->GetLayerCount() > 0) (*opened)->GetLayer(0)->GetFeatureCount();
    }
    if (!hasContent(log) && !hasContent(journal)) return {};
    return Error{ErrorCode::Conflict, english(Sentence::SaveFileBusy), path};
}

/// The new file begins as a copy of the one that the map comes from.
Result<void> copyOrigin(const std::string& origin, const std::filesystem::path& temporary) {
    std::error_code failure;
    if (origin.empty() || std::filesystem::exists(temporary, failure)) return {};
    if (!std::filesystem::is_regular_file(origin, failure)) return {};
    if (auto settled = settle(origin); !settled) return settled;
    std::filesystem::copy_file(origin, temporary, failure);
    if (!failure) return {};
    if (std::ifstream(origin, std::ios::binary).good()) // the other end is at fault
        return systemError(failure.value(), english(Sentence::SaveNotThere),
                           temporary.parent_path().string());
    return systemError(failure.value(), english(Sentence::SaveNotCopied), origin);
}

} // namespace

Result<void> saveBuilding(const Building& building, const std::string& path, const std::string& origin) {
    if (isDatabase(path)) {
        auto revision = saveToDatabase(building, path);
        return revision ? Result<void>() : Result<void>(revision.error());
    }
    try {
        if (auto writable = checkWritable(building.data(), path); !writable) return writable;
        if (auto settled = settle(path); !settled) return settled;
        return replaceFile(path, true, [&](const std::filesystem::path& temporary) {
            if (auto copied = copyOrigin(origin, temporary); !copied) return copied;
            return fill(temporary, building.data(), path);
        });
    } catch (const std::exception& failure) {
        return Error{ErrorCode::Internal, english(Sentence::SaveFailed, failure.what()), path};
    }
}

} // namespace farol::building
