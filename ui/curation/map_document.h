#pragma once
// The map that the curator works on: opened or imported in the background, changed step by step with undo and
// redo, saved through core. GUI thread; the building itself is immutable and replaced by each change.

#include "core/building/building.h"
#include "core/building/checks.h"
#include "core/building/edit.h"
#include "core/building/import/importer.h"
#include "ui/convert/background.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <memory>
#include <optional>
#include <vector>

namespace farol::ui {

class MapDocument : public QObject {
    Q_OBJECT

public:
    enum class Work { None, Opening, Importing, Saving, Checking };

    explicit MapDocument(QObject* parent = nullptr);
    ~MapDocument() override; ///< waits for what is running and drops it

    /// A building file as it is; anything else is imported.
    void open(const QString& source);
    void importFrom(const QString& source, const building::ImportOptions& options);
    /// The map that was open stays. What is running goes on for a while, but its result counts for nothing.
    void cancel();
    /// Writes to `path` and keeps it; what is changed meanwhile stays unsaved.
    void save(const QString& path);
    void check(); ///< finds anew what is wrong

    /// False, with `refused` told, where the change makes no sense.
    bool push(const Result<building::Edit>& edit, const QString& text, bool nudge = false);

    Work work() const { return m_work; }
    const std::shared_ptr<const building::Building>& building() const { return m_building; }
    const std::vector<building::Finding>& findings() const { return m_findings; }
    bool findingsHold() const { return m_findingsOf == m_building; } ///< nothing was changed since
    const QString& path() const { return m_path; }                   ///< empty: not saved yet
    const QString& source() const { return m_source; }               ///< what was opened or imported
    bool imported() const { return m_imported; }
    bool unsaved() const { return m_building && (m_neverSaved || !m_undo.isClean()); }
    QUndoStack& undoStack() { return m_undo; }

Q_SIGNALS:
    void opened(); ///< another building
    void edited(const farol::building::Edit& edit);
    void findingsChanged();
    void workChanged();
    void stateChanged(); ///< path, unsaved
    void saved(const QString& path);
    void failed(const QString& message); ///< opening, importing or saving
    void refused(const QString& message);

private:
    friend class EditCommand;

    struct Loaded {
        std::shared_ptr<const building::Building> building;
        std::vector<building::Finding> findings;
        bool imported = false;
    };

    static Result<Loaded> load(const std::string& source);
    static Result<Loaded> import(const std::string& source, const building::ImportOptions& options);
    void begin(Work work);
    void loaded(const QString& source, Result<Loaded> result);
    void apply(const building::Edit& edit);

    std::shared_ptr<const building::Building> m_building;
    std::vector<building::Finding> m_findings;
    std::shared_ptr<const building::Building> m_findingsOf;
    QString m_path, m_source;
    bool m_imported = false, m_neverSaved = false;
    QUndoStack m_undo;
    Work m_work = Work::None;
    std::uint64_t m_job = 0; ///< whose result counts
    Background m_background; ///< last: its jobs use the rest
};

} // namespace farol::ui
