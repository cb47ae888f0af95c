#pragma once
// What a walk was like until now: enough of it to look back, and to save it as a table. A long walk is kept
// more coarsely, so that it never takes more memory.

#include "core/session/percept.h"

#include <QByteArray>
#include <QObject>
#include <QString>

#include <memory>
#include <vector>

namespace farol::ui {

struct Moment {
    double time = 0.0;
    double confidence = 0.0;
    std::optional<RegionId> region;
    double latencyMs = 0.0;
    QStringList said;                               ///< cues since the moment before
    std::shared_ptr<const session::Snapshot> light; ///< without its picture
    QByteArray picture;                             ///< JPEG, smaller than it was
};

class WalkTimeline : public QObject {
    Q_OBJECT

public:
    static constexpr std::size_t kMost = 1500;

    using QObject::QObject;

    void clear();
    /// Moments follow each other by at least `spacing()` seconds; others are left out.
    void add(const session::Snapshot& snapshot);
    void noteSaid(const QString& text);
    double spacing() const { return m_spacing; }
    const std::vector<Moment>& moments() const { return m_moments; }
    /// As it was then, with its picture.
    std::shared_ptr<const session::Snapshot> snapshotAt(std::size_t index) const;
    /// Comma separated, with a header, for a spreadsheet.
    QByteArray csv(const building::Building* building) const;

Q_SIGNALS:
    void changed();

private:
    std::vector<Moment> m_moments;
    QStringList m_said;
    double m_spacing = 0.2;
};

} // namespace farol::ui
