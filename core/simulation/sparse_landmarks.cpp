#include "core/simulation/sparse_landmarks.h"

#include "core/base/geometry.h"
#include "core/building/sayable.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace farol::simulation {

namespace {

using building::Access;
using building::AccessKind;
using building::Building;
using building::Landmark;
using building::Region;
using building::RegionKind;

constexpr double kExtinguisherEveryM = 20.0, kOffWallM = 0.06, kClearOfDoorsM = 1.2, kBesideDoorM = 0.25;

bool isWay(const Region& region) {
    return region.kind == RegionKind::Corridor || region.kind == RegionKind::Hall;
}

class Furnisher {
public:
    explicit Furnisher(const Building& building) : m_building(building), m_data(building.data()) {
        for (const Landmark& landmark : building.landmarks()) m_known.insert(landmark.kind);
    }

    building::BuildingData furnished() {
        for (std::size_t i = 0; i < m_building.accesses().size(); ++i) furnishDoor(i);
        for (const Region& region : m_building.regions())
            if (isWay(region) && !m_known.contains(Kind::Extinguisher)) hangExtinguishers(region);
        return std::move(m_data);
    }

private:
    void furnishDoor(std::size_t index) {
        const Access& access = m_building.accesses()[index];
        const Region *a = m_building.region(access.regionA), *b = m_building.region(access.regionB);
        bool door = access.passable() && !access.changesLevel() && access.line.size() >= 2;
        if (!door || a == nullptr || b == nullptr) return;
        for (auto [way, behind] : {std::pair(a, b), std::pair(b, a)}) {
            if (!isWay(*way) || isWay(*behind)) continue;
            bool stairs = behind->kind == RegionKind::Stairwell;
            if (stairs && !m_known.contains(Kind::ExitSign)) {
                hang(*way, access, Kind::ExitSign, {}, 0.0, 2.25);
            } else if (!stairs && !m_known.contains(Kind::Text) && access.kind == AccessKind::Door) {
                std::string name =
                    building::isSayable(behind->ref) ? behind->ref : building::sayableName(*behind);
                if (!name.empty() && ++m_named % 2 == 1)
                    hang(*way, access, Kind::Text, name, kBesideDoorM, 1.5);
            }
            return;
        }
    }

    /// On the wall of `way` in which the door stands.
    void hang(const Region& way, const Access& access, Kind kind, const std::string& text, double beside,
              double height) {
        Point2 from = access.line.front(), to = access.line.back(), middle = (from + to) * 0.5;
        double width = distance(from, to);
        if (width < 1e-6) return;
        Point2 along = (to - from) * (1.0 / width);
        double aside = beside > 0.0 ? width / 2.0 + beside : 0.0;
        for (double side : {1.0, -1.0}) {
            for (double end : {1.0, -1.0}) {
                Point2 out{-along.y * side, along.x * side};
                Point2 at = middle + along * (aside * end) + out * kOffWallM;
                if (!contains(way.polygon, at) || !contains(way.polygon, at + out * 0.3)) continue;
                add(way, kind, text, at, directionOf(out), height);
                return;
            }
        }
    }

    void hangExtinguishers(const Region& region) {
        const Ring& ring = region.polygon.outer;
        double since = kExtinguisherEveryM / 2.0;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            Point2 a = ring[i], b = ring[(i + 1) % ring.size()];
            double size = distance(a, b);
            if (size < 0.8) continue;
            Point2 along = (b - a) * (1.0 / size);
            for (double at = 0.4; at < size - 0.4; at += 0.2) {
                since += 0.2;
                Point2 spot = a + along * at;
                if (since < kExtinguisherEveryM || nearAccess(region, spot)) continue;
                Point2 out{-along.y, along.x};
                if (!contains(region.polygon, spot + out * 0.3)) out = out * -1.0;
                if (!contains(region.polygon, spot + out * 0.3)) continue;
                add(region, Kind::Extinguisher, {}, spot + out * kOffWallM, directionOf(out), 1.0);
                since = 0.0;
            }
        }
    }

    bool nearAccess(const Region& region, Point2 spot) const {
        for (std::size_t access : m_building.accessesOf(*m_building.regionIndex(region.id))) {
            const Polyline& line = m_building.accesses()[access].line;
            if (!line.empty() && distanceToSegment(spot, line.front(), line.back()) < kClearOfDoorsM)
                return true;
        }
        return false;
    }

    void add(const Region& region, Kind kind, const std::string& text, Point2 at, Radians facing,
             double height) {
        Landmark landmark;
        landmark.id = LandmarkId("by-rule-" + std::to_string(++m_count));
        landmark.kind = kind;
        landmark.text = text;
        landmark.region = region.id;
        landmark.level = region.level;
        landmark.heading = facing;
        landmark.heightM = height;
        landmark.position = at;
        m_data.landmarks.push_back(std::move(landmark));
    }

    const Building& m_building;
    building::BuildingData m_data;
    std::set<Kind> m_known;
    int m_named = 0, m_count = 0;
};

} // namespace

std::shared_ptr<const Building> withSparseLandmarks(const Building& building) {
    return std::make_shared<const Building>(Furnisher(building).furnished());
}

} // namespace farol::simulation
