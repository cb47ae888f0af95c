#include "app/farol-cli/commands.h"

namespace farol::cli {

void addRouteCommand(CLI::App& /*app*/, int& /*exitCode*/) {}

} // namespace farol::cli
