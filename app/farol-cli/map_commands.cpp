#include "app/farol-cli/commands.h"

namespace farol::cli {

void addMapCommands(CLI::App& /*app*/, int& /*exitCode*/) {}

} // namespace farol::cli
