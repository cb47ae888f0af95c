#pragma once
// What columns, codes, layers and floors are called in tables of rooms and doors: synonyms, and the JSON
// profile that overrules them.

#include "core/base/error.h"
#include "core/base/kind.h"
#include "core/building/building.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace farol::building {

/// What one feature or a whole layer stands for.
enum class TableRole { Unknown, Region, Access, Landmark, Wall, Level, Ignore };

struct TableKind {
    TableRole role = TableRole::Unknown;
    RegionKind region = RegionKind::Room;
    AccessKind access = AccessKind::Door;
    Kind landmark = Kind::Other;
    bool restricted = false;
};

/// A JSON profile, all members optional:
///   {"columns": {"id": ["NUMERO"], "name": "DESIGNACAO", "level": "COTA"},
///    "codes":   {"SHOP": "room", "PT": "door", "EXT": "extinguisher", "MURO": "wall", "LIXO": "ignore"},
///    "levels":  {"CAVE": -1, "RC": 0},
///    "layers":  {"plantas_*": {"role": "regions", "level": 2, "kind": "corridor"}}}
/// Columns: id, region, region_a, region_b, name, ref, level, kind, restricted, shaft, oneway, door_type,
/// automatic, width_m, steps, closed, text, template, heading_deg. Roles: regions, accesses, landmarks,
/// walls, levels, ignore.
class TableWords {
public:
    struct LayerRule {
        std::string pattern; ///< '*' stands for anything
        TableRole role = TableRole::Unknown;
        std::optional<double> level;
        std::string kind;
    };

    static Result<TableWords> fromProfile(const std::string& path); ///< the synonyms alone for an empty path

    /// Names a column may have, the profile's first, lower case.
    const std::vector<std::string>& columns(const std::string& meaning) const;
    /// Of a code or word in a kind column; role Unknown when nobody knows it.
    TableKind kind(const std::string& word) const;
    std::optional<double> level(const std::string& text) const; ///< "-1", "B1", "GF", "2F", "piso 3"
    const LayerRule* ruleFor(const std::string& layer) const;
    static TableRole roleOfLayer(const std::string& name); ///< by keywords in the name
    /// Of a file's or layer's name: _B1_, _GF_, floor-2, MapA (the first floor of the paper's maps).
    std::optional<double> levelOfName(const std::string& name) const;

private:
    std::map<std::string, std::vector<std::string>> m_columns;
    std::map<std::string, std::string> m_codes;
    std::map<std::string, double> m_levels;
    std::vector<LayerRule> m_layers;
};

std::string lowerCase(std::string text);

} // namespace farol::building
