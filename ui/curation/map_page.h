#pragma once
// The map curator's page: the plan, the table of attributes, what is wrong with the map, routes tried out,
// and changes with undo and redo.

#include "ui/curation/map_document.h"
#include "ui/map/hit_detector.h"
#include "ui/settings/settings.h"

#include <QWidget>

#include <functional>
#include <optional>

class QFrame;
class QLabel;
class QProgressBar;
class QPushButton;
class QSplitter;
class QTabWidget;

namespace farol::ui {

class BannerStack;
class FeaturePanel;
class FloorPictures;
class MapActions;
class PlanPanel;
class ReportPanel;
class RoutePanel;

class MapPage : public QWidget {
    Q_OBJECT

public:
    explicit MapPage(Settings& settings, QWidget* parent = nullptr);
    ~MapPage() override;

    void open(const QString& source); ///< asks first when something is unsaved
    void chooseMap();
    /// Runs `then` at once, or once what is unsaved was saved or given up. Not at all when the user stays.
    void whenSaved(std::function<void()> then);
    void saveLayout();
    /// A route, and what is chosen, by the words of the command line (an id, a name, a number).
    void showRoute(const QString& from, const QString& to);
    /// Lets the user choose the place of a landmark that is like this one, on the map that is open or on the
    /// next one.
    void placeLandmark(const building::Landmark& like);
    bool settled() const; ///< nothing is being loaded, planned or checked

    MapDocument& document() { return m_document; }
    MapActions& actions() { return *m_actions; }
    PlanPanel& plan() { return *m_plan; }
    FeaturePanel& features() { return *m_features; }
    ReportPanel& report() { return *m_report; }
    RoutePanel& route() { return *m_route; }
    QTabWidget& tabs() { return *m_tabs; }
    FloorPictures& pictures() { return *m_pictures; }
    BannerStack& banners() { return *m_banners; }
    QPushButton& cancel() { return *m_cancel; }
    QWidget* firstFocus() const;
    std::vector<QWidget*> panes() const; ///< in the order of the keyboard

Q_SIGNALS:
    void walkWanted(const QString& path);
    void documentChanged(); ///< another map, or its name or state

protected:
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void build();
    void connectDocument();
    void connectFiles();
    void connectEdits();
    void connectViews();
    void connectOutside();
    void connectLayers();
    void choosePicture();
    void showCoverage(bool on);
    void showMissing();
    void showLayers(); ///< of another map, or of the one that was changed
    void askOvertaken(const QString& path);
    void showOpened();
    void showReplaced();
    void showEdited(const building::Edit& edit);
    void showWork();
    void showFailure(const QString& message);
    void importMap();
    bool save(); ///< false when no file was chosen
    bool saveAs();
    void print();
    void startPlacing(bool landmark);
    void placed(Point2 at);
    void landmarkPlaced(Point2 at);
    void editSelected();
    void removeSelected();
    void moveSelected(const MapHit& hit, Point2 by, bool byKey);
    void openForm(const MapHit& hit);
    void openMenu(const MapHit& hit, const QPoint& at);
    std::optional<RegionId> regionOf(const MapHit& hit) const;
    void showAmbiguity(bool on);
    void refreshActions();
    void retranslate();

    Settings& m_settings;
    MapDocument m_document;
    MapActions* m_actions;
    BannerStack* m_banners;
    QFrame* m_work;
    QLabel* m_workText;
    QProgressBar* m_workBar;
    QPushButton* m_cancel;
    QSplitter* m_halves;
    PlanPanel* m_plan;
    FloorPictures* m_pictures;
    QTabWidget* m_tabs;
    FeaturePanel* m_features;
    ReportPanel* m_report;
    RoutePanel* m_route;
    bool m_placeLandmark = false;
    Kind m_lastKind = Kind::Sign;
    std::optional<building::Landmark> m_like; ///< what the landmark to be placed is like
    bool m_placeWhenOpen = false;
    std::function<void()> m_afterSave;
    bool m_linking = false;  ///< table and plan tell each other
    int m_marking = 0;       ///< layers that are being worked out
    Background m_background; ///< last: its jobs use the rest
};

} // namespace farol::ui
