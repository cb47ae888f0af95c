#pragma once
// The landmark curator's page: the library, and the wizard that teaches a landmark.

#include "ui/settings/settings.h"
#include "ui/training/library_document.h"
#include "ui/training/teach_panel.h"

#include <QWidget>

#include <functional>

class QLabel;
class QStackedWidget;

namespace farol::ui {

class BannerStack;
class LibraryPanel;
class TrainingActions;

class TrainingPage : public QWidget {
    Q_OBJECT

public:
    /// `draftFolder`: where an unfinished landmark is kept. `open` is replaced by tests; empty: real sources.
    TrainingPage(Settings& settings, const QString& draftFolder, PictureReel::OpenSource open = {},
                 QWidget* parent = nullptr);
    ~TrainingPage() override;

    void open(const QString& path);
    void chooseLibrary();
    void teach(); ///< a new landmark
    bool teaching() const;
    bool settled() const; ///< nothing is being worked out
    void saveLayout();
    QWidget* firstFocus() const;
    std::vector<QWidget*> panes() const; ///< in the order of the keyboard

    LibraryDocument& document() { return m_document; }
    TeachSession& session() { return m_session; }
    TeachPanel& wizard() { return *m_wizard; }
    LibraryPanel& panel() { return *m_panel; }
    TrainingActions& actions() { return *m_actions; }
    BannerStack& banners() { return *m_banners; }

Q_SIGNALS:
    void placeWanted(const farol::recognition::Template& entry);
    void walkWanted(const QString& library);
    void librarySaved(const QString& library);
    void documentChanged(); ///< another library

protected:
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void build();
    void connectDocument();
    void connectActions();
    void connectWizard();
    void createLibrary();
    void saveAs();
    void addViews();
    void edit();
    void merge();
    void split();
    void removeViews();
    void remove();
    void saveCsv();
    void finishTeaching();
    void showLibrary();
    void offerUnfinished();
    void goOnTeaching(TeachDraft draft);
    void refresh();
    void retranslate();
    const recognition::Template* chosen() const;

    Settings& m_settings;
    LibraryDocument m_document;
    TeachSession m_session;
    TrainingActions* m_actions;
    BannerStack* m_banners;
    QStackedWidget* m_stack;
    LibraryPanel* m_panel;
    TeachPanel* m_wizard;
    QLabel* m_state;
    TemplateId m_saving;                 ///< the wizard's landmark is on its way into the library
    std::optional<TeachDraft> m_waiting; ///< to go on with, once its library is open
};

} // namespace farol::ui
