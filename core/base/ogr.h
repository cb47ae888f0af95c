#pragma once
// The adapter to GDAL/OGR that every reader and writer of vector files shares: registration, error capture,
// opening. One dataset per thread. GDAL's own messages never reach stderr; the last ones stand in the Error.

#include "core/base/error.h"

#include <functional>
#include <memory>
#include <string>

class GDALDataset;

namespace farol {

struct DatasetCloser {
    void operator()(GDALDataset* dataset) const;
};
using DatasetPtr = std::unique_ptr<GDALDataset, DatasetCloser>;

enum class OpenMode { ReadOnly, Update };

/// Opens a vector dataset: a file, or an OGR connection string such as "PG:dbname=campus".
/// NotFound for a missing file, UnsupportedFormat when no driver knows it, Corrupt when the driver gave up,
/// Unavailable for a database that cannot be reached. No message repeats a password.
Result<DatasetPtr> openVector(const std::string& source, OpenMode mode = OpenMode::ReadOnly);

/// A new, empty GeoPackage; an existing file at the path is an error.
Result<DatasetPtr> createGeoPackage(const std::string& path);

/// Closes the dataset and reports what GDAL could only say then (a full disk, for example).
Result<void> closeVector(DatasetPtr dataset, const std::string& context);

/// Collects what GDAL says on this thread between construction and destruction, instead of printing it.
class GdalMessages {
public:
    GdalMessages();
    ~GdalMessages();
    GdalMessages(const GdalMessages&) = delete;
    GdalMessages& operator=(const GdalMessages&) = delete;

    bool failed() const;      ///< an error was reported (warnings do not count)
    std::string text() const; ///< the errors, joined by "; "
    void clear();
    /// An Error from what was said: NoSpace when GDAL spoke of a full disk, else `fallback`.
    Error error(ErrorCode fallback, const std::string& action, const std::string& context) const;

    struct State;

private:
    std::unique_ptr<State> m_state;
};

} // namespace farol
