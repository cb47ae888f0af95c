#include "ui/models/route_model.h"

#include "ui/convert/convert.h"

#include <QLocale>

namespace farol::ui {

void RouteModel::setRoute(std::shared_ptr<const building::Building> building,
                          std::shared_ptr<const routing::Route> route) {
    beginResetModel();
    m_building = std::move(building);
    m_route = std::move(route);
    endResetModel();
}

void RouteModel::setStyle(DirectionStyle style) {
    m_phrasebook.setStyle(style);
    retranslate();
}

const routing::Manoeuvre& RouteModel::at(int row) const {
    return m_route->manoeuvres[static_cast<std::size_t>(row)];
}

void RouteModel::retranslate() {
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
    if (rowCount() > 0) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

int RouteModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !m_route ? 0 : static_cast<int>(m_route->manoeuvres.size());
}

int RouteModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString RouteModel::sentence(const routing::Manoeuvre& manoeuvre) const {
    const auto nameOf = [this](const RegionId& id) {
        const building::Region* region = m_building->region(id);
        return region ? building::spokenName(*region) : std::string();
    };
    if (manoeuvre.kind == routing::ManoeuvreKind::Start)
        return tr("Start in %1.").arg(regionName(m_building.get(), manoeuvre.into));
    guidance::Cue cue;
    cue.kind = guidance::CueKind::Act;
    cue.manoeuvre = manoeuvre;
    cue.region = manoeuvre.into;
    cue.regionName = nameOf(manoeuvre.into);
    if (manoeuvre.into != manoeuvre.from || manoeuvre.kind == routing::ManoeuvreKind::Arrive)
        cue.intoName = cue.regionName;
    if (manoeuvre.targetLevel != manoeuvre.level)
        cue.levelName = toUtf8(levelLabel(*m_building, manoeuvre.targetLevel));
    return m_phrasebook.sentence(cue);
}

QVariant RouteModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    if (role == Qt::TextAlignmentRole && index.column() == Distance)
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
    const routing::Manoeuvre& manoeuvre = at(index.row());
    if (index.column() == Distance) return tr("%1 m").arg(QLocale().toString(manoeuvre.atM, 'f', 0));
    return sentence(manoeuvre);
}

QVariant RouteModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    return section == Distance ? tr("After") : tr("What to do");
}

} // namespace farol::ui
