#pragma once
// The map that the curator works on: opened or imported in the background, changed step by step with undo and
// redo, saved through core. GUI thread; the building itself is immutable and replaced by each change.

#include "core/building/building.h"
#include "core/building/checks.h"
#include "core/building/edit.h"
#include "core/building/import/importer.h"
#include "ui/convert/background.h"
#include "ui/convert/map_watch.h"

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
    /// Writes to `path` and keeps it; what is changed meanwhile stays unsaved. What another program wrote
    /// into that file since it was read is not overwritten, unless `anyway`: `overtaken` is told instead.
    void save(const QString& path, bool anyway = false);
    /// What another program made of the map, as one step that can be taken back.
    void takeOutside();
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
    bool unsaved() const { return m_building && (m_neverSaved || m_onlyHere || !m_undo.isClean()); }
    QUndoStack& undoStack() { return m_undo; }

Q_SIGNALS:
    void opened(); ///< another building
    void edited(const farol::building::Edit& edit);
    void replaced(); ///< the same map, as another program made it, or as it was before
    void findingsChanged();
    void workChanged();
    void stateChanged(); ///< path, unsaved
    void saved(const QString& path);
    void failed(const QString& message); ///< opening, importing or saving
    void refused(const QString& message);
    void changedOutside(); ///< another program has changed the file: takeOutside() shows what it wrote
    void outsideSettled(); ///< the file says again what was read or written here
    void fileGone();
    void fileUnreadable(const QString& message);
    void overtaken(const QString& path); ///< not saved: another program has changed the file

private:
    friend class EditCommand;
    friend class OutsideCommand;

    struct Loaded {
        std::shared_ptr<const building::Building> building;
        std::vector<building::Finding> findings;
        bool imported = false;
        FileStamp stamp{};
    };
    struct Saved {
        FileStamp stamp;
        MapWatch::Map asRead;
        bool overtaken = false;
    };

    static Result<Loaded> load(const std::string& source);
    static Result<Loaded> import(const std::string& source, const building::ImportOptions& options);
    static Result<Saved> write(const building::Building& building, const QString& path,
                               const QString& origin);
    void begin(Work work);
    void connectWatch();
    void setOnlyHere(bool only);
    void written(const QString& path, const Saved& saved);
    void put(const std::shared_ptr<const building::Building>& building);
    void loaded(const QString& source, Result<Loaded> result);
    void apply(const building::Edit& edit);

    std::shared_ptr<const building::Building> m_building;
    std::vector<building::Finding> m_findings;
    std::shared_ptr<const building::Building> m_findingsOf;
    QString m_path, m_source;
    bool m_imported = false, m_neverSaved = false;
    bool m_onlyHere = false; ///< the file it was read from is gone, or no map any more
    QUndoStack m_undo;
    Work m_work = Work::None;
    std::uint64_t m_job = 0; ///< whose result counts
    MapWatch m_watch;
    MapWatch::Map m_outside; ///< what another program wrote; empty: nothing new
    FileStamp m_outsideStamp;
    Background m_background; ///< last: its jobs use the rest
};

} // namespace farol::ui
