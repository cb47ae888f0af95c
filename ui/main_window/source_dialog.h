#pragma once
// Where the pictures come from: camera, video file, folder of pictures, network address.

#include "ui/live/walk.h"

#include <QDialog>

class QButtonGroup;
class QDialogButtonBox;
class QDoubleSpinBox;
class QLineEdit;
class QRadioButton;
class QSpinBox;

namespace farol::ui {

class SourceDialog : public QDialog {
    Q_OBJECT

public:
    explicit SourceDialog(const WalkSource& current, QWidget* parent = nullptr);

    WalkSource source() const;

private:
    void browse();
    void refresh();

    QRadioButton *m_camera, *m_file, *m_folder, *m_address;
    QSpinBox* m_number;
    QLineEdit *m_fileEdit, *m_folderEdit, *m_addressEdit;
    QDoubleSpinBox* m_rate;
    QDialogButtonBox* m_buttons;
};

} // namespace farol::ui
