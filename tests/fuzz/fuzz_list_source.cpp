#include "tests/fuzz/import_fuzz.h"

// Bytes as a zip: a listing within the limits, whose members can be looked at, or an Error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace farol::building;
    std::string bytes(reinterpret_cast<const char*>(data), size);
    const char* path = "/vsimem/fuzz/map.zip";
    VSIFCloseL(VSIFileFromMemBuffer(path, reinterpret_cast<GByte*>(bytes.data()), bytes.size(), FALSE));
    auto listing = listSource(path);
    if (listing.ok()) {
        for (std::size_t i = 0; i < listing->members.size() && i < 10; ++i) {
            if (("/" + listing->members[i].name + "/").find("/../") != std::string::npos) __builtin_trap();
            (void)listing->head(listing->members[i]);
            (void)listing->content(listing->members[i], 1U << 20U);
        }
    } else if (listing.error().message.empty()) {
        __builtin_trap();
    }
    VSIUnlink(path);
    return 0;
}
