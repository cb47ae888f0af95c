#pragma once
// A lobby of a few square metres with a door on every side: "the door ahead" fits several.

#include "tests/support/ascii_map.h"

namespace farol::test {

/// L is the lobby; 6 is just behind the door from W, 7 beside the wall further on, 8 in the middle.
inline AsciiMap lobbyMap() {
    return AsciiMap().floor(R"(
        +----+----+------+
        |W   |N   |E     |
        |    |  5 |   4  |
        |    +-/--+      |
        |    |L   /      |
        | 1  /6 8 +------+
        |    |7   |F     |
        |    |    /    2 |
        |    +--/-+      |
        |    |S 3 |      |
        +----+----+------+
    )");
}

} // namespace farol::test
