#pragma once
// What is wrong with a map, in words a curator can act on.

#include "core/building/building.h"
#include "core/building/sentence.h"

#include <string>
#include <utility>
#include <vector>

namespace farol::building {

enum class Severity { Error, Warning, Note };

/// `rule` is stable ("access-joins-two-regions"); `ids` name the features of `layer`; `message` says what is
/// wrong and what to do. It is `said` in English, and never made otherwise.
struct Finding {
    Finding() = default;
    Finding(Severity how, std::string which, Message what, std::string where, std::vector<std::string> whom)
        : severity(how),
          rule(std::move(which)),
          message(what.english()),
          layer(std::move(where)),
          ids(std::move(whom)),
          said(std::move(what)) {}

    Severity severity = Severity::Note;
    std::string rule;
    std::string message;
    std::string layer;
    std::vector<std::string> ids;
    Message said;
};

std::string severityName(Severity severity);

/// Rules so far: region-polygon-valid, region-id-unique, access-joins-two-regions, access-regions-exist,
/// regions-connected (components), landmark-region-exists, landmark-inside-region, region-named,
/// region-name-sayable, level-listed, access-id-unique, landmark-id-unique, access-touches-regions,
/// access-level-change, kind-known, region-sliver, region-overlap, region-inside, region-duplicate,
/// region-ref-unique, region-has-access, region-door-joins-others, access-touches-two-regions,
/// escalator-direction, shaft-misses-level, crs-degrees-for-metres.
std::vector<Finding> checkBuilding(const Building& building);

/// Connected components over passable accesses: region indices, largest first.
std::vector<std::vector<std::size_t>> components(const Building& building);

} // namespace farol::building
