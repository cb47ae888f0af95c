#pragma once
// Help: a chapter for each page with a picture of it, beside a list of them. It can stay open beside the
// window.

#include "ui/main_window/window_actions.h"

#include <QDialog>
#include <QPointer>

#include <vector>

class QListWidget;
class QTextBrowser;

namespace farol::ui {

class HelpDialog : public QDialog {
    Q_OBJECT

public:
    /// `pages` in the order of Page; the chapters show them as they are when they are opened.
    explicit HelpDialog(const std::vector<QWidget*>& pages, QWidget* parent = nullptr);

    void showPage(Page page);
    QListWidget& chapters() { return *m_chapters; }
    QString text() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void drawPictures();
    void retranslate();
    void showChapter(int chapter);
    QString walkChapter();
    QString mapChapter();
    QString landmarksChapter();
    QString kioskChapter();
    QString pageView(Page page);

    std::vector<QPointer<QWidget>> m_pages;
    QListWidget* m_chapters;
    QTextBrowser* m_text;
};

} // namespace farol::ui
