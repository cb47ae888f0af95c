#pragma once
// Makes a building of OpenStreetMap features. Everything is measured in a local plane; the exact coordinates
// of nodes (fixed-point in the source) tell which door stands on which outline, as the readers keep no node
// ids.

#include "core/building/import/importer.h"
#include "core/building/import/local_plane.h"
#include "core/building/import/osm_tags.h"
#include "core/building/import/tagged_feature.h"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace farol::building {

class OsmBuilder {
public:
    OsmBuilder(std::vector<TaggedFeature> features, const ImportOptions& options, std::string context);
    Result<RawMap> build();

private:
    using NodeKey = std::pair<std::int64_t, std::int64_t>; ///< 1e-7 degrees, the source's own unit
    struct Corner {                                        ///< a vertex of a region's outline
        std::size_t region;
        Point2 before, after;
    };
    struct WalkLine {
        const TaggedFeature* feature;
        RegionRole role;
        double level;
        Polyline line;
    };

    Error tooMuch() const;
    static NodeKey keyOf(Point2 degrees);
    std::vector<double> levelsOf(const TaggedFeature& feature);
    std::vector<double> levelsOrGround(const TaggedFeature& feature);
    void note(Severity severity, const std::string& rule, const Message& message, const std::string& id);

    void addAreas();
    void addArea(const TaggedFeature& feature, const RegionRole& role);
    void linkLevels(const std::vector<RegionId>& stack, AccessKind kind, const std::string& shaft);
    void addLifts();
    void addLift(const TaggedFeature& feature, Point2 at);
    std::size_t addRegion(Region region, bool walled);
    void collectWalkLines();
    void addWalkRegions();
    void addWalkRegionsOf(double level);
    GeometryPtr areasNear(const Polyline& line, const std::vector<std::size_t>& areas, double reach);
    bool mayMeet();
    void addWalls();
    void addLandmarks();
    void addLevelRows();

    void addDoors();
    void addDoorsOf(const TaggedFeature& feature, Point2 degrees);
    void addDoor(const TaggedFeature& feature, double level, Polyline line,
                 const std::vector<std::size_t>& sides);
    void addRoomOpenings();
    void addOpening(const WalkLine& walk, std::size_t room, Point2 at);
    void addSteps();
    void addFlight(const TaggedFeature& feature, const Polyline& line);
    void addStairs(const TaggedFeature& feature, const Polyline& climb, std::pair<double, double> levels,
                   std::pair<std::optional<std::size_t>, std::optional<std::size_t>> ends, bool rises);
    std::optional<std::size_t> addStairsHalf(const TaggedFeature& feature, const Polyline& half, double level,
                                             double width, std::optional<std::size_t> end);
    std::optional<std::size_t> addStrip(const TaggedFeature& feature, const Polyline& line, double level,
                                        double width, RegionKind kind);
    void addStripEnd(std::size_t strip, const Polyline& outwards, double width, std::size_t end, OneWay way);
    void addWalkways();
    void addWalkway(const TaggedFeature& feature, const Polyline& line, double level);
    void joinLonelyLifts();

    std::optional<std::size_t> regionAt(Point2 metres, double level, double reach,
                                        std::optional<std::size_t> except = {}) const;
    Polyline acrossOutline(std::size_t region, Point2 at, double width) const;
    bool doorNear(const RegionId& region, Point2 at, double reach) const;
    std::string accessId(const std::string& base);

    std::vector<TaggedFeature> m_features;
    std::string m_language, m_context;
    LocalPlane m_plane;
    RawMap m_map;
    std::vector<bool> m_walled;                           ///< beside m_map.data.regions
    std::vector<Box2> m_boxes;                            ///< the same
    std::map<double, std::vector<std::size_t>> m_onLevel; ///< regions of each level
    std::multimap<NodeKey, Corner> m_corners;
    std::map<RegionId, std::vector<std::size_t>> m_accessesOf;
    std::set<std::string> m_accessIds;
    std::set<std::pair<RegionId, RegionId>> m_linked;
    std::vector<WalkLine> m_walks;
    std::map<std::string, Finding> m_notes;
    std::set<std::string> m_stairIds;
    std::map<double, int> m_escalators, m_walkways;
    std::size_t m_stairsFrom = static_cast<std::size_t>(-1); ///< regions from here on are halves of steps
    std::size_t m_meetings = 0;
    bool m_tooMuch = false;
};

} // namespace farol::building
