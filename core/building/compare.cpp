#include "core/building/compare.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace farol::building {

namespace {

// Taken apart by structured bindings: a member that is added and forgotten here does not compile.
auto parts(const Polygon& polygon) {
    const auto& [outer, holes] = polygon;
    return std::tie(outer, holes);
}

auto parts(const Level& level) {
    const auto& [ordinal, name, ref, elevation, height, extra] = level;
    return std::tie(ordinal, name, ref, elevation, height, extra);
}

auto parts(const Region& region) {
    const auto& [id, level, name, ref, kind, kindText, restricted, polygon, extra] = region;
    return std::tuple_cat(std::tie(id, level, name, ref, kind, kindText, restricted, extra), parts(polygon));
}

auto parts(const Access& access) {
    const auto& [id, kind, kindText, level, a, b, shaft, oneWay, doorType, automatic, width, steps, closed,
                 line, extra] = access;
    return std::tie(id, kind, kindText, level, a, b, shaft, oneWay, doorType, automatic, width, steps, closed,
                    line, extra);
}

auto parts(const Landmark& landmark) {
    const auto& [id, kind, kindText, templateId, text, region, level, heading, height, width, tall, position,
                 extra] = landmark;
    return std::tie(id, kind, kindText, templateId, text, region, level, heading, height, width, tall,
                    position, extra);
}

auto parts(const Wall& wall) {
    const auto& [level, line, extra] = wall;
    return std::tie(level, line, extra);
}

template <class Feature>
bool same(const std::vector<Feature>& a, const std::vector<Feature>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Feature& one, const Feature& other) { return parts(one) == parts(other); });
}

} // namespace

bool sameContent(const BuildingData& a, const BuildingData& b) {
    const auto& [title, languages, crs, levels, regions, accesses, landmarks, walls, properties, revision] =
        b;
    return a.title == title && a.languages == languages && a.crs == crs && same(a.levels, levels) &&
           same(a.regions, regions) && same(a.accesses, accesses) && same(a.landmarks, landmarks) &&
           same(a.walls, walls) && a.properties == properties;
}

} // namespace farol::building
