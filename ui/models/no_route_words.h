#pragma once
// Why there is no way, in the user's language.

#include "core/building/building.h"
#include "core/routing/route.h"

#include <QCoreApplication>
#include <QString>

namespace farol::ui {

class NoRouteWords {
    Q_DECLARE_TR_FUNCTIONS(farol::ui::NoRouteWords)

public:
    static QString sentence(const building::Building& building, const routing::NoRoute& why);

private:
    static QString avoided(routing::Obstacle obstacle); ///< "stairs"
    static QString barrier(const building::Building& building, const routing::NoRoute::Barrier& barrier);
};

} // namespace farol::ui
