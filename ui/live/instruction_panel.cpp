#include "ui/live/instruction_panel.h"

#include "ui/convert/convert.h"
#include "ui/convert/kind_style.h"
#include "ui/models/words.h"
#include "ui/parts/tables.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>

#include <cmath>

namespace farol::ui {

namespace {

bool isInstruction(const guidance::Cue& cue) {
    return cue.kind != guidance::CueKind::Detection && cue.kind != guidance::CueKind::Text;
}

} // namespace

InstructionPanel::InstructionPanel(QWidget* parent)
    : QFrame(parent),
      m_sentence(new QLabel(this)),
      m_way(new ElidedLabel(this)),
      m_voice(new ElidedLabel(this)) {
    setFrameShape(QFrame::StyledPanel);
    QFont large = m_sentence->font();
    large.setPointSizeF(large.pointSizeF() * 1.9);
    large.setBold(true);
    m_sentence->setFont(large);
    m_sentence->setWordWrap(true);
    m_sentence->setMinimumHeight(m_sentence->fontMetrics().height() + 4);
    m_sentence->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::MinimumExpanding);
    m_sentence->setTextFormat(Qt::PlainText);
    m_sentence->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_voice->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(12, 6, 12, 6);
    layout->setVerticalSpacing(2);
    layout->addWidget(m_sentence, 0, 0, 1, 2);
    layout->addWidget(m_way, 1, 0);
    layout->addWidget(m_voice, 1, 1);
    layout->setColumnStretch(0, 3);
    layout->setColumnStretch(1, 2);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    retranslate();
}

void InstructionPanel::setBuilding(std::shared_ptr<const building::Building> building) {
    m_building = std::move(building);
    m_snapshot.reset();
    m_said.clear();
    m_saidCue.reset();
    retranslate();
}

void InstructionPanel::show(const std::shared_ptr<const session::Snapshot>& snapshot) {
    if (!snapshot) setNotice({});
    m_snapshot = snapshot;
    retranslate();
}

void InstructionPanel::note(const Utterance& utterance) {
    if (!isInstruction(utterance.cue) || utterance.text.isEmpty()) return;
    const bool current =
        utterance.state == UtteranceState::Speaking || utterance.state == UtteranceState::Shown;
    if (!current) return;
    m_said = utterance.text;
    m_saidCue = utterance.cue;
    retranslate();
}

void InstructionPanel::setNotice(const QString& text) {
    m_said = text;
    m_saidCue.reset();
    retranslate();
}

void InstructionPanel::setVoice(const QString& status, bool trouble) {
    m_voiceStatus = status;
    m_voiceTrouble = trouble;
    retranslate();
}

QString InstructionPanel::sentence() const {
    return m_sentence->text();
}
QString InstructionPanel::way() const {
    return m_way->text();
}
QString InstructionPanel::voiceText() const {
    return m_voice->text();
}

bool InstructionPanel::outdated() const {
    return m_saidCue && m_snapshot && m_snapshot->step.percept.time > m_saidCue->validUntil;
}

QString InstructionPanel::progressText() const {
    const guidance::Progress& progress = m_snapshot->step.progress;
    switch (progress.travel) {
    case guidance::Travel::NoDestination:
        return tr("No destination chosen: places are told, no route.");
    case guidance::Travel::NoFix:
        return tr("The route follows as soon as it is known where you are.");
    case guidance::Travel::Unreachable:
        return tr("There is no way to the destination. %1").arg(toQString(progress.reason));
    case guidance::Travel::Arrived:
        return tr("At the destination.");
    case guidance::Travel::OffRoute:
    case guidance::Travel::OnRoute:
        break;
    }
    QStringList parts;
    if (progress.route && !progress.route->regions.empty()) {
        const QString goal = regionName(m_building.get(), progress.route->regions.back());
        const std::size_t left = progress.route->regions.size() - 1 -
                                 std::min(progress.regionsPassed, progress.route->regions.size() - 1);
        parts << tr("On the way to %1").arg(goal);
        parts << tr("%n more place(s) to pass", nullptr, static_cast<int>(left));
    }
    if (progress.distanceM) parts << tr("next in %1 m").arg(std::lround(*progress.distanceM));
    if (progress.remainingM) parts << tr("%1 m to go").arg(std::lround(*progress.remainingM));
    if (progress.travel == guidance::Travel::OffRoute) parts.prepend(tr("Off the route"));
    return parts.join(QStringLiteral(" · "));
}

void InstructionPanel::retranslate() {
    setAccessibleName(tr("Next instruction"));
    // A sentence of a while ago must not look like an order of now.
    const bool old = outdated();
    QFont font = m_sentence->font();
    if (font.bold() == old) {
        font.setBold(!old);
        m_sentence->setFont(font);
    }
    QStringList way;
    if (old) way << tr("Said at %1").arg(clockText(m_saidCue->time));
    if (m_snapshot) way << progressText();
    m_way->setText(way.join(QStringLiteral(" · ")));
    if (!m_said.isEmpty())
        m_sentence->setText(m_said);
    else if (!m_building)
        m_sentence->setText(tr("Open a map to begin."));
    else if (!m_snapshot)
        m_sentence->setText(tr("Ready. Press Play to start the walk."));
    else
        m_sentence->setText(tr("Looking around…"));
    m_sentence->setAccessibleName(tr("Next instruction: %1").arg(m_sentence->text()));
    m_sentence->setToolTip(m_sentence->text());
    m_way->setToolTip(m_way->text());
    m_voice->setText(m_voiceTrouble ? tr("No sound: %1").arg(m_voiceStatus) : m_voiceStatus);
    m_voice->setToolTip(m_voice->text());
    QPalette colours = palette();
    if (m_voiceTrouble)
        colours.setColor(QPalette::WindowText, isDark(palette()) ? QColor(0xff9a9a) : QColor(0xa3142b));
    m_voice->setPalette(colours);
}

void InstructionPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange) retranslate();
    QFrame::changeEvent(event);
}

} // namespace farol::ui
