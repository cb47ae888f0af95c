#include "ui/training/teach_try.h"

#include "ui/convert/convert.h"
#include "ui/models/words.h"
#include "ui/parts/frame_view.h"
#include "ui/parts/naming.h"
#include "ui/parts/tables.h"
#include "ui/training/teach_session.h"
#include "ui/training/training_words.h"

#include <QEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include <cmath>

namespace farol::ui {

TeachTry::TeachTry(TeachSession& session, PictureReel& reel, QWidget* parent)
    : QWidget(parent), m_session(session), m_reel(reel) {
    build();
    connect(m_camera, &QPushButton::clicked, &m_reel,
            [this] { m_reel.openSource(QStringLiteral("camera:0")); });
    connect(m_recording, &QPushButton::clicked, this, [this] {
        const QString folder = QFileDialog::getExistingDirectory(
            this, tr("Folder of a recorded walk, or of pictures"), QString());
        if (!folder.isEmpty()) m_reel.openSource(folder);
    });
    connect(m_previous, &QPushButton::clicked, &m_reel, &PictureReel::previous);
    connect(m_next, &QPushButton::clicked, &m_reel, &PictureReel::next);
    connect(&m_reel, &PictureReel::pictureChanged, this, &TeachTry::tryPicture);
    connect(&m_reel, &PictureReel::stateChanged, this, &TeachTry::refresh);
    connect(&m_session, &TeachSession::tried, this, &TeachTry::showResult);
    connect(&m_session, &TeachSession::changed, this, &TeachTry::refresh);
    retranslate();
}

void TeachTry::build() {
    m_intro = new QLabel(this);
    m_intro->setWordWrap(true);
    m_frame = new FrameView(this);
    m_frame->setShowGrid(false);
    m_frame->setShowRejected(true);
    m_camera = new QPushButton(this);
    m_recording = new QPushButton(this);
    m_previous = new QPushButton(this);
    m_next = new QPushButton(this);
    m_verdict = new QLabel(this);
    m_verdict->setWordWrap(true);
    m_verdict->setTextFormat(Qt::PlainText);
    m_verdict->setFrameShape(QFrame::StyledPanel);
    m_verdict->setMargin(10);
    m_verdict->setMinimumHeight(90);
    m_verdict->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    QFont large = m_verdict->font();
    large.setPointSizeF(large.pointSizeF() * 1.3);
    m_verdict->setFont(large);
    m_tallies = new QLabel(this);
    m_healthTitle = panelTitle(this);
    m_health = new QLabel(this);
    m_health->setWordWrap(true);
    m_health->setTextFormat(Qt::PlainText);
    auto* sources = new QHBoxLayout;
    sources->addWidget(m_camera);
    sources->addWidget(m_recording);
    sources->addStretch(1);
    sources->addWidget(m_previous);
    sources->addWidget(m_next);
    auto* left = new QVBoxLayout;
    left->addLayout(sources);
    left->addWidget(m_frame, 1);
    auto* right = new QVBoxLayout;
    right->addWidget(m_intro);
    right->addWidget(m_verdict);
    right->addWidget(m_tallies);
    right->addSpacing(12);
    right->addWidget(m_healthTitle);
    right->addWidget(m_health);
    right->addStretch(1);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(left, 3);
    layout->addSpacing(8);
    layout->addLayout(right, 2);
}

void TeachTry::setShown(bool shown) {
    if (shown && !m_shown) m_looks = m_hits = 0;
    m_shown = shown;
    if (shown) tryPicture();
    refresh();
}

void TeachTry::tryPicture() {
    if (!m_shown) return;
    const PictureReel::Picture& picture = m_reel.current();
    if (!picture) m_frame->setFrame({});
    m_frame->setFindings({}, {});
    if (picture) {
        m_frame->setFrame(picture->shown);
        m_session.tryOn(picture->image);
    }
}

QString TeachTry::sentence(const recognition::DetectorResult& result) const {
    const TemplateId& own = m_session.trained()->id;
    QStringList others;
    QString found;
    for (const recognition::Detection& detection : result.detections) {
        if (detection.templateId != own) {
            others << toQString(detection.templateId.value);
            continue;
        }
        found = tr("Found, %1 % sure.").arg(std::lround(detection.score * 100.0));
        if (detection.rangeM)
            found +=
                QLatin1Char(' ') + tr("About %1 m away.").arg(QLocale().toString(*detection.rangeM, 'f', 1));
    }
    if (found.isEmpty()) {
        found = tr("Not found.");
        for (const recognition::Rejection& rejection : result.rejections)
            if (rejection.templateId == own) found = tr("Not found: %1.").arg(Words::rejection(rejection));
    }
    if (!others.isEmpty())
        found += QLatin1Char('\n') + tr("Also seen: %1.").arg(others.join(QStringLiteral(", ")));
    return found;
}

void TeachTry::showResult(const recognition::DetectorResult& result) {
    if (!m_shown || !m_reel.current() || !m_session.trained()) return;
    ++m_looks;
    for (const recognition::Detection& detection : result.detections)
        if (detection.templateId == m_session.trained()->id) {
            ++m_hits;
            break;
        }
    std::vector<recognition::Rejection> own;
    for (const recognition::Rejection& rejection : result.rejections)
        if (rejection.templateId == m_session.trained()->id) own.push_back(rejection);
    m_frame->setFindings(result.detections, std::move(own));
    m_verdict->setText(sentence(result));
    m_verdict->setAccessibleName(m_verdict->text());
    m_tallies->setText(tr("Found in %1 of %2 pictures looked at.").arg(m_hits).arg(m_looks));
}

QString TeachTry::verdict() const {
    return m_verdict->text();
}

void TeachTry::refresh() {
    m_previous->setEnabled(m_reel.hasPrevious());
    m_next->setEnabled(m_reel.hasNext());
    m_previous->setVisible(!m_reel.live());
    m_next->setVisible(!m_reel.live());
    if (m_looks == 0) {
        m_verdict->setText(m_reel.current() ? tr("Looking…") : tr("No picture yet."));
        m_tallies->clear();
    }
    m_health->setText(
        m_session.checking() ? tr("Looking how well it is found…")
        : m_session.health()
            ? TrainingWords::health(*m_session.health(), m_session.draft().kind).join(QLatin1Char('\n'))
            : QString());
}

void TeachTry::retranslate() {
    const auto& name = nameButton;
    m_intro->setText(
        tr("Walk towards it, past it and away from it, or step through other pictures, and see whether "
           "Farol finds it. Go back to add views where it is lost."));
    name(m_camera, tr("&Camera"), tr("Camera"), tr("Look for it with the camera of this computer"));
    name(m_recording, tr("&Recording…"), tr("Recording"),
         tr("Look for it in a recorded walk, or in any folder of pictures"));
    name(m_previous, tr("Pre&vious picture"), tr("Previous picture"), tr("The picture before"));
    name(m_next, tr("Ne&xt picture"), tr("Next picture"), tr("The picture after"));
    m_frame->setAccessibleName(tr("Picture with what was recognised"));
    m_frame->setToolTip(tr("What was recognised in this picture, and what nearly was"));
    m_healthTitle->setText(tr("How well it will be found"));
    refresh();
}

void TeachTry::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

} // namespace farol::ui
