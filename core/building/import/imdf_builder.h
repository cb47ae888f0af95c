#pragma once
// IMDF features put together to a RawMap.

#include "core/building/import/finishing.h"
#include "core/building/import/importer.h"
#include "core/building/import/tagged_feature.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace farol::building {

/// Features by type: "unit", "opening", ... as the files of an IMDF archive are called.
using ImdfFiles = std::map<std::string, std::vector<TaggedFeature>>;

class ImdfBuilder {
public:
    ImdfBuilder(const ImdfFiles& files, std::string language)
        : m_files(files), m_language(std::move(language)) {}
    RawMap build();

private:
    const std::vector<TaggedFeature>& files(const std::string& type) const;
    std::string label(const TaggedFeature& feature, const std::string& key) const;
    double levelOf(const TaggedFeature& feature, const std::string& layer);
    void tell(Severity severity, const std::string& rule, const Message& message, const std::string& layer,
              const std::string& id);
    void readTitle();
    void readLevels();
    void readUnits();
    void readUnit(const TaggedFeature& unit);
    void addWalls(const TaggedFeature& feature, double level);
    void readOccupants();
    void readOpenings();
    void readOpening(const TaggedFeature& opening);
    void readAmenities();
    void readAmenity(const TaggedFeature& amenity);
    void readFixtures();
    void readDetails();
    void readRelationships();
    void readRelationship(const TaggedFeature& relationship);
    void directOpening(const std::vector<std::string>& steps);

    const ImdfFiles& m_files;
    std::string m_language;
    RawMap m_map;
    FindingList m_findings;
    std::map<std::string, double> m_levels;                 ///< id -> ordinal
    std::map<std::string, std::size_t> m_units, m_openings; ///< id -> index of the first part
};

} // namespace farol::building
