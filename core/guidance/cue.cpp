#include "core/guidance/cue.h"

namespace farol::guidance {

std::string cueKindName(CueKind kind) {
    switch (kind) {
    case CueKind::RouteStart:
        return "route_start";
    case CueKind::Prepare:
        return "prepare";
    case CueKind::Act:
        return "act";
    case CueKind::Reassure:
        return "reassure";
    case CueKind::Arrived:
        return "arrived";
    case CueKind::OffRoute:
        return "off_route";
    case CueKind::Unsure:
        return "unsure";
    case CueKind::Located:
        return "located";
    case CueKind::Detection:
        return "detection";
    case CueKind::Text:
        return "text";
    case CueKind::NoRoute:
        return "no_route";
    case CueKind::AlreadyThere:
        return "already_there";
    case CueKind::Warning:
        return "warning";
    case CueKind::Around:
        return "around";
    case CueKind::Itinerary:
        return "itinerary";
    case CueKind::Chime:
        return "chime";
    }
    return "unknown";
}

std::string cueReasonName(CueReason reason) {
    switch (reason) {
    case CueReason::None:
        return "none";
    case CueReason::NoDestination:
        return "no_destination";
    case CueReason::DestinationUnknown:
        return "destination_unknown";
    case CueReason::DestinationUnreachable:
        return "destination_unreachable";
    case CueReason::CameraLost:
        return "camera_lost";
    case CueReason::CameraBack:
        return "camera_back";
    case CueReason::RecordingStopped:
        return "recording_stopped";
    case CueReason::PictureCovered:
        return "picture_covered";
    case CueReason::FrameSkipped:
        return "frame_skipped";
    }
    return "unknown";
}

std::string sweepStepName(SweepStep step) {
    switch (step) {
    case SweepStep::None:
        return "none";
    case SweepStep::Right:
        return "right";
    case SweepStep::Left:
        return "left";
    case SweepStep::Up:
        return "up";
    case SweepStep::Down:
        return "down";
    case SweepStep::AskForHelp:
        return "ask_for_help";
    case SweepStep::Done:
        return "done";
    }
    return "unknown";
}

std::string deviationName(Deviation deviation) {
    switch (deviation) {
    case Deviation::LeftRoute:
        return "left_route";
    case Deviation::WrongWay:
        return "wrong_way";
    case Deviation::Missed:
        return "missed";
    }
    return "unknown";
}

std::string chimeName(Chime chime) {
    switch (chime) {
    case Chime::None:
        return "none";
    case Chime::Fix:
        return "fix";
    case Chime::Warning:
        return "warning";
    }
    return "unknown";
}

std::string bearingName(Bearing bearing) {
    switch (bearing) {
    case Bearing::None:
        return "none";
    case Bearing::Facing:
        return "facing";
    case Bearing::AlongWay:
        return "along_way";
    case Bearing::Map:
        return "map";
    }
    return "unknown";
}

} // namespace farol::guidance
