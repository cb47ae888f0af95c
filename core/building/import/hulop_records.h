#pragma once
// The records of a HULOP (NavCog, CaBot) route network in either of its dialects: Japanese keys of 2016,
// English of 2018.

#include "core/building/building.h"
#include "core/building/import/tagged_feature.h"

#include <optional>
#include <string>
#include <vector>

namespace farol::building {

struct HulopNode {
    std::string id;
    std::optional<Point2> at; ///< degrees
    double floor = 0.0;
    bool floorKnown = false;
    Tags tags;
};

struct HulopLink {
    std::string id, from, to;
    AccessKind kind = AccessKind::Opening;
    OneWay oneWay = OneWay::No;
    double widthM = 2.0;
    Polyline line; ///< degrees; may be empty
    Tags tags;
};

struct HulopEntrance {
    std::string id, facility, node, name;
    AccessKind kind = AccessKind::Opening;
    std::string doorType;
    bool automatic = false;
    Tags tags;
};

struct HulopFacility {
    std::string id, name;
    bool toilet = false;
    bool pointOfInterest = false; ///< something to tell on the way: a landmark, not a room
    Kind kind = Kind::Other;
    std::string kindText;
    std::optional<Point2> at; ///< degrees
    std::optional<double> floor;
    std::optional<Radians> heading; ///< the way the thing faces; empty: any
    Tags tags;
};

struct HulopRecords {
    std::vector<HulopNode> nodes;
    std::vector<HulopLink> links;
    std::vector<HulopEntrance> entrances;
    std::vector<HulopFacility> facilities;
    std::vector<std::string> unknown; ///< features that are none of these
};

HulopRecords hulopRecords(const std::vector<TaggedFeature>& features, const std::string& language);

/// "35.41.02.450" or "-0.00.00.418": degrees, minutes and seconds, with parts of a second; or plain degrees.
std::optional<double> sexagesimalDegrees(const std::string& text);

} // namespace farol::building
