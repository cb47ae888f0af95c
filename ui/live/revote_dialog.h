#pragma once
// Chooses a recorded walk and another localiser, and shows where the two do not agree.

#include "ui/convert/background.h"
#include "ui/live/revote.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace farol::ui {

class RevoteDialog : public QDialog {
    Q_OBJECT

public:
    /// `names`: localisers by their stable names, with what they are called here.
    RevoteDialog(const QString& folder, const QList<std::pair<QString, QString>>& names,
                 QWidget* parent = nullptr);

    QString summary() const;
    QTableWidget& table() { return *m_table; }
    QPushButton& startButton() { return *m_start; }
    QLineEdit& folder() { return *m_folder; }
    QComboBox& localiser() { return *m_localiser; }

private:
    void build(const QString& folder);
    void start();
    void showResult(const Result<Revote>& result);
    QString nameOf(const std::string& localiser) const;

    QList<std::pair<QString, QString>> m_names;
    QLineEdit* m_folder;
    QComboBox* m_localiser;
    QPushButton* m_start;
    QProgressBar* m_busy;
    QLabel* m_summary;
    QTableWidget* m_table;
    Background m_background; ///< last: its jobs use the rest
};

} // namespace farol::ui
