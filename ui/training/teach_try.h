#pragma once
// Third step of teaching: the camera, or more pictures, with what Farol recognises in them.

#include "core/recognition/detection.h"
#include "ui/training/picture_reel.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace farol::ui {

class FrameView;
class TeachSession;

class TeachTry : public QWidget {
    Q_OBJECT

public:
    TeachTry(TeachSession& session, PictureReel& reel, QWidget* parent = nullptr);

    void setShown(bool shown); ///< pictures are looked at only while the step is shown
    QPushButton& recordingButton() { return *m_recording; }
    QString verdict() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void tryPicture();
    void showResult(const recognition::DetectorResult& result);
    QString sentence(const recognition::DetectorResult& result) const;
    void refresh();
    void retranslate();

    TeachSession& m_session;
    PictureReel& m_reel;
    FrameView* m_frame;
    QPushButton *m_camera, *m_recording, *m_previous, *m_next;
    QLabel *m_intro, *m_verdict, *m_healthTitle, *m_health, *m_tallies;
    int m_looks = 0, m_hits = 0;
    bool m_shown = false;
};

} // namespace farol::ui
