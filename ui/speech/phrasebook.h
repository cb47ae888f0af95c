#pragma once
// Words are made here and nowhere else: cues in, sentences in the user's language out. QtCore only.

#include "core/guidance/cue.h"

#include <QCoreApplication>
#include <QString>

namespace farol::ui {

/// How turns and directions are said (Wayfindr: the user chooses). Default for turns: left and right.
enum class DirectionStyle { LeftRight, Clock, Degrees };

/// Text in the language of the installed translators (see installTranslation). Imperative, short, hedged where the
/// cue is not sure; never a metre figure the cue does not carry.
class Phrasebook {
    Q_DECLARE_TR_FUNCTIONS(farol::ui::Phrasebook)

public:
    explicit Phrasebook(DirectionStyle style = DirectionStyle::LeftRight) : m_style(style) {}

    /// The sentence of a cue; empty when there is nothing to say.
    QString sentence(const guidance::Cue& cue) const;
    static QString kindWord(Kind kind);
    static QString zoneWords(Zone zone);
    QString turnWords(Radians turn) const;
    void setStyle(DirectionStyle style) { m_style = style; }

private:
    DirectionStyle m_style;
};

/// Installs farol_<language>.qm (and Qt's own) from the program's resources: "en", "pt", or a locale name such as
/// "pt_BR". False when there is none, and English is used.
bool installTranslation(const QString& language);

} // namespace farol::ui
