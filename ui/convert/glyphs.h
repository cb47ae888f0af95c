#pragma once
// Small line drawings, kept as text and painted in any colour and size: the buttons' icons and the map's
// symbols. They follow the palette, so they are as legible on dark windows as on light ones.

#include "core/base/kind.h"
#include "core/building/building.h"

#include <QIcon>
#include <QPainterPath>
#include <QPalette>

#include <string_view>

class QPainter;

namespace farol::ui {

enum class Glyph {
    Play,
    Pause,
    Step,
    Stop,
    Repeat,
    Sound,
    Mute,
    Record,
    Fit,
    ZoomIn,
    ZoomOut,
    Map,
    Library,
    Camera,
    Clear,
    Go,
    Import,
    Save,
    Undo,
    Redo,
    AddLandmark,
    AddDoor,
    Edit,
    Remove,
    Check,
    Alike,
    Print,
    WrongTurn,
    Cover,
    Lamp,
    Visitor
};

/// Commands on a 24 x 24 board, y down: "M x y" move, "L x y" line, "Z" close, "R x y w h" box, "O x y r"
/// circle. An unknown command ends the drawing.
QPainterPath glyphPath(std::string_view commands);

const QPainterPath& pathOf(Glyph glyph);
const QPainterPath& pathOf(Kind kind);
/// Door, opening, stairs, lift, escalator, ramp, window.
const QPainterPath& pathOf(building::AccessKind kind);

/// Strokes (or fills) a drawing into a square around `centre`.
void paintGlyph(QPainter& painter, const QPainterPath& path, QPointF centre, double size,
                const QColor& colour, bool filled = false);
/// An icon in the palette's text colour, with its greyed form.
QIcon glyphIcon(Glyph glyph, const QPalette& palette);

} // namespace farol::ui
