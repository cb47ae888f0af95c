#pragma once
// The demo building, drawn for Farol: three levels with a bar and its neighbours, an atrium, a ring corridor,
// two wings that look alike, two stairwells and a lift. It stands nowhere.

#include "core/building/building.h"

namespace farol::demo {

building::BuildingData demoBuilding();

} // namespace farol::demo
