#include "core/building/import/hulop_records.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace farol::building {

namespace {

/// The first of the keys that has a value.
std::string valueOf(const TaggedFeature& feature, std::initializer_list<const char*> keys) {
    for (const char* key : keys)
        if (const std::string& value = feature.tag(key); !value.empty()) return value;
    return {};
}

std::string namedIn(const TaggedFeature& feature, const std::string& language,
                    std::initializer_list<const char*> keys) {
    if (!language.empty())
        for (const char* key : keys)
            for (const char* joint : {":", "_"})
                if (const std::string& value = feature.tag(key + (joint + language)); !value.empty())
                    return value;
    if (std::string plain = valueOf(feature, keys); !plain.empty()) return plain;
    for (const char* key : keys)
        for (const char* ending : {":en", "_en", ":ja", "_ja"})
            if (const std::string& value = feature.tag(std::string(key) + ending); !value.empty())
                return value;
    return {};
}

std::optional<Point2> placeOf(const TaggedFeature& feature, const char* latitude16, const char* latitude18,
                              const char* longitude16, const char* longitude18) {
    if (!feature.points.empty()) return feature.points.front();
    auto y = sexagesimalDegrees(valueOf(feature, {latitude16, latitude18}));
    auto x = sexagesimalDegrees(valueOf(feature, {longitude16, longitude18}));
    if (!x || !y || !isGeographic({*x, *y})) return std::nullopt;
    return Point2{*x, *y};
}

AccessKind routeKind2016(const std::string& code) {
    if (code == "10") return AccessKind::Elevator;
    if (code == "11") return AccessKind::Escalator;
    if (code == "12") return AccessKind::Stairs;
    return code == "13" ? AccessKind::Ramp : AccessKind::Opening;
}

AccessKind routeKind2018(const std::string& code) {
    if (code == "4") return AccessKind::Elevator;
    if (code == "5") return AccessKind::Escalator;
    if (code == "6") return AccessKind::Stairs;
    return code == "7" ? AccessKind::Ramp : AccessKind::Opening;
}

/// Both dialects give a class: under 1 m, to 1.5 m, to 2 m, above; 2018 counts from 1 as far as its data
/// show.
double widthOf(const TaggedFeature& feature) {
    std::string code = feature.tag("有効幅員");
    if (code.empty() && !feature.tag("width").empty()) {
        auto number = plainNumber(feature.tag("width"));
        code =
            number && *number >= 1.0 && *number <= 4.0 ? std::to_string(static_cast<int>(*number) - 1) : "";
    }
    if (code == "0") return 1.0;
    if (code == "1") return 1.25;
    if (code == "2") return 1.75;
    return code == "3" ? 2.5 : 2.0;
}

HulopNode nodeOf(const TaggedFeature& feature) {
    HulopNode node;
    node.id = valueOf(feature, {"ノードID", "node_id"});
    node.at = placeOf(feature, "緯度", "lat", "経度", "lon");
    auto floor = plainNumber(valueOf(feature, {"高さ", "floor"}));
    node.floorKnown = floor.has_value() && std::abs(*floor) < 1000.0;
    node.floor = node.floorKnown ? *floor : 0.0;
    node.tags = feature.tags;
    return node;
}

HulopLink linkOf(const TaggedFeature& feature) {
    HulopLink link;
    bool old = feature.has("リンクID");
    link.id = valueOf(feature, {"リンクID", "link_id"});
    link.from = valueOf(feature, {"起点ノードID", "start_id"});
    link.to = valueOf(feature, {"終点ノードID", "end_id"});
    link.kind = old ? routeKind2016(feature.tag("経路の種類")) : routeKind2018(feature.tag("route_type"));
    std::string direction = old ? feature.tag("方向性") : feature.tag("direction");
    if (direction == (old ? "1" : "2")) link.oneWay = OneWay::AToB;
    if (direction == (old ? "2" : "3")) link.oneWay = OneWay::BToA;
    link.widthM = widthOf(feature);
    if (!feature.lines.empty()) link.line = feature.lines.front();
    link.tags = feature.tags;
    return link;
}

void setDoor(const std::string& code, HulopEntrance& entrance) {
    if (code.empty() || code == "0" || code == "99") return;
    entrance.kind = AccessKind::Door;
    entrance.automatic = code == "1" || code == "2";
    if (code == "3") entrance.doorType = "sliding";
    if (code == "4") entrance.doorType = "hinged";
    if (code == "5") entrance.doorType = "revolving";
}

HulopEntrance entranceOf(const TaggedFeature& feature, const std::string& language) {
    HulopEntrance entrance;
    entrance.id = feature.tag("出入口ID");
    entrance.facility = feature.tag("対応施設ID");
    entrance.node = feature.tag("対応ノードID");
    entrance.name = namedIn(feature, language, {"出入口の名称"});
    setDoor(feature.tag("扉の種類"), entrance);
    entrance.tags = feature.tags;
    return entrance;
}

/// Entrances of the 2018 dialect stand in the facility: ent1_node, ent2_node, ...
void addEntrances(const TaggedFeature& feature, const std::string& language,
                  std::vector<HulopEntrance>& entrances) {
    for (int number = 1; number <= 99; ++number) {
        std::string start = "ent" + std::to_string(number) + "_";
        if (!feature.has(start + "node")) break;
        HulopEntrance entrance;
        entrance.facility = feature.tag("facil_id");
        entrance.id = entrance.facility + "/" + std::to_string(number);
        entrance.node = feature.tag(start + "node");
        entrance.name = language.empty() ? "" : feature.tag(start + "n_" + language);
        if (entrance.name.empty()) entrance.name = feature.tag(start + "n");
        setDoor(feature.tag(start + "d"), entrance);
        if (!entrance.node.empty()) entrances.push_back(std::move(entrance));
    }
}

void setInterest(const std::string& sub, HulopFacility& facility) {
    facility.pointOfInterest = true;
    facility.kindText = sub;
    auto has = [&sub](const char* word) { return sub.find(word) != std::string::npos; };
    if (has("_nav_door_"))
        facility.kind = Kind::Door;
    else if (has("elevator"))
        facility.kind = Kind::Elevator;
    else if (has("_nav_info_") || has("sign"))
        facility.kind = Kind::Sign;
    else if (has("stair"))
        facility.kind = Kind::Stairs;
    if (facility.kind != Kind::Other) facility.kindText.clear();
}

/// The source tells which way a person looks to whom it is announced, clockwise from north, and how far that
/// may be off.
std::optional<Radians> facing(const TaggedFeature& feature) {
    auto heading = plainNumber(valueOf(feature, {"hulop_heading", "heading"}));
    auto angle = plainNumber(valueOf(feature, {"hulop_angle", "angle"}));
    if (!heading || std::abs(*heading) > 3600.0 || !angle || *angle >= 180.0) return std::nullopt;
    return wrapped(fromDegrees(-90.0 - *heading));
}

HulopFacility facilityOf(const TaggedFeature& feature, const std::string& language) {
    HulopFacility facility;
    facility.id = valueOf(feature, {"施設ID", "facil_id"});
    facility.name = namedIn(feature, language, {"名称", "name", "hulop_content", "long_description"});
    std::string major = valueOf(feature, {"major_category", "hulop_major_category"});
    std::string sub = valueOf(feature, {"sub_category", "hulop_sub_category"});
    if (major == "_nav_poi_") setInterest(sub, facility);
    facility.toilet = feature.is("category", "公共用トイレの情報") || feature.has("男女別") ||
                      feature.has("toilet") || major.find("TOI") != std::string::npos ||
                      sub.find("TOI") != std::string::npos;
    facility.at = placeOf(feature, "緯度", "lat", "経度", "lon");
    facility.floor = plainNumber(valueOf(feature, {"階層", "hulop_height", "height", "floor"}));
    facility.heading = facing(feature);
    facility.tags = feature.tags;
    return facility;
}

} // namespace

std::optional<double> sexagesimalDegrees(const std::string& text) {
    if (std::count(text.begin(), text.end(), '.') < 2) return plainNumber(text);
    bool negative = text[0] == '-';
    std::string rest = text.substr(negative ? 1 : 0);
    std::size_t first = rest.find('.'), second = rest.find('.', first + 1);
    auto digits = [](const std::string& part) {
        return !part.empty() && part.find_first_not_of("0123456789.") == std::string::npos;
    };
    std::string parts[] = {rest.substr(0, first), rest.substr(first + 1, second - first - 1),
                           rest.substr(second + 1)};
    double values[3] = {};
    for (int i = 0; i < 3; ++i) {
        auto value = digits(parts[i]) ? plainNumber(parts[i]) : std::nullopt;
        if (!value || (i > 0 && *value >= 60.0)) return std::nullopt;
        values[i] = *value;
    }
    double degrees = values[0] + values[1] / 60.0 + values[2] / 3600.0;
    return negative ? -degrees : degrees;
}

HulopRecords hulopRecords(const std::vector<TaggedFeature>& features, const std::string& language) {
    HulopRecords records;
    for (const TaggedFeature& feature : features) {
        if (feature.has("リンクID") || feature.has("link_id"))
            records.links.push_back(linkOf(feature));
        else if (feature.has("ノードID") || feature.has("node_id"))
            records.nodes.push_back(nodeOf(feature));
        else if (feature.has("出入口ID"))
            records.entrances.push_back(entranceOf(feature, language));
        else if (feature.has("施設ID") || feature.has("facil_id")) {
            records.facilities.push_back(facilityOf(feature, language));
            addEntrances(feature, language, records.entrances);
        } else
            records.unknown.push_back(feature.id);
    }
    return records;
}

} // namespace farol::building
