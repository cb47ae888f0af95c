#include "core/building/import/table_words.h"

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/building/import/imdf_categories.h"
#include "core/building/sentence.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <set>
#include <utility>

namespace farol::building {

namespace {

using Json = nlohmann::json;

const std::map<std::string, std::vector<std::string>>& synonyms() {
    static const std::map<std::string, std::vector<std::string>> columns{
        {"id",
         {"access_id", "landmark_id", "region_id", "espacoid", "espaco_id", "spaceid", "space_id", "roomid",
          "room_id", "unit_id", "id", "gid", "objectid"}},
        {"region",
         {"region_id", "espacoid", "espaco_id", "spaceid", "space_id", "roomid", "room_id", "unit_id",
          "espaco"}},
        {"region_a",
         {"region_a", "espacoa", "espaco_a", "espaco1", "room_a", "roomfrom", "from_id", "from_room"}},
        {"region_b", {"region_b", "espacob", "espaco_b", "espaco2", "room_b", "roomto", "to_id", "to_room"}},
        {"name",
         {"name", "nome", "designacao", "designation", "label", "title", "long_name", "bezeichnung", "nom"}},
        {"ref",
         {"ref", "number", "numero", "num", "room_no", "roomnumber", "room_num", "short_name", "sala"}},
        {"level",
         {"level", "piso", "floor", "ordinal", "andar", "storey", "level_no", "nivel", "etage", "geschoss"}},
        {"kind", {"kind", "tipo", "type", "category", "categoria", "class", "classe", "company_co"}},
        {"restricted", {"restricted", "restriction", "restrict", "private"}},
        {"shaft", {"shaft", "shaft_id"}},
        {"oneway", {"oneway", "one_way", "direction", "sentido", "direccao", "conveying"}},
        {"level_to", {"level_to", "to_level", "piso_destino", "level_b", "nivel_destino"}},
        {"door_type", {"door_type", "doortype"}},
        {"automatic", {"automatic", "door_autom"}},
        {"width_m", {"width_m", "width", "largura"}},
        {"steps", {"steps", "degraus", "step_count"}},
        {"closed", {"closed", "fechado"}},
        {"text", {"text", "texto", "label", "name", "nome"}},
        {"template", {"template", "template_id", "objecto", "objeto", "object"}},
        {"heading_deg", {"heading_deg", "heading"}},
    };
    return columns;
}

TableKind regionOf(RegionKind kind) {
    return {TableRole::Region, kind, AccessKind::Door, Kind::Other, false};
}
TableKind accessOf(AccessKind kind) {
    return {TableRole::Access, RegionKind::Room, kind, Kind::Other, false};
}
TableKind landmarkOf(Kind kind) {
    return {TableRole::Landmark, RegionKind::Room, AccessKind::Door, kind, false};
}
TableKind plain(TableRole role) {
    return {role, RegionKind::Room, AccessKind::Door, Kind::Other, false};
}

const std::map<std::string, TableKind>& kindWords() {
    static const std::map<std::string, TableKind> words = [] {
        std::map<std::string, TableKind> all;
        auto add = [&](const TableKind& kind, std::initializer_list<const char*> names) {
            for (const char* name : names) all.emplace(foldedForMatching(name), kind);
        };
        add(regionOf(RegionKind::Room),
            {"room", "sala", "quarto", "gabinete", "escritorio", "laboratorio", "lab", "auditorio",
             "anfiteatro", "espaco", "space", "unit", "shop", "loja", "food", "arrumos", "biblioteca"});
        add(regionOf(RegionKind::Corridor),
            {"corridor", "corredor", "hallway", "passage", "passagem", "flur", "couloir"});
        add(regionOf(RegionKind::Hall), {"hall", "atrio", "foyer", "lobby", "entrance hall", "halle"});
        add(regionOf(RegionKind::Stairwell), {"stairwell", "staircase", "caixa de escadas"});
        add(regionOf(RegionKind::Toilet),
            {"toilet", "toilets", "wc", "restroom", "bathroom", "casa de banho", "instalacao sanitaria"});
        add(regionOf(RegionKind::Outside), {"outside", "outdoor", "exterior"});
        add(accessOf(AccessKind::Door),
            {"door", "porta", "tur", "porte", "gate", "entrance", "entrada", "pedestrian",
             "pedestrian.principal", "pedestrian.transit", "service"});
        add(accessOf(AccessKind::Opening), {"opening", "abertura", "vao"});
        add(accessOf(AccessKind::Window), {"window", "janela", "fenster", "fenetre"});
        add(plain(TableRole::Wall), {"wall", "parede", "muro", "wand", "mur", "column", "coluna", "pilar"});
        add(plain(TableRole::Ignore), {"ignore"});
        add(landmarkOf(Kind::Extinguisher), {"extintor"});
        add(landmarkOf(Kind::Picture), {"quadro"});
        add(landmarkOf(Kind::Sign), {"placa", "sinal"});
        for (Kind kind : allKinds())
            if (kind != Kind::Other) all.emplace(foldedForMatching(kindName(kind)), landmarkOf(kind));
        return all;
    }();
    return words;
}

/// Words that are a region as an area, an access as a line and a landmark as a point.
std::optional<TableKind> climbing(const std::string& folded) {
    static const std::map<std::string, std::pair<RegionKind, AccessKind>> words{
        {"STAIRS", {RegionKind::Stairwell, AccessKind::Stairs}},
        {"STEPS", {RegionKind::Stairwell, AccessKind::Stairs}},
        {"ESCADA", {RegionKind::Stairwell, AccessKind::Stairs}},
        {"ESCADAS", {RegionKind::Stairwell, AccessKind::Stairs}},
        {"ELEVATOR", {RegionKind::Elevator, AccessKind::Elevator}},
        {"LIFT", {RegionKind::Elevator, AccessKind::Elevator}},
        {"ELEVADOR", {RegionKind::Elevator, AccessKind::Elevator}},
        {"ASCENSOR", {RegionKind::Elevator, AccessKind::Elevator}},
        {"ESCALATOR", {RegionKind::Stairwell, AccessKind::Escalator}},
        {"RAMP", {RegionKind::Corridor, AccessKind::Ramp}},
        {"RAMPA", {RegionKind::Corridor, AccessKind::Ramp}},
    };
    auto found = words.find(folded);
    if (found == words.end()) return std::nullopt;
    Kind landmark = found->second.first == RegionKind::Elevator    ? Kind::Elevator
                    : found->second.first == RegionKind::Stairwell ? Kind::Stairs
                                                                   : Kind::Other;
    return TableKind{TableRole::Unknown, found->second.first, found->second.second, landmark, false};
}

std::vector<std::string> textsIn(const Json& json) {
    std::vector<std::string> texts;
    if (json.is_string())
        texts.push_back(lowerCase(json.get<std::string>()));
    else if (json.is_array())
        for (const Json& each : json)
            if (each.is_string()) texts.push_back(lowerCase(each.get<std::string>()));
    return texts;
}

std::optional<TableRole> roleFromName(const std::string& name) {
    static const std::map<std::string, TableRole> roles{
        {"regions", TableRole::Region}, {"accesses", TableRole::Access}, {"landmarks", TableRole::Landmark},
        {"walls", TableRole::Wall},     {"levels", TableRole::Level},    {"ignore", TableRole::Ignore}};
    auto found = roles.find(name);
    return found == roles.end() ? std::nullopt : std::optional(found->second);
}

bool matches(const std::string& pattern, const std::string& text) {
    std::size_t p = 0, t = 0, star = std::string::npos, mark = 0;
    while (t < text.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            mark = t;
        } else if (p < pattern.size() && pattern[p] == text[t]) {
            ++p;
            ++t;
        } else if (star != std::string::npos) {
            p = star + 1;
            t = ++mark;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') ++p;
    return p == pattern.size();
}

/// Letters and digits apart: "JRTokyoSta_B1_Space" -> JRTOKYOSTA, B1, SPACE.
std::vector<std::string> wordsOf(const std::string& name) {
    std::vector<std::string> words(1);
    for (std::size_t i = 0; i < name.size(); ++i) {
        unsigned char c = static_cast<unsigned char>(name[i]);
        bool minus = c == '-' && words.back().empty() && i + 1 < name.size() &&
                     std::isdigit(static_cast<unsigned char>(name[i + 1])) != 0 && i > 0 &&
                     name[i - 1] == '_';
        if (std::isalnum(c) != 0 || minus)
            words.back().push_back(static_cast<char>(std::toupper(c)));
        else if (!words.back().empty())
            words.emplace_back();
    }
    return words;
}

std::optional<double> number(const std::string& text) {
    double value = 0.0;
    auto [rest, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    bool whole =
        failure == std::errc() && rest == text.data() + text.size() && !text.empty() && std::isfinite(value);
    return whole ? std::optional(value) : std::nullopt;
}

/// "B1" -1, "GF" 0, "2F", "F2", "L2", "PISO2" 2.
std::optional<double> levelWord(const std::string& word) {
    static const std::set<std::string> ground{"G", "GF", "RC", "R/C", "GROUND", "TERREO", "EG", "RDC"};
    if (ground.count(word) != 0) return 0.0;
    if (word.size() > 1 && word.front() == 'B')
        if (auto below = number(word.substr(1))) return -std::abs(*below);
    for (const char* mark : {"F", "L", "LEVEL", "FLOOR", "PISO", "ANDAR", "NIVEL", "STOREY", "OG"}) {
        std::string prefix = mark;
        if (word.rfind(prefix, 0) == 0)
            if (auto level = number(word.substr(prefix.size()))) return level;
        if (word.size() > prefix.size() &&
            word.compare(word.size() - prefix.size(), prefix.size(), prefix) == 0)
            if (auto level = number(word.substr(0, word.size() - prefix.size()))) return level;
    }
    return std::nullopt;
}

} // namespace

std::string lowerCase(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

Result<TableWords> TableWords::fromProfile(const std::string& path) {
    TableWords words;
    words.m_columns = synonyms();
    if (path.empty()) return words;
    auto text = readFile(path);
    if (!text) return text.error();
    Json json = Json::parse(*text, nullptr, false);
    if (!json.is_object()) return Error{ErrorCode::InvalidArgument, english(Sentence::ProfileNoObject), path};
    const auto part = [&](const char* key) {
        auto found = json.find(key);
        return found != json.end() && found->is_object() ? *found : Json(Json::object());
    };
    const Json columns = part("columns"), codes = part("codes"), levels = part("levels"),
               layers = part("layers");
    for (const auto& [meaning, names] : columns.items()) {
        auto known = words.m_columns.find(meaning);
        if (known == words.m_columns.end())
            return Error{ErrorCode::InvalidArgument, english(Sentence::ProfileColumn, meaning), path};
        std::vector<std::string> own = textsIn(names);
        known->second.insert(known->second.begin(), own.begin(), own.end());
    }
    for (const auto& [code, word] : codes.items())
        if (word.is_string()) words.m_codes[foldedForMatching(code)] = word.get<std::string>();
    for (const auto& [name, ordinal] : levels.items())
        if (ordinal.is_number()) words.m_levels[foldedForMatching(name)] = ordinal.get<double>();
    for (const auto& [pattern, rule] : layers.items()) {
        LayerRule layer;
        layer.pattern = lowerCase(pattern);
        if (rule.is_object() && rule.contains("role")) {
            auto role =
                rule["role"].is_string() ? roleFromName(rule["role"].get<std::string>()) : std::nullopt;
            if (!role)
                return Error{ErrorCode::InvalidArgument, english(Sentence::ProfileRole, pattern), path};
            layer.role = *role;
        }
        if (rule.is_object() && rule.contains("level") && rule["level"].is_number())
            layer.level = rule["level"].get<double>();
        if (rule.is_object() && rule.contains("kind") && rule["kind"].is_string())
            layer.kind = rule["kind"].get<std::string>();
        words.m_layers.push_back(std::move(layer));
    }
    return words;
}

const std::vector<std::string>& TableWords::columns(const std::string& meaning) const {
    static const std::vector<std::string> none;
    auto found = m_columns.find(meaning);
    return found == m_columns.end() ? none : found->second;
}

TableKind TableWords::kind(const std::string& word) const {
    auto code = m_codes.find(foldedForMatching(word));
    std::string meaning = code == m_codes.end() ? word : code->second;
    std::string folded = foldedForMatching(meaning);
    if (folded.empty()) return {};
    if (auto climb = climbing(folded)) return *climb;
    auto known = kindWords().find(folded);
    if (known != kindWords().end()) return known->second;
    UnitRole unit = imdfUnitRole(lowerCase(meaning));
    if (!unit.known) return {};
    if (!unit.walkable) return plain(TableRole::Wall);
    return {TableRole::Region, unit.kind, AccessKind::Door, Kind::Other, unit.restricted};
}

std::optional<double> TableWords::level(const std::string& text) const {
    std::string folded = foldedForMatching(text);
    auto own = m_levels.find(folded);
    if (own != m_levels.end()) return own->second;
    if (auto plainNumber = number(folded)) return plainNumber;
    folded.erase(std::remove(folded.begin(), folded.end(), ' '), folded.end());
    return levelWord(folded);
}

const TableWords::LayerRule* TableWords::ruleFor(const std::string& layer) const {
    for (const LayerRule& rule : m_layers)
        if (matches(rule.pattern, lowerCase(layer))) return &rule;
    return nullptr;
}

TableRole TableWords::roleOfLayer(const std::string& name) {
    static const std::vector<std::pair<TableRole, std::vector<const char*>>> keywords{
        {TableRole::Access, {"opening", "door", "entry", "gate", "access", "porta", "window", "janela"}},
        {TableRole::Wall, {"wall", "parede", "muro", "detail", "edge", "curb"}},
        {TableRole::Landmark,
         {"landmark", "fixture", "fxt", "furniture", "amenity", "referenc", "poi", "ponto", "objecto"}},
        {TableRole::Region, {"space", "unit", "room", "region", "espaco", "sala", "area"}},
        {TableRole::Level, {"level", "storey"}},
        {TableRole::Ignore, {"building", "bldg", "venue", "footprint", "anchor"}},
    };
    std::string lower = lowerCase(name);
    for (const auto& [role, words] : keywords)
        for (const char* word : words)
            if (lower.find(word) != std::string::npos) return role;
    return TableRole::Unknown;
}

std::optional<double> TableWords::levelOfName(const std::string& name) const {
    std::vector<std::string> words = wordsOf(name);
    for (const std::string& word : words) {
        auto own = m_levels.find(word);
        if (own != m_levels.end()) return own->second;
        if (auto level = levelWord(word)) return level;
    }
    // A bare number is a floor when it stands apart and is no year or EPSG code.
    for (std::size_t i = 1; i < words.size(); ++i)
        if (auto level = number(words[i]); level && std::abs(*level) < 200.0) return level;
    std::string first = words.front();
    if (first.size() == 4 && first.rfind("MAP", 0) == 0 && first[3] >= 'A' && first[3] <= 'Z')
        return static_cast<double>(first[3] - 'A');
    return std::nullopt;
}

} // namespace farol::building
