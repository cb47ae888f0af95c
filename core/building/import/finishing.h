#pragma once
// The steps of finishImport(), each telling what it mended.

#include "core/base/error.h"
#include "core/building/import/importer.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace farol::building {

/// Gathers one finding per rule and wording, with all the ids it is about.
class FindingList {
public:
    /// `message` is of all of them: "regions cross themselves and were mended".
    void add(Severity severity, const std::string& rule, const Message& message, const std::string& layer,
             const std::string& id);
    void add(Finding finding) { m_findings.push_back(std::move(finding)); }
    std::vector<Finding> take(); ///< in the order of the first mention

private:
    std::vector<Finding> m_findings;
    std::map<std::string, std::size_t> m_grouped; ///< rule, message and layer -> index
};

/// Coordinates become metres: UTM for degrees and Web Mercator, unchanged for metric CRSs and local planes.
Result<void> toMetricPlane(RawMap& raw, FindingList& findings);

/// Every feature gets an id of its own; levels within reason; attributes get names that a table can have.
Result<void> mendTables(BuildingData& data, FindingList& findings);
/// Valid polygons without repeats; regions of which nothing is left are dropped, those in parts split.
Result<void> mendRegions(RawMap& raw, FindingList& findings);
/// Doors, openings and windows get the two regions they lie between.
void joinAccesses(BuildingData& data, FindingList& findings);
/// Stairs, lifts and escalators of which one side is missing get the region on the other level: by the level
/// that the source names, by the same shaft or the same kind above, never one of their own level.
void joinFarSides(RawMap& raw, FindingList& findings);
/// "up", "subir", "descending", ...: true for upwards.
std::optional<bool> climbDirection(const std::string& word);
/// A stairwell, lift or escalator, by its kind or by what the source calls it.
std::optional<AccessKind> shaftKind(const Region& region);
/// Openings where regions share a border, or one reaches into the other, without a wall or an access between
/// them.
void openSharedBorders(BuildingData& data, FindingList& findings);
/// Accesses along stairs, lifts and escalators: the source's own links, and, where `byOverlap`, what lies
/// above another.
void joinLevels(RawMap& raw, bool byOverlap, FindingList& findings);
void placeLandmarks(BuildingData& data, FindingList& findings);
void nameRegions(BuildingData& data, FindingList& findings);

} // namespace farol::building
