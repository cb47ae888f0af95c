#pragma once
// What lies under a point of the map.

#include "ui/map/map_scene.h"
#include "ui/map/view_transform.h"

#include <optional>

namespace farol::ui {

struct MapHit {
    enum class What { Region, Access, Landmark };
    What what = What::Region;
    std::size_t index = 0; ///< in the building's list of that sort

    friend bool operator==(const MapHit&, const MapHit&) = default;
};

/// Landmarks before accesses before regions: the smaller thing is the one meant. `tolerancePx` around
/// symbols.
std::optional<MapHit> hitAt(QPointF screen, const MapScene& scene, double level, const ViewTransform& view,
                            double tolerancePx = 9.0);
/// Where a thing stands on its level.
Point2 positionOf(const MapHit& hit, const MapScene& scene);
double levelOf(const MapHit& hit, const building::Building& building);

} // namespace farol::ui
