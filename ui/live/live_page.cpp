#include "ui/live/live_page.h"

#include "ui/convert/convert.h"
#include "ui/live/frame_panel.h"
#include "ui/live/instruction_panel.h"
#include "ui/live/map_panel.h"
#include "ui/live/timeline_bar.h"
#include "ui/parts/banner.h"
#include "ui/parts/place_chooser.h"
#include "ui/parts/tables.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QSplitter>
#include <QTabWidget>
#include <QTableView>
#include <QVBoxLayout>

namespace farol::ui {

namespace {

constexpr double kZoneSeconds = 4.0; // how long the zone of a spoken object stays marked

QWidget* titled(QLabel* title, QWidget* content, QWidget* parent) {
    auto* box = new QWidget(parent);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(title);
    layout->addWidget(content, 1);
    return box;
}

} // namespace

LivePage::LivePage(Walk& walk, SpeechDesk& speech, Settings& settings, QWidget* parent)
    : QWidget(parent), m_walk(walk), m_speech(speech), m_settings(settings) {
    build();
    connectWalk();
    connectViews();
    retranslate();
    restoreLayout();
    m_instruction->setVoice(speech.status(), speech.trouble());
    setBuilding(walk.building());
}

LivePage::~LivePage() = default;

void LivePage::build() {
    m_banners = new BannerStack(this);
    m_destination = new PlaceChooser(m_regions, PlaceChooser::Purpose::Destination, this);
    m_start = new PlaceChooser(m_regions, PlaceChooser::Purpose::Start, this);
    m_instruction = new InstructionPanel(this);
    m_views = new QSplitter(Qt::Horizontal, this);
    m_frame = new FramePanel(m_views);
    m_map = new MapPanel(m_views);
    m_views->addWidget(m_frame);
    m_views->addWidget(m_map);
    m_views->setStretchFactor(0, 1);
    m_views->setStretchFactor(1, 1);
    m_timelineBar = new TimelineBar(m_timeline, this);
    m_halves = new QSplitter(Qt::Vertical, this);
    m_halves->addWidget(m_views);
    m_halves->addWidget(makeTables());
    m_halves->setStretchFactor(0, 5);
    m_halves->setStretchFactor(1, 2);
    for (QSplitter* splitter : {m_views, m_lists, m_halves}) {
        splitter->setChildrenCollapsible(false);
        splitter->setHandleWidth(8);
    }

    auto* places = new QHBoxLayout;
    places->setSpacing(16);
    places->addWidget(m_destination, 1);
    places->addWidget(m_start, 1);
    auto* content = new QVBoxLayout;
    content->setContentsMargins(8, 6, 8, 4);
    content->setSpacing(6);
    content->addLayout(places);
    content->addWidget(m_instruction);
    content->addWidget(m_halves, 1);
    content->addWidget(m_timelineBar);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_banners);
    layout->addLayout(content, 1);
}

QWidget* LivePage::makeTables() {
    m_lists = new QSplitter(Qt::Horizontal, this);
    m_saidTitle = panelTitle(m_lists);
    m_voteTitle = panelTitle(m_lists);
    m_said = panelTable(&m_utterances, UtteranceModel::Sentence, m_lists);
    m_voteTable = panelTable(&m_votes, VoteModel::Why, m_lists);
    m_voteTable->setItemDelegateForColumn(VoteModel::Vote, new ShareBarDelegate(m_voteTable));
    m_tabs = new QTabWidget(m_lists);
    m_tabs->setDocumentMode(true);
    m_historyTable = panelTable(&m_history, HistoryModel::Name, m_tabs);
    m_pictureTable = panelTable(&m_detections, DetectionModel::Name, m_tabs);
    m_floorTable = panelTable(&m_floor, FloorModel::Name, m_tabs);
    m_detailTable = panelTable(&m_detail, VoteDetailModel::Meaning, m_tabs);
    m_tabs->addTab(m_detailTable, QString());
    m_tabs->addTab(m_historyTable, QString());
    m_tabs->addTab(m_pictureTable, QString());
    m_tabs->addTab(m_floorTable, QString());
    for (QTableView* table : {m_said, m_voteTable, m_detailTable}) wrapRows(table);
    m_lists->addWidget(titled(m_saidTitle, m_said, m_lists));
    m_lists->addWidget(titled(m_voteTitle, m_voteTable, m_lists));
    m_lists->addWidget(m_tabs);
    m_lists->setStretchFactor(0, 5);
    m_lists->setStretchFactor(1, 4);
    m_lists->setStretchFactor(2, 4);
    m_saidTitle->setBuddy(m_said);
    m_voteTitle->setBuddy(m_voteTable);
    return m_lists;
}

void LivePage::connectWalk() {
    connect(&m_walk, &Walk::mapChanged, this, [this] { setBuilding(m_walk.building()); });
    connect(&m_walk, &Walk::snapshotChanged, this, [this] {
        if (m_walk.snapshot() && !m_walk.snapshot()->frame.image.empty()) m_timeline.add(*m_walk.snapshot());
        if (!m_timelineBar->looksBack()) show(m_walk.snapshot());
    });
    connect(m_timelineBar, &TimelineBar::wanted, this,
            [this](const std::shared_ptr<const session::Snapshot>& then) {
                show(then ? then : m_walk.snapshot());
            });
    connect(&m_walk, &Walk::walkBegan, this, [this] {
        m_speech.reset();
        m_utterances.clear();
        m_timeline.clear();
        m_explained.reset();
        m_told.clear();
        const auto options = session::NavigatorOptions::with(toUtf8(m_walk.localiser()));
        m_map->setSureConfidence(options.guidance.sureConfidence);
        m_framesShown = 0;
        show(nullptr);
    });
    connect(&m_walk, &Walk::stepped, this, [this](const session::NavigationStep& step) {
        m_speech.setNow(step.percept.time, step.fix.region, step.progress.routeVersion);
        m_told.heard(step.fix);
    });
    connect(&m_walk, &Walk::corrected, this, [this](const std::optional<RegionId>& region) {
        m_told.tell(region);
        if (!m_timelineBar->looksBack()) show(m_walk.snapshot());
    });
    connect(&m_walk, &Walk::cueCame, this, [this](const guidance::Cue& cue) { m_speech.add(cue); });
    connect(&m_walk, &Walk::placesChanged, this, [this] {
        m_destination->setChosen(m_walk.destination());
        m_start->setChosen(m_walk.start());
        m_map->setDestination(m_walk.destination());
        markFloor();
    });
    m_walk.setVoiced(true);
    connect(&m_speech, &SpeechDesk::utteranceChanged, this, [this](const Utterance& utterance) {
        if (utterance.state == UtteranceState::Speaking && !utterance.own) m_walk.heard(utterance.cue);
    });
    connect(&m_speech, &SpeechDesk::utteranceChanged, this, &LivePage::note);
    connect(&m_speech, &SpeechDesk::statusChanged, m_instruction, &InstructionPanel::setVoice);
}

void LivePage::connectViews() {
    connect(m_destination, &PlaceChooser::placeChosen, &m_walk, &Walk::setDestination);
    connect(m_start, &PlaceChooser::placeChosen, &m_walk, &Walk::setStart);
    connect(m_map, &MapPanel::destinationWanted, &m_walk,
            [this](const RegionId& region) { m_walk.setDestination(region); });
    connect(m_map, &MapPanel::startWanted, &m_walk,
            [this](const RegionId& region) { m_walk.setStart(region); });
    connect(m_map, &MapPanel::hereWanted, &m_walk,
            [this](const RegionId& region) { m_walk.correct(region); });
    connect(m_voteTable->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& current) {
                if (!current.isValid() || !m_voteTable->hasFocus()) return;
                m_explained = RegionId(toUtf8(current.data(VoteModel::RegionRole).toString()));
                explainVote();
            });
    connect(m_map, &MapPanel::followChanged, &m_settings, &Settings::setFollowLevel);
    connect(&m_map->view(), &MapView::levelChanged, this,
            [this](double ordinal) { m_floor.setLevel(ordinal); });
    connect(&m_map->view(), &MapView::selectionChanged, this, [this](const std::optional<MapHit>& hit) {
        if (!hit) return m_floorTable->clearSelection();
        const auto sort = static_cast<FloorModel::Sort>(hit->what);
        if (const int row = m_floor.rowOf(sort, hit->index); row >= 0) m_floorTable->selectRow(row);
    });
    connect(m_floorTable->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& current) {
                if (current.isValid() && m_floorTable->hasFocus()) selectOnMap(current.row());
            });
    connect(m_floorTable, &QTableView::activated, this, [this](const QModelIndex& index) {
        const FloorModel::Row& row = m_floor.at(index.row());
        if (row.sort == FloorModel::Sort::Region)
            m_walk.setDestination(m_walk.building()->regions()[row.index].id);
    });
    QScrollBar* said = m_said->verticalScrollBar(); // follows the newest, unless the reader looks further up
    connect(said, &QScrollBar::valueChanged, this,
            [this, said](int value) { m_saidAtEnd = value >= said->maximum() - 4; });
    connect(said, &QScrollBar::rangeChanged, this, [this, said](int /*least*/, int most) {
        if (m_saidAtEnd) said->setValue(most);
    });
    const auto display = [this] {
        m_frame->view().setShowGrid(m_settings.showGrid());
        m_frame->view().setShowRejected(m_settings.showRejected());
        m_map->setFollow(m_settings.followLevel());
        show(m_shown);
    };
    connect(&m_settings, &Settings::displayChanged, this, display);
    display();
}

void LivePage::selectOnMap(int floorRow) {
    const FloorModel::Row& row = m_floor.at(floorRow);
    m_map->view().select(MapHit{static_cast<MapHit::What>(row.sort), row.index}, true);
}

void LivePage::setBuilding(const std::shared_ptr<const building::Building>& building) {
    m_shown.reset();
    m_regions.setBuilding(building);
    m_votes.setBuilding(building);
    m_detail.setBuilding(building);
    m_floor.setBuilding(building);
    m_instruction->setBuilding(building);
    m_map->setBuilding(building);
    m_floor.setLevel(m_map->view().level());
    for (PlaceChooser* chooser : {m_destination, m_start}) chooser->setEnabled(building != nullptr);
    show(nullptr);
}

void LivePage::show(const std::shared_ptr<const session::Snapshot>& snapshot) {
    const bool newFrame = snapshot && snapshot != m_shown && !snapshot->frame.image.empty();
    m_shown = snapshot;
    m_frame->show(snapshot);
    m_map->setTold(m_timelineBar->looksBack() ? ToldPlace() : m_told);
    m_map->show(snapshot);
    m_instruction->show(snapshot);
    if (!snapshot) {
        m_history.show({});
        m_detections.show({}, {});
        m_votes.show({});
        m_frame->view().setSpokenZone(std::nullopt);
    } else {
        const session::NavigationStep& step = snapshot->step;
        m_history.show(step.history);
        m_detections.show(session::inView(step.percept), m_settings.showRejected()
                                                             ? step.percept.rejections
                                                             : std::vector<recognition::Rejection>{});
        m_votes.show(step.fix.votes);
        if (step.percept.time > m_zoneUntil) m_frame->view().setSpokenZone(std::nullopt);
    }
    markFloor();
    explainVote();
    if (newFrame && !m_timelineBar->looksBack()) Q_EMIT frameShown(++m_framesShown);
}

/// Of the place that the user chose in the list, while it is in it; else of the best.
void LivePage::explainVote() {
    int row = 0;
    for (int i = 0; m_explained && i < m_votes.rowCount(); ++i)
        if (m_votes.vote(i)->region == *m_explained) row = i;
    m_detail.show(m_votes.vote(row),
                  m_shown ? m_shown->step.history : std::deque<localisation::Observation>());
}

std::optional<RegionId> LivePage::chosenRegion() const {
    const std::optional<MapHit>& hit = m_map->view().selected();
    if (hit && hit->what == MapHit::What::Region && m_walk.building())
        return m_walk.building()->regions()[hit->index].id;
    return m_explained;
}

void LivePage::markFloor() {
    m_floor.setMarks(m_shown ? m_shown->step.fix.region : std::nullopt, m_walk.destination());
}

void LivePage::note(const Utterance& utterance) {
    m_utterances.note(utterance);
    if (utterance.state == UtteranceState::Speaking || utterance.state == UtteranceState::Shown)
        m_timeline.noteSaid(utterance.text);
    m_instruction->note(utterance);
    const bool hasZone =
        utterance.cue.kind == guidance::CueKind::Detection || utterance.cue.kind == guidance::CueKind::Text;
    const bool current =
        utterance.state == UtteranceState::Speaking || utterance.state == UtteranceState::Shown;
    if (!hasZone || !current) return;
    m_zoneUntil = utterance.cue.time + kZoneSeconds;
    m_frame->view().setSpokenZone(utterance.cue.zone);
}

void LivePage::retranslate() {
    m_saidTitle->setText(tr("What was said"));
    m_voteTitle->setText(tr("Where it could be"));
    const auto name = [](QTableView* table, const QString& text, const QString& tip) {
        table->setAccessibleName(text);
        table->setToolTip(tip);
    };
    name(m_said, tr("What was said"), tr("Every sentence, when it was due, and what became of it"));
    name(m_voteTable, tr("Where it could be"), tr("The places that fit what was seen, best first"));
    name(m_detailTable, tr("Why there"),
         tr("What the vote of the chosen place is made of, and what speaks for it"));
    name(m_historyTable, tr("Last seen"), tr("The last objects that the place is worked out from"));
    name(m_pictureTable, tr("In the picture"), tr("Everything recognised in the picture shown"));
    name(m_floorTable, tr("On this floor"), tr("The map as a list; press Enter on a place to go there"));
    setEmptyHint(m_said, tr("Nothing has been said yet."));
    setEmptyHint(m_voteTable, tr("Nothing has been worked out yet."));
    setEmptyHint(m_detailTable, tr("As soon as there is a place, what speaks for it stands here."));
    setEmptyHint(m_historyTable, tr("Nothing has been recognised yet."));
    setEmptyHint(m_pictureTable, tr("Nothing is recognised in the picture."));
    setEmptyHint(m_floorTable, tr("No map is open."));
    m_tabs->setTabText(0, tr("Why there"));
    m_tabs->setTabText(1, tr("Last seen"));
    m_tabs->setTabText(2, tr("In the picture"));
    m_tabs->setTabText(3, tr("On this floor"));
    m_tabs->setAccessibleName(tr("Lists"));
    m_tabs->setToolTip(tr("Lists"));
    m_tabs->tabBar()->setAccessibleName(tr("Lists"));
    for (QTableView* table :
         {m_said, m_voteTable, m_detailTable, m_historyTable, m_pictureTable, m_floorTable})
        table->viewport()->update();
    for (const QAbstractItemModel* model : std::initializer_list<const QAbstractItemModel*>{
             &m_utterances, &m_votes, &m_detail, &m_history, &m_detections, &m_floor})
        Q_EMIT const_cast<QAbstractItemModel*>(model)->headerDataChanged(Qt::Horizontal, 0,
                                                                         model->columnCount() - 1);
}

void LivePage::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

std::vector<QWidget*> LivePage::tables() const {
    return {m_said, m_voteTable, m_tabs->currentWidget()};
}

void LivePage::restoreLayout() {
    m_halves->setSizes({430, 180});
    m_views->setSizes({500, 500});
    m_lists->setSizes({450, 350, 460}); // the last one has tabs, in the longest language too
    m_views->restoreState(m_settings.splitter(QStringLiteral("views")));
    m_lists->restoreState(m_settings.splitter(QStringLiteral("lists")));
    m_halves->restoreState(m_settings.splitter(QStringLiteral("halves")));
}

void LivePage::saveLayout() {
    m_settings.setSplitter(QStringLiteral("views"), m_views->saveState());
    m_settings.setSplitter(QStringLiteral("lists"), m_lists->saveState());
    m_settings.setSplitter(QStringLiteral("halves"), m_halves->saveState());
}

} // namespace farol::ui
