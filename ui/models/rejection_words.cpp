// Why a candidate was not accepted, in words. The stable words are core's.

#include "ui/convert/convert.h"
#include "ui/models/words.h"

#include <algorithm>
#include <iterator>

namespace farol::ui {

namespace {

struct Reason {
    const char* word;
    const char* text;
};

constexpr const char* kContext = "farol::ui::Words";

constexpr Reason kReasons[]{
    {"above_the_floor", QT_TRANSLATE_NOOP("farol::ui::Words", "does not reach the floor")},
    {"ambiguous_place", QT_TRANSLATE_NOOP("farol::ui::Words", "two places look alike")},
    {"beside_an_edge", QT_TRANSLATE_NOOP("farol::ui::Words", "part of the number may be hidden")},
    {"blurred", QT_TRANSLATE_NOOP("farol::ui::Words", "blurred")},
    {"busy_leaf", QT_TRANSLATE_NOOP("farol::ui::Words", "too many lines for a door")},
    {"contradicted", QT_TRANSLATE_NOOP("farol::ui::Words", "looked at again, it was something else")},
    {"cut", QT_TRANSLATE_NOOP("farol::ui::Words", "the scene changed")},
    {"even_spacing", QT_TRANSLATE_NOOP("farol::ui::Words", "lines evenly apart, as of a shelf")},
    {"few_edges", QT_TRANSLATE_NOOP("farol::ui::Words", "too few step edges")},
    {"few_inliers", QT_TRANSLATE_NOOP("farol::ui::Words", "too few points fit")},
    {"flat_lines", QT_TRANSLATE_NOOP("farol::ui::Words", "lines, but no steps")},
    {"floor_spacing", QT_TRANSLATE_NOOP("farol::ui::Words", "lines apart as of floor tiles")},
    {"folded_quad", QT_TRANSLATE_NOOP("farol::ui::Words", "outline folded")},
    {"frames_too_far_apart", QT_TRANSLATE_NOOP("farol::ui::Words", "pictures too far apart to follow it")},
    {"grid", QT_TRANSLATE_NOOP("farol::ui::Words", "a grid, as of tiles or windows")},
    {"high_steps", QT_TRANSLATE_NOOP("farol::ui::Words", "too high for steps")},
    {"impossible_size", QT_TRANSLATE_NOOP("farol::ui::Words", "impossible size")},
    {"inconsistent_motion", QT_TRANSLATE_NOOP("farol::ui::Words", "does not move as one thing")},
    {"jambs_go_on_above", QT_TRANSLATE_NOOP("farol::ui::Words", "its sides go on above it")},
    {"kind_not_asked_for", QT_TRANSLATE_NOOP("farol::ui::Words", "of a kind that is not looked for")},
    {"known_by_its_look", QT_TRANSLATE_NOOP("farol::ui::Words", "told by its trained look instead")},
    {"left_view", QT_TRANSLATE_NOOP("farol::ui::Words", "left the picture")},
    {"lies_across_itself", QT_TRANSLATE_NOOP("farol::ui::Words", "a likeness within one already found")},
    {"line_across", QT_TRANSLATE_NOOP("farol::ui::Words", "a line goes across it")},
    {"line_up_the_middle", QT_TRANSLATE_NOOP("farol::ui::Words", "a line goes up its middle")},
    {"lone_stroke", QT_TRANSLATE_NOOP("farol::ui::Words", "a stroke rather than a letter")},
    {"looks_different", QT_TRANSLATE_NOOP("farol::ui::Words", "looks different now")},
    {"lost_letter", QT_TRANSLATE_NOOP("farol::ui::Words", "a letter was missed")},
    {"lost_point", QT_TRANSLATE_NOOP("farol::ui::Words", "a point was missed")},
    {"lost_space", QT_TRANSLATE_NOOP("farol::ui::Words", "a space was missed")},
    {"low_confidence", QT_TRANSLATE_NOOP("farol::ui::Words", "reading not sure")},
    {"low_contrast", QT_TRANSLATE_NOOP("farol::ui::Words", "too pale")},
    {"low_patch_correlation", QT_TRANSLATE_NOOP("farol::ui::Words", "looks too different")},
    {"low_row", QT_TRANSLATE_NOOP("farol::ui::Words", "too low for stairs")},
    {"low_score", QT_TRANSLATE_NOOP("farol::ui::Words", "not sure enough")},
    {"mirrored_quad", QT_TRANSLATE_NOOP("farol::ui::Words", "seen as in a mirror")},
    {"narrow", QT_TRANSLATE_NOOP("farol::ui::Words", "too narrow")},
    {"narrow_support", QT_TRANSLATE_NOOP("farol::ui::Words", "only a small part fits")},
    {"no_homography", QT_TRANSLATE_NOOP("farol::ui::Words", "the points fit no outline")},
    {"no_letters", QT_TRANSLATE_NOOP("farol::ui::Words", "no letters")},
    {"not_agreed_yet", QT_TRANSLATE_NOOP("farol::ui::Words", "readings do not agree yet")},
    {"not_finite", QT_TRANSLATE_NOOP("farol::ui::Words", "outline without numbers")},
    {"outside_frame", QT_TRANSLATE_NOOP("farol::ui::Words", "mostly outside the picture")},
    {"points_lost", QT_TRANSLATE_NOOP("farol::ui::Words", "lost from sight")},
    {"seen_once", QT_TRANSLATE_NOOP("farol::ui::Words", "seen only once so far")},
    {"sliver_quad", QT_TRANSLATE_NOOP("farol::ui::Words", "only a sliver")},
    {"too_short", QT_TRANSLATE_NOOP("farol::ui::Words", "too few letters")},
    {"too_small", QT_TRANSLATE_NOOP("farol::ui::Words", "too small")},
    {"unconfirmed", QT_TRANSLATE_NOOP("farol::ui::Words", "not seen again")},
    {"uneven_contrast", QT_TRANSLATE_NOOP("farol::ui::Words", "step edges of uneven contrast")},
    {"uneven_spacing", QT_TRANSLATE_NOOP("farol::ui::Words", "step edges unevenly apart")},
    {"unstable_reading", QT_TRANSLATE_NOOP("farol::ui::Words", "read differently each time")},
    {"weak_lintel", QT_TRANSLATE_NOOP("farol::ui::Words", "no top of a door frame")},
    {"wider_above", QT_TRANSLATE_NOOP("farol::ui::Words", "wider above than below")},
};

} // namespace

bool Words::knowsRejection(const std::string& reason) {
    return std::any_of(std::begin(kReasons), std::end(kReasons),
                       [&](const Reason& known) { return reason == known.word; });
}

QString Words::rejection(const recognition::Rejection& rejection) {
    for (const Reason& reason : kReasons)
        if (rejection.reason == reason.word) return QCoreApplication::translate(kContext, reason.text);
    return toQString(rejection.reason).replace(QLatin1Char('_'), QLatin1Char(' '));
}

} // namespace farol::ui
