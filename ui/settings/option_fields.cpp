#include "ui/settings/option_fields.h"

namespace farol::ui {

const std::vector<OptionField<guidance::GuidanceOptions>>& guidanceFields() {
    using O = guidance::GuidanceOptions;
    static const std::vector<OptionField<O>> kFields{
        {"prepare-distance", QT_TRANSLATE_NOOP("farol::ui::OptionFields", "Announce what comes within"), "m",
         &O::prepareDistanceM, 5.5, 30.0, 0.5},
        {"act-distance", QT_TRANSLATE_NOOP("farol::ui::OptionFields", "Say “now” within"), "m",
         &O::actDistanceM, 0.5, 5.0, 0.1},
        {"reassure-every", QT_TRANSLATE_NOOP("farol::ui::OptionFields", "Reassure every"), "m",
         &O::reassureEveryM, 3.0, 100.0, 1.0},
        {"reassure-every-s",
         QT_TRANSLATE_NOOP("farol::ui::OptionFields", "Reassure, where no distance is known, every"), "s",
         &O::reassureEverySeconds, 5.0, 120.0, 1.0},
        {"repeat-after", QT_TRANSLATE_NOOP("farol::ui::OptionFields", "Repeat an instruction after"), "s",
         &O::repeatAfterSeconds, 5.0, 120.0, 1.0},
        {"object-repeat", QT_TRANSLATE_NOOP("farol::ui::OptionFields", "Tell an object again after"), "s",
         &O::objectRepeatSeconds, 5.0, 600.0, 5.0},
        {"unsure-after",
         QT_TRANSLATE_NOOP("farol::ui::OptionFields", "Say that the place is not known after"), "s",
         &O::unsureAfterSeconds, 3.0, 60.0, 1.0},
        {"off-route-repeat",
         QT_TRANSLATE_NOOP("farol::ui::OptionFields", "Say again that the route was left after"), "s",
         &O::offRouteRepeatSeconds, 5.0, 120.0, 1.0},
    };
    return kFields;
}

const std::vector<OptionField<routing::RouteOptions>>& routeFields() {
    using O = routing::RouteOptions;
    static const std::vector<OptionField<O>> kFields{
        {"avoid-stairs", QT_TRANSLATE_NOOP("farol::ui::OptionFields", "Avoid stairs"), "", &O::avoidStairs},
        {"avoid-elevator", QT_TRANSLATE_NOOP("farol::ui::OptionFields", "Avoid lifts"), "",
         &O::avoidElevator},
        {"avoid-escalator", QT_TRANSLATE_NOOP("farol::ui::OptionFields", "Avoid escalators"), "",
         &O::avoidEscalator},
        {"avoid-walkway", QT_TRANSLATE_NOOP("farol::ui::OptionFields", "Avoid moving walkways"), "",
         &O::avoidWalkway},
        {"avoid-ramp", QT_TRANSLATE_NOOP("farol::ui::OptionFields", "Avoid ramps"), "", &O::avoidRamp},
        {"avoid-narrow", QT_TRANSLATE_NOOP("farol::ui::OptionFields", "Avoid narrow doors"), "",
         &O::avoidNarrow},
        {"avoid-restricted", QT_TRANSLATE_NOOP("farol::ui::OptionFields", "Avoid restricted places"), "",
         &O::avoidRestricted},
        {"walking-speed", QT_TRANSLATE_NOOP("farol::ui::OptionFields", "Walking speed"), "m/s",
         &O::walkingSpeed, 0.2, 2.0, 0.1},
        {"door-seconds", QT_TRANSLATE_NOOP("farol::ui::OptionFields", "Time to find and pass a door"), "s",
         &O::doorSeconds, 0.0, 60.0, 1.0},
        {"stairs-seconds", QT_TRANSLATE_NOOP("farol::ui::OptionFields", "Time for the stairs of a level"),
         "s", &O::stairsSecondsPerLevel, 1.0, 300.0, 5.0},
        {"lift-seconds", QT_TRANSLATE_NOOP("farol::ui::OptionFields", "Time to wait for a lift and ride it"),
         "s", &O::elevatorSeconds, 1.0, 600.0, 5.0},
    };
    return kFields;
}

const std::vector<OptionField<recognition::RecogniserOptions>>& recogniserFields() {
    using O = recognition::RecogniserOptions;
    static const std::vector<OptionField<O>> kFields{
        {"object-points", QT_TRANSLATE_NOOP("farol::ui::OptionFields", "Points that must fit an object"), "",
         &O::minInliers, 4, 40, 1},
        {"object-odds", QT_TRANSLATE_NOOP("farol::ui::OptionFields", "Evidence that an object needs"), "",
         &O::minLogOdds, 0.0, 8.0, 0.25},
        {"place-points", QT_TRANSLATE_NOOP("farol::ui::OptionFields", "Points that must fit a known place"),
         "", &O::minPlaceInliers, 8, 60, 1},
        {"sharpness", QT_TRANSLATE_NOOP("farol::ui::OptionFields", "Sharpness that a picture needs"), "",
         &O::minSharpness, 0.0, 20.0, 0.5},
    };
    return kFields;
}

} // namespace farol::ui
