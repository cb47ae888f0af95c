// One sentence per cue. Names from the map stand behind a colon or between commas, so that they need no
// article and no gender in any language.

#include "ui/speech/phrasebook.h"

#include "core/guidance/clock.h"
#include "ui/speech/spoken.h"

namespace farol::ui {

using guidance::Cue;
using guidance::CueKind;
using guidance::CueReason;
using routing::ManoeuvreKind;

namespace {

/// Nobody walks further the wrong way without a word; in a room one finds the walls sooner.
constexpr double kFarM = 5.0, kFarInRoomM = 8.0;

} // namespace

QString Phrasebook::sentence(const Cue& cue) const {
    switch (cue.kind) {
    case CueKind::RouteStart:
        return routeStart(cue);
    case CueKind::Prepare:
        return prepare(cue);
    case CueKind::Act:
        return act(cue);
    case CueKind::Reassure:
        return reassure(cue);
    case CueKind::Arrived:
        return withStop(cue, arrived(cue));
    case CueKind::OffRoute:
        return offRoute(cue);
    case CueKind::Unsure:
        return lookAround(cue);
    case CueKind::Located:
        return located(cue);
    case CueKind::Detection:
        return detection(cue);
    case CueKind::Text: {
        const QString read = spoken::shortened(cue.text);
        //: %1 what is written there, %2 "left, up"
        return read.isEmpty() ? QString()
                              : tr("I read: %1. %2.").arg(read, spoken::capitalised(zoneWords(cue.zone)));
    }
    case CueKind::NoRoute:
        return noRoute(cue);
    case CueKind::AlreadyThere:
        return withStop(cue, alreadyThere(cue));
    case CueKind::Warning:
        return warning(cue);
    case CueKind::Around:
        return around(cue);
    case CueKind::Itinerary:
        return itinerary(cue);
    case CueKind::Chime:
        break;
    }
    return {};
}

QString Phrasebook::routeStart(const Cue& cue) const {
    const QString destination = spoken::name(cue.regionName);
    QStringList sentences;
    sentences << (destination.isEmpty() ? tr("I have found the way.")
                                        : tr("Destination: %1.").arg(destination));
    const int count = cue.sure ? counted(cue.distanceM) : 0;
    if (count > 0 && count != counted(cue.firstM)) sentences << length(count);

    // "Start" is nothing to do in itself: the manoeuvre behind it is the first one.
    Cue first = cue;
    if (first.manoeuvre && first.manoeuvre->kind == ManoeuvreKind::Start && first.next) {
        first.manoeuvre = first.next;
        first.next.reset();
    }
    if (!first.manoeuvre) return spoken::joined(sentences);
    const QString turning = facing(cue);
    const QString opener = !turning.isEmpty() ? tr("Then") : cue.sure ? tr("First") : tr("First, probably");
    sentences << turning << announcedFirst(first, firstOpener(cue, opener), *first.manoeuvre);
    // Along a corridor there are two ways to go, and only walking tells which one the user faces.
    const double farM = cue.fromKind == building::RegionKind::Room ? kFarInRoomM : kFarM;
    const bool far = first.manoeuvre->atM >= farM;
    if (!cue.facingWay && turning.isEmpty() && far)
        sentences << tr("Start slowly: I will tell you if it is the wrong way.");
    return spoken::joined(sentences);
}

/// "In about 15 metres" instead of "first": told from afar, a door without a distance is taken for the next
/// one at hand.
QString Phrasebook::firstOpener(const Cue& cue, const QString& near) const {
    const int count = cue.sure ? counted(cue.firstM) : 0;
    return count > 0 ? ahead(count) : near;
}

/// Which way to turn before the way begins: only when the cue knows which way the user faces.
QString Phrasebook::facing(const Cue& cue) const {
    if (!cue.turnFirst) return {};
    if (cue.sure) return spoken::sentence(turnOnTheSpot(*cue.turnFirst));
    //: %1 "turn left", "turn around"
    return tr("Probably %1 first.").arg(turnOnTheSpot(*cue.turnFirst));
}

QString Phrasebook::prepare(const Cue& cue) const {
    if (!cue.manoeuvre) return {};
    // A thing that is felt tells more than metres do.
    const int metres = cue.sure && !cue.mark ? counted(cue.distanceM) : 0;
    const QString turning = facing(cue);
    const QString opener = metres > 0           ? ahead(metres)
                           : !turning.isEmpty() ? tr("Then")
                           : cue.soon           ? (cue.sure ? tr("Soon") : tr("Soon, probably"))
                                                : (cue.sure ? tr("From here") : tr("From here, probably"));
    return spoken::joined({turning, announced(cue, opener, *cue.manoeuvre)});
}

QString Phrasebook::reassure(const Cue& cue) const {
    if (!cue.sure) return tr("Keep moving forward. You are probably going the right way.");
    const int count = counted(cue.distanceM);
    return count > 0 ? keepMoving(count) : tr("Keep moving forward.");
}

/// Whoever asks where they are hears first that this is not known.
QString Phrasebook::lookAround(const Cue& cue) {
    using guidance::SweepStep;
    const bool under =
        cue.sweep == SweepStep::Left || cue.sweep == SweepStep::Up || cue.sweep == SweepStep::Down;
    const QString unknown = cue.asked && under ? tr("I do not know yet where you are.") : QString();
    return spoken::joined({unknown, sweepWords(cue.sweep)});
}

QString Phrasebook::sweepWords(guidance::SweepStep step) {
    using guidance::SweepStep;
    switch (step) {
    case SweepStep::None:
    case SweepStep::Right:
        break;
    case SweepStep::Left:
        return tr("Now turn slowly to the left, past where you began.");
    case SweepStep::Up:
        return tr("Hold still, and tilt the camera slowly up.");
    case SweepStep::Down:
        return tr("Now tilt it slowly down.");
    case SweepStep::AskForHelp:
        return tr(
            "I still do not know where you are. If you can, move a few steps along a wall, or ask for help.");
    case SweepStep::Done:
        return tr("Thank you, that is enough.");
    }
    return tr("I am not sure where you are. Stop, and turn slowly to the right, so that I can look around.");
}

/// The order before is void, even for one who is just opening the door.
QString Phrasebook::withStop(const Cue& cue, const QString& sentence) {
    //: To somebody who walks, or is opening a door
    return cue.stop ? spoken::joined({tr("Stop."), sentence}) : sentence;
}

QString Phrasebook::arrived(const Cue& cue) const {
    const QString place = spoken::name(cue.regionName);
    if (place.isEmpty()) return cue.sure ? tr("You have arrived.") : tr("You have probably arrived.");
    return (cue.sure ? tr("You have arrived: %1.") : tr("You have probably arrived: %1.")).arg(place);
}

QString Phrasebook::offRouteLead(const Cue& cue) {
    switch (cue.deviation) {
    case guidance::Deviation::WrongWay:
        return cue.sure ? tr("You are walking the wrong way.")
                        : tr("You are probably walking the wrong way.");
    case guidance::Deviation::Missed:
        return cue.sure ? tr("You have gone too far.") : tr("You have probably gone too far.");
    case guidance::Deviation::LeftRoute:
        break;
    }
    return cue.sure ? tr("You have left the route.") : tr("You have probably left the route.");
}

QString Phrasebook::offRoute(const Cue& cue) const {
    const QString left = offRouteLead(cue);
    if (cue.reason == CueReason::DestinationUnreachable || cue.reason == CueReason::DestinationUnknown) {
        return spoken::joined({left, tr("Stop. I know no way from here.")});
    }
    if (!cue.manoeuvre) return spoken::joined({left, tr("Stop for a moment.")});
    const QString turning = facing(cue);
    const QString opener = firstOpener(cue, turning.isEmpty() ? tr("From here") : tr("Then"));
    return spoken::joined({left, turning, announcedFirst(cue, opener, *cue.manoeuvre)});
}

QString Phrasebook::located(const Cue& cue) const {
    QString place = spoken::name(cue.regionName);
    if (place.isEmpty()) place = regionWord(cue.regionKind);
    const QString level = levelWords(cue);
    if (place.isEmpty() && level.isEmpty()) return tr("I do not know yet where you are.");
    const QString where = place.isEmpty()   ? level
                          : level.isEmpty() ? place
                                            : place + QStringLiteral(", ") + level;
    return (cue.sure ? tr("You are here: %1.") : tr("You are probably here, or next to it: %1.")).arg(where);
}

/// The paper's form: what, then where in the picture.
QString Phrasebook::detection(const Cue& cue) const {
    QString what = kindWord(cue.objectKind);
    const QString read = spoken::shortened(cue.text);
    if (!read.isEmpty()) what += QLatin1Char(' ') + read;
    QString where = zoneWords(cue.zone);
    if (cue.hour && m_style == DirectionStyle::Clock) {
        QStringList words{hourWord(((*cue.hour % 12) + 12) % 12)};
        if (cue.zone.row == Row::Up) words << tr("up");
        if (cue.zone.row == Row::Down) words << tr("down");
        where = words.join(QStringLiteral(", "));
    }
    //: %1 "extinguisher", %2 "left, down"
    const QString said = (cue.sure ? tr("%1, %2.") : tr("perhaps: %1, %2.")).arg(what, where);
    return spoken::capitalised(said);
}

QString Phrasebook::noRoute(const Cue& cue) const {
    const QString place = spoken::name(cue.regionName);
    if (cue.reason == CueReason::NoDestination) return tr("No destination is chosen yet. Choose one first.");
    if (cue.reason == CueReason::DestinationUnknown) {
        return place.isEmpty() ? tr("I do not know this destination. Choose another one.")
                               : tr("I do not know this destination: %1. Choose another one.").arg(place);
    }
    return place.isEmpty()
               ? tr("I know no way to your destination. Choose another one, or ask for help.")
               : tr("I know no way to: %1. Choose another destination, or ask for help.").arg(place);
}

QString Phrasebook::alreadyThere(const Cue& cue) const {
    const QString place = spoken::name(cue.regionName);
    if (place.isEmpty())
        return cue.sure ? tr("You are already there.") : tr("You are probably there already.");
    return (cue.sure ? tr("You are already there: %1.") : tr("You are probably there already: %1."))
        .arg(place);
}

QString Phrasebook::whereAround(const guidance::Surrounding& what, guidance::Bearing bearing) const {
    if (!what.direction) return tr("near you");
    return bearing == guidance::Bearing::Map ? compassWords(*what.direction)
                                             : whereWords(guidance::clockHour(*what.direction));
}

/// "a door, Library"
QString Phrasebook::whatAround(const guidance::Surrounding& what) {
    QString noun = thingWords(what.kind);
    if (what.access) {
        Manoeuvre manoeuvre;
        manoeuvre.kind = *what.access;
        manoeuvre.vertical = what.vertical;
        noun = featureNoun(featureOf(manoeuvre));
    }
    QString name = spoken::shortened(what.name);
    const bool unsaid =
        what.behind == building::RegionKind::Stairwell || what.behind == building::RegionKind::Elevator;
    if (what.access && unsaid && *what.access != routing::ManoeuvreKind::Door) name.clear();
    if (name.isEmpty() && what.access && !unsaid) name = regionWord(what.behind);
    //: %1 "a door", %2 a name
    return name.isEmpty() ? noun : tr("%1, %2", "what is around").arg(noun, name);
}

/// One sentence for each direction, the nearest first.
QString Phrasebook::around(const Cue& cue) const {
    QStringList sentences{located(cue)};
    if (cue.around.empty()) return spoken::joined(sentences << tr("I know of nothing near you."));
    if (cue.bearing == guidance::Bearing::AlongWay)
        sentences << tr("The directions are as you face along your way.");
    if (cue.bearing == guidance::Bearing::Map) sentences << tr("The directions are those of the map.");
    QStringList directions;
    QList<QStringList> things;
    for (const guidance::Surrounding& each : cue.around) {
        const QString where = whereAround(each, cue.bearing);
        qsizetype at = directions.indexOf(where);
        if (at < 0) {
            at = directions.size();
            directions << where;
            things << QStringList();
        }
        things[at] << whatAround(each);
    }
    for (qsizetype i = 0; i < directions.size(); ++i) {
        //: %1 "on your left", %2 "a door, Library; an extinguisher"
        sentences << spoken::capitalised(
            tr("%1: %2.", "what is around").arg(directions[i], things[i].join(QStringLiteral("; "))));
    }
    return spoken::joined(sentences);
}

QString Phrasebook::warning(const Cue& cue) const {
    switch (cue.reason) {
    case CueReason::CameraLost:
        return tr("Stop. The camera gives no picture, and I cannot guide you.");
    case CueReason::CameraBack:
        return tr("The camera works again.");
    case CueReason::RecordingStopped:
        return tr("The recording has stopped. I keep guiding you.");
    case CueReason::PictureCovered:
        return tr("Stop. I cannot see. Please uncover the camera.");
    case CueReason::FrameSkipped:
        return tr("One picture could not be used. I keep guiding you.");
    case CueReason::NoDestination:
    case CueReason::DestinationUnknown:
    case CueReason::DestinationUnreachable:
        return noRoute(cue);
    case CueReason::None:
        break;
    }
    return tr("Stop. Something is wrong. Please ask for help.");
}

} // namespace farol::ui
