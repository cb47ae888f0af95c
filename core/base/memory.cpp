#include "core/base/memory.h"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace farol {

void keepHeapSmall() {
#ifdef __GLIBC__
    // glibc raises the first limit to the size of each block that is freed, up to 32 MB; set, it stays.
    constexpr int kLargeBytes = 256 * 1024, kSpareBytes = 1024 * 1024;
    mallopt(M_MMAP_THRESHOLD, kLargeBytes);
    mallopt(M_TRIM_THRESHOLD, kSpareBytes);
#endif
}

} // namespace farol
