#include "app/farol-cli/commands.h"

namespace farol::cli {

void addRecogniseCommands(CLI::App& /*app*/, int& /*exitCode*/) {}

} // namespace farol::cli
