#include "tests/support/ascii_map.h"

#include "core/base/text.h"
#include "tests/support/ascii_drawing.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace farol::test {

using building::Access;
using building::AccessKind;
using building::OneWay;

namespace {

AccessId freeId(const building::BuildingData& data, char a, char b) {
    std::string base = std::string(1, a) + "-" + b;
    for (int number = 1;; ++number) {
        AccessId id(number == 1 ? base : base + std::to_string(number));
        if (std::none_of(data.accesses.begin(), data.accesses.end(),
                         [&](const Access& each) { return each.id == id; }))
            return id;
    }
}

Access accessOf(const AsciiDrawing::Opening& opening, double level) {
    Access access;
    access.level = level;
    access.line = opening.line;
    access.widthM = length(opening.line);
    access.closed = opening.character == '*';
    access.kind = opening.character == ':'   ? AccessKind::Opening
                  : opening.character == '%' ? AccessKind::Window
                                             : AccessKind::Door;
    bool swapped = opening.second < opening.first;
    access.regionA = RegionId(std::string(1, swapped ? opening.second : opening.first));
    access.regionB = RegionId(std::string(1, swapped ? opening.first : opening.second));
    bool forward = opening.character == '>' || opening.character == 'v';
    if (forward || opening.character == '<' || opening.character == '^')
        access.oneWay = forward != swapped ? OneWay::AToB : OneWay::BToA;
    return access;
}

} // namespace

AsciiMap& AsciiMap::floor(std::string_view drawing, double level) {
    AsciiDrawing picture(drawing, m_cellM);
    m_data.levels.push_back({level, "Level " + formatNumber(level), formatNumber(level), {}, {}, {}});
    for (char letter : picture.letters()) {
        building::Region region;
        region.id = RegionId(std::string(1, letter));
        for (const building::Region& other : m_data.regions)
            if (other.id == region.id)
                throw std::invalid_argument("ASCII map: two levels have a room " + other.name);
        region.level = level;
        region.name = region.id.value;
        region.kind = building::RegionKind::Room;
        region.polygon = picture.outline(letter);
        m_data.regions.push_back(std::move(region));
    }
    for (const AsciiDrawing::Opening& opening : picture.openings()) {
        Access access = accessOf(opening, level);
        access.id = freeId(m_data, access.regionA.value.front(), access.regionB.value.front());
        m_data.accesses.push_back(std::move(access));
    }
    for (AsciiDrawing::Cell cell : picture.spots()) {
        char room = picture.roomAt(cell);
        if (room == '\0') continue;
        m_spots.push_back(
            {picture.character(cell), {RegionId(std::string(1, room)), picture.position(cell)}, level});
    }
    return *this;
}

building::Region& AsciiMap::regionOf(char letter) {
    for (building::Region& region : m_data.regions)
        if (region.id.value == std::string(1, letter)) return region;
    throw std::invalid_argument(std::string("ASCII map: no room ") + letter + " is drawn");
}

AsciiMap& AsciiMap::region(char letter, AsciiRegion about) {
    building::Region& region = regionOf(letter);
    if (!about.name.empty()) region.name = about.name;
    region.ref = about.ref;
    region.kind = about.kind;
    region.restricted = about.restricted;
    return *this;
}

AsciiMap& AsciiMap::landmark(char character, AsciiLandmark about) {
    m_landmarks[character] = std::move(about);
    return *this;
}

AsciiMap& AsciiMap::join(AccessKind kind, char a, char b, const std::string& shaft,
                         std::optional<int> steps) {
    if (b < a) std::swap(a, b);
    const building::Region& first = regionOf(a);
    Access access;
    access.id = freeId(m_data, a, b);
    access.kind = kind;
    access.level = first.level;
    access.regionA = first.id;
    access.regionB = regionOf(b).id;
    access.shaft = ShaftId(shaft);
    access.steps = steps;
    access.line = {pointInside(first.polygon)};
    m_data.accesses.push_back(std::move(access));
    return *this;
}

building::BuildingData AsciiMap::data() const {
    building::BuildingData data = m_data;
    std::map<char, int> counts;
    for (const Spot& spot : m_spots) {
        auto about = m_landmarks.find(spot.character);
        if (about == m_landmarks.end()) continue;
        int number = ++counts[spot.character];
        building::Landmark landmark;
        landmark.id =
            LandmarkId(std::string(1, spot.character) + (number == 1 ? "" : std::to_string(number)));
        landmark.kind = about->second.kind;
        landmark.text = about->second.text;
        landmark.templateId = TemplateId(about->second.templateId);
        if (about->second.headingDeg) landmark.heading = fromDegrees(*about->second.headingDeg);
        landmark.region = spot.location.region;
        landmark.level = spot.level;
        landmark.position = *spot.location.position;
        data.landmarks.push_back(std::move(landmark));
    }
    for (const auto& [character, about] : m_landmarks)
        if (counts[character] == 0)
            throw std::invalid_argument(std::string("ASCII map: landmark ") + character + " is not drawn");
    return data;
}

std::shared_ptr<const building::Building> AsciiMap::build() const {
    return std::make_shared<const building::Building>(data());
}

building::Location AsciiMap::spot(char character) const {
    for (const Spot& spot : m_spots)
        if (spot.character == character) return spot.location;
    throw std::invalid_argument(std::string("ASCII map: no spot ") + character + " is drawn");
}

std::shared_ptr<const building::Building> asciiMap(std::string_view drawing,
                                                   const std::map<char, AsciiLandmark>& landmarks) {
    AsciiMap map;
    map.floor(drawing);
    for (const auto& [character, about] : landmarks) map.landmark(character, about);
    return map.build();
}

} // namespace farol::test
