#pragma once
// A building of a HULOP route network, which has no areas. Each node becomes a region: its links as strips of
// their width, cut half-way to the next node; there an opening leads on. A facility becomes a square of 2 m
// behind each of its entrances, on the side where the facility lies.

#include "core/building/import/hulop_records.h"
#include "core/building/import/importer.h"
#include "core/building/import/local_plane.h"

#include <map>
#include <string>
#include <vector>

namespace farol::building {

class HulopBuilder {
public:
    HulopBuilder(HulopRecords records, const ImportOptions& options, std::string context);
    Result<RawMap> build();

private:
    struct Place {
        Point2 at;
        double level = 0.0;
        std::size_t region = 0;
        std::size_t links = 0;
        double reachM = 1.0; ///< half the width of its widest link
        std::vector<Polygon> strips;
    };

    void chooseFloors();
    double levelOf(double floor) const;
    void placeNodes();
    void addLinks();
    void addLink(const HulopLink& link);
    void addStrips(const HulopLink& link, const Polyline& line, Place& from, Place& to);
    void nameShafts();
    void shapeRegions();
    void addFacilities();
    void addFacilityAt(const HulopFacility& facility, const HulopEntrance& entrance, const Place& place);
    void addLandmark(const HulopFacility& facility);
    const Place* nearestPlace(Point2 at, std::optional<double> level) const;
    std::string freeId(const std::string& wish);
    void note(Severity severity, const std::string& rule, const Message& message, const std::string& id);

    HulopRecords m_records;
    ImportOptions m_options;
    std::string m_context;
    LocalPlane m_plane;
    bool m_zeroBased = false;
    RawMap m_map;
    std::map<std::string, Place> m_places; ///< by node id
    std::map<std::string, int> m_ids;
    std::map<std::string, Finding> m_notes;
};

} // namespace farol::building
