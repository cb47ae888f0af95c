#include "ui/main_window/source_dialog.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSpinBox>

namespace farol::ui {

SourceDialog::SourceDialog(const WalkSource& current, QWidget* parent)
    : QDialog(parent),
      m_camera(new QRadioButton(tr("&Camera number"), this)),
      m_file(new QRadioButton(tr("&Video file"), this)),
      m_folder(new QRadioButton(tr("&Folder of pictures"), this)),
      m_address(new QRadioButton(tr("Network &address"), this)),
      m_number(new QSpinBox(this)),
      m_fileEdit(new QLineEdit(this)),
      m_folderEdit(new QLineEdit(this)),
      m_addressEdit(new QLineEdit(this)),
      m_rate(new QDoubleSpinBox(this)),
      m_buttons(new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this)) {
    setWindowTitle(tr("Open pictures"));
    m_number->setRange(0, 63);
    m_number->setAccessibleName(tr("Camera number"));
    m_number->setToolTip(tr("0 is the first camera of this computer"));
    m_fileEdit->setAccessibleName(tr("Video file"));
    m_folderEdit->setAccessibleName(tr("Folder of pictures"));
    m_addressEdit->setAccessibleName(tr("Network address"));
    m_addressEdit->setPlaceholderText(QStringLiteral("rtsp://… http://…"));
    m_rate->setRange(0.1, 60.0);
    m_rate->setDecimals(1);
    m_rate->setValue(current.framesPerSecond > 0.0 ? current.framesPerSecond : 1.0);
    m_rate->setAccessibleName(tr("Pictures a second"));
    m_rate->setToolTip(tr("How many pictures of the folder make a second"));
    auto* rateLabel = new QLabel(tr("Pictures a &second:"), this);
    rateLabel->setBuddy(m_rate);
    auto* browseFile = new QPushButton(tr("&Browse…"), this);
    browseFile->setAccessibleName(tr("Browse for a video file"));
    auto* browseFolder = new QPushButton(tr("B&rowse…"), this);
    browseFolder->setAccessibleName(tr("Browse for a folder"));

    auto* grid = new QGridLayout(this);
    grid->addWidget(m_camera, 0, 0);
    grid->addWidget(m_number, 0, 1, Qt::AlignLeft);
    grid->addWidget(m_file, 1, 0);
    grid->addWidget(m_fileEdit, 1, 1);
    grid->addWidget(browseFile, 1, 2);
    grid->addWidget(m_folder, 2, 0);
    grid->addWidget(m_folderEdit, 2, 1);
    grid->addWidget(browseFolder, 2, 2);
    grid->addWidget(rateLabel, 3, 1, Qt::AlignRight);
    grid->addWidget(m_rate, 3, 2);
    grid->addWidget(m_address, 4, 0);
    grid->addWidget(m_addressEdit, 4, 1, 1, 2);
    grid->addWidget(m_buttons, 5, 0, 1, 3);
    grid->setColumnMinimumWidth(1, 320);

    for (QRadioButton* radio : {m_camera, m_file, m_folder, m_address})
        connect(radio, &QRadioButton::toggled, this, &SourceDialog::refresh);
    for (QLineEdit* edit : {m_fileEdit, m_folderEdit, m_addressEdit})
        connect(edit, &QLineEdit::textChanged, this, &SourceDialog::refresh);
    connect(browseFile, &QPushButton::clicked, this, [this] {
        m_file->setChecked(true);
        browse();
    });
    connect(browseFolder, &QPushButton::clicked, this, [this] {
        m_folder->setChecked(true);
        browse();
    });
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    const QString& name = current.name;
    m_camera->setChecked(true);
    if (name.startsWith(QLatin1String("camera:")))
        m_number->setValue(name.mid(7).toInt());
    else if (name.contains(QLatin1String("://")))
        (m_address->setChecked(true), m_addressEdit->setText(name));
    else if (QFileInfo(name).isDir())
        (m_folder->setChecked(true), m_folderEdit->setText(name));
    else if (!name.isEmpty())
        (m_file->setChecked(true), m_fileEdit->setText(name));
    refresh();
}

void SourceDialog::browse() {
    if (m_file->isChecked()) {
        const QString name = QFileDialog::getOpenFileName(
            this, tr("Open a video"), m_fileEdit->text(),
            tr("Videos (%1);;All files (%2)")
                .arg(QStringLiteral("*.mp4 *.avi *.mkv *.mov *.webm"), QStringLiteral("*")));
        if (!name.isEmpty()) m_fileEdit->setText(name);
    } else {
        const QString name =
            QFileDialog::getExistingDirectory(this, tr("Open a folder of pictures"), m_folderEdit->text());
        if (!name.isEmpty()) m_folderEdit->setText(name);
    }
}

void SourceDialog::refresh() {
    m_number->setEnabled(m_camera->isChecked());
    m_fileEdit->setEnabled(m_file->isChecked());
    m_folderEdit->setEnabled(m_folder->isChecked());
    m_rate->setEnabled(m_folder->isChecked());
    m_addressEdit->setEnabled(m_address->isChecked());
    m_buttons->button(QDialogButtonBox::Open)->setEnabled(!source().name.isEmpty());
}

WalkSource SourceDialog::source() const {
    if (m_camera->isChecked()) return {QStringLiteral("camera:%1").arg(m_number->value()), 0.0};
    if (m_file->isChecked()) return {m_fileEdit->text().trimmed(), 0.0};
    if (m_folder->isChecked()) return {m_folderEdit->text().trimmed(), m_rate->value()};
    return {m_addressEdit->text().trimmed(), 0.0};
}

} // namespace farol::ui
