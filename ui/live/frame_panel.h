#pragma once
// The picture and, below it, when it was taken and how long Farol took to understand it.

#include "core/session/percept.h"
#include "ui/parts/frame_view.h"

#include <QWidget>

#include <memory>

class QLabel;

namespace farol::ui {

class FramePanel : public QWidget {
    Q_OBJECT

public:
    explicit FramePanel(QWidget* parent = nullptr);

    void show(const std::shared_ptr<const session::Snapshot>& snapshot); ///< null: nothing yet
    FrameView& view() { return *m_view; }
    QString facts() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();

    FrameView* m_view;
    QLabel* m_title;
    QLabel* m_when;
    QLabel* m_cost;
    std::shared_ptr<const session::Snapshot> m_snapshot;
};

} // namespace farol::ui
