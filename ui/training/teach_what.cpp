#include "ui/training/teach_what.h"

#include "ui/speech/phrasebook.h"
#include "ui/training/teach_session.h"
#include "ui/training/training_words.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

namespace farol::ui {

TeachWhat::TeachWhat(TeachSession& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_intro(new QLabel(this)),
      m_name(new QLineEdit(this)),
      m_id(new QLineEdit(this)),
      m_kind(new QComboBox(this)),
      m_problem(new QLabel(this)) {
    m_intro->setWordWrap(true);
    m_problem->setWordWrap(true);
    m_width = metres();
    m_height = metres();
    for (const Kind kind : allKinds()) m_kind->addItem(QString(), static_cast<int>(kind));
    auto* form = new QFormLayout;
    form->setVerticalSpacing(10);
    const auto row = [&](QWidget* field) {
        auto* label = new QLabel(this);
        label->setBuddy(field);
        form->addRow(label, field);
        return label;
    };
    m_nameLabel = row(m_name);
    m_kindLabel = row(m_kind);
    m_widthLabel = row(m_width);
    m_heightLabel = row(m_height);
    m_idLabel = row(m_id);
    auto* inner = new QVBoxLayout;
    inner->addWidget(m_intro);
    inner->addSpacing(8);
    inner->addLayout(form);
    inner->addWidget(m_problem);
    inner->addStretch(1);
    auto* box = new QWidget(this);
    box->setLayout(inner);
    box->setMaximumWidth(680);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 12);
    layout->addWidget(box);
    connect(m_name, &QLineEdit::textEdited, this, [this] {
        if (!m_ownId) m_id->setText(TrainingWords::idFrom(m_name->text()));
        tell();
    });
    connect(m_id, &QLineEdit::textEdited, this, [this] {
        m_ownId = !m_id->text().isEmpty();
        tell();
    });
    connect(m_kind, &QComboBox::currentIndexChanged, this, &TeachWhat::tell);
    for (QDoubleSpinBox* box_ : {m_width, m_height})
        connect(box_, &QDoubleSpinBox::valueChanged, this, &TeachWhat::tell);
    connect(&session, &TeachSession::changed, this, &TeachWhat::refresh);
    retranslate();
}

QDoubleSpinBox* TeachWhat::metres() {
    auto* box = new QDoubleSpinBox(this);
    box->setRange(0.0, 50.0);
    box->setDecimals(2);
    box->setSingleStep(0.05);
    box->setSuffix(QStringLiteral(" m"));
    return box;
}

void TeachWhat::show() {
    m_showing = true;
    const TeachDraft& draft = m_session.draft();
    m_name->setText(draft.name);
    m_id->setText(draft.id);
    m_ownId = !draft.id.isEmpty() && draft.id != TrainingWords::idFrom(draft.name);
    m_kind->setCurrentIndex(m_kind->findData(static_cast<int>(draft.kind)));
    m_width->setValue(draft.widthM);
    m_height->setValue(draft.heightM);
    m_id->setEnabled(!draft.extends);
    m_kind->setEnabled(!draft.extends);
    m_showing = false;
    refresh();
}

void TeachWhat::tell() {
    if (m_showing) return;
    m_session.setWhat(m_name->text().trimmed(), m_id->text().trimmed(),
                      static_cast<Kind>(m_kind->currentData().toInt()), m_width->value(), m_height->value());
}

void TeachWhat::refresh() {
    const QString problem = m_name->text().isEmpty() ? QString() : m_session.nameProblem();
    m_problem->setText(problem);
    m_problem->setVisible(!problem.isEmpty());
    const bool place = m_session.draft().kind == Kind::Place;
    m_width->setEnabled(!place);
    m_height->setEnabled(!place);
}

void TeachWhat::retranslate() {
    m_intro->setText(
        tr("What is it that Farol shall know again? A sign, a poster, a door with something on it: flat "
           "things with detail are known best. Choose “known place” for the whole view of a spot."));
    const auto name = [](QLabel* label, QWidget* field, const QString& text, const QString& accessible,
                         const QString& tip) {
        label->setText(text);
        field->setAccessibleName(accessible);
        field->setToolTip(tip);
    };
    name(m_nameLabel, m_name, tr("&Name:"), tr("Name"), tr("What people call it"));
    name(m_kindLabel, m_kind, tr("&Kind:"), tr("Kind"), tr("What it is"));
    name(m_widthLabel, m_width, tr("Real &width:"), tr("Real width"),
         tr("Lets Farol tell how far away it is"));
    name(m_heightLabel, m_height, tr("Real &height:"), tr("Real height"),
         tr("Lets Farol tell how far away it is"));
    name(m_idLabel, m_id, tr("In &maps called:"), tr("In maps called"),
         tr("Landmarks of the map refer to it by this word, so it should not change"));
    for (QDoubleSpinBox* box : {m_width, m_height}) box->setSpecialValueText(tr("not known"));
    m_showing = true;
    for (int i = 0; i < m_kind->count(); ++i)
        m_kind->setItemText(i, Phrasebook::kindWord(static_cast<Kind>(m_kind->itemData(i).toInt())));
    m_showing = false;
    refresh();
}

void TeachWhat::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

} // namespace farol::ui
