#pragma once
// The workstation's window: pages, menus, keys.

#include "ui/convert/map_watch.h"
#include "ui/curation/map_page.h"
#include "ui/demo/demo.h"
#include "ui/live/live_page.h"
#include "ui/live/speech_desk.h"
#include "ui/live/walk.h"
#include "ui/main_window/figures.h"
#include "ui/main_window/start_options.h"
#include "ui/main_window/window_actions.h"
#include "ui/settings/settings.h"
#include "ui/training/training_page.h"

#include <QMainWindow>

class QLabel;
class QProgressBar;
class QStackedWidget;
class QTabBar;

namespace farol::ui {

class DemoBar;
class LocaliserMenu;
class ProfileMenu;
class MapView;

class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    /// `open` and `makeOutput` are replaced by tests. The settings must outlive the window.
    explicit MainWindow(Settings& settings, Walk::OpenSource open = {},
                        SpeechDesk::MakeOutput makeOutput = {}, QWidget* parent = nullptr);
    ~MainWindow() override;

    void begin(const StartOptions& options);
    /// Installs the language that the settings name, or the computer's.
    static void applyLanguage(const Settings& settings);
    static void applyLook(const Settings& settings);
    void welcome(); ///< the page of the first start

    Walk& walk() { return m_walk; }
    LivePage& page() { return *m_page; }
    MapPage& mapPage() { return *m_mapPage; }
    Demo& demo() { return *m_demo; }
    TrainingPage& trainingPage() { return *m_trainingPage; }
    Page shownPage() const;
    void showPage(Page page);
    bool showsMap() const { return shownPage() == Page::Map; }
    void showMap(bool shown) { showPage(shown ? Page::Map : Page::Walk); }
    WindowActions& actions() { return *m_actions; }

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void connectFile();
    void connectWalk();
    void connectVoice();
    void connectView();
    void connectNews();
    void connectPages();
    void connectDemo();
    void connectTraining();
    void connectMapWatch();
    void connectSupervision();
    void connectSettings();
    void showHelp();
    void saveFile(const QString& caption, const QString& suggestion, const QString& filter,
                  const std::function<bool(const QString&)>& write);
    MapView& shownMap();
    bool mayLeave();
    void showState(session::RunState state);
    void showProblem(Problem kind, const QString& message);
    void toggleRecording(bool on);
    std::optional<QString> nextRecording() const;
    void resolvePlaces();
    void changeSpeed(int by);
    void movePane(int by);
    void fillRecent();
    void chooseMap();
    void chooseLibrary();
    void chooseSource();
    void retranslate();
    QString title() const;

    Settings& m_settings;
    std::shared_ptr<SimulatedWalks> m_simulated;
    Walk m_walk;
    SpeechDesk m_speech;
    WindowActions* m_actions;
    LivePage* m_page;
    MapPage* m_mapPage;
    Demo* m_demo; ///< after the page, which must know a map before places in it are chosen
    DemoBar* m_demoBar;
    LocaliserMenu* m_localisers;
    ProfileMenu* m_profiles;
    MapWatch m_mapWatch;       ///< of the walk's map
    Calibration m_calibration; ///< of the walk that is shown, where its truth is known
    TrainingPage* m_trainingPage;
    QStackedWidget* m_pages;
    QTabBar* m_pageTabs;
    QLabel* m_status;
    QProgressBar* m_busy;
    QString m_from, m_to;   ///< to be looked up once the map is there
    bool m_leaving = false; ///< what was unsaved has been dealt with
};

} // namespace farol::ui
