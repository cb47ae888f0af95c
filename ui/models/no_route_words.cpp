#include "ui/models/no_route_words.h"

#include "ui/convert/convert.h"

#include <QStringList>

namespace farol::ui {

QString NoRouteWords::avoided(routing::Obstacle obstacle) {
    using routing::Obstacle;
    switch (obstacle) {
    case Obstacle::Stairs:
        return tr("stairs");
    case Obstacle::Elevator:
        return tr("a lift");
    case Obstacle::Escalator:
        return tr("an escalator");
    case Obstacle::Walkway:
        return tr("a moving walkway");
    case Obstacle::Ramp:
        return tr("a ramp");
    case Obstacle::Narrow:
        return tr("a narrow door");
    case Obstacle::Restricted:
        return tr("a restricted region");
    case Obstacle::Closed:
        return tr("a closed door or passage");
    case Obstacle::OneWay:
        return tr("a one-way door or passage");
    }
    return {};
}

QString NoRouteWords::barrier(const building::Building& building, const routing::NoRoute::Barrier& barrier) {
    return tr("%1 (from %2 to %3)")
        .arg(avoided(barrier.obstacle), regionName(&building, barrier.from),
             regionName(&building, barrier.into));
}

QString NoRouteWords::sentence(const building::Building& building, const routing::NoRoute& why) {
    const QString goal = regionName(&building, why.to);
    if (!why.joined())
        return tr("The map joins %1 and %2 in no way.").arg(regionName(&building, why.from), goal);
    QStringList parts;
    if (!why.anyOf.empty()) {
        for (const routing::Obstacle obstacle : why.anyOf) parts << avoided(obstacle);
        return tr("%1 is reached only by what is to be avoided: %2.").arg(goal, parts.join(tr(" or ")));
    }
    for (const routing::NoRoute::Barrier& each : why.past) parts << barrier(building, each);
    return tr("On the way to %1 stands %2.").arg(goal, parts.join(tr(" and ")));
}

} // namespace farol::ui
