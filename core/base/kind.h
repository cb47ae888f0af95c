#pragma once
// What a landmark or a detection is. One list for maps, libraries and detectors (design: "Kinds").

#include <optional>
#include <string_view>
#include <vector>

namespace farol {

enum class Kind {
    Place,
    Door,
    Stairs,
    Elevator,
    Extinguisher,
    ExitSign,
    Sign,
    Text,
    Rectangle,
    Window,
    Locker,
    Poster,
    Fountain,
    Hydrant,
    VendingMachine,
    Bin,
    Plant,
    Furniture,
    Picture,
    Other,
};

/// The name in files and JSON, such as "exit_sign".
std::string_view kindName(Kind kind);
/// Empty for a name that is not in the list: the caller keeps the text, treats it as Other and warns.
std::optional<Kind> kindFromName(std::string_view name);
/// All of them in the order above.
const std::vector<Kind>& allKinds();

} // namespace farol
