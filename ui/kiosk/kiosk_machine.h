#pragma once
// The kiosk without a screen: keys in, spoken words and commands out. It knows neither widgets nor the walk.

#include "core/guidance/cue.h"
#include "ui/kiosk/kiosk_keys.h"
#include "ui/kiosk/kiosk_places.h"
#include "ui/settings/settings.h"

#include <QCoreApplication>
#include <QObject>
#include <QString>
#include <QTimer>

#include <memory>
#include <optional>
#include <vector>

namespace farol::ui {

enum class KioskState {
    Loading, ///< no map, or none with places
    Choosing,
    Typing,
    Preview,
    Walking,
    Arrived,
    StopQuestion,
    LeaveQuestion,
    Help,
    Leaving
};

enum class KioskCamera { None, Opening, Running, Gone };

/// What the walk is asked; the answer comes as a cue.
enum class KioskQuestion { WhereAmI, AroundMe, Next, Remaining, Repeat, Preview };

class KioskMachine : public QObject {
    Q_OBJECT

public:
    explicit KioskMachine(Settings& settings, QObject* parent = nullptr);

    void greet();
    void setBuilding(std::shared_ptr<const building::Building> building);
    void mapFailed();
    /// Told once, behind the next words about places: nothing that concerns the next step.
    void remark(const QString& text);
    void refuse(const QString& why); ///< these are the last words
    /// `told`: the walk itself says it.
    void setCamera(KioskCamera camera, bool told = false);
    void setRegion(const std::optional<RegionId>& region); ///< where the user is, as far as known
    /// A destination for when the map is there: asked for on the command line, or left by a crash.
    void setWish(const RegionId& destination, bool afterCrash, const std::optional<RegionId>& region);
    void press(const KioskKey& key);
    void holdBack(); ///< the Escape key was held down: leaves
    /// Is this cue to be spoken now? A refusal changes the state.
    bool wants(const guidance::Cue& cue);
    /// It is being spoken, or shown instead: who has heard of the arrival is there. What waits may yet
    /// expire.
    void told(const guidance::Cue& cue);
    void answered() { m_patience.stop(); } ///< what was asked has been told
    void retranslate();

    KioskState state() const { return m_state; }
    bool guiding() const; ///< on the way, or just there: what is spoken is to be done
    bool quiet() const { return m_quiet; }
    const std::optional<RegionId>& destination() const { return m_destination; }
    QString title() const; ///< of the state, for the screen
    QString hint() const;  ///< the few keys of the state, for the screen
    /// How long each order of the look around stands, and how long an answer may take without a word.
    void setPace(int sweepMs, int patienceMs);

Q_SIGNALS:
    void said(const QString& text);
    void asked(farol::ui::KioskQuestion question);
    void destinationChosen(const std::optional<farol::RegionId>& region);
    void cameraWanted(); ///< try it again
    void changed();      ///< state, title or hint
    void left();         ///< the last words have been said

private:
    /// One thing that the two-key way offers.
    struct Option {
        QString words;
        KioskCommand command = KioskCommand::None;
        int category = -1, place = -1;
    };

    void say(const QString& text);
    void setState(KioskState state);
    KioskState underlying() const;
    void perform(KioskCommand command);
    void performAsked(KioskCommand command);
    bool performSetting(KioskCommand command);
    void loading(KioskCommand command);
    void choosing(KioskCommand command);
    void preview(KioskCommand command);
    void walking(KioskCommand command);
    void arrived(KioskCommand command);
    void question(KioskCommand command);
    void help(KioskCommand command);
    bool typing(const KioskKey& key, KioskCommand command);
    void moveTo(int index);
    void changeCategory(int by);
    void startTyping(const QString& first);
    void type(const QString& text);
    void endTyping();
    void confirm();
    void toChoosing();
    void toPreview(const RegionId& region);
    void toWalking();
    void ask(KioskQuestion question);
    void startSweep();
    void stepSweep();
    void stopSweep();
    void wishGranted();

    void scanOptions();
    void chooseOption();
    std::vector<Option> options() const;
    std::vector<Option> choosingOptions() const;
    static Option optionOf(KioskCommand command);

    QString withRemarks(const QString& words);
    QString stateWords() const;
    QString chooseWords() const;
    QString placeWords() const;
    QString questionWords() const;
    QString previewWords() const;
    QString cameraWords() const;
    QString settingWords(KioskCommand command) const;
    QString typedWords() const;
    QString destinationWords() const;

    Settings& m_settings;
    std::shared_ptr<const building::Building> m_building;
    KioskPlaces m_places;
    KioskState m_state = KioskState::Loading;
    KioskState m_before = KioskState::Loading; ///< of help and questions
    KioskCamera m_camera = KioskCamera::None;
    bool m_mapFailed = false;
    bool m_cameraWasGone = false; ///< and has not come back yet
    bool m_quiet = false;
    bool m_wayTold = false; ///< since the destination was chosen
    bool m_arrivalSure = false;
    std::optional<RegionId> m_destination, m_region;
    struct Wish {
        RegionId destination;
        bool afterCrash = false;
        std::optional<RegionId> region;
    };
    std::optional<Wish> m_wish;
    QTimer m_patience, m_sweepTimer;
    int m_sweep = 0; ///< order of the look around that was told last; 0: none
    int m_option = -1;
    bool m_inCategory = false;
    QStringList m_remarks;
};

/// Everything the kiosk says of itself; sentences of the way are the Phrasebook's.
class KioskWords {
    Q_DECLARE_TR_FUNCTIONS(farol::ui::KioskWords)

public:
    static QString key(KioskCommand command);       ///< "W"
    static QString meaning(KioskCommand command);   ///< "where am I"
    static QString explained(KioskCommand command); ///< "W: where am I."
    static QString allKeys();
    static QString numberPad();
    static QString unknownKey();
    static QString verbosity(guidance::Verbosity verbosity);
    static QString style(DirectionStyle style);
    static QString unit(DistanceUnit unit);
};

} // namespace farol::ui
