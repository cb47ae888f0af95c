#pragma once
// The floor map with its level switch, and one line in words: where one is and how sure that is.

#include "core/session/percept.h"
#include "ui/live/told_place.h"
#include "ui/map/map_view.h"

#include <QWidget>

#include <memory>

class QCheckBox;
class QComboBox;
class QLabel;
class QToolButton;

namespace farol::ui {

class MapPanel : public QWidget {
    Q_OBJECT

public:
    explicit MapPanel(QWidget* parent = nullptr);

    void setBuilding(const std::shared_ptr<const building::Building>& building);
    void show(const std::shared_ptr<const session::Snapshot>& snapshot); ///< null: nothing yet
    /// The assistant's word, over what a snapshot says.
    void setTold(const ToldPlace& told) { m_told = told; }
    void setDestination(const std::optional<RegionId>& destination);
    /// Of a simulated walk; empty: nobody knows.
    void setTruth(const std::optional<TruePlace>& truth);
    /// From which confidence on a place is told as sure.
    void setSureConfidence(double confidence) { m_sureConfidence = confidence; }
    void setFollow(bool follow);
    bool follow() const;
    MapView& view() { return *m_view; }
    QString whereText() const;

Q_SIGNALS:
    void followChanged(bool follow);
    void destinationWanted(const farol::RegionId& region);
    void startWanted(const farol::RegionId& region);
    void hereWanted(const farol::RegionId& region); ///< the user is there now

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void fillLevels();
    void levelPicked(int row);
    void openMenu(const MapHit& hit, const QPoint& at);
    QString describe(const MapHit& hit) const;
    QString where() const;
    QString whereItIs(const localisation::Fix& fix) const;
    std::optional<RegionId> regionOf(const MapHit& hit) const;

    std::shared_ptr<const building::Building> m_building;
    std::shared_ptr<const session::Snapshot> m_snapshot;
    std::optional<RegionId> m_destination;
    std::optional<TruePlace> m_truth;
    ToldPlace m_told;
    double m_sureConfidence = 0.5;
    MapView* m_view;
    QLabel* m_title;
    QLabel* m_levelLabel;
    QComboBox* m_levels;
    QCheckBox* m_follow;
    QToolButton* m_zoomIn;
    QToolButton* m_zoomOut;
    QToolButton* m_fit;
    QLabel* m_where;
};

} // namespace farol::ui
