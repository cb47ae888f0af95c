#pragma once
// Twelve drawn buildings, of the kinds that people get lost in, and one walk through each.

#include "core/building/building.h"
#include "core/building/info.h"

#include <memory>
#include <string>
#include <vector>

namespace farol::test {

struct GoldenBuilding {
    std::string name;  ///< of its file
    std::string title; ///< what is special about it
    std::vector<std::string> drawings;
    std::shared_ptr<const building::Building> building;
    building::Location from, to;
    bool seesObjects = false; ///< the walker wants to hear of objects and texts, too
};

std::vector<GoldenBuilding> goldenBuildings();

} // namespace farol::test
