#pragma once
// Language, colours, voice, what is told, and the figures of guidance, routes and recognition: a page for
// each. Changes count when the dialog is accepted.

#include "ui/settings/settings.h"

#include <QDialog>

#include <vector>

class QComboBox;
class QFormLayout;
class QLineEdit;
class QSlider;
class QTabWidget;

namespace farol::ui {

class OptionForm;

class SettingsDialog : public QDialog {
    Q_OBJECT

public:
    explicit SettingsDialog(Settings& settings, QWidget* parent = nullptr);

    void accept() override;

private:
    void buildWords(QFormLayout& form);
    void buildVoice(QFormLayout& form);
    void buildFolder(QFormLayout& form);
    void addForms();
    void fillVoices();

    Settings& m_settings;
    QTabWidget* m_tabs;
    QComboBox *m_language, *m_look, *m_style, *m_unit, *m_verbosity, *m_engine, *m_voice;
    QSlider *m_rate, *m_volume;
    QLineEdit* m_folder;
    std::vector<OptionForm*> m_forms;
};

} // namespace farol::ui
