#include "core/simulation/wall_spots.h"

#include <algorithm>
#include <cmath>

namespace farol::simulation {

std::optional<WallSpot> wallSpot(const SceneData& scene, std::size_t region, Point2 at,
                                 std::optional<Radians> heading, double width, double reach) {
    std::optional<WallSpot> best;
    double least = reach;
    for (const PlanEdge& edge : scene.plan.regions[region].edges) {
        if (edge.to - edge.from < 0.05) continue;
        if (heading) {
            Point2 way{std::cos(heading->value), std::sin(heading->value)};
            if (dot(way, edge.inward) < 0.6) continue;
        }
        double margin = std::min(width / 2 + 0.01, (edge.to - edge.from) / 2);
        double metres = std::clamp(edge.metresOf(at), edge.from + margin, edge.to - margin);
        Point2 on = edge.at(metres, edge.inset);
        double gap = distance(on, at);
        // A point on the border lies as near to both walls of a corner: the one it lies along is meant.
        double aside = std::abs(edge.metresOf(at) - metres);
        if (gap + 0.5 * aside >= least) continue;
        least = gap + 0.5 * aside;
        best = WallSpot{&edge, metres, on, gap};
    }
    return best;
}

bool solidWall(const PlanEdge& edge, double from, double to, double bottom, double top) {
    if (from < edge.from || to > edge.to) return false;
    return std::none_of(edge.cuts.begin(), edge.cuts.end(), [&](const Cut& cut) {
        return cut.from < to && cut.to > from && cut.bottom < top && cut.top > bottom;
    });
}

} // namespace farol::simulation
