#include "app/farol-cli/evaluate/walk_log.h"

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/building/geopackage.h"
#include "core/session/json_fields.h"

#include <algorithm>
#include <sstream>

namespace farol::cli {

namespace fs = std::filesystem;

namespace {

Result<TruthRow> readTruthRow(const std::string& text) {
    auto json = session::parsedJson(text);
    if (!json) return Error{ErrorCode::Corrupt, "is not JSON", ""};
    session::JsonFields fields(*json);
    TruthRow row;
    row.time = fields.number("t");
    row.region = RegionId(fields.text("region"));
    row.level = fields.number("level");
    row.position = {fields.number("x"), fields.number("y")};
    row.heading = fromDegrees(fields.number("heading_deg"));
    row.mode = fields.textOr("mode", "");
    row.onRoute = fields.flagOr("onroute", true);
    row.destination = RegionId(fields.textOr("to", ""));
    if (!fields.ok()) return fields.error();
    return row;
}

template <class Act>
Result<void> eachLine(const std::string& text, const std::string& where, Act act) {
    std::istringstream in(text);
    std::size_t number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        if (Result<void> done = act(line); !done)
            return Error{done.error().code, done.error().message, where + ", line " + std::to_string(number)};
    }
    return {};
}

Result<LoggedWalk> readWalk(std::shared_ptr<const building::Building> building, const fs::path& log) {
    auto lines = readFile(log);
    if (!lines) return lines.error();
    fs::path truth = log;
    auto rows = readFile(truth.replace_extension(".truth.jsonl"));
    if (!rows) return rows.error();
    return parseWalk(std::move(building), log.parent_path().filename().string() + "/" + log.stem().string(),
                     *lines, *rows);
}

class Follower {
public:
    Follower(const building::Building& building, session::Navigator& navigator, bool withMotion)
        : m_building(building), m_navigator(navigator), m_withMotion(withMotion) {}

    void act(const session::LogDetection& line) {
        session::Percept percept = line.percept;
        if (!line.frameGiven) percept.frame = m_navigator.lastFrame() + 1;
        m_navigator.advance(std::move(percept));
    }
    void act(const session::LogStart& line) { m_navigator.start(line.time, line.region); }
    void act(const session::LogDestination& line) {
        auto place = building::resolveWhere(m_building, line.where);
        m_navigator.setDestination(place ? std::optional(*place) : std::nullopt);
    }
    void act(const session::LogMotion& line) {
        if (!m_withMotion) return;
        session::Percept percept;
        percept.time = line.time;
        percept.frame = m_navigator.lastFrame();
        percept.motion = line.motion;
        m_navigator.advance(std::move(percept));
    }
    void act(const session::LogOther&) {}

    Moment momentAt(double time) {
        session::Percept nothing;
        nothing.time = time;
        nothing.frame = m_navigator.lastFrame();
        session::NavigationStep step = m_navigator.advance(std::move(nothing));
        return {step.fix, step.progress.next};
    }

private:
    const building::Building& m_building;
    session::Navigator& m_navigator;
    bool m_withMotion;
};

} // namespace

double timeOf(const session::LogLine& line) {
    struct Time {
        double operator()(const session::LogDetection& one) const { return one.percept.time; }
        double operator()(const session::LogStart& one) const { return one.time; }
        double operator()(const session::LogDestination& one) const { return one.time; }
        double operator()(const session::LogMotion& one) const { return one.time; }
        double operator()(const session::LogOther& one) const { return one.time; }
    };
    return std::visit(Time{}, line);
}

Result<LoggedWalk> parseWalk(std::shared_ptr<const building::Building> building, const std::string& name,
                             const std::string& log, const std::string& truth) {
    LoggedWalk walk;
    walk.building = std::move(building);
    walk.name = name;
    auto lines = eachLine(log, name, [&](const std::string& text) -> Result<void> {
        auto line = session::parseLogLine(text);
        if (!line) return line.error();
        if (auto* start = std::get_if<session::LogStart>(&*line); start != nullptr && !start->region)
            walk.unknownSince.push_back(start->time);
        if (auto* to = std::get_if<session::LogDestination>(&*line); to != nullptr && to->time > 0.0) {
            auto json = session::parsedJson(text);
            bool known = !json || session::JsonFields(*json).flagOr("known", true);
            if (!known) walk.unknownSince.push_back(to->time);
        }
        walk.lines.push_back(std::move(*line));
        return {};
    });
    if (!lines) return lines.error();
    auto rows = eachLine(truth, name + ", truth", [&](const std::string& text) -> Result<void> {
        auto row = readTruthRow(text);
        if (!row) return row.error();
        walk.truth.push_back(std::move(*row));
        return {};
    });
    if (!rows) return rows.error();
    return walk;
}

Result<std::vector<LoggedWalk>> readWalks(const fs::path& folder) {
    std::vector<fs::path> maps, logs;
    std::error_code failed;
    for (const auto& entry : fs::directory_iterator(folder, failed))
        if (fs::exists(entry.path() / "map.gpkg", failed)) maps.push_back(entry.path());
    auto naturally = [](const fs::path& a, const fs::path& b) { return naturalLess(a.string(), b.string()); };
    std::sort(maps.begin(), maps.end(), naturally);
    std::vector<LoggedWalk> walks;
    for (const fs::path& map : maps) {
        auto loaded = building::loadBuilding((map / "map.gpkg").string());
        if (!loaded) return loaded.error();
        logs.clear();
        for (const auto& entry : fs::directory_iterator(map, failed)) {
            std::string name = entry.path().filename().string();
            bool log = entry.path().extension() == ".jsonl" && name.find(".truth.") == std::string::npos;
            if (log) logs.push_back(entry.path());
        }
        std::sort(logs.begin(), logs.end(), naturally);
        for (const fs::path& log : logs) {
            auto walk = readWalk(loaded->building, log);
            if (!walk) return walk.error();
            walks.push_back(std::move(*walk));
        }
    }
    if (walks.empty())
        return Error{ErrorCode::NotFound, "there are no folders with map.gpkg and walks (wNNN.jsonl)",
                     folder.string()};
    return walks;
}

Result<std::vector<Moment>> follow(const LoggedWalk& walk, const std::string& localiser, bool withMotion) {
    session::NavigatorOptions options;
    options.localiser = localiser;
    auto navigator = session::Navigator::create(walk.building, options);
    if (!navigator) return navigator.error();
    Follower follower(*walk.building, **navigator, withMotion);
    std::vector<Moment> moments;
    moments.reserve(walk.truth.size());
    std::size_t next = 0;
    for (const TruthRow& row : walk.truth) {
        for (; next < walk.lines.size() && timeOf(walk.lines[next]) <= row.time; ++next)
            std::visit([&](const auto& line) { follower.act(line); }, walk.lines[next]);
        moments.push_back(follower.momentAt(row.time));
    }
    return moments;
}

} // namespace farol::cli
