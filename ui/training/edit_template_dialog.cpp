#include "ui/training/edit_template_dialog.h"

#include "ui/convert/convert.h"
#include "ui/speech/phrasebook.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>

namespace farol::ui {

EditTemplateDialog::EditTemplateDialog(const recognition::Template& entry, QWidget* parent)
    : QDialog(parent),
      m_name(new QLineEdit(toQString(entry.name), this)),
      m_id(new QLineEdit(toQString(entry.id.value), this)),
      m_kind(new QComboBox(this)) {
    setWindowTitle(tr("Change “%1”").arg(toQString(entry.name.empty() ? entry.id.value : entry.name)));
    for (const Kind kind : allKinds()) m_kind->addItem(Phrasebook::kindWord(kind), static_cast<int>(kind));
    m_kind->setCurrentIndex(m_kind->findData(static_cast<int>(entry.kind)));
    const auto metres = [this](const std::optional<double>& value) {
        auto* box = new QDoubleSpinBox(this);
        box->setRange(0.0, 999.0);
        box->setDecimals(2);
        box->setSingleStep(0.05);
        box->setSuffix(QStringLiteral(" m"));
        box->setSpecialValueText(tr("not known"));
        box->setValue(value.value_or(0.0));
        return box;
    };
    m_width = metres(entry.widthM);
    m_height = metres(entry.heightM);
    m_shownWidth = m_width->value();
    m_shownHeight = m_height->value();
    auto* form = new QFormLayout(this);
    const auto row = [&](const QString& name, QWidget* field, const QString& tip) {
        auto* label = new QLabel(tr("%1:").arg(name), this);
        label->setBuddy(field);
        field->setAccessibleName(name);
        field->setToolTip(tip);
        form->addRow(label, field);
    };
    row(tr("Name"), m_name, tr("What people call it"));
    row(tr("Kind"), m_kind, tr("What it is"));
    row(tr("Real width"), m_width, tr("Lets Farol tell how far away it is"));
    row(tr("Real height"), m_height, tr("Lets Farol tell how far away it is"));
    row(tr("In maps called"), m_id,
        tr("Landmarks of the map refer to it by this word: when it changes, change them too"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    setMinimumWidth(420);
}

recognition::Template EditTemplateDialog::changed(recognition::Template entry) const {
    entry.name = toUtf8(m_name->text().trimmed());
    entry.id = TemplateId(toUtf8(m_id->text().trimmed()));
    entry.kind = static_cast<Kind>(m_kind->currentData().toInt());
    const auto size = [](const QDoubleSpinBox* box, double shown, const std::optional<double>& before) {
        if (box->value() == shown) return before; // a spin box holds centimetres: what was not touched stays
        return box->value() > 0.0 ? std::optional(box->value()) : std::nullopt;
    };
    entry.widthM = size(m_width, m_shownWidth, entry.widthM);
    entry.heightM = size(m_height, m_shownHeight, entry.heightM);
    return entry;
}

} // namespace farol::ui
