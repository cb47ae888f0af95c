#pragma once
// A tool bar whose buttons give their words up, keeping icon, name and tip, rather than stand where nobody
// sees them: languages and fonts differ in width by a third.

#include <QList>
#include <QObject>
#include <QSize>

class QAction;
class QToolBar;
class QToolButton;

namespace farol::ui {

/// Lives with `bar`. GUI thread.
class BarWords final : public QObject {
public:
    /// Groups of the bar's actions in the order in which they give their words up; each has an icon. What is
    /// in no group keeps its words.
    BarWords(QToolBar& bar, QList<QList<QAction*>> groups);

private:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void fit();
    QSize sizeOf(const QToolButton& button, Qt::ToolButtonStyle style) const;

    QToolBar& m_bar;
    QList<QList<QAction*>> m_groups;
    QToolButton* m_measure; ///< never shown
};

} // namespace farol::ui
