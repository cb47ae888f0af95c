#include "core/session/walk_alignment.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace farol::session {

namespace {

constexpr double kBodyTurnM = 0.7;
/// A frame that fits nowhere costs no more than this: one wrong recognition does not bend the whole walk.
constexpr double kMostCost = 8.0;

double wrappedDifference(Radians a, Radians b) {
    return wrapped(a - b).value;
}

} // namespace

WalkedPath::WalkedPath(std::vector<routing::PathPoint> points) {
    for (routing::PathPoint& point : points) {
        bool same = !m_points.empty() && m_points.back().level == point.level &&
                    distance(m_points.back().position, point.position) < 1e-6;
        if (same) continue;
        double step = m_points.empty() ? 0.0 : distance(m_points.back().position, point.position);
        m_at.push_back(m_at.empty() ? 0.0 : m_at.back() + step);
        m_points.push_back(point);
    }
}

std::size_t WalkedPath::segmentAt(double metres) const {
    auto after = std::upper_bound(m_at.begin(), m_at.end(), metres);
    auto index = static_cast<std::size_t>(std::distance(m_at.begin(), after));
    return std::clamp<std::size_t>(index, 1, m_points.size() - 1) - 1;
}

routing::PathPoint WalkedPath::at(double metres) const {
    if (m_points.size() < 2) return m_points.empty() ? routing::PathPoint{} : m_points.front();
    std::size_t i = segmentAt(metres);
    double span = m_at[i + 1] - m_at[i];
    double share = span > 0.0 ? std::clamp((metres - m_at[i]) / span, 0.0, 1.0) : 0.0;
    Point2 a = m_points[i].position, b = m_points[i + 1].position;
    return {a + (b - a) * share, share < 0.5 ? m_points[i].level : m_points[i + 1].level};
}

std::optional<Radians> WalkedPath::heading(double metres) const {
    if (m_points.size() < 2) return std::nullopt;
    std::size_t i = segmentAt(metres);
    if (m_points[i].level != m_points[i + 1].level) return std::nullopt;
    Point2 before = at(std::max(0.0, metres - kBodyTurnM)).position,
           after = at(std::min(lengthM(), metres + kBodyTurnM)).position;
    Point2 way = after - before;
    if (length(way) < 0.2) way = m_points[i + 1].position - m_points[i].position;
    return directionOf(way);
}

bool WalkedPath::bends(double metres, Radians limit) const {
    if (m_points.size() < 2) return true;
    std::size_t first = segmentAt(std::max(0.0, metres - kBodyTurnM)),
                last = segmentAt(std::min(lengthM(), metres + kBodyTurnM));
    auto direction = [&](std::size_t i) {
        return directionOf(m_points[i + 1].position - m_points[i].position);
    };
    for (std::size_t i = first; i <= last; ++i) {
        if (m_points[i].level != m_points[i + 1].level) return true;
        if (std::abs(wrappedDifference(direction(i), direction(first))) > limit.value) return true;
    }
    return false;
}

Result<void> AlignmentOptions::check() const {
    auto wrong = [](const char* which) {
        return Error{ErrorCode::InvalidArgument, "must be above 0", std::string("alignment.") + which};
    };
    auto positive = [](double value) { return std::isfinite(value) && value > 0.0; };
    if (!positive(cellM)) return wrong("cellM");
    if (!positive(paceSpread)) return wrong("paceSpread");
    if (!positive(headingSpreadRad)) return wrong("headingSpreadRad");
    if (!positive(anchorSpreadM)) return wrong("anchorSpreadM");
    if (!positive(maxSpeed)) return wrong("maxSpeed");
    return {};
}

namespace {

/// Expected steps in metres: the measured pace where there is one, the mean of the others where there is
/// none, scaled so that all of them together make the way.
std::vector<double> expectedSteps(const std::vector<WalkedFrame>& frames, double lengthM) {
    std::vector<double> steps(frames.size(), 0.0);
    double measured = 0.0, measuredSeconds = 0.0;
    for (std::size_t i = 1; i < frames.size(); ++i) {
        double seconds = std::max(0.0, frames[i].time - frames[i - 1].time);
        if (!frames[i].motion.speed) continue;
        measured += *frames[i].motion.speed * seconds;
        measuredSeconds += seconds;
    }
    double mean = measured > 0.0 ? measured / measuredSeconds : 1.0, all = 0.0;
    for (std::size_t i = 1; i < frames.size(); ++i) {
        double seconds = std::max(0.0, frames[i].time - frames[i - 1].time);
        double speed = measured > 0.0 ? frames[i].motion.speed.value_or(mean) : mean;
        steps[i] = speed * seconds;
        all += steps[i];
    }
    for (double& step : steps) step = all > 0.0 ? step * lengthM / all : 0.0;
    return steps;
}

/// The camera's heading by the visual gyroscope, turned so that it begins along the way; empty after a gap,
/// from which on it knows nothing.
std::vector<std::optional<Radians>> visualHeadings(const std::vector<WalkedFrame>& frames,
                                                   const WalkedPath& path) {
    std::vector<std::optional<Radians>> headings(frames.size());
    std::optional<Radians> now = path.heading(0.0);
    for (std::size_t i = 0; i < frames.size() && now; ++i) {
        if (i > 0) {
            if (!frames[i].motion.turn) break;
            now = *now + *frames[i].motion.turn;
        }
        headings[i] = now;
    }
    return headings;
}

/// Several frames taken together, so that a step is long against the cells: many small steps, each rounded to
/// whole cells, would not add up.
struct Tick {
    std::size_t frame = 0; ///< the last of them
    double stepM = 0.0;    ///< expected
    double seconds = 0.0;
    std::vector<Anchor> anchors;
};

std::vector<Tick> ticksOf(const std::vector<WalkedFrame>& frames, const std::vector<double>& steps,
                          const AlignmentOptions& options) {
    constexpr double kCellsPerTick = 3.0;
    std::vector<Tick> ticks(1);
    ticks.front().anchors = frames.front().anchors;
    Tick now;
    for (std::size_t i = 1; i < frames.size(); ++i) {
        now.frame = i;
        now.stepM += steps[i];
        now.seconds += std::max(0.0, frames[i].time - frames[i - 1].time);
        now.anchors.insert(now.anchors.end(), frames[i].anchors.begin(), frames[i].anchors.end());
        bool last = i + 1 == frames.size();
        if (!last && now.stepM < kCellsPerTick * options.cellM && now.anchors.empty()) continue;
        ticks.push_back(std::move(now));
        now = {};
    }
    return ticks;
}

class Aligner {
public:
    Aligner(const WalkedPath& path, const std::vector<WalkedFrame>& frames, const AlignmentOptions& options)
        : m_options(options),
          m_steps(expectedSteps(frames, path.lengthM())),
          m_ticks(ticksOf(frames, m_steps, options)),
          m_headings(visualHeadings(frames, path)) {
        m_cells = static_cast<std::size_t>(std::ceil(path.lengthM() / options.cellM)) + 1;
        m_cell = path.lengthM() / static_cast<double>(m_cells - 1);
        roundSteps();
        for (std::size_t i = 0; i < m_cells; ++i) {
            double metres = m_cell * static_cast<double>(i);
            m_spots.push_back(path.at(metres));
            m_ways.push_back(path.heading(metres));
        }
    }

    std::optional<std::vector<double>> solve() {
        const double never = std::numeric_limits<double>::infinity();
        std::vector<double> cost(m_cells, never), next(m_cells);
        std::vector<std::vector<std::uint32_t>> from(m_ticks.size(), std::vector<std::uint32_t>(m_cells, 0));
        cost[0] = 0.0;
        for (std::size_t t = 1; t < m_ticks.size(); ++t) {
            std::fill(next.begin(), next.end(), never);
            double farthest = std::max(m_options.maxSpeed * m_ticks[t].seconds, 3.0 * m_ticks[t].stepM);
            auto most = static_cast<std::size_t>(std::ceil(farthest / m_cell));
            for (std::size_t cell = 0; cell < m_cells; ++cell)
                relax(m_ticks[t], cell, std::min(cell, most), cost, next, from[t]);
            std::swap(cost, next);
        }
        if (!std::isfinite(cost.back())) return std::nullopt;
        std::vector<double> atTick(m_ticks.size());
        std::size_t cell = m_cells - 1;
        for (std::size_t t = m_ticks.size(); t-- > 0;) {
            atTick[t] = m_cell * static_cast<double>(cell);
            if (t > 0) cell = from[t][cell];
        }
        return between(atTick);
    }

private:
    /// Whole cells, the rest carried over to the next step: where nothing else is known an even pace stays
    /// even. Steps between two whole numbers of cells would be rounded up for a while and then down for a
    /// while, at the same cost.
    void roundSteps() {
        double walked = 0.0, cells = 0.0;
        for (Tick& tick : m_ticks) {
            walked += tick.stepM;
            double upTo = std::round(walked / m_cell);
            tick.stepM = m_cell * (upTo - cells);
            cells = upTo;
        }
    }

    /// The frames between two ticks share the way between them as their steps do.
    std::vector<double> between(const std::vector<double>& atTick) const {
        std::vector<double> metres(m_steps.size(), 0.0);
        for (std::size_t t = 1; t < m_ticks.size(); ++t) {
            double walked = 0.0;
            for (std::size_t f = m_ticks[t - 1].frame + 1; f <= m_ticks[t].frame; ++f) {
                walked += m_steps[f];
                double share = m_ticks[t].stepM > 0.0 ? walked / m_ticks[t].stepM : 1.0;
                metres[f] = atTick[t - 1] + std::min(share, 1.0) * (atTick[t] - atTick[t - 1]);
            }
            metres[m_ticks[t].frame] = atTick[t];
        }
        return metres;
    }

    void relax(const Tick& tick, std::size_t cell, std::size_t most, const std::vector<double>& cost,
               std::vector<double>& next, std::vector<std::uint32_t>& from) const {
        double expected = tick.stepM, spread = m_cell + m_options.paceSpread * expected;
        for (std::size_t back = 0; back <= most; ++back) {
            double before = cost[cell - back];
            if (!std::isfinite(before)) continue;
            double off = (m_cell * static_cast<double>(back) - expected) / spread;
            double total = before + 0.5 * off * off;
            if (total >= next[cell]) continue;
            next[cell] = total;
            from[cell] = static_cast<std::uint32_t>(cell - back);
        }
        if (std::isfinite(next[cell])) next[cell] += evidence(tick, cell);
    }

    double evidence(const Tick& tick, std::size_t cell) const {
        double cost = 0.0;
        if (m_headings[tick.frame] && m_ways[cell]) {
            double off =
                wrappedDifference(*m_headings[tick.frame], *m_ways[cell]) / m_options.headingSpreadRad;
            // Frames that follow one another closely err together: each counts for its share of a second.
            cost += std::min(1.0, tick.seconds) * std::min(0.5 * off * off, kMostCost);
        }
        for (const Anchor& anchor : tick.anchors) {
            double off = offOf(anchor, cell);
            cost += std::min(0.5 * off * off, kMostCost);
        }
        return cost;
    }

    /// By how many standard deviations what was seen does not fit a walker who is there.
    double offOf(const Anchor& anchor, std::size_t cell) const {
        if (anchor.level != m_spots[cell].level) return std::numeric_limits<double>::infinity();
        Point2 to = anchor.position - m_spots[cell].position;
        double beyond = length(to) - anchor.rangeM;
        double off = anchor.rangeSpreadM ? beyond / std::hypot(m_options.anchorSpreadM, *anchor.rangeSpreadM)
                                         : std::max(0.0, beyond) / m_options.anchorSpreadM;
        if (!anchor.ahead || !m_ways[cell]) return off;
        double passed = -(to.x * std::cos(m_ways[cell]->value) + to.y * std::sin(m_ways[cell]->value));
        return std::hypot(off, std::max(0.0, passed) / m_options.anchorSpreadM);
    }

    AlignmentOptions m_options;
    std::vector<double> m_steps;
    std::vector<Tick> m_ticks;
    std::vector<std::optional<Radians>> m_headings;
    std::size_t m_cells = 0;
    double m_cell = 0.0;
    std::vector<routing::PathPoint> m_spots;
    std::vector<std::optional<Radians>> m_ways;
};

} // namespace

Result<std::vector<double>> alignWalk(const WalkedPath& path, const std::vector<WalkedFrame>& frames,
                                      const AlignmentOptions& options) {
    if (auto checked = options.check(); !checked) return checked.error();
    double seconds = frames.empty() ? 0.0 : frames.back().time - frames.front().time;
    if (path.lengthM() < 0.5)
        return Error{ErrorCode::InvalidArgument,
                     "the way has no length; name the places that the walk passes", "survey"};
    if (frames.size() < 2 || path.lengthM() > options.maxSpeed * seconds)
        return Error{ErrorCode::InvalidArgument,
                     "the recording has " + std::to_string(frames.size()) + " frames of " +
                         formatNumber(seconds) + " s, too few for a way of " +
                         formatNumber(std::round(path.lengthM())) +
                         " m; give the places it really passes, or the right frames per second",
                     "survey"};
    if (auto metres = Aligner(path, frames, options).solve()) return *std::move(metres);
    return Error{ErrorCode::InvalidArgument, "the recording does not fit the way: it has gaps without frames",
                 "survey"};
}

} // namespace farol::session
