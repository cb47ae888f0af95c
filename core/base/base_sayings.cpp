#include "core/base/base_sayings.h"

#include "core/base/saying.h"

namespace farol {

namespace {

constexpr Saying<BaseSaying> kTable[]{
    {BaseSaying::NotReopened, SAID("core", "cannot reopen for writing")},
    {BaseSaying::NotWrittenToDisk, SAID("core", "cannot write to disk")},
    {BaseSaying::NotCopied, SAID("core", "cannot copy before saving")},
    {BaseSaying::NotPutInPlace, SAID("core", "cannot put the new file in place")},
    {BaseSaying::NoOrdinaryFile, SAID("core", "is no ordinary file; name another one")},
    {BaseSaying::NotOpened, SAID("core", "cannot open")},
    {BaseSaying::NotRead, SAID("core", "cannot read")},
    {BaseSaying::NotWritten, SAID("core", "cannot write")},
    {BaseSaying::NotBegun, SAID("core", "cannot begin to write")},
    {BaseSaying::NotFinished, SAID("core", "cannot finish writing")},
    {BaseSaying::NotCreated, SAID("core", "cannot create the file")},
    {BaseSaying::NoGeoPackageDriver, SAID("core", "this GDAL has no GeoPackage driver")},
    {BaseSaying::ConnectionUnclear,
     SAID("core",
          "the connection cannot be understood: write PG: and then key=value pairs such as dbname=campus "
          "host=maps user=anna, values with blanks in single quotes")},
};
static_assert(inOrder(kTable), "said() looks rows up by their number");

} // namespace

std::string said(BaseSaying saying) {
    return kTable[static_cast<std::size_t>(saying)].english;
}

std::vector<const char*> baseSayings() {
    return englishOf(kTable);
}

} // namespace farol
