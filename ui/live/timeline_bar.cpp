#include "ui/live/timeline_bar.h"

#include "ui/convert/convert.h"
#include "ui/convert/kind_style.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace farol::ui {

namespace {

constexpr double kMargin = 6.0;

} // namespace

TimelineSlider::TimelineSlider(const WalkTimeline& timeline, QWidget* parent)
    : QSlider(Qt::Horizontal, parent), m_timeline(timeline) {
    setMinimumHeight(30);
    setPageStep(25);
    setFocusPolicy(Qt::StrongFocus);
}

void TimelineSlider::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const QRectF area = QRectF(rect()).adjusted(kMargin, 3, -kMargin, -3);
    const bool dark = isDark(palette());
    painter.fillRect(area, palette().color(QPalette::Base));
    const auto& moments = m_timeline.moments();
    const int last = std::max(1, maximum());
    const double width = std::max(1.0, area.width() / (last + 1));
    const auto x = [&](std::size_t i) {
        return area.left() + area.width() * static_cast<double>(i) / (last + 1);
    };
    for (std::size_t i = 0; i < moments.size(); ++i) {
        const Moment& moment = moments[i];
        if (!moment.region) continue;
        const double height = area.height() * std::clamp(moment.confidence, 0.05, 1.0);
        const QColor colour = moment.confidence >= 0.5 ? QColor(dark ? 0x3f8fd6 : 0x6fb1ea)
                                                       : QColor(dark ? 0xa8792c : 0xf0c070);
        painter.fillRect(QRectF(x(i), area.bottom() - height, width + 0.5, height), colour);
    }
    painter.setPen(QPen(palette().color(QPalette::Text), 2));
    for (std::size_t i = 0; i < moments.size(); ++i)
        if (!moments[i].said.isEmpty())
            painter.drawLine(QPointF(x(i), area.top()), QPointF(x(i), area.top() + 7));
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawRect(area);
    if (isEnabled()) {
        const double at = area.left() + area.width() * (value() + 0.5) / (last + 1);
        painter.setPen(QPen(QColor(dark ? 0xff6b8a : 0xc2185b), 3));
        painter.drawLine(QPointF(at, area.top() - 2), QPointF(at, area.bottom() + 2));
    }
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
    }
}

int TimelineSlider::valueAt(double x) const {
    const double share = (x - kMargin) / std::max(1.0, width() - 2 * kMargin);
    return std::clamp(static_cast<int>(std::floor(share * (maximum() + 1))), minimum(), maximum());
}

void TimelineSlider::mousePressEvent(QMouseEvent* event) {
    setFocus(Qt::MouseFocusReason);
    setSliderDown(true);
    setValue(valueAt(event->position().x()));
}

void TimelineSlider::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() & Qt::LeftButton) setValue(valueAt(event->position().x()));
}

void TimelineSlider::mouseReleaseEvent(QMouseEvent* /*event*/) {
    setSliderDown(false);
}

TimelineBar::TimelineBar(WalkTimeline& timeline, QWidget* parent)
    : QWidget(parent),
      m_timeline(timeline),
      m_title(new QLabel(this)),
      m_when(new QLabel(this)),
      m_slider(new TimelineSlider(timeline, this)),
      m_now(new QToolButton(this)) {
    m_title->setBuddy(m_slider);
    m_now->setFocusPolicy(Qt::TabFocus);
    m_when->setMinimumWidth(m_when->fontMetrics().horizontalAdvance(QStringLiteral("00:00.0 / 00:00.0 ")));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_title);
    layout->addWidget(m_slider, 1);
    layout->addWidget(m_when);
    layout->addWidget(m_now);
    connect(&timeline, &WalkTimeline::changed, this, &TimelineBar::follow);
    connect(m_slider, &QSlider::valueChanged, this, &TimelineBar::moved);
    connect(m_now, &QToolButton::clicked, this, &TimelineBar::goToNow);
    retranslate();
    follow();
}

void TimelineBar::follow() {
    const auto& moments = m_timeline.moments();
    if (moments.empty()) m_back = false;
    {
        const QSignalBlocker quiet(m_slider);
        const int last = std::max(0, static_cast<int>(moments.size()) - 1);
        m_slider->setRange(0, last);
        int value = last;
        if (m_back) {
            const auto found =
                std::lower_bound(moments.begin(), moments.end(), m_backTime - 1e-9,
                                 [](const Moment& one, double time) { return one.time < time; });
            value = static_cast<int>(std::distance(moments.begin(), found));
        }
        m_slider->setValue(std::min(value, last));
        m_slider->setEnabled(moments.size() > 1);
    }
    retranslate();
    m_slider->update();
}

void TimelineBar::moved(int value) {
    const auto& moments = m_timeline.moments();
    if (moments.empty()) return;
    if (value >= static_cast<int>(moments.size()) - 1) return goToNow();
    m_back = true;
    m_backTime = moments[static_cast<std::size_t>(value)].time;
    retranslate();
    Q_EMIT wanted(m_timeline.snapshotAt(static_cast<std::size_t>(value)));
}

void TimelineBar::goToNow() {
    m_back = false;
    follow();
    Q_EMIT wanted(nullptr);
}

void TimelineBar::retranslate() {
    m_title->setText(tr("T&imeline:"));
    m_slider->setAccessibleName(tr("Timeline"));
    m_slider->setToolTip(tr("How sure the place was, and marks where something was said. Drag it, or use the "
                            "arrow keys, to look back; End goes back to now."));
    m_now->setText(tr("Now"));
    m_now->setAccessibleName(tr("Back to now"));
    m_now->setToolTip(tr("Show the walk as it is now"));
    m_now->setEnabled(m_back);
    const auto& moments = m_timeline.moments();
    const QString end = moments.empty() ? QString() : clockText(moments.back().time);
    m_when->setText(m_back ? tr("%1 of %2").arg(clockText(m_backTime), end) : end);
    const QString said = m_back ? tr("Looking back at %1").arg(clockText(m_backTime)) : tr("Now");
    if (m_slider->accessibleDescription() != said) m_slider->setAccessibleDescription(said);
}

void TimelineBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

} // namespace farol::ui
