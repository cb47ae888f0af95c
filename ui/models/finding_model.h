#pragma once
// What is wrong with a map: one branch for each rule, under it what the rule found.

#include "core/building/checks.h"

#include <QAbstractItemModel>
#include <QString>

#include <string>
#include <vector>

namespace farol::ui {

class FindingModel : public QAbstractItemModel {
    Q_OBJECT

public:
    enum Column { What, Features, ColumnCount };

    using QAbstractItemModel::QAbstractItemModel;

    void setFindings(std::vector<building::Finding> findings);
    /// nullptr for a branch.
    const building::Finding* findingAt(const QModelIndex& index) const;
    /// All in words: how grave it is and what the rule means, what was found, what to do, the features.
    QString explained(const QModelIndex& index) const;
    std::size_t count(building::Severity severity) const;
    static QString severityWord(building::Severity severity);
    void retranslate();

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& index) const override;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    struct Branch {
        building::Severity severity = building::Severity::Note;
        std::string rule;
        std::vector<building::Finding> findings;
    };
    static QString idsOf(const building::Finding& finding, std::size_t most);
    QString text(const Branch& branch, int column) const;

    std::vector<Branch> m_branches;
};

} // namespace farol::ui
