#include "ui/training/teach_views.h"

#include "ui/convert/convert.h"
#include "ui/parts/naming.h"
#include "ui/parts/tables.h"
#include "ui/training/outline_view.h"
#include "ui/training/teach_session.h"
#include "ui/training/training_words.h"

#include <QDir>
#include <QEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

namespace farol::ui {

namespace {

/// An outline to begin with: the middle of the picture.
Quad middleOf(const QImage& image) {
    return quadOf({image.width() * 0.25, image.height() * 0.25, image.width() * 0.5, image.height() * 0.5});
}

QIcon thumbnail(const std::string& jpeg) {
    const QImage image =
        QImage::fromData(QByteArray::fromRawData(jpeg.data(), static_cast<qsizetype>(jpeg.size())));
    if (image.isNull()) return {};
    return QPixmap::fromImage(image.scaled(96, 72, Qt::KeepAspectRatio, Qt::SmoothTransformation));
}

} // namespace

TeachViews::TeachViews(TeachSession& session, PictureReel& reel, QWidget* parent)
    : QWidget(parent), m_session(session), m_reel(reel) {
    build();
    connectAll();
    retranslate();
}

void TeachViews::build() {
    auto* halves = new QSplitter(Qt::Horizontal, this);
    halves->setChildrenCollapsible(false);
    halves->setHandleWidth(8);
    halves->addWidget(buildPictures());
    halves->addWidget(buildCoach());
    halves->setStretchFactor(0, 3);
    halves->setStretchFactor(1, 2);
    halves->setSizes({760, 440});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(halves);
}

QWidget* TeachViews::buildPictures() {
    auto* box = new QWidget(this);
    const auto button = [box] { return new QPushButton(box); };
    m_camera = button();
    m_files = button();
    m_recording = button();
    m_previous = button();
    m_next = button();
    m_hold = button();
    m_hold->setCheckable(true);
    m_find = button();
    m_whole = button();
    m_add = button();
    m_add->setDefault(false);
    m_position = new ElidedLabel(box);
    m_outline = new OutlineView(box);
    auto* sources = new QHBoxLayout;
    for (QPushButton* one : {m_camera, m_files, m_recording}) sources->addWidget(one);
    sources->addStretch(1);
    sources->addWidget(m_hold);
    sources->addWidget(m_previous);
    sources->addWidget(m_next);
    auto* below = new QHBoxLayout;
    below->addWidget(m_find);
    below->addWidget(m_whole);
    below->addWidget(m_position, 1);
    below->addWidget(m_add);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(sources);
    layout->addWidget(m_outline, 1);
    layout->addLayout(below);
    return box;
}

QWidget* TeachViews::buildCoach() {
    auto* box = new QWidget(this);
    m_coachTitle = panelTitle(box);
    m_coach = new QLabel(box);
    m_coach->setWordWrap(true);
    m_coach->setTextFormat(Qt::PlainText);
    m_coach->setFrameShape(QFrame::StyledPanel);
    m_coach->setMargin(10);
    m_coach->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_coach->setMinimumHeight(84);
    QFont large = m_coach->font();
    large.setPointSizeF(large.pointSizeF() * 1.15);
    m_coach->setFont(large);
    m_viewsTitle = panelTitle(box);
    m_views = new QListWidget(box);
    m_views->setViewMode(QListView::IconMode);
    m_views->setIconSize({96, 72});
    m_views->setResizeMode(QListView::Adjust);
    m_views->setMovement(QListView::Static);
    m_views->setSpacing(6);
    m_views->setMinimumHeight(120);
    m_viewsTitle->setBuddy(m_views);
    m_remove = new QPushButton(box);
    m_healthTitle = panelTitle(box);
    m_health = new QLabel(box);
    m_health->setWordWrap(true);
    m_health->setTextFormat(Qt::PlainText);
    m_health->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_coachTitle);
    layout->addWidget(m_coach);
    layout->addWidget(m_viewsTitle);
    layout->addWidget(m_views, 1);
    layout->addWidget(m_remove, 0, Qt::AlignLeft);
    layout->addWidget(m_healthTitle);
    layout->addWidget(m_health);
    return box;
}

void TeachViews::connectAll() {
    connect(m_camera, &QPushButton::clicked, &m_reel,
            [this] { m_reel.openSource(QStringLiteral("camera:0")); });
    connect(m_files, &QPushButton::clicked, this, &TeachViews::chooseFiles);
    connect(m_recording, &QPushButton::clicked, this, &TeachViews::chooseRecording);
    connect(m_next, &QPushButton::clicked, &m_reel, &PictureReel::next);
    connect(m_previous, &QPushButton::clicked, &m_reel, &PictureReel::previous);
    connect(m_hold, &QPushButton::toggled, &m_reel, &PictureReel::hold);
    connect(m_find, &QPushButton::clicked, this, [this] {
        if (!m_reel.current()) return;
        m_asked = true;
        m_session.lookForOutline(m_reel.current()->image);
    });
    connect(m_whole, &QPushButton::clicked, this, [this] {
        if (!m_reel.current()) return;
        const QSize size = m_reel.current()->shown.size();
        m_outline->setOutline(quadOf({0.0, 0.0, 1.0 * size.width(), 1.0 * size.height()}));
        judge();
    });
    connect(m_add, &QPushButton::clicked, this, &TeachViews::addView);
    connect(m_remove, &QPushButton::clicked, this, [this] {
        const int row = m_views->currentRow();
        if (row >= 0) m_session.removeView(static_cast<std::size_t>(row));
    });
    connect(m_views, &QListWidget::currentRowChanged, this, &TeachViews::refresh);
    connect(&m_reel, &PictureReel::pictureChanged, this, &TeachViews::showPicture);
    connect(&m_reel, &PictureReel::stateChanged, this, &TeachViews::refresh);
    connect(&m_reel, &PictureReel::failed, this, [this](const QString& message) {
        m_told = message;
        refreshCoach();
    });
    connect(m_outline, &OutlineView::outlineChanged, this, &TeachViews::judge);
    connect(&m_session, &TeachSession::changed, this, [this] {
        fillViews();
        refresh();
    });
    connect(&m_session, &TeachSession::judged, this, [this](const recognition::PictureQuality& quality) {
        m_quality = quality;
        m_judged = m_reel.current() != nullptr;
        m_outline->setKeypoints(quality.keypoints);
        refreshCoach();
    });
    connect(&m_session, &TeachSession::outlineFound, this, [this](const std::optional<Quad>& outline) {
        if (outline) m_outline->setOutline(outline);
        judge();
        m_told = outline || !m_asked ? QString() : tr("No outline was found. Set the four corners yourself.");
        m_asked = false;
        refreshCoach();
    });
    connect(&m_session, &TeachSession::viewAdded, this, [this] {
        m_told.clear();
        if (m_reel.live())
            m_hold->setChecked(false);
        else
            m_reel.next();
    });
    connect(&m_session, &TeachSession::refused, this, [this](const QString& message) {
        m_told = message;
        refreshCoach();
    });
}

void TeachViews::chooseFiles() {
    const QStringList files = QFileDialog::getOpenFileNames(
        this, tr("Photographs"), QString(),
        tr("Pictures (%1);;All files (%2)")
            .arg(QStringLiteral("*.jpg *.jpeg *.png *.bmp *.webp *.tif *.tiff *.JPG *.JPEG *.PNG"),
                 QStringLiteral("*")));
    if (!files.isEmpty()) m_reel.openFiles(files);
}

void TeachViews::chooseRecording() {
    const QString folder =
        QFileDialog::getExistingDirectory(this, tr("Folder of a recorded walk, or of pictures"), QString());
    if (!folder.isEmpty()) m_reel.openSource(folder);
}

void TeachViews::show() {
    m_told.clear();
    fillViews();
    showPicture();
    refresh();
}

void TeachViews::setShown(bool shown) {
    m_shown = shown;
    if (shown) judge();
}

void TeachViews::showPicture() {
    const PictureReel::Picture& picture = m_reel.current();
    const bool still = !m_reel.live() || m_reel.held();
    m_outline->setPicture(picture ? picture->shown : QImage());
    if (picture && !m_outline->outline()) m_outline->setOutline(middleOf(picture->shown));
    if (still) m_told.clear();
    // What was taught already is looked for in every new picture: most often nothing is left to be dragged.
    if (picture && !m_reel.live() && m_shown && m_session.trained() && !m_session.training() &&
        m_session.draft().kind != Kind::Place)
        m_session.lookForOutline(picture->image);
    if (!picture) {
        m_judged = false;
        m_outline->setKeypoints({});
    }
    judge();
    refresh();
}

void TeachViews::judge() {
    if (!m_shown || !m_reel.current()) return;
    const bool place = m_session.draft().kind == Kind::Place;
    m_session.judge(m_reel.current()->image, place ? std::nullopt : m_outline->outline());
}

void TeachViews::addView() {
    const PictureReel::Picture picture = m_reel.current();
    if (!picture || m_session.training()) return;
    const bool place = m_session.draft().kind == Kind::Place;
    const QSizeF size = picture->shown.size();
    const Quad whole = quadOf({0.0, 0.0, size.width(), size.height()});
    m_told.clear();
    m_session.addView(picture->file(), place ? whole : m_outline->outline().value_or(whole));
}

QString TeachViews::coachText() const {
    return m_coach->text();
}

QString TeachViews::healthText() const {
    return m_health->text();
}

void TeachViews::refreshCoach() {
    QStringList lines;
    if (!m_told.isEmpty()) lines << m_told;
    if (m_session.training())
        lines << tr("Learning this view…");
    else if (m_reel.current() && m_judged && !m_quality.problems.empty())
        for (const recognition::Advice advice : m_quality.problems) lines << TrainingWords::advice(advice);
    else if (m_reel.current() && m_judged)
        lines << tr("This picture is good: %n point(s).", nullptr,
                    static_cast<int>(m_quality.keypoints.size()));
    lines << TrainingWords::advice(m_session.next());
    const QString text = lines.join(QLatin1Char('\n'));
    if (text == m_coach->text()) return;
    m_coach->setText(text);
    m_coach->setAccessibleName(tr("Coach: %1").arg(text));
}

void TeachViews::fillViews() {
    const auto& views = m_session.draft().views;
    const int chosen = m_views->currentRow();
    if (m_views->count() != static_cast<int>(views.size())) {
        m_views->clear();
        for (std::size_t i = 0; i < views.size(); ++i)
            m_views->addItem(
                new QListWidgetItem(thumbnail(views[i].bytes), tr("View %1").arg(static_cast<int>(i + 1))));
        m_views->setCurrentRow(std::min(chosen, m_views->count() - 1));
    }
}

void TeachViews::refresh() {
    const bool picture = m_reel.current() != nullptr;
    const bool place = m_session.draft().kind == Kind::Place;
    const bool live = m_reel.live();
    m_outline->setEditable(!place);
    m_hold->setVisible(live);
    m_previous->setVisible(!live);
    m_next->setVisible(!live);
    m_previous->setEnabled(m_reel.hasPrevious());
    m_next->setEnabled(m_reel.hasNext());
    m_find->setEnabled(picture && !place);
    m_whole->setEnabled(picture && !place);
    m_add->setEnabled(picture && !m_session.training());
    m_remove->setEnabled(m_views->currentRow() >= 0 && !m_session.training());
    QString where = picture ? m_reel.current()->name : QString();
    if (m_reel.count() > 1)
        where = tr("%1 (%2 of %3)").arg(where).arg(m_reel.index() + 1).arg(m_reel.count());
    m_position->setText(where);
    m_position->setToolTip(where);
    QString health;
    if (m_session.checking())
        health = tr("Looking how well it is found…");
    else if (m_session.health())
        health = TrainingWords::health(*m_session.health(), m_session.draft().kind).join(QLatin1Char('\n'));
    else
        health = tr("Nothing yet: add a view.");
    if (m_session.oldViews() > 0)
        health.prepend(
            tr("With the %n view(s) it had before.", nullptr, static_cast<int>(m_session.oldViews())) +
            QLatin1Char('\n'));
    m_health->setText(health);
    refreshCoach();
}

void TeachViews::retranslate() {
    const auto& name = nameButton;
    name(m_camera, tr("&Camera"), tr("Camera"), tr("Take photographs with the camera of this computer"));
    name(m_files, tr("&Pictures…"), tr("Pictures"), tr("Choose photographs from files"));
    name(m_recording, tr("&Recording…"), tr("Recording"),
         tr("Choose the folder of a recorded walk, or any folder of pictures"));
    name(m_hold, tr("&Hold"), tr("Hold the picture"), tr("Keep the picture that the camera shows now"));
    name(m_previous, tr("Pre&vious picture"), tr("Previous picture"), tr("The picture before"));
    name(m_next, tr("Ne&xt picture"), tr("Next picture"), tr("The picture after"));
    name(m_find, tr("&Find outline"), tr("Find the outline"), tr("Look for the outline in this picture"));
    name(m_whole, tr("Whole p&icture"), tr("Outline the whole picture"),
         tr("Set the corners to those of the picture"));
    name(m_add, tr("&Add this view"), tr("Add this view"), tr("Learn the landmark from this picture"));
    name(m_remove, tr("Re&move view"), tr("Remove the chosen view"), tr("Forget the chosen view"));
    m_coachTitle->setText(tr("Coach"));
    m_viewsTitle->setText(tr("Views so far"));
    m_healthTitle->setText(tr("How well it will be found"));
    m_views->setAccessibleName(tr("Views so far"));
    m_views->setToolTip(tr("The photographs it is learnt from"));
    m_outline->setAccessibleName(tr("Picture with outline"));
    m_outline->setToolTip(tr("Drag the four corners onto the landmark. By keys: 1 to 4 choose a corner, the "
                             "arrows move it, with Shift by one pixel."));
    m_outline->setHint(tr("No picture yet.\nSwitch on the camera, or choose pictures or a recording."));
    m_views->clear();
    fillViews();
    refresh();
}

void TeachViews::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

} // namespace farol::ui
