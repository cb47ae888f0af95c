#pragma once
// A building of an IndoorGML document: cells become regions, transitions become accesses, and a door that is
// a cell of its own (ConnectionSpace) becomes the access between the two cells beside it.

#include "core/building/import/importer.h"
#include "core/building/import/indoorgml_geometry.h"
#include "core/building/import/indoorgml_xml.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace farol::building {

class IndoorGmlBuilder {
public:
    IndoorGmlBuilder(const XmlNode& root, const ImportOptions& options, std::string context);
    Result<RawMap> build();

private:
    struct Cell {
        Region region;
        bool door = false; ///< a ConnectionSpace
        std::string stateId, storey;
        std::optional<double> z;
        std::optional<Point2> state;
    };
    struct Link {
        std::string id;
        std::size_t a, b; ///< cells
        Polyline line;
        const XmlNode* boundary = nullptr;
    };

    void indexIds(const XmlNode& node);
    void findCrs(const XmlNode& node);
    void readCells(const XmlNode& node);
    void readCell(const XmlNode& node);
    void readStates(const XmlNode& node);
    void readState(const XmlNode& node);
    void readTransitions(const XmlNode& node);
    void readTransition(const XmlNode& node);
    std::string storeyOf(const XmlNode& node) const;
    void setLevels();
    bool setLevelsByStorey();
    void setLevelsByHeight();
    void addRegions();
    void addAccesses();
    void addAccess(const std::string& id, std::size_t a, std::size_t b, const Polyline& line,
                   const XmlNode* boundary, const Cell* door);
    AccessKind kindBetween(const Cell& a, const Cell& b, bool door) const;
    Point2 passage(const Cell& a, const Cell& b, const Polyline& line) const;
    void note(Severity severity, const std::string& rule, const Message& message, const std::string& id);

    const XmlNode& m_root;
    ImportOptions m_options;
    std::string m_context;
    XmlIndex m_ids;
    bool m_swapped = false;
    std::optional<GmlGeometry> m_geometry;
    RawMap m_map;
    std::vector<Cell> m_cells;
    std::map<std::string, std::size_t> m_cellOf; ///< by the id of the cell and of its state
    std::vector<Link> m_links;
    std::set<std::string> m_linkKeys;
    std::set<std::size_t> m_collapsed; ///< door cells that became accesses
    std::map<std::string, Finding> m_notes;
};

} // namespace farol::building
