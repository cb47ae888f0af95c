#include "tests/ui/hand_made.h"

#include <QMetaObject>

namespace farol::ui::test {

namespace {

Polygon box(double left, double bottom, double right, double top) {
    return {{{left, bottom}, {right, bottom}, {right, top}, {left, top}}, {}};
}

building::Region region(const char* id, const char* name, const char* ref, double level,
                        building::RegionKind kind, Polygon polygon) {
    building::Region made;
    made.id = RegionId(id);
    made.name = name;
    made.ref = ref;
    made.level = level;
    made.kind = kind;
    made.polygon = std::move(polygon);
    return made;
}

building::Access access(const char* id, building::AccessKind kind, const char* a, const char* b,
                        Polyline line) {
    building::Access made;
    made.id = AccessId(id);
    made.kind = kind;
    made.regionA = RegionId(a);
    made.regionB = RegionId(b);
    made.line = std::move(line);
    return made;
}

building::Landmark landmark(const char* id, Kind kind, const char* text, const char* home, Point2 position) {
    building::Landmark made;
    made.id = LandmarkId(id);
    made.kind = kind;
    made.text = text;
    made.region = RegionId(home);
    made.position = position;
    return made;
}

} // namespace

std::shared_ptr<const building::Building> handMadeBuilding() {
    using building::AccessKind;
    using building::RegionKind;
    building::BuildingData data;
    data.title = "Hand-made house";
    data.levels = {{0.0, "Ground floor", "G", 0.0, 3.0, {}}, {1.0, "First floor", "1", 3.0, 3.0, {}}};
    data.regions = {region("c", "Main corridor", "", 0.0, RegionKind::Corridor, box(0, 0, 10, 2)),
                    region("r1", "Room 1", "0.01", 0.0, RegionKind::Room, box(0, 2, 5, 6)),
                    region("r2", "Café", "0.02", 0.0, RegionKind::Room, box(5, 2, 10, 6)),
                    region("s0", "Stairs below", "", 0.0, RegionKind::Stairwell, box(10, 0, 13, 2)),
                    region("s1", "Stairs above", "", 1.0, RegionKind::Stairwell, box(10, 0, 13, 2)),
                    region("lib", "Library", "1.01", 1.0, RegionKind::Room, box(0, 0, 10, 6))};
    data.accesses = {access("d1", AccessKind::Door, "c", "r1", {{2, 2}, {3, 2}}),
                     access("d2", AccessKind::Door, "c", "r2", {{7, 2}, {8, 2}}),
                     access("o1", AccessKind::Opening, "c", "s0", {{10, 0.5}, {10, 1.5}}),
                     access("st", AccessKind::Stairs, "s0", "s1", {{12, 1}}),
                     access("d3", AccessKind::Door, "s1", "lib", {{10, 0.5}, {10, 1.5}})};
    data.accesses.back().level = 1.0;
    data.landmarks = {landmark("L1", Kind::Extinguisher, "", "c", {4, 0.2}),
                      landmark("L2", Kind::Sign, "CAFE", "c", {9, 1.8})};
    data.walls = {{0.0, {{0, 0}, {10, 0}}, {}}};
    return std::make_shared<const building::Building>(std::move(data));
}

std::shared_ptr<const session::Snapshot> handMadeSnapshot() {
    auto snapshot = std::make_shared<session::Snapshot>();
    snapshot->state = session::RunState::Running;
    snapshot->frame.index = 6;
    snapshot->frame.capturedAt = 62.5;
    snapshot->frame.name = "7.jpg";
    snapshot->frame.image = cv::Mat(240, 320, CV_8UC3, cv::Scalar(40, 120, 200));
    snapshot->framesDropped = 3;
    snapshot->times.ageMs = 85.2;

    recognition::Detection door;
    door.kind = Kind::Door;
    door.quad = quadOf({20, 40, 60, 150});
    door.image = {320, 240};
    door.score = 0.91;
    recognition::Rejection nearly;
    nearly.detector = "doors";
    nearly.kind = Kind::Door;
    nearly.quad = quadOf({200, 40, 60, 150});
    nearly.reason = "few_inliers";
    session::NavigationStep& step = snapshot->step;
    step.percept.frame = 6;
    step.percept.time = 62.5;
    step.percept.size = {320, 240};
    step.percept.detections = {door};
    step.percept.rejections = {nearly};
    step.history = {{door, 60.0, 4, 1}, {door, 62.5, 6, 2}};
    step.fix.time = 62.5;
    step.fix.region = RegionId("c");
    step.fix.level = 0.0;
    step.fix.confidence = 0.7;
    step.fix.position = Point2{4.0, 1.0};
    step.fix.sigmaM = 0.8;
    step.fix.heading = Radians{0.0};
    step.fix.landmark = LandmarkId("L1");
    step.fix.votes = {{RegionId("c"), 6.0, {{"Pmaxobj", 3.0}, {"Pperc", 1.5}}, {LandmarkId("L1")}},
                      {RegionId("r1"), 1.5, {{"Ppos", 2.0}}, {}}};
    auto route = std::make_shared<routing::Route>();
    route->regions = {RegionId("c"), RegionId("s0"), RegionId("s1"), RegionId("lib")};
    route->path = {{{4, 1}, 0.0}, {{10, 1}, 0.0}, {{12, 1}, 0.0}, {{12, 1}, 1.0}, {{5, 3}, 1.0}};
    step.progress.travel = guidance::Travel::OnRoute;
    step.progress.route = route;
    step.progress.distanceM = 6.2;
    step.progress.remainingM = 19.0;
    return snapshot;
}

namespace {

capture::Frame greyFrame(std::uint64_t index, double period) {
    capture::Frame frame;
    frame.index = index;
    frame.capturedAt = static_cast<double>(index) * period;
    frame.image = cv::Mat(120, 160, CV_8UC3, cv::Scalar(90, 90, 90));
    frame.arrivedAt = std::chrono::steady_clock::now();
    return frame;
}

} // namespace

std::optional<capture::Frame> FakeSource::next() {
    if (m_next >= m_frames || stopRequested()) return std::nullopt;
    return greyFrame(m_next++, m_period);
}

void Cable::setPlugged(bool plugged) {
    std::scoped_lock lock(m_mutex);
    m_state = plugged ? State::Plugged : State::Unplugged;
    m_changed.notify_all();
}

void Cable::pull() {
    std::scoped_lock lock(m_mutex);
    m_state = State::Gone;
    m_changed.notify_all();
}

Cable::State Cable::next() {
    constexpr std::chrono::milliseconds kPicture{20};
    std::unique_lock lock(m_mutex);
    m_changed.wait_for(lock, kPicture, [this] { return m_state != State::Plugged; });
    return m_state;
}

Cable::State Cable::whenNotUnplugged(const std::function<bool()>& over) {
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [&] { return m_state != State::Unplugged || over(); });
    return m_state;
}

std::optional<capture::Frame> CameraOnCable::next() {
    Cable::State state = m_cable->next();
    if (state == Cable::State::Unplugged) {
        tell(capture::SourceEventKind::ConnectionLost, "the camera gives no more pictures");
        state = m_cable->whenNotUnplugged([this] { return stopRequested(); });
        if (state == Cable::State::Plugged) tell(capture::SourceEventKind::Reconnected, "the camera is back");
    }
    if (stopRequested() || state != Cable::State::Plugged) return std::nullopt;
    return greyFrame(m_next++, 0.02);
}

void CameraOnCable::requestStop() {
    FrameSource::requestStop();
    m_cable->wake();
}

void FakeVoice::say(const QString& /*text*/) {
    QMetaObject::invokeMethod(
        this,
        [this] {
            if (m_works)
                Q_EMIT finished();
            else
                Q_EMIT failed(QStringLiteral("the fake voice is hoarse"));
        },
        Qt::QueuedConnection);
}

} // namespace farol::ui::test
