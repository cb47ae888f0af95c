#include "core/routing/open_zone.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace farol::routing {

namespace {

constexpr double kTouch = 1e-6;
/// Looking through opening after opening ends after so many: where areas overlap, every two of them joined,
/// there would be no end of it. A way not seen is then walked past a bend, a little longer, never through a
/// wall.
constexpr std::size_t kMostLooks = 400;

/// How far away along a direction the line through a and b is; empty when they run alike.
std::optional<double> depthAlong(Point2 from, Point2 direction, Point2 a, Point2 b) {
    double turn = farol::cross(direction, b - a);
    if (std::abs(turn) <= 1e-12 * length(direction) * distance(a, b)) return std::nullopt;
    return farol::cross(a - from, b - a) / turn;
}

/// Where the line from `from` to `to` meets a-b, as a part of the way; empty when it misses it or runs along.
std::optional<double> meeting(Point2 from, Point2 to, Point2 a, Point2 b) {
    Point2 way = to - from;
    Point2 along = b - a;
    double turn = farol::cross(way, along);
    if (std::abs(turn) <= 1e-12 * length(way) * length(along)) return std::nullopt;
    double share = farol::cross(a - from, along) / turn;
    double part = farol::cross(a - from, way) / turn;
    if (part < -1e-9 || part > 1.0 + 1e-9 || share < -1e-9 || share > 1.0 + 1e-9) return std::nullopt;
    return std::clamp(share, 0.0, 1.0);
}

} // namespace

OpenZone::OpenZone(std::vector<std::size_t> regions, std::vector<const WalkingSpace*> spaces,
                   const std::vector<WideOpening>& openings)
    : m_regions(std::move(regions)) {
    for (std::size_t i = 0; i < m_regions.size(); ++i)
        m_places.push_back({spaces[i], m_regions[i], {}, {}, {}});
    for (const WideOpening& each : openings) {
        Slot first = slotOf(each.first), second = slotOf(each.second);
        if (each.touching) {
            addLink(each.inFirst[0], each.inFirst[1], first, second, each.access);
            continue;
        }
        Polygon gap{{each.inFirst[0], each.inFirst[1], each.inSecond[1], each.inSecond[0]}, {}};
        auto between = static_cast<Slot>(m_places.size());
        m_places.push_back({&m_gaps.emplace_back(gap), each.second, {}, {}, {}});
        addLink(each.inFirst[0], each.inFirst[1], first, between, each.access);
        addLink(each.inSecond[0], each.inSecond[1], between, second, each.access);
    }
    addBends();
}

OpenZone::Slot OpenZone::slotOf(std::size_t region) const {
    return static_cast<Slot>(std::lower_bound(m_regions.begin(), m_regions.end(), region) -
                             m_regions.begin());
}

void OpenZone::addLink(Point2 a, Point2 b, Slot first, Slot second, std::size_t access) {
    auto number = static_cast<std::uint32_t>(m_links.size());
    m_links.push_back({a, b, {first, second}, access});
    m_places[first].links.push_back(number);
    m_places[second].links.push_back(number);
}

void OpenZone::addBends() {
    auto add = [&](Slot slot, Bend bend) {
        for (const Hop& hop : placesAt(slot, bend.position)) bend.slots.push_back(hop.slot);
        bend.wall = bend.wall && bend.slots.size() == 1;
        for (Slot each : bend.slots)
            m_places[each].bends.push_back(static_cast<std::uint32_t>(m_bends.size()));
        m_bends.push_back(std::move(bend));
    };
    for (Slot slot = 0; slot < m_places.size(); ++slot)
        for (const WalkingSpace::Corner& corner : m_places[slot].space->corners())
            add(slot, {corner.position, {}, true, corner});
    for (const Link& link : m_links)
        for (Point2 end : {link.a, link.b}) add(link.places[0], {end, {}, false, {}});
}

std::size_t OpenZone::addTarget(std::size_t region, Point2 position) {
    Slot slot = slotOf(region);
    auto number = static_cast<std::uint32_t>(m_targets.size());
    m_targets.push_back({position, slot});
    for (const Hop& hop : placesAt(slot, position)) m_places[hop.slot].targets.push_back(number);
    return m_bends.size() + number;
}

/// The places one is in at once who stands in an opening; the first is `slot` itself.
std::vector<OpenZone::Hop> OpenZone::placesAt(Slot slot, Point2 position) const {
    std::vector<Hop> found{{slot, 0, 0}};
    for (std::size_t i = 0; i < found.size(); ++i)
        for (std::uint32_t number : m_places[found[i].slot].links) {
            const Link& link = m_links[number];
            Slot other = otherSide(link, found[i].slot);
            if (distanceToSegment(position, link.a, link.b) > kTouch ||
                std::any_of(found.begin(), found.end(), [&](const Hop& hop) { return hop.slot == other; }))
                continue;
            found.push_back({other, i, number});
        }
    return found;
}

bool OpenZone::within(const Beam& beam, Point2 direction) {
    if (beam.whole) return true;
    double reach = 1e-9 * length(direction);
    return farol::cross(beam.right, direction) >= -reach * length(beam.right) &&
           farol::cross(direction, beam.left) >= -reach * length(beam.left);
}

/// What of the beam goes on through an opening; false when nothing does.
bool OpenZone::narrowed(const Beam& beam, Point2 from, const Link& link, Beam& inside) {
    Beam through{link.a - from, link.b - from, false};
    double turn = farol::cross(through.right, through.left);
    if (std::abs(turn) <= kTouch * distance(link.a, link.b)) return false; // seen from its own line
    if (turn < 0.0) std::swap(through.right, through.left);
    inside = through;
    if (beam.whole) return true;
    bool rightIn = within(beam, through.right), leftIn = within(beam, through.left);
    if (!rightIn && !within(through, beam.right)) return false;
    if (!leftIn && !within(through, beam.left)) return false;
    if (!rightIn) inside.right = beam.right;
    if (!leftIn) inside.left = beam.left;
    return farol::cross(inside.right, inside.left) > 1e-12 * length(inside.right) * length(inside.left);
}

/// Does the straight line lead through the openings of the chain, one after the other, past no wall?
bool OpenZone::reaches(Slot start, Point2 from, const Chain& chain, Point2 to) const {
    Slot slot = start;
    Point2 at = from;
    double gone = 0.0;
    for (std::uint32_t number : chain) {
        const Link& link = m_links[number];
        auto share = meeting(from, to, link.a, link.b);
        if (!share || *share < gone - 1e-9) return false;
        Point2 next = from + (to - from) * *share;
        if (!m_places[slot].space->clear(at, next)) return false;
        gone = *share;
        at = next;
        slot = otherSide(link, slot);
    }
    return m_places[slot].space->clear(at, to);
}

/// Is the opening nearer than the one looked through before, all over the beam? Where areas overlap, looking
/// back and forth through their openings would have no end.
bool OpenZone::liesBefore(Point2 from, const Beam& beam, const Link& link, const Link& before) {
    for (Point2 edge : {beam.right, beam.left}) {
        auto here = depthAlong(from, edge, link.a, link.b),
             there = depthAlong(from, edge, before.a, before.b);
        if (!here || !there || *here >= *there - 1e-9 * std::abs(*there)) return false;
    }
    return true;
}

template <class Visit>
void OpenZone::lookOn(Slot start, Slot slot, Point2 from, const Beam& beam, Chain& chain, std::size_t& left,
                      const Visit& visit) const {
    if (left == 0) return;
    --left;
    visit(start, slot, beam, chain);
    for (std::uint32_t number : m_places[slot].links) {
        const Link& link = m_links[number];
        // A straight line goes through an opening once; who stands in one has both sides looked at already.
        if (std::find(chain.begin(), chain.end(), number) != chain.end() ||
            distanceToSegment(from, link.a, link.b) <= kTouch)
            continue;
        Beam inside;
        if (!narrowed(beam, from, link, inside)) continue;
        if (!chain.empty() && liesBefore(from, inside, link, m_links[chain.back()])) continue;
        chain.push_back(number);
        lookOn(start, otherSide(link, slot), from, inside, chain, left, visit);
        chain.pop_back();
    }
}

template <class Visit>
void OpenZone::look(Slot slot, Point2 from, const Visit& visit) const {
    Chain chain;
    std::size_t left = kMostLooks;
    lookOn(slot, slot, from, Beam{}, chain, left, visit);
}

void OpenZone::collect(const std::vector<Hop>& eyes, Point2 from, const WalkingSpace::Corner* corner,
                       std::vector<Seen>& seen) const {
    auto known = [&](std::size_t what) {
        return std::any_of(seen.begin(), seen.end(), [&](const Seen& each) { return each.what == what; });
    };
    auto visit = [&](Slot start, Slot slot, const Beam& beam, const Chain& chain) {
        auto tryOne = [&](std::size_t what, Point2 to) {
            if (!within(beam, to - from) || (corner != nullptr && !corner->worthGoing(to)) || known(what) ||
                !reaches(start, from, chain, to))
                return;
            seen.push_back({what, distance(from, to)});
        };
        for (std::uint32_t i : m_places[slot].bends)
            if (!m_bends[i].wall || m_bends[i].corner.worthGoing(from)) tryOne(i, m_bends[i].position);
        for (std::uint32_t i : m_places[slot].targets) tryOne(m_bends.size() + i, m_targets[i].position);
    };
    for (const Hop& eye : eyes) look(eye.slot, from, visit);
}

std::vector<OpenZone::Seen> OpenZone::seenFrom(std::size_t region, Point2 position) const {
    std::vector<Seen> seen;
    collect(placesAt(slotOf(region), position), position, nullptr, seen);
    return seen;
}

std::vector<OpenZone::Seen> OpenZone::seenFromBend(std::size_t number) const {
    const Bend& bend = m_bends[number];
    std::vector<Seen> seen;
    collect(placesAt(bend.slots.front(), bend.position), bend.position, bend.wall ? &bend.corner : nullptr,
            seen);
    std::erase_if(seen, [&](const Seen& each) { return each.what == number; });
    return seen;
}

void OpenZone::cross(Leg& leg, Slot& at, std::uint32_t number, Point2 position) const {
    Slot other = otherSide(m_links[number], at);
    if (m_places[other].region != m_places[at].region)
        leg.crossings.push_back({m_links[number].access, position, m_places[other].region});
    at = other;
}

/// From the first of the places one is in at once to another of them.
void OpenZone::hop(Leg& leg, Slot& at, const std::vector<Hop>& hops, std::size_t index,
                   Point2 position) const {
    std::vector<std::uint32_t> links;
    for (; index != 0; index = hops[index].from) links.push_back(hops[index].link);
    for (auto link = links.rbegin(); link != links.rend(); ++link) cross(leg, at, *link, position);
}

OpenZone::Leg OpenZone::legToBend(std::uint32_t place, Point2 from, std::size_t bend) const {
    return leg(place, from, m_bends[bend].position, m_bends[bend].slots.front(), true);
}

OpenZone::Leg OpenZone::legTo(std::uint32_t place, Point2 from, std::size_t region, Point2 to) const {
    return leg(place, from, to, slotOf(region), false);
}

/// With `anySideOfOpening` the leg may end in whichever place the goal adjoins where it stands in an opening.
OpenZone::Leg OpenZone::leg(Slot place, Point2 from, Point2 to, Slot goal, bool anySideOfOpening) const {
    std::vector<Hop> eyes = placesAt(place, from);
    std::optional<Chain> best;
    std::size_t bestEye = 0, bestEnd = 0, fewest = 0;
    auto visit = [&](std::size_t eye, Slot slot, const Beam& beam, const Chain& chain) {
        if (!within(beam, to - from) || distance(m_places[slot].space->entryOf(to), to) > kTouch) return;
        std::vector<Hop> ends = placesAt(slot, to);
        std::size_t end = 0;
        while (end < ends.size() && ends[end].slot != goal) ++end;
        if (end == ends.size()) return;
        if (anySideOfOpening) end = 0;
        std::size_t hops = eye + chain.size() + end;
        if ((best && hops >= fewest) || !reaches(eyes[eye].slot, from, chain, to)) return;
        best = chain;
        bestEye = eye;
        bestEnd = end;
        fewest = hops;
    };
    for (std::size_t i = 0; i < eyes.size(); ++i)
        look(eyes[i].slot, from,
             [&](Slot, Slot slot, const Beam& beam, const Chain& chain) { visit(i, slot, beam, chain); });
    Leg found;
    found.endsIn = place;
    if (!best) return found;
    found.clear = true;
    found.metres = distance(from, to);
    hop(found, found.endsIn, eyes, bestEye, from);
    for (std::uint32_t number : *best)
        cross(found, found.endsIn, number,
              from + (to - from) * meeting(from, to, m_links[number].a, m_links[number].b).value_or(0.0));
    hop(found, found.endsIn, placesAt(found.endsIn, to), bestEnd, to);
    return found;
}

} // namespace farol::routing
