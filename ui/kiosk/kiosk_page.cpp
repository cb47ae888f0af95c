#include "ui/kiosk/kiosk_page.h"

#include <QAccessible>
#include <QCloseEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace farol::ui {

namespace {

constexpr int kPoints = 40;
constexpr int kWordPoints = 54;
constexpr int kLongWords = 160;   // letters; longer texts are set smaller
constexpr quint64 kFingerMs = 20; // no finger lets a key go and is down again in less
constexpr int kReadMs = 70;       // a letter, as the voice takes
const QString kYellow = QStringLiteral("#ffe000");
const QString kWhite = QStringLiteral("#ffffff");

/// Lines break between the keys, not between a key and what it does.
QString keptTogether(const QString& hint) {
    const QString gap = QStringLiteral("   ");
    QStringList entries = hint.split(gap);
    for (QString& entry : entries) entry.replace(QLatin1Char(' '), QChar::Nbsp);
    return entries.join(gap);
}

} // namespace

/// Shows whole lines only: a line that is cut through can't be read.
class LinesArea : public QScrollArea {
public:
    using QScrollArea::QScrollArea;

    /// How high a line is, in pixels.
    void setLine(int height) {
        m_line = std::max(1, height);
        fit();
    }
    int line() const { return m_line; }

protected:
    void resizeEvent(QResizeEvent* event) override {
        QScrollArea::resizeEvent(event);
        fit();
    }

private:
    void fit() { setViewportMargins(0, 0, 0, contentsRect().height() % m_line); }

    int m_line = 1;
};

KioskPage::KioskPage(Kiosk& kiosk, QWidget* parent) : QWidget(parent), m_kiosk(kiosk) {
    setObjectName(QStringLiteral("kiosk"));
    setAttribute(Qt::WA_StyledBackground);
    setStyleSheet(QStringLiteral("#kiosk, #area, #area > QWidget > QWidget { background: #000000; }"));
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::BlankCursor);
    m_title = addLabel(kYellow, kPoints, QStringLiteral("title"));
    m_words = addLabel(kWhite, kWordPoints, QStringLiteral("words"));
    m_detail = addLabel(kWhite, kPoints, QStringLiteral("detail"));
    m_hint = addLabel(kYellow, kPoints, QStringLiteral("hint"));
    m_words->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_area = new LinesArea(this);
    m_area->setObjectName(QStringLiteral("area"));
    m_area->setWidget(m_words);
    m_area->setWidgetResizable(true);
    m_area->setFrameShape(QFrame::NoFrame);
    m_area->setFocusPolicy(Qt::NoFocus);
    m_area->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll = new QVariantAnimation(this);
    m_scroll->setStartValue(0.0);
    m_scroll->setEndValue(1.0);
    // Of what is hidden now: lines above and below come and go meanwhile.
    connect(m_scroll, &QVariantAnimation::valueChanged, m_area, [area = m_area](const QVariant& share) {
        QScrollBar& bar = *area->verticalScrollBar();
        const int lines = (bar.maximum() + area->line() - 1) / area->line();
        bar.setValue(static_cast<int>(share.toDouble() * lines) * area->line());
    });
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(40, 24, 40, 24);
    layout->setSpacing(16);
    layout->addWidget(m_title);
    layout->addWidget(m_area, 1);
    layout->addWidget(m_detail);
    layout->addWidget(m_hint);
    m_hold.setSingleShot(true);
    m_hold.setTimerType(Qt::PreciseTimer);
    connect(&m_hold, &QTimer::timeout, &kiosk, &Kiosk::holdBack);
    connect(&kiosk, &Kiosk::spoken, this, &KioskPage::showWords);
    connect(&kiosk, &Kiosk::changed, this, &KioskPage::refresh);
    connect(&kiosk, &Kiosk::finished, this, &QWidget::close);
    refresh();
}

QLabel* KioskPage::addLabel(const QString& colour, int points, const QString& name) {
    auto* label = new QLabel(this);
    label->setObjectName(name);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setStyleSheet(QStringLiteral("color: %1; background: #000000; font-size: %2pt; font-weight: %3;")
                             .arg(colour, QString::number(points), QStringLiteral("600")));
    return label;
}

void KioskPage::showWords(const QString& text) {
    const int points = text.size() > kLongWords ? kPoints : kWordPoints;
    m_words->setStyleSheet(
        QStringLiteral("color: %1; background: #000000; font-size: %2pt; font-weight: 600;")
            .arg(kWhite, QString::number(points)));
    m_words->setText(text);
    m_words->setAccessibleName(text);
    QAccessibleEvent changed(m_words, QAccessible::NameChanged);
    QAccessible::updateAccessibility(&changed);
    // What does not fit moves up, line by line, as it is read.
    m_scroll->stop();
    m_area->verticalScrollBar()->setValue(0);
    m_words->ensurePolished();
    m_area->setLine(m_words->fontMetrics().lineSpacing());
    m_scroll->setDuration(static_cast<int>(text.size()) * kReadMs);
    m_scroll->start();
}

void KioskPage::refresh() {
    setWindowTitle(tr("Farol"));
    setAccessibleName(tr("Farol, guidance"));
    const auto set = [](QLabel* label, const QString& text) {
        label->setText(text);
        label->setAccessibleName(text);
        label->setVisible(!text.isEmpty());
    };
    set(m_title, m_kiosk.machine().title());
    set(m_hint, keptTogether(m_kiosk.machine().hint()));
    set(m_detail, m_kiosk.detail());
}

/// A key that is held down comes as a row of releases and presses. Where both do not arrive together, Qt
/// takes them for those of a finger: a question would be answered by the key that asked it.
bool KioskPage::isRepetition(const QKeyEvent& event) const {
    if (event.isAutoRepeat()) return true;
    return event.key() == m_releasedKey && event.timestamp() != 0 &&
           event.timestamp() - m_releasedAt < kFingerMs;
}

void KioskPage::keyPressEvent(QKeyEvent* event) {
    event->accept();
    const KioskKey key{event->key(), event->text(), event->modifiers().testFlag(Qt::KeypadModifier)};
    const KioskCommand command = commandOf(key);
    const bool repetition = isRepetition(*event);
    if (command != KioskCommand::Back)
        m_hold.stop();
    else if (!repetition)
        m_hold.start(m_holdMs);
    else if (!m_hold.isActive() && m_holdLeftMs >= 0)
        m_hold.start(m_holdLeftMs);
    m_holdLeftMs = -1;
    if (repetition && !repeats(command)) return;
    m_kiosk.press(key);
}

void KioskPage::keyReleaseEvent(QKeyEvent* event) {
    event->accept();
    if (event->isAutoRepeat()) return;
    m_releasedKey = event->key();
    m_releasedAt = event->timestamp();
    m_holdLeftMs = m_hold.remainingTime();
    m_hold.stop();
}

/// Tab is a key like all others here: it has nowhere to go.
bool KioskPage::focusNextPrevChild(bool /*next*/) {
    return false;
}

void KioskPage::closeEvent(QCloseEvent* event) {
    m_hold.stop();
    m_kiosk.close();
    QWidget::closeEvent(event);
}

} // namespace farol::ui
