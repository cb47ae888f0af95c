#pragma once
// Marks a function that the compiler writes for the newest processors as well; the right one is chosen at
// start. Only avx2, without fused multiplication: every processor gets the same numbers. Sanitizers cannot
// instrument the choice.

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) &&     \
    !defined(__SANITIZE_THREAD__)
#define FAROL_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define FAROL_WIDE
#endif
