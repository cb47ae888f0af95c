#pragma once
// The page of the first start: what one can do here, a button for each.

#include <QDialog>

namespace farol::ui {

class Settings;

class WelcomeDialog : public QDialog {
    Q_OBJECT

public:
    explicit WelcomeDialog(Settings& settings, QWidget* parent = nullptr);

Q_SIGNALS:
    void walkWanted();
    void mapWanted();
    void landmarksWanted();
    void helpWanted();

private:
    void addChoice(const QString& text, const QString& about, void (WelcomeDialog::*chosen)());
};

} // namespace farol::ui
