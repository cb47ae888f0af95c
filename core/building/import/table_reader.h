#pragma once
// Layers of rooms, doors, walls and points, whatever their columns are called, put together to a RawMap.

#include "core/building/import/finishing.h"
#include "core/building/import/importer.h"
#include "core/building/import/table_words.h"

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

class GDALDataset;
class OGRFeature;
class OGRGeometry;
class OGRLayer;
class OGRSpatialReference;

namespace farol::building {

class TableReader {
public:
    TableReader(TableWords words, ImportOptions options);
    ~TableReader();

    /// All layers of one file.
    Result<void> read(const SourceMember& member);
    Result<RawMap> finish(const std::string& source);

private:
    struct Layer {
        std::string name;    ///< of the layer, or of the file where they are one
        std::string context; ///< for messages
        TableRole role = TableRole::Unknown;
        std::optional<double> level;
        std::string kind; ///< of all features, by the profile
        std::size_t features = 0;
    };
    struct Shapes {
        std::vector<Polygon> polygons;
        std::vector<Polyline> lines;
        std::vector<Point2> points;
    };
    using Row = const OGRFeature&;

    Result<void> readLayer(OGRLayer& source, const SourceMember& member, bool onlyOne);
    Layer described(const std::string& name, const SourceMember& member);
    bool takeReference(OGRLayer& source, const Layer& layer);
    void readLevelRow(Row row);
    void readFeature(Row row, Layer& layer);
    void readShapes(const OGRGeometry& geometry, Shapes& shapes) const;
    TableRole roleFor(const TableKind& kind, const Layer& layer, const Shapes& shapes);
    void addRegions(Row row, const Layer& layer, const TableKind& kind, Shapes shapes);
    void addAccesses(Row row, const Layer& layer, const TableKind& kind, const Shapes& shapes);
    void addLandmarks(Row row, const Layer& layer, const TableKind& kind, const Shapes& shapes);
    void addWalls(Row row, const Layer& layer, const Shapes& shapes);
    void tellUnknownKind(const std::string& word, const std::string& layer, const std::string& id);
    void resolveReferences();

    std::string text(Row row, const std::string& meaning) const;
    std::optional<double> number(Row row, const std::string& meaning) const;
    bool flag(Row row, const std::string& meaning) const;
    std::string idOf(Row row, const Layer& layer) const;
    double levelOf(Row row, const Layer& layer);
    void rememberHeight(std::map<std::size_t, double>& heights, std::size_t at) const;
    Result<void> levelsFromHeights();
    void readDirection(Row row, Access& access, RawMap::LevelChange& change);
    Attributes attributes(Row row) const;

    TableWords m_words;
    ImportOptions m_options;
    RawMap m_map;
    FindingList m_findings;
    std::unique_ptr<OGRSpatialReference> m_reference; ///< of the first layer that names one
    std::set<std::string> m_withoutReference;
    std::set<std::string> m_empty;
    std::size_t m_features = 0;
    std::optional<double> m_height; ///< of the feature being read, where nothing else tells its level
    struct Heights {                ///< by place in the lists of the map
        std::map<std::size_t, double> regions, accesses, landmarks, walls;
    } m_heights;
};

} // namespace farol::building
