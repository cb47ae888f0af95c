#include "core/base/text.h"
#include "core/building/import/finishing.h"
#include "core/building/layer_schema.h"

#include <cpl_string.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_set>

namespace farol::building {

namespace {

constexpr double kFurthestLevel = 1000.0;
constexpr std::size_t kMostLevels = 500;
/// More attributes than this go into one column as JSON: a table of a thousand columns serves nobody.
constexpr std::size_t kMostColumns = 300;
constexpr const char* kRestColumn = "source_attributes";

void makeUtf8(std::string& text) {
    text.erase(std::remove(text.begin(), text.end(), '\0'), text.end());
    if (CPLIsUTF8(text.c_str(), static_cast<int>(text.size())) != FALSE) return;
    char* recoded = CPLRecode(text.c_str(), CPL_ENC_ISO8859_1, CPL_ENC_UTF8);
    text = recoded;
    CPLFree(recoded);
}

template <class Items>
void giveIds(Items& items, const std::string& layer, const std::string& word, FindingList& findings) {
    std::unordered_set<std::string> used;
    for (auto& item : items) makeUtf8(item.id.value);
    for (const auto& item : items) used.insert(item.id.value);
    std::unordered_set<std::string> taken;
    std::size_t number = 0;
    for (auto& item : items) {
        if (!item.id.empty() && taken.insert(item.id.value).second) continue;
        std::string old = item.id.value, fresh;
        do fresh = (old.empty() ? word : old) + "-" + std::to_string(++number);
        while (used.count(fresh) != 0);
        used.insert(fresh);
        taken.insert(fresh);
        item.id.value = fresh;
        findings.add(Severity::Warning, word + "-id-unique",
                     old.empty() ? Sentence::IdGiven : Sentence::IdChanged, layer, fresh);
    }
}

/// The columns of one layer's unknown attributes: what each source name is called, and of which type it is.
class Columns {
public:
    explicit Columns(const LayerSpec& spec) : m_spec(spec) {}

    void see(const Attributes& extra) {
        for (const auto& [name, value] : extra) {
            Column& column = m_columns[name];
            column.text = column.text || std::holds_alternative<std::string>(value);
            column.real = column.real || std::holds_alternative<double>(value);
            ++column.uses;
        }
    }

    void name() {
        std::vector<std::string> order;
        for (const auto& [name, column] : m_columns) order.push_back(name);
        std::stable_sort(order.begin(), order.end(), [this](const std::string& a, const std::string& b) {
            return m_columns[a].uses > m_columns[b].uses;
        });
        std::set<std::string> used{"FID", "GEOM", foldedForMatching(kRestColumn)};
        std::size_t count = 0;
        for (const std::string& name : order) {
            if (++count > kMostColumns) break; // no name: into the rest
            std::string clean = name.empty() ? "attribute" : name;
            makeUtf8(clean);
            if (m_spec.knows(clean) || EQUAL(clean.c_str(), "fid") || EQUAL(clean.c_str(), "geom"))
                clean = "source_" + clean;
            std::string base = clean;
            for (int i = 2; !used.insert(foldedForMatching(clean)).second; ++i)
                clean = base + "_" + std::to_string(i);
            m_columns[name].name = clean;
        }
    }

    void rename(Attributes& extra) const {
        Attributes renamed;
        nlohmann::json rest = nlohmann::json::object();
        for (const auto& [name, value] : extra) {
            const Column& column = m_columns.at(name);
            AttributeValue kept = column.text ? asText(value) : column.real ? asReal(value) : value;
            if (!column.name.empty()) {
                renamed[column.name] = std::move(kept);
            } else {
                AttributeValue text = asText(value);
                rest[name] = std::holds_alternative<std::string>(text) ? std::get<std::string>(text) : "";
            }
        }
        if (!rest.empty())
            renamed[kRestColumn] = rest.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
        extra = std::move(renamed);
    }

private:
    struct Column {
        std::string name;
        bool text = false, real = false;
        std::size_t uses = 0;
    };

    static AttributeValue asText(const AttributeValue& value) {
        if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
        if (const auto* real = std::get_if<double>(&value)) return formatNumber(*real);
        AttributeValue kept = value;
        if (auto* text = std::get_if<std::string>(&kept)) makeUtf8(*text);
        return kept;
    }
    static AttributeValue asReal(const AttributeValue& value) {
        if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
        return value;
    }

    const LayerSpec& m_spec;
    std::map<std::string, Column> m_columns;
};

template <class Items>
void nameColumns(Items& items, const LayerSpec& spec) {
    Columns columns(spec);
    for (const auto& item : items) columns.see(item.extra);
    columns.name();
    for (auto& item : items) columns.rename(item.extra);
}

Result<void> mendLevels(BuildingData& data, FindingList& findings) {
    std::set<double> known, used;
    auto judge = [&](double& level, const std::string& layer, const std::string& id) {
        if (!std::isfinite(level) || std::abs(level) > kFurthestLevel) {
            findings.add(Severity::Warning, "level-number", Sentence::LevelsNoFloors, layer, id);
            level = 0.0;
        }
        level = std::round(level * 1000.0) / 1000.0;
        used.insert(level);
    };
    for (Region& region : data.regions) judge(region.level, "regions", region.id.value);
    for (Access& access : data.accesses) judge(access.level, "accesses", access.id.value);
    for (Landmark& landmark : data.landmarks) judge(landmark.level, "landmarks", landmark.id.value);
    for (Wall& wall : data.walls) judge(wall.level, "walls", "");
    std::vector<Level> levels;
    for (Level& level : data.levels) {
        judge(level.ordinal, "levels", level.ref.empty() ? level.name : level.ref);
        makeUtf8(level.name);
        makeUtf8(level.ref);
        if (known.insert(level.ordinal).second)
            levels.push_back(std::move(level));
        else
            findings.add(Severity::Note, "level-twice", Sentence::LevelsTwice, "levels",
                         formatNumber(level.ordinal));
    }
    for (double ordinal : used) {
        if (known.count(ordinal) != 0) continue;
        Level level;
        level.ordinal = ordinal;
        level.ref = formatNumber(ordinal);
        levels.push_back(std::move(level));
    }
    if (levels.size() > kMostLevels)
        return Error{ErrorCode::Corrupt, english(Sentence::TooManyLevels, static_cast<double>(levels.size())),
                     ""};
    data.levels = std::move(levels);
    return {};
}

} // namespace

Result<void> mendTables(BuildingData& data, FindingList& findings) {
    giveIds(data.regions, "regions", "region", findings);
    giveIds(data.accesses, "accesses", "access", findings);
    giveIds(data.landmarks, "landmarks", "landmark", findings);
    for (Region& region : data.regions)
        for (std::string* text : {&region.name, &region.ref, &region.kindText}) makeUtf8(*text);
    for (Access& access : data.accesses)
        for (std::string* text : {&access.kindText, &access.doorType, &access.shaft.value}) makeUtf8(*text);
    for (Landmark& landmark : data.landmarks)
        for (std::string* text : {&landmark.text, &landmark.kindText}) makeUtf8(*text);
    makeUtf8(data.title);
    if (auto done = mendLevels(data, findings); !done) return done;
    nameColumns(data.levels, levelsLayer());
    nameColumns(data.regions, regionsLayer());
    nameColumns(data.accesses, accessesLayer());
    nameColumns(data.landmarks, landmarksLayer());
    nameColumns(data.walls, wallsLayer());
    return {};
}

} // namespace farol::building
