#include "core/recognition/models.h"

// The assembler takes the file's bytes as they are; the build names the file and rebuilds this when it
// changes.
asm(".pushsection .rodata\n"
    ".balign 16\n"
    "farolSignNetworkBegin:\n"
    ".incbin \"" FAROL_SIGN_NETWORK "\"\n"
    "farolSignNetworkEnd:\n"
    ".byte 0\n"
    ".globl farolSignNetworkBegin\n"
    ".globl farolSignNetworkEnd\n"
    ".popsection\n");

extern "C" {
extern const char farolSignNetworkBegin[];
extern const char farolSignNetworkEnd[];
}

namespace farol::recognition {

std::string_view signNetwork() {
    return {farolSignNetworkBegin, static_cast<std::size_t>(farolSignNetworkEnd - farolSignNetworkBegin)};
}

} // namespace farol::recognition
