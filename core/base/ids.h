#pragma once
// Typed identifiers: a region's id cannot be passed where an access's is wanted.

#include <compare>
#include <functional>
#include <string>
#include <utility>

namespace farol {

/// The text by which a map or library names a thing. Empty means "none".
template <class Tag>
struct Id {
    std::string value;

    Id() = default;
    explicit Id(std::string text) : value(std::move(text)) {}

    bool empty() const { return value.empty(); }
    friend auto operator<=>(const Id&, const Id&) = default;
};

using RegionId = Id<struct RegionTag>;
using AccessId = Id<struct AccessTag>;
using LandmarkId = Id<struct LandmarkTag>;
using TemplateId = Id<struct TemplateTag>;
using ShaftId = Id<struct ShaftTag>;

} // namespace farol

template <class Tag>
struct std::hash<farol::Id<Tag>> {
    std::size_t operator()(const farol::Id<Tag>& id) const noexcept {
        return std::hash<std::string>{}(id.value);
    }
};
