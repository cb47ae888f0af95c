#include "core/session/map_words.h"

#include <set>

namespace farol::session {

std::vector<std::string> wordsOf(const building::Building& building) {
    std::set<std::string> words;
    for (const building::Region& region : building.regions()) words.insert({region.ref, region.name});
    for (const building::Level& level : building.levels()) words.insert({level.ref, level.name});
    for (const building::Landmark& landmark : building.landmarks()) words.insert(landmark.text);
    words.erase("");
    return {words.begin(), words.end()};
}

} // namespace farol::session
