#pragma once
// A landmark that is being taught, as it is kept on disk after every step, so that nothing is lost when the
// program or the computer stops.

#include "core/base/error.h"
#include "core/base/geometry.h"
#include "core/base/kind.h"

#include <QLockFile>
#include <QString>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace farol::ui {

struct DraftView {
    std::string bytes; ///< of the photograph's file
    Quad outline{};
};

struct TeachDraft {
    QString library;      ///< the file it will be part of
    QString id, name;     ///< `id` is what maps call it
    bool extends = false; ///< more views of a template that the library has already
    Kind kind = Kind::Sign;
    double widthM = 0.0, heightM = 0.0; ///< 0: not known
    std::vector<DraftView> views;       ///< new ones
    int step = 0;                       ///< of the wizard

    bool worthKeeping() const { return !name.isEmpty() || !views.empty(); }
};

/// One draft in a folder of its own: draft.json and the photographs. A second program that runs at the same
/// time has another folder, so that they do not overwrite each other's; what was left there by a crash is
/// found again.
class DraftStore {
public:
    explicit DraftStore(const QString& folder);

    Result<void> save(const TeachDraft& draft) const;
    /// Empty where there is none. A photograph that is missing or damaged is left out.
    std::optional<TeachDraft> load() const;
    void clear() const;

private:
    QString m_folder;
    std::unique_ptr<QLockFile> m_lock; ///< held while this program runs
};

} // namespace farol::ui
