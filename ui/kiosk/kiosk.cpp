#include "ui/kiosk/kiosk.h"

#include "core/building/info.h"
#include "ui/convert/convert.h"
#include "ui/demo/demo.h"
#include "ui/models/core_words.h"
#include "ui/speech/spoken.h"

#include <QDir>
#include <QFileInfo>
#include <QLocale>

#include <utility>

namespace farol::ui {

using guidance::Cue;

namespace {

/// A voice that never ends does not keep the kiosk from closing.
constexpr int kFarewellMs = 3000;

} // namespace

Kiosk::Kiosk(Settings& settings, KioskStart start, Walk::OpenSource open, SpeechDesk::MakeOutput makeOutput,
             std::unique_ptr<Chimes> chimes)
    : m_settings(settings),
      m_start(std::move(start)),
      m_simulated(std::make_shared<SimulatedWalks>()),
      m_walk(Demo::opener(m_simulated, std::move(open))),
      m_user(m_walk, m_simulated),
      m_log(m_start.utteranceFile),
      m_speech(settings, otherVoiceIfNeeded(std::move(makeOutput))),
      m_chimes(chimes ? std::move(chimes) : makeChimes()),
      m_machine(settings),
      m_memory(m_start.memoryFile) {
    settings.setMuted(false); // nobody could tell why it is silent
    m_walk.setVerbosity(settings.verbosity());
    m_farewell.setSingleShot(true);
    m_farewell.setInterval(kFarewellMs);
    connectWalk();
    connectMachine();
    connectVoice();
    connectMapWatch();
}

Kiosk::~Kiosk() = default;

SpeechDesk::MakeOutput Kiosk::otherVoiceIfNeeded(SpeechDesk::MakeOutput make) {
    return [this, make = std::move(make)](VoiceChoice choice) {
        if (m_anyVoice) choice.engine.clear();
        return make ? make(choice) : makeSpeechOutput(choice);
    };
}

/// Two that speak at once, and share one memory of the way, would mislead.
bool Kiosk::isTheOnlyOne() {
    if (m_start.memoryFile.isEmpty()) return true;
    QDir().mkpath(QFileInfo(m_start.memoryFile).absolutePath());
    m_lock = std::make_unique<QLockFile>(m_start.memoryFile + QStringLiteral(".lock"));
    m_lock->setStaleLockTime(0); // one that has crashed is known by its process
    return m_lock->tryLock(0) || m_lock->error() != QLockFile::LockFailedError;
}

void Kiosk::connectWalk() {
    connect(&m_walk, &Walk::mapChanged, this, &Kiosk::mapCame);
    connect(&m_walk, &Walk::problem, this, &Kiosk::trouble);
    connect(&m_walk, &Walk::stateChanged, this, &Kiosk::watchCamera);
    connect(&m_walk, &Walk::busyChanged, this, &Kiosk::watchCamera);
    connect(&m_walk, &Walk::walkBegan, this, [this] {
        m_sourceBroken = m_cameraLost = false;
        setDetail({});
    });
    connect(&m_walk, &Walk::cueCame, this, &Kiosk::cueCame);
    connect(&m_user, &SimulatedUser::movedTo, this,
            [this](const RegionId& region) { m_log.writeTruth(region); });
    connect(&m_walk, &Walk::stepped, this, [this](const session::NavigationStep& step) {
        m_log.setNow(step.percept.time);
        m_speech.setNow(step.percept.time, step.fix.region, step.progress.routeVersion);
        if (step.fix.region == m_region) return;
        m_region = step.fix.region;
        m_machine.setRegion(m_region);
        if (!m_region) return;
        m_lastRegion = m_region;
        remember();
    });
}

void Kiosk::connectMachine() {
    connect(&m_machine, &KioskMachine::said, &m_speech, &SpeechDesk::say);
    connect(&m_machine, &KioskMachine::asked, this, &Kiosk::answer);
    connect(&m_machine, &KioskMachine::destinationChosen, this,
            [this](const std::optional<RegionId>& region) {
                m_speech.forgetWay();
                m_walk.setDestination(region);
                if (region) {
                    m_user.setOut();
                    remember();
                } else {
                    m_user.stand();
                    m_memory.forget();
                    if (m_mapChanged) useChangedMap();
                }
            });
    connect(&m_machine, &KioskMachine::cameraWanted, this, [this] {
        if (m_cameraLost && m_walk.state() == session::RunState::Running) return; // it is tried all the time
        m_speech.reset(); // the new session counts its routes anew
        if (m_lastRegion) m_walk.setStart(m_lastRegion);
        m_walk.play();
    });
    connect(&m_machine, &KioskMachine::changed, this, &Kiosk::changed);
    connect(&m_machine, &KioskMachine::left, this, [this] {
        m_leaving = true;
        m_farewell.start();
    });
    connect(&m_farewell, &QTimer::timeout, this, [this] {
        close();
        Q_EMIT finished();
    });
}

void Kiosk::connectVoice() {
    m_walk.setVoiced(true);
    connect(&m_speech, &SpeechDesk::utteranceChanged, this, &Kiosk::utteranceCame);
    connect(&m_speech, &SpeechDesk::statusChanged, this, &Kiosk::voiceTrouble);
    connect(&m_settings, &Settings::guidanceChanged, this,
            [this] { m_walk.setVerbosity(m_settings.verbosity()); });
    connect(&m_settings, &Settings::languageChanged, this, [this] {
        installTranslation(m_settings.language());
        m_walk.followLanguage();
        m_machine.retranslate();
    });
}

void Kiosk::voiceTrouble(const QString& status, bool bad) {
    const QString detail = bad ? status : QString();
    if (detail == m_voiceDetail) return;
    m_voiceDetail = detail;
    Q_EMIT changed();
    if (!bad) return;
    m_chimes->play(Sound::Warning); // perhaps this is still heard
    if (m_anyVoice || m_settings.voice().engine.isEmpty()) return;
    m_anyVoice = true;
    // Not from within the voice that has just failed.
    QTimer::singleShot(0, this, [this] {
        if (m_closed) return;
        m_speech.rebuild();
        m_speech.say(spoken::joined({tr("The chosen voice does not work. This is another one."), m_unheard}));
    });
}

/// While somebody is led, the way is by the map he set out with.
void Kiosk::connectMapWatch() {
    connect(&m_mapWatch, &MapWatch::changed, this, [this] {
        if (m_closed || m_leaving) return;
        if (!m_machine.destination()) return useChangedMap();
        m_mapChanged = true;
        setDetail(tr("The map has been changed. The new one is used after this way."));
    });
    connect(&m_mapWatch, &MapWatch::changedBack, this, [this] {
        m_mapChanged = false;
        setDetail({});
    });
    connect(&m_mapWatch, &MapWatch::gone, this, [this] {
        const QString told = tr("The file of the map is gone. I keep the map that I have.");
        setDetail(told);
        m_machine.remark(told);
    });
    connect(&m_mapWatch, &MapWatch::unreadable, this, [this](const Error& error) {
        setDetail(CoreWords::problem(error));
        m_machine.remark(tr("The new map cannot be opened. I keep the old one."));
    });
}

void Kiosk::useChangedMap() {
    m_mapChanged = false;
    setDetail({});
    m_walk.loadMap(m_walk.mapName());
    if (!m_start.source.isEmpty()) m_walk.play(); // once it is loaded
}

void Kiosk::utteranceCame(const Utterance& utterance) {
    const UtteranceState state = utterance.state;
    const bool heard = state == UtteranceState::Speaking || state == UtteranceState::Shown;
    if (heard) Q_EMIT spoken(utterance.text);
    if (heard && !utterance.own) m_machine.told(utterance.cue);
    if (state == UtteranceState::Speaking && !utterance.own) m_walk.heard(utterance.cue);
    m_log.write(utterance);
    if (!m_log.trouble().isEmpty() && m_detail.isEmpty()) setDetail(m_log.trouble());
    // Who has only asked what the way is like does not set out on it.
    if (heard && !utterance.own && m_machine.guiding()) m_user.hear(utterance.cue);
    if (state == UtteranceState::Shown) m_unheard = utterance.text;
    const bool over = state == UtteranceState::Spoken || state == UtteranceState::Shown;
    if (m_leaving && over && utterance.own) m_farewell.start(0);
}

void Kiosk::press(const KioskKey& key) {
    m_log.writeKey(key);
    m_machine.press(key);
    m_log.endKey();
}

void Kiosk::holdBack() {
    m_log.writeHold();
    m_machine.holdBack();
    m_log.endKey();
}

void Kiosk::begin() {
    if (!isTheOnlyOne()) {
        m_opened = m_closed = true; // the memory is the other one's
        setDetail(tr("Another Farol kiosk of this user is running."));
        return m_machine.refuse(tr("Farol is already running here. I close this one. Goodbye."));
    }
    if (!m_log.trouble().isEmpty()) setDetail(m_log.trouble());
    if (!m_start.memoryFile.isEmpty() && !m_memory.writable()) memoryTrouble();
    m_machine.greet();
    if (m_start.map.isEmpty()) {
        setDetail(tr("No map was given (farol --kiosk --map FILE)."));
        m_machine.mapFailed();
        return;
    }
    if (!m_start.source.isEmpty()) m_walk.setSource({m_start.source, m_start.framesPerSecond});
    if (!m_start.library.isEmpty()) m_walk.loadLibrary(m_start.library);
    m_walk.loadMap(m_start.map);
    if (!m_start.source.isEmpty()) m_walk.play(); // once all is loaded
    watchCamera();
}

void Kiosk::mapCame() {
    const auto building = m_walk.building();
    const auto look = [&](const QString& where) -> std::optional<RegionId> {
        if (where.isEmpty()) return std::nullopt;
        const auto found = building::resolveWhere(*building, toUtf8(where));
        if (found) return found->region;
        setDetail(CoreWords::problem(found.error()));
        return std::nullopt;
    };
    m_mapWatch.follow(m_walk.mapName(), FileStamp::of(m_walk.mapName()), building);
    if (m_opened) { // the changed map: the user is where he was
        if (m_region && building->region(*m_region)) m_walk.setStart(m_region);
        m_machine.remark(tr("The map has been changed, and I use the new one."));
        return m_machine.setBuilding(building);
    }
    m_opened = true;
    if (const auto from = look(m_start.from)) m_walk.setStart(from);
    const std::optional<KioskMoment> left = m_memory.load();
    if (left && left->map == m_walk.mapName()) {
        const auto region =
            left->region.isEmpty() ? std::nullopt : std::optional(RegionId(toUtf8(left->region)));
        m_lastRegion = region; // should it crash again before it knows better
        m_machine.setWish(RegionId(toUtf8(left->destination)), true, region);
    } else if (const auto to = look(m_start.to)) {
        m_machine.setWish(*to, false, std::nullopt);
    }
    m_machine.setBuilding(building);
}

void Kiosk::cueCame(const Cue& cue) {
    if (cue.kind == guidance::CueKind::Warning) cameraCue(cue);
    if (!m_machine.wants(cue)) return;
    if (cue.chime != guidance::Chime::None)
        m_chimes->play(cue.chime == guidance::Chime::Fix ? Sound::Fix : Sound::Warning);
    m_speech.add(cue);
}

/// A camera that was unplugged is told at once, while the walk goes on and waits for it.
void Kiosk::cameraCue(const Cue& cue) {
    const bool lost = cue.reason == guidance::CueReason::CameraLost;
    if (!lost && cue.reason != guidance::CueReason::CameraBack) return;
    m_cameraLost = lost;
    setDetail(lost ? Phrasebook().sentence(cue) : QString());
    m_machine.setCamera(lost ? KioskCamera::Gone : KioskCamera::Running, true);
}

void Kiosk::watchCamera() {
    if (m_closed || m_leaving) return;
    const session::RunState state = m_walk.state();
    KioskCamera camera = KioskCamera::Opening;
    if (m_start.source.isEmpty())
        camera = KioskCamera::None;
    else if (!m_walk.loading()) {
        const bool runs = state == session::RunState::Running || state == session::RunState::Paused;
        const bool ended = state == session::RunState::Ended || state == session::RunState::Failed;
        if (m_cameraLost || (!runs && (m_sourceBroken || ended)))
            camera = KioskCamera::Gone;
        else if (runs)
            camera = KioskCamera::Running;
    }
    m_machine.setCamera(camera);
}

void Kiosk::trouble(Problem kind, const QString& message) {
    setDetail(message);
    switch (kind) {
    case Problem::Map:
        return m_machine.mapFailed();
    case Problem::Library:
        m_speech.say(tr("The landmarks cannot be loaded: I will hardly know where you are. Ask for help."));
        return m_walk.play();
    case Problem::Source:
    case Problem::Session:
        m_sourceBroken = true;
        return watchCamera();
    case Problem::Recording:
        return;
    }
}

void Kiosk::setDetail(const QString& detail) {
    if (detail == m_detail) return;
    m_detail = detail;
    Q_EMIT changed();
}

void Kiosk::remember() {
    const std::optional<RegionId>& destination = m_machine.destination();
    if (!destination || m_leaving || m_closed) return;
    const bool kept = m_memory.save({m_walk.mapName(), toQString(destination->value),
                                     m_lastRegion ? toQString(m_lastRegion->value) : QString()});
    if (!kept) memoryTrouble();
}

void Kiosk::memoryTrouble() {
    if (std::exchange(m_memoryTold, true)) return;
    m_machine.remark(memoryWords());
    Q_EMIT changed();
}

QString Kiosk::memoryWords() {
    return tr("The destination cannot be kept for a restart: the folder cannot be written.");
}

QString Kiosk::detail() const {
    if (!m_voiceDetail.isEmpty()) return m_voiceDetail;
    return m_detail.isEmpty() && m_memoryTold ? memoryWords() : m_detail;
}

void Kiosk::close() {
    if (m_closed) return;
    m_closed = true;
    m_memory.forget();
    m_walk.stop();
    m_settings.sync();
}

} // namespace farol::ui
