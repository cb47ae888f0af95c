#pragma once
// Files that are never half-written.

#include "core/base/error.h"

#include <filesystem>
#include <functional>
#include <string>

namespace farol {

/// Lets `write` fill a temporary file beside `target`, then puts it in the target's place in one step (fsync
/// and rename). Whatever fails, the old target stays whole and the temporary file is removed; so are those of
/// programs that were killed while they wrote the same target. A symbolic link stays one. `seed`: start the
/// temporary file as a copy of the existing target, for edits in place. NoSpace when the disk is the reason,
/// also where `write` could not tell.
Result<void> replaceFile(const std::filesystem::path& target, bool seed,
                         const std::function<Result<void>(const std::filesystem::path& temporary)>& write);

/// The whole file as bytes.
Result<std::string> readFile(const std::filesystem::path& path);

/// The Error for an errno value: NoSpace for a full disk, NotFound for a missing file, Io otherwise.
Error systemError(int errorNumber, const std::string& action, const std::string& context);

} // namespace farol
