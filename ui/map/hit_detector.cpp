#include "ui/map/hit_detector.h"

#include <cmath>

namespace farol::ui {

namespace {

double pixelsBetween(QPointF a, QPointF b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

} // namespace

std::optional<MapHit> hitAt(QPointF screen, const MapScene& scene, double level, const ViewTransform& view,
                            double tolerancePx) {
    const LevelScene* floor = scene.level(level);
    if (!floor) return std::nullopt;

    double best = tolerancePx;
    std::optional<MapHit> hit;
    const auto offer = [&](double gap, MapHit candidate) {
        if (gap > best) return;
        best = gap;
        hit = candidate;
    };
    const Point2 point = view.mapFromScreen(screen);
    const Box2 around = building::grown({point, point}, tolerancePx / view.pixelsPerMetre());
    for (const std::size_t i : floor->landmarkIndex.meeting(around)) {
        const std::size_t index = floor->landmarks[i];
        offer(pixelsBetween(screen, view.screenFromMap(scene.building().landmarks()[index].position)),
              {MapHit::What::Landmark, index});
    }
    if (hit) return hit;
    for (const std::size_t i : floor->accessIndex.meeting(around)) {
        const AccessShape& access = floor->accesses[i];
        offer(pixelsBetween(screen, view.screenFromMap(access.middle)), {MapHit::What::Access, access.index});
    }
    if (hit) return hit;

    const std::vector<std::size_t> under = floor->regionIndex.meeting({point, point});
    for (auto i = under.rbegin(); i != under.rend(); ++i) { // the smallest is last
        const std::size_t index = floor->regions[*i].index;
        if (contains(scene.building().regions()[index].polygon, point))
            return MapHit{MapHit::What::Region, index};
    }
    return std::nullopt;
}

Point2 positionOf(const MapHit& hit, const MapScene& scene) {
    const building::Building& building = scene.building();
    switch (hit.what) {
    case MapHit::What::Landmark:
        return building.landmarks()[hit.index].position;
    case MapHit::What::Access:
        return building.accesses()[hit.index].midpoint();
    case MapHit::What::Region:
        break;
    }
    return pointInside(building.regions()[hit.index].polygon);
}

double levelOf(const MapHit& hit, const building::Building& building) {
    switch (hit.what) {
    case MapHit::What::Landmark:
        return building.landmarks()[hit.index].level;
    case MapHit::What::Access:
        return building.accesses()[hit.index].level;
    case MapHit::What::Region:
        break;
    }
    return building.regions()[hit.index].level;
}

} // namespace farol::ui
