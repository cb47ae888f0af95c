#include "ui/main_window/settings_dialog.h"

#include "ui/main_window/option_form.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <functional>

namespace farol::ui {

namespace {

void name(QWidget* widget, const QString& accessible, const QString& tip) {
    widget->setAccessibleName(accessible);
    widget->setToolTip(tip);
}

/// A slider with what it stands at beside it.
QLayout* withFigure(QSlider* slider, const std::function<QString(int)>& words) {
    auto* figure = new QLabel(slider->parentWidget());
    figure->setTextFormat(Qt::PlainText);
    int widest = 0;
    for (const int value : {slider->minimum(), 0, slider->maximum()})
        widest = std::max(widest, figure->fontMetrics().horizontalAdvance(words(value)));
    figure->setMinimumWidth(widest + 8);
    const auto tell = [figure, words](int value) { figure->setText(words(value)); };
    tell(slider->value());
    QObject::connect(slider, &QSlider::valueChanged, figure, tell);
    auto* row = new QHBoxLayout;
    row->addWidget(slider, 1);
    row->addWidget(figure);
    return row;
}

/// Of a field that shares its row with a button.
QLabel* labelFor(const QString& text, QWidget* field) {
    auto* label = new QLabel(text, field->parentWidget());
    label->setBuddy(field);
    return label;
}

} // namespace

SettingsDialog::SettingsDialog(Settings& settings, QWidget* parent)
    : QDialog(parent),
      m_settings(settings),
      m_tabs(new QTabWidget(this)),
      m_language(new QComboBox(this)),
      m_look(new QComboBox(this)),
      m_style(new QComboBox(this)),
      m_unit(new QComboBox(this)),
      m_verbosity(new QComboBox(this)),
      m_engine(new QComboBox(this)),
      m_voice(new QComboBox(this)),
      m_rate(new QSlider(Qt::Horizontal, this)),
      m_volume(new QSlider(Qt::Horizontal, this)),
      m_folder(new QLineEdit(this)) {
    setWindowTitle(tr("Settings"));
    m_tabs->setAccessibleName(tr("Pages of the settings"));
    m_tabs->tabBar()->setAccessibleName(tr("Pages of the settings"));
    const auto page = [this](const QString& title) {
        auto* box = new QWidget(m_tabs);
        auto* form = new QFormLayout(box);
        form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
        m_tabs->addTab(box, title);
        return form;
    };
    QFormLayout* general = page(tr("General"));
    buildWords(*general);
    buildFolder(*general);
    buildVoice(*page(tr("Voice")));
    addForms();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_tabs, 1);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &SettingsDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    setMinimumWidth(560);
}

void SettingsDialog::addForms() {
    const auto add = [this](const QString& title, OptionForm* form) {
        m_tabs->addTab(form, title);
        m_forms.push_back(form);
    };
    add(tr("Guidance"), new OptionForm(m_settings, guidanceFields(),
                                       tr("When something is said. From the next start of a walk."), m_tabs));
    add(tr("Routes"), new OptionForm(m_settings, routeFields(),
                                     tr("Which way is chosen. From the next start of a walk."), m_tabs));
    add(tr("Recognition"),
        new OptionForm(
            m_settings, recogniserFields(),
            tr("How sure a landmark must be before it counts. Lower figures find more, and more that is "
               "wrong: leave them unless you can check. From the next start of a walk."),
            m_tabs));
}

void SettingsDialog::buildWords(QFormLayout& form) {
    m_language->addItem(tr("As the computer is set"), QString());
    for (const Language& each : languages()) m_language->addItem(each.name, each.code);
    m_language->setCurrentIndex(std::max(0, m_language->findData(m_settings.language())));
    name(m_language, tr("Language"), tr("Language of the window and of the voice"));
    form.addRow(tr("&Language:"), m_language);

    m_look->addItems({tr("As the computer is set"), tr("Light"), tr("Dark")});
    m_look->setCurrentIndex(static_cast<int>(m_settings.look()));
    name(m_look, tr("Colours"), tr("Light or dark windows"));
    form.addRow(tr("&Colours:"), m_look);

    m_style->addItems({tr("Left and right"), tr("Hours of a clock"), tr("Degrees")});
    m_style->setCurrentIndex(static_cast<int>(m_settings.directionStyle()));
    name(m_style, tr("Directions"), tr("How turns are told"));
    form.addRow(tr("&Directions:"), m_style);

    m_unit->addItems({tr("Metres"), tr("Feet"), tr("Steps")});
    m_unit->setCurrentIndex(static_cast<int>(m_settings.unit()));
    name(m_unit, tr("Distances"), tr("How distances are told"));
    form.addRow(tr("Dis&tances:"), m_unit);

    m_verbosity->addItems({tr("The way only"), tr("The way and objects"), tr("The way, objects and texts")});
    m_verbosity->setCurrentIndex(static_cast<int>(m_settings.verbosity()));
    name(m_verbosity, tr("What is told"), tr("How much is told on the way"));
    form.addRow(tr("&What is told:"), m_verbosity);
}

void SettingsDialog::buildVoice(QFormLayout& form) {
    const VoiceChoice voice = m_settings.voice();
    m_engine->addItem(tr("The first that works"), QString());
    for (const QString& engine : speechEngines()) m_engine->addItem(engine, engine);
    m_engine->setCurrentIndex(std::max(0, m_engine->findData(voice.engine)));
    name(m_engine, tr("Speech program"), tr("Which speech program of this computer speaks"));
    form.addRow(tr("&Speech program:"), m_engine);

    m_voice->addItem(tr("What fits the language"), QString());
    if (!voice.voice.isEmpty()) m_voice->addItem(voice.voice, voice.voice);
    m_voice->setCurrentIndex(std::max(0, m_voice->findData(voice.voice)));
    name(m_voice, tr("Voice"), tr("Press “List voices” to choose among those of the speech program"));
    auto* list = new QPushButton(tr("List &voices"), this);
    name(list, tr("List voices"), tr("Ask the speech program for its voices; this can take some seconds"));
    connect(list, &QPushButton::clicked, this, &SettingsDialog::fillVoices);
    connect(m_engine, &QComboBox::activated, this, [this] {
        while (m_voice->count() > 1) m_voice->removeItem(1);
    });
    auto* row = new QHBoxLayout;
    row->addWidget(m_voice, 1);
    row->addWidget(list);
    form.addRow(labelFor(tr("V&oice:"), m_voice), row);

    m_rate->setRange(-100, 100);
    m_rate->setValue(static_cast<int>(voice.rate * 100.0));
    name(m_rate, tr("Speed of the voice"), tr("Slow on the left, fast on the right"));
    form.addRow(
        labelFor(tr("S&peed of the voice:"), m_rate), withFigure(m_rate, [](int value) {
            return value == 0 ? tr("normal") : value > 0 ? tr("+%1").arg(value) : tr("−%1").arg(-value);
        }));
    m_volume->setRange(0, 100);
    m_volume->setValue(static_cast<int>(voice.volume * 100.0));
    name(m_volume, tr("Loudness"), tr("How loud the voice is"));
    form.addRow(labelFor(tr("Lo&udness:"), m_volume),
                withFigure(m_volume, [](int value) { return tr("%1 %").arg(value); }));
}

void SettingsDialog::buildFolder(QFormLayout& form) {
    m_folder->setText(m_settings.recordingFolder());
    name(m_folder, tr("Folder of recordings"), tr("Where recorded walks are kept"));
    auto* browse = new QPushButton(tr("&Browse…"), this);
    name(browse, tr("Browse for the folder of recordings"), tr("Choose where recorded walks are kept"));
    connect(browse, &QPushButton::clicked, this, [this] {
        const QString folder =
            QFileDialog::getExistingDirectory(this, tr("Folder of recordings"), m_folder->text());
        if (!folder.isEmpty()) m_folder->setText(folder);
    });
    auto* row = new QHBoxLayout;
    row->addWidget(m_folder, 1);
    row->addWidget(browse);
    form.addRow(labelFor(tr("&Recordings:"), m_folder), row);
}

void SettingsDialog::fillVoices() {
    VoiceChoice choice = m_settings.voice();
    choice.engine = m_engine->currentData().toString();
    choice.language = m_language->currentData().toString();
    const QString before = m_voice->currentData().toString();
    setCursor(Qt::WaitCursor);
    const QStringList voices = speechVoices(choice);
    unsetCursor();
    while (m_voice->count() > 1) m_voice->removeItem(1);
    for (const QString& voice : voices) m_voice->addItem(voice, voice);
    m_voice->setCurrentIndex(std::max(0, m_voice->findData(before)));
}

void SettingsDialog::accept() {
    VoiceChoice voice = m_settings.voice();
    voice.engine = m_engine->currentData().toString();
    voice.voice = m_voice->currentData().toString();
    voice.rate = m_rate->value() / 100.0;
    voice.volume = m_volume->value() / 100.0;
    m_settings.setVoice(voice);
    m_settings.setDirectionStyle(static_cast<DirectionStyle>(m_style->currentIndex()));
    m_settings.setVerbosity(static_cast<guidance::Verbosity>(m_verbosity->currentIndex()));
    m_settings.setUnit(static_cast<DistanceUnit>(m_unit->currentIndex()));
    for (const OptionForm* form : m_forms) form->store(m_settings);
    m_settings.setLook(static_cast<Look>(m_look->currentIndex()));
    m_settings.setRecordingFolder(m_folder->text().trimmed());
    m_settings.setLanguage(m_language->currentData().toString());
    QDialog::accept();
}

} // namespace farol::ui
