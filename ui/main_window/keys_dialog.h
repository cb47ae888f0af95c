#pragma once
// The list of keys.

#include <QDialog>
#include <QList>

class QAction;

namespace farol::ui {

class KeysDialog : public QDialog {
    Q_OBJECT

public:
    explicit KeysDialog(const QList<QAction*>& actions, QWidget* parent = nullptr);
};

} // namespace farol::ui
