#pragma once
// Short words that several tables and labels share. Sentences are the Phrasebook's.

#include "core/building/building.h"
#include "core/localisation/localiser.h"
#include "core/recognition/detection.h"
#include "ui/speech/speech_queue.h"

#include <QCoreApplication>
#include <QString>

namespace farol::ui {

class Words {
    Q_DECLARE_TR_FUNCTIONS(farol::ui::Words)

public:
    static QString regionKind(building::RegionKind kind);
    static QString accessKind(building::AccessKind kind);
    /// "level 2"
    static QString level(const building::Building& building, double ordinal);
    /// A feature of the map in a few words: "Room 2.14 (room)", "door between A and B (closed)".
    static QString about(const building::Region& region);
    static QString about(const building::Building& building, const building::Access& access);
    static QString about(const building::Building& building, const building::Landmark& landmark);
    /// What a detection is called: its text, else the trained name, else nothing.
    static QString detectionName(const recognition::Detection& detection);
    static QString utteranceState(UtteranceState state);
    static QString cause(const guidance::Cue& cue);
    /// How sure a place is, in words: never a bare percentage, because the figure is no probability.
    static QString sureness(double confidence, double sureFrom);
    /// A reason that has no words is shown as core calls it.
    static bool knowsRejection(const std::string& reason);
    static QString rejection(const recognition::Rejection& rejection);
    /// One part of a vote (paper 4.2), such as "on the way".
    static QString voteTerm(const std::string& name);
};

} // namespace farol::ui
