#include "ui/map/map_scene.h"

#include "ui/convert/convert.h"

#include <algorithm>

namespace farol::ui {

namespace {

void addRing(QPainterPath& path, const Ring& ring) {
    if (ring.size() < 3) return;
    path.moveTo(ring.front().x, ring.front().y);
    for (std::size_t i = 1; i < ring.size(); ++i) path.lineTo(ring[i].x, ring[i].y);
    path.closeSubpath();
}

void addLine(QPainterPath& path, const Polyline& line) {
    if (line.size() < 2) return;
    path.moveTo(line.front().x, line.front().y);
    for (std::size_t i = 1; i < line.size(); ++i) path.lineTo(line[i].x, line[i].y);
}

void extend(QRectF& bounds, Point2 point) {
    const QRectF spot(point.x, point.y, 0.001, 0.001);
    bounds = bounds.isNull() ? spot : bounds.united(spot);
}

} // namespace

MapScene::MapScene(std::shared_ptr<const building::Building> building) : m_building(std::move(building)) {
    for (const building::Level& level : m_building->levels()) levelFor(level.ordinal);
    addRegions();
    addAccesses();
    for (std::size_t i = 0; i < m_building->landmarks().size(); ++i)
        levelFor(m_building->landmarks()[i].level).landmarks.push_back(i);
    for (const building::Wall& wall : m_building->data().walls)
        addLine(levelFor(wall.level).walls, wall.line);

    std::sort(m_levels.begin(), m_levels.end(),
              [](const LevelScene& a, const LevelScene& b) { return a.ordinal < b.ordinal; });
    for (LevelScene& level : m_levels) {
        std::stable_sort(
            level.regions.begin(), level.regions.end(), [](const RegionShape& a, const RegionShape& b) {
                return a.bounds.width() * a.bounds.height() > b.bounds.width() * b.bounds.height();
            });
        QRectF bounds = level.walls.boundingRect();
        for (const RegionShape& shape : level.regions) bounds = bounds.united(shape.bounds);
        for (const std::size_t index : level.landmarks)
            extend(bounds, m_building->landmarks()[index].position);
        level.bounds = {{bounds.left(), bounds.top()}, {bounds.right(), bounds.bottom()}};
    }
}

LevelScene& MapScene::levelFor(double ordinal) {
    for (LevelScene& level : m_levels)
        if (level.ordinal == ordinal) return level;
    m_levels.emplace_back();
    m_levels.back().ordinal = ordinal;
    return m_levels.back();
}

void MapScene::addRegions() {
    for (std::size_t i = 0; i < m_building->regions().size(); ++i) {
        const building::Region& region = m_building->regions()[i];
        RegionShape shape;
        shape.index = i;
        shape.path.setFillRule(Qt::OddEvenFill);
        addRing(shape.path, region.polygon.outer);
        for (const Ring& hole : region.polygon.holes) addRing(shape.path, hole);
        shape.bounds = shape.path.boundingRect();
        if (region.polygon.outer.size() >= 3) shape.labelAt = pointInside(region.polygon);
        shape.label = regionLabel(region);
        levelFor(region.level).regions.push_back(std::move(shape));
    }
}

void MapScene::addAccesses() {
    for (std::size_t i = 0; i < m_building->accesses().size(); ++i) {
        const building::Access& access = m_building->accesses()[i];
        if (access.line.empty()) continue;
        const AccessShape shape{i, access.line, access.midpoint()};
        levelFor(access.level).accesses.push_back(shape);
        const building::Region* far = m_building->region(access.regionB);
        if (access.changesLevel() && far && far->level != access.level)
            levelFor(far->level).accesses.push_back(shape);
    }
}

const LevelScene* MapScene::level(double ordinal) const {
    for (const LevelScene& level : m_levels)
        if (level.ordinal == ordinal) return &level;
    return nullptr;
}

const RegionShape* MapScene::shapeOf(const RegionId& id) const {
    const std::optional<std::size_t> index = m_building->regionIndex(id);
    if (!index) return nullptr;
    const LevelScene* home = level(m_building->regions()[*index].level);
    if (!home) return nullptr;
    for (const RegionShape& shape : home->regions)
        if (shape.index == *index) return &shape;
    return nullptr;
}

} // namespace farol::ui
