#include "core/base/text.h"
#include "core/building/import/finishing.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <utility>

namespace farol::building {

void FindingList::add(Severity severity, const std::string& rule, const Message& message,
                      const std::string& layer, const std::string& id) {
    auto [place, fresh] =
        m_grouped.emplace(rule + '\n' + message.english() + '\n' + layer, m_findings.size());
    if (fresh) m_findings.push_back({severity, rule, message, layer, {}});
    std::vector<std::string>& ids = m_findings[place->second].ids;
    if (ids.empty() || ids.back() != id) ids.push_back(id);
}

std::vector<Finding> FindingList::take() {
    m_grouped.clear();
    return std::exchange(m_findings, {});
}

namespace {

Result<void> mend(RawMap& raw, FindingList& findings) {
    if (auto done = mendTables(raw.data, findings); !done) return done;
    if (auto done = toMetricPlane(raw, findings); !done) return done;
    if (auto done = mendRegions(raw, findings); !done) return done;
    if (!raw.explicitGraph) joinAccesses(raw.data, findings);
    if (!raw.explicitGraph) joinFarSides(raw, findings);
    if (raw.openBoundaries && !raw.explicitGraph) openSharedBorders(raw.data, findings);
    joinLevels(raw, !raw.explicitGraph, findings);
    placeLandmarks(raw.data, findings);
    nameRegions(raw.data, findings);
    return {};
}

} // namespace

Result<ImportedBuilding> finishImport(RawMap raw, MapFormat format) {
    try {
        FindingList findings;
        for (Finding& finding : raw.findings) findings.add(std::move(finding));
        if (auto done = mend(raw, findings); !done) return done.error();
        auto byId = [](const auto& a, const auto& b) { return naturalLess(a.id.value, b.id.value); };
        std::stable_sort(raw.data.regions.begin(), raw.data.regions.end(), byId);
        std::stable_sort(raw.data.accesses.begin(), raw.data.accesses.end(), byId);
        std::stable_sort(raw.data.landmarks.begin(), raw.data.landmarks.end(), byId);
        ImportedBuilding imported;
        imported.format = format;
        imported.building = std::make_shared<const Building>(std::move(raw.data));
        imported.findings = findings.take();
        for (Finding& finding : checkBuilding(*imported.building))
            imported.findings.push_back(std::move(finding));
        std::stable_sort(imported.findings.begin(), imported.findings.end(),
                         [](const Finding& a, const Finding& b) { return a.severity < b.severity; });
        return imported;
    } catch (const std::exception& failure) {
        return Error{ErrorCode::Corrupt, english(Sentence::NotPutTogether, failure.what()), ""};
    }
}

} // namespace farol::building
