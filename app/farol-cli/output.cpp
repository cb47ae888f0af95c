#include "app/farol-cli/output.h"

#include <cstdio>

namespace farol::cli {

int report(const Error& error) {
    std::fprintf(stderr, "farol-cli: %s\n", error.text().c_str());
    return error.code == ErrorCode::InvalidArgument ? kUsage : kFailed;
}

void warn(const std::string& text) {
    std::fprintf(stderr, "farol-cli: warning: %s\n", text.c_str());
}

void warnAll(const std::vector<std::string>& texts) {
    for (const std::string& text : texts) warn(text);
}

void printLine(const std::string& line) {
    std::fwrite(line.data(), 1, line.size(), stdout);
    std::fputc('\n', stdout);
    std::fflush(stdout);
}

} // namespace farol::cli
