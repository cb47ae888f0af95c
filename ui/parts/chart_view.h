#pragma once
// Charts that people look at: lines over time, bars by value or by name. Drawn here, saved as PNG or SVG.

#include <QPointF>
#include <QString>
#include <QStringList>
#include <QWidget>

#include <vector>

namespace farol::ui {

struct ChartSeries {
    QString name;
    std::vector<QPointF> points; ///< by rising x
};

struct Chart {
    QString title, xName, yName;
    QString missing; ///< what to do where there is nothing to show
    std::vector<ChartSeries> lines;
    std::vector<double> bars; ///< one beside the other
    QStringList barNames;     ///< of each bar; empty: the bars divide 0 to `barsEnd`
    double barsEnd = 0.0;
    bool diagonal = false; ///< the line on which both axes agree

    bool empty() const { return lines.empty() && bars.empty(); }
};

class ChartView : public QWidget {
    Q_OBJECT

public:
    explicit ChartView(QWidget* parent = nullptr);

    void setChart(Chart chart);
    const Chart& chart() const { return m_chart; }
    /// By the name's end: svg, else a picture. False: it cannot be written.
    bool save(const QString& file) const;

    QSize sizeHint() const override { return {640, 400}; }
    QSize minimumSizeHint() const override { return {320, 220}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paint(QPainter& painter, const QRectF& area, const QPalette& palette) const;

    Chart m_chart;
};

/// Round figures from 0 to about `end`, at most `most` steps.
std::vector<double> niceTicks(double end, int most);

} // namespace farol::ui
