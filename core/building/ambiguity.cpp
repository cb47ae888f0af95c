#include "core/building/ambiguity.h"

#include "core/base/text.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace farol::building {

namespace {

/// The paper's history is four deep: where one is, and three regions before.
constexpr int kStepsBack = 3;
constexpr std::size_t kMostCandidates = 400, kMostSuggestions = 5;

using Colours = std::vector<std::size_t>;

std::string appearance(const Landmark& landmark) {
    if (!landmark.templateId.empty()) return "template " + landmark.templateId.value;
    return std::string(kindName(landmark.kind)) + " " + landmark.kindText + " " +
           foldedForMatching(landmark.text);
}

/// Equal signatures get equal numbers.
template <class Signature>
Colours numbered(const std::vector<Signature>& signatures) {
    std::map<Signature, std::size_t> numbers;
    for (const Signature& signature : signatures) numbers.emplace(signature, 0);
    std::size_t next = 0;
    for (auto& [signature, number] : numbers) number = next++;
    Colours colours;
    for (const Signature& signature : signatures) colours.push_back(numbers[signature]);
    return colours;
}

Colours looks(const Building& building) {
    std::vector<std::vector<std::string>> signatures(building.regions().size());
    for (std::size_t i = 0; i < signatures.size(); ++i) {
        for (std::size_t landmark : building.landmarksOf(i))
            signatures[i].push_back(appearance(building.landmarks()[landmark]));
        std::sort(signatures[i].begin(), signatures[i].end());
    }
    return numbered(signatures);
}

Colours afterWalking(const Building& building, Colours colours) {
    for (int step = 0; step < kStepsBack; ++step) {
        std::vector<std::vector<std::size_t>> signatures(colours.size());
        for (std::size_t i = 0; i < colours.size(); ++i) {
            for (std::size_t neighbour : building.neighboursOf(i))
                signatures[i].push_back(colours[neighbour]);
            std::sort(signatures[i].begin(), signatures[i].end());
            // Which door one came by is unknown: how many neighbours look so does not count.
            signatures[i].erase(std::unique(signatures[i].begin(), signatures[i].end()), signatures[i].end());
            signatures[i].insert(signatures[i].begin(), colours[i]);
        }
        colours = numbered(signatures);
    }
    return colours;
}

std::map<std::size_t, std::vector<std::size_t>> groupsOf(const Colours& colours) {
    std::map<std::size_t, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < colours.size(); ++i) groups[colours[i]].push_back(i);
    return groups;
}

std::size_t pairsIn(const Colours& colours) {
    std::vector<std::size_t> sizes(colours.size(), 0);
    for (std::size_t colour : colours) ++sizes[colour];
    std::size_t pairs = 0;
    for (std::size_t size : sizes) pairs += size * (size - (size > 0 ? 1 : 0)) / 2;
    return pairs;
}

/// Members of groups, those first whose group is large and who have many neighbours.
std::vector<std::size_t> candidates(const Building& building,
                                    const std::map<std::size_t, std::vector<std::size_t>>& groups) {
    std::vector<std::pair<std::size_t, std::size_t>> scored;
    for (const auto& [colour, members] : groups)
        for (std::size_t region : members)
            scored.emplace_back(members.size() * (1 + building.neighboursOf(region).size()), region);
    std::stable_sort(scored.begin(), scored.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    // A campus has too many to try each; the cost of one trial grows with the map.
    std::size_t most = std::min(kMostCandidates, 1 + 2000000 / (building.regions().size() + 1));
    if (scored.size() > most) scored.resize(most);
    std::vector<std::size_t> regions;
    for (const auto& [score, region] : scored) regions.push_back(region);
    return regions;
}

} // namespace

Ambiguity findAmbiguity(const Building& building) {
    Ambiguity result;
    const std::vector<Region>& regions = building.regions();
    for (std::size_t i = 0; i < regions.size(); ++i)
        if (building.landmarksOf(i).empty()) result.withoutLandmarks.push_back(regions[i].id);
    Colours own = looks(building);
    Colours colours = afterWalking(building, own);
    auto groups = groupsOf(colours);
    for (const auto& [colour, members] : groups) {
        if (members.size() < 2) continue;
        std::vector<RegionId> ids;
        for (std::size_t member : members) ids.push_back(regions[member].id);
        result.groups.push_back(std::move(ids));
    }
    std::stable_sort(result.groups.begin(), result.groups.end(), [](const auto& a, const auto& b) {
        return a.size() != b.size() ? a.size() > b.size() : naturalLess(a.front().value, b.front().value);
    });
    result.confusedPairs = pairsIn(colours);
    if (result.confusedPairs == 0) return result;
    for (std::size_t region : candidates(building, groups)) {
        Colours marked = own;
        marked[region] = regions.size(); // a look that nothing else has
        std::size_t left = pairsIn(afterWalking(building, std::move(marked)));
        if (left < result.confusedPairs)
            result.suggestions.push_back({regions[region].id, result.confusedPairs - left});
    }
    std::stable_sort(result.suggestions.begin(), result.suggestions.end(), [](const auto& a, const auto& b) {
        return a.pairs != b.pairs ? a.pairs > b.pairs : naturalLess(a.region.value, b.region.value);
    });
    if (result.suggestions.size() > kMostSuggestions) result.suggestions.resize(kMostSuggestions);
    return result;
}

} // namespace farol::building
