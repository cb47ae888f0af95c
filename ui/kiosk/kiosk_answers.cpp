// The one place where a key's question is answered: from the newest picture of the walk.

#include "ui/convert/convert.h"
#include "ui/kiosk/kiosk.h"
#include "ui/models/route_model.h"
#include "ui/models/words.h"
#include "ui/speech/spoken.h"

namespace farol::ui {

using guidance::Cue;
using guidance::CueKind;
using guidance::CuePriority;

namespace {

constexpr int kMostNeighbours = 6; // more, and nobody remembers the first

Cue whereCue(const building::Building& building, const localisation::Fix& fix) {
    Cue cue;
    cue.priority = CuePriority::Arrival;
    cue.time = fix.time;
    cue.kind = CueKind::Located;
    const building::Region* region = fix.region ? building.region(*fix.region) : nullptr;
    if (!region) return cue; // "I do not know yet where you are"
    cue.region = region->id;
    cue.regionName = building::spokenName(*region);
    if (building.levels().size() > 1) cue.levelName = toUtf8(levelLabel(building, region->level));
    cue.sure = fix.confidence >= guidance::GuidanceOptions().sureConfidence;
    return cue;
}

QString neighbours(const building::Building& building, const localisation::Fix& fix) {
    const auto index = fix.region ? building.regionIndex(*fix.region) : std::nullopt;
    QStringList names;
    if (index) {
        for (const std::size_t other : building.neighboursOf(*index)) {
            const building::Region& region = building.regions()[other];
            if ((region.name.empty() && region.ref.empty()) || names.size() >= kMostNeighbours) continue;
            names << spoken::name(building::spokenName(region));
        }
    }
    return names.join(QStringLiteral("; "));
}

} // namespace

void Kiosk::answer(KioskQuestion question) {
    const auto snapshot = m_walk.snapshot();
    const auto building = m_walk.building();
    if (!snapshot || !building) return; // the patience of the machine tells that it takes a moment
    const session::NavigationStep& step = snapshot->step;
    m_machine.answered();
    Phrasebook words(m_settings.directionStyle());
    const QString where = words.sentence(whereCue(*building, step.fix));
    switch (question) {
    case KioskQuestion::WhereAmI:
        return m_speech.say(where);
    case KioskQuestion::AroundMe: {
        const QString near = neighbours(*building, step.fix);
        return m_speech.say(near.isEmpty() ? where
                                           : where + QLatin1Char(' ') + tr("Beside it: %1.").arg(near));
    }
    case KioskQuestion::Next:
    case KioskQuestion::Repeat:
        return step.progress.route ? m_speech.repeatLast() : m_speech.say(where);
    case KioskQuestion::Remaining:
    case KioskQuestion::Preview:
        break;
    }
    if (!step.progress.route) return m_speech.say(where + QLatin1Char(' ') + tr("So I know no way yet."));
    RouteModel route;
    route.setStyle(m_settings.directionStyle());
    route.setRoute(building, step.progress.route);
    QStringList sentences;
    for (int row = 0; row < route.rowCount(); ++row)
        sentences << route.index(row, RouteModel::Sentence).data().toString();
    m_speech.say(spoken::joined(sentences));
}

} // namespace farol::ui
