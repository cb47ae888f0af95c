#pragma once
// The templates of a library as a table, and who is taken for whom as a square.

#include "core/recognition/library_check.h"
#include "ui/convert/background.h"

#include <QAbstractTableModel>
#include <QHash>
#include <QImage>

#include <memory>
#include <vector>

namespace farol::ui {

class LibraryModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Name, KindWord, Size, Views, Health, ColumnCount };
    using Library = std::shared_ptr<const recognition::LandmarkLibrary>;

    explicit LibraryModel(QObject* parent = nullptr);

    void setLibrary(Library library); ///< pictures come a little later
    void setChecks(const std::vector<recognition::TemplateCheck>& checks);
    const Library& library() const { return m_library; }
    const recognition::TemplateCheck* check(const TemplateId& id) const;
    int rowOf(const TemplateId& id) const; ///< -1: none

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QString text(const recognition::Template& entry, int column) const;
    void makePictures();

    Library m_library;
    std::vector<recognition::TemplateCheck> m_checks;
    QHash<QString, QImage> m_pictures; ///< by template and photograph
    std::uint64_t m_job = 0;
    Background m_background; ///< last: its jobs use the rest
};

/// Row: whose photograph was shown. Column: what was seen in it. On the diagonal how many were found again.
class ConfusionModel : public QAbstractTableModel {
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    void setChecks(std::vector<recognition::TemplateCheck> checks);
    const std::vector<recognition::TemplateCheck>& checks() const { return m_checks; }
    int confusions() const; ///< pairs
    /// Comma separated, with a header, for a spreadsheet.
    QByteArray csv() const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    int times(int row, int column) const;

    std::vector<recognition::TemplateCheck> m_checks;
};

} // namespace farol::ui
