#include "core/base/kind.h"

#include <algorithm>
#include <array>
#include <utility>

namespace farol {

namespace {

constexpr std::array<std::pair<Kind, std::string_view>, 20> kNames{{
    {Kind::Place, "place"},
    {Kind::Door, "door"},
    {Kind::Stairs, "stairs"},
    {Kind::Elevator, "elevator"},
    {Kind::Extinguisher, "extinguisher"},
    {Kind::ExitSign, "exit_sign"},
    {Kind::Sign, "sign"},
    {Kind::Text, "text"},
    {Kind::Rectangle, "rectangle"},
    {Kind::Window, "window"},
    {Kind::Locker, "locker"},
    {Kind::Poster, "poster"},
    {Kind::Fountain, "fountain"},
    {Kind::Hydrant, "hydrant"},
    {Kind::VendingMachine, "vending_machine"},
    {Kind::Bin, "bin"},
    {Kind::Plant, "plant"},
    {Kind::Furniture, "furniture"},
    {Kind::Picture, "picture"},
    {Kind::Other, "other"},
}};

} // namespace

std::string_view kindName(Kind kind) {
    auto it =
        std::find_if(kNames.begin(), kNames.end(), [&](const auto& entry) { return entry.first == kind; });
    return it == kNames.end() ? std::string_view("other") : it->second;
}

std::optional<Kind> kindFromName(std::string_view name) {
    auto it =
        std::find_if(kNames.begin(), kNames.end(), [&](const auto& entry) { return entry.second == name; });
    if (it == kNames.end()) return std::nullopt;
    return it->first;
}

const std::vector<Kind>& allKinds() {
    static const std::vector<Kind> kinds = [] {
        std::vector<Kind> list;
        for (const auto& entry : kNames) list.push_back(entry.first);
        return list;
    }();
    return kinds;
}

} // namespace farol
