#pragma once
// Choosing a place by typing part of its name, number or level.

#include "ui/models/region_filter.h"
#include "ui/models/region_model.h"

#include <QWidget>

#include <optional>

class QLabel;
class QLineEdit;

namespace farol::ui {

class PlaceChooser : public QWidget {
    Q_OBJECT

public:
    enum class Purpose { Destination, Start, From, To, Side };

    PlaceChooser(RegionModel& regions, Purpose purpose, QWidget* parent = nullptr);

    /// Shows a choice without telling it again.
    void setChosen(const std::optional<RegionId>& region);
    const std::optional<RegionId>& chosen() const { return m_chosen; }
    void focusAndOpen();
    QLineEdit& edit() { return *m_edit; }
    QLabel& label() { return *m_label; }
    QString hint() const;
    /// Screen readers are told of the cross in a line that can be cleared; Qt gives it no name.
    static void nameClearButton(const QLineEdit& edit);

Q_SIGNALS:
    void placeChosen(const std::optional<farol::RegionId>& region);

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void choose(const std::optional<RegionId>& region);
    void confirmTyped();
    void openList();
    void tell(const QString& hint);
    void retranslate();

    RegionModel& m_regions;
    RegionFilter m_filter;
    Purpose m_purpose;
    QLabel* m_label;
    QLineEdit* m_edit;
    QLabel* m_hint;
    std::optional<RegionId> m_chosen;
};

} // namespace farol::ui
