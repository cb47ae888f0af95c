#include "ui/map/map_colours.h"

#include <algorithm>

namespace farol::ui {

MapColours MapColours::of(bool dark) {
    MapColours c;
    c.dark = dark;
    if (dark) {
        c.outside = QColor(0x1b1e23);
        c.floor = QColor(0x2a2f37);
        c.corridor = QColor(0x323943);
        c.border = QColor(0x6d7683);
        c.wall = QColor(0xaab2be);
        c.text = QColor(0xf2f4f7);
        c.halo = QColor(0x1b1e23);
        c.door = QColor(0x7cc0ff);
        c.shaft = QColor(0xd6a6ff);
        c.closed = QColor(0xff9a9a);
        c.route = QColor(0x4da3ff);
        c.routeCasing = QColor(0x0c1a2b);
        c.passed = QColor(0x8a94a3);
        c.fix = QColor(0xff5fa2);
        c.fixCasing = QColor(0xffffff);
        c.destination = QColor(0x74d991);
    } else {
        c.outside = QColor(0xe9ecf0);
        c.floor = QColor(0xffffff);
        c.corridor = QColor(0xf6f7f9);
        c.border = QColor(0x8b95a3);
        c.wall = QColor(0x3b424d);
        c.text = QColor(0x16191d);
        c.halo = QColor(0xffffff);
        c.door = QColor(0x0b57a4);
        c.shaft = QColor(0x6a2c91);
        c.closed = QColor(0xa3142b);
        c.route = QColor(0x1769e0);
        c.routeCasing = QColor(0xffffff);
        c.passed = QColor(0x7d8793);
        c.fix = QColor(0xc2185b);
        c.fixCasing = QColor(0xffffff);
        c.destination = QColor(0x0b6b2f);
    }
    return c;
}

QColor MapColours::heat(double share) const {
    const QColor strong = dark ? QColor(0x8a5200) : QColor(0xffb52e);
    const double t = std::clamp(share, 0.0, 1.0);
    const auto mix = [t](int low, int high) { return static_cast<int>(low + t * (high - low)); };
    return {mix(floor.red(), strong.red()), mix(floor.green(), strong.green()),
            mix(floor.blue(), strong.blue())};
}

QColor MapColours::fill(building::RegionKind kind) const {
    switch (kind) {
    case building::RegionKind::Room:
        return dark ? QColor(0x2b3648) : QColor(0xe3ecf9);
    case building::RegionKind::Corridor:
        return dark ? QColor(0x3a3d42) : QColor(0xfdfdfb);
    case building::RegionKind::Hall:
        return dark ? QColor(0x3d3a2c) : QColor(0xfbf4dc);
    case building::RegionKind::Stairwell:
        return dark ? QColor(0x40304c) : QColor(0xecdff5);
    case building::RegionKind::Elevator:
        return dark ? QColor(0x4d3442) : QColor(0xf8dcea);
    case building::RegionKind::Toilet:
        return dark ? QColor(0x234241) : QColor(0xd8f0ec);
    case building::RegionKind::Outside:
        return dark ? QColor(0x29402c) : QColor(0xe0f0dc);
    case building::RegionKind::Other:
        break;
    }
    return dark ? QColor(0x2a2f37) : QColor(0xf0f1f3);
}

RegionMarkStyle regionMarkStyle(RegionMark mark, bool dark) {
    switch (mark) {
    case RegionMark::NoLandmark:
        return {dark ? QColor(0x8a94a3) : QColor(0x7d8793), Qt::BDiagPattern};
    case RegionMark::LooksAlike:
        return {dark ? QColor(0xffb35c) : QColor(0xb35900), Qt::FDiagPattern};
    case RegionMark::LandmarkHelps:
        return {dark ? QColor(0x74d991) : QColor(0x0b6b2f), Qt::CrossPattern};
    case RegionMark::CutOff:
        return {dark ? QColor(0xff9a9a) : QColor(0xa3142b), Qt::DiagCrossPattern};
    case RegionMark::None:
        break;
    }
    return {};
}

} // namespace farol::ui
