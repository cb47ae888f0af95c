#pragma once
// What is to be told, as structure. Words are made once, in ui/speech (Phrasebook).

#include "core/localisation/localiser.h"
#include "core/routing/route.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace farol::guidance {

enum class CueKind {
    RouteStart, ///< a route is planned: destination, length, first manoeuvre
    Prepare,    ///< a manoeuvre comes soon
    Act,        ///< do it now
    Reassure,   ///< keep going
    Arrived,
    OffRoute,     ///< left the route; a new one follows or none exists
    Unsure,       ///< not known where: `sweep` says how to look around
    Located,      ///< where the user is, when that changed or was asked for
    Detection,    ///< an object and its zone (paper 4.3: "extinguisher-left-down")
    Text,         ///< something read on a sign
    NoRoute,      ///< destination unknown or unreachable: `reason`
    AlreadyThere, ///< the destination is the region one is in
    Warning,      ///< the camera went away, the disk is full, the picture is covered: `reason`
    Around,       ///< an answer: what is near, `around`
    Itinerary,    ///< an answer: all that is to be done to the destination, `steps`
    Chime,        ///< a sound without words: `chime`
};

/// Lower value is more urgent (field.md 4.5).
enum class CuePriority { Warning, ActNow, OffRoute, Prepare, Arrival, Answer, Detection, Reassurance };

/// Why a NoRoute or Warning cue came; the Phrasebook has a sentence for each.
enum class CueReason {
    None,
    NoDestination, ///< asked for the way without having chosen one
    DestinationUnknown,
    DestinationUnreachable,
    CameraLost,
    CameraBack,
    RecordingStopped,
    PictureCovered,
    FrameSkipped
};

/// The coached look around of someone lost (paper section 2: 180 degrees across, 45 up and down), one order
/// at a time. Done: the place is known again.
enum class SweepStep { None, Right, Left, Up, Down, AskForHelp, Done };

/// How the user came off the way (OffRoute).
enum class Deviation { LeftRoute, WrongWay, Missed };

/// A sound to be played with a cue, before its words. Fix: the place is known again.
enum class Chime { None, Fix, Warning };

/// A mapped thing that hand or cane finds, shortly before a manoeuvre: "after the extinguisher on your left".
struct Mark {
    Kind kind = Kind::Other;
    routing::Side side = routing::Side::None; ///< None: the side of the door itself, or no side
};

/// What the directions of an answer count from. Map: from north, as maps are drawn.
enum class Bearing { None, Facing, AlongWay, Map };

/// One thing near the user: an access to a neighbouring region, or a landmark.
struct Surrounding {
    std::optional<routing::ManoeuvreKind> access; ///< empty: a landmark
    routing::Vertical vertical = routing::Vertical::None;
    Kind kind = Kind::Other; ///< of the landmark
    std::string name;        ///< of the region behind, or what is written on the landmark; may be empty
    building::RegionKind behind = building::RegionKind::Other;
    std::optional<Radians> direction; ///< counter-clockwise from Cue::bearing
    std::optional<double> distanceM;  ///< for the order; not spoken
};

struct Cue {
    CueKind kind = CueKind::Reassure;
    CuePriority priority = CuePriority::Reassurance;
    std::uint64_t id = 0;           ///< rises by one with each cue of a session
    std::uint64_t frame = 0;        ///< the frame that caused it
    double time = 0.0;              ///< of that frame
    double validUntil = 0.0;        ///< same clock; later it is not spoken
    std::vector<RegionId> validIn;  ///< regions in which it still holds; empty: anywhere
    std::uint64_t routeVersion = 0; ///< a newer route makes route cues void; 0: not tied to a route

    std::optional<routing::Manoeuvre> manoeuvre; ///< of RouteStart (the first), Prepare, Act
    std::optional<routing::Manoeuvre> next;      ///< to be told in the same breath
    std::optional<int> hour; ///< clock hour to the next access; only when the heading is trusted
    /// Where a way begins behind or beside the user: how far to turn first, left positive. Only when a
    /// trained place has just told which way the user faces; `hour` is then empty, for it would no longer
    /// hold after the turn.
    std::optional<Radians> turnFirst;
    std::optional<double> distanceM; ///< only when the position allows to say it
    /// RouteStart, OffRoute: to the manoeuvre, when other doors may lie before it. `distanceM` of a
    /// RouteStart is the length of the whole way.
    std::optional<double> firstM;
    bool soon = true; ///< Prepare: known to be near
    /// RouteStart, OffRoute: the user is known to face the way; otherwise nothing is on the left or right
    /// yet.
    bool facingWay = true;
    std::optional<Mark> mark; ///< Prepare: what comes just before the manoeuvre
    /// Arrived, AlreadyThere: an order to go on was told a moment ago by a guess, and may be just about to be
    /// followed.
    bool stop = false;
    bool staying = false;   ///< a lift that the user is in already, and stays in
    RegionId region;        ///< RouteStart, Arrived: destination; Located: where; others: region ahead
    std::string regionName; ///< spoken name of `region`
    std::string intoName;   ///< spoken name of the region that the manoeuvre leads into
    /// Kinds of `region`, and of where the manoeuvre leads from and into: said where a name is missing.
    building::RegionKind regionKind = building::RegionKind::Other;
    building::RegionKind fromKind = building::RegionKind::Other;
    building::RegionKind intoKind = building::RegionKind::Other;
    std::string levelName;             ///< spoken name of the target level of stairs and lifts
    bool sure = true;                  ///< false: hedge the words
    Kind objectKind = Kind::Other;     ///< Detection
    Zone zone;                         ///< Detection, Text
    std::string text;                  ///< Text: what was read; Detection: the landmark's text, if any
    SweepStep sweep = SweepStep::None; ///< Unsure
    CueReason reason = CueReason::None;
    std::string detail;                         ///< of `reason`, for the log; not spoken
    Deviation deviation = Deviation::LeftRoute; ///< OffRoute
    Chime chime = Chime::None;
    bool asked = false; ///< an answer: spoken even if it was said a moment ago
    Bearing bearing = Bearing::None;
    std::vector<Surrounding> around; ///< Around; nearest first
    std::vector<Cue> steps;          ///< Itinerary: Act cues in order
};

std::string cueKindName(CueKind kind);
std::string cueReasonName(CueReason reason);
std::string sweepStepName(SweepStep step);
std::string deviationName(Deviation deviation);
std::string chimeName(Chime chime);
std::string bearingName(Bearing bearing);

} // namespace farol::guidance
