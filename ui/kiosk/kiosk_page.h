#pragma once
// The kiosk's screen: what is being said, in large letters, for those who see a little. All of it is heard
// too.

#include "ui/kiosk/kiosk.h"

#include <QTimer>
#include <QVariantAnimation>
#include <QWidget>

class QLabel;

namespace farol::ui {

class LinesArea;

class KioskPage : public QWidget {
    Q_OBJECT

public:
    explicit KioskPage(Kiosk& kiosk, QWidget* parent = nullptr);

    /// How long Escape is held down to leave.
    void setHoldMs(int ms) { m_holdMs = ms; }

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    bool focusNextPrevChild(bool next) override;

private:
    QLabel* addLabel(const QString& colour, int points, const QString& name);
    void showWords(const QString& text);
    void refresh();
    bool isRepetition(const QKeyEvent& event) const;

    Kiosk& m_kiosk;
    QLabel *m_title, *m_words, *m_detail, *m_hint;
    LinesArea* m_area;
    QVariantAnimation* m_scroll;
    QTimer m_hold;
    int m_holdMs = 1500;
    int m_holdLeftMs = -1; ///< when Escape was let go
    int m_releasedKey = 0;
    quint64 m_releasedAt = 0; ///< by the window system's clock, ms
};

} // namespace farol::ui
