#pragma once
// What the command line asks the window to begin with.

#include <QString>

namespace farol::ui {

struct StartOptions {
    QString map, library, source; ///< empty: none
    double framesPerSecond = 0.0;
    QString from, to; ///< WHERE of the command line
    QString banner;   ///< which example is running
    bool play = false;
};

} // namespace farol::ui
