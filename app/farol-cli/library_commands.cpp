#include "app/farol-cli/commands.h"

namespace farol::cli {

void addLibraryCommands(CLI::App& /*app*/, int& /*exitCode*/) {}

} // namespace farol::cli
