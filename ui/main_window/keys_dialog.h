#pragma once
// The list of keys.

#include <QDialog>

namespace farol::ui {

class WindowActions;

class KeysDialog : public QDialog {
    Q_OBJECT

public:
    explicit KeysDialog(const WindowActions& actions, QWidget* parent = nullptr);
};

} // namespace farol::ui
