#pragma once
// Second step of teaching: photographs, outlines, and what the coach says of them.

#include "core/recognition/view_coach.h"
#include "ui/training/picture_reel.h"

#include <QWidget>

class QLabel;
class QListWidget;
class QPushButton;

namespace farol::ui {

class OutlineView;
class TeachSession;

class TeachViews : public QWidget {
    Q_OBJECT

public:
    TeachViews(TeachSession& session, PictureReel& reel, QWidget* parent = nullptr);

    void show();               ///< what the session holds
    void setShown(bool shown); ///< pictures are judged only while they are looked at
    OutlineView& outline() { return *m_outline; }
    QPushButton& filesButton() { return *m_files; }
    QPushButton& addButton() { return *m_add; }
    QPushButton& removeButton() { return *m_remove; }
    QListWidget& views() { return *m_views; }
    QString coachText() const;
    QString healthText() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    QWidget* buildPictures();
    QWidget* buildCoach();
    void connectAll();
    void chooseFiles();
    void chooseRecording();
    void showPicture();
    void judge();
    void addView();
    void refresh();
    void refreshCoach();
    void fillViews();
    void retranslate();

    TeachSession& m_session;
    PictureReel& m_reel;
    OutlineView* m_outline;
    QPushButton *m_camera, *m_files, *m_recording, *m_previous, *m_next, *m_hold;
    QPushButton *m_find, *m_whole, *m_add, *m_remove;
    QLabel *m_position, *m_coachTitle, *m_coach, *m_viewsTitle, *m_healthTitle, *m_health;
    QListWidget* m_views;
    recognition::PictureQuality m_quality;
    bool m_judged = false;
    bool m_shown = false;
    bool m_asked = false; ///< for the outline, by the user
    QString m_told;       ///< what was refused, until the next picture or outline
};

} // namespace farol::ui
