#pragma once
// Several readings of one plate, and what they agree on. A wrong word sends somebody into the wrong room: one
// reading is not enough.

#include "core/recognition/lexicon.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace farol::session {

class PlateReadings {
public:
    /// `words`: what the map calls its places.
    explicit PlateReadings(const std::vector<std::string>& words);

    /// One reading of the plate that is followed under this number, in a frame of that time; `sharp`: of a
    /// frame that shows fine detail.
    void add(std::uint64_t track, const std::string& reading, bool sharp, double time);
    /// What three readings agree on and most say (two of sharp frames for a word of the map); null before.
    const std::string* agreed(std::uint64_t track) const;
    /// Forgets plates that were last read before that time.
    void forgetBefore(double time);

private:
    struct Votes {
        std::string text; ///< as it was read last
        int all = 0, sharp = 0;
    };
    struct Plate {
        std::map<std::string, Votes> votes; ///< by the form in which names are compared
        double lastTime = 0.0;
        const std::string* agreed = nullptr; ///< into votes
    };

    recognition::Lexicon m_lexicon;
    std::map<std::uint64_t, Plate> m_plates;
};

} // namespace farol::session
