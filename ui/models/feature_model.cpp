#include "ui/models/feature_model.h"

#include "core/base/text.h"
#include "ui/convert/convert.h"
#include "ui/models/words.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace farol::ui {

namespace {

QVariant number(const std::optional<double>& value) {
    return value ? QVariant(*value) : QVariant();
}

} // namespace

FeatureModel::FeatureModel(QObject* parent) : QAbstractTableModel(parent), m_headings(headings()) {}

void FeatureModel::setBuilding(const std::shared_ptr<const building::Building>& building) {
    const int before = rowCount();
    const std::shared_ptr<const building::Building> old = m_building;
    m_building = building;
    const int after = rowCount();
    m_building = old;
    if (old && building && before == after && before > 0) { // an edit in place: the reader's row stays
        m_building = building;
        Q_EMIT dataChanged(index(0, 0), index(after - 1, columnCount() - 1));
        return;
    }
    beginResetModel();
    m_building = building;
    endResetModel();
}

void FeatureModel::setSort(Sort sort) {
    if (sort == m_sort) return;
    beginResetModel();
    m_sort = sort;
    m_headings = headings();
    endResetModel();
}

void FeatureModel::retranslate() {
    m_headings = headings();
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
    if (rowCount() > 0) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

QStringList FeatureModel::headings() const {
    switch (m_sort) {
    case Sort::Region:
        return {tr("Name"),  tr("Number"),     tr("Kind"), tr("Level"),      tr("Area (m²)"),
                tr("Doors"), tr("Neighbours"), tr("Seen"), tr("Restricted"), tr("Id")};
    case Sort::Access:
        return {tr("Kind"),  tr("One side"), tr("Other side"), tr("Level"), tr("Width (m)"),
                tr("Steps"), tr("One way"),  tr("Closed"),     tr("Shaft"), tr("Id")};
    case Sort::Landmark:
        break;
    }
    return {tr("Kind"),       tr("Text"),     tr("Region"),   tr("Level"),      tr("Faces (°)"),
            tr("Height (m)"), tr("Wide (m)"), tr("Tall (m)"), tr("Trained as"), tr("Id")};
}

int FeatureModel::rowCount(const QModelIndex& parent) const {
    if (parent.isValid() || !m_building) return 0;
    switch (m_sort) {
    case Sort::Region:
        return static_cast<int>(m_building->regions().size());
    case Sort::Access:
        return static_cast<int>(m_building->accesses().size());
    case Sort::Landmark:
        break;
    }
    return static_cast<int>(m_building->landmarks().size());
}

int FeatureModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_headings.size());
}

QVariant FeatureModel::regionValue(std::size_t row, int column) const {
    const building::Region& region = m_building->regions()[row];
    switch (column) {
    case 0:
        return toQString(region.name);
    case 1:
        return toQString(region.ref);
    case 2:
        return Words::regionKind(region.kind);
    case 3:
        return levelLabel(*m_building, region.level);
    case 4:
        return std::round(area(region.polygon) * 10.0) / 10.0;
    case 5:
        return static_cast<int>(m_building->accessesOf(row).size());
    case 6:
        return static_cast<int>(m_building->neighboursOf(row).size());
    case 7:
        return static_cast<int>(m_building->landmarksOf(row).size());
    case 8:
        return region.restricted;
    default:
        return toQString(region.id.value);
    }
}

QVariant FeatureModel::accessValue(std::size_t row, int column) const {
    const building::Access& access = m_building->accesses()[row];
    switch (column) {
    case 0:
        return Words::accessKind(access.kind);
    case 1:
        return access.regionA.empty() ? QString() : regionName(m_building.get(), access.regionA);
    case 2:
        return access.regionB.empty() ? QString() : regionName(m_building.get(), access.regionB);
    case 3:
        return levelLabel(*m_building, access.level);
    case 4:
        return number(access.widthM);
    case 5:
        return access.steps ? QVariant(*access.steps) : QVariant();
    case 6:
        return access.oneWay != building::OneWay::No;
    case 7:
        return access.closed;
    case 8:
        return toQString(access.shaft.value);
    default:
        return toQString(access.id.value);
    }
}

QVariant FeatureModel::landmarkValue(std::size_t row, int column) const {
    const building::Landmark& landmark = m_building->landmarks()[row];
    switch (column) {
    case 0:
        return Phrasebook::kindWord(landmark.kind);
    case 1:
        return toQString(landmark.text);
    case 2:
        return landmark.region.empty() ? QString() : regionName(m_building.get(), landmark.region);
    case 3:
        return levelLabel(*m_building, landmark.level);
    case 4:
        return landmark.heading ? QVariant(std::round(toDegrees(*landmark.heading))) : QVariant();
    case 5:
        return number(landmark.heightM);
    case 6:
        return number(landmark.widthM);
    case 7:
        return number(landmark.tallM);
    case 8:
        return toQString(landmark.templateId.value);
    default:
        return toQString(landmark.id.value);
    }
}

QVariant FeatureModel::value(int row, int column) const {
    const auto at = static_cast<std::size_t>(row);
    switch (m_sort) {
    case Sort::Region:
        return regionValue(at, column);
    case Sort::Access:
        return accessValue(at, column);
    case Sort::Landmark:
        break;
    }
    return landmarkValue(at, column);
}

QString FeatureModel::text(int row, int column) const {
    const QVariant found = value(row, column);
    switch (found.typeId()) {
    case QMetaType::Bool:
        return found.toBool() ? tr("yes") : QString();
    case QMetaType::Double:
        return QLocale().toString(found.toDouble(), 'g', 6);
    case QMetaType::Int:
        return QLocale().toString(found.toInt());
    default:
        return found.toString();
    }
}

double FeatureModel::levelOf(int row) const {
    const auto at = static_cast<std::size_t>(row);
    switch (m_sort) {
    case Sort::Region:
        return m_building->regions()[at].level;
    case Sort::Access:
        return m_building->accesses()[at].level;
    case Sort::Landmark:
        break;
    }
    return m_building->landmarks()[at].level;
}

QVariant FeatureModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole:
        return text(index.row(), index.column());
    case Qt::TextAlignmentRole: {
        const int type = value(index.row(), index.column()).typeId();
        const bool figure = type == QMetaType::Double || type == QMetaType::Int;
        return QVariant(figure ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignLeft | Qt::AlignVCenter);
    }
    case LevelRole:
        return levelOf(index.row());
    case OrderRole:
        return value(index.row(), index.column());
    case SearchRole: {
        QStringList words;
        for (int column = 0; column < columnCount(); ++column) words << text(index.row(), column);
        return toQString(foldedForMatching(toUtf8(words.join(QLatin1Char(' ')))));
    }
    default:
        return {};
    }
}

QVariant FeatureModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    return section >= 0 && section < m_headings.size() ? QVariant(m_headings[section]) : QVariant();
}

void FeatureFilter::setTyped(const QString& text) {
    m_words = toQString(foldedForMatching(toUtf8(text))).split(QLatin1Char(' '), Qt::SkipEmptyParts);
    invalidateFilter();
}

void FeatureFilter::setLevel(const std::optional<double>& ordinal) {
    if (ordinal == m_level) return;
    m_level = ordinal;
    invalidateFilter();
}

bool FeatureFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
    const QModelIndex index = sourceModel()->index(row, 0, parent);
    if (m_level && index.data(FeatureModel::LevelRole).toDouble() != *m_level) return false;
    if (m_words.isEmpty()) return true;
    const QString words = index.data(FeatureModel::SearchRole).toString();
    return std::all_of(m_words.begin(), m_words.end(),
                       [&](const QString& word) { return words.contains(word); });
}

bool FeatureFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
    const QVariant a = left.data(FeatureModel::OrderRole);
    const QVariant b = right.data(FeatureModel::OrderRole);
    const auto isText = [](const QVariant& value) { return value.typeId() == QMetaType::QString; };
    if (isText(a) && isText(b)) return naturalLess(toUtf8(a.toString()), toUtf8(b.toString()));
    if (!a.isValid() || !b.isValid()) return !a.isValid() && b.isValid();
    return a.toDouble() < b.toDouble();
}

} // namespace farol::ui
