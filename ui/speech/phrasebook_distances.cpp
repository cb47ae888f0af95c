// How far: in metres, feet or steps.

#include "ui/speech/phrasebook.h"
#include "ui/speech/spoken.h"

namespace farol::ui {

namespace {

constexpr double kFootM = 0.3048;
constexpr double kStepM = 0.7;

double unitM(DistanceUnit unit) {
    switch (unit) {
    case DistanceUnit::Feet:
        return kFootM;
    case DistanceUnit::Steps:
        return kStepM;
    case DistanceUnit::Metres:
        break;
    }
    return 1.0;
}

} // namespace

int Phrasebook::counted(const std::optional<double>& distanceM) const {
    return distanceM ? spoken::metres(*distanceM / unitM(m_unit)) : 0;
}

QString Phrasebook::length(int count) const {
    switch (m_unit) {
    case DistanceUnit::Feet:
        return tr("About %n foot(feet).", "length of the route", count);
    case DistanceUnit::Steps:
        return tr("About %n step(s).", "length of the route", count);
    case DistanceUnit::Metres:
        break;
    }
    return tr("About %n metre(s).", "length of the route", count);
}

QString Phrasebook::ahead(int count) const {
    switch (m_unit) {
    case DistanceUnit::Feet:
        return tr("In about %n foot(feet)", "then what is there", count);
    case DistanceUnit::Steps:
        return tr("In about %n step(s)", "then what is there", count);
    case DistanceUnit::Metres:
        break;
    }
    return tr("In about %n metre(s)", "then what is there", count);
}

QString Phrasebook::keepMoving(int count) const {
    switch (m_unit) {
    case DistanceUnit::Feet:
        return tr("Keep moving forward for about %n foot(feet).", nullptr, count);
    case DistanceUnit::Steps:
        return tr("Keep moving forward for about %n step(s).", nullptr, count);
    case DistanceUnit::Metres:
        break;
    }
    return tr("Keep moving forward for about %n metre(s).", nullptr, count);
}

} // namespace farol::ui
