// What is done at doors, stairs, lifts and turns. A turn at a door is said as "go through the door, turning
// left": the way may bend before the door or behind it, and the route knows only that it bends there. Turns
// at stairs and lifts are not said at all, because nobody knows the way a person faces after them.

#include "ui/speech/phrasebook.h"
#include "ui/speech/spoken.h"

#include <cmath>

namespace farol::ui {

using guidance::Cue;
using routing::ManoeuvreKind;
using routing::Vertical;

namespace {

/// Counting more steps than this distracts (Wayfindr, stairs 5.2).
constexpr int kMostStepsCounted = 12;

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

/// "The door is on your left.", with a marker for the direction.
QString Phrasebook::placeSentence(Feature feature, bool sure) {
    switch (feature) {
    case Feature::Door:
        return sure ? tr("The door is %1.") : tr("The door is probably %1.");
    case Feature::Opening:
        return sure ? tr("The opening is %1.") : tr("The opening is probably %1.");
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

/// What to do with something that was just named: "go through it".
QString Phrasebook::actionThere(Feature feature) {
    switch (feature) {
    case Feature::Door:
        return tr("go through it", "the door");
    case Feature::Opening:
        return tr("go through it", "the opening");
    case Feature::StairsUp:
        return tr("take them up", "the stairs");
    case Feature::StairsDown:
        return tr("take them down", "the stairs");
    case Feature::Stairs:
        return tr("take them, but feel first whether they go up or down", "the stairs");
    case Feature::LiftUp:
        return tr("take it up", "the lift");
    case Feature::LiftDown:
        return tr("take it down", "the lift");
    case Feature::Lift:
        return tr("take it", "the lift");
    case Feature::EscalatorUp:
        return tr("take it up", "the escalator");
    case Feature::EscalatorDown:
        return tr("take it down", "the escalator");
    case Feature::Escalator:
        return tr("take it, but feel first whether it goes up or down", "the escalator");
    case Feature::RampUp:
        return tr("go up it", "the ramp");
    case Feature::RampDown:
        return tr("go down it", "the ramp");
    case Feature::Ramp:
        return tr("follow it", "the ramp");
    case Feature::None:
        break;
    }
    return {};
}

/// The same for something not named yet: "go through the door".
QString Phrasebook::action(Feature feature) {
    switch (feature) {
    case Feature::Door:
        return tr("go through the door");
    case Feature::Opening:
        return tr("go through the opening");
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
    case Feature::None:
        break;
    }
    return {};
}

QString Phrasebook::withTurn(const QString& clause, const Manoeuvre& manoeuvre) const {
    if (changesLevel(manoeuvre.kind) || verticalOf(manoeuvre) != Vertical::None) return clause;
    const QString turning = turningWords(manoeuvre.turn);
    //: %1 "go through the door", %2 "turning left"
    if (!turning.isEmpty()) return tr("%1, %2").arg(clause, turning);
    const bool gap = manoeuvre.kind == ManoeuvreKind::Door || manoeuvre.kind == ManoeuvreKind::Opening;
    //: %1 "go through the door"
    return gap && std::isfinite(manoeuvre.turn.value) ? tr("%1 and straight on").arg(clause) : clause;
}

/// "go through the door, turning left": in lower case and without a stop, to stand alone or behind "then".
QString Phrasebook::clause(const Manoeuvre& manoeuvre) const {
    if (manoeuvre.kind == ManoeuvreKind::Turn) return turnWords(manoeuvre.turn);
    if (manoeuvre.kind == ManoeuvreKind::Start) return tr("move forward");
    if (manoeuvre.kind == ManoeuvreKind::Arrive) return tr("your destination");
    return withTurn(action(featureOf(manoeuvre)), manoeuvre);
}

QString Phrasebook::clauseThere(const Manoeuvre& manoeuvre) const {
    const Feature feature = featureOf(manoeuvre);
    return feature == Feature::None ? clause(manoeuvre) : withTurn(actionThere(feature), manoeuvre);
}

/// What comes with the manoeuvre: steps, the button to press, the place one comes to, what to do right after.
QString Phrasebook::tail(const Cue& cue, const Manoeuvre& manoeuvre) const {
    QStringList sentences;
    const QString into = spoken::name(cue.intoName);
    const QString level = spoken::level(cue.levelName, tr("level %1"), tr("minus %1"));
    const Vertical vertical = verticalOf(manoeuvre);
    const bool counted = manoeuvre.kind == ManoeuvreKind::Stairs && manoeuvre.steps && *manoeuvre.steps > 0;
    if (counted && *manoeuvre.steps > kMostStepsCounted)
        sentences << tr("It is a long flight.");
    else if (counted)
        sentences << tr("%n step(s).", nullptr, *manoeuvre.steps);
    QStringList place;
    if (manoeuvre.kind == ManoeuvreKind::Elevator) {
        if (!level.isEmpty()) sentences << tr("Inside, choose: %1.").arg(level);
    } else if (changesLevel(manoeuvre.kind) && !level.isEmpty()) {
        place << level;
    }
    if (!into.isEmpty() && manoeuvre.kind != ManoeuvreKind::Turn && manoeuvre.kind != ManoeuvreKind::Arrive)
        place << into;
    const bool arrives = cue.next && cue.next->kind == ManoeuvreKind::Arrive;
    if (arrives) place << tr("your destination");
    if (!place.isEmpty()) {
        const QString where = place.join(QStringLiteral(", "));
        if (!changesLevel(manoeuvre.kind))
            sentences << tr("Next: %1.").arg(where);
        else if (manoeuvre.kind == ManoeuvreKind::Elevator)
            sentences << tr("When you get out: %1.").arg(where);
        else if (vertical == Vertical::Up)
            sentences << tr("At the top: %1.").arg(where);
        else if (vertical == Vertical::Down)
            sentences << tr("At the bottom: %1.").arg(where);
        else
            sentences << tr("Next: %1.").arg(where);
    }
    if (cue.next && !arrives && cue.next->kind != ManoeuvreKind::Start) {
        sentences << tr("Then, straight away, %1.").arg(clause(*cue.next));
    }
    return spoken::joined(sentences);
}

/// A manoeuvre that is not due yet, behind words such as "Soon": "Soon: a door. Go through it, turning left."
QString Phrasebook::announced(const Cue& cue, const QString& opener, const Manoeuvre& manoeuvre) const {
    const Feature feature = featureOf(manoeuvre);
    if (manoeuvre.kind == ManoeuvreKind::Arrive) {
        const QString into = spoken::name(cue.intoName.empty() ? cue.regionName : cue.intoName);
        return into.isEmpty() ? tr("%1: your destination.").arg(opener)
                              : tr("%1: your destination, %2.").arg(opener, into);
    }
    if (feature == Feature::None) {
        return spoken::joined({tr("%1, %2.").arg(opener, clause(manoeuvre)), tail(cue, manoeuvre)});
    }
    const QString noun = featureNoun(feature);
    //: %1 "Soon", %2 "a door", %3 "on your left"
    const QString head = cue.hour ? tr("%1: %2, %3.").arg(opener, noun, whereWords(*cue.hour))
                                  : tr("%1: %2.").arg(opener, noun);
    return spoken::joined({head, spoken::sentence(clauseThere(manoeuvre)), tail(cue, manoeuvre)});
}

/// The same where a way begins. Nobody knows yet which way the user faces, so "turn left" would be heard as
/// an order for this spot: a turn is told as a bend of the way.
QString Phrasebook::announcedFirst(const Cue& cue, const QString& opener, const Manoeuvre& manoeuvre) const {
    const QString turning = manoeuvre.kind == ManoeuvreKind::Turn ? turningWords(manoeuvre.turn) : QString();
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
    const Feature feature = featureOf(manoeuvre);
    QString lead;
    if (feature != Feature::None && cue.hour)
        lead = placeSentence(feature, cue.sure).arg(whereWords(*cue.hour));
    else if (!cue.sure)
        lead = nearSentence(manoeuvre);
    const QString order = lead.isEmpty() ? clause(manoeuvre) : clauseThere(manoeuvre);
    return spoken::joined({lead, spoken::sentence(order), tail(cue, manoeuvre)});
}

} // namespace farol::ui
