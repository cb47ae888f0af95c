#include "ui/models/words.h"

#include "ui/convert/convert.h"

namespace farol::ui {

QString Words::regionKind(building::RegionKind kind) {
    switch (kind) {
    case building::RegionKind::Room:
        return tr("room");
    case building::RegionKind::Corridor:
        return tr("corridor");
    case building::RegionKind::Hall:
        return tr("hall");
    case building::RegionKind::Stairwell:
        return tr("stairwell");
    case building::RegionKind::Elevator:
        return tr("lift");
    case building::RegionKind::Toilet:
        return tr("toilet");
    case building::RegionKind::Outside:
        return tr("outside");
    case building::RegionKind::Other:
        break;
    }
    return tr("place");
}

QString Words::accessKind(building::AccessKind kind) {
    switch (kind) {
    case building::AccessKind::Door:
        return tr("door");
    case building::AccessKind::Opening:
        return tr("opening");
    case building::AccessKind::Stairs:
        return tr("stairs");
    case building::AccessKind::Elevator:
        return tr("lift");
    case building::AccessKind::Escalator:
        return tr("escalator");
    case building::AccessKind::Ramp:
        return tr("ramp");
    case building::AccessKind::Window:
        return tr("window");
    case building::AccessKind::Other:
        break;
    }
    return tr("passage");
}

QString Words::level(const building::Building& building, double ordinal) {
    return tr("level %1").arg(levelLabel(building, ordinal));
}

QString Words::about(const building::Region& region) {
    return tr("%1 (%2)").arg(regionLabel(region), regionKind(region.kind));
}

QString Words::about(const building::Building& building, const building::Access& access) {
    const auto side = [&](const RegionId& id) { return id.empty() ? tr("?") : regionName(&building, id); };
    const QString text =
        tr("%1 between %2 and %3").arg(accessKind(access.kind), side(access.regionA), side(access.regionB));
    return access.closed ? tr("%1 (closed)").arg(text) : text;
}

QString Words::about(const building::Building& building, const building::Landmark& landmark) {
    const QString name = toQString(landmark.text.empty() ? landmark.id.value : landmark.text);
    const QString kind = Phrasebook::kindWord(landmark.kind);
    if (landmark.region.empty()) return tr("%1: %2").arg(kind, name);
    return tr("%1: %2, in %3").arg(kind, name, regionName(&building, landmark.region));
}

QString Words::detectionName(const recognition::Detection& detection) {
    if (!detection.text.empty()) return QStringLiteral("“%1”").arg(toQString(detection.text));
    return toQString(detection.templateId.value);
}

QString Words::utteranceState(UtteranceState state) {
    switch (state) {
    case UtteranceState::Waiting:
        return tr("waiting");
    case UtteranceState::Speaking:
        return tr("speaking");
    case UtteranceState::Spoken:
        return tr("spoken");
    case UtteranceState::Interrupted:
        return tr("interrupted");
    case UtteranceState::Expired:
        return tr("too late");
    case UtteranceState::Shown:
        break;
    }
    return tr("shown");
}

QString Words::cause(const guidance::Cue& cue) {
    switch (cue.kind) {
    case guidance::CueKind::RouteStart:
        return tr("new route");
    case guidance::CueKind::Prepare:
        return tr("coming up");
    case guidance::CueKind::Act:
        return tr("do it now");
    case guidance::CueKind::Reassure:
        return tr("keep going");
    case guidance::CueKind::Arrived:
        return tr("arrived");
    case guidance::CueKind::OffRoute:
        return tr("left the route");
    case guidance::CueKind::Unsure:
        return tr("place not known");
    case guidance::CueKind::Located:
        return tr("place found");
    case guidance::CueKind::Detection:
        return tr("object seen");
    case guidance::CueKind::Text:
        return tr("text read");
    case guidance::CueKind::NoRoute:
        return tr("no route");
    case guidance::CueKind::AlreadyThere:
        return tr("already there");
    case guidance::CueKind::Around:
    case guidance::CueKind::Itinerary:
    case guidance::CueKind::Chime: // has no words, so it is in no list
        return tr("asked for");
    case guidance::CueKind::Warning:
        break;
    }
    return tr("warning");
}

QString Words::sureness(double confidence, double sureFrom) {
    if (confidence >= sureFrom) return tr("sure");
    return confidence >= sureFrom / 2 ? tr("fairly sure") : tr("not sure");
}

QString Words::voteTerm(const std::string& name) {
    if (name == "Pobj") return tr("objects");
    if (name == "Pmaxobj") return tr("best object");
    if (name == "Ppos") return tr("near the last place");
    if (name == "Pperc") return tr("on the way");
    if (name == "PID") return tr("seen together");
    if (name == "Preg") return tr("weight of the place");
    if (name == "Rp") return tr("share seen here");
    if (name == "Rv") return tr("share seen next door");
    if (name == "Vreg") return tr("vote");
    if (name == "Pdir") return tr("in the way of walking");
    if (name == "Pf") return tr("on your level");
    if (name == "Np") return tr("matching objects");
    if (name == "Nv") return tr("matching objects next door");
    if (name == "Nobj") return tr("objects seen");
    if (name == "weight") return tr("share of the likelihood");
    if (name == "lost") return tr("could be anywhere");
    if (name == "against") return tr("evidence against all of this");
    return toQString(name);
}

} // namespace farol::ui
