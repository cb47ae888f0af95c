#include "ui/parts/chart_view.h"

#include <QImage>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QSvgGenerator>

#include <algorithm>
#include <array>
#include <cmath>

namespace farol::ui {

namespace {

constexpr QSize kSaved(1280, 800);
// Told apart also by people who see few colours; the lines differ in their dashes, too.
constexpr std::array<QRgb, 6> kColours{0x0072b2, 0xe69f00, 0x009e73, 0xcc79a7, 0xd55e00, 0x56b4e9};
constexpr std::array<Qt::PenStyle, 4> kDashes{Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine};

QPen penOf(std::size_t series) {
    QPen pen(QColor(kColours[series % kColours.size()]), 2);
    pen.setStyle(kDashes[series % kDashes.size()]);
    return pen;
}

/// Where figures come on the paper.
struct Plot {
    QRectF area;
    double right = 1.0, top = 1.0;

    QPointF at(double x, double y) const {
        return {area.left() + area.width() * x / right, area.bottom() - area.height() * y / top};
    }
};

double endOfX(const Chart& chart) {
    double end = chart.barsEnd;
    for (const ChartSeries& series : chart.lines)
        for (const QPointF& point : series.points) end = std::max(end, point.x());
    return end > 0.0 ? end : 1.0;
}

double endOfY(const Chart& chart) {
    if (chart.diagonal) return 1.0;
    double end = 0.0;
    for (const ChartSeries& series : chart.lines)
        for (const QPointF& point : series.points) end = std::max(end, point.y());
    for (const double bar : chart.bars) end = std::max(end, bar);
    return end > 0.0 ? end * 1.04 : 1.0; // the highest line stays clear of the edge
}

void paintAxes(QPainter& painter, const Plot& plot, const Chart& chart, const QPalette& palette) {
    const QFontMetricsF metrics(painter.font());
    const QLocale locale;
    painter.setPen(palette.color(QPalette::Mid));
    for (const double tick : niceTicks(plot.top, 6)) {
        const QPointF at = plot.at(0, tick);
        painter.drawLine(at, QPointF(plot.area.right(), at.y()));
        painter.save();
        painter.setPen(palette.color(QPalette::Text));
        painter.drawText(QRectF(0, at.y() - metrics.height() / 2, plot.area.left() - 6, metrics.height()),
                         Qt::AlignRight | Qt::AlignVCenter, locale.toString(tick, 'g', 4));
        painter.restore();
    }
    painter.setPen(palette.color(QPalette::Text));
    if (chart.barNames.isEmpty())
        for (const double tick : niceTicks(plot.right, 8)) {
            const QPointF at = plot.at(tick, 0);
            painter.drawLine(at, at + QPointF(0, 4));
            painter.drawText(QRectF(at.x() - 40, at.y() + 5, 80, metrics.height()),
                             Qt::AlignHCenter | Qt::AlignTop, locale.toString(tick, 'g', 4));
        }
    painter.drawLine(plot.area.bottomLeft(), plot.area.bottomRight());
    painter.drawLine(plot.area.bottomLeft(), plot.area.topLeft());
}

void paintBars(QPainter& painter, const Plot& plot, const Chart& chart, const QPalette& palette) {
    const QFontMetricsF metrics(painter.font());
    const double widest = chart.barNames.isEmpty() ? plot.area.width() : 70.0;
    const double width = std::min(widest, plot.area.width() / static_cast<double>(chart.bars.size()));
    for (std::size_t i = 0; i < chart.bars.size(); ++i) {
        const double left = plot.area.left() + width * static_cast<double>(i);
        const double top = plot.at(0, chart.bars[i]).y();
        const double gap = chart.barNames.isEmpty() ? 0.5 : std::min(6.0, width * 0.15);
        painter.fillRect(QRectF(left + gap, top, width - 2 * gap, plot.area.bottom() - top),
                         QColor(kColours[0]));
        if (chart.barNames.isEmpty()) continue;
        painter.save();
        painter.setPen(palette.color(QPalette::Text));
        painter.translate(left + width / 2, plot.area.bottom() + 6);
        painter.rotate(-55);
        const QString name =
            metrics.elidedText(chart.barNames.value(static_cast<qsizetype>(i)), Qt::ElideRight, 118);
        painter.drawText(QRectF(-122, -metrics.height() / 2, 120, metrics.height()),
                         Qt::AlignRight | Qt::AlignVCenter, name);
        painter.restore();
    }
}

} // namespace

std::vector<double> niceTicks(double end, int most) {
    if (!(end > 0.0) || most < 1) return {0.0};
    const double rough = end / most;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    double step = 10.0 * power;
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= rough) {
            step = factor * power;
            break;
        }
    std::vector<double> ticks;
    for (int i = 0; i * step <= end * 1.0001; ++i) ticks.push_back(i * step);
    return ticks;
}

ChartView::ChartView(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus); // so that a screen reader can visit it
}

void ChartView::setChart(Chart chart) {
    m_chart = std::move(chart);
    setAccessibleName(m_chart.title);
    QStringList parts;
    for (const ChartSeries& series : m_chart.lines) parts << series.name;
    for (std::size_t i = 0; i < m_chart.bars.size() && !m_chart.barNames.isEmpty(); ++i)
        parts << QStringLiteral("%1: %2").arg(m_chart.barNames.value(static_cast<qsizetype>(i)),
                                              QLocale().toString(m_chart.bars[i], 'g', 3));
    setAccessibleDescription(m_chart.empty() ? m_chart.missing : parts.join(QStringLiteral("; ")));
    update();
}

void ChartView::paint(QPainter& painter, const QRectF& area, const QPalette& palette) const {
    painter.fillRect(area, palette.color(QPalette::Base));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(palette.color(QPalette::Text));
    const QFontMetricsF metrics(painter.font());
    QFont bold = painter.font();
    bold.setBold(true);
    painter.save();
    painter.setFont(bold);
    painter.drawText(QRectF(area.left() + 12, area.top() + 8, area.width() - 24, metrics.height() + 4),
                     Qt::AlignLeft, m_chart.title);
    painter.restore();
    if (m_chart.empty())
        return painter.drawText(area.adjusted(24, 40, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                                m_chart.missing);
    const double line = metrics.height();
    const double legend = m_chart.lines.size() > 1 ? line + 6 : 0.0;
    const double names = m_chart.barNames.isEmpty() ? line + 8 : 106.0;
    Plot plot{area.adjusted(64, 20 + 2 * line + legend, -20, -(names + line + 14)), endOfX(m_chart),
              endOfY(m_chart)};
    painter.drawText(QRectF(area.left() + 12, plot.area.top() - line - 6, 400, line), Qt::AlignLeft,
                     m_chart.yName);
    painter.drawText(QRectF(plot.area.left(), area.bottom() - line - 8, plot.area.width(), line),
                     Qt::AlignHCenter, m_chart.xName);
    paintAxes(painter, plot, m_chart, palette);
    if (m_chart.diagonal) {
        painter.setPen(QPen(palette.color(QPalette::Mid), 1.5, Qt::DashLine));
        painter.drawLine(plot.at(0, 0), plot.at(plot.right, plot.right));
    }
    if (!m_chart.bars.empty()) paintBars(painter, plot, m_chart, palette);
    double x = area.left() + 12;
    for (std::size_t i = 0; i < m_chart.lines.size(); ++i) {
        QPainterPath path;
        for (const QPointF& point : m_chart.lines[i].points)
            path.elementCount() == 0 ? path.moveTo(plot.at(point.x(), point.y()))
                                     : path.lineTo(plot.at(point.x(), point.y()));
        painter.setBrush(Qt::NoBrush);
        painter.setPen(penOf(i));
        painter.drawPath(path);
        if (legend == 0.0) continue;
        const double y = area.top() + 18 + 1.5 * line;
        painter.drawLine(QPointF(x, y), QPointF(x + 26, y));
        painter.setPen(palette.color(QPalette::Text));
        painter.drawText(QPointF(x + 32, y + metrics.ascent() / 2 - 1), m_chart.lines[i].name);
        x += 50 + metrics.horizontalAdvance(m_chart.lines[i].name);
    }
}

void ChartView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    paint(painter, rect(), palette());
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

bool ChartView::save(const QString& file) const {
    QFont large = font();
    large.setPointSizeF(large.pointSizeF() * 1.5); // the picture is larger than the window
    QPalette paper;                                // ink on white, whatever the window looks like
    paper.setColor(QPalette::Base, Qt::white);
    paper.setColor(QPalette::Text, Qt::black);
    paper.setColor(QPalette::Mid, QColor(0xc8, 0xc8, 0xc8));
    if (file.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive)) {
        QSvgGenerator svg;
        svg.setFileName(file);
        svg.setSize(kSaved);
        svg.setViewBox(QRect(QPoint(0, 0), kSaved));
        svg.setTitle(m_chart.title);
        QPainter painter;
        if (!painter.begin(&svg)) return false;
        painter.setFont(large);
        paint(painter, QRectF(QPointF(0, 0), kSaved), paper);
        return painter.end();
    }
    QImage image(kSaved, QImage::Format_RGB32);
    QPainter painter(&image);
    painter.setFont(large);
    paint(painter, QRectF(QPointF(0, 0), kSaved), paper);
    painter.end();
    return image.save(file);
}

} // namespace farol::ui
