#pragma once
// The command line of the workstation.

#include "ui/main_window/start_options.h"

#include <QSize>
#include <QString>
#include <QStringList>

#include <optional>

namespace farol {

struct Options {
    ui::StartOptions begin;
    QString language;   ///< empty: as the settings say
    QString screenshot; ///< file; empty: none
    int after = 10;     ///< pictures shown before it is taken
    std::optional<QSize> size;
    std::optional<double> level; ///< that the Map page shows
    QString panel;               ///< table, check or route; empty: as it comes
    bool dark = false;
    bool alike = false; ///< mark the places that look alike
    bool selfTest = false;
    bool kiosk = false;   ///< for a blind user: full screen, keys and speech alone
    QString utterances;   ///< file for what the kiosk says; empty: none
    bool watched = false; ///< the kiosk itself, which another process starts again after a crash
};

/// Ends the program for --help, --version (0) and wrong usage (2).
Options optionsFrom(const QStringList& arguments);

} // namespace farol
