#include "ui/curation/floor_pictures.h"

#include "core/building/building.h"
#include "core/building/plan_picture.h"
#include "ui/convert/convert.h"
#include "ui/curation/plan_panel.h"
#include "ui/models/core_words.h"
#include "ui/parts/naming.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QPushButton>
#include <QSlider>

#include <algorithm>
#include <cmath>
#include <utility>

namespace farol::ui {

namespace {

QImage toImage(const building::PlanPicture& read) {
    const QImage borrowed(read.rgba.data(), read.width, read.height, 4 * read.width, QImage::Format_RGBA8888);
    return borrowed.convertToFormat(QImage::Format_ARGB32_Premultiplied); // a copy
}

QJsonArray numbers(const QTransform& t) {
    return {t.m11(), t.m12(), t.m21(), t.m22(), t.dx(), t.dy()};
}

std::optional<QTransform> transformOf(const QJsonArray& n) {
    if (n.size() != 6) return std::nullopt;
    const QTransform found(n[0].toDouble(), n[1].toDouble(), n[2].toDouble(), n[3].toDouble(),
                           n[4].toDouble(), n[5].toDouble());
    return found.isInvertible() ? std::optional(found) : std::nullopt;
}

} // namespace

FloorPictures::FloorPictures(PlanPanel& plan, Settings& settings, QObject* parent)
    : QObject(parent),
      m_plan(plan),
      m_settings(settings),
      m_bar(new QWidget(&plan)),
      m_label(new QLabel(m_bar)),
      m_opacity(new QSlider(Qt::Horizontal, m_bar)),
      m_place(new QPushButton(m_bar)),
      m_remove(new QPushButton(m_bar)),
      m_background(this) {
    m_opacity->setRange(10, 100);
    m_opacity->setPageStep(10);
    m_label->setBuddy(m_opacity);
    auto* layout = new QHBoxLayout(m_bar);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_label);
    layout->addWidget(m_opacity, 1);
    layout->addWidget(m_place);
    layout->addWidget(m_remove);
    m_bar->hide();
    plan.addBelow(m_bar);
    connect(m_opacity, &QSlider::valueChanged, this, [this](int percent) {
        const FloorPicture* picture = current();
        if (!picture || std::lround(picture->opacity * 100.0) == percent) return;
        FloorPicture changed = *picture;
        changed.opacity = percent / 100.0;
        change(changed);
    });
    connect(m_place, &QPushButton::clicked, this, &FloorPictures::beginPlacing);
    connect(m_remove, &QPushButton::clicked, this, &FloorPictures::remove);
    connect(&plan.view(), &MapView::levelChanged, this, &FloorPictures::show);
    retranslate();
}

bool FloorPictures::isPicture(const QString& file) {
    static const QStringList kEndings{QStringLiteral("png"), QStringLiteral("jpg"),  QStringLiteral("jpeg"),
                                      QStringLiteral("tif"), QStringLiteral("tiff"), QStringLiteral("bmp"),
                                      QStringLiteral("webp")};
    return kEndings.contains(QFileInfo(file).suffix().toLower());
}

void FloorPictures::setMap(const std::shared_ptr<const building::Building>& building, const QString& name) {
    endPlacing();
    ++m_map;
    m_building = building;
    m_name = name;
    m_pictures.clear();
    show();
    if (!building) return;
    for (const QJsonValue value : QJsonDocument::fromJson(m_settings.floorPictures(name)).array()) {
        const QJsonObject kept = value.toObject();
        const auto toMap = transformOf(kept[QLatin1String("place")].toArray());
        if (toMap)
            read({kept[QLatin1String("file")].toString(), kept[QLatin1String("level")].toDouble(),
                  std::clamp(kept[QLatin1String("opacity")].toDouble(), 0.1, 1.0), toMap},
                 true);
    }
}

void FloorPictures::setName(const QString& name) {
    m_name = name;
    if (!m_pictures.empty()) keep();
}

void FloorPictures::load(const QString& file) {
    if (m_building)
        read({QFileInfo(file).absoluteFilePath(), m_plan.view().level(), 0.6, std::nullopt}, false);
}

void FloorPictures::read(const Wish& wish, bool kept) {
    ++m_busy;
    m_background.run([file = toUtf8(wish.file),
                      crs = m_building->data().crs] { return building::loadPlanPicture(file, crs); },
                     [this, wish, kept, map = m_map](Result<building::PlanPicture> result) {
                         --m_busy;
                         if (map != m_map) return;
                         if (!result) return void(Q_EMIT failed(CoreWords::problem(result.error())));
                         FloorPicture picture{toImage(*result), {}, wish.opacity, wish.level, wish.file};
                         const auto& own = result->toMap;
                         if (wish.toMap)
                             picture.toMap = *wish.toMap;
                         else if (own)
                             picture.toMap =
                                 QTransform((*own)[1], (*own)[4], (*own)[2], (*own)[5], (*own)[0], (*own)[3]);
                         take(std::move(picture), own && !kept, kept);
                     });
}

void FloorPictures::take(FloorPicture picture, bool placedByFile, bool kept) {
    const LevelScene* level = m_plan.view().scene() ? m_plan.view().scene()->level(picture.level) : nullptr;
    if (!level) return;
    if (!kept && !placedByFile) picture.toMap = placedIn(level->bounds, picture.image.size());
    if (kept)
        m_pictures.push_back(std::make_shared<const FloorPicture>(std::move(picture)));
    else
        change(picture);
    show();
    Q_EMIT loaded();
    if (kept) return;
    if (placedByFile)
        m_plan.tell(tr("The image lies where its file says."));
    else
        beginPlacing();
}

const FloorPicture* FloorPictures::current() const {
    for (const auto& picture : m_pictures)
        if (picture->level == m_plan.view().level()) return picture.get();
    return nullptr;
}

/// Takes the place of the one on its level.
void FloorPictures::change(const FloorPicture& picture) {
    const double level = picture.level;
    auto fresh = std::make_shared<const FloorPicture>(picture);
    std::erase_if(m_pictures, [level](const auto& other) { return other->level == level; });
    m_pictures.push_back(std::move(fresh));
    show();
    keep();
}

void FloorPictures::show() {
    MapOverlay overlay = m_plan.view().overlay();
    overlay.pictures = m_pictures;
    m_plan.view().setOverlay(overlay);
    const FloorPicture* picture = current();
    m_bar->setVisible(picture != nullptr);
    if (picture) m_opacity->setValue(static_cast<int>(std::lround(picture->opacity * 100.0)));
}

void FloorPictures::keep() {
    QJsonArray all;
    for (const auto& picture : m_pictures)
        all.append(QJsonObject{{QStringLiteral("file"), picture->file},
                               {QStringLiteral("level"), picture->level},
                               {QStringLiteral("opacity"), picture->opacity},
                               {QStringLiteral("place"), numbers(picture->toMap)}});
    m_settings.setFloorPictures(m_name, QJsonDocument(all).toJson(QJsonDocument::Compact));
}

void FloorPictures::remove() {
    endPlacing();
    const double level = m_plan.view().level();
    std::erase_if(m_pictures, [level](const auto& picture) { return picture->level == level; });
    show();
    keep();
    m_plan.view().setFocus(Qt::OtherFocusReason);
}

void FloorPictures::beginPlacing() {
    if (!current()) return;
    m_placing = true;
    m_pixel.reset();
    m_points.clear();
    m_plan.view().setTool(MapView::Tool::Place);
    m_plan.view().setFocus(Qt::ShortcutFocusReason);
    ask();
}

void FloorPictures::ask() {
    if (m_pixel) return m_plan.tell(tr("Now click where this point belongs on the map. Escape gives up."));
    switch (m_points.size()) {
    case 0:
        return m_plan.tell(
            tr("Click a point of the image that you know on the map, a corner of the house, say. Escape "
               "leaves the image where it is."));
    case 1:
        return m_plan.tell(tr("Click a second point of the image, far from the first."));
    default:
        return m_plan.tell(tr("Placed. A third point straightens a skewed image; Escape ends."));
    }
}

void FloorPictures::placed(Point2 at) {
    const FloorPicture* picture = current();
    if (!picture) return endPlacing();
    if (!m_pixel) {
        const QPointF pixel = picture->toMap.inverted().map(QPointF(at.x, at.y));
        if (!QRectF(picture->image.rect()).contains(pixel))
            return m_plan.tell(tr("That is beside the image. Click a point of the image."));
        m_pixel = pixel;
        return ask();
    }
    m_points.emplace_back(*std::exchange(m_pixel, std::nullopt), at);
    if (m_points.size() < 2) return ask();
    const auto found = placedBy(m_points);
    if (!found) {
        m_points.pop_back();
        return m_plan.tell(tr("These points lie too near each other, or on one line. Click another one."));
    }
    FloorPicture moved = *picture;
    moved.toMap = *found;
    change(moved);
    if (m_points.size() == 3) {
        endPlacing();
        return m_plan.tell(tr("The image is placed by three points."));
    }
    ask();
}

void FloorPictures::endPlacing() {
    if (!std::exchange(m_placing, false)) return;
    m_pixel.reset();
    m_points.clear();
    m_plan.view().setTool(MapView::Tool::Move);
    m_plan.tell({});
}

void FloorPictures::retranslate() {
    m_label->setText(tr("Ima&ge:"));
    m_opacity->setAccessibleName(tr("How strong the floor-plan image is"));
    m_opacity->setToolTip(tr("How strong the floor-plan image is"));
    nameButton(m_place, tr("Place by p&oints"), tr("Place the image by points"),
               tr("Click two or three points of the image and where they belong on the map"));
    nameButton(m_remove, tr("Take a&way"), tr("Take the image away"),
               tr("The floor shows no image any more; its file stays"));
}

} // namespace farol::ui
