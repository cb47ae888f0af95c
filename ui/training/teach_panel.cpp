#include "ui/training/teach_panel.h"

#include "ui/convert/convert.h"
#include "ui/parts/naming.h"
#include "ui/training/outline_view.h"
#include "ui/training/teach_try.h"
#include "ui/training/teach_views.h"
#include "ui/training/teach_what.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace farol::ui {

TeachPanel::TeachPanel(TeachSession& session, PictureReel::OpenSource open, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_reel(std::move(open)),
      m_title(new QLabel(this)),
      m_steps(new QLabel(this)),
      m_stack(new QStackedWidget(this)),
      m_what(new TeachWhat(session, m_stack)),
      m_views(new TeachViews(session, m_reel, m_stack)),
      m_try(new TeachTry(session, m_reel, m_stack)),
      m_end(buildEnd()),
      m_why(new QLabel(this)),
      m_back(new QPushButton(this)),
      m_forward(new QPushButton(this)),
      m_aside(new QPushButton(this)),
      m_giveUp(new QPushButton(this)) {
    QFont large = m_title->font();
    large.setBold(true);
    large.setPointSizeF(large.pointSizeF() * 1.3);
    m_title->setFont(large);
    m_title->setTextFormat(Qt::PlainText);
    for (QWidget* page : std::initializer_list<QWidget*>{m_what, m_views, m_try, m_end})
        m_stack->addWidget(page);
    auto* head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    head->addWidget(m_steps);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_giveUp);
    buttons->addWidget(m_aside);
    buttons->addWidget(m_why, 1);
    buttons->addWidget(m_back);
    buttons->addWidget(m_forward);
    m_why->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_why->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(head);
    layout->addWidget(m_stack, 1);
    layout->addLayout(buttons);
    connect(m_back, &QPushButton::clicked, this, [this] { go(static_cast<Step>(step() - 1)); });
    connect(m_forward, &QPushButton::clicked, this, &TeachPanel::goOn);
    connect(m_aside, &QPushButton::clicked, this, &TeachPanel::putAside);
    connect(m_giveUp, &QPushButton::clicked, this, [this] {
        auto* box = new QMessageBox(QMessageBox::Question, tr("Give up?"),
                                    tr("What you have taught of this landmark will be lost."),
                                    QMessageBox::NoButton, this);
        box->setAttribute(Qt::WA_DeleteOnClose);
        auto* yes = box->addButton(tr("&Give it up"), QMessageBox::DestructiveRole);
        QPushButton* keep = box->addButton(tr("&Keep it"), QMessageBox::RejectRole);
        box->setDefaultButton(keep); // a slip on Enter loses nothing
        connect(box, &QMessageBox::buttonClicked, this, [this, yes](QAbstractButton* button) {
            if (button == yes) Q_EMIT givenUp();
        });
        box->open();
    });
    connect(&m_session, &TeachSession::changed, this, &TeachPanel::refresh);
    retranslate();
}

QWidget* TeachPanel::buildEnd() {
    auto* box = new QWidget(m_stack);
    m_endText = new QLabel(box);
    m_endText->setWordWrap(true);
    m_endText->setTextFormat(Qt::PlainText);
    m_place = new QPushButton(box);
    m_another = new QPushButton(box);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_place);
    buttons->addWidget(m_another);
    buttons->addStretch(1);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(16, 12, 16, 12);
    layout->addWidget(m_endText);
    layout->addSpacing(8);
    layout->addLayout(buttons);
    layout->addStretch(1);
    connect(m_place, &QPushButton::clicked, this, &TeachPanel::placeWanted);
    connect(m_another, &QPushButton::clicked, this, &TeachPanel::anotherWanted);
    return box;
}

TeachPanel::Step TeachPanel::step() const {
    return static_cast<Step>(m_stack->currentIndex());
}

void TeachPanel::begin() {
    m_saved = false;
    m_what->show();
    m_views->outline().setOutline(std::nullopt);
    m_views->show();
    const int step = std::clamp(m_session.draft().step, static_cast<int>(What), static_cast<int>(Try));
    const bool usable = m_session.nameProblem().isEmpty();
    go(!usable ? What : m_session.draft().views.empty() && step > Views ? Views : static_cast<Step>(step));
}

void TeachPanel::go(Step step) {
    m_stack->setCurrentIndex(step);
    m_views->setShown(step == Views);
    m_try->setShown(step == Try);
    if (step != End) m_session.setStep(step);
    if (step == What) m_what->name().setFocus(Qt::OtherFocusReason);
    if (step == Views) m_views->show();
    if (step == End) {
        m_reel.close(); // the camera is let go
        m_place->setFocus(Qt::OtherFocusReason);
    }
    refresh();
}

void TeachPanel::goOn() {
    if (step() == Try) return void(Q_EMIT saveWanted());
    if (step() == End) return void(Q_EMIT putAside());
    go(static_cast<Step>(step() + 1));
}

void TeachPanel::showSaved() {
    m_saved = true;
    go(End);
}

QString TeachPanel::why() const {
    if (step() == What) return m_session.nameProblem();
    if (step() == Views && !m_session.trained()) return tr("Add a view first.");
    if (step() != What && m_session.training()) return tr("Learning…");
    return {};
}

void TeachPanel::refresh() {
    const QString name = m_session.draft().name;
    m_title->setText(name.isEmpty() ? tr("A new landmark") : name);
    const QStringList names{tr("What it is"), tr("Views"), tr("Trial"), tr("Map")};
    QStringList steps;
    for (int i = 0; i < names.size(); ++i) {
        const QString text = tr("%1. %2").arg(i + 1).arg(names.at(i)).toHtmlEscaped();
        steps << (i == step() ? QStringLiteral("<b>%1</b>").arg(text) : text);
    }
    m_steps->setText(steps.join(QStringLiteral(" &nbsp;›&nbsp; ")));
    m_steps->setAccessibleName(
        tr("Step %1 of %2: %3").arg(step() + 1).arg(names.size()).arg(names.at(step())));
    const bool end = step() == End;
    const QString why = this->why();
    m_why->setText(why);
    m_back->setVisible(!end);
    m_back->setEnabled(step() > What);
    m_aside->setVisible(!end);
    m_giveUp->setVisible(!end);
    m_forward->setEnabled(why.isEmpty());
    m_forward->setText(end ? tr("&Done") : step() == Try ? tr("&Save it") : tr("&Go on"));
    m_forward->setAccessibleName(m_forward->text().remove(QLatin1Char('&')));
    m_forward->setToolTip(end             ? tr("Go back to the library")
                          : step() == Try ? tr("Put it into the library")
                                          : tr("The next step"));
    m_endText->setText(
        tr("“%1” is in the library. Where does it hang? Put it on the map, so that Farol knows "
           "where you are when it is seen. The same landmark can hang in several places.")
            .arg(name));
}

void TeachPanel::retranslate() {
    const auto& name = nameButton;
    name(m_back, tr("&Back"), tr("Back"), tr("The step before"));
    name(m_aside, tr("Put as&ide"), tr("Put aside"),
         tr("Go back to the library and go on with this landmark later"));
    name(m_giveUp, tr("Give &up"), tr("Give up"), tr("Forget this landmark"));
    name(m_place, tr("Put it on the &map…"), tr("Put it on the map"), tr("Choose its place on the Map page"));
    name(m_another, tr("Teach an&other"), tr("Teach another"), tr("Teach the next landmark"));
    refresh();
}

void TeachPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

} // namespace farol::ui
