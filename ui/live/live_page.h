#pragma once
// The page on which a walk is watched: picture, map, next instruction, what was said, votes and what was
// seen.

#include "ui/live/speech_desk.h"
#include "ui/live/told_place.h"
#include "ui/live/walk.h"
#include "ui/live/walk_timeline.h"
#include "ui/models/detection_model.h"
#include "ui/models/floor_model.h"
#include "ui/models/history_model.h"
#include "ui/models/region_model.h"
#include "ui/models/utterance_model.h"
#include "ui/models/vote_detail_model.h"
#include "ui/models/vote_model.h"

#include <QWidget>

#include <vector>

class QLabel;
class QSplitter;
class QTabWidget;
class QTableView;

namespace farol::ui {

class BannerStack;
class FramePanel;
class InstructionPanel;
class MapPanel;
class PlaceChooser;
class TimelineBar;

/// Needs a Walk, a voice and settings that outlive it.
class LivePage : public QWidget {
    Q_OBJECT

public:
    LivePage(Walk& walk, SpeechDesk& speech, Settings& settings, QWidget* parent = nullptr);
    ~LivePage() override;

    /// Shows a snapshot as it is; null: nothing yet. The walk's own come by themselves.
    void show(const std::shared_ptr<const session::Snapshot>& snapshot);
    void setBuilding(const std::shared_ptr<const building::Building>& building);
    BannerStack& banners() { return *m_banners; }
    PlaceChooser& destination() { return *m_destination; }
    PlaceChooser& startPlace() { return *m_start; }
    FramePanel& framePanel() { return *m_frame; }
    MapPanel& mapPanel() { return *m_map; }
    InstructionPanel& instruction() { return *m_instruction; }
    UtteranceModel& utterances() { return m_utterances; }
    std::vector<QWidget*> tables() const; ///< in the order of the keyboard
    int framesShown() const { return m_framesShown; }
    void saveLayout();
    WalkTimeline& timeline() { return m_timeline; }
    TimelineBar& timelineBar() { return *m_timelineBar; }
    VoteDetailModel& voteDetail() { return m_detail; }
    /// What is chosen on the map, else in the list of places.
    std::optional<RegionId> chosenRegion() const;

Q_SIGNALS:
    void frameShown(int count);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    QWidget* makeTables();
    void connectWalk();
    void connectViews();
    void note(const Utterance& utterance);
    void markFloor();
    void selectOnMap(int floorRow);
    void explainVote();
    void retranslate();
    void restoreLayout();

    Walk& m_walk;
    SpeechDesk& m_speech;
    Settings& m_settings;
    RegionModel m_regions;
    FloorModel m_floor;
    HistoryModel m_history;
    DetectionModel m_detections;
    VoteModel m_votes;
    UtteranceModel m_utterances;
    VoteDetailModel m_detail;
    WalkTimeline m_timeline;

    BannerStack* m_banners;
    PlaceChooser* m_start;
    PlaceChooser* m_destination;
    InstructionPanel* m_instruction;
    FramePanel* m_frame;
    MapPanel* m_map;
    QSplitter* m_views;
    QSplitter* m_lists;
    QSplitter* m_halves;
    QLabel* m_saidTitle;
    QLabel* m_voteTitle;
    QTableView* m_said;
    bool m_saidAtEnd = true; ///< it shows the newest sentence
    QTableView* m_voteTable;
    QTabWidget* m_tabs;
    QTableView* m_historyTable;
    QTableView* m_pictureTable;
    QTableView* m_floorTable;
    QTableView* m_detailTable;
    TimelineBar* m_timelineBar;

    std::optional<RegionId> m_explained; ///< chosen by the user; empty: the best
    int m_framesShown = 0;
    std::shared_ptr<const session::Snapshot> m_shown;
    ToldPlace m_told;         ///< of the walk that runs
    double m_zoneUntil = 0.0; ///< walk time until which the spoken zone stays marked
};

} // namespace farol::ui
