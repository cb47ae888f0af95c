#pragma once
// Which map of another kind is to be brought in, and how it is to be read.

#include "core/building/import/importer.h"

#include <QDialog>

class QComboBox;
class QDialogButtonBox;
class QLineEdit;

namespace farol::ui {

class ImportDialog : public QDialog {
    Q_OBJECT

public:
    explicit ImportDialog(const QString& folder, QWidget* parent = nullptr);

    QString source() const;
    building::ImportOptions options() const;
    QLineEdit& path() { return *m_path; }

private:
    void browseFile();
    void browseFolder();
    void refresh();

    QString m_folder;
    QLineEdit *m_path, *m_levels, *m_profile, *m_language;
    QComboBox* m_format;
    QDialogButtonBox* m_buttons;
};

} // namespace farol::ui
