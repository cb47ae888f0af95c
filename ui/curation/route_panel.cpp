#include "ui/curation/route_panel.h"

#include "core/routing/route_rules.h"
#include "ui/convert/convert.h"
#include "ui/models/core_words.h"
#include "ui/models/no_route_words.h"
#include "ui/parts/place_chooser.h"
#include "ui/parts/tables.h"

#include <QCheckBox>
#include <QEvent>
#include <QGridLayout>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace farol::ui {

RoutePanel::RoutePanel(QWidget* parent)
    : QWidget(parent),
      m_from(new PlaceChooser(m_regions, PlaceChooser::Purpose::From, this)),
      m_to(new PlaceChooser(m_regions, PlaceChooser::Purpose::To, this)),
      m_swap(new QPushButton(this)),
      m_avoid(new QGroupBox(this)),
      m_stairs(new QCheckBox(m_avoid)),
      m_lifts(new QCheckBox(m_avoid)),
      m_escalators(new QCheckBox(m_avoid)),
      m_restricted(new QCheckBox(m_avoid)),
      m_summary(new QLabel(this)),
      m_table(panelTable(&m_model, RouteModel::Sentence, this)),
      m_background(this) {
    auto* avoid = new QGridLayout(m_avoid);
    avoid->addWidget(m_stairs, 0, 0);
    avoid->addWidget(m_lifts, 0, 1);
    avoid->addWidget(m_escalators, 1, 0);
    avoid->addWidget(m_restricted, 1, 1);
    m_summary->setWordWrap(true);
    m_summary->setTextFormat(Qt::PlainText);
    m_summary->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_table->setWordWrap(true);
    m_table->setTextElideMode(Qt::ElideNone);
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 6, 4, 4);
    layout->addWidget(m_from);
    layout->addWidget(m_to);
    layout->addWidget(m_swap, 0, Qt::AlignRight);
    layout->addWidget(m_avoid);
    layout->addWidget(m_summary);
    layout->addWidget(m_table, 1);

    for (PlaceChooser* chooser : {m_from, m_to})
        connect(chooser, &PlaceChooser::placeChosen, this, [this] {
            plan();
            Q_EMIT placesChanged();
        });
    connect(m_swap, &QPushButton::clicked, this, [this] {
        const std::optional<RegionId> from = m_from->chosen();
        m_from->setChosen(m_to->chosen());
        m_to->setChosen(from);
        plan();
        Q_EMIT placesChanged();
    });
    for (QCheckBox* box : {m_stairs, m_lifts, m_escalators, m_restricted})
        connect(box, &QCheckBox::toggled, this, [this] {
            m_planner.reset();
            plan();
        });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& current) {
                if (current.isValid()) Q_EMIT manoeuvreChosen(m_model.at(current.row()));
            });
    retranslate();
    summarise();
}

RoutePanel::~RoutePanel() = default;

void RoutePanel::setBuilding(const std::shared_ptr<const building::Building>& building, bool sameMap) {
    const std::optional<RegionId> from = sameMap ? m_from->chosen() : std::nullopt;
    const std::optional<RegionId> to = sameMap ? m_to->chosen() : std::nullopt;
    m_building = building;
    m_planner.reset();
    m_regions.setBuilding(building); // forgets the places
    if (building && from && building->region(*from)) m_from->setChosen(from);
    if (building && to && building->region(*to)) m_to->setChosen(to);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_from, m_to, m_swap, m_avoid})
        widget->setEnabled(building != nullptr);
    plan();
}

void RoutePanel::setFrom(const std::optional<RegionId>& region) {
    m_from->setChosen(region);
    plan();
    Q_EMIT placesChanged();
}

void RoutePanel::setTo(const std::optional<RegionId>& region) {
    m_to->setChosen(region);
    plan();
    Q_EMIT placesChanged();
}

void RoutePanel::setStyle(DirectionStyle style) {
    m_model.setStyle(style);
}

QString RoutePanel::summary() const {
    return m_summary->text();
}

routing::RouteOptions RoutePanel::options() const {
    routing::RouteOptions chosen;
    chosen.avoidStairs = m_stairs->isChecked();
    chosen.avoidElevator = m_lifts->isChecked();
    chosen.avoidEscalator = m_escalators->isChecked();
    chosen.avoidRestricted = m_restricted->isChecked();
    return chosen;
}

void RoutePanel::plan() {
    const std::uint64_t job = ++m_job;
    m_reason.clear();
    m_noRoute.reset();
    m_planning = m_building && m_from->chosen() && m_to->chosen();
    if (!m_planning) {
        m_model.setRoute(m_building, nullptr);
        summarise();
        Q_EMIT routeChanged();
        return;
    }
    summarise();
    m_background.run(
        [building = m_building, planner = m_planner, chosen = options(), from = *m_from->chosen(),
         to = *m_to->chosen()] {
            std::shared_ptr<const routing::Planner> with = planner;
            if (!with) with = routing::makeOptimalPlanner(building, chosen);
            Answer answer{with, with->plan({from, std::nullopt}, {to, std::nullopt}), std::nullopt};
            const auto start = building->regionIndex(from);
            const auto goal = building->regionIndex(to);
            if (!answer.route && start && goal && answer.route.error().code == ErrorCode::NotFound)
                answer.why = routing::RouteRules(building, chosen).noRoute(*start, *goal);
            return answer;
        },
        [this, job, building = m_building](Answer answer) {
            if (job != m_job) return;
            m_planner = answer.planner;
            planned(building, std::move(answer));
        });
}

void RoutePanel::planned(const std::shared_ptr<const building::Building>& building, Answer answer) {
    m_planning = false;
    Result<routing::Route>& route = answer.route;
    if (!route) m_reason = CoreWords::problem(route.error());
    m_noRoute = std::move(answer.why);
    m_model.setRoute(building, route ? std::make_shared<const routing::Route>(std::move(*route)) : nullptr);
    summarise();
    Q_EMIT routeChanged();
}

void RoutePanel::summarise() {
    QString text;
    if (!m_building)
        text = tr("No map is open.");
    else if (m_planning)
        text = tr("Looking for the way…");
    else if (!m_reason.isEmpty())
        text = tr("There is no way. %1")
                   .arg(m_noRoute ? NoRouteWords::sentence(*m_building, *m_noRoute) : m_reason);
    else if (const auto& route = m_model.route())
        text = tr("%1 m, about %n minute(s), through %2.", nullptr,
                  static_cast<int>(std::max(1L, std::lround(route->seconds / 60.0))))
                   .arg(QLocale().toString(route->lengthM, 'f', 0),
                        tr("%n door(s) and passage(s)", nullptr, static_cast<int>(route->accesses.size())));
    else
        text = tr("Choose where the route begins and ends, here or by the menu of a place on the plan.");
    m_summary->setText(text);
    m_summary->setAccessibleName(text);
    m_summary->setToolTip(text);
}

void RoutePanel::retranslate() {
    m_swap->setText(tr("Swa&p"));
    m_swap->setToolTip(tr("The way back: exchange where the route begins and ends"));
    m_avoid->setTitle(tr("Avoid"));
    const auto name = [](QCheckBox* box, const QString& text, const QString& tip) {
        box->setText(text);
        box->setToolTip(tip);
    };
    name(m_stairs, tr("stairs"), tr("Find a way without stairs"));
    name(m_lifts, tr("lifts"), tr("Find a way without lifts"));
    name(m_escalators, tr("escalators"), tr("Find a way without escalators"));
    name(m_restricted, tr("restricted regions"), tr("Find a way that is open to everyone"));
    m_table->setAccessibleName(tr("Sentences of the route"));
    m_table->setToolTip(tr("What the walker hears; choose a sentence to see its place on the plan"));
    m_model.retranslate();
    int width = 0; // the two fields stand below each other
    for (PlaceChooser* chooser : {m_from, m_to}) {
        chooser->label().setMinimumWidth(0);
        width = std::max(width, chooser->label().sizeHint().width());
    }
    for (PlaceChooser* chooser : {m_from, m_to}) chooser->label().setMinimumWidth(width);
}

void RoutePanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        summarise();
    }
    QWidget::changeEvent(event);
}

} // namespace farol::ui
