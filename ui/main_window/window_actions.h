#pragma once
// Every command of the window with its name, key and icon, and the menus and tool bar made of them.

#include "ui/convert/glyphs.h"

#include <QList>
#include <QObject>

#include <vector>

class QAction;
class QActionGroup;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QMainWindow;
class QMenu;
class QMenuBar;
class QToolBar;

namespace farol::ui {

/// In the order of the tabs.
enum class Page { Walk, Map, Landmarks };

class WindowActions : public QObject {
    Q_OBJECT

public:
    explicit WindowActions(QMainWindow& window);

    QAction *openMap, *openLibrary, *closeLibrary, *openSource, *settings, *quit;
    QAction *play, *step, *stop, *record, *faster, *slower;
    QAction *destination, *start, *noDestination, *repeat, *mute;
    QAction *here, *wrong, *sayThis, *revote, *figures, *savePicture, *saveWalk;
    QAction *walkPage, *mapPage, *landmarksPage;
    QAction *grid, *rejected, *follow, *fitMap, *zoomIn, *zoomOut, *nextPane, *previousPane;
    QAction *help, *welcome, *keys, *about;
    QList<QAction*> languages; ///< data(): "pt"
    QMenu *recentMaps, *recentLibraries, *recentSources;
    QComboBox* speed;

    void retranslate();
    void setPlaying(bool playing); ///< the first command is Pause while a walk runs
    /// Puts a page's own menu behind those of the walk.
    void addPageMenu(QMenu& menu);
    void addBesideMenus(QWidget& widget);
    void addToFileMenu(QMenu& menu);
    void addToWalkMenu(QMenu& menu);
    /// The tool bar, and what makes no sense while another page is shown, follow the page.
    void showPage(Page page);
    /// All with a key of their own, for the list of keys.
    QList<QAction*> withKeys() const;

private:
    QAction* add(QMenu* menu, const QList<QKeySequence>& shortcuts = {}, bool checkable = false);
    void addGlyph(QAction* action, Glyph glyph);
    void buildMenus();
    void buildToolBar();
    void refreshIcons();
    bool eventFilter(QObject* watched, QEvent* event) override;

    struct Iconed {
        QAction* action;
        Glyph glyph;
    };

    QMainWindow& m_window;
    QMenu *m_file, *m_walk, *m_voice, *m_view, *m_help, *m_language;
    QMenuBar* m_menuBar;
    QHBoxLayout* m_besideMenus;
    QToolBar* m_bar;
    QLabel* m_speedLabel;
    std::vector<Iconed> m_icons;
    bool m_playing = false;
};

} // namespace farol::ui
