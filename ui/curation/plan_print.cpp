#include "ui/curation/plan_print.h"

#include "ui/convert/convert.h"
#include "ui/curation/plan_panel.h"
#include "ui/map/map_painter.h"
#include "ui/models/words.h"

#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>

#include <algorithm>
#include <set>
#include <vector>

namespace farol::ui {

namespace {

constexpr int kDotsPerInch = 96; // what the painter's widths in pixels are meant for
constexpr double kTitleHeight = 34.0;
constexpr double kLegendGap = 8.0;

/// What stands on this level, in the words and colours of the screen's legend.
std::vector<PlanLegend::Entry> legendOf(const MapScene& scene, const LevelScene& level,
                                        const MapOverlay& overlay) {
    std::set<building::RegionKind> kinds;
    std::set<RegionMark> marks;
    for (const RegionShape& shape : level.regions) {
        kinds.insert(scene.building().regions()[shape.index].kind);
        if (overlay.marks && shape.index < overlay.marks->size()) marks.insert((*overlay.marks)[shape.index]);
    }
    marks.erase(RegionMark::None);
    return PlanLegend::entries({kinds.begin(), kinds.end()}, {marks.begin(), marks.end()},
                               overlay.coverage != nullptr, false);
}

} // namespace

void paintPlanPage(QPainter& painter, const MapScene& scene, const LevelScene& level,
                   const MapOverlay& overlay, QSizeF page) {
    const building::Building& building = scene.building();
    const QString title = toQString(building.data().title);
    const QString name = Words::level(building, level.ordinal);
    QFont font = painter.font();
    font.setPixelSize(18);
    painter.setFont(font);
    painter.setPen(Qt::black);
    painter.drawText(QRectF(0, 0, page.width(), kTitleHeight), Qt::AlignLeft | Qt::AlignVCenter,
                     title.isEmpty() ? name : QStringLiteral("%1 – %2").arg(title, name));
    font.setPixelSize(11);
    painter.setFont(font);
    const std::vector<PlanLegend::Entry> legend = legendOf(scene, level, overlay);
    const int width = static_cast<int>(page.width());
    const QFontMetrics metrics(font, painter.device());
    const int legendHeight = PlanLegend::paint(legend, width, metrics, false, nullptr);
    painter.save();
    painter.translate(0, page.height() - legendHeight);
    PlanLegend::paint(legend, width, metrics, false, &painter);
    painter.restore();
    const QSizeF room(page.width(), page.height() - kTitleHeight - legendHeight - kLegendGap);
    MapColours colours = MapColours::of(false);
    colours.outside = Qt::white;
    const ViewTransform view = ViewTransform::fitted(level.bounds, room, 24.0);
    const MapPainter map(scene, level.ordinal, view, colours, font, {true, false, true});
    painter.save();
    painter.translate(0, kTitleHeight);
    painter.setClipRect(QRectF(QPointF(), room));
    map.paintGround(painter);
    map.paintPictures(painter, overlay);
    map.paintTint(painter, overlay);
    map.paintFurnishing(painter);
    map.paintRoute(painter, overlay);
    std::vector<PlacedName> names = map.placedNames();
    const std::vector<PlacedName> moved = map.movedAside(names, overlay);
    std::erase_if(names, [&](const PlacedName& placed) {
        return std::any_of(moved.begin(), moved.end(),
                           [&](const PlacedName& each) { return each.home == placed.box; });
    });
    map.paintNames(painter, names);
    map.paintMarks(painter, overlay, moved);
    map.paintScale(painter);
    painter.restore();
}

bool printPlan(const std::shared_ptr<const building::Building>& building, const MapOverlay& overlay,
               const QString& file) {
    QSaveFile target(file); // the old file stays whole until the new one is
    if (!target.open(QIODevice::WriteOnly)) return false;
    const MapScene scene(building);
    {
        QPdfWriter writer(&target);
        writer.setTitle(toQString(building->data().title));
        writer.setCreator(QStringLiteral("Farol"));
        writer.setResolution(kDotsPerInch);
        writer.setPageSize(QPageSize(QPageSize::A3));
        writer.setPageOrientation(QPageLayout::Landscape);
        QPainter painter(&writer);
        bool first = true;
        for (const LevelScene& level : scene.levels()) {
            if (!first) writer.newPage();
            first = false;
            paintPlanPage(painter, scene, level, overlay, QSizeF(writer.width(), writer.height()));
        }
    }
    // commit() alone forgets that the last bytes could not be written, and puts a cut file in place.
    if (!target.flush()) target.cancelWriting();
    return target.commit();
}

} // namespace farol::ui
