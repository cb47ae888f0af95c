#include "app/farol-cli/loop_words.h"

#include "app/farol-cli/output.h"
#include "core/simulation/spoken_instruction.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace farol::cli {

namespace {

constexpr double kPoseEveryS = 5.0, kSameSightS = 5.0;

/// "sees poster welcome, 3.1 m, 20 degrees left".
std::string sightOf(const recognition::Detection& seen) {
    std::string words = "sees " + std::string(kindName(seen.kind));
    if (!seen.templateId.value.empty()) words += " " + seen.templateId.value;
    if (!seen.text.empty()) words += " \"" + seen.text + "\"";
    char figure[48];
    if (seen.rangeM) {
        std::snprintf(figure, sizeof figure, ", %.1f m", *seen.rangeM);
        words += figure;
    }
    if (seen.bearing) {
        double degrees = toDegrees(*seen.bearing);
        std::snprintf(figure, sizeof figure, ", %.0f degrees %s", std::abs(degrees),
                      degrees < 0.0 ? "right" : "left");
        words += figure;
    }
    std::snprintf(figure, sizeof figure, " (%.2f)", seen.score);
    return words + figure;
}

} // namespace

session::ClosedLoop::Ear sentenceEar() {
    return
        [words = ui::Phrasebook()](const guidance::Cue& cue) -> std::optional<simulation::WalkInstruction> {
            return simulation::instructionFrom(words.sentence(cue).toStdString());
        };
}

LoopTranscript::LoopTranscript(const building::Building& building) {
    bool first = true;
    for (const building::Region& region : building.regions()) {
        for (Point2 p : region.polygon.outer) {
            m_corner = first ? p : Point2{std::min(m_corner.x, p.x), std::min(m_corner.y, p.y)};
            first = false;
        }
    }
}

void LoopTranscript::sights(double time, const std::vector<localisation::Observation>& fresh) {
    for (const localisation::Observation& seen : fresh) {
        const recognition::Detection& thing = seen.detection;
        std::string name = std::string(kindName(thing.kind)) + " " + thing.templateId.value + " " + thing.text;
        auto told = m_seen.find(name);
        if (told == m_seen.end() || time - told->second >= kSameSightS) {
            printLine("            " + sightOf(thing));
            m_seen[name] = time;
        }
    }
}

void LoopTranscript::moment(const session::ClosedLoopMoment& moment) {
    const localisation::Fix& fix = moment.step.fix;
    double time = moment.pose.time;
    bool moved = moment.region != m_region || fix.region != m_taken;
    if (moved || time - m_told >= kPoseEveryS) {
        char line[200];
        std::snprintf(line, sizeof line, "%8.1f s  in %s at %.1f,%.1f facing %.0f; taken for %s (%.2f)", time,
                      moment.region.value.c_str(), moment.pose.position.x - m_corner.x,
                      moment.pose.position.y - m_corner.y, toDegrees(moment.pose.heading),
                      fix.region ? fix.region->value.c_str() : "nowhere", fix.confidence);
        printLine(line);
        const guidance::Progress& progress = moment.step.progress;
        if (progress.next) {
            std::snprintf(
                line, sizeof line, "%10s  %s: next %s into %s%s", "",
                guidance::travelName(progress.travel).c_str(),
                routing::manoeuvreKindName(progress.next->kind).c_str(), progress.next->into.value.c_str(),
                progress.distanceM
                    ? (" in " + std::to_string(static_cast<int>(std::lround(*progress.distanceM))) + " m")
                          .c_str()
                    : "");
            printLine(line);
        }
        m_region = moment.region;
        m_taken = fix.region;
        m_told = time;
    }
    sights(time, moment.step.fresh);
    for (const guidance::Cue& cue : moment.step.cues) {
        std::string text = m_phrasebook.sentence(cue).toStdString();
        char when[24];
        std::snprintf(when, sizeof when, "%8.1f s", time);
        if (!text.empty()) printLine(std::string(when) + "    \"" + text + "\"");
    }
}

} // namespace farol::cli
