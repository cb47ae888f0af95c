#pragma once
// Words are made here and nowhere else: cues in, sentences in the user's language out. QtCore only.

#include "core/guidance/cue.h"

#include <QCoreApplication>
#include <QString>

namespace farol::ui {

/// How turns and directions are said (Wayfindr: the user chooses). Default for turns: left and right.
enum class DirectionStyle { LeftRight, Clock, Degrees };

/// How distances are said. A step is one of 0.7 m.
enum class DistanceUnit { Metres, Feet, Steps };

/// Text in the language of the installed translators (see installTranslation). Imperative, short, hedged
/// where the cue is not sure; never a metre figure the cue does not carry.
class Phrasebook {
    Q_DECLARE_TR_FUNCTIONS(farol::ui::Phrasebook)

public:
    explicit Phrasebook(DirectionStyle style = DirectionStyle::LeftRight) : m_style(style) {}

    /// The sentence of a cue; empty when there is nothing to say.
    QString sentence(const guidance::Cue& cue) const;
    static QString kindWord(Kind kind);
    static QString zoneWords(Zone zone);
    /// "turn left", "turn to 9 o'clock", "turn 90 degrees to the left"; "go straight on" for a small angle.
    QString turnWords(Radians turn) const;
    void setStyle(DirectionStyle style) { m_style = style; }
    DirectionStyle style() const { return m_style; }
    void setUnit(DistanceUnit unit) { m_unit = unit; }

private:
    using Manoeuvre = routing::Manoeuvre;
    enum class Feature {
        None,
        Door,
        Opening,
        StairsUp,
        StairsDown,
        Stairs,
        LiftUp,
        LiftDown,
        Lift,
        EscalatorUp,
        EscalatorDown,
        Escalator,
        RampUp,
        RampDown,
        Ramp
    };

    static Feature featureOf(const Manoeuvre& manoeuvre);
    static QString featureNoun(Feature feature);
    static QString placeSentence(Feature feature, bool sure);
    static QString nearSentence(const Manoeuvre& manoeuvre);
    static QString action(Feature feature);
    static QString thingWords(Kind kind);
    static QString hourWord(int hour);
    static QString ordinal(int number);
    static QString markWords(Kind kind);
    static QString regionWord(building::RegionKind kind);
    static QString compassWords(Radians fromNorth);

    QString turnOnTheSpot(Radians turn) const;
    QString turningWords(Radians turn) const;
    QString whereWords(int hour, routing::Side side = routing::Side::None) const;
    QString sideWords(routing::Side side) const;
    QString markClause(const guidance::Cue& cue) const;
    QString gapWhere(const guidance::Cue& cue) const;
    QString gapClause(const guidance::Cue& cue) const;
    static QString wallClause(const routing::Manoeuvre& manoeuvre);
    QString withTurn(const QString& clause, const Manoeuvre& manoeuvre) const;
    QString clause(const guidance::Cue& cue) const;
    QString nextClause(const guidance::Cue& cue) const;
    QString nextNoun(const guidance::Cue& cue) const;
    static QString intoWords(const guidance::Cue& cue);
    static QString levelWords(const guidance::Cue& cue);
    static QString stepsSentence(const Manoeuvre& manoeuvre);
    static QString placeBehind(const guidance::Cue& cue, const Manoeuvre& manoeuvre);
    QString announced(const guidance::Cue& cue, const QString& opener, const Manoeuvre& manoeuvre) const;
    QString announcedFirst(const guidance::Cue& cue, const QString& opener, const Manoeuvre& manoeuvre) const;
    QString tail(const guidance::Cue& cue, const Manoeuvre& manoeuvre) const;

    QString facing(const guidance::Cue& cue) const;
    QString firstOpener(const guidance::Cue& cue, const QString& near) const;
    QString routeStart(const guidance::Cue& cue) const;
    QString prepare(const guidance::Cue& cue) const;
    QString act(const guidance::Cue& cue) const;
    QString reassure(const guidance::Cue& cue) const;
    static QString lookAround(const guidance::Cue& cue);
    static QString sweepWords(guidance::SweepStep step);
    static QString withStop(const guidance::Cue& cue, const QString& sentence);
    QString arrived(const guidance::Cue& cue) const;
    QString offRoute(const guidance::Cue& cue) const;
    static QString offRouteLead(const guidance::Cue& cue);
    QString located(const guidance::Cue& cue) const;
    QString detection(const guidance::Cue& cue) const;
    QString noRoute(const guidance::Cue& cue) const;
    QString alreadyThere(const guidance::Cue& cue) const;
    QString around(const guidance::Cue& cue) const;
    QString whereAround(const guidance::Surrounding& what, guidance::Bearing bearing) const;
    static QString whatAround(const guidance::Surrounding& what);
    QString itinerary(const guidance::Cue& cue) const;
    QString warning(const guidance::Cue& cue) const;

    DirectionStyle m_style;
    DistanceUnit m_unit = DistanceUnit::Metres;

    /// A distance as it is said: coarser the farther it is. 0 when there is nothing to say.
    int counted(const std::optional<double>& distanceM) const;
    QString length(int count) const;     ///< "About 20 metres."
    QString ahead(int count) const;      ///< "In about 20 metres", then what is there
    QString keepMoving(int count) const; ///< "Keep moving forward for about 20 metres."
};

struct Language {
    QString code; ///< "pt"
    QString name; ///< "Português": in itself, so that its speakers find it
};
/// All that the program speaks and shows, complete.
const QList<Language>& languages();
/// Installs farol_<language>.qm (and Qt's own, where it is installed) for the whole program: "en", "pt", … or
/// a locale name such as "pt_BR". False when there is none, and English is used. Needs a QCoreApplication.
bool installTranslation(const QString& language);
/// What the program speaks now: "en", "pt".
QString installedLanguage();

} // namespace farol::ui
