#pragma once
// What the user chose, kept between runs. Typed: nobody else reads QSettings.

#include "core/guidance/cue_scheduler.h"
#include "core/recognition/landmark_recogniser.h"
#include "core/routing/route.h"
#include "ui/speech/phrasebook.h"
#include "ui/speech/speech_output.h"

#include <QByteArray>
#include <QObject>
#include <QSettings>
#include <QString>
#include <QStringList>

#include <memory>
#include <optional>

namespace farol::ui {

/// Colours: as the desktop has them, or as the user wants them.
enum class Look { System, Light, Dark };

enum class RecentKind { Map, Library, Source };

/// GUI thread. Values that a file holds but this program does not know fall back to the default.
class Settings : public QObject {
    Q_OBJECT

public:
    /// `file` empty: the user's own settings. Tests give a file.
    explicit Settings(const QString& file = {}, QObject* parent = nullptr);

    /// "en", "pt", …; empty: as the system says.
    QString language() const;
    void setLanguage(const QString& language);
    VoiceChoice voice() const;
    void setVoice(const VoiceChoice& voice);
    bool muted() const;
    void setMuted(bool muted);
    DirectionStyle directionStyle() const;
    void setDirectionStyle(DirectionStyle style);
    DistanceUnit unit() const;
    void setUnit(DistanceUnit unit);
    guidance::Verbosity verbosity() const;
    void setVerbosity(guidance::Verbosity verbosity);

    Look look() const;
    void setLook(Look look);
    bool firstRun() const; ///< nothing was ever chosen
    void setFirstRunDone();

    /// The options of a walk as the user changed them; what was not changed is as in `base`.
    guidance::GuidanceOptions guidanceOptions(guidance::GuidanceOptions base) const;
    routing::RouteOptions routeOptions(routing::RouteOptions base) const;
    recognition::RecogniserOptions recogniserOptions(recognition::RecogniserOptions base) const;
    /// One figure of these, by its key (option_fields.h); empty: as the program has it.
    std::optional<double> option(const QString& key) const;
    void setOption(const QString& key, const std::optional<double>& value);

    /// Everything here belongs to the profile of one user; the first has no name.
    QStringList profiles() const;
    QString profile() const { return m_profile; }
    /// Another profile, made as a copy of this one where there is none of that name yet. False for a name
    /// that can be no file.
    bool useProfile(const QString& name);

    /// How places are worked out; the first is the default.
    static QStringList localisers();
    QString localiser() const;
    void setLocaliser(const QString& name);

    /// The kiosk is used with two keys: one goes through the choices, the other takes one.
    bool twoKeys() const;
    void setTwoKeys(bool twoKeys);

    bool followLevel() const;
    void setFollowLevel(bool follow);
    bool showGrid() const;
    void setShowGrid(bool show);
    bool showRejected() const;
    void setShowRejected(bool show);
    double speed() const; ///< of playing, 0.25 to 8
    void setSpeed(double speed);
    QString recordingFolder() const; ///< where recordings are put; never empty
    void setRecordingFolder(const QString& folder);

    /// Newest first, at most eight, each once.
    QStringList recent(RecentKind kind) const;
    void addRecent(RecentKind kind, const QString& item);
    void clearRecent(RecentKind kind);

    /// Where unfinished work is kept: with the user's own data, or beside a settings file that was given.
    QString workFolder() const;
    QByteArray windowGeometry() const;
    void setWindowGeometry(const QByteArray& geometry);
    QByteArray splitter(const QString& name) const;
    void setSplitter(const QString& name, const QByteArray& state);
    /// The floor-plan images of a map, by the map's file, as FloorPictures writes them.
    QByteArray floorPictures(const QString& map) const;
    void setFloorPictures(const QString& map, const QByteArray& pictures);
    void sync() { m_store->sync(); }

Q_SIGNALS:
    void languageChanged();
    void voiceChanged();
    void mutedChanged(bool muted);
    void guidanceChanged(); ///< direction style, unit or verbosity
    void displayChanged();  ///< grid, rejected candidates, following
    void recentChanged();
    void lookChanged();
    void profileChanged();

private:
    template <class T>
    bool store(const QString& key, const T& value);

    std::unique_ptr<QSettings> m_store;
    std::unique_ptr<QSettings> openProfile(const QString& name) const;
    QString profileFolder() const;

    QString m_mainFile, m_profile;
    bool m_own = true; ///< the user's own settings
};

} // namespace farol::ui
