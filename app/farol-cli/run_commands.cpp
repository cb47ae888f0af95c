#include "app/farol-cli/commands.h"

namespace farol::cli {

void addRunCommands(CLI::App& /*app*/, int& /*exitCode*/) {}

} // namespace farol::cli
