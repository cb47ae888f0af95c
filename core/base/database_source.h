#pragma once
// Maps that live in a database: how their connection strings are read, and shown without what is secret in
// them.

#include "core/base/error.h"

#include <string>

namespace farol {

/// Is it a database ("PG:dbname=campus host=maps"), not a file?
bool isDatabase(const std::string& source);

/// The source as it may be shown, logged and stored: of a database only where it is and who asks, never a
/// password. Files stay as they are.
std::string shownSource(const std::string& source);

/// What the driver is to be given: waits a bounded time for a server that does not answer. InvalidArgument
/// where the words cannot be understood; they are not repeated, for a password may be among them.
Result<std::string> checkedConnection(const std::string& source);

/// The text without the connection string and the secrets in it, should the driver have repeated them.
std::string withoutSecrets(std::string text, const std::string& source);

} // namespace farol
