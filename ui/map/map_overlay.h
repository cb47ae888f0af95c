#pragma once
// What changes on the map with every frame, apart from the building itself.

#include "core/localisation/localiser.h"
#include "core/routing/route.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace farol::ui {

struct CoverageLayer;
struct FloorPicture;

/// What a region is marked as, apart from votes. Drawn as hatching, so that colour never stands alone.
enum class RegionMark : std::uint8_t { None, NoLandmark, LooksAlike, LandmarkHelps, CutOff };

/// Where somebody is known to be beyond doubt: of a simulation.
struct TruePlace {
    Point2 position;
    double level = 0.0; ///< between two ordinals on stairs and in lifts
    Radians heading;
    RegionId region;
};

struct MapOverlay {
    std::optional<localisation::Fix> fix;
    std::shared_ptr<const routing::Route> route;
    std::size_t regionsPassed = 0; ///< of the route
    std::optional<RegionId> destination;
    std::optional<RegionId> start;
    std::optional<TruePlace> truth;
    std::shared_ptr<const std::vector<RegionMark>> marks;      ///< by index of the region; null: none
    std::shared_ptr<const CoverageLayer> coverage;             ///< null: none
    std::vector<std::shared_ptr<const FloorPicture>> pictures; ///< under the map, each on its level
    double sureConfidence = 0.5;                               ///< from here on a place counts as sure

    /// 0 to 1: the share of the best vote; 0 for a region without one.
    double heatOf(const RegionId& region) const;
};

/// How the map is drawn: the walk's map shows likelihoods, the curator's what the regions are.
struct MapStyle {
    bool kinds = false;     ///< a colour for each kind of region
    bool likelihood = true; ///< the legend of votes
    bool scale = false;     ///< a bar of so many metres

    friend bool operator==(const MapStyle&, const MapStyle&) = default;
};

} // namespace farol::ui
