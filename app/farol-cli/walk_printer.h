#pragma once
// What `run` and `replay` write: JSON lines, or a transcript to read. One class, so that they cannot differ.

#include "core/session/json_lines.h"
#include "ui/speech/phrasebook.h"

#include <memory>
#include <optional>
#include <string>

namespace farol::cli {

class WalkPrinter {
public:
    WalkPrinter(bool jsonLines, std::shared_ptr<const building::Building> building)
        : m_jsonLines(jsonLines), m_building(std::move(building)) {}

    void step(const session::NavigationStep& step);
    /// A cue from outside the chain.
    void warning(const guidance::Cue& cue);
    void message(double time, std::uint64_t frame, const std::string& text);

private:
    void jsonStep(const session::NavigationStep& step);
    void utter(const guidance::Cue& cue);
    std::string placeWords(const localisation::Fix& fix) const;

    bool m_jsonLines;
    std::shared_ptr<const building::Building> m_building;
    ui::Phrasebook m_phrasebook;
    std::optional<guidance::Progress> m_before;
    std::string m_lastPlace;
};

} // namespace farol::cli
