#pragma once
// The walk as a strip: how sure the place was, and where something was said. Dragging it, or the arrow keys,
// looks back; its end is now.

#include "ui/live/walk_timeline.h"

#include <QSlider>
#include <QWidget>

class QLabel;
class QToolButton;

namespace farol::ui {

class TimelineSlider : public QSlider {
    Q_OBJECT

public:
    TimelineSlider(const WalkTimeline& timeline, QWidget* parent);

    QSize sizeHint() const override { return {400, 30}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    int valueAt(double x) const;

    const WalkTimeline& m_timeline;
};

class TimelineBar : public QWidget {
    Q_OBJECT

public:
    explicit TimelineBar(WalkTimeline& timeline, QWidget* parent = nullptr);

    bool looksBack() const { return m_back; }
    TimelineSlider& slider() { return *m_slider; }
    void goToNow();

Q_SIGNALS:
    /// Null: now.
    void wanted(const std::shared_ptr<const farol::session::Snapshot>& snapshot);

protected:
    void changeEvent(QEvent* event) override;

private:
    void follow();
    void moved(int value);
    void retranslate();

    WalkTimeline& m_timeline;
    QLabel *m_title, *m_when;
    TimelineSlider* m_slider;
    QToolButton* m_now;
    bool m_back = false;
    double m_backTime = 0.0; ///< of the moment looked at, which coarser keeping may move
};

} // namespace farol::ui
