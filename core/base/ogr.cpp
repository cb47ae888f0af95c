#include "core/base/ogr.h"

#include "core/base/base_sayings.h"
#include "core/base/database_source.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <filesystem>
#include <mutex>
#include <system_error>
#include <vector>

namespace farol {

struct GdalMessages::State {
    std::vector<std::string> errors;
};

namespace {

void collect(CPLErr level, CPLErrorNum, const char* message) {
    if (level < CE_Failure) return;
    static_cast<GdalMessages::State*>(CPLGetErrorHandlerUserData())->errors.emplace_back(message);
}

void registerDrivers() {
    static std::once_flag once;
    std::call_once(once, [] {
        GDALAllRegister();
        // A damaged file must not make the driver guess: field types are what the file says.
        CPLSetConfigOption("OGR_SQLITE_SYNCHRONOUS", "FULL");
    });
}

bool looksLikePath(const std::string& source) {
    return source.rfind("/vsi", 0) != 0 && source.find(':') == std::string::npos;
}

} // namespace

GdalMessages::GdalMessages() : m_state(std::make_unique<State>()) {
    CPLPushErrorHandlerEx(collect, m_state.get());
    CPLErrorReset();
}

GdalMessages::~GdalMessages() {
    CPLPopErrorHandler();
}

bool GdalMessages::failed() const {
    return !m_state->errors.empty();
}

void GdalMessages::clear() {
    m_state->errors.clear();
}

std::string GdalMessages::text() const {
    std::string joined;
    for (const std::string& message : m_state->errors) joined += (joined.empty() ? "" : "; ") + message;
    return joined;
}

Error GdalMessages::error(ErrorCode fallback, const std::string& action, const std::string& context) const {
    std::string told = text();
    bool full =
        told.find("disk is full") != std::string::npos || told.find("No space left") != std::string::npos;
    return {full ? ErrorCode::NoSpace : fallback, told.empty() ? action : action + " (" + told + ")",
            context};
}

void DatasetCloser::operator()(GDALDataset* dataset) const {
    GDALClose(dataset);
}

namespace {

Result<DatasetPtr> openDatabase(const std::string& source, unsigned flags) {
    auto connection = checkedConnection(source);
    if (!connection) return connection.error();
    GdalMessages messages;
    const char* const drivers[] = {"PostgreSQL", nullptr};
    DatasetPtr dataset(GDALDataset::Open(connection->c_str(), flags, drivers));
    if (dataset != nullptr) return dataset;
    std::string said = messages.text();
    while (!said.empty() && said.back() == '\n') said.pop_back();
    return Error{ErrorCode::Unavailable,
                 "the database cannot be opened" +
                     (said.empty() ? std::string() : " (" + withoutSecrets(said, source) + ")"),
                 shownSource(source)};
}

} // namespace

Result<DatasetPtr> openVector(const std::string& source, OpenMode mode) {
    registerDrivers();
    unsigned flags =
        GDAL_OF_VECTOR | GDAL_OF_VERBOSE_ERROR | (mode == OpenMode::Update ? GDAL_OF_UPDATE : 0U);
    if (isDatabase(source)) return openDatabase(source, flags);
    if (looksLikePath(source)) {
        std::error_code failure;
        if (!std::filesystem::exists(source, failure))
            return Error{ErrorCode::NotFound, "there is no such file", source};
    }
    GdalMessages messages;
    DatasetPtr dataset(GDALDataset::Open(source.c_str(), flags));
    if (dataset == nullptr) {
        bool foreign = messages.text().find("not recognized as a supported file format") != std::string::npos;
        return messages.error(foreign ? ErrorCode::UnsupportedFormat : ErrorCode::Corrupt,
                              foreign ? "is not a map file that can be read" : "cannot be opened", source);
    }
    return dataset;
}

Result<DatasetPtr> createGeoPackage(const std::string& path) {
    registerDrivers();
    GdalMessages messages;
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
    if (driver == nullptr) return Error{ErrorCode::Unavailable, said(BaseSaying::NoGeoPackageDriver), path};
    DatasetPtr dataset(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    if (dataset == nullptr) return messages.error(ErrorCode::Io, said(BaseSaying::NotCreated), path);
    return dataset;
}

Result<void> closeVector(DatasetPtr dataset, const std::string& context) {
    GdalMessages messages;
    dataset->FlushCache();
    dataset.reset();
    if (messages.failed()) return messages.error(ErrorCode::Io, said(BaseSaying::NotFinished), context);
    return {};
}

} // namespace farol
