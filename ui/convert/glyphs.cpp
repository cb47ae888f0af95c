#include "ui/convert/glyphs.h"

#include <QPainter>

#include <array>
#include <charconv>

namespace farol::ui {

namespace {

struct Reader {
    std::string_view rest;

    void skip() {
        while (!rest.empty() && rest.front() == ' ') rest.remove_prefix(1);
    }
    char command() {
        skip();
        if (rest.empty()) return 0;
        const char c = rest.front();
        rest.remove_prefix(1);
        return c;
    }
    double number() {
        skip();
        double value = 0.0;
        const auto result = std::from_chars(rest.data(), rest.data() + rest.size(), value);
        rest.remove_prefix(static_cast<std::size_t>(result.ptr - rest.data()));
        return value;
    }
    QPointF point() {
        const double x = number();
        return {x, number()};
    }
};

constexpr std::array<std::string_view, 31> kGlyphs{
    "M 7 4 L 20 12 L 7 20 Z",                                                                   // Play
    "R 6 4 4 16 R 14 4 4 16",                                                                   // Pause
    "M 5 5 L 15 12 L 5 19 Z R 17 5 2.5 14",                                                     // Step
    "R 5 5 14 14",                                                                              // Stop
    "M 5 12 L 5 7 L 18 7 M 15 4 L 18 7 L 15 10 M 19 12 L 19 17 L 6 17 M 9 14 L 6 17 L 9 20",    // Repeat
    "M 4 9 L 8 9 L 13 5 L 13 19 L 8 15 L 4 15 Z M 16 9 L 18 12 L 16 15 M 18 6 L 21 12 L 18 18", // Sound
    "M 4 9 L 8 9 L 13 5 L 13 19 L 8 15 L 4 15 Z M 16 9 L 21 15 M 21 9 L 16 15",                 // Mute
    "O 12 12 7",                                                                                // Record
    "M 4 9 L 4 4 L 9 4 M 15 4 L 20 4 L 20 9 M 20 15 L 20 20 L 15 20 M 9 20 L 4 20 L 4 15",      // Fit
    "O 10 10 6 M 14.5 14.5 L 20 20 M 7 10 L 13 10 M 10 7 L 10 13",                              // ZoomIn
    "O 10 10 6 M 14.5 14.5 L 20 20 M 7 10 L 13 10",                                             // ZoomOut
    "M 3 6 L 9 4 L 15 6 L 21 4 L 21 18 L 15 20 L 9 18 L 3 20 Z M 9 4 L 9 18 M 15 6 L 15 20",    // Map
    "R 4 5 16 14 M 4 15 L 9 10 L 13 14 L 16 11 L 20 15 O 15.5 8.5 1.2",                         // Library
    "R 3 7 18 12 O 12 13 3.5 M 8 7 L 10 4.5 L 14 4.5 L 16 7",                                   // Camera
    "M 6 6 L 18 18 M 18 6 L 6 18",                                                              // Clear
    "M 4 12 L 19 12 M 13 6 L 19 12 L 13 18",                                                    // Go
    "M 12 3 L 12 14 M 8 10 L 12 14 L 16 10 M 4 15 L 4 20 L 20 20 L 20 15",                      // Import
    "M 4 4 L 17 4 L 20 7 L 20 20 L 4 20 Z R 8 4 7 5 R 7 13 10 7",                               // Save
    "M 9 5 L 4 10 L 9 15 M 4 10 L 16 10 L 20 14 L 20 19",                                       // Undo
    "M 15 5 L 20 10 L 15 15 M 20 10 L 8 10 L 4 14 L 4 19",                                      // Redo
    "O 9 9 4.5 M 9 14 L 9 21 M 18 13 L 18 21 M 14 17 L 22 17",                                  // AddLandmark
    "R 4 3 9 18 O 10.5 12 0.8 M 18 13 L 18 21 M 14 17 L 22 17",                                 // AddDoor
    "M 5 19 L 6 15 L 16 5 L 19 8 L 9 18 Z M 14 7 L 17 10",                                      // Edit
    "M 5 7 L 19 7 M 9 7 L 10 4 L 14 4 L 15 7 M 7 7 L 8 20 L 16 20 L 17 7 M 12 10 L 12 17",      // Remove
    "M 4 12 L 10 18 L 20 6",                                                                    // Check
    "R 3 6 8 12 R 13 6 8 12 M 5.5 12 L 8.5 12 M 15.5 12 L 18.5 12",                             // Alike
    "R 7 3 10 5 R 4 8 16 8 R 7 14 10 7",                                                        // Print
    "M 12 21 L 12 13 M 12 13 L 5 6 M 5 10 L 5 6 L 9 6 M 12 13 L 19 6 M 15 3 L 21 9",            // WrongTurn
    "R 3 7 18 12 O 12 13 3.5 M 3 21 L 21 4",                                                    // Cover
    "M 9 18 L 15 18 M 10 21 L 14 21 M 9 18 L 9 15 L 6 11 L 7 6 L 12 3 L 17 6 L 18 11 L 15 15 L 15 18", // Lamp
    "O 12 6 3 M 12 9 L 12 15 M 6 12 L 18 12 M 12 15 L 8 21 M 12 15 L 16 21", // Visitor
};

// In the order of enum class Kind.
constexpr std::array<std::string_view, 20> kKinds{
    "M 12 21 L 5 8 L 19 8 Z O 12 19 1.2",                                    // Place: a view cone
    "R 7 3 10 18 O 14.5 12 0.9",                                             // Door
    "M 2 21 L 8 21 L 8 15 L 15 15 L 15 9 L 22 9 L 22 3",                     // Stairs
    "R 5 3 14 18 M 9 10 L 12 6 L 15 10 Z M 9 14 L 12 18 L 15 14 Z",          // Elevator
    "R 9 8 6 13 M 12 8 L 12 5 L 17 5 M 12 5 L 8 3",                          // Extinguisher
    "R 3 6 18 12 M 7 12 L 16 12 M 13 9 L 16 12 L 13 15",                     // ExitSign
    "R 4 4 16 10 M 12 14 L 12 21 M 7 9 L 17 9",                              // Sign
    "M 6 6 L 18 6 M 12 6 L 12 19",                                           // Text
    "R 5 6 14 12",                                                           // Rectangle
    "R 5 4 14 16 M 12 4 L 12 20 M 5 12 L 19 12",                             // Window
    "R 5 3 14 18 M 12 3 L 12 21 M 8 7 L 10 7 M 14 7 L 16 7",                 // Locker
    "R 6 4 12 16 M 9 8 L 15 8 M 9 12 L 15 12 M 9 16 L 13 16",                // Poster
    "M 5 10 L 19 10 L 16 16 L 8 16 Z M 12 16 L 12 21 M 12 10 L 12 5 L 15 5", // Fountain
    "R 8 9 8 11 M 6 20 L 18 20 M 10 9 L 10 5 L 14 5 L 14 9 M 5 13 L 8 13 M 16 13 L 19 13", // Hydrant
    "R 5 3 14 18 R 8 6 5 8 M 16 7 L 16 9 M 8 17 L 13 17",                                  // VendingMachine
    "M 6 8 L 18 8 L 16.5 21 L 7.5 21 Z M 9 8 L 10 4 L 14 4 L 15 8",                        // Bin
    "M 8 15 L 16 15 L 15 21 L 9 21 Z M 12 15 L 12 8 M 12 11 L 7 6 M 12 9 L 16 4",          // Plant
    "M 6 4 L 6 21 M 6 13 L 18 13 L 18 21 M 6 13 L 18 13",                                  // Furniture
    "R 4 5 16 14 M 4 16 L 10 10 L 16 16 O 15 9 1.5",                                       // Picture
    "O 12 12 6",                                                                           // Other
};

// In the order of enum class AccessKind.
constexpr std::array<std::string_view, 8> kAccesses{
    "M 4 19 L 4 5 M 4 5 L 11 7 L 16 11 L 18 19",                             // Door: leaf and swing
    "M 4 6 L 4 18 M 20 6 L 20 18",                                           // Opening
    "M 2 21 L 8 21 L 8 15 L 15 15 L 15 9 L 22 9 L 22 3",                     // Stairs
    "R 4 3 16 18 M 8 10 L 12 6 L 16 10 Z M 8 14 L 12 18 L 16 14 Z",          // Elevator
    "M 3 19 L 8 19 L 16 8 L 21 8 M 10 8 L 13 5 M 13 5 L 13 8 M 13 5 L 10 5", // Escalator
    "M 3 18 L 21 18 L 21 10 Z",                                              // Ramp
    "M 4 10 L 20 10 M 4 14 L 20 14",                                         // Window
    "O 12 12 5",                                                             // Other
};

template <std::size_t N>
const QPainterPath& cached(const std::array<std::string_view, N>& texts, std::size_t index) {
    static std::array<QPainterPath, N> paths = [&] {
        std::array<QPainterPath, N> made;
        for (std::size_t i = 0; i < N; ++i) made[i] = glyphPath(texts[i]);
        return made;
    }();
    return paths[index < N ? index : N - 1];
}

bool isSolid(Glyph glyph) {
    return glyph == Glyph::Play || glyph == Glyph::Pause || glyph == Glyph::Step || glyph == Glyph::Stop;
}

} // namespace

QPainterPath glyphPath(std::string_view commands) {
    QPainterPath path;
    Reader reader{commands};
    for (;;) {
        switch (reader.command()) {
        case 'M':
            path.moveTo(reader.point());
            break;
        case 'L':
            path.lineTo(reader.point());
            break;
        case 'Z':
            path.closeSubpath();
            break;
        case 'R': {
            const QPointF corner = reader.point();
            const QPointF size = reader.point();
            path.addRect(corner.x(), corner.y(), size.x(), size.y());
            break;
        }
        case 'O': {
            const QPointF centre = reader.point();
            const double radius = reader.number();
            path.addEllipse(centre, radius, radius);
            break;
        }
        default:
            return path;
        }
    }
}

const QPainterPath& pathOf(Glyph glyph) {
    return cached(kGlyphs, static_cast<std::size_t>(glyph));
}
const QPainterPath& pathOf(Kind kind) {
    return cached(kKinds, static_cast<std::size_t>(kind));
}
const QPainterPath& pathOf(building::AccessKind kind) {
    return cached(kAccesses, static_cast<std::size_t>(kind));
}

void paintGlyph(QPainter& painter, const QPainterPath& path, QPointF centre, double size,
                const QColor& colour, bool filled) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(centre);
    painter.scale(size / 24.0, size / 24.0);
    painter.translate(-12.0, -12.0);
    painter.setPen(QPen(colour, filled ? 1.0 : 1.9, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(filled ? QBrush(colour) : QBrush(Qt::NoBrush));
    painter.drawPath(path);
    painter.restore();
}

QIcon glyphIcon(Glyph glyph, const QPalette& palette) {
    QIcon icon;
    const QColor record =
        palette.color(QPalette::Window).lightness() < 128 ? QColor(255, 107, 107) : QColor(176, 0, 32);
    const auto add = [&](int size, QIcon::Mode mode, const QColor& colour) {
        QPixmap pixmap(size, size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paintGlyph(painter, pathOf(glyph), {size / 2.0, size / 2.0}, size, colour,
                   isSolid(glyph) || glyph == Glyph::Record);
        painter.end();
        icon.addPixmap(pixmap, mode);
    };
    for (const int size : {16, 20, 24, 32, 48}) {
        add(size, QIcon::Normal,
            glyph == Glyph::Record ? record : palette.color(QPalette::Active, QPalette::ButtonText));
        add(size, QIcon::Disabled, palette.color(QPalette::Disabled, QPalette::ButtonText));
    }
    return icon;
}

} // namespace farol::ui
