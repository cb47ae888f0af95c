#pragma once
// Every command of the Map page with its name, key and icon. The keys work while the page has the keyboard.

#include <QList>
#include <QObject>

class QAction;
class QMenu;
class QToolBar;
class QUndoStack;
class QWidget;

namespace farol::ui {

class MapActions : public QObject {
    Q_OBJECT

public:
    MapActions(QWidget& page, QUndoStack& steps);

    QAction *open, *import, *save, *saveAs, *print;
    QAction *undo, *redo, *addLandmark, *addAccess, *edit, *remove;
    QAction *routeFrom, *routeTo, *find, *check, *nextFeature, *ambiguity, *coverage, *missing, *picture,
        *walkHere;

    QMenu& menu() { return *m_menu; }
    QToolBar& bar() { return *m_bar; }
    /// All with a key of their own, for the list of keys.
    QList<QAction*> withKeys() const;
    void retranslate();
    void refreshIcons();

private:
    QAction* add(const QList<QKeySequence>& shortcuts = {}, bool checkable = false);

    QWidget& m_page;
    QUndoStack& m_steps;
    QMenu* m_menu;
    QToolBar* m_bar;
};

} // namespace farol::ui
