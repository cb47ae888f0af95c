#pragma once
// What every sub-command shares: messages on stderr, exit codes.

#include "core/base/error.h"

#include <string>
#include <vector>

namespace farol::cli {

inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;
inline constexpr int kUsage = 2;

/// "farol-cli: <context>: <message>" on stderr; answers the exit code that fits (2 for InvalidArgument, else
/// 1).
int report(const Error& error);
/// The same for a library that could not be opened, with how to train it again where that helps.
int reportLibrary(const Error& error, const std::string& path);
/// "farol-cli: warning: <text>" on stderr.
void warn(const std::string& text);
void warnAll(const std::vector<std::string>& texts);
/// One line on stdout, flushed, so that a reader at the other end of a pipe sees it at once.
void printLine(const std::string& line);

} // namespace farol::cli
