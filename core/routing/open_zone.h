#pragma once
// Several regions joined by wide openings, walked as one space: straight lines go through the openings, and
// shortest ways bend at corners of walls and at the ends of openings only.

#include "core/routing/walking_space.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

namespace farol::routing {

/// What may be walked through between two regions, each time from one end to the other.
struct WideOpening {
    std::size_t access = 0;
    std::size_t first = 0; ///< region
    std::size_t second = 0;
    Point2 inFirst[2]; ///< on the border of `first`
    Point2 inSecond[2];
    bool touching = true; ///< both are one line; else there is a gap to cross, such as a thick wall
};

class OpenZone {
public:
    using Slot = std::uint32_t;
    using Slots = std::vector<Slot>;

    /// `spaces`: of the regions, in their order. The spaces must outlive the zone.
    OpenZone(std::vector<std::size_t> regions, std::vector<const WalkingSpace*> spaces,
             const std::vector<WideOpening>& openings);

    const std::vector<std::size_t>& regions() const { return m_regions; }
    /// Where a shortest way may bend.
    std::size_t bendCount() const { return m_bends.size(); }
    Point2 bend(std::size_t i) const { return m_bends[i].position; }

    /// Something to be looked for, such as a door: it is seen from within its region.
    std::size_t addTarget(std::size_t region, Point2 position);

    struct Seen {
        std::size_t what; ///< a bend, or bendCount() + the number of a target
        double metres;
    };
    std::vector<Seen> seenFrom(std::size_t region, Point2 position) const;
    std::vector<Seen> seenFromBend(std::size_t bend) const;

    /// The access that is passed between two points of a straight leg, where, and into which region.
    struct Crossing {
        std::size_t access;
        Point2 position;
        std::size_t into;
    };
    struct Leg {
        bool clear = false;
        double metres = 0.0;
        std::uint32_t endsIn = 0; ///< place
        std::vector<Crossing> crossings;
    };
    /// Where one is between the legs of a way: a region, or the gap of an opening.
    std::uint32_t placeOf(std::size_t region) const { return slotOf(region); }
    /// The straight leg from a point of a place to a bend, or to a point of a region, over as few openings as
    /// may be.
    Leg legToBend(std::uint32_t place, Point2 from, std::size_t bend) const;
    Leg legTo(std::uint32_t place, Point2 from, std::size_t region, Point2 to) const;

private:
    struct Place {
        const WalkingSpace* space;
        std::size_t region;
        std::vector<std::uint32_t> links; ///< out of it
        std::vector<std::uint32_t> bends;
        std::vector<std::uint32_t> targets;
    };
    struct Link { ///< one line between two places, as seen from either
        Point2 a, b;
        Slot places[2];
        std::size_t access;
    };
    struct Bend {
        Point2 position;
        Slots slots;
        bool wall; ///< a corner of walls only, at which `corner` tells which lines are worth going
        WalkingSpace::Corner corner;
    };
    struct Target {
        Point2 position;
        Slot slot;
    };
    struct Beam { ///< between two directions, less than half a turn
        Point2 right, left;
        bool whole = true;
    };
    struct Hop {
        Slot slot;
        std::size_t from; ///< which hop
        std::uint32_t link;
    };
    using Chain = std::vector<std::uint32_t>;

    Slot slotOf(std::size_t region) const;
    Slot otherSide(const Link& link, Slot slot) const { return link.places[link.places[0] == slot ? 1 : 0]; }
    void addLink(Point2 a, Point2 b, Slot first, Slot second, std::size_t access);
    void addBends();
    std::vector<Hop> placesAt(Slot slot, Point2 position) const;
    static bool narrowed(const Beam& beam, Point2 from, const Link& link, Beam& inside);
    static bool within(const Beam& beam, Point2 direction);
    static bool liesBefore(Point2 from, const Beam& beam, const Link& link, const Link& before);
    bool reaches(Slot start, Point2 from, const Chain& chain, Point2 to) const;
    template <class Visit>
    void look(Slot slot, Point2 from, const Visit& visit) const;
    template <class Visit>
    void lookOn(Slot start, Slot slot, Point2 from, const Beam& beam, Chain& chain, std::size_t& left,
                const Visit& visit) const;
    void collect(const std::vector<Hop>& eyes, Point2 from, const WalkingSpace::Corner* corner,
                 std::vector<Seen>& seen) const;
    Leg leg(Slot place, Point2 from, Point2 to, Slot goal, bool anySideOfOpening) const;
    void hop(Leg& leg, Slot& at, const std::vector<Hop>& hops, std::size_t index, Point2 position) const;
    void cross(Leg& leg, Slot& at, std::uint32_t link, Point2 position) const;

    std::vector<std::size_t> m_regions;
    std::vector<Place> m_places; ///< regions first, then the gaps
    std::deque<WalkingSpace> m_gaps;
    std::vector<Link> m_links;
    std::vector<Bend> m_bends;
    std::vector<Target> m_targets;
};

} // namespace farol::routing
