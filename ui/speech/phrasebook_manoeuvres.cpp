// What is done at doors, stairs, lifts and turns. Where the map tells how a door stands, its side and the
// turn behind it are told apart; where it does not, "go through the door, turning left" leaves open which of
// both it is. Turns at stairs and lifts are not said at all, because nobody knows the way a person faces
// after them.

#include "ui/speech/phrasebook.h"
#include "ui/speech/spoken.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace farol::ui {

using building::RegionKind;
using guidance::Cue;
using guidance::CueKind;
using routing::ManoeuvreKind;
using routing::Side;
using routing::Vertical;

namespace {

/// Counting more steps than this distracts (Wayfindr, stairs 5.2).
constexpr int kMostStepsCounted = 12;
/// Who has to turn by so much to go through a door does not go straight on.
constexpr double kBesideRadians = 60.0 * kPi / 180.0;
/// From so much on a turn behind a door is told.
constexpr double kTurnTold = 30.0 * kPi / 180.0;

Vertical verticalOf(const routing::Manoeuvre& manoeuvre) {
    if (manoeuvre.vertical != Vertical::None) return manoeuvre.vertical;
    if (manoeuvre.targetLevel > manoeuvre.level) return Vertical::Up;
    if (manoeuvre.targetLevel < manoeuvre.level) return Vertical::Down;
    return Vertical::None;
}

bool changesLevel(ManoeuvreKind kind) {
    return kind == ManoeuvreKind::Stairs || kind == ManoeuvreKind::Elevator ||
           kind == ManoeuvreKind::Escalator;
}

/// With nothing to be done in between: the way goes on as it was.
bool isStraightGap(const routing::Manoeuvre& manoeuvre) {
    return manoeuvre.behind && manoeuvre.side == Side::None &&
           std::abs(manoeuvre.behind->value) < kTurnTold &&
           std::abs(wrapped(manoeuvre.turn - *manoeuvre.behind).value) < kBesideRadians;
}

/// Two doors or two openings, one right behind the other. Told one by one they sound like an echo.
bool isPair(const Cue& cue) {
    const bool gap =
        cue.manoeuvre->kind == ManoeuvreKind::Door || cue.manoeuvre->kind == ManoeuvreKind::Opening;
    return gap && cue.next && cue.next->kind == cue.manoeuvre->kind && isStraightGap(*cue.next);
}

/// The order of the first one covers the second.
bool saidAsPair(const Cue& cue) {
    return isPair(cue) && cue.facingWay && cue.hour.value_or(12) % 12 == 0 && isStraightGap(*cue.manoeuvre) &&
           cue.fromKind != RegionKind::Elevator && cue.intoKind != RegionKind::Elevator;
}

/// Is there something to be done right behind? In the lift one hears what to do there.
bool followsAtOnce(const Cue& cue) {
    if (!cue.next || cue.next->kind == ManoeuvreKind::Arrive || cue.next->kind == ManoeuvreKind::Start)
        return false;
    if (changesLevel(cue.manoeuvre->kind)) return false; // one has to find one's bearings first
    return cue.next->kind != ManoeuvreKind::Elevator || cue.intoKind != RegionKind::Elevator;
}

} // namespace

Phrasebook::Feature Phrasebook::featureOf(const Manoeuvre& manoeuvre) {
    const Vertical vertical = verticalOf(manoeuvre);
    auto pick = [&](Feature up, Feature down, Feature unknown) {
        return vertical == Vertical::Up ? up : vertical == Vertical::Down ? down : unknown;
    };
    switch (manoeuvre.kind) {
    case ManoeuvreKind::Door:
        return Feature::Door;
    case ManoeuvreKind::Opening:
        return Feature::Opening;
    case ManoeuvreKind::Stairs:
        return pick(Feature::StairsUp, Feature::StairsDown, Feature::Stairs);
    case ManoeuvreKind::Elevator:
        return pick(Feature::LiftUp, Feature::LiftDown, Feature::Lift);
    case ManoeuvreKind::Escalator:
        return pick(Feature::EscalatorUp, Feature::EscalatorDown, Feature::Escalator);
    case ManoeuvreKind::Ramp:
        return pick(Feature::RampUp, Feature::RampDown, Feature::Ramp);
    case ManoeuvreKind::Start:
    case ManoeuvreKind::Turn:
    case ManoeuvreKind::Arrive:
        break;
    }
    return Feature::None;
}

/// As in "Soon: a door."
QString Phrasebook::featureNoun(Feature feature) {
    switch (feature) {
    case Feature::Door:
        return tr("a door");
    case Feature::Opening:
        return tr("an opening");
    case Feature::StairsUp:
        return tr("stairs up");
    case Feature::StairsDown:
        return tr("stairs down");
    case Feature::Stairs:
        return tr("stairs");
    case Feature::LiftUp:
    case Feature::LiftDown:
    case Feature::Lift:
        return tr("a lift");
    case Feature::EscalatorUp:
        return tr("an escalator up");
    case Feature::EscalatorDown:
        return tr("an escalator down");
    case Feature::Escalator:
        return tr("an escalator");
    case Feature::RampUp:
        return tr("a ramp up");
    case Feature::RampDown:
        return tr("a ramp down");
    case Feature::Ramp:
        return tr("a ramp");
    case Feature::None:
        break;
    }
    return {};
}

/// "The stairs are on your left.", with a marker for the direction. Doors have clauses of their own.
QString Phrasebook::placeSentence(Feature feature, bool sure) {
    switch (feature) {
    case Feature::StairsUp:
    case Feature::StairsDown:
    case Feature::Stairs:
        return sure ? tr("The stairs are %1.") : tr("The stairs are probably %1.");
    case Feature::LiftUp:
    case Feature::LiftDown:
    case Feature::Lift:
        return sure ? tr("The lift is %1.") : tr("The lift is probably %1.");
    case Feature::EscalatorUp:
    case Feature::EscalatorDown:
    case Feature::Escalator:
        return sure ? tr("The escalator is %1.") : tr("The escalator is probably %1.");
    case Feature::RampUp:
    case Feature::RampDown:
    case Feature::Ramp:
        return sure ? tr("The ramp is %1.") : tr("The ramp is probably %1.");
    case Feature::Door:
    case Feature::Opening:
    case Feature::None:
        break;
    }
    return {};
}

QString Phrasebook::nearSentence(const Manoeuvre& manoeuvre) {
    switch (manoeuvre.kind) {
    case ManoeuvreKind::Door:
        return tr("You are probably near the door.");
    case ManoeuvreKind::Opening:
        return tr("You are probably near the opening.");
    case ManoeuvreKind::Stairs:
        return tr("Careful: you are probably near the stairs.");
    case ManoeuvreKind::Elevator:
        return tr("You are probably near the lift.");
    case ManoeuvreKind::Escalator:
        return tr("Careful: you are probably near the escalator.");
    case ManoeuvreKind::Ramp:
        return tr("You are probably near the ramp.");
    case ManoeuvreKind::Turn:
        return tr("You are probably where you have to turn.");
    case ManoeuvreKind::Start:
    case ManoeuvreKind::Arrive:
        break;
    }
    return {};
}

/// "take the stairs up". Doors and openings have clauses of their own.
QString Phrasebook::action(Feature feature) {
    switch (feature) {
    case Feature::StairsUp:
        return tr("take the stairs up");
    case Feature::StairsDown:
        return tr("take the stairs down");
    case Feature::Stairs:
        return tr("take the stairs, but feel first whether they go up or down");
    case Feature::LiftUp:
        return tr("take the lift up");
    case Feature::LiftDown:
        return tr("take the lift down");
    case Feature::Lift:
        return tr("take the lift");
    case Feature::EscalatorUp:
        return tr("take the escalator up");
    case Feature::EscalatorDown:
        return tr("take the escalator down");
    case Feature::Escalator:
        return tr("take the escalator, but feel first whether it goes up or down");
    case Feature::RampUp:
        return tr("go up the ramp");
    case Feature::RampDown:
        return tr("go down the ramp");
    case Feature::Ramp:
        return tr("follow the ramp");
    case Feature::Door:
    case Feature::Opening:
    case Feature::None:
        break;
    }
    return {};
}

/// "on your left": of a door in the wall that one walks along.
QString Phrasebook::sideWords(Side side) const {
    if (side == Side::None) return {};
    return whereWords(m_style == DirectionStyle::Degrees ? 0 : side == Side::Left ? 9 : 3, side);
}

/// Where the door is, for somebody who walks along the way; empty where nobody knows.
QString Phrasebook::gapWhere(const Cue& cue) const {
    const Manoeuvre& manoeuvre = *cue.manoeuvre;
    if (cue.staying || !cue.facingWay) return {};
    if (manoeuvre.side != Side::None) return sideWords(manoeuvre.side);
    if (cue.hour && *cue.hour % 12 != 0) return whereWords(*cue.hour);
    if (cue.hour) return tr("ahead");
    return manoeuvre.behind ? tr("ahead") : QString();
}

/// "go through the third door on your left", with what to do behind it.
QString Phrasebook::gapClause(const Cue& cue) const {
    const Manoeuvre& manoeuvre = *cue.manoeuvre;
    const bool door = manoeuvre.kind == ManoeuvreKind::Door;
    const QString where = gapWhere(cue);
    const bool arrives = cue.next && cue.next->kind == ManoeuvreKind::Arrive;
    const bool bends = manoeuvre.behind && !arrives && std::abs(manoeuvre.behind->value) >= kTurnTold;
    const bool straight =
        !arrives && cue.facingWay && cue.hour.value_or(12) % 12 == 0 && isStraightGap(manoeuvre);
    const bool isNext = cue.kind == CueKind::Prepare && manoeuvre.number == 1 && cue.routeVersion != 0;
    const QString number = cue.kind == CueKind::Act && !cue.asked && cue.routeVersion != 0 ? QString()
                           : isNext && cue.facingWay && !cue.mark ? tr("next", "door or opening")
                           : cue.facingWay && !cue.mark           ? ordinal(manoeuvre.number)
                                                                  : QString();
    QString clause;
    if (door && cue.fromKind == RegionKind::Elevator && cue.intoKind != RegionKind::Elevator)
        clause = tr("get out of the lift");
    else if (door && cue.intoKind == RegionKind::Elevator)
        clause = where.isEmpty() ? tr("go into the lift") : tr("go into the lift %1").arg(where);
    else if (saidAsPair(cue))
        clause = door ? tr("go straight on through two doors in a row")
                      : tr("go straight on through two openings in a row");
    else if (straight)
        clause = door ? tr("go straight on through the door") : tr("go straight on through the opening");
    else if (manoeuvre.alongWall && cue.facingWay && !ordinal(manoeuvre.number).isEmpty())
        clause = wallClause(manoeuvre);
    else if (where.isEmpty())
        clause = door ? tr("go through the door") : tr("go through the opening");
    else if (number.isEmpty())
        clause = door ? tr("go through the door %1").arg(where) : tr("go through the opening %1").arg(where);
    else // %1 "third", %2 "on your left"
        clause = door ? tr("go through the %1 door %2").arg(number, where)
                      : tr("go through the %1 opening %2").arg(number, where);
    //: %1 "go through the door", %2 "turn left"
    if (bends) return tr("%1, then %2").arg(clause, turnWords(*manoeuvre.behind));
    // "On your left, turning left" would be heard as two turns.
    const bool saidBySide =
        !where.isEmpty() && cue.hour && (wrapped(manoeuvre.turn).value > 0.0) == (*cue.hour % 12 > 6);
    return manoeuvre.behind || arrives || saidBySide ? clause : withTurn(clause, manoeuvre);
}

/// Which of several doors around a small room: hand and cane find it along the wall.
QString Phrasebook::wallClause(const Manoeuvre& manoeuvre) {
    const bool left = manoeuvre.side == Side::Left;
    const QString number = ordinal(manoeuvre.number);
    if (manoeuvre.kind == ManoeuvreKind::Opening)
        return left ? tr("follow the wall on your left and go through the opening")
                    : tr("follow the wall on your right and go through the opening");
    //: %1 "second"
    return left ? tr("follow the wall on your left and go through the %1 door").arg(number)
                : tr("follow the wall on your right and go through the %1 door").arg(number);
}

QString Phrasebook::withTurn(const QString& clause, const Manoeuvre& manoeuvre) const {
    if (changesLevel(manoeuvre.kind) || verticalOf(manoeuvre) != Vertical::None) return clause;
    const QString turning = turningWords(manoeuvre.turn);
    //: %1 "go through the door", %2 "turning left"
    return turning.isEmpty() ? clause : tr("%1, %2").arg(clause, turning);
}

/// "go through the door, then turn left": in lower case and without a stop, to stand alone or behind "then".
QString Phrasebook::clause(const Cue& cue) const {
    const Manoeuvre& manoeuvre = *cue.manoeuvre;
    if (manoeuvre.kind == ManoeuvreKind::Turn) return turnWords(manoeuvre.turn);
    if (manoeuvre.kind == ManoeuvreKind::Start) return tr("move forward");
    if (manoeuvre.kind == ManoeuvreKind::Arrive) return tr("your destination");
    const Feature feature = featureOf(manoeuvre);
    if (feature == Feature::Door || feature == Feature::Opening) return gapClause(cue);
    if (cue.staying) {
        const QString level = levelWords(cue);
        return level.isEmpty() ? tr("stay in the lift") : tr("stay in the lift until: %1").arg(level);
    }
    return withTurn(action(feature), manoeuvre);
}

/// What follows at once, as a clause behind "then, straight away".
QString Phrasebook::nextClause(const Cue& cue) const {
    if (isPair(cue) && cue.intoKind != RegionKind::Elevator && cue.fromKind != RegionKind::Elevator)
        return cue.next->kind == ManoeuvreKind::Door ? tr("go straight on through the next door")
                                                     : tr("go straight on through the next opening");
    Cue second;
    second.kind = CueKind::Prepare; // with its number: it is counted from the first
    second.manoeuvre = cue.next;
    second.fromKind = cue.intoKind;
    second.facingWay = true;
    return clause(second);
}

/// The same in a word or two, behind something announced from afar: "a door on your left".
QString Phrasebook::nextNoun(const Cue& cue) const {
    const Feature feature = featureOf(*cue.next);
    if (feature == Feature::None || cue.next->alongWall) return nextClause(cue);
    const QString where = sideWords(cue.next->side);
    //: %1 "a door", %2 "on your left"
    return where.isEmpty() ? featureNoun(feature)
                           : tr("%1 %2", "what and where").arg(featureNoun(feature), where);
}

/// "after the extinguisher on your left"
QString Phrasebook::markClause(const Cue& cue) const {
    if (!cue.mark) return {};
    QString mark = markWords(cue.mark->kind);
    if (mark.isEmpty() || cue.mark->side == Side::None) return mark;
    //: %1 "after the extinguisher", %2 "on your left"
    return tr("%1 %2", "what and where").arg(mark, sideWords(cue.mark->side));
}

QString Phrasebook::levelWords(const Cue& cue) {
    return spoken::level(cue.levelName, tr("level %1"), tr("minus %1"),
                         QLocale(installedLanguage()).decimalPoint());
}

/// The place one comes to: its name, else what it is. Stairwells and lifts are felt.
QString Phrasebook::intoWords(const Cue& cue) {
    if (cue.intoKind == RegionKind::Stairwell || cue.intoKind == RegionKind::Elevator) return {};
    const QString name = spoken::name(cue.intoName);
    return name.isEmpty() ? regionWord(cue.intoKind) : name;
}

QString Phrasebook::stepsSentence(const Manoeuvre& manoeuvre) {
    if (manoeuvre.kind != ManoeuvreKind::Stairs || !manoeuvre.steps || *manoeuvre.steps <= 0) return {};
    return *manoeuvre.steps > kMostStepsCounted ? tr("It is a long flight.")
                                                : tr("%n step(s).", nullptr, *manoeuvre.steps);
}

/// "At the top: level 2, Gallery."
QString Phrasebook::placeBehind(const Cue& cue, const Manoeuvre& manoeuvre) {
    const bool arrives = cue.next && cue.next->kind == ManoeuvreKind::Arrive;
    const Vertical vertical = verticalOf(manoeuvre);
    QStringList place;
    if (changesLevel(manoeuvre.kind) && manoeuvre.kind != ManoeuvreKind::Elevator) place << levelWords(cue);
    const bool isPlace = manoeuvre.kind != ManoeuvreKind::Turn && manoeuvre.kind != ManoeuvreKind::Arrive;
    // On arrival the name is told anyway; before, it would only make the order longer.
    const bool told = arrives && cue.kind == CueKind::Act && !cue.asked;
    if (isPlace && !told) place << intoWords(cue);
    if (arrives) place << tr("your destination");
    place.removeAll(QString());
    if (place.isEmpty() || cue.staying) return {};
    const QString where = place.join(QStringLiteral(", "));
    if (!changesLevel(manoeuvre.kind)) return tr("Next: %1.").arg(where);
    if (manoeuvre.kind == ManoeuvreKind::Elevator) return tr("When you get out: %1.").arg(where);
    if (vertical == Vertical::Up) return tr("At the top: %1.").arg(where);
    if (vertical == Vertical::Down) return tr("At the bottom: %1.").arg(where);
    return tr("Next: %1.").arg(where);
}

/// What comes with the manoeuvre: steps, the button to press, the place one comes to, what to do right after.
/// Announced from afar, only what one has to know by then.
QString Phrasebook::tail(const Cue& cue, const Manoeuvre& manoeuvre) const {
    if (cue.sure && cue.firstM) return {}; // far off: told again before it counts
    QStringList sentences{stepsSentence(manoeuvre)};
    const bool follows = followsAtOnce(cue);
    const bool isPrepare = cue.kind == CueKind::Prepare && !cue.asked;
    if (!isPrepare) {
        const QString level = levelWords(cue);
        if (manoeuvre.kind == ManoeuvreKind::Elevator && !level.isEmpty() && !cue.staying)
            sentences << tr("Inside, choose: %1.").arg(level);
        if (!follows || changesLevel(manoeuvre.kind)) sentences << placeBehind(cue, manoeuvre);
    }
    if (follows && !isPrepare && !saidAsPair(cue))
        sentences << tr("Then, straight away, %1.").arg(nextClause(cue));
    return spoken::joined(sentences);
}

/// A manoeuvre that is not due yet, behind words such as "Soon": "Soon, go through the second door on your
/// left."
QString Phrasebook::announced(const Cue& cue, const QString& opener, const Manoeuvre& manoeuvre) const {
    const Feature feature = featureOf(manoeuvre);
    if (manoeuvre.kind == ManoeuvreKind::Arrive) {
        const QString into = spoken::name(cue.intoName.empty() ? cue.regionName : cue.intoName);
        return into.isEmpty() ? tr("%1: your destination.").arg(opener)
                              : tr("%1: your destination, %2.").arg(opener, into);
    }
    const bool isPrepare = cue.kind == CueKind::Prepare && !cue.asked;
    const bool isGap = feature == Feature::Door || feature == Feature::Opening;
    const bool asNoun = isPrepare && !isGap && feature != Feature::None && !cue.staying;
    QString what = asNoun ? featureNoun(feature) : clause(cue);
    if (asNoun && cue.hour) what = tr("%1, %2", "what is around").arg(what, whereWords(*cue.hour));
    const QString mark = markClause(cue);
    //: %1 "turn left", %2 "after the extinguisher"
    if (!mark.isEmpty()) what = tr("%1, %2", "mark").arg(what, mark);
    // Two things at once are enough.
    const bool bends = manoeuvre.behind && std::abs(manoeuvre.behind->value) >= kTurnTold;
    if (isPrepare && followsAtOnce(cue) && !isPair(cue) && !bends && mark.isEmpty())
        what = tr("%1, then %2").arg(what, nextNoun(cue));
    //: %1 "Soon", %2 "stairs up"
    const QString head = asNoun ? tr("%1: %2.", "when, what comes").arg(opener, what)
                                //: %1 "Soon", %2 "go through the door"
                                : tr("%1, %2.", "when, what to do").arg(opener, what);
    return spoken::joined({head, tail(cue, manoeuvre)});
}

/// The same where a way begins. Where nobody knows yet which way the user faces, "turn left" would be heard
/// as an order for this spot: a turn is told as a bend of the way.
QString Phrasebook::announcedFirst(const Cue& cue, const QString& opener, const Manoeuvre& manoeuvre) const {
    const bool bend =
        manoeuvre.kind == ManoeuvreKind::Turn && !(cue.facingWay && cue.kind == CueKind::OffRoute);
    const QString turning = bend ? turningWords(manoeuvre.turn) : QString();
    if (turning.isEmpty()) return announced(cue, opener, manoeuvre);
    //: %1 "First", %2 "turning left"
    return spoken::joined({tr("%1: a bend. Follow it, %2.").arg(opener, turning), tail(cue, manoeuvre)});
}

QString Phrasebook::act(const Cue& cue) const {
    if (!cue.manoeuvre) return {};
    const Manoeuvre& manoeuvre = *cue.manoeuvre;
    if (manoeuvre.kind == ManoeuvreKind::Arrive) {
        const QString into = spoken::name(cue.intoName.empty() ? cue.regionName : cue.intoName);
        if (into.isEmpty())
            return cue.sure ? tr("Your destination is here.") : tr("Your destination is probably here.");
        return (cue.sure ? tr("Your destination is here: %1.") : tr("Your destination is probably here: %1."))
            .arg(into);
    }
    if (const QString turning = facing(cue); !turning.isEmpty())
        return spoken::joined({turning, announced(cue, tr("Then"), manoeuvre)});
    const Feature feature = featureOf(manoeuvre);
    const bool isGap = feature == Feature::Door || feature == Feature::Opening;
    QString lead;
    if (feature != Feature::None && !isGap && cue.hour)
        lead = placeSentence(feature, cue.sure).arg(whereWords(*cue.hour));
    else if (!cue.sure)
        lead = nearSentence(manoeuvre);
    return spoken::joined({lead, spoken::sentence(clause(cue)), tail(cue, manoeuvre)});
}

QString Phrasebook::itinerary(const Cue& cue) const {
    constexpr std::size_t kMostSteps = 8; // more nobody keeps in mind
    QStringList sentences;
    const QString destination = spoken::name(cue.regionName);
    if (!destination.isEmpty()) sentences << tr("Destination: %1.").arg(destination);
    const int count = cue.sure ? counted(cue.distanceM) : 0;
    if (count > 0) sentences << length(count);
    const std::size_t told = std::min(cue.steps.size(), kMostSteps);
    for (std::size_t i = 0; i < told; ++i) {
        const Cue& step = cue.steps[i];
        if (!step.manoeuvre) continue;
        Cue asked = step;
        asked.asked = true;
        const QString opener = i == 0 ? tr("First") : tr("Then");
        sentences << (i == 0 ? announcedFirst(asked, opener, *step.manoeuvre)
                             : announced(asked, opener, *step.manoeuvre));
    }
    const int more = static_cast<int>(cue.steps.size() - told);
    if (more > 0) sentences << tr("And %n more thing(s) to do after that.", nullptr, more);
    return spoken::joined(sentences);
}

} // namespace farol::ui
