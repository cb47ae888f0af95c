#include "ui/live/frame_panel.h"

#include "ui/convert/convert.h"
#include "ui/parts/tables.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <cmath>

namespace farol::ui {

FramePanel::FramePanel(QWidget* parent)
    : QWidget(parent),
      m_view(new FrameView(this)),
      m_title(panelTitle(this)),
      m_when(new ElidedLabel(this)),
      m_cost(new ElidedLabel(this)) {
    auto* facts = new QHBoxLayout;
    facts->setContentsMargins(0, 0, 6, 0);
    facts->addWidget(m_when);
    facts->addWidget(m_cost);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_title);
    layout->addWidget(m_view, 1);
    layout->addLayout(facts);
    m_cost->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    facts->setStretch(0, 4);
    facts->setStretch(1, 6);
    retranslate();
}

void FramePanel::show(const std::shared_ptr<const session::Snapshot>& snapshot) {
    const bool newFrame = snapshot && (!m_snapshot || m_snapshot->frame.index != snapshot->frame.index ||
                                       m_snapshot->frame.image.data != snapshot->frame.image.data);
    m_snapshot = snapshot;
    if (!snapshot) {
        m_view->setFrame({});
        m_view->setFindings({}, {});
    } else if (newFrame) {
        m_view->setFrame(toQImage(snapshot->frame.image));
        m_view->setFindings(session::inView(snapshot->step.percept), snapshot->step.percept.rejections);
    }
    retranslate();
}

QString FramePanel::facts() const {
    return QStringLiteral("%1 %2").arg(m_when->text(), m_cost->text());
}

void FramePanel::retranslate() {
    m_title->setText(tr("What the camera sees"));
    m_view->setAccessibleName(tr("Camera picture"));
    m_view->setToolTip(tr("The camera's picture, with what Farol recognised in it"));
    if (!m_snapshot || m_snapshot->frame.image.empty()) {
        m_when->clear();
        m_cost->clear();
        return;
    }
    const capture::Frame& frame = m_snapshot->frame;
    const QString name = toQString(frame.name);
    const QString number = QString::number(frame.index + 1);
    m_when->setText(name.isEmpty()
                        ? tr("Picture %1 at %2").arg(number, clockText(frame.capturedAt))
                        : tr("Picture %1 at %2 (%3)").arg(number, clockText(frame.capturedAt), name));
    QStringList cost;
    cost << tr("understood in %1 ms").arg(std::lround(m_snapshot->times.ageMs));
    const int late = static_cast<int>(m_snapshot->framesDropped);
    const int unreadable = static_cast<int>(m_snapshot->framesSkipped);
    cost << tr("%n left out because late", nullptr, late);
    if (unreadable > 0) cost << tr("%n unreadable", nullptr, unreadable);
    m_cost->setText(cost.join(QStringLiteral(" · ")));
    m_when->setToolTip(m_when->text());
    m_cost->setToolTip(
        m_cost->text() + QLatin1Char('\n') +
        tr("Time from the picture's arrival to the answer, and how many pictures had to be left out "
           "because Farol was still busy with an earlier one"));
}

void FramePanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

} // namespace farol::ui
