#include "core/session/plate_readings.h"

#include "core/base/text.h"

namespace farol::session {

namespace {

constexpr int kAgreeing = 3, kAgreeingSharp = 2;

} // namespace

PlateReadings::PlateReadings(const std::vector<std::string>& words) : m_lexicon(words) {}

void PlateReadings::add(std::uint64_t track, const std::string& reading, bool sharp, double time) {
    Plate& plate = m_plates[track];
    plate.lastTime = time;
    Votes& said = plate.votes[foldedForMatching(reading)];
    said.text = reading;
    ++said.all;
    if (sharp) ++said.sharp;
    int total = 0;
    for (const auto& [form, votes] : plate.votes) total += votes.all;
    plate.agreed = nullptr;
    for (const auto& [form, votes] : plate.votes) {
        if (2 * votes.all <= total) continue;
        // A ring on a wall is a nought to any reader: words of one letter take the longer way.
        bool known = form.size() > 1 && votes.sharp >= kAgreeingSharp && m_lexicon.meant(votes.text);
        if (votes.all >= kAgreeing || known) plate.agreed = &votes.text;
    }
}

const std::string* PlateReadings::agreed(std::uint64_t track) const {
    auto found = m_plates.find(track);
    return found != m_plates.end() ? found->second.agreed : nullptr;
}

void PlateReadings::forgetBefore(double time) {
    std::erase_if(m_plates, [time](const auto& each) { return each.second.lastTime < time; });
}

} // namespace farol::session
