#pragma once
// Levels as OpenStreetMap writes them: "0", "-1;0", "1-3", "-4--2", "0;2-3;5", with the mistakes people make.

#include <string_view>
#include <vector>

namespace farol::building {

inline constexpr std::size_t kMaxLevelsPerValue = 1000;

struct ParsedLevels {
    std::vector<double> levels; ///< ascending, each once
    bool understood = true; ///< false: a part was no level, or there were too many; `levels` holds the rest
};

/// Lists by ';', ranges by '-', whole steps in a range. A comma between digits is a decimal comma ("1,5"),
/// unless there are several in one part ("0,1,2"); any other comma separates ("0,-1"). The same in every
/// locale.
ParsedLevels parseLevels(std::string_view text);

} // namespace farol::building
