#include "ui/models/finding_model.h"

#include "ui/convert/convert.h"
#include "ui/models/core_words.h"
#include "ui/models/rule_words.h"

#include <QLocale>

#include <algorithm>

namespace farol::ui {

namespace {

/// A sentence that names all its features needs no list of them.
bool namesAll(const building::Finding& finding) {
    const std::vector<building::Argument>& said = finding.said.arguments;
    return std::all_of(finding.ids.begin(), finding.ids.end(), [&](const std::string& id) {
        return std::any_of(said.begin(), said.end(), [&](const building::Argument& argument) {
            return argument.is == building::Argument::Is::Text && argument.text == id;
        });
    });
}

constexpr quintptr kBranch = 0; // internal ids: 0 for a branch, its row + 1 for what is under it

} // namespace

void FindingModel::setFindings(std::vector<building::Finding> findings) {
    beginResetModel();
    m_branches.clear();
    for (building::Finding& finding : findings) {
        const auto same = [&](const Branch& branch) {
            return branch.rule == finding.rule && branch.severity == finding.severity;
        };
        auto place = std::find_if(m_branches.begin(), m_branches.end(), same);
        if (place == m_branches.end())
            place = m_branches.insert(m_branches.end(), {finding.severity, finding.rule, {}});
        place->findings.push_back(std::move(finding));
    }
    std::stable_sort(m_branches.begin(), m_branches.end(),
                     [](const Branch& a, const Branch& b) { return a.severity < b.severity; });
    endResetModel();
}

const building::Finding* FindingModel::findingAt(const QModelIndex& index) const {
    if (!index.isValid() || index.internalId() == kBranch) return nullptr;
    return &m_branches[index.internalId() - 1].findings[static_cast<std::size_t>(index.row())];
}

std::size_t FindingModel::count(building::Severity severity) const {
    std::size_t total = 0;
    for (const Branch& branch : m_branches)
        if (branch.severity == severity) total += branch.findings.size();
    return total;
}

QString FindingModel::severityWord(building::Severity severity) {
    switch (severity) {
    case building::Severity::Error:
        return tr("Error");
    case building::Severity::Warning:
        return tr("Warning");
    case building::Severity::Note:
        break;
    }
    return tr("Note");
}

QString FindingModel::idsOf(const building::Finding& finding, std::size_t most) {
    QStringList ids;
    for (std::size_t i = 0; i < finding.ids.size() && i < most; ++i) ids << CoreWords::id(finding.ids[i]);
    if (finding.ids.size() > most)
        ids << tr("and %n more", nullptr, static_cast<int>(finding.ids.size() - most));
    return ids.join(QStringLiteral(", "));
}

QString FindingModel::explained(const QModelIndex& index) const {
    if (!index.isValid()) return {};
    const building::Finding* finding = findingAt(index);
    const auto row = static_cast<std::size_t>(finding ? index.internalId() - 1 : index.row());
    const Branch& branch = m_branches[row];
    QStringList lines{tr("%1: %2").arg(severityWord(branch.severity), RuleWords::title(branch.rule))};
    if (finding) lines << CoreWords::sentence(finding->said);
    if (const QString fix = RuleWords::fix(branch.rule); !fix.isEmpty()) lines << fix;
    if (finding && !namesAll(*finding)) lines << idsOf(*finding, 30);
    lines << tr("Rule: %1").arg(toQString(branch.rule));
    return lines.join(QLatin1Char('\n'));
}

void FindingModel::retranslate() {
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
    if (!m_branches.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

QModelIndex FindingModel::index(int row, int column, const QModelIndex& parent) const {
    if (!hasIndex(row, column, parent)) return {};
    return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) + 1 : kBranch);
}

QModelIndex FindingModel::parent(const QModelIndex& index) const {
    if (!index.isValid() || index.internalId() == kBranch) return {};
    return createIndex(static_cast<int>(index.internalId() - 1), 0, kBranch);
}

int FindingModel::rowCount(const QModelIndex& parent) const {
    if (!parent.isValid()) return static_cast<int>(m_branches.size());
    if (parent.internalId() != kBranch || parent.column() != 0) return 0;
    return static_cast<int>(m_branches[static_cast<std::size_t>(parent.row())].findings.size());
}

int FindingModel::columnCount(const QModelIndex& /*parent*/) const {
    return ColumnCount;
}

QString FindingModel::text(const Branch& branch, int column) const {
    if (column == Features) {
        std::size_t features = 0;
        for (const building::Finding& finding : branch.findings)
            features += std::max<std::size_t>(finding.ids.size(), 1);
        return QLocale().toString(static_cast<qulonglong>(features));
    }
    return tr("%1: %2").arg(severityWord(branch.severity), RuleWords::title(branch.rule));
}

QVariant FindingModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    if (role == Qt::ToolTipRole) return explained(index);
    if (role != Qt::DisplayRole) return {};
    const building::Finding* finding = findingAt(index);
    if (!finding) return text(m_branches[static_cast<std::size_t>(index.row())], index.column());
    // Its sentence is long, and much the same in each row: it stands in the words below.
    if (index.column() == What)
        return finding->ids.empty() ? CoreWords::sentence(finding->said) : idsOf(*finding, 8);
    return finding->ids.size() > 1 ? QLocale().toString(static_cast<qulonglong>(finding->ids.size()))
                                   : QString();
}

QVariant FindingModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    return section == What ? tr("What was found") : tr("How many");
}

} // namespace farol::ui
