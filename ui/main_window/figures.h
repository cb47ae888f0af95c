#pragma once
// What the charts show, made from a walk and a checked library.

#include "core/recognition/library_check.h"
#include "ui/live/walk_timeline.h"
#include "ui/parts/chart_view.h"

#include <QCoreApplication>

#include <array>

namespace farol::ui {

/// How often the place was right, by how sure it was told; only where the truth is known.
struct Calibration {
    std::array<int, 10> told{}, right{};

    void note(double confidence, bool isRight);
};

class Figures {
    Q_DECLARE_TR_FUNCTIONS(farol::ui::Figures)

public:
    /// The five places with the highest votes.
    static Chart votes(const WalkTimeline& timeline, const building::Building* building);
    static Chart latency(const WalkTimeline& timeline);
    static Chart calibration(const Calibration& calibration);
    static Chart ranges(const std::vector<recognition::TemplateCheck>& checks);
};

} // namespace farol::ui
