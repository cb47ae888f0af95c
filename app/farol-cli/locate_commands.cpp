#include "app/farol-cli/commands.h"

namespace farol::cli {

void addLocateCommand(CLI::App& /*app*/, int& /*exitCode*/) {}

} // namespace farol::cli
