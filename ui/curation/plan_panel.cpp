#include "ui/curation/plan_panel.h"

#include "ui/convert/convert.h"
#include "ui/convert/glyphs.h"
#include "ui/convert/kind_style.h"
#include "ui/map/coverage.h"
#include "ui/map/map_colours.h"
#include "ui/models/words.h"
#include "ui/parts/tables.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <set>

namespace farol::ui {

PlanLegend::PlanLegend(QWidget* parent) : QWidget(parent) {
    QSizePolicy policy(QSizePolicy::Ignored, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

void PlanLegend::setKinds(std::vector<building::RegionKind> kinds) {
    if (kinds == m_kinds) return;
    m_kinds = std::move(kinds);
    refresh();
}

void PlanLegend::setMarks(std::vector<RegionMark> marks) {
    if (marks == m_marks) return;
    m_marks = std::move(marks);
    refresh();
}

void PlanLegend::setCoverage(bool shown) {
    if (shown == m_coverage) return;
    m_coverage = shown;
    refresh();
}

QString PlanLegend::markWords(RegionMark mark) {
    switch (mark) {
    case RegionMark::NoLandmark:
        return tr("no landmark");
    case RegionMark::LooksAlike:
        return tr("looks like another place");
    case RegionMark::LandmarkHelps:
        return tr("a landmark here helps most");
    case RegionMark::CutOff:
        return tr("not joined with the rest");
    case RegionMark::None:
        break;
    }
    return {};
}

std::vector<PlanLegend::Entry> PlanLegend::entries(const std::vector<building::RegionKind>& kinds,
                                                   const std::vector<RegionMark>& marks, bool coverage,
                                                   bool dark) {
    const MapColours colours = MapColours::of(dark);
    std::vector<Entry> all;
    for (const building::RegionKind kind : kinds)
        all.push_back({Words::regionKind(kind), colours.fill(kind), Qt::SolidPattern});
    for (const RegionMark mark : marks) {
        const RegionMarkStyle style = regionMarkStyle(mark, dark);
        all.push_back({markWords(mark), style.colour, style.pattern});
    }
    if (!coverage) return all;
    all.push_back({tr("sees no landmark"), coverageColour(0, dark), Qt::FDiagPattern});
    all.push_back({tr("sees one"), coverageColour(1, dark), Qt::SolidPattern});
    all.push_back({tr("sees several"), coverageColour(2, dark), Qt::SolidPattern});
    return all;
}

std::vector<PlanLegend::Entry> PlanLegend::entries() const {
    return entries(m_kinds, m_marks, m_coverage, isDark(palette()));
}

int PlanLegend::paint(const std::vector<Entry>& entries, int width, const QFontMetrics& metrics, bool dark,
                      QPainter* painter) {
    const MapColours colours = MapColours::of(dark);
    const int line = std::max(metrics.height() + 4, 18);
    int x = 0;
    int y = 0;
    for (const Entry& entry : entries) {
        const int takes = 18 + 6 + metrics.horizontalAdvance(entry.words) + 14;
        if (x > 0 && x + takes > width) {
            x = 0;
            y += line;
        }
        if (painter) {
            const QRect swatch(x, y + (line - 14) / 2, 18, 14);
            painter->fillRect(swatch, colours.outside);
            painter->fillRect(swatch, QBrush(entry.colour, entry.pattern));
            painter->setPen(colours.border);
            painter->drawRect(swatch);
            painter->setPen(colours.text);
            painter->drawText(QRect(x + 24, y, takes, line), Qt::AlignVCenter | Qt::AlignLeft, entry.words);
        }
        x += takes;
    }
    return x == 0 && y == 0 ? 0 : y + line + 1;
}

int PlanLegend::layOut(int width, QPainter* painter) const {
    return paint(entries(), width, fontMetrics(), isDark(palette()), painter);
}

int PlanLegend::heightForWidth(int width) const {
    return layOut(width, nullptr);
}

QSize PlanLegend::sizeHint() const {
    return {300, layOut(std::max(width(), 300), nullptr)};
}

void PlanLegend::refresh() {
    QStringList words;
    for (const Entry& entry : entries()) words << entry.words;
    setAccessibleName(tr("Legend: %1").arg(words.join(QStringLiteral(", "))));
    updateGeometry();
    update();
}

void PlanLegend::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    layOut(width(), &painter);
}

void PlanLegend::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange) refresh();
    QWidget::changeEvent(event);
}

PlanPanel::PlanPanel(QWidget* parent)
    : QWidget(parent),
      m_view(new MapView(this)),
      m_levelLabel(new QLabel(this)),
      m_levels(new QComboBox(this)),
      m_zoomIn(new QToolButton(this)),
      m_zoomOut(new QToolButton(this)),
      m_fit(new QToolButton(this)),
      m_legend(new PlanLegend(this)),
      m_what(new ElidedLabel(this)) {
    m_view->setStyle({true, false, true});
    m_view->setTool(MapView::Tool::Move);
    m_levelLabel->setBuddy(m_levels);
    m_levels->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_levels->setMinimumContentsLength(6);
    auto* bar = new QHBoxLayout;
    bar->setSpacing(6);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_levelLabel, m_levels}) bar->addWidget(widget);
    bar->addStretch();
    for (QToolButton* button : {m_zoomOut, m_zoomIn, m_fit}) {
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
        bar->addWidget(button);
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(bar);
    layout->addWidget(m_view, 1);
    layout->addWidget(m_legend);
    layout->addWidget(m_what);
    m_view->setDescriber([this](const MapHit& hit) { return describe(hit); });
    connect(m_levels, &QComboBox::activated, this,
            [this](int row) { m_view->setLevel(m_levels->itemData(row).toDouble()); });
    connect(m_zoomIn, &QToolButton::clicked, this, [this] { m_view->zoom(1.25); });
    connect(m_zoomOut, &QToolButton::clicked, this, [this] { m_view->zoom(0.8); });
    connect(m_fit, &QToolButton::clicked, m_view, &MapView::fit);
    connect(m_view, &MapView::levelChanged, this, [this](double ordinal) {
        m_levels->setCurrentIndex(m_levels->findData(ordinal));
        refreshLegend();
        showWhat();
    });
    connect(m_view, &MapView::selectionChanged, this, [this] {
        m_told.clear();
        showWhat();
    });
    retranslate();
}

void PlanPanel::setBuilding(const std::shared_ptr<const building::Building>& building) {
    m_building = building;
    m_told.clear();
    m_view->setBuilding(building);
    fillLevels();
    refreshLegend();
    showWhat();
}

void PlanPanel::replaceBuilding(const std::shared_ptr<const building::Building>& building) {
    m_building = building;
    m_view->replaceBuilding(building);
    fillLevels();
    refreshLegend();
    showWhat();
}

void PlanPanel::setMarks(std::shared_ptr<const std::vector<RegionMark>> marks) {
    MapOverlay overlay = m_view->overlay();
    overlay.marks = std::move(marks);
    m_view->setOverlay(overlay);
    std::set<RegionMark> found;
    if (overlay.marks) found.insert(overlay.marks->begin(), overlay.marks->end());
    found.erase(RegionMark::None);
    m_legend->setMarks({found.begin(), found.end()});
}

void PlanPanel::setCoverage(std::shared_ptr<const CoverageLayer> coverage) {
    MapOverlay overlay = m_view->overlay();
    overlay.coverage = std::move(coverage);
    m_view->setOverlay(overlay);
    m_legend->setCoverage(overlay.coverage != nullptr);
}

void PlanPanel::addBelow(QWidget* widget) {
    auto* column = static_cast<QVBoxLayout*>(layout());
    column->insertWidget(column->indexOf(m_legend), widget);
}

void PlanPanel::fillLevels() {
    const QSignalBlocker quiet(m_levels);
    m_levels->clear();
    const MapScene* scene = m_view->scene();
    if (scene) // the highest floor on top, as in a lift
        for (auto level = scene->levels().rbegin(); level != scene->levels().rend(); ++level)
            m_levels->addItem(levelLabel(*m_building, level->ordinal), level->ordinal);
    m_levels->setCurrentIndex(m_levels->findData(m_view->level()));
    m_levels->setEnabled(m_levels->count() > 1);
}

void PlanPanel::refreshLegend() {
    std::set<building::RegionKind> kinds;
    const LevelScene* level = m_view->scene() ? m_view->scene()->level(m_view->level()) : nullptr;
    if (level)
        for (const RegionShape& shape : level->regions) kinds.insert(m_building->regions()[shape.index].kind);
    m_legend->setKinds({kinds.begin(), kinds.end()});
}

QString PlanPanel::describe(const MapHit& hit) const {
    if (!m_building) return {};
    switch (hit.what) {
    case MapHit::What::Region:
        return Words::about(m_building->regions()[hit.index]);
    case MapHit::What::Access:
        return Words::about(*m_building, m_building->accesses()[hit.index]);
    case MapHit::What::Landmark:
        break;
    }
    return Words::about(*m_building, m_building->landmarks()[hit.index]);
}

QString PlanPanel::whatText() const {
    return m_what->text();
}

void PlanPanel::tell(const QString& words) {
    m_told = words;
    showWhat();
}

void PlanPanel::showWhat() {
    QString words = m_told;
    if (words.isEmpty() && !m_building) words = tr("No map is open.");
    if (words.isEmpty() && m_view->selected()) words = describe(*m_view->selected());
    if (words.isEmpty()) {
        const LevelScene* level = m_view->scene()->level(m_view->level());
        const int regions = level ? static_cast<int>(level->regions.size()) : 0;
        words =
            tr("%1: %n region(s), %2", nullptr, regions)
                .arg(Words::level(*m_building, m_view->level()),
                     tr("%n landmark(s)", nullptr, level ? static_cast<int>(level->landmarks.size()) : 0));
    }
    m_what->setText(words);
    m_what->setToolTip(words);
    m_view->setAccessibleDescription(words);
}

void PlanPanel::retranslate() {
    m_levelLabel->setText(tr("&Level:"));
    m_levels->setAccessibleName(tr("Level of the plan"));
    m_levels->setToolTip(tr("The floor that the plan shows (Page Up and Page Down in the plan)"));
    const auto name = [this](QToolButton* button, Glyph glyph, const QString& text) {
        button->setIcon(glyphIcon(glyph, palette()));
        button->setAccessibleName(text);
        button->setToolTip(text);
    };
    name(m_zoomIn, Glyph::ZoomIn, tr("Larger (+)"));
    name(m_zoomOut, Glyph::ZoomOut, tr("Smaller (-)"));
    name(m_fit, Glyph::Fit, tr("Show the whole floor (0)"));
    m_view->setAccessibleName(tr("Plan"));
    m_view->setToolTip(tr("Drag to move, turn the wheel to zoom. What is chosen can be dragged, or moved by "
                          "Alt and the arrows"));
    refreshLegend();
    showWhat();
}

void PlanPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange) retranslate();
    QWidget::changeEvent(event);
}

} // namespace farol::ui
