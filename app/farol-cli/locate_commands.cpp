#include "app/farol-cli/commands.h"
#include "app/farol-cli/output.h"
#include "app/farol-cli/walk_inputs.h"
#include "core/base/text.h"
#include "core/session/json_lines.h"
#include "core/session/navigator.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>

namespace farol::cli {

namespace {

struct LocateOptions {
    std::string map, log, localiser = "voting", to;
    double every = 0.0;
    bool jsonLines = false;
};

constexpr char kExamples[] =
    "Examples:\n"
    "  farol-cli locate office.gpkg detections.jsonl --json-lines\n"
    "  farol-cli run --map office.gpkg --source walk.mp4 --json-lines | farol-cli locate office.gpkg - "
    "--every 1\n"
    "Lines in: detections as `run` writes them, {\"t\":0,\"start\":\"R12\"|null}, {\"t\":0,\"to\":\"R40\"},\n"
    "{\"t\":1,\"motion\":{\"turn_deg\":-3.1,\"speed\":0.8}}; other lines of `run` only tell the time.\n";

class Locate {
public:
    Locate(const LocateOptions& options, session::Navigator& navigator)
        : m_options(options), m_navigator(navigator) {}

    int run(std::istream& in);

private:
    void read(const std::string& text);
    double timeOf(double time);
    void act(session::LogDetection& line);
    void act(session::LogStart& line);
    void act(session::LogDestination& line);
    void act(session::LogMotion& line);
    void act(session::LogOther& line) { timeOf(line.time); }
    void writeDue(double before, bool including);
    void write(const localisation::Fix& fix);
    void complain(const std::string& text);

    const LocateOptions& m_options;
    session::Navigator& m_navigator;
    std::size_t m_line = 0, m_good = 0, m_bad = 0, m_complaints = 0;
    std::optional<double> m_now;
    double m_nextStep = 0.0; ///< of --every: a whole number, so that no error adds up
    bool m_headWritten = false;
};

void Locate::complain(const std::string& text) {
    constexpr std::size_t kMostComplaints = 20;
    ++m_complaints;
    if (m_complaints <= kMostComplaints)
        warn(m_options.log + ", line " + std::to_string(m_line) + ": " + text);
    if (m_complaints == kMostComplaints + 1) warn(m_options.log + ": more such lines follow");
}

double Locate::timeOf(double time) {
    if (m_now && time < *m_now) {
        complain("the time runs backwards (" + formatNumber(time) + " after " + formatNumber(*m_now) +
                 "); it counts as " + formatNumber(*m_now));
        return *m_now;
    }
    if (m_options.every > 0.0) {
        if (!m_now) m_nextStep = std::ceil(time / m_options.every);
        writeDue(time, false);
    }
    m_now = time;
    return time;
}

void Locate::writeDue(double before, bool including) {
    constexpr double kMostStepsInAGap = 100000.0;
    double last = before / m_options.every;
    if (last - m_nextStep > kMostStepsInAGap) {
        complain("the time jumps to " + formatNumber(before) + "; no fixes are written for the gap");
        m_nextStep = std::ceil(last);
    }
    for (; m_nextStep < last || (including && m_nextStep <= last); m_nextStep += 1.0) {
        session::Percept nothing;
        nothing.time = m_nextStep * m_options.every;
        nothing.frame = m_navigator.lastFrame();
        write(m_navigator.advance(std::move(nothing)).fix);
    }
}

void Locate::act(session::LogDetection& line) {
    if (!line.unknownKind.empty())
        complain("the kind \"" + line.unknownKind + "\" is not known; it counts as other");
    bool later = !m_now || line.percept.time > *m_now;
    line.percept.time = timeOf(line.percept.time);
    // Lines of one moment are one frame: two extinguishers side by side are two, the same one a second later
    // is one.
    if (!line.frameGiven) line.percept.frame = m_navigator.lastFrame() + (later ? 1 : 0);
    localisation::Fix fix = m_navigator.advance(std::move(line.percept)).fix;
    if (m_options.every <= 0.0) write(fix);
}

void Locate::act(session::LogMotion& line) {
    session::Percept percept;
    percept.time = timeOf(line.time);
    percept.frame = m_navigator.lastFrame();
    percept.motion = line.motion;
    m_navigator.advance(std::move(percept));
}

void Locate::act(session::LogStart& line) {
    double time = timeOf(line.time);
    std::optional<RegionId> region;
    if (line.region) {
        auto place = building::resolveWhere(m_navigator.building(), line.region->value);
        if (place)
            region = place->region;
        else
            complain("the start " + place.error().text() + "; it counts as unknown");
    }
    m_navigator.start(time, region);
}

void Locate::act(session::LogDestination& line) {
    timeOf(line.time);
    auto place = building::resolveWhere(m_navigator.building(), line.where);
    if (!place) {
        complain("the destination " + place.error().text() + "; there is none now");
        m_navigator.setDestination(std::nullopt);
        return;
    }
    m_navigator.setDestination(*place);
}

void Locate::write(const localisation::Fix& fix) {
    if (m_options.jsonLines) {
        printLine(session::dumped(session::fixJson(fix)));
        return;
    }
    if (!std::exchange(m_headWritten, true))
        printLine("     t s  confidence  level  x, y m            region");
    char head[64];
    std::snprintf(head, sizeof head, "%8.2f  %10.2f  ", fix.time, fix.confidence);
    char place[64] = "                  ";
    if (fix.position) std::snprintf(place, sizeof place, "%8.2f,%8.2f ", fix.position->x, fix.position->y);
    std::string level = fix.level ? formatNumber(*fix.level) : "-";
    level.resize(std::max<std::size_t>(level.size(), 5), ' ');
    printLine(head + level + "  " + place + (fix.region ? fix.region->value : "not known"));
}

void Locate::read(const std::string& text) {
    if (text.find_first_not_of(" \t\r") == std::string::npos) return;
    auto line = session::parseLogLine(text);
    if (!line) {
        ++m_bad;
        complain(line.error().message + "; the line is left out");
        return;
    }
    ++m_good;
    std::visit([this](auto& one) { act(one); }, *line);
}

int Locate::run(std::istream& in) {
    for (std::string text; std::getline(in, text);) {
        ++m_line;
        read(text);
    }
    if (in.bad()) return report({ErrorCode::Io, "cannot be read to its end", m_options.log});
    if (m_options.every > 0.0 && m_now) writeDue(*m_now, true);
    if (m_bad > 0)
        warn(m_options.log + ": " + std::to_string(m_bad) + " of " + std::to_string(m_bad + m_good) +
             " lines were left out");
    if (m_good == 0 && m_bad > 0)
        return report({ErrorCode::Corrupt, "holds no line that can be used; is it a log of detections?",
                       m_options.log});
    return kDone;
}

int locate(const LocateOptions& options) {
    if (!std::isfinite(options.every) || options.every < 0.0)
        return report({ErrorCode::InvalidArgument, "is to be a number of seconds above 0", "--every"});
    int exitCode = kDone;
    auto building = openMap(options.map, exitCode);
    if (!building) return exitCode;
    std::optional<building::Location> destination;
    if (!findPlace(*building, "--to", options.to, destination, exitCode)) return exitCode;
    session::NavigatorOptions navigatorOptions;
    navigatorOptions.localiser = options.localiser;
    auto navigator = session::Navigator::create(building, navigatorOptions);
    if (!navigator) return report(navigator.error());
    if (destination) (*navigator)->setDestination(destination);
    Locate run(options, **navigator);
    if (options.log == "-") return run.run(std::cin);
    std::ifstream file(options.log);
    if (!file) return report({ErrorCode::NotFound, "the log cannot be opened", options.log});
    return run.run(file);
}

} // namespace

void addLocateCommand(CLI::App& app, int& exitCode) {
    auto options = std::make_shared<LocateOptions>();
    CLI::App* command = app.add_subcommand("locate", "Fixes from a log of detections: where was the user?");
    command->footer(kExamples);
    command->add_option("MAP", options->map, "Building file or connection string")->required();
    command->add_option("DETECTIONS", options->log, "JSON lines; - reads standard input")->required();
    command
        ->add_option("--localiser", options->localiser,
                     "voting, voting-literal, bayes, bayes-guided or bayes-guided-sparse")
        ->capture_default_str();
    command->add_option("--to", options->to,
                        "Destination, for localisers that use the route: region id, name, ref or x,y,level");
    command->add_option("--every", options->every,
                        "A fix every so many seconds of the log instead of one per detection");
    command->add_flag("--json-lines", options->jsonLines, "One JSON object a line instead of a table");
    command->callback([options, &exitCode] { exitCode = locate(*options); });
}

} // namespace farol::cli
