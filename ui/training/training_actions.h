#pragma once
// Every command of the Landmarks page with its name, key and icon. The keys work while the page has the
// keyboard.

#include <QList>
#include <QObject>

class QAction;
class QMenu;
class QToolBar;
class QUndoStack;
class QWidget;

namespace farol::ui {

class TrainingActions : public QObject {
    Q_OBJECT

public:
    TrainingActions(QWidget& page, QUndoStack& steps);

    QAction *open, *fresh, *saveAs, *undo, *redo;
    QAction *teach, *addViews, *edit, *merge, *split, *removeViews, *remove, *place, *check, *walkHere;

    QMenu& menu() { return *m_menu; }
    QToolBar& bar() { return *m_bar; }
    /// All with a key of their own, for the list of keys.
    QList<QAction*> withKeys() const;
    void retranslate();
    void refreshIcons();

private:
    QAction* add(const QList<QKeySequence>& shortcuts = {});

    QWidget& m_page;
    QMenu* m_menu;
    QToolBar* m_bar;
};

} // namespace farol::ui
