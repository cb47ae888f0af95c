#pragma once
// The plan on paper: a page for each level, with its name and a scale bar.

#include "ui/map/map_overlay.h"

#include <QString>

#include <memory>

namespace farol::ui {

/// False when the file cannot be written.
bool printPlan(const std::shared_ptr<const building::Building>& building, const MapOverlay& overlay,
               const QString& file);

} // namespace farol::ui
