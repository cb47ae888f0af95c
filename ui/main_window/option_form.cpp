#include "ui/main_window/option_form.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include <cmath>

namespace farol::ui {

void OptionForm::build(const QString& about) {
    auto* text = new QLabel(about, this);
    text->setWordWrap(true);
    m_form = new QFormLayout;
    m_reset = new QPushButton(tr("&Defaults"), this);
    m_reset->setAccessibleName(tr("Defaults"));
    m_reset->setToolTip(tr("Take every figure of this page back to what the program has"));
    connect(m_reset, &QPushButton::clicked, this, &OptionForm::takeBack);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(text);
    layout->addLayout(m_form);
    layout->addStretch(1);
    layout->addWidget(m_reset, 0, Qt::AlignLeft);
}

void OptionForm::addRow(const Settings& settings, const Row& row) {
    const double now = settings.option(row.key).value_or(row.usual);
    if (row.yesOrNo) {
        auto* box = new QCheckBox(row.label, this);
        box->setObjectName(row.key);
        box->setAccessibleName(row.label);
        box->setToolTip(row.label);
        box->setChecked(now != 0.0);
        m_form->addRow(QString(), box);
        m_rows.push_back({row, [box] { return box->isChecked() ? 1.0 : 0.0; },
                          [box](double value) { box->setChecked(value != 0.0); }});
        return;
    }
    auto* box = new QDoubleSpinBox(this);
    box->setObjectName(row.key);
    box->setRange(row.low, row.high);
    box->setDecimals(row.whole ? 0 : row.step < 0.1 ? 2 : row.step < 1.0 ? 2 : 1);
    box->setSingleStep(row.step);
    if (!row.unit.isEmpty()) box->setSuffix(QLatin1Char(' ') + row.unit);
    box->setValue(now);
    box->setAccessibleName(row.label);
    box->setToolTip(tr("Usually %1").arg(QLocale().toString(row.usual) + box->suffix()));
    auto* label = new QLabel(tr("%1:").arg(row.label), this);
    label->setBuddy(box);
    m_form->addRow(label, box);
    m_rows.push_back({row, [box] { return box->value(); }, [box](double value) { box->setValue(value); }});
}

void OptionForm::store(Settings& settings) const {
    for (const Shown& shown : m_rows) {
        const double value = shown.value();
        const bool usual = std::abs(value - shown.row.usual) < 1e-6;
        settings.setOption(shown.row.key, usual ? std::nullopt : std::optional(value));
    }
}

void OptionForm::takeBack() {
    for (const Shown& shown : m_rows) shown.set(shown.row.usual);
}

} // namespace farol::ui
