#include "core/building/database_map.h"

#include "core/base/database_source.h"
#include "core/base/ogr.h"
#include "core/building/layer_schema.h"
#include "core/building/layers_out.h"
#include "core/building/sentence.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <array>
#include <exception>
#include <optional>
#include <utility>

namespace farol::building {

namespace {

std::array<const char*, 6> layerNames() {
    return {levelsLayer().name,    regionsLayer().name, accessesLayer().name,
            landmarksLayer().name, wallsLayer().name,   farolLayer().name};
}

/// What the user or the database says of waiting holds, but nobody waits for ever.
constexpr const char* kBoundedWait =
    "SELECT set_config('lock_timeout', CASE current_setting('lock_timeout') WHEN '0' THEN '10s' "
    "ELSE current_setting('lock_timeout') END, true)";

/// Says nothing itself: the caller knows what a failure means.
bool run(GDALDataset& dataset, const std::string& sql, const GdalMessages& messages) {
    OGRLayer* rows = dataset.ExecuteSQL(sql.c_str(), nullptr, nullptr);
    if (rows != nullptr) dataset.ReleaseResultSet(rows);
    return !messages.failed();
}

/// The text in the first row; empty for null.
std::optional<std::string> ask(GDALDataset& dataset, const std::string& sql, const GdalMessages& messages) {
    OGRLayer* rows = dataset.ExecuteSQL(sql.c_str(), nullptr, nullptr);
    if (rows == nullptr) return std::nullopt;
    OGRFeatureUniquePtr row{rows->GetNextFeature()};
    std::optional<std::string> text;
    if (row != nullptr && row->GetFieldCount() > 0) text = row->GetFieldAsString(0);
    row.reset();
    dataset.ReleaseResultSet(rows);
    return messages.failed() ? std::nullopt : text;
}

std::optional<bool> exists(GDALDataset& dataset, const std::string& table, const GdalMessages& messages) {
    auto found = ask(dataset, "SELECT coalesce(to_regclass('" + table + "')::text, '')", messages);
    if (!found) return std::nullopt;
    return !found->empty();
}

/// Other writers wait from here on until the transaction ends; readers go on with what was there before.
Result<void> takeTurn(GDALDataset& dataset, const std::string& context) {
    GdalMessages messages;
    // Among Farols this lock decides, also while there are no tables yet. The number is any, but always the
    // same.
    bool taken = ask(dataset, kBoundedWait, messages).has_value() &&
                 ask(dataset, "SELECT pg_advisory_xact_lock(1178686319)::text", messages).has_value();
    for (const char* table : layerNames()) {
        if (!taken) break;
        auto there = exists(dataset, table, messages);
        taken = there.has_value() &&
                (!*there ||
                 run(dataset, std::string("LOCK TABLE ") + table + " IN SHARE ROW EXCLUSIVE MODE", messages));
    }
    if (taken) return {};
    return messages.error(ErrorCode::Conflict, english(Sentence::SaveNotAllowed), context);
}

Result<void> checkCanHoldMaps(GDALDataset& dataset, const std::string& context) {
    GdalMessages messages;
    auto found = ask(dataset, "SELECT count(*)::text FROM pg_extension WHERE extname = 'postgis'", messages);
    if (found == "1") return {};
    return messages.error(ErrorCode::Unavailable, english(Sentence::DatabaseNoPostGis), context);
}

Result<void> checkUnchanged(GDALDataset& dataset, const std::string& known, const std::string& context) {
    if (known.empty()) return {};
    auto now = mapRevision(dataset, context);
    if (!now) return now.error();
    if (*now == known) return {};
    return Error{ErrorCode::Conflict, english(Sentence::SaveChangedBySomeone), context};
}

Result<std::string> writeInTurn(GDALDataset& dataset, const BuildingData& data, const std::string& context) {
    if (auto turn = takeTurn(dataset, context); !turn) return turn.error();
    if (auto same = checkUnchanged(dataset, data.revision, context); !same) return same.error();
    if (auto sound = checkNotLater(dataset, context); !sound) return sound.error();
    if (auto written = writeLayers(dataset, data, context); !written) return written.error();
    GdalMessages messages;
    dataset.FlushCache();
    if (messages.failed()) return messages.error(ErrorCode::Io, "cannot finish writing", context);
    return mapRevision(dataset, context);
}

Result<std::string> save(const BuildingData& data, const std::string& source, const std::string& context) {
    auto opened = openVector(source, OpenMode::Update);
    if (!opened) return opened.error();
    DatasetPtr dataset = std::move(*opened);
    if (auto able = checkCanHoldMaps(*dataset, context); !able) return able.error();
    GdalMessages messages;
    if (dataset->StartTransaction() != OGRERR_NONE)
        return messages.error(ErrorCode::Io, "cannot begin to write", context);
    auto revision = writeInTurn(*dataset, data, context);
    if (!revision) {
        dataset->RollbackTransaction();
        return revision;
    }
    if (dataset->CommitTransaction() != OGRERR_NONE || messages.failed())
        return messages.error(ErrorCode::Io, "cannot finish writing", context);
    if (auto closed = closeVector(std::move(dataset), context); !closed) return closed.error();
    return revision;
}

} // namespace

Result<void> holdMoment(GDALDataset& dataset, const std::string& context) {
    GdalMessages messages;
    if (run(dataset, "SET SESSION CHARACTERISTICS AS TRANSACTION ISOLATION LEVEL REPEATABLE READ, READ ONLY",
            messages) &&
        dataset.StartTransaction() == OGRERR_NONE && !messages.failed())
        return {};
    return messages.error(ErrorCode::Io, "the database cannot be read", context);
}

Result<std::string> mapRevision(GDALDataset& dataset, const std::string& context) {
    GdalMessages messages;
    std::string revision;
    for (const char* table : layerNames()) {
        auto there = exists(dataset, table, messages);
        std::optional<std::string> part;
        if (there && !*there) part = "none";
        if (there && *there)
            part = ask(
                dataset,
                std::string("SELECT count(*) || ':' || coalesce(sum(hashtextextended(t::text, 0)::numeric), "
                            "0) FROM ") +
                    table + " t",
                messages);
        if (!part) return messages.error(ErrorCode::Io, "cannot see what the database holds", context);
        revision += (revision.empty() ? "" : "/") + *part;
    }
    return revision;
}

Result<std::string> saveToDatabase(const Building& building, const std::string& source) {
    std::string context = shownSource(source);
    try {
        if (auto writable = checkWritable(building.data(), context); !writable) return writable.error();
        return save(building.data(), source, context);
    } catch (const std::exception& failure) {
        return Error{ErrorCode::Internal, std::string("writing the map failed: ") + failure.what(), context};
    }
}

} // namespace farol::building
