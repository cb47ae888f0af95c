#include "ui/curation/import_dialog.h"

#include "ui/convert/convert.h"
#include "ui/speech/phrasebook.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <array>
#include <utility>

namespace farol::ui {

namespace {

using building::MapFormat;

// Names of formats, the same in every language.
constexpr std::array<std::pair<MapFormat, const char*>, 8> kFormats{{{MapFormat::Imdf, "IMDF"},
                                                                     {MapFormat::Osm, "OpenStreetMap"},
                                                                     {MapFormat::IndoorGml, "IndoorGML"},
                                                                     {MapFormat::Shapefile, "Shapefile"},
                                                                     {MapFormat::GeoJson, "GeoJSON"},
                                                                     {MapFormat::GeoPackage, "GeoPackage"},
                                                                     {MapFormat::Hulop, "HULOP"},
                                                                     {MapFormat::Wrld, "WRLD"}}};

} // namespace

ImportDialog::ImportDialog(const QString& folder, QWidget* parent)
    : QDialog(parent),
      m_folder(folder),
      m_path(new QLineEdit(this)),
      m_levels(new QLineEdit(this)),
      m_profile(new QLineEdit(this)),
      m_language(new QLineEdit(this)),
      m_format(new QComboBox(this)),
      m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)) {
    setWindowTitle(tr("Import a map"));
    auto* intro = new QLabel(tr("A file, a folder or a zip: IMDF, OpenStreetMap indoor, IndoorGML, per-floor "
                                "Shapefiles, GeoJSON, GeoPackage, HULOP, WRLD. What is found wrong is told "
                                "afterwards; nothing is written until you save."),
                             this);
    intro->setWordWrap(true);
    auto* file = new QPushButton(tr("&File…"), this);
    auto* directory = new QPushButton(tr("Fol&der…"), this);
    file->setAccessibleName(tr("Choose a file"));
    directory->setAccessibleName(tr("Choose a folder"));
    auto* where = new QGridLayout;
    where->addWidget(m_path, 0, 0, 1, 3);
    where->addWidget(file, 1, 1);
    where->addWidget(directory, 1, 2);
    where->setColumnStretch(0, 1);
    m_format->addItem(tr("by its content"), -1);
    for (const auto& [format, name] : kFormats)
        m_format->addItem(QLatin1String(name), static_cast<int>(format));
    m_language->setText(installedLanguage());
    m_levels->setPlaceholderText(tr("as the format has it"));
    m_profile->setPlaceholderText(tr("none is needed"));
    auto* form = new QFormLayout;
    const auto row = [&](const QString& name, QWidget* field, const QString& tip) {
        auto* label = new QLabel(tr("%1:").arg(name), this);
        label->setBuddy(field);
        field->setAccessibleName(name);
        field->setToolTip(tip);
        return label;
    };
    form->addRow(row(tr("Map"), m_path, tr("Path of the file, folder or zip")), where);
    form->addRow(row(tr("Kind"), m_format, tr("Of which kind the map is")), m_format);
    form->addRow(
        row(tr("Language of names"), m_language, tr("Which of several names is taken, such as en or pt")),
        m_language);
    form->addRow(row(tr("Where the level is"), m_levels,
                     tr("Where the map leaves it open: filename, z, or the name of a column")),
                 m_levels);
    form->addRow(
        row(tr("File of other names"), m_profile, tr("A file with other names of columns and codes")),
        m_profile);
    m_buttons->button(QDialogButtonBox::Ok)->setText(tr("&Import"));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(intro);
    layout->addLayout(form);
    layout->addWidget(m_buttons);
    setMinimumWidth(520);
    connect(file, &QPushButton::clicked, this, &ImportDialog::browseFile);
    connect(directory, &QPushButton::clicked, this, &ImportDialog::browseFolder);
    connect(m_path, &QLineEdit::textChanged, this, &ImportDialog::refresh);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    m_path->setFocus();
    refresh();
}

void ImportDialog::browseFile() {
    const QString chosen = QFileDialog::getOpenFileName(this, tr("Import a map"), m_folder);
    if (!chosen.isEmpty()) m_path->setText(QDir::toNativeSeparators(chosen));
}

void ImportDialog::browseFolder() {
    const QString chosen = QFileDialog::getExistingDirectory(this, tr("Import a map"), m_folder);
    if (!chosen.isEmpty()) m_path->setText(QDir::toNativeSeparators(chosen));
}

void ImportDialog::refresh() {
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(!source().isEmpty());
}

QString ImportDialog::source() const {
    return QDir::fromNativeSeparators(m_path->text().trimmed());
}

building::ImportOptions ImportDialog::options() const {
    building::ImportOptions options;
    if (const int format = m_format->currentData().toInt(); format >= 0)
        options.format = static_cast<MapFormat>(format);
    options.profile = toUtf8(m_profile->text().trimmed());
    options.levelFrom = toUtf8(m_levels->text().trimmed());
    options.language = toUtf8(m_language->text().trimmed());
    return options;
}

} // namespace farol::ui
