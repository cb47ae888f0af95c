// Logs and recordings come from anywhere: no bytes may crash their readers, or the walk that is replayed from
// them.

#include "core/session/json_lines.h"
#include "core/session/recorder.h"
#include "tests/support/ascii_map.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace {

using namespace farol;

std::shared_ptr<const building::Building> rooms() {
    static const auto building =
        test::asciiMap(R"(
        +------+------+
        |A  e  /B  p  |
        +------+------+
    )",
                       {{'e', {Kind::Extinguisher, "", "e"}}, {'p', {Kind::Poster, "", "p"}}});
    return building;
}

void replayed(const std::string& header, const std::string& walk) {
    auto recording = session::parseRecording(header, walk);
    if (!recording) return;
    std::optional<guidance::Progress> before;
    session::ReplayHandlers handlers;
    handlers.step = [&](const session::NavigationStep& step) {
        (void)session::linesOf(step, before ? &*before : nullptr);
        before = step.progress;
    };
    handlers.warning = [](const guidance::Cue& cue) { (void)session::cueLine(cue); };
    (void)session::replay(*recording, rooms(), {}, handlers);
}

} // namespace

/// The first byte says who reads the rest; of a recording the header ends at the first zero byte.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
    switch (data[0] % 4) {
    case 0:
        (void)session::parseLogLine(text);
        break;
    case 1:
        if (auto json = session::parsedJson(text)) (void)session::perceptFromJson(*json);
        break;
    case 2:
        replayed(R"({"farol_recording":1})", text);
        break;
    default: {
        std::size_t split = text.find('\0');
        replayed(text.substr(0, split), split == std::string::npos ? std::string() : text.substr(split + 1));
    }
    }
    return 0;
}
