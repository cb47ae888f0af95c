#include "app/farol-cli/walk_printer.h"

#include "app/farol-cli/output.h"

#include <cstdio>

namespace farol::cli {

namespace {

std::string clockText(double time) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%8.1f s", time);
    return buffer;
}

} // namespace

void WalkPrinter::utter(const guidance::Cue& cue) {
    std::string text = m_phrasebook.sentence(cue).toStdString();
    if (text.empty()) return;
    printLine(m_jsonLines ? session::utteranceLine(cue.time, cue.frame, cue.id, text)
                          : clockText(cue.time) + "    \"" + text + "\"");
}

void WalkPrinter::jsonStep(const session::NavigationStep& step) {
    std::vector<std::string> lines = session::linesOf(step, m_before ? &*m_before : nullptr);
    std::size_t firstCue = lines.size() - step.cues.size();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        printLine(lines[i]);
        if (i >= firstCue) utter(step.cues[i - firstCue]);
    }
}

std::string WalkPrinter::placeWords(const localisation::Fix& fix) const {
    if (!fix.region) return "place not known";
    const building::Region* region = m_building->region(*fix.region);
    char confidence[40];
    std::snprintf(confidence, sizeof confidence, "  (confidence %.2f)", fix.confidence);
    return (region != nullptr ? building::spokenName(*region) : fix.region->value) + confidence;
}

void WalkPrinter::step(const session::NavigationStep& step) {
    if (m_jsonLines) {
        jsonStep(step);
    } else {
        std::string place = placeWords(step.fix);
        if (place != m_lastPlace) printLine(clockText(step.fix.time) + "  " + place);
        m_lastPlace = place;
        for (const guidance::Cue& cue : step.cues) utter(cue);
    }
    m_before = step.progress;
}

void WalkPrinter::warning(const guidance::Cue& cue) {
    if (m_jsonLines) printLine(session::cueLine(cue));
    utter(cue);
}

void WalkPrinter::message(double time, std::uint64_t frame, const std::string& text) {
    if (m_jsonLines) {
        printLine(session::warningLine(time, frame, text));
    } else {
        warn(text);
    }
}

} // namespace farol::cli
