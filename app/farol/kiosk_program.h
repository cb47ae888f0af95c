#pragma once
// farol --kiosk: the kiosk itself, and the process that starts it again after a crash.

#include "app/farol/options.h"

namespace farol {

/// Needs a QApplication. The exit code of the program.
int runKiosk(const Options& options);

/// Runs this program again with --watched until it ends well. After a few crashes in a row it gives up, so
/// that whatever started it (a systemd user unit) can decide. Needs no display.
int keepKioskRunning(int& argc, char** argv);
/// Is this command line one for keepKioskRunning()?
bool wantsKeeping(int argc, char** argv);

} // namespace farol
