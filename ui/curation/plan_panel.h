#pragma once
// The plan with its level switch, its legend, and one line in words on what is chosen.

#include "ui/map/map_view.h"

#include <QWidget>

#include <memory>
#include <vector>

class QComboBox;
class QLabel;
class QToolButton;

namespace farol::ui {

/// Which colours and hatchings stand for what: kinds of the level, and what regions are marked as.
class PlanLegend : public QWidget {
    Q_OBJECT

public:
    struct Entry {
        QString words;
        QColor colour;
        Qt::BrushStyle pattern = Qt::SolidPattern;
    };

    explicit PlanLegend(QWidget* parent = nullptr);

    static std::vector<Entry> entries(const std::vector<building::RegionKind>& kinds,
                                      const std::vector<RegionMark>& marks, bool coverage, bool dark);
    /// In rows of at most `width`; without a painter it is only measured. The height it takes.
    static int paint(const std::vector<Entry>& entries, int width, const QFontMetrics& metrics, bool dark,
                     QPainter* painter);
    void setKinds(std::vector<building::RegionKind> kinds);
    void setMarks(std::vector<RegionMark> marks);
    void setCoverage(bool shown);
    static QString markWords(RegionMark mark);
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    std::vector<Entry> entries() const;
    int layOut(int width, QPainter* painter) const; ///< the height it takes
    void refresh();

    std::vector<building::RegionKind> m_kinds;
    std::vector<RegionMark> m_marks;
    bool m_coverage = false;
};

class PlanPanel : public QWidget {
    Q_OBJECT

public:
    explicit PlanPanel(QWidget* parent = nullptr);

    void setBuilding(const std::shared_ptr<const building::Building>& building);
    void replaceBuilding(const std::shared_ptr<const building::Building>& building);
    void setMarks(std::shared_ptr<const std::vector<RegionMark>> marks);
    MapView& view() { return *m_view; }
    QComboBox& levels() { return *m_levels; }
    QString describe(const MapHit& hit) const;
    QString whatText() const;
    /// Words that stand below the plan until the next choice.
    void tell(const QString& words);
    /// A widget between the plan and its legend.
    void addBelow(QWidget* widget);
    void setCoverage(std::shared_ptr<const CoverageLayer> coverage);

protected:
    void changeEvent(QEvent* event) override;

private:
    void fillLevels();
    void refreshLegend();
    void showWhat();
    void retranslate();

    std::shared_ptr<const building::Building> m_building;
    MapView* m_view;
    QLabel* m_levelLabel;
    QComboBox* m_levels;
    QToolButton *m_zoomIn, *m_zoomOut, *m_fit;
    PlanLegend* m_legend;
    QLabel* m_what;
    QString m_told;
};

} // namespace farol::ui
