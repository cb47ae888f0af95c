#pragma once
// Buildings, snapshots, sources and voices made by hand, for tests of the window.

#include "core/building/building.h"
#include "core/session/percept.h"
#include "ui/speech/speech_output.h"

#include <QStringList>

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>

namespace farol::ui::test {

/// Two floors: on 0 a corridor "Main corridor" (10 x 2 m) with "Room 1" and "Café" above it and a stairwell;
/// on 1 a "Library". Doors, stairs, two landmarks, a wall.
std::shared_ptr<const building::Building> handMadeBuilding();
/// In the corridor of that building, on the way to the library, with a door in the picture.
std::shared_ptr<const session::Snapshot> handMadeSnapshot();

/// Plain grey pictures, one each `period` seconds.
class FakeSource : public capture::FrameSource {
public:
    FakeSource(std::uint64_t frames, double period) : m_frames(frames), m_period(period) {}

    std::optional<capture::Frame> next() override;
    bool live() const override { return false; }
    std::optional<std::uint64_t> frameCount() const override { return m_frames; }
    double framePeriod() const override { return m_period; }
    std::string description() const override { return "grey pictures"; }

private:
    std::uint64_t m_frames;
    double m_period;
    std::uint64_t m_next = 0;
};

/// Of a camera; held by the test, which pulls it out.
class Cable {
public:
    void setPlugged(bool plugged);
    void pull(); ///< for good: the camera gives up
    void wake() { m_changed.notify_all(); }
    enum class State { Plugged, Unplugged, Gone };
    /// As it is after one picture's time.
    State next();
    /// Once it is plugged in again, or `over` is true.
    State whenNotUnplugged(const std::function<bool()>& over);

private:
    std::mutex m_mutex;
    std::condition_variable m_changed;
    State m_state = State::Plugged;
};

/// A live camera at a cable.
class CameraOnCable : public capture::FrameSource {
public:
    explicit CameraOnCable(std::shared_ptr<Cable> cable) : m_cable(std::move(cable)) {}

    std::optional<capture::Frame> next() override;
    bool live() const override { return true; }
    std::string description() const override { return "camera at a cable"; }
    void requestStop() override;

private:
    std::shared_ptr<Cable> m_cable;
    std::uint64_t m_next = 0;
};

/// Hears everything at once, or fails each time.
class FakeVoice : public SpeechOutput {
    Q_OBJECT

public:
    explicit FakeVoice(bool works = true) : m_works(works) {}

    void say(const QString& text) override;
    void stop() override {}
    bool speaking() const override { return false; }
    QString description() const override { return QStringLiteral("fake voice"); }

private:
    bool m_works;
};

} // namespace farol::ui::test
