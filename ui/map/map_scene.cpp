#include "ui/map/map_scene.h"

#include "ui/convert/convert.h"

#include <algorithm>

namespace farol::ui {

namespace {

constexpr double kAside = 0.25; // of the floor's length: what is farther outside is not shown with it

void addRing(QPainterPath& path, const Ring& ring) {
    if (ring.size() < 3) return;
    path.moveTo(ring.front().x, ring.front().y);
    for (std::size_t i = 1; i < ring.size(); ++i) path.lineTo(ring[i].x, ring[i].y);
    path.closeSubpath();
}

Box2 boxOf(const QRectF& rect) {
    return {{rect.left(), rect.top()}, {rect.right(), rect.bottom()}};
}

Box2 boxOf(const Polyline& line) {
    return boundingBox(line).value_or(Box2{});
}

} // namespace

MapScene::MapScene(std::shared_ptr<const building::Building> building) : m_building(std::move(building)) {
    for (const building::Level& level : m_building->levels()) levelFor(level.ordinal);
    addRegions();
    addAccesses();
    for (std::size_t i = 0; i < m_building->landmarks().size(); ++i)
        levelFor(m_building->landmarks()[i].level).landmarks.push_back(i);
    const std::vector<building::Wall>& walls = m_building->data().walls;
    for (std::size_t i = 0; i < walls.size(); ++i)
        if (walls[i].line.size() >= 2) levelFor(walls[i].level).walls.push_back(i);

    std::sort(m_levels.begin(), m_levels.end(),
              [](const LevelScene& a, const LevelScene& b) { return a.ordinal < b.ordinal; });
    m_homes.resize(m_building->regions().size(), {m_levels.size(), 0});
    for (std::size_t i = 0; i < m_levels.size(); ++i) {
        finishLevel(m_levels[i]);
        for (std::size_t shape = 0; shape < m_levels[i].regions.size(); ++shape)
            m_homes[m_levels[i].regions[shape].index] = {i, shape};
    }
}

void MapScene::finishLevel(LevelScene& level) {
    std::stable_sort(level.regions.begin(), level.regions.end(),
                     [](const RegionShape& a, const RegionShape& b) {
                         return a.bounds.width() * a.bounds.height() > b.bounds.width() * b.bounds.height();
                     });
    // What lies far outside (a landmark with a wrong figure) must not make the floor a spot in a corner.
    std::optional<Box2> all, floor;
    const auto near = [&floor](const Box2& box) {
        if (!floor) return true;
        const double margin = kAside * std::max(floor->width(), floor->height());
        return box.high.x >= floor->low.x - margin && box.low.x <= floor->high.x + margin &&
               box.high.y >= floor->low.y - margin && box.low.y <= floor->high.y + margin;
    };
    const auto index = [&](const auto& list, auto box) {
        std::vector<Box2> boxes;
        boxes.reserve(list.size());
        for (const auto& item : list) {
            const Box2 one = box(item);
            boxes.push_back(one);
            if (!isFinite(one.low) || !isFinite(one.high) || !near(one)) continue;
            if (!all) all = one;
            all->low = {std::min(all->low.x, one.low.x), std::min(all->low.y, one.low.y)};
            all->high = {std::max(all->high.x, one.high.x), std::max(all->high.y, one.high.y)};
        }
        return building::BoxIndex(boxes);
    };
    level.regionIndex = index(level.regions, [](const RegionShape& shape) { return boxOf(shape.bounds); });
    floor = all;
    level.accessIndex = index(level.accesses, [](const AccessShape& shape) { return boxOf(shape.line); });
    level.landmarkIndex = index(level.landmarks, [this](std::size_t i) {
        const Point2 at = m_building->landmarks()[i].position;
        return Box2{at, at};
    });
    level.wallIndex =
        index(level.walls, [this](std::size_t i) { return boxOf(m_building->data().walls[i].line); });
    level.bounds = all.value_or(Box2{});
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
        if (region.polygon.outer.size() < 3) continue; // the check tells of it
        RegionShape shape;
        shape.index = i;
        shape.path.setFillRule(Qt::OddEvenFill);
        addRing(shape.path, region.polygon.outer);
        for (const Ring& hole : region.polygon.holes) addRing(shape.path, hole);
        shape.bounds = shape.path.boundingRect();
        shape.labelAt = pointInside(region.polygon);
        shape.label = regionLabel(region);
        shape.brief = toQString(region.ref);
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
    const Home home = m_homes[*index];
    if (home.level >= m_levels.size()) return nullptr;
    return &m_levels[home.level].regions[home.shape];
}

} // namespace farol::ui
