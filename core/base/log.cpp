#include "core/base/log.h"

#include <cstdio>
#include <mutex>
#include <utility>

namespace farol {

namespace {

std::mutex& sinkMutex() {
    static std::mutex mutex;
    return mutex;
}

LogSink& currentSink() {
    static LogSink sink = [](LogLevel level, const std::string& message) {
        const char* word = level == LogLevel::Info      ? ""
                           : level == LogLevel::Warning ? "warning: "
                                                        : "error: ";
        std::fprintf(stderr, "farol: %s%s\n", word, message.c_str());
    };
    return sink;
}

} // namespace

void setLogSink(LogSink sink) {
    std::scoped_lock lock(sinkMutex());
    currentSink() = std::move(sink);
}

void logMessage(LogLevel level, const std::string& message) {
    std::scoped_lock lock(sinkMutex());
    if (currentSink()) currentSink()(level, message);
}

} // namespace farol
