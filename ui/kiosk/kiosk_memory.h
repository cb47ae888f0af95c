#pragma once
// What survives a crash of the kiosk: where the user was, and where to.

#include <QString>

#include <optional>

namespace farol::ui {

struct KioskMoment {
    QString map, destination, region; ///< ids; empty: none
};

/// One small file, replaced as a whole. It exists while the kiosk runs with a destination, so that one that
/// is found at the start was left by a crash.
class KioskMemory {
public:
    explicit KioskMemory(QString file) : m_file(std::move(file)) {}

    std::optional<KioskMoment> load() const; ///< empty also for a file that cannot be read
    /// False: it could not be written (read-only folder, full disk); the old file is whole.
    bool save(const KioskMoment& moment) const;
    bool writable() const; ///< a try that leaves nothing behind
    void forget() const;

private:
    QString m_file;
};

} // namespace farol::ui
