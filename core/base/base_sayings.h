#pragma once
// What base itself says of files: its table of sentences (core/base/saying.h).

#include <string>
#include <vector>

namespace farol {

enum class BaseSaying {
    NotReopened,
    NotWrittenToDisk,
    NotCopied,
    NotPutInPlace,
    NoOrdinaryFile,
    NotOpened,
    NotRead,
    NotWritten,
    NotBegun,
    NotFinished,
    NotCreated,
    NoGeoPackageDriver,
    ConnectionUnclear,
};

std::string said(BaseSaying saying);
std::vector<const char*> baseSayings();

} // namespace farol
