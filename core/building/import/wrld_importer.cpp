#include "core/base/ogr.h"
#include "core/base/text.h"
#include "core/building/import/importer.h"
#include "core/building/import/local_plane.h"
#include "core/building/import/tagged_feature.h"
#include "core/building/import/wrld_floor.h"

#include <nlohmann/json.hpp>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <set>

namespace farol::building {

namespace {

using Json = nlohmann::json;

constexpr std::uint64_t kMaxMainBytes = 4ULL << 20U, kMaxFloorBytes = 32ULL << 20U;
constexpr std::size_t kMaxLevels = 300, kMaxFloorFeatures = 10000, kMaxFeatures = 40000;
constexpr double kStackedShare = 0.3; ///< of the smaller polygon, for stairs or a lift above another

struct LevelEntry {
    std::string id, name, readable, file;
    double zOrder = 0.0;
};

std::string textOf(const Json& object, const char* key) {
    auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

Result<std::vector<LevelEntry>> levelsOf(const Json& main, const std::string& context) {
    auto levels = main.is_object() ? main.find("levels") : main.end();
    if (levels == main.end() || !levels->is_array() || levels->empty())
        return Error{ErrorCode::UnsupportedFormat, english(Sentence::WrldNoLevels), context};
    if (levels->size() > kMaxLevels)
        return Error{ErrorCode::Corrupt, english(Sentence::WrldTooManyLevels), context};
    std::vector<LevelEntry> entries;
    std::set<double> orders;
    for (const Json& level : *levels) {
        LevelEntry entry{textOf(level, "id"), textOf(level, "name"), textOf(level, "readable_name"),
                         textOf(level, "filename"), 0.0};
        auto order = level.is_object() ? level.find("z_order") : level.end();
        bool number = order != level.end() && order->is_number_integer();
        entry.zOrder = number ? order->get<double>() : 0.0;
        if (!number || std::abs(entry.zOrder) > 1000.0 || !orders.insert(entry.zOrder).second)
            return Error{ErrorCode::Corrupt, english(Sentence::WrldLevelOrder),
                         english(Sentence::LevelOf, context, entry.id)};
        if (entry.name.empty()) entry.name = formatNumber(entry.zOrder);
        entries.push_back(std::move(entry));
    }
    return entries;
}

/// z_order counts from the lowest floor. The ground is the level that is called so, else the one of the
/// entrance.
double groundOrder(const std::vector<LevelEntry>& levels, const Json& main) {
    for (const LevelEntry& level : levels) {
        std::string name = foldedForMatching(level.name), readable = foldedForMatching(level.readable);
        if (name == "G" || name == "GF" || readable.rfind("GROUND", 0) == 0) return level.zOrder;
    }
    auto entrance = main.find("entrance_level");
    std::size_t index =
        entrance != main.end() && entrance->is_number_unsigned() ? entrance->get<std::size_t>() : 0;
    return levels[index < levels.size() ? index : 0].zOrder;
}

bool near(const Polygon& a, const Polygon& b) {
    auto first = boundingBox(a.outer), second = boundingBox(b.outer);
    return first && second && first->low.x <= second->high.x && second->low.x <= first->high.x &&
           first->low.y <= second->high.y && second->low.y <= first->high.y;
}

double sharedArea(const Polygon& a, const Polygon& b) {
    GeometryPtr first = ogrPolygon(a), second = ogrPolygon(b);
    if (first == nullptr || second == nullptr) return 0.0;
    GeometryPtr common(first->Intersection(second.get()));
    double shared = 0.0;
    for (const Polygon& part : polygonsOf(common.get(), 0.0)) shared += area(part);
    return shared;
}

class Reader {
public:
    Reader(const SourceListing& source, Json main)
        : m_source(source), m_main(std::move(main)), m_plane(centre()) {}

    Result<RawMap> read(const std::string& context) {
        auto levels = levelsOf(m_main, context);
        if (!levels) return levels.error();
        double ground = groundOrder(*levels, m_main);
        std::sort(levels->begin(), levels->end(),
                  [](const LevelEntry& a, const LevelEntry& b) { return a.zOrder < b.zOrder; });
        std::set<std::string> names;
        for (LevelEntry& level : *levels) {
            if (!names.insert(level.name).second) level.name += "(" + formatNumber(level.zOrder) + ")";
            if (auto done = readLevel(level, level.zOrder - ground); !done) return done.error();
        }
        if (m_map.data.regions.empty())
            return Error{ErrorCode::UnsupportedFormat, english(Sentence::WrldNoRooms), context};
        m_map.data.title = textOf(m_main, "name");
        m_map.coordinates = RawCoordinates::Geographic;
        m_map.openBoundaries =
            true; // stairs and lifts join the landing they are drawn in; walls have a thickness here
        stack();
        tell(context);
        m_plane.toDegrees(m_map.data);
        return std::move(m_map);
    }

private:
    Point2 centre() const {
        auto location = m_main.is_object() ? m_main.find("location") : m_main.end();
        if (location == m_main.end() || !location->is_object()) return {};
        auto at = location->find("coordinates");
        if (at == location->end() || !at->is_array() || at->size() < 2 || !(*at)[0].is_number() ||
            !(*at)[1].is_number())
            return {};
        Point2 point{(*at)[0].get<double>(), (*at)[1].get<double>()};
        return isGeographic(point) ? point : Point2{};
    }

    Result<void> readLevel(const LevelEntry& entry, double ordinal) {
        const SourceMember* member = entry.file.empty() ? nullptr : m_source.find(entry.file);
        if (member == nullptr)
            return Error{ErrorCode::NotFound, english(Sentence::WrldFloorMissing, entry.file),
                         "level " + entry.id};
        auto text = m_source.content(*member, kMaxFloorBytes);
        if (!text) return text.error();
        auto collection = readTaggedGeoJson(*text, member->name, m_map.findings);
        if (!collection) return collection.error();
        m_features += collection->features.size();
        if (collection->features.size() > kMaxFloorFeatures || m_features > kMaxFeatures)
            return Error{ErrorCode::Corrupt, english(Sentence::WrldTooManyFeatures), member->name};
        WrldFloor floor(std::move(collection->features), m_plane, ordinal, entry.name);
        floor.build();
        Level level;
        level.ordinal = ordinal;
        level.name = entry.readable;
        level.ref = entry.name;
        m_map.data.levels.push_back(std::move(level));
        m_closed += floor.closedSpaces;
        auto append = [](auto& all, auto& some) {
            all.insert(all.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
        };
        append(m_map.data.regions, floor.regions);
        append(m_map.data.accesses, floor.accesses);
        append(m_map.data.walls, floor.walls);
        append(m_narrow, floor.narrow);
        return {};
    }

    /// Stairs above stairs and lifts above lifts, from each level to the next.
    void stack() {
        GdalMessages quiet;
        const std::vector<Region>& regions = m_map.data.regions;
        std::vector<std::size_t> climbing;
        for (std::size_t i = 0; i < regions.size(); ++i)
            if (regions[i].kind == RegionKind::Stairwell || regions[i].kind == RegionKind::Elevator ||
                regions[i].kindText == "escalator")
                climbing.push_back(i);
        std::map<std::size_t, std::size_t> shaftOf;
        for (std::size_t i : climbing)
            for (std::size_t j : climbing) {
                const Region& a = regions[i];
                const Region& b = regions[j];
                if (a.kind != b.kind || a.kindText != b.kindText || b.level != a.level + 1.0) continue;
                if (!near(a.polygon, b.polygon)) continue;
                double smaller = std::min(area(a.polygon), area(b.polygon));
                if (sharedArea(a.polygon, b.polygon) < kStackedShare * smaller) continue;
                std::size_t shaft = shaftOf.emplace(i, i).first->second;
                shaftOf[j] = shaft;
                RawMap::VerticalLink link;
                link.from = a.id;
                link.to = b.id;
                link.kind = a.kind == RegionKind::Elevator    ? AccessKind::Elevator
                            : a.kind == RegionKind::Stairwell ? AccessKind::Stairs
                                                              : AccessKind::Escalator;
                link.shaft = ShaftId(regions[shaft].id.value);
                m_map.verticalLinks.push_back(std::move(link));
            }
    }

    void tell(const std::string& context) {
        m_map.findings.push_back({Severity::Note,
                                  "wrld-closed-spaces",
                                  counted(Sentence::WrldSpacesClosed, m_closed),
                                  context,
                                  {}});
        if (!m_narrow.empty())
            m_map.findings.push_back(
                {Severity::Note, "wrld-narrow-spaces", Sentence::WrldNarrow, context, std::move(m_narrow)});
        Finding half{Severity::Warning, "wrld-door-one-side", Sentence::WrldDoorOneSide, context, {}};
        for (const Access& access : m_map.data.accesses)
            if (access.regionA.empty() || access.regionB.empty()) half.ids.push_back(access.id.value);
        if (!half.ids.empty()) m_map.findings.push_back(std::move(half));
    }

    const SourceListing& m_source;
    Json m_main;
    LocalPlane m_plane;
    RawMap m_map;
    std::vector<std::string> m_narrow;
    std::size_t m_closed = 0, m_features = 0;
};

class WrldImporter : public Importer {
public:
    MapFormat format() const override { return MapFormat::Wrld; }

    int recognises(const SourceListing& source) const override {
        const SourceMember* main = source.find("main.json");
        if (main == nullptr) return 0;
        std::string head = source.head(*main);
        return head.find("\"levels\"") != std::string::npos && head.find("\"z_order\"") != std::string::npos
                   ? 90
                   : 0;
    }

    Result<RawMap> read(const SourceListing& source, const ImportOptions&) const override {
        const SourceMember* main = source.find("main.json");
        if (main == nullptr)
            return Error{ErrorCode::UnsupportedFormat, english(Sentence::WrldNoMain), source.path};
        auto text = source.content(*main, kMaxMainBytes);
        if (!text) return text.error();
        try {
            // Nesting is bounded by the size, and this parser keeps its own stack.
            return Reader(source, Json::parse(*text)).read(main->name);
        } catch (const std::exception& failure) {
            return Error{ErrorCode::Corrupt, english(Sentence::WrldDamaged, failure.what()), main->name};
        }
    }
};

} // namespace

std::unique_ptr<Importer> makeWrldImporter() {
    return std::make_unique<WrldImporter>();
}

} // namespace farol::building
