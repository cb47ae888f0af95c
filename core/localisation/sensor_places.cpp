// Trained places: from where a view of one is recognised, how much it tells, and what look-alikes take from
// it.

#include "core/localisation/sensor_model.h"

#include <algorithm>
#include <cmath>

namespace farol::localisation {

namespace {

constexpr float kRadToDeg = 57.29578F;
constexpr float kAnyWay = 0.5F; // of a place without a heading: looked at from some ways, nobody knows which

/// How likely a place is the right one whose geometry has that share of the strongest one's strength: of true
/// places seen again most look-alikes have half or less, of false ones .8 or more (tests/bench/README.md).
double fitBeside(double share) {
    constexpr double kAsGood = 0.9, kFalls = 6.0;
    return std::isfinite(share) ? std::exp(-kFalls * std::max(0.0, kAsGood - share)) : 0.0;
}

} // namespace

/// Of places told wrongly there are fewer by a factor e for each five in strength, beyond the least.
double SensorModel::falsePlace(double strength) {
    constexpr double kPerSecond = 0.02, kLeast = 12.0, kScale = 5.0, kMost = 32.0;
    if (!(strength > kLeast)) return kPerSecond;
    return kPerSecond * std::exp((kLeast - std::min(strength, kMost)) / kScale);
}

/// Floors of one building look alike. Where a spot above or below a place, looked at the same way, was never
/// surveyed, nothing in the library could say that the view is from there: it is taken for a copy of the
/// place.
void SensorModel::addTwins() {
    const auto& building = m_map->building();
    std::map<std::uint32_t, std::vector<Item>> placesIn;
    for (const auto& [index, items] : m_placesOf)
        for (std::uint32_t one : items) placesIn[m_items[one].region].push_back(m_items[one]);
    for (const auto& [home, places] : placesIn) {
        const building::Region& own = building.regions()[home];
        for (const building::Level& level : building.levels()) {
            if (level.ordinal == own.level) continue;
            for (Item twin : places) {
                auto region = building.regionAt(m_map->global(twin.at), level.ordinal);
                if (!region || building.regions()[*region].kind != own.kind) continue;
                twin.region = static_cast<std::uint32_t>(*region);
                auto there = placesIn.find(twin.region);
                if (there != placesIn.end() && surveyed(twin, there->second)) continue;
                twin.twin = true;
                addItem(twin);
            }
        }
    }
}

/// Is one of these places about where the given one would be, looking about the same way?
bool SensorModel::surveyed(const Item& like, const std::vector<Item>& places) {
    constexpr float kAboutM = 5.0F, kAboutCosine = 0.5F;
    return std::any_of(places.begin(), places.end(), [&](const Item& place) {
        if (gapBetween(place.at, like.at) > kAboutM) return false;
        bool anyWay = (place.nx == 0.0F && place.ny == 0.0F) || (like.nx == 0.0F && like.ny == 0.0F);
        return anyWay || place.nx * like.nx + place.ny * like.ny >= kAboutCosine;
    });
}

float SensorModel::placeRatio(const Look& look, const Item& item, Spot at, const Gaze& gaze,
                              float factor) const {
    auto sigma = static_cast<float>(m_options.placeSigmaM),
         turn = static_cast<float>(m_options.placeSigmaDeg);
    float dx = item.at.x - at.x, dy = item.at.y - at.y;
    float near = std::exp(-0.5F * (dx * dx + dy * dy) / (sigma * sigma));
    if (item.nx == 0.0F && item.ny == 0.0F) return factor * near * kAnyWay * look.inverseFalse;
    float yaw = std::atan2(item.ny, item.nx) * kRadToDeg;
    float off = std::remainder(yaw - gaze.yawDeg, 360.0F);
    float known = std::exp(-0.5F * off * off / (turn * turn + gaze.variance)) * turn /
                  std::sqrt(turn * turn + gaze.variance);
    float any = turn * 2.5066F / 360.0F;
    return factor * near * (known * (1.0F - gaze.unknownShare) + any * gaze.unknownShare) * look.inverseFalse;
}

/// Are the places of two templates apart from one another, wherever they are?
bool SensorModel::elsewhere(std::int32_t one, std::int32_t other) const {
    constexpr float kNeighbourM = 8.0F;
    auto a = m_placesOf.find(one), b = m_placesOf.find(other);
    if (a == m_placesOf.end() || b == m_placesOf.end()) return false;
    const auto& regions = m_map->building().regions();
    for (std::uint32_t i : a->second)
        for (std::uint32_t j : b->second) {
            const Item &here = m_items[i], &there = m_items[j];
            // Down one corridor the same end is in view all along.
            if (here.region == there.region) return false;
            bool sameLevel = regions[here.region].level == regions[there.region].level;
            if (sameLevel && gapBetween(here.at, there.at) < kNeighbourM) return false;
        }
    return true;
}

/// A view that fits several places is evidence for each of them, and where it fits places elsewhere nearly as
/// well it is hardly evidence at all: then it may as well be a spot that nobody surveyed.
void SensorModel::weighLookAlikes(const recognition::Detection& detection, Look& look,
                                  double& falseFactor) const {
    look.placeFactor.assign(std::max<std::size_t>(1, m_templates.size()),
                            static_cast<float>(m_options.otherTemplate));
    if (look.templateIndex >= 0) look.placeFactor[static_cast<std::size_t>(look.templateIndex)] = 1.0F;
    double rival = 0.0;
    for (const recognition::LookAlike& other : detection.lookAlikes) {
        auto found = m_templates.find(other.templateId.value);
        if (found == m_templates.end() || found->second == look.templateIndex) continue;
        double fits = fitBeside(other.strength / detection.strength);
        float& factor = look.placeFactor[static_cast<std::size_t>(found->second)];
        factor = std::max(factor, static_cast<float>(fits));
        if (elsewhere(found->second, look.templateIndex)) rival = std::max(rival, fits);
    }
    falseFactor *= 1.0 + m_options.lookAlikeFalse * rival;
}

} // namespace farol::localisation
