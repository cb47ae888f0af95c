// The table of all that the map check and the importers say. English stands here and nowhere else; the other
// languages stand in translations/*.ts, into which `./dev translate` collects what is within SAID and
// SAID_OF_MANY.

#include "core/building/sentence.h"

#include <cstddef>

// Names that lupdate is told of (cmake/FarolTranslations.cmake): a sentence, and one that has plural forms.
#define SAID(context, english) english
#define SAID_OF_MANY(context, english) english

namespace farol::building {

namespace {

constexpr SentenceText kSentences[]{
    {Sentence::Nothing, ""},
    // The map check: ids, outlines, names.
    {Sentence::IdMissing, SAID_OF_MANY("core", "%n features have no id; give each its own"),
     "%n feature has no id; give each its own"},
    {Sentence::IdShared, SAID_OF_MANY("core", "%n features share the id \"%1\"; give each its own")},
    {Sentence::OutlineCorners,
     SAID("core", "the outline of region \"%1\" has fewer than three corners; draw it again")},
    {Sentence::OutlineNumbers,
     SAID("core", "the outline of region \"%1\" has a coordinate that is no number; draw it again")},
    {Sentence::OutlineArea, SAID("core", "the outline of region \"%1\" has no area; draw it again")},
    {Sentence::OutlineCrosses, SAID("core", "the outline of region \"%1\" crosses itself; draw it again")},
    {Sentence::HoleCorners,
     SAID("core",
          "the outline of region \"%1\" has a hole that has fewer than three corners; draw it again")},
    {Sentence::HoleNumbers,
     SAID("core",
          "the outline of region \"%1\" has a hole that has a coordinate that is no number; draw it again")},
    {Sentence::HoleArea,
     SAID("core", "the outline of region \"%1\" has a hole that has no area; draw it again")},
    {Sentence::HoleCrosses,
     SAID("core", "the outline of region \"%1\" has a hole that crosses itself; draw it again")},
    {Sentence::HoleOutside,
     SAID("core", "the outline of region \"%1\" has a hole that lies outside it; draw it again")},
    {Sentence::RegionsUnnamed,
     SAID_OF_MANY("core", "%n regions have neither name nor ref: only its kind is spoken"),
     "%n region has neither name nor ref: only its kind is spoken"},
    {Sentence::RegionsUnsayable,
     SAID_OF_MANY(
         "core",
         "%n regions are called \"%1\" or the like, which is never spoken; give it the name that people use"),
     "%n region is called \"%1\", which is never spoken; give it the name that people use"},
    {Sentence::LevelUnlisted,
     SAID_OF_MANY(
         "core",
         "level %1 is used by %n regions but is not in the layer levels: its name cannot be spoken; add it"),
     "level %1 is used by %n region but is not in the layer levels: its name cannot be spoken; add it"},
    // Accesses.
    {Sentence::AccessRegionMissing,
     SAID("core", "access \"%1\" names the region \"%2\", which does not exist; correct it")},
    {Sentence::AccessFarFromRegion,
     SAID("core", "access \"%1\" lies more than 1 m from region \"%2\"; move it to the border")},
    {Sentence::AccessSameSides, SAID("core", "access \"%1\" has the same region on both sides: no route "
                                             "passes it; set region_a and region_b, or move it to a border")},
    {Sentence::AccessJoinsNone, SAID("core", "access \"%1\" does not join two regions: no route passes it; "
                                             "set region_a and region_b, or move it to a border")},
    {Sentence::AccessChangesLevel,
     SAID("core", "access \"%1\" is no stairs, lift, escalator or ramp but joins regions of levels %2 and "
                  "%3; correct its kind or regions")},
    {Sentence::AccessesOnManyRegions,
     SAID_OF_MANY(
         "core",
         "%n accesses are drawn on more than two regions: see that region_a and region_b are the right ones"),
     "%n access is drawn on more than two regions: see that region_a and region_b are the right ones"},
    {Sentence::EscalatorsUndirected,
     SAID_OF_MANY("core", "%n escalators have no direction and count as running both ways: set oneway"),
     "%n escalator has no direction and count as running both ways: set oneway"},
    {Sentence::ShaftMissesLevel,
     SAID("core",
          "shaft \"%1\" passes level %2 without an access there; add it, unless it does not stop there")},
    // Landmarks and kinds.
    {Sentence::LandmarkNoRegion, SAID("core", "landmark \"%1\" belongs to no region; set region_id")},
    {Sentence::LandmarkRegionMissing,
     SAID("core", "landmark \"%1\" names the region \"%2\", which does not exist; correct it")},
    {Sentence::LandmarkOtherLevel,
     SAID("core", "landmark \"%1\" is on level %2, its region \"%3\" on level %4")},
    {Sentence::LandmarkOutside,
     SAID("core",
          "landmark \"%1\" lies more than 0.5 m outside its region \"%2\"; move it or correct region_id")},
    {Sentence::KindUnknown, SAID_OF_MANY("core", "%n features have the unknown kind \"%1\"; known are %2"),
     "%n feature has the unknown kind \"%1\"; known are %2"},
    {Sentence::AccessKindUnknown,
     SAID_OF_MANY("core",
                  "%n features have the unknown kind \"%1\"; known are %2 (nobody is led through other)"),
     "%n feature has the unknown kind \"%1\"; known are %2 (nobody is led through other)"},
    // Regions beside and over each other.
    {Sentence::BuildingInParts,
     SAID_OF_MANY("core", "the building falls into %1 parts; %n regions cannot be reached from the largest "
                          "(%2): accesses are missing or closed"),
     "the building falls into %1 parts; %n region cannot be reached from the largest (%2): accesses are "
     "missing or closed"},
    {Sentence::CountedRegions, SAID_OF_MANY("core", "%n regions"), "%n region"},
    {Sentence::RegionSliver,
     SAID("core",
          "region \"%1\" is a sliver, about %2 m wide: nobody stands there; join it to its neighbour")},
    {Sentence::RegionsAlike, SAID("core", "regions \"%1\" and \"%2\" have the same outline; remove one")},
    {Sentence::RegionInside, SAID("core", "regions \"%1\" and \"%2\": the smaller lies inside the larger; "
                                          "cut it out of the larger one, unless it is a part of it")},
    {Sentence::RegionsOverlap,
     SAID("core", "regions \"%1\" and \"%2\" overlap by %3 % of the smaller; draw the border between them")},
    {Sentence::OverlapsTooMany,
     SAID("core", "so many regions overlap that not all pairs were compared; are all levels drawn on one?")},
    {Sentence::RefShared,
     SAID_OF_MANY("core",
                  "%n regions of level %1 have the ref \"%2\": people are led to the wrong one; correct it")},
    {Sentence::BuildingTiny, SAID("core", "the whole building is smaller than 0.3 m: its coordinates are "
                                          "degrees, not metres; import or reproject it")},
    {Sentence::RegionsWithoutAccess,
     SAID_OF_MANY("core", "%n regions have no door or other access that joins another region: nobody can be "
                          "led there; add it"),
     "%n region has no door or other access that joins another region: nobody can be led there; add it"},
    {Sentence::RegionsBesideDoors,
     SAID_OF_MANY("core", "%n regions have a door drawn on the border, but the door joins two others and "
                          "nothing leads there: correct region_a or region_b, or draw another door"),
     "%n region has a door drawn on the border, but the door joins two others and nothing leads there: "
     "correct region_a or region_b, or draw another door"},
    // Every import: ids, outlines, levels.
    {Sentence::IdGiven, SAID("core", "features had no id and were given one")},
    {Sentence::IdChanged, SAID("core", "features shared an id and were given another")},
    {Sentence::CornersNoPlaces,
     SAID("core", "outlines have corners that are no places; these were left out")},
    {Sentence::RegionsOfFewCorners,
     SAID("core", "outlines have fewer than three corners; the regions were left out")},
    {Sentence::RegionsOfManyCorners,
     SAID("core", "outlines have more than 200,000 corners; the regions were left out")},
    {Sentence::RegionsOfNoArea, SAID("core", "outlines enclose no area; the regions were left out")},
    {Sentence::OutlinesMended,
     SAID("core", "outlines crossed or touched themselves and were mended: compare them with the plan")},
    {Sentence::RegionsSplit,
     SAID("core", "regions fell into several parts: each part is a region of its own")},
    {Sentence::RegionsMerged,
     SAID("core", "regions repeat the outline of another one on their level and were merged with it")},
    {Sentence::AccessPointsNoPlaces,
     SAID("core", "accesses have points that are no places; these were left out")},
    {Sentence::AccessesNoPlace, SAID("core", "accesses have no place on the map and were left out")},
    {Sentence::LandmarksNoPlace, SAID("core", "landmarks have no place on the map and were left out")},
    {Sentence::LevelsNoFloors, SAID("core", "levels are no floors of a building; level 0 is assumed")},
    {Sentence::LevelsTwice, SAID("core", "levels stand twice in the source; the first name is kept")},
    {Sentence::RegionsGivenNames,
     SAID(
         "core",
         "regions had no name and were given one from kind and number, such as \"Corridor 3\": rename them")},
    {Sentence::LandmarksGivenRegion,
     SAID("core", "landmarks lie outside every region and were given to the nearest one")},
    {Sentence::OpeningsAdded,
     SAID("core", "openings were added where regions meet without a wall between them")},
    // Every import: the two sides of accesses.
    {Sentence::AccessesOnFewRegions, SAID("core", "accesses are drawn on fewer than two regions")},
    {Sentence::AccessesAmbiguous, SAID("core", "accesses lie beside more than two regions; the two with the "
                                               "widest border were taken: see that they are right")},
    {Sentence::AccessesAcross, SAID("core", "accesses run from one region to another and along no border: if "
                                            "one walks along the line, set region_a and region_b")},
    {Sentence::FarLevelUnknown,
     SAID("core", "stairs, lifts or escalators lead to a level that nothing names: set region_b, or give "
                  "them and their other end the same shaft")},
    {Sentence::UpperEndsLeftOut,
     SAID("core",
          "upper ends of stairs, lifts or escalators were left out: their lower ends lead there already")},
    {Sentence::LevelLinksNowhere, SAID("core", "links between levels name regions that do not exist")},
    {Sentence::LevelsJoined,
     SAID(
         "core",
         "stairs, lifts or escalators were joined with the ones above them, because their outlines overlap")},
    // Every import: coordinates.
    {Sentence::CrsNotUnderstood,
     SAID("core", "the coordinate reference system of the source cannot be understood")},
    {Sentence::CrsMetresButDegrees,
     SAID("core",
          "the source names a CRS in metres, but its coordinates are degrees: they are taken as WGS 84")},
    {Sentence::CrsMissingDegrees,
     SAID("core", "the source names no CRS; its coordinates look like degrees and are taken as WGS 84")},
    {Sentence::CrsDegreesButMetres, SAID("core", "the source names a CRS in degrees, but its coordinates are "
                                                 "not: they are taken as metres of a local plane")},
    {Sentence::CrsMissingMetres, SAID("core", "the source names no CRS: its coordinates are taken as metres "
                                              "of a local plane; name the CRS if there is one")},
    {Sentence::AxesExchanged, SAID("core", "north and east stand in each other's place in the source: they "
                                           "were exchanged; export it again to be sure")},
    {Sentence::CoordinatesBrought, SAID("core", "coordinates were brought from %1 to %2, in metres")},
    {Sentence::CoordinatesBroughtUnnamed,
     SAID("core", "coordinates were brought from the source's CRS to %1, in metres")},
    // Shapefiles, GeoPackages and GeoJSON.
    {Sentence::LayersNotUsed,
     SAID("core", "layers hold no rooms, doors, walls or points by their name; a profile can say otherwise")},
    {Sentence::FeaturesOtherCrs, SAID("core", "features cannot be brought to the CRS of the other layers")},
    {Sentence::LayersNoLevel,
     SAID("core", "layers tell no level; the ground floor is assumed: name the field that holds the level")},
    {Sentence::LevelsByHeight,
     SAID("core",
          "levels were counted from the heights of the shapes, the one nearest to 0 as the ground floor")},
    {Sentence::LinesAsWalls, SAID("core", "lines of layers that nothing names doors or walls are taken as "
                                          "walls; name the layer or give a profile")},
    {Sentence::FeaturesNoGeometry, SAID("core", "features have no geometry and were left out")},
    {Sentence::CodeUnknown,
     SAID("core", "features have the code \"%1\", which nobody knows: name it under codes in a profile")},
    {Sentence::DirectionUnknown, SAID("core", "accesses have a direction that nobody knows and are taken to "
                                              "be passed both ways: a_to_b, b_to_a, up or down is wanted")},
    {Sentence::PointsRegionMissing,
     SAID("core", "points name a region that does not exist; the one they lie in is taken")},
    {Sentence::LayersEmpty, SAID("core", "layers have no features: %1")},
    {Sentence::LayerOfFile, SAID("core", "%1, layer %2")},
    {Sentence::LayersNoCrs, SAID("core", "layers name no CRS; that of the other layers is taken")},
    {Sentence::ShapesNotOnEarth,
     SAID("core", "features left out: their coordinates are missing or no places on Earth")},
    {Sentence::ShapesUnusable, SAID("core", "features left out: they have no usable shape")},
    // OpenStreetMap.
    {Sentence::OsmLevelUnreadable,
     SAID("core", "the value of level or repeat_on is no list of levels such as -1;0 or 1-3: correct it")},
    {Sentence::OsmLevelMissing,
     SAID("core", "there is no readable level; level 0 is assumed: add the level")},
    {Sentence::OsmLiftPoint,
     SAID("core", "the lift is a point in the source: a square of 1.6 m was drawn for its car")},
    {Sentence::OsmLandmarkLevel,
     SAID("core", "left out: it has no level, and it stands over no or several levels' regions")},
    {Sentence::OsmLandmarkOutside, SAID("core", "left out: no region of its level lies within 3 m")},
    {Sentence::OsmDoorLevel, SAID("core", "left out: it has no level and stands on no outline of a region")},
    {Sentence::OsmEntranceByWay,
     SAID("core", "no door is drawn where a way leads into the room: an opening was put there")},
    {Sentence::OsmStepsIncline,
     SAID("core",
          "nothing tells which end of the steps is up; the first was taken as the lower: add incline")},
    {Sentence::OsmStepsEnd,
     SAID("core", "no region lies at an end of the steps: draw the area or way it leads to")},
    {Sentence::OsmStepsShort, SAID("core", "steps left out: their line has no length")},
    {Sentence::OsmWalkwayDirection, SAID("core", "nothing tells which way the walkway runs; it is taken to "
                                                 "run both ways: set conveying to forward or backward")},
    {Sentence::OsmWalkwayEnd,
     SAID("core", "no region lies at an end of the walkway: draw the area or way it leads to")},
    {Sentence::OsmLiftDoor,
     SAID("core", "the lift has no drawn door; one was put on a side that is open: move it to its place")},
    // IMDF.
    {Sentence::ImdfNotUsed, SAID("core", "features of the type %1 have no place in a building file")},
    {Sentence::ImdfLevelOrdinal, SAID("core", "levels have no ordinal; they are taken as the ground floor")},
    {Sentence::ImdfLevelMissing,
     SAID("core", "features name a level that does not exist; the ground floor is assumed")},
    {Sentence::ImdfCategory,
     SAID("core", "units have a category that IMDF 1.0 does not list; they are taken as rooms")},
    {Sentence::ImdfNotWalkable, SAID("core", "units are walls, columns or voids: they became walls")},
    {Sentence::ImdfUnitOutline, SAID("core", "units have no outline and were left out")},
    {Sentence::ImdfOccupantAnchor, SAID("core", "occupants have no anchor in a unit and were left out")},
    {Sentence::ImdfOpeningClosed,
     SAID("core",
          "openings are emergency exits, for vehicles or out of service: nobody is led through them")},
    {Sentence::ImdfOpeningLine, SAID("core", "openings have no line and were left out")},
    {Sentence::ImdfAmenityPoint, SAID("core", "amenities have no point and were left out")},
    {Sentence::ImdfAmenityLevel,
     SAID("core", "amenities name no unit that tells their level and were left out")},
    {Sentence::ImdfRelationship, SAID("core", "relationships do not name two units and were left out")},
    // IndoorGML.
    {Sentence::GmlCrs,
     SAID("core", "the name of the coordinate system is not known; a local plane in metres is assumed")},
    {Sentence::GmlCell, SAID("core", "cells left out: they have no outline, no id, or the id of another")},
    {Sentence::GmlTransition,
     SAID("core", "transitions left out: they do not connect two cells that are there")},
    {Sentence::GmlStorey, SAID("core", "storeys are named by words; levels were taken from the heights")},
    {Sentence::GmlLevel,
     SAID("core", "nothing tells the levels: all is taken as level 0; name the field that holds the level")},
    {Sentence::GmlLevelByHeight, SAID("core", "levels were counted from the heights of the floors")},
    {Sentence::GmlDoorCell,
     SAID("core", "the door's cell does not lie between two rooms: it stays a region")},
    // HULOP.
    {Sentence::HulopUnknown, SAID("core", "features left out: they are no node, link, facility or entrance")},
    {Sentence::HulopShapes,
     SAID("core", "the network has no areas: each node became a region of strips along its links, cut "
                  "half-way, and each facility a square of 2 m behind its entrance")},
    {Sentence::HulopFloorZero,
     SAID("core",
          "floor 0 is taken as the ground floor; import it with the level from 1 when it is floor 1")},
    {Sentence::HulopFloorOne,
     SAID("core",
          "floor 1 is taken as the ground floor; import it with the level from 0 when it is floor 0")},
    {Sentence::HulopNode, SAID("core", "nodes left out: they have no place, no id, or the id of another")},
    {Sentence::HulopNodeFloor, SAID("core", "nodes without a floor are taken to be on the ground")},
    {Sentence::HulopLink, SAID("core", "links left out: they do not join two nodes that are there")},
    {Sentence::HulopNodeAlone, SAID("core", "no link leads to the node")},
    {Sentence::HulopFacility,
     SAID("core", "no entrance with a known node leads to the facility: it became a landmark")},
    {Sentence::HulopEntrance, SAID("core", "the facility of the entrance is missing")},
    {Sentence::HulopLandmarkFar,
     SAID("core", "left out: it lies more than 20 m from every node of its floor")},
    // WRLD.
    {Sentence::WrldSpacesClosed,
     SAID_OF_MANY("core", "%n spaces were closed from walls, doors and windows; they have no names, and "
                          "whether they are rooms, corridors or halls is a guess from their doors and size")},
    {Sentence::WrldNarrow, SAID("core", "strips under 0.3 m between walls were left out")},
    {Sentence::WrldDoorOneSide,
     SAID("core", "no space lies on one side of the door: it leads outside, or a wall is missing")},
};

constexpr bool inOrder() {
    std::size_t number = 0;
    for (const SentenceText& row : kSentences)
        if (static_cast<std::size_t>(row.sentence) != number++) return false;
    return true;
}
static_assert(inOrder(), "textOf() looks rows up by their number");

} // namespace

std::span<const SentenceText> allSentences() {
    return kSentences;
}

const SentenceText& textOf(Sentence sentence) {
    return kSentences[static_cast<std::size_t>(sentence)];
}

} // namespace farol::building
