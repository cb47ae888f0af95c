#include "app/farol-cli/output.h"

#include <cstdio>

namespace farol::cli {

int report(const Error& error) {
    std::fprintf(stderr, "farol-cli: %s\n", error.text().c_str());
    return error.code == ErrorCode::InvalidArgument ? kUsage : kFailed;
}

int reportLibrary(const Error& error, const std::string& path) {
    int code = report(error);
    if (error.code == ErrorCode::Conflict)
        std::fprintf(stderr,
                     "farol-cli: its photographs are kept; to train it again: farol-cli library retrain %s\n",
                     path.c_str());
    return code;
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
