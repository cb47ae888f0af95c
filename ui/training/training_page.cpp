#include "ui/training/training_page.h"

#include "ui/convert/convert.h"
#include "ui/parts/banner.h"
#include "ui/training/library_panel.h"
#include "ui/training/outline_view.h"
#include "ui/training/teach_views.h"
#include "ui/training/teach_what.h"
#include "ui/training/training_actions.h"

#include <QAction>
#include <QDir>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QPushButton>
#include <QSaveFile>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTableView>
#include <QToolBar>
#include <QUndoStack>
#include <QUrl>
#include <QVBoxLayout>

namespace farol::ui {

namespace {

const QString kFailure = QStringLiteral("failure");
const QString kUnsaved = QStringLiteral("unsaved");
const QString kOutside = QStringLiteral("outside");
const QString kRefused = QStringLiteral("refused");
const QString kUnfinished = QStringLiteral("unfinished");

QString libraryFilter() {
    return QStringLiteral("*.gpkg");
}

} // namespace

TrainingPage::TrainingPage(Settings& settings, const QString& draftFolder, PictureReel::OpenSource open,
                           QWidget* parent)
    : QWidget(parent),
      m_settings(settings),
      m_session(draftFolder),
      m_actions(new TrainingActions(*this, m_document.undoStack())),
      m_banners(new BannerStack(this)),
      m_stack(new QStackedWidget(this)),
      m_panel(new LibraryPanel(m_stack)),
      m_wizard(new TeachPanel(m_session, std::move(open), m_stack)),
      m_state(new QLabel(this)) {
    build();
    connectDocument();
    connectActions();
    connectWizard();
    setAcceptDrops(true);
    m_panel->halves().restoreState(settings.splitter(QStringLiteral("library-halves")));
    retranslate();
    offerUnfinished();
}

TrainingPage::~TrainingPage() = default;

void TrainingPage::build() {
    m_stack->addWidget(m_panel);
    m_stack->addWidget(m_wizard);
    auto* content = new QVBoxLayout;
    content->setContentsMargins(8, 6, 8, 4);
    content->addWidget(m_stack, 1);
    content->addSpacing(2);
    content->addWidget(m_state);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(&m_actions->bar());
    layout->addWidget(m_banners);
    layout->addLayout(content, 1);
}

void TrainingPage::connectDocument() {
    connect(&m_document, &LibraryDocument::opened, this, [this] {
        m_banners->hide(kFailure);
        m_banners->hide(kUnsaved);
        m_banners->hide(kOutside);
        m_settings.addRecent(RecentKind::Library, m_document.path());
        m_panel->setLibrary(m_document.library());
        refresh();
        if (m_waiting) goOnTeaching(*std::exchange(m_waiting, std::nullopt));
        Q_EMIT documentChanged();
    });
    connect(&m_document, &LibraryDocument::edited, this, [this] {
        m_banners->hide(kRefused);
        m_panel->setLibrary(m_document.library());
        if (!m_saving.empty() && m_document.library()->find(m_saving) != nullptr) {
            m_panel->select(m_saving);
            m_saving = TemplateId();
            m_wizard->showSaved();
            m_session.end(false);
        }
        refresh();
    });
    connect(&m_document, &LibraryDocument::stateChanged, this, &TrainingPage::refresh);
    connect(&m_document.undoStack(), &QUndoStack::indexChanged, this, &TrainingPage::refresh);
    connect(&m_document, &LibraryDocument::saved, this, [this] {
        m_banners->hide(kUnsaved);
        Q_EMIT librarySaved(m_document.path());
    });
    connect(&m_document, &LibraryDocument::failed, this, [this](const QString& message) {
        m_waiting.reset();
        m_banners->show(kFailure, {BannerKind::Problem, message, tr("Open another &library…"),
                                   [this] { chooseLibrary(); }, true});
    });
    connect(&m_document, &LibraryDocument::unwritable, this, [this](const QString& message) {
        m_banners->show(kUnsaved, {BannerKind::Problem, tr("Not saved: %1").arg(message),
                                   tr("Save el&sewhere…"), [this] { saveAs(); }, false});
    });
    connect(&m_document, &LibraryDocument::overtaken, this, [this] {
        m_banners->hide(kOutside);
        m_banners->show(kUnsaved,
                        {BannerKind::Problem,
                         tr("Not saved: another program has changed the same landmarks in %1. Save yours "
                            "under another name; what the other program wrote stays.")
                             .arg(QFileInfo(m_document.path()).fileName()),
                         tr("Save el&sewhere…"), [this] { saveAs(); }, false});
    });
    connect(&m_document, &LibraryDocument::joined, this, [this] {
        m_banners->show(kOutside,
                        {BannerKind::Note,
                         tr("Another program has changed %1 meanwhile: its changes and yours are both saved. "
                            "Earlier steps can no longer be undone.")
                             .arg(QFileInfo(m_document.path()).fileName()),
                         {},
                         {},
                         true});
    });
    connect(&m_document, &LibraryDocument::changedOutside, this, [this] {
        m_banners->show(kOutside,
                        {BannerKind::Note,
                         tr("Another program has changed %1.").arg(QFileInfo(m_document.path()).fileName()),
                         tr("&Load it again"), [this] { m_document.open(m_document.path()); }, true});
    });
    connect(&m_document, &LibraryDocument::refused, this, [this](const QString& message) {
        m_saving = TemplateId();
        m_banners->show(kRefused, {BannerKind::Warning, message, {}, {}, true});
    });
}

void TrainingPage::connectActions() {
    const TrainingActions& a = *m_actions;
    connect(a.open, &QAction::triggered, this, &TrainingPage::chooseLibrary);
    connect(a.fresh, &QAction::triggered, this, &TrainingPage::createLibrary);
    connect(a.saveAs, &QAction::triggered, this, &TrainingPage::saveAs);
    connect(a.teach, &QAction::triggered, this, &TrainingPage::teach);
    connect(a.addViews, &QAction::triggered, this, &TrainingPage::addViews);
    connect(a.edit, &QAction::triggered, this, &TrainingPage::edit);
    connect(a.merge, &QAction::triggered, this, &TrainingPage::merge);
    connect(a.split, &QAction::triggered, this, &TrainingPage::split);
    connect(a.removeViews, &QAction::triggered, this, &TrainingPage::removeViews);
    connect(a.remove, &QAction::triggered, this, &TrainingPage::remove);
    const auto check = [this] {
        m_panel->showReport();
        m_panel->check();
    };
    connect(a.check, &QAction::triggered, this, check);
    connect(m_panel, &LibraryPanel::checkWanted, this, check);
    connect(a.place, &QAction::triggered, this, [this] {
        if (chosen() != nullptr) Q_EMIT placeWanted(*chosen());
    });
    connect(a.walkHere, &QAction::triggered, this, [this] { Q_EMIT walkWanted(m_document.path()); });
    connect(m_panel, &LibraryPanel::chosenChanged, this, &TrainingPage::refresh);
    connect(m_panel, &LibraryPanel::teachWanted, this, &TrainingPage::addViews);
    connect(m_panel, &LibraryPanel::csvWanted, this, &TrainingPage::saveCsv);
}

void TrainingPage::connectWizard() {
    connect(m_wizard, &TeachPanel::saveWanted, this, &TrainingPage::finishTeaching);
    connect(m_wizard, &TeachPanel::placeWanted, this, [this] {
        if (chosen() != nullptr) Q_EMIT placeWanted(*chosen());
    });
    connect(m_wizard, &TeachPanel::anotherWanted, this, [this] {
        showLibrary();
        teach();
    });
    connect(m_wizard, &TeachPanel::putAside, this, [this] {
        m_session.end(true);
        showLibrary();
    });
    connect(m_wizard, &TeachPanel::givenUp, this, [this] {
        m_session.end(false);
        showLibrary();
    });
    connect(&m_session, &TeachSession::unkept, this, [this](const QString& message) {
        m_banners->show(kUnfinished, {BannerKind::Problem, message, {}, {}, true});
    });
}

void TrainingPage::open(const QString& path) {
    if (teaching()) {
        m_session.end(true);
        showLibrary();
    }
    m_document.open(path);
}

void TrainingPage::chooseLibrary() {
    const QString file = QFileDialog::getOpenFileName(
        this, tr("Open a landmark library"), QFileInfo(m_document.path()).path(),
        tr("Landmark libraries (%1);;All files (%2)").arg(libraryFilter(), QStringLiteral("*")));
    if (!file.isEmpty()) open(file);
}

void TrainingPage::createLibrary() {
    QString file =
        QFileDialog::getSaveFileName(this, tr("New landmark library"), QFileInfo(m_document.path()).path(),
                                     tr("Landmark libraries (%1)").arg(libraryFilter()));
    if (file.isEmpty()) return;
    if (QFileInfo(file).suffix().isEmpty()) file += QStringLiteral(".gpkg");
    m_document.create(file);
}

void TrainingPage::saveAs() {
    QString file = QFileDialog::getSaveFileName(this, tr("Save the library as"), m_document.path(),
                                                tr("Landmark libraries (%1)").arg(libraryFilter()));
    if (file.isEmpty()) return;
    if (QFileInfo(file).suffix().isEmpty()) file += QStringLiteral(".gpkg");
    m_document.saveAs(file);
    m_settings.addRecent(RecentKind::Library, file);
}

bool TrainingPage::teaching() const {
    return m_stack->currentWidget() == m_wizard;
}

bool TrainingPage::settled() const {
    return m_document.settled() && m_session.settled() && !m_panel->checking();
}

void TrainingPage::teach() {
    if (!m_document.library() || teaching()) return;
    TeachDraft draft;
    draft.library = m_document.path();
    // One landmark at a time is kept: an older one must not be overwritten unasked.
    if (const auto old = m_session.unfinished(); old && old->worthKeeping()) return offerUnfinished();
    goOnTeaching(std::move(draft));
}

void TrainingPage::goOnTeaching(TeachDraft draft) {
    m_banners->hide(kUnfinished);
    m_session.begin(m_document.library(), std::move(draft));
    m_stack->setCurrentWidget(m_wizard);
    m_wizard->begin();
    refresh();
}

void TrainingPage::offerUnfinished() {
    const auto draft = m_session.unfinished();
    if (!draft || !draft->worthKeeping()) return;
    const QString text =
        tr("“%1” is unfinished, with %n view(s).", nullptr, static_cast<int>(draft->views.size()))
            .arg(draft->name.isEmpty() ? tr("A new landmark") : draft->name);
    m_banners->show(kUnfinished, {BannerKind::Note, text, tr("Go &on with it"),
                                  [this, draft = *draft] {
                                      if (m_document.library() && m_document.path() == draft.library)
                                          return goOnTeaching(draft);
                                      m_waiting = draft;
                                      m_document.open(draft.library);
                                  },
                                  true});
}

const recognition::Template* TrainingPage::chosen() const {
    const auto index = m_panel->chosen();
    return index && m_document.library() ? &m_document.library()->templates[*index] : nullptr;
}

void TrainingPage::addViews() {
    if (chosen() == nullptr || teaching()) return;
    if (const auto old = m_session.unfinished(); old && old->worthKeeping()) return offerUnfinished();
    TeachDraft draft;
    draft.library = m_document.path();
    draft.extends = true;
    draft.id = toQString(chosen()->id.value);
    draft.name = toQString(chosen()->name.empty() ? chosen()->id.value : chosen()->name);
    draft.kind = chosen()->kind;
    draft.widthM = chosen()->widthM.value_or(0.0);
    draft.heightM = chosen()->heightM.value_or(0.0);
    draft.step = TeachPanel::Views;
    goOnTeaching(std::move(draft));
}

void TrainingPage::finishTeaching() {
    m_saving = TemplateId(toUtf8(m_session.draft().id));
    const QString text = tr("Teach “%1”").arg(m_session.draft().name);
    if (!m_document.change(text, m_session.finished())) m_saving = TemplateId();
}

void TrainingPage::showLibrary() {
    m_stack->setCurrentWidget(m_panel);
    m_wizard->reel().close();
    m_panel->table().setFocus(Qt::OtherFocusReason);
    offerUnfinished();
    refresh();
}

void TrainingPage::saveCsv() {
    const QString name =
        QDir(QFileInfo(m_document.path()).path())
            .filePath(QFileInfo(m_document.path()).completeBaseName() + QStringLiteral(".csv"));
    const QString file = QFileDialog::getSaveFileName(this, tr("Save the report"), name,
                                                      tr("Table (%1)").arg(QStringLiteral("*.csv")));
    if (file.isEmpty()) return;
    QSaveFile out(file);
    const QByteArray bytes = m_panel->confusion().csv();
    if (out.open(QIODevice::WriteOnly) && out.write(bytes) == bytes.size() && out.flush() && out.commit())
        return;
    m_banners->show(kFailure,
                    {BannerKind::Problem,
                     tr("%1 cannot be written. Choose another folder.").arg(QDir::toNativeSeparators(file)),
                     {},
                     {},
                     true});
}

void TrainingPage::refresh() {
    const bool library = m_document.library() != nullptr;
    const bool desk = !teaching();
    const bool one = chosen() != nullptr && desk && !m_document.busy();
    const std::size_t views = m_panel->chosenViews().size();
    const bool some = one && views > 0 && views < chosen()->views.size();
    const TrainingActions& a = *m_actions;
    for (QAction* action : {a.open, a.fresh}) action->setEnabled(!m_document.busy());
    a.saveAs->setEnabled(library);
    a.undo->setEnabled(desk && !m_document.busy() && m_document.undoStack().canUndo());
    a.redo->setEnabled(desk && !m_document.busy() && m_document.undoStack().canRedo());
    a.teach->setEnabled(library && desk);
    for (QAction* action : {a.addViews, a.edit, a.remove, a.place}) action->setEnabled(one);
    a.merge->setEnabled(one && m_document.library()->templates.size() > 1);
    a.split->setEnabled(some);
    a.removeViews->setEnabled(some);
    a.check->setEnabled(library && desk && !m_document.library()->templates.empty());
    a.walkHere->setEnabled(library);
    QString text;
    if (m_document.busy())
        text = tr("Working…");
    else if (library)
        text = m_document.unsaved() ? tr("%1 · being saved").arg(QDir::toNativeSeparators(m_document.path()))
                                    : tr("%1 · saved").arg(QDir::toNativeSeparators(m_document.path()));
    m_state->setText(text);
}

void TrainingPage::saveLayout() {
    m_settings.setSplitter(QStringLiteral("library-halves"), m_panel->halves().saveState());
}

QWidget* TrainingPage::firstFocus() const {
    if (teaching()) return &m_wizard->what().name();
    return m_document.library() ? static_cast<QWidget*>(&m_panel->table()) : &m_actions->bar();
}

std::vector<QWidget*> TrainingPage::panes() const {
    if (teaching()) {
        if (m_wizard->step() == TeachPanel::Views)
            return {&m_wizard->views().outline(), &m_wizard->views().views()};
        return {&m_wizard->forward()};
    }
    return {&m_panel->table(), m_panel->tabs().currentIndex() == 0 ? static_cast<QWidget*>(&m_panel->views())
                                                                   : &m_panel->matrix()};
}

void TrainingPage::retranslate() {
    m_actions->retranslate();
    m_actions->refreshIcons();
    refresh();
}

void TrainingPage::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange) retranslate();
    QWidget::changeEvent(event);
}

void TrainingPage::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

/// Pictures become views, a library is opened.
void TrainingPage::dropEvent(QDropEvent* event) {
    QStringList files;
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile()) files << url.toLocalFile();
    if (files.isEmpty()) return;
    event->acceptProposedAction();
    if (files.first().endsWith(QLatin1String(".gpkg"), Qt::CaseInsensitive)) return open(files.first());
    if (!teaching()) teach();
    if (!teaching()) return;
    if (files.size() == 1 && QFileInfo(files.first()).isDir())
        m_wizard->reel().openSource(files.first());
    else
        m_wizard->reel().openFiles(files);
}

} // namespace farol::ui
