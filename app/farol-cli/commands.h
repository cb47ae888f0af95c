#pragma once
// The sub-commands of farol-cli. Each adds itself to the parser; its callback leaves the exit code (0 done, 1
// failed, 2 wrong usage) in `exitCode`. With --json or --json-lines only JSON goes to stdout; messages go to
// stderr.

#include <CLI/CLI.hpp>

namespace farol::cli {

void addMapCommands(CLI::App& app, int& exitCode);       ///< map check, info, and what follows
void addMapImport(CLI::App& map, int& exitCode);         ///< map import
void addMapAmbiguity(CLI::App& map, int& exitCode);      ///< map ambiguity
void addRouteCommand(CLI::App& app, int& exitCode);      ///< route
void addLibraryCommands(CLI::App& app, int& exitCode);   ///< train, library list, remove, retrain, check
void addRecogniseCommands(CLI::App& app, int& exitCode); ///< recognise, detect
void addLocateCommand(CLI::App& app, int& exitCode);     ///< locate
void addCalibrateCommand(CLI::App& app, int& exitCode);  ///< calibrate
void addRunCommands(CLI::App& app, int& exitCode);       ///< run, replay
void addEvaluateCommand(CLI::App& app, int& exitCode);   ///< evaluate
void addSurveyCommand(CLI::App& app, int& exitCode);     ///< survey
void addSimulateCommand(CLI::App& app, int& exitCode);   ///< simulate

} // namespace farol::cli
