#pragma once
// What a program that handles pictures for hours asks of the allocator.

namespace farol {

/// Large blocks, such as pictures, come straight from the system and go back to it when they are freed,
/// instead of staying as holes in a heap that grows. Call it once, first thing in main. No effect but with
/// glibc.
void keepHeapSmall();

} // namespace farol
