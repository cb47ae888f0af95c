#pragma once
// Help: a chapter for each page, beside a list of them. It can stay open beside the window.

#include "ui/main_window/window_actions.h"

#include <QDialog>

class QListWidget;
class QTextBrowser;

namespace farol::ui {

class HelpDialog : public QDialog {
    Q_OBJECT

public:
    explicit HelpDialog(QWidget* parent = nullptr);

    void showPage(Page page);
    QListWidget& chapters() { return *m_chapters; }
    QString text() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void drawPictures();
    void showChapter(int chapter);

    QListWidget* m_chapters;
    QTextBrowser* m_text;
};

} // namespace farol::ui
