#include "ui/models/detection_model.h"

#include "ui/convert/convert.h"
#include "ui/models/words.h"

#include <QLocale>

#include <cmath>

namespace farol::ui {

void DetectionModel::show(const std::vector<recognition::Detection>& detections,
                          const std::vector<recognition::Rejection>& rejections) {
    decltype(m_rows) rows(detections.begin(), detections.end());
    rows.insert(rows.end(), rejections.begin(), rejections.end());
    replaceRows(m_rows, std::move(rows), ColumnCount);
}

int DetectionModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int DetectionModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant DetectionModel::detectionText(const recognition::Detection& detection, int column) const {
    switch (column) {
    case What:
        return Phrasebook::kindWord(detection.kind);
    case Name:
        return Words::detectionName(detection);
    case Where:
        return Phrasebook::zoneWords(detection.zone());
    case Score:
        return tr("%1 %").arg(std::lround(detection.score * 100.0));
    default:
        return {};
    }
}

QVariant DetectionModel::rejectionText(const recognition::Rejection& rejection, int column) const {
    switch (column) {
    case What:
        return Phrasebook::kindWord(rejection.kind);
    case Name:
        return toQString(rejection.templateId.value);
    case Where:
        return tr("not accepted");
    case Score:
        return Words::rejection(rejection);
    default:
        return {};
    }
}

QVariant DetectionModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
    const auto& row = m_rows[static_cast<std::size_t>(index.row())];
    if (const auto* detection = std::get_if<recognition::Detection>(&row))
        return detectionText(*detection, index.column());
    return rejectionText(std::get<recognition::Rejection>(row), index.column());
}

QVariant DetectionModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    switch (section) {
    case What:
        return tr("What");
    case Name:
        return tr("Name");
    case Where:
        return tr("Where");
    case Score:
        return tr("Match");
    default:
        return {};
    }
}

} // namespace farol::ui
