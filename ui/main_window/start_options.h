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
    QString localiser; ///< empty: as the settings say
    QString edit;      ///< what the Map page opens, a map of any kind; empty: the Walk page is shown
};

} // namespace farol::ui
