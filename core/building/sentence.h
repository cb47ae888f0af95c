#pragma once
// What the map check and the importers say, as structure: which sentence, and what stands in its places. The
// English text is made of it here; the workstation makes the same sentence in the user's language
// (ui/models/core_words).

#include "core/base/saying.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace farol::building {

enum class Sentence {
    Nothing,
    // The map check: ids, outlines, names.
    IdMissing,
    IdShared,
    OutlineCorners,
    OutlineNumbers,
    OutlineArea,
    OutlineCrosses,
    HoleCorners,
    HoleNumbers,
    HoleArea,
    HoleCrosses,
    HoleOutside,
    RegionsUnnamed,
    RegionsUnsayable,
    LevelUnlisted,
    // Accesses.
    AccessRegionMissing,
    AccessFarFromRegion,
    AccessSameSides,
    AccessJoinsNone,
    AccessChangesLevel,
    AccessesOnManyRegions,
    EscalatorsUndirected,
    ShaftMissesLevel,
    // Landmarks and kinds.
    LandmarkNoRegion,
    LandmarkRegionMissing,
    LandmarkOtherLevel,
    LandmarkOutside,
    KindUnknown,
    AccessKindUnknown,
    // Regions beside and over each other.
    BuildingInParts,
    CountedRegions,
    RegionSliver,
    RegionsAlike,
    RegionInside,
    RegionsOverlap,
    OverlapsTooMany,
    RefShared,
    BuildingTiny,
    RegionsWithoutAccess,
    RegionsBesideDoors,
    // Every import: ids, outlines, levels.
    IdGiven,
    IdChanged,
    CornersNoPlaces,
    RegionsOfFewCorners,
    RegionsOfManyCorners,
    RegionsOfNoArea,
    OutlinesMended,
    RegionsSplit,
    RegionsMerged,
    AccessPointsNoPlaces,
    AccessesNoPlace,
    LandmarksNoPlace,
    LevelsNoFloors,
    LevelsTwice,
    RegionsGivenNames,
    LandmarksGivenRegion,
    OpeningsAdded,
    // Every import: the two sides of accesses.
    AccessesOnFewRegions,
    AccessesAmbiguous,
    AccessesAcross,
    FarLevelUnknown,
    UpperEndsLeftOut,
    LevelLinksNowhere,
    LevelsJoined,
    // Every import: coordinates.
    CrsNotUnderstood,
    CrsMetresButDegrees,
    CrsMissingDegrees,
    CrsDegreesButMetres,
    CrsMissingMetres,
    AxesExchanged,
    CoordinatesBrought,
    CoordinatesBroughtUnnamed,
    // Shapefiles, GeoPackages and GeoJSON.
    LayersNotUsed,
    FeaturesOtherCrs,
    LayersNoLevel,
    LevelsByHeight,
    LinesAsWalls,
    FeaturesNoGeometry,
    CodeUnknown,
    DirectionUnknown,
    PointsRegionMissing,
    LayersEmpty,
    LayerOfFile,
    LayersNoCrs,
    ShapesNotOnEarth,
    ShapesUnusable,
    // OpenStreetMap.
    OsmLevelUnreadable,
    OsmLevelMissing,
    OsmLiftPoint,
    OsmLandmarkLevel,
    OsmLandmarkOutside,
    OsmDoorLevel,
    OsmEntranceByWay,
    OsmStepsIncline,
    OsmStepsEnd,
    OsmStepsShort,
    OsmWalkwayDirection,
    OsmWalkwayEnd,
    OsmLiftDoor,
    // IMDF.
    ImdfNotUsed,
    ImdfLevelOrdinal,
    ImdfLevelMissing,
    ImdfCategory,
    ImdfNotWalkable,
    ImdfUnitOutline,
    ImdfOccupantAnchor,
    ImdfOpeningClosed,
    ImdfOpeningLine,
    ImdfAmenityPoint,
    ImdfAmenityLevel,
    ImdfRelationship,
    // IndoorGML.
    GmlCrs,
    GmlCell,
    GmlTransition,
    GmlStorey,
    GmlLevel,
    GmlLevelByHeight,
    GmlDoorCell,
    // HULOP.
    HulopUnknown,
    HulopShapes,
    HulopFloorZero,
    HulopFloorOne,
    HulopNode,
    HulopNodeFloor,
    HulopLink,
    HulopNodeAlone,
    HulopFacility,
    HulopEntrance,
    HulopLandmarkFar,
    // WRLD.
    WrldSpacesClosed,
    WrldNarrow,
    WrldDoorOneSide,
    // Why a map cannot be opened or imported: what it is.
    InContext,
    FeatureOf,
    FeatureNumberOf,
    LineOf,
    LevelOf,
    MoreOf,
    NoSuchFile,
    NoSuchSource,
    NoFileOrFolder,
    FolderNotFile,
    HoldsNoFiles,
    NotOpened,
    NotListed,
    NotReadable,
    NotReadToItsEnd,
    NotRead,
    NotImported,
    NotPutTogether,
    ReadingFailed,
    EmptyFile,
    UnknownKindOfMap,
    NoFileOfFormat,
    FileOverOneGb,
    FileOverMb,
    TooManyFiles,
    DatabaseNotOpened,
    // Zips.
    ZipTooManyFiles,
    ZipLeadsOut,
    ZipLocked,
    ZipUnpacksTo,
    ZipListDamaged,
    ZipCutOff,
    ZipTooLarge,
    ZipListOutside,
    // A building file.
    LibraryNotMap,
    NoFarolMap,
    MapInDegrees,
    MapNotInMetres,
    FieldMissing,
    SchemaNoVersion,
    SchemaNewer,
    MapNoRegions,
    IdTwice,
    LevelListedTwice,
    OnewayUnknown,
    FieldEmpty,
    FieldNoNumber,
    FieldNoWhole,
    FieldNoFlag,
    LevelNoFloor,
    NoGeometry,
    SeveralParts,
    CornerNoNumber,
    CornerTooFar,
    AreaNone,
    OtherShape,
    NoOutline,
    // Any foreign map.
    NothingToWalk,
    TooManyLevels,
    NoCoordinates,
    Geocentric,
    BeyondAnyBuilding,
    OutsideTheirCrs,
    CrsNotToMetres,
    TooManyFeatures,
    TooManyShapes,
    NoHeights,
    HoldsNoRooms,
    HoldsDoorsAlone,
    HoldsLinesAlone,
    HoldsNoFeatures,
    NoFeatureCollection,
    JsonTooDeep,
    JsonDamaged,
    ProfileNoObject,
    ProfileColumn,
    ProfileRole,
    // Maps of one format.
    OsmTooMuch,
    OsmNoIndoor,
    OsmTooManyFeatures,
    OsmDamaged,
    OsmNotRead,
    OsmNoFile,
    ImdfNoUnits,
    ImdfSeveralVenues,
    HulopTooMuch,
    HulopNoNodes,
    HulopTooManyFeatures,
    GmlOtherXml,
    GmlTooManyCells,
    GmlNoCells,
    GmlDoorsAlone,
    GmlNoFile,
    XmlDamaged,
    XmlTooManyElements,
    XmlTooDeep,
    XmlEntities,
    WrldNoLevels,
    WrldTooManyLevels,
    WrldLevelOrder,
    WrldNoRooms,
    WrldFloorMissing,
    WrldTooManyFeatures,
    WrldNoMain,
    WrldDamaged,
    // What is refused when a map is changed or saved.
    EditNoOutline,
    EditAccessNoPlace,
    EditSameSides,
    EditWidthOrSteps,
    EditLandmarkNoPlace,
    EditLandmarkSize,
    EditNameTaken,
    EditGone,
    SaveLaterFarol,
    SaveOtherKind,
    SaveFileBusy,
    SaveDiskFull,
    SaveChangedBySomeone,
    // Remarks about a map that opens all the same.
    FieldLevelMissing,
    LayerMissing,
    AccessesNotWalked,
    KindAsOther,
    NoKindAsOther,
    // A place that is named, and a way to it.
    WhereEmpty,
    WhereInNoRegion,
    WhereShared,
    WhereUnknown,
    WhereNearly,
    RegionOnLevel,
    WayRegionMissing,
    WayNoPlace,
    WayOptionRange,
    // A map that cannot be written.
    SaveOutlineNone,
    SaveNoPosition,
    SaveWallNoLength,
    SaveNotThere,
    SaveNotCopied,
    SaveFailed,
    SaveNotAllowed,
    DatabaseNoPostGis,
    PlanNoPicture,
    PlanDamaged,
};

/// One row of the table of all that is said. Places are %1, %2, ...; where the text has %n, a count stands
/// there and chooses between `one` and `text`. Sentences begin in lower case and end without a stop, as they
/// may stand behind the name of a file.
struct SentenceText {
    Sentence sentence = Sentence::Nothing;
    const char* text = "";
    const char* one = nullptr; ///< nullptr: `text` serves for one, too

    bool counts() const;
};

/// In the order of the enumeration.
std::span<const SentenceText> allSentences();
const SentenceText& textOf(Sentence sentence);

struct Message;

/// What stands in one place of a sentence.
struct Argument {
    enum class Is {
        Text,    // as it stands in the map: an id, a name, a file
        Numbers, // to be written as the reader writes numbers
        RegionKinds,
        AccessKinds,
        LandmarkKinds, // all the kinds that are known, as a list
        Phrase         // a part of the sentence with a count of its own
    };

    Argument(std::string as) : text(std::move(as)) {}             // NOLINT: on purpose
    Argument(const char* as) : text(as) {}                        // NOLINT: on purpose
    Argument(double number) : is(Is::Numbers), numbers{number} {} // NOLINT: on purpose
    Argument(std::vector<double> several)
        : is(Is::Numbers), numbers(std::move(several)) {} // NOLINT: on purpose
    Argument(Is kinds) : is(kinds) {}                     // NOLINT: on purpose
    Argument(Sentence part);                              // NOLINT: on purpose
    Argument(Message part);                               // NOLINT: on purpose

    std::vector<std::string> words() const; ///< in English; the kinds as they are written in a map
    std::string english() const;            ///< the words with commas between them

    Is is = Is::Text;
    std::string text;
    std::vector<double> numbers;
    std::shared_ptr<const Message> phrase;
};

struct Message {
    Message() = default;
    Message(Sentence which) : sentence(which) {} // NOLINT: converts on purpose
    Message(Sentence which, std::optional<std::size_t> number, std::vector<Argument> places)
        : sentence(which), count(number), arguments(std::move(places)) {}

    std::string english() const;

    Sentence sentence = Sentence::Nothing;
    std::optional<std::size_t> count; ///< for %n
    std::vector<Argument> arguments;  ///< for %1, %2, ...
};

/// said(Sentence::RegionSliver, id, width): the places in their order.
template <class... Places>
Message said(Sentence sentence, Places&&... places) {
    return {sentence, std::nullopt, {Argument(std::forward<Places>(places))...}};
}
/// The same with a count for %n.
template <class... Places>
Message counted(Sentence sentence, std::size_t count, Places&&... places) {
    return {sentence, count, {Argument(std::forward<Places>(places))...}};
}

/// The English alone, for an error.
template <class... Places>
std::string english(Sentence sentence, Places&&... places) {
    return said(sentence, std::forward<Places>(places)...).english();
}

using farol::withPlaces;

} // namespace farol::building
