#pragma once
// Pictures of floor plans under the map: loaded, placed by pairs of points that the user clicks, seen
// through, taken away, and kept with the user's settings for the next time the map is opened.

#include "ui/convert/background.h"
#include "ui/map/floor_picture.h"
#include "ui/settings/settings.h"

#include <QObject>

#include <memory>
#include <optional>
#include <vector>

class QLabel;
class QPushButton;
class QSlider;

namespace farol::building {
class Building;
}

namespace farol::ui {

class PlanPanel;

class FloorPictures : public QObject {
    Q_OBJECT

public:
    FloorPictures(PlanPanel& plan, Settings& settings, QObject* parent = nullptr);

    static bool isPicture(const QString& file);
    /// Another map, or none: shows what was kept for it. `name` is the map's file.
    void setMap(const std::shared_ptr<const building::Building>& building, const QString& name);
    void setName(const QString& name); ///< the map has got another file
    void load(const QString& file);    ///< under the floor that is shown
    void beginPlacing();
    bool placing() const { return m_placing; }
    void placed(Point2 at); ///< what the user clicked while placing
    void endPlacing();
    void remove();
    bool busy() const { return m_busy > 0; }
    QWidget& bar() { return *m_bar; }
    QSlider& opacity() { return *m_opacity; }
    QPushButton& placeButton() { return *m_place; }
    QPushButton& removeButton() { return *m_remove; }
    /// Of the floor that is shown; nullptr without one.
    const FloorPicture* current() const;
    void retranslate();

Q_SIGNALS:
    void failed(const QString& message);
    void loaded();

private:
    struct Wish { ///< what shall be read
        QString file;
        double level = 0.0, opacity = 0.6;
        std::optional<QTransform> toMap;
    };
    void read(const Wish& wish, bool kept);
    void take(FloorPicture picture, bool placedByFile, bool kept);
    void change(const FloorPicture& picture);
    void show();
    void keep();
    void ask();

    PlanPanel& m_plan;
    Settings& m_settings;
    std::shared_ptr<const building::Building> m_building;
    QString m_name;
    std::vector<std::shared_ptr<const FloorPicture>> m_pictures;
    QWidget* m_bar;
    QLabel* m_label;
    QSlider* m_opacity;
    QPushButton *m_place, *m_remove;
    bool m_placing = false;
    std::optional<QPointF> m_pixel; ///< clicked, its place on the map not yet
    std::vector<PlacedPoint> m_points;
    std::uint64_t m_map = 0; ///< counts the maps
    int m_busy = 0;
    Background m_background; ///< last: its jobs use the rest
};

} // namespace farol::ui
