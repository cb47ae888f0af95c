#include "ui/main_window/figures.h"

#include "ui/convert/convert.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace farol::ui {

void Calibration::note(double confidence, bool isRight) {
    const auto bin = static_cast<std::size_t>(std::clamp(static_cast<int>(confidence * 10.0), 0, 9));
    ++told[bin];
    if (isRight) ++right[bin];
}

Chart Figures::votes(const WalkTimeline& timeline, const building::Building* building) {
    Chart chart{
        tr("Votes over time"), tr("seconds"), tr("votes"), tr("Start a walk first."), {}, {}, {}, 0.0, false};
    std::map<std::string, double> highest;
    for (const Moment& moment : timeline.moments())
        for (const localisation::RegionVote& vote : moment.light->step.fix.votes)
            highest[vote.region.value] = std::max(highest[vote.region.value], vote.vote);
    std::vector<std::pair<double, std::string>> order;
    for (const auto& [region, vote] : highest) order.emplace_back(-vote, region);
    std::sort(order.begin(), order.end());
    if (order.size() > 5) order.resize(5);
    for (const auto& [vote, region] : order) {
        ChartSeries series{regionName(building, RegionId(region)), {}};
        for (const Moment& moment : timeline.moments()) {
            double value = 0.0;
            for (const localisation::RegionVote& one : moment.light->step.fix.votes)
                if (one.region.value == region) value = one.vote;
            series.points.emplace_back(moment.time, value);
        }
        chart.lines.push_back(std::move(series));
    }
    return chart;
}

Chart Figures::latency(const WalkTimeline& timeline) {
    Chart chart{tr("How long pictures took to understand"),
                tr("milliseconds"),
                tr("pictures"),
                tr("Start a walk first."),
                {},
                {},
                {},
                0.0,
                false};
    double longest = 0.0;
    for (const Moment& moment : timeline.moments()) longest = std::max(longest, moment.latencyMs);
    if (timeline.moments().empty()) return chart;
    chart.barsEnd = std::max(10.0, std::ceil(longest / 10.0) * 10.0);
    chart.bars.assign(20, 0.0);
    for (const Moment& moment : timeline.moments()) {
        const auto bin =
            static_cast<std::size_t>(std::clamp(moment.latencyMs / chart.barsEnd * 20.0, 0.0, 19.0));
        chart.bars[bin] += 1.0;
    }
    return chart;
}

Chart Figures::calibration(const Calibration& calibration) {
    Chart chart{tr("How sure, and how right"),
                tr("told confidence"),
                tr("share that was right"),
                tr("The truth is known in simulated walks only: start the demonstration."),
                {},
                {},
                {},
                1.0,
                true};
    ChartSeries series{tr("this walk"), {}};
    for (std::size_t i = 0; i < calibration.told.size(); ++i)
        if (calibration.told[i] > 0)
            series.points.emplace_back((static_cast<double>(i) + 0.5) / 10.0,
                                       1.0 * calibration.right[i] / calibration.told[i]);
    if (!series.points.empty()) chart.lines.push_back(std::move(series));
    return chart;
}

Chart Figures::ranges(const std::vector<recognition::TemplateCheck>& checks) {
    Chart chart{tr("From how far each landmark is found"),
                tr("landmarks"),
                tr("metres"),
                tr("Check the library on the Landmarks page first (F7); landmarks need a real size."),
                {},
                {},
                {},
                0.0,
                false};
    for (const recognition::TemplateCheck& check : checks) {
        if (!check.farthestM) continue;
        chart.bars.push_back(*check.farthestM);
        chart.barNames << toQString(check.id.value);
    }
    return chart;
}

} // namespace farol::ui
