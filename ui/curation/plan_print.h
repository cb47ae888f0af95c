#pragma once
// The plan on paper: a page for each level, with its name and a scale bar.

#include "ui/map/map_overlay.h"
#include "ui/map/map_scene.h"

#include <QString>

#include <memory>

class QPainter;

namespace farol::ui {

/// One page, with what the overlay shows: the image of the floor, what is seen from where, marks, the route,
/// and a legend of them.
void paintPlanPage(QPainter& painter, const MapScene& scene, const LevelScene& level,
                   const MapOverlay& overlay, QSizeF page);
/// False when the file cannot be written.
bool printPlan(const std::shared_ptr<const building::Building>& building, const MapOverlay& overlay,
               const QString& file);

} // namespace farol::ui
