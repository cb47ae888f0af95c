// farol-cli: the engine without a screen (design, section 5).

#include "app/farol-cli/commands.h"
#include "app/farol-cli/output.h"

#include <clocale>
#include <csignal>

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN); // a file that may not grow further is told of, like a full disk
    CLI::App app{"Farol on the command line: maps, routes, landmarks, walks.", "farol-cli"};
    app.require_subcommand(1);
    app.set_help_all_flag("--help-all", "Help of every sub-command");
    int exitCode = farol::cli::kDone;
    farol::cli::addMapCommands(app, exitCode);
    farol::cli::addRouteCommand(app, exitCode);
    farol::cli::addLibraryCommands(app, exitCode);
    farol::cli::addRecogniseCommands(app, exitCode);
    farol::cli::addLocateCommand(app, exitCode);
    farol::cli::addCalibrateCommand(app, exitCode);
    farol::cli::addRunCommands(app, exitCode);
    farol::cli::addSurveyCommand(app, exitCode);
    farol::cli::addSimulateCommand(app, exitCode);
    farol::cli::addEvaluateCommand(app, exitCode);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& success) { // --help
        return app.exit(success);
    } catch (const CLI::Error& wrong) {
        app.exit(wrong);
        return farol::cli::kUsage;
    }
    return exitCode;
}
