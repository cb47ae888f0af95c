#pragma once
// Name, kind and size of a landmark that is in the library.

#include "core/recognition/landmark_library.h"

#include <QDialog>

class QComboBox;
class QDoubleSpinBox;
class QLineEdit;

namespace farol::ui {

class EditTemplateDialog : public QDialog {
    Q_OBJECT

public:
    explicit EditTemplateDialog(const recognition::Template& entry, QWidget* parent = nullptr);

    /// `entry` with what the form says.
    recognition::Template changed(recognition::Template entry) const;

private:
    QLineEdit *m_name, *m_id;
    QComboBox* m_kind;
    QDoubleSpinBox *m_width, *m_height;
    double m_shownWidth = 0.0, m_shownHeight = 0.0;
};

} // namespace farol::ui
