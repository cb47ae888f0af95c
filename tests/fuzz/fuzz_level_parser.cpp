#include "core/building/import/level_parser.h"

#include <cstdint>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    auto parsed = farol::building::parseLevels({reinterpret_cast<const char*>(data), size});
    if (parsed.levels.size() > 2 * farol::building::kMaxLevelsPerValue) __builtin_trap();
    return 0;
}
