#pragma once
// The kiosk's parts put together: keys and words (KioskMachine), the walk, the voice, the sounds and what
// survives a crash. GUI thread; no widgets.

#include "ui/convert/map_watch.h"
#include "ui/demo/simulated_user.h"
#include "ui/kiosk/chimes.h"
#include "ui/kiosk/kiosk_machine.h"
#include "ui/kiosk/kiosk_memory.h"
#include "ui/kiosk/utterance_log.h"
#include "ui/live/speech_desk.h"
#include "ui/live/walk.h"
#include "ui/settings/settings.h"

#include <QLockFile>
#include <QObject>
#include <QString>
#include <QTimer>

#include <memory>

namespace farol::ui {

struct KioskStart {
    QString map, library, source; ///< empty: none
    double framesPerSecond = 0.0;
    QString from, to;      ///< WHERE of the command line
    QString memoryFile;    ///< see KioskMemory
    QString utteranceFile; ///< see UtteranceLog; empty: none
};

class Kiosk : public QObject {
    Q_OBJECT

public:
    /// `open`, `makeOutput` and `chimes` are replaced by tests. The settings must outlive the kiosk.
    Kiosk(Settings& settings, KioskStart start, Walk::OpenSource open = {},
          SpeechDesk::MakeOutput makeOutput = {}, std::unique_ptr<Chimes> chimes = {});
    ~Kiosk() override;

    void begin();
    void press(const KioskKey& key);
    void holdBack();
    /// The user goes, or the window is closed: not a crash.
    void close();

    KioskMachine& machine() { return m_machine; }
    Walk& walk() { return m_walk; }
    SimulatedUser& user() { return m_user; }
    SpeechDesk& speech() { return m_speech; }
    QString detail() const; ///< what is wrong, for those who help

Q_SIGNALS:
    void spoken(const QString& text); ///< is being said now, or shown for want of a voice
    void changed();                   ///< title, hint or detail
    void finished();                  ///< the last words are said

private:
    void connectWalk();
    void connectMachine();
    void connectVoice();
    void connectMapWatch();
    bool isTheOnlyOne();
    SpeechDesk::MakeOutput otherVoiceIfNeeded(SpeechDesk::MakeOutput make);
    void memoryTrouble();
    static QString memoryWords();
    void voiceTrouble(const QString& status, bool bad);
    void useChangedMap();
    void utteranceCame(const Utterance& utterance);
    void mapCame();
    void cueCame(const guidance::Cue& cue);
    void answer(KioskQuestion question);
    void watchCamera();
    void cameraCue(const guidance::Cue& cue);
    void trouble(Problem kind, const QString& message);
    void setDetail(const QString& detail);
    void remember();

    Settings& m_settings;
    KioskStart m_start;
    std::shared_ptr<SimulatedWalks> m_simulated;
    Walk m_walk;
    SimulatedUser m_user; ///< where the source is a simulation
    UtteranceLog m_log;
    bool m_anyVoice = false; ///< the chosen one does not work
    SpeechDesk m_speech;
    std::unique_ptr<Chimes> m_chimes;
    KioskMachine m_machine;
    KioskMemory m_memory;
    MapWatch m_mapWatch;
    std::unique_ptr<QLockFile> m_lock; ///< held while this kiosk is the only one of its user
    QTimer m_farewell;
    QString m_detail, m_voiceDetail;
    QString m_unheard; ///< was shown last, for want of a voice
    std::optional<RegionId> m_region;
    std::optional<RegionId> m_lastRegion; ///< known last, before a crash too
    bool m_sourceBroken = false, m_leaving = false, m_closed = false;
    bool m_cameraLost = false; ///< a live one, which is being tried again
    bool m_mapChanged = false; ///< the new one waits for the end of the way
    bool m_memoryTold = false;
    bool m_opened = false; ///< the command line has been followed
};

} // namespace farol::ui
