#pragma once
// Messages for people who run the program. One sink for the process: stderr until the application sets
// another. Thread-safe. Libraries (OpenCV, GDAL) are quiet; what they say arrives in Errors.

#include <functional>
#include <string>

namespace farol {

enum class LogLevel { Info, Warning, Error };

using LogSink = std::function<void(LogLevel, const std::string&)>;

void setLogSink(LogSink sink);
void logMessage(LogLevel level, const std::string& message);
inline void logInfo(const std::string& message) {
    logMessage(LogLevel::Info, message);
}
inline void logWarning(const std::string& message) {
    logMessage(LogLevel::Warning, message);
}
inline void logError(const std::string& message) {
    logMessage(LogLevel::Error, message);
}

} // namespace farol
