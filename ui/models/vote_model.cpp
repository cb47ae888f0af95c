#include "ui/models/vote_model.h"

#include "ui/convert/convert.h"
#include "ui/models/words.h"

#include <QLocale>

#include <array>

namespace farol::ui {

void VoteModel::setBuilding(std::shared_ptr<const building::Building> building) {
    beginResetModel();
    m_building = std::move(building);
    m_votes.clear();
    endResetModel();
}

void VoteModel::show(const std::vector<localisation::RegionVote>& votes) {
    replaceRows(m_votes, votes, ColumnCount);
}

const localisation::RegionVote* VoteModel::vote(int row) const {
    return row >= 0 && row < rowCount() ? &m_votes[static_cast<std::size_t>(row)] : nullptr;
}

int VoteModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_votes.size());
}

int VoteModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString VoteModel::why(const localisation::RegionVote& vote, const QString& separator) const {
    static const std::array<const char*, 7> kOrder{"Pmaxobj", "Rp", "Rv", "Ppos", "Pperc", "PID", "weight"};
    QStringList parts;
    for (const char* name : kOrder)
        if (const auto term = vote.terms.find(name); term != vote.terms.end() && term->second != 0.0)
            parts << QStringLiteral("%1 %2").arg(Words::voteTerm(name),
                                                 QLocale().toString(term->second, 'f', 2));
    if (!vote.evidence.empty())
        parts << tr("%n matching object(s)", nullptr, static_cast<int>(vote.evidence.size()));
    return parts.join(separator);
}

QVariant VoteModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const localisation::RegionVote& vote = m_votes[static_cast<std::size_t>(index.row())];
    if (role == RegionRole) return toQString(vote.region.value);
    if (role == ShareRole) return m_votes.front().vote > 0.0 ? vote.vote / m_votes.front().vote : 0.0;
    if (role == Qt::TextAlignmentRole && index.column() == Vote)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole && index.column() == Why) return why(vote, QStringLiteral("\n"));
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
    switch (index.column()) {
    case Place:
        return regionName(m_building.get(), vote.region);
    case Vote:
        return QLocale().toString(vote.vote, 'f', 2);
    case Why:
        return why(vote, QStringLiteral(" · "));
    default:
        return {};
    }
}

QVariant VoteModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    switch (section) {
    case Place:
        return tr("Place");
    case Vote:
        return tr("Votes");
    case Why:
        return tr("Made of");
    default:
        return {};
    }
}

} // namespace farol::ui
