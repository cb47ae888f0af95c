#pragma once
// The whole library: its templates, the views of the chosen one, and the report of who is taken for whom.

#include "ui/training/library_model.h"

#include <QWidget>

#include <atomic>
#include <optional>
#include <vector>

class QLabel;
class QListWidget;
class QProgressBar;
class QPushButton;
class QSplitter;
class QTabWidget;
class QTableView;

namespace farol::ui {

class LibraryPanel : public QWidget {
    Q_OBJECT

public:
    explicit LibraryPanel(QWidget* parent = nullptr);
    ~LibraryPanel() override; ///< a check that runs is given up

    void setLibrary(const LibraryModel::Library& library); ///< null: none
    void select(const TemplateId& id);
    std::optional<std::size_t> chosen() const; ///< index of the template
    std::vector<std::size_t> chosenViews() const;
    void check(); ///< the whole library, in the background
    bool checking() const { return m_checking; }
    void showReport();

    QTableView& table() { return *m_table; }
    QListWidget& views() { return *m_views; }
    QTabWidget& tabs() { return *m_tabs; }
    QTableView& matrix() { return *m_matrix; }
    LibraryModel& model() { return m_model; }
    ConfusionModel& confusion() { return m_confusion; }
    QSplitter& halves() { return *m_halves; }
    QString reportText() const;
    QString healthText() const;

Q_SIGNALS:
    void chosenChanged();
    void teachWanted(); ///< views for the chosen template
    void csvWanted();
    void checkWanted();

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    QWidget* buildReport();
    void showChosen();
    void fillViews();
    QStringList foundWords() const;
    void refreshReport();
    void retranslate();

    LibraryModel m_model;
    ConfusionModel m_confusion;
    QSplitter* m_halves;
    QLabel *m_title, *m_detailTitle, *m_health, *m_report, *m_viewsTitle;
    QTableView *m_table, *m_matrix;
    QListWidget* m_views;
    QTabWidget* m_tabs;
    QPushButton *m_checkAll, *m_csv;
    QProgressBar* m_progress;
    std::vector<recognition::TemplateCheck> m_checks;
    LibraryModel::Library m_checked; ///< of which library the report is
    bool m_checking = false, m_settingUp = false;
    std::uint64_t m_job = 0, m_pictureJob = 0;
    std::shared_ptr<std::atomic<bool>> m_stop;
    std::shared_ptr<std::atomic<int>> m_done, m_all;
    Background m_background; ///< last: its jobs use the rest
};

} // namespace farol::ui
