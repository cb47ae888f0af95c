#pragma once
// The building as a value: levels, regions, accesses, landmarks and walls, as the GeoPackage of the design
// (section 4) holds them. Map axes: x east, y north, metres, in the metric CRS named by `crs`. Nothing here
// reads files.

#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/base/kind.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

namespace farol::building {

/// One attribute that Farol does not know: kept, so that it survives a round trip.
using AttributeValue = std::variant<std::monostate, std::int64_t, double, std::string>;
using Attributes = std::map<std::string, AttributeValue>;

/// A floor. `ordinal`: 0 ground, negative below, 0.5 a mezzanine. `ref`: what people call it and lifts show.
struct Level {
    double ordinal = 0.0;
    std::string name;
    std::string ref;
    std::optional<double> elevationM;
    std::optional<double> heightM;
    Attributes extra;
};

enum class RegionKind { Room, Corridor, Hall, Stairwell, Elevator, Toilet, Outside, Other };

/// A room, corridor, stairwell, lift car or hall (the paper's space, EspacoID).
struct Region {
    RegionId id;
    double level = 0.0;
    std::string name; ///< what is spoken; may be empty in the file, see spokenName()
    std::string ref;  ///< room number on the door
    RegionKind kind = RegionKind::Other;
    std::string kindText; ///< as in the file when `kind` is Other
    bool restricted = false;
    Polygon polygon;
    Attributes extra;
};

enum class AccessKind { Door, Opening, Stairs, Elevator, Escalator, Ramp, Window, Other };
enum class OneWay { No, AToB, BToA };

/// What joins two regions. `line` has two or more points for a door's width, one for a point. Stairs, lifts
/// and escalators join regions of different levels; `level` is then the level of `regionA`.
struct Access {
    AccessId id;
    AccessKind kind = AccessKind::Door;
    std::string kindText;
    double level = 0.0;
    RegionId regionA; ///< empty in a file: derived from geometry on reading where that is possible
    RegionId regionB;
    ShaftId shaft; ///< the same on every level for one stairwell or lift; may be empty
    OneWay oneWay = OneWay::No;
    std::string doorType;
    bool automatic = false;
    std::optional<double> widthM;
    std::optional<int> steps;
    bool closed = false;
    Polyline line;
    Attributes extra;

    Point2 midpoint() const; ///< half-way along `line`
    /// Can one walk through? Windows are seen through, not passed; closed accesses are not passed either.
    bool passable() const { return kind != AccessKind::Window && kind != AccessKind::Other && !closed; }
    bool changesLevel() const {
        return kind == AccessKind::Stairs || kind == AccessKind::Elevator || kind == AccessKind::Escalator;
    }
};

/// A reference object at a place in the map. Kind Place is the view of the spot itself: `position` is where
/// the camera stood and `heading` the way it looked; for all others `heading` is the way the object faces.
struct Landmark {
    LandmarkId id;
    Kind kind = Kind::Other;
    std::string kindText; ///< as in the file when `kind` is Other
    TemplateId
        templateId; ///< the trained appearance, which many landmarks may share; empty: known by kind or text
    std::string text;
    RegionId region;
    double level = 0.0;
    std::optional<Radians> heading; ///< counter-clockwise from east; empty: any
    std::optional<double> heightM, widthM, tallM;
    Point2 position;
    Attributes extra;
};

/// For drawing and simulation only.
struct Wall {
    double level = 0.0;
    Polyline line;
    Attributes extra;
};

/// The parts of a building as a file or an editor holds them, with no promise that they fit together.
struct BuildingData {
    std::string title;
    std::vector<std::string> languages;
    std::string crs; ///< WKT; empty: a local metric plane
    std::vector<Level> levels;
    std::vector<Region> regions;
    std::vector<Access> accesses;
    std::vector<Landmark> landmarks;
    std::vector<Wall> walls;
    std::map<std::string, std::string> properties; ///< the `farol` layer's other keys
    /// Of the database it was read from, which a save must find unchanged; empty for all other maps.
    std::string revision{};
};

/// An immutable building with its lookups. Indices are positions in the vectors. Neighbours are joined by a
/// passable access in either direction; an access that does not name two known regions joins nothing (see
/// checks.h). Publish as shared_ptr<const Building>; safe to read from any thread.
class Building {
public:
    explicit Building(BuildingData data);

    const BuildingData& data() const { return m_data; }
    const std::vector<Level>& levels() const { return m_data.levels; } ///< sorted by ordinal
    const std::vector<Region>& regions() const { return m_data.regions; }
    const std::vector<Access>& accesses() const { return m_data.accesses; }
    const std::vector<Landmark>& landmarks() const { return m_data.landmarks; }

    std::optional<std::size_t> regionIndex(const RegionId& id) const;
    const Region* region(const RegionId& id) const; ///< nullptr when unknown
    const Access* access(const AccessId& id) const;
    const Landmark* landmark(const LandmarkId& id) const;
    const Level* level(double ordinal) const;

    std::span<const std::size_t> accessesOf(std::size_t regionIndex) const; ///< also closed ones and windows
    std::span<const std::size_t> neighboursOf(std::size_t regionIndex) const; ///< sorted, each once
    std::span<const std::size_t> landmarksOf(std::size_t regionIndex) const;
    bool areNeighbours(std::size_t a, std::size_t b) const;
    /// The region on the other side, or empty when the access does not join two known regions.
    std::optional<std::size_t> otherSide(const Access& access, std::size_t regionIndex) const;
    /// The region of that level whose polygon holds the point; the smallest one when several do.
    std::optional<std::size_t> regionAt(Point2 point, double level) const;
    /// Does the region hold or adjoin a staircase, lift or escalator? (paper 4.2, the floor transition)
    bool nearLevelChange(std::size_t regionIndex) const;

private:
    struct Lists { // compressed rows: list i is items[starts[i] .. starts[i+1])
        std::vector<std::size_t> starts;
        std::vector<std::size_t> items;
        std::span<const std::size_t> of(std::size_t i) const;
    };

    BuildingData m_data;
    std::unordered_map<RegionId, std::size_t> m_regionIndex;
    std::unordered_map<AccessId, std::size_t> m_accessIndex;
    std::unordered_map<LandmarkId, std::size_t> m_landmarkIndex;
    Lists m_accesses, m_neighbours, m_landmarks;
    std::vector<std::optional<Box2>> m_boxes; ///< of the regions, for regionAt
    std::vector<bool> m_nearLevelChange;

    static Lists listsOf(std::vector<std::vector<std::size_t>> rows, bool sortedOnce);
    void indexNeighbours();
};

/// The name in a language ("pt"), from the field name_pt where the map has one; else the map's own. An empty
/// language asks for the map's own.
std::string nameIn(const Region& region, const std::string& language);
std::string nameIn(const Level& level, const std::string& language);
/// The region's name, else its ref, else its id: never empty.
std::string spokenName(const Region& region, const std::string& language = {});

std::string regionKindName(RegionKind kind);
std::optional<RegionKind> regionKindFromName(const std::string& name);
std::string accessKindName(AccessKind kind);
std::optional<AccessKind> accessKindFromName(const std::string& name);

} // namespace farol::building
