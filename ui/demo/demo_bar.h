#pragma once
// What a visitor of an exhibition may do to the simulated walk: a menu and a tool bar with the same commands,
// there only while such a walk is open, and one line that says what is going on.

#include <QList>
#include <QObject>
#include <QString>

class QAction;
class QMainWindow;
class QMenu;
class QToolBar;

namespace farol::ui {

class Demo;

class DemoBar : public QObject {
    Q_OBJECT

public:
    DemoBar(QMainWindow& window, Demo& demo);

    QAction *wrongTurn, *cover, *lightsOut, *nextVisitor;

    QMenu& menu() { return *m_menu; }
    /// Its keys belong to the page with the walk.
    void setPageShown(bool shown);
    /// All with a key of their own, for the list of keys.
    QList<QAction*> withKeys() const;
    /// "Visitor 3, from the Bar to 2.23 …"; empty while no simulated walk is open.
    QString news() const;
    void retranslate();

private:
    void refresh();
    void refreshIcons();
    bool eventFilter(QObject* watched, QEvent* event) override;

    QMainWindow& m_window;
    Demo& m_demo;
    QMenu* m_menu;
    QToolBar* m_bar;
    bool m_pageShown = true;
};

} // namespace farol::ui
