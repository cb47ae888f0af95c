#pragma once
// Where people walk in a building, as few points as possible: doors and openings (one node on either side),
// the corners one has to walk round in bent regions, and straight lines between those that see each other.
// Built once; far smaller than a lattice, so that a campus fits.

#include "core/building/building.h"
#include "core/building/info.h"
#include "core/localisation/localiser.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace farol::localisation {

/// Metres east and north of WalkingMap::origin(): small numbers, so that single precision is enough.
struct Spot {
    float x = 0.0F, y = 0.0F;
};

struct WalkingNode {
    Spot at;
    std::uint32_t region = 0;
    std::int32_t across = -1; ///< the node on the other side; -1 for corners and for what cannot be passed
    float crossingM = 0.0F;   ///< walking distance to `across`
    float halfWidthM = 0.0F;  ///< how far beside `at` one may pass
    Spot along;               ///< unit vector of the opening
    bool changesLevel = false, isLift = false;
    building::AccessKind kind = building::AccessKind::Door;
    bool isOpening = false; ///< nothing to be opened: one comes through without meaning to
    Spot sill;              ///< unit vector along the opening, of a narrow one too; (0, 0): drawn as a point
    Spot out;               ///< unit vector across it, out of the region; (0, 0): not known
    float halfOpenM = 0.0F; ///< half of its whole width
};

class WalkingMap {
public:
    static constexpr float kUnreachable = 1e9F;
    static constexpr std::uint32_t kNoRegion = 0xffffffffU;

    explicit WalkingMap(std::shared_ptr<const building::Building> building);

    const building::Building& building() const { return *m_building; }
    Point2 origin() const { return m_origin; }
    Spot local(Point2 p) const;
    Point2 global(Spot s) const { return {m_origin.x + double(s.x), m_origin.y + double(s.y)}; }

    const std::vector<WalkingNode>& nodes() const { return m_nodes; }
    std::span<const std::uint32_t> nodesOf(std::uint32_t region) const;
    /// Can one walk straight from one point of the region to another?
    bool straight(std::uint32_t region, Spot a, Spot b) const;
    bool bent(std::uint32_t region) const { return m_bent[region] != 0; }
    bool inside(std::uint32_t region, Spot s) const;
    Spot middleOf(std::uint32_t region) const { return m_middles[region]; }
    /// A point of the region; `u`, `v` from 0 to 1.
    Spot spotIn(std::uint32_t region, float u, float v) const;
    /// How much walking a region sees, about one per metre of a corridor and per 5 m2 of a room.
    double weightOf(std::uint32_t region) const;
    double totalWeight() const { return m_weightsUpTo.empty() ? 0.0 : m_weightsUpTo.back(); }
    /// The region in which `u` (0 to 1) of all walking is reached.
    std::uint32_t regionAtShare(double u) const;

    /// Walking distance from each node to the spot; kUnreachable where there is no way. Thrown away when the
    /// goal is taken away.
    void setGoal(std::uint32_t region, Spot spot);
    /// straight() between two nodes of a region, by their order in nodesOf(); remembered.
    bool nodesSee(std::uint32_t region, std::size_t i, std::size_t j);
    void clearGoal();
    bool hasGoal() const { return m_goalRegion != kNoRegion; }
    std::uint32_t goalRegion() const { return m_goalRegion; }
    Spot goalSpot() const { return m_goalSpot; }
    float toGoal(std::uint32_t node) const { return m_toGoal[node]; }
    /// Does the way to the goal pass on through that node? Else it leads back.
    bool leadsOn(std::uint32_t node) const;
    /// Could it be meant by that: a door by any door, stairs by any that go that way up or down?
    bool fits(std::uint32_t node, const ToldWay& told) const;
    /// The same, and from the level of which it was told; a lift is left where it was told, however far on.
    bool fitsHere(std::uint32_t node, const ToldWay& told) const;

private:
    /// Most regions are rectangles, if turned: points in them are found and tested without their outline.
    struct Frame {
        Spot corner, a, b;
        float inverse = 0.0F; ///< 1 / (a x b); 0: no such shape
    };

    static Frame frameOf(const Polygon& polygon, Spot first, Spot second, Spot third, Spot fourth);
    void addAccess(const building::Access& access, std::uint32_t a, std::uint32_t b);
    void addCorners(std::uint32_t region);
    void indexNodes();
    void measureRegions();

    std::shared_ptr<const building::Building> m_building;
    Point2 m_origin;
    std::vector<WalkingNode> m_nodes;
    std::vector<std::uint32_t> m_firstNode, m_nodeOfRegion; ///< compressed rows
    std::vector<char> m_bent;
    std::unordered_map<std::uint32_t, std::vector<char>> m_sights; ///< node sees node, of bent regions
    std::vector<Spot> m_middles;
    std::vector<Frame> m_frames; ///< of each region
    std::vector<double> m_weightsUpTo;
    std::vector<float> m_toGoal;
    std::uint32_t m_goalRegion = kNoRegion;
    Spot m_goalSpot;
};

float gapBetween(Spot a, Spot b);

} // namespace farol::localisation
