#pragma once
// A tour of the workstation: every page, dialog and step of the wizard, one after the other, with material in
// them, for tests that look at all of them.

#include "tests/ui/hand_made.h"
#include "ui/main_window/main_window.h"

#include <QTemporaryDir>

#include <functional>
#include <memory>

class QDialog;

namespace farol::ui::test {

class DeskTour {
public:
    /// `top` is shown and active. `name` is fit for a file.
    using Visit = std::function<void(QWidget& top, const QString& name)>;

    DeskTour(); ///< makes a map, a library, photographs
    /// In the language, at 1280 x 800 unless the visitor changes it. What went wrong; empty: all was seen.
    QString go(const QString& language, const Visit& visit);

private:
    void pages();
    void walkPage();
    void demo();
    void mapPage();
    void landmarksPage();
    void wizard();
    void windowsOwnDialogs();
    void dialogs();
    void kiosk();
    void make();
    void stop(QWidget& top, const QString& name);
    void see(std::unique_ptr<QDialog> dialog, const QString& name);
    void seeModal(const QString& name); ///< what the window has just opened, then closed by Escape
    bool await(const std::function<bool()>& condition, const char* what);
    QString file(const char* name) const { return m_folder.filePath(QLatin1String(name)); }

    QTemporaryDir m_folder;
    QString m_map, m_library, m_language, m_wrong;
    QStringList m_photos;
    Visit m_visit;
    std::unique_ptr<Settings> m_settings;
    std::unique_ptr<MainWindow> m_window;
};

} // namespace farol::ui::test
