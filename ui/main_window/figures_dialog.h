#pragma once
// Figures of the walk and of the library as charts: votes over time, how long pictures took, how sure against
// how right, and from how far each landmark is found.

#include "ui/parts/chart_view.h"

#include <QDialog>

#include <vector>

class QListWidget;

namespace farol::ui {

class FiguresDialog : public QDialog {
    Q_OBJECT

public:
    explicit FiguresDialog(std::vector<Chart> charts, QWidget* parent = nullptr);

    QListWidget& list() { return *m_list; }
    ChartView& view() { return *m_view; }

private:
    void save();

    std::vector<Chart> m_charts;
    QListWidget* m_list;
    ChartView* m_view;
};

} // namespace farol::ui
