#include "ui/models/vote_detail_model.h"

#include "ui/convert/convert.h"
#include "ui/models/words.h"

#include <QLocale>

#include <algorithm>
#include <array>

namespace farol::ui {

namespace {

// As the paper makes the vote: first what was seen, then what was expected, then the result.
constexpr std::array<const char*, 17> kOrder{"Nobj", "Np",    "Pobj",   "Pdir", "Pf",     "Pmaxobj",
                                             "Ppos", "Pperc", "PID",    "Preg", "Rp",     "Nv",
                                             "Rv",   "Vreg",  "weight", "lost", "against"};

} // namespace

void VoteDetailModel::setBuilding(std::shared_ptr<const building::Building> building) {
    m_building = std::move(building);
    show(nullptr, {});
}

/// When it was seen last, by the same template, text or kind.
QString VoteDetailModel::seen(const building::Landmark& landmark,
                              const std::deque<localisation::Observation>& history) const {
    for (auto one = history.rbegin(); one != history.rend(); ++one) {
        const recognition::Detection& detection = one->detection;
        const bool same = !landmark.templateId.empty() ? detection.templateId == landmark.templateId
                          : !landmark.text.empty()     ? detection.text == landmark.text
                                                       : detection.kind == landmark.kind;
        if (same) return tr("seen at %1").arg(clockText(one->time));
    }
    return {};
}

void VoteDetailModel::show(const localisation::RegionVote* vote,
                           const std::deque<localisation::Observation>& history) {
    std::vector<Row> rows;
    if (vote != nullptr) {
        const QLocale locale;
        const bool filter = vote->terms.count("weight") > 0;
        for (const char* name : kOrder)
            if (const auto term = vote->terms.find(name); term != vote->terms.end())
                rows.push_back({filter ? tr("filter") : QString::fromLatin1(name),
                                locale.toString(term->second, 'f', 2), Words::voteTerm(name)});
        std::vector<LandmarkId> evidence = vote->evidence;
        if (filter && m_building) // it weighs all it saw: what hangs in this place is told
            for (const building::Landmark& landmark : m_building->landmarks())
                if (landmark.region == vote->region && !seen(landmark, history).isEmpty())
                    evidence.push_back(landmark.id);
        for (const LandmarkId& id : evidence) {
            const building::Landmark* landmark = m_building ? m_building->landmark(id) : nullptr;
            if (landmark != nullptr)
                rows.push_back(
                    {tr("speaks for it"), seen(*landmark, history), Words::about(*m_building, *landmark)});
        }
        if (evidence.empty())
            rows.push_back({tr("speaks for it"), {}, tr("none of the objects last seen stands there")});
    }
    replaceRows(m_rows, std::move(rows), ColumnCount);
}

int VoteDetailModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int VoteDetailModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant VoteDetailModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
    const Row& row = m_rows[static_cast<std::size_t>(index.row())];
    return index.column() == What ? row.what : index.column() == Figure ? row.figure : row.meaning;
}

QVariant VoteDetailModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    switch (section) {
    case What:
        return tr("Term");
    case Figure:
        return tr("Figure");
    case Meaning:
        return tr("Meaning");
    default:
        return {};
    }
}

} // namespace farol::ui
