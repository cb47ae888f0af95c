#pragma once
// Language, voice and what is told. Changes count when the dialog is accepted.

#include "ui/settings/settings.h"

#include <QDialog>

class QComboBox;
class QFormLayout;
class QLineEdit;
class QSlider;

namespace farol::ui {

class SettingsDialog : public QDialog {
    Q_OBJECT

public:
    explicit SettingsDialog(Settings& settings, QWidget* parent = nullptr);

    void accept() override;

private:
    void buildWords(QFormLayout& form);
    void buildVoice(QFormLayout& form);
    void buildFolder(QFormLayout& form);
    void fillVoices();

    Settings& m_settings;
    QComboBox *m_language, *m_style, *m_verbosity, *m_engine, *m_voice;
    QSlider *m_rate, *m_volume;
    QLineEdit* m_folder;
};

} // namespace farol::ui
