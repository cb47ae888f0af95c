#pragma once
// First step of teaching: what the landmark is.

#include "core/base/kind.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;

namespace farol::ui {

class TeachSession;

class TeachWhat : public QWidget {
    Q_OBJECT

public:
    explicit TeachWhat(TeachSession& session, QWidget* parent = nullptr);

    void show(); ///< what the session holds
    QLineEdit& name() { return *m_name; }
    QComboBox& kind() { return *m_kind; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void tell();
    void refresh();
    void retranslate();
    QDoubleSpinBox* metres();

    TeachSession& m_session;
    QLabel* m_intro;
    QLabel *m_nameLabel, *m_kindLabel, *m_widthLabel, *m_heightLabel, *m_idLabel;
    QLineEdit *m_name, *m_id;
    QComboBox* m_kind;
    QDoubleSpinBox *m_width, *m_height;
    QLabel* m_problem;
    bool m_ownId = false; ///< the user has typed it
    bool m_showing = false;
};

} // namespace farol::ui
