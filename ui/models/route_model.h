#pragma once
// A route as a list of what to do, in the words that a walker hears.

#include "core/building/building.h"
#include "core/routing/route.h"
#include "ui/speech/phrasebook.h"

#include <QAbstractTableModel>
#include <QStringList>

#include <memory>

namespace farol::ui {

class RouteModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Distance, Sentence, ColumnCount };

    using QAbstractTableModel::QAbstractTableModel;

    void setRoute(std::shared_ptr<const building::Building> building,
                  std::shared_ptr<const routing::Route> route); ///< null: none
    void setStyle(DirectionStyle style);
    const routing::Manoeuvre& at(int row) const;
    const std::shared_ptr<const routing::Route>& route() const { return m_route; }
    void retranslate();
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QString sentence(const routing::Manoeuvre& manoeuvre) const;

    std::shared_ptr<const building::Building> m_building;
    std::shared_ptr<const routing::Route> m_route;
    Phrasebook m_phrasebook;
};

} // namespace farol::ui
