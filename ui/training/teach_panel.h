#pragma once
// Teaching one landmark in four steps: what it is, its views, a trial, its place on the map.

#include "ui/training/picture_reel.h"
#include "ui/training/teach_session.h"

#include <QWidget>

class QLabel;
class QPushButton;
class QStackedWidget;

namespace farol::ui {

class TeachTry;
class TeachViews;
class TeachWhat;

class TeachPanel : public QWidget {
    Q_OBJECT

public:
    enum Step { What, Views, Try, End };

    TeachPanel(TeachSession& session, PictureReel::OpenSource open, QWidget* parent = nullptr);

    void begin();     ///< shows what the session holds, at its step
    void showSaved(); ///< the library has taken it
    Step step() const;
    TeachWhat& what() { return *m_what; }
    TeachViews& views() { return *m_views; }
    TeachTry& trial() { return *m_try; }
    PictureReel& reel() { return m_reel; }
    QPushButton& back() { return *m_back; }
    QPushButton& forward() { return *m_forward; }
    QPushButton& place() { return *m_place; }
    QPushButton& giveUp() { return *m_giveUp; }
    QString why() const; ///< one cannot go on

Q_SIGNALS:
    void saveWanted();
    void placeWanted();
    void anotherWanted();
    void putAside(); ///< to go on later
    void givenUp();

protected:
    void changeEvent(QEvent* event) override;

private:
    QWidget* buildEnd();
    void go(Step step);
    void goOn();
    void refresh();
    void retranslate();

    TeachSession& m_session;
    PictureReel m_reel;
    QLabel* m_title;
    QLabel* m_steps;
    QStackedWidget* m_stack;
    TeachWhat* m_what;
    TeachViews* m_views;
    TeachTry* m_try;
    QWidget* m_end;
    QLabel *m_endText, *m_why;
    QPushButton *m_place, *m_another;
    QPushButton *m_back, *m_forward, *m_aside, *m_giveUp;
    bool m_saved = false;
};

} // namespace farol::ui
