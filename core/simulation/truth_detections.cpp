#include "core/simulation/truth_detections.h"

#include "core/building/unmarked_landmarks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace farol::simulation {

namespace {

constexpr ImageSize kImage{640, 480};
constexpr double kSceneSeconds = 0.8;
constexpr double kCameraSpread = 0.1;
/// Misses of one object go together as long as it is in view.
constexpr double kVisitSeconds = 20.0;
/// Out of the picture for longer it is followed no more.
constexpr double kFollowedSeconds = 1.0, kLookSeconds = 0.4;

/// Spread of the logarithm of a range, by what it is measured on.
double rangeSpread(Kind kind) {
    switch (kind) {
    case Kind::Door:
        return 0.15;
    case Kind::Extinguisher:
    case Kind::ExitSign:
        return 0.18;
    case Kind::Text:
        return 0.25;
    case Kind::Stairs:
        return 0.3;
    case Kind::Poster:
        return 0.35;
    case Kind::Rectangle:
        return 0.4;
    default:
        return 0.2;
    }
}

/// A detector finds it: one of its own for that kind, or as a trained object.
bool detectable(const building::Landmark& landmark) {
    switch (landmark.kind) {
    case Kind::Door:
    case Kind::Stairs:
    case Kind::Extinguisher:
    case Kind::ExitSign:
    case Kind::Locker:
    case Kind::Poster:
    case Kind::Rectangle:
        return true;
    case Kind::Place:
        return false;
    default:
        return !landmark.text.empty() || !landmark.templateId.empty();
    }
}

/// How far the recognisers see a thing: a trained one while it is some two dozen pixels wide.
double reachOf(const building::Landmark& landmark) {
    constexpr double kSizesAway = 24.0, kUntrainedM = 4.8, kFarthestM = 19.0;
    if (landmark.templateId.empty()) return kUntrainedM;
    double size = std::min(landmark.widthM.value_or(0.5), landmark.tallM.value_or(0.5));
    return std::clamp(kSizesAway * size, 2.5, kFarthestM);
}

double farFactor(double range, double reach) {
    if (range < 1.0) return 0.3 + 0.7 * range;
    return range < 2.6 ? 1.0 : std::max(0.0, (reach - range) / (reach - 2.6));
}

} // namespace

TruthDetectionOptions TruthDetectionOptions::ofCamera() {
    TruthDetectionOptions options;
    options.camera = true;
    options.detectionsPerSecond = 0.35;
    options.wrongKind = 0.005;
    options.misread = 0.1;
    options.falsePerSecond = 0.01;
    options.lostFlow = 0.3;
    options.viewDegrees = 63.0;
    return options;
}

Result<void> TruthDetectionOptions::check() const {
    for (double share : {wrongKind, misread, noRange, stale, lostFlow})
        if (!(share >= 0.0 && share <= 1.0))
            return Error{ErrorCode::InvalidArgument, "a share is from 0 to 1", "truth detections"};
    for (double rate : {detectionsPerSecond, falsePerSecond, clutterPerM2})
        if (!(std::isfinite(rate) && rate >= 0.0))
            return Error{ErrorCode::InvalidArgument, "a rate is a number from 0 on", "truth detections"};
    if (!(viewDegrees > 5.0 && viewDegrees < 170.0) || !(reachM > 2.7 && reachM < 100.0))
        return Error{ErrorCode::InvalidArgument, "a camera sees 5 to 170 degrees, and 2.7 to 100 m far",
                     "truth detections"};
    return {};
}

TruthDetections::TruthDetections(std::shared_ptr<const WalkWorld> world, const TruthDetectionOptions& options)
    : m_world(std::move(world)),
      m_options(options),
      m_random(options.seed * 0xd1342543de82ef95ULL + 0x2bULL),
      m_things(m_world->building().regions().size()),
      m_scale(0.75 + 0.6 * m_random.uniformDouble()) {
    placeThings();
}

std::size_t TruthDetections::below(std::size_t count) {
    return count == 0 ? 0 : static_cast<std::size_t>(m_random.uniformDouble() * static_cast<double>(count));
}

void TruthDetections::placeThings() {
    const building::Building& building = m_world->building();
    for (const building::Landmark& landmark : building.landmarks()) placeThing(landmark);
    if (m_options.camera)
        for (const building::Landmark& door : building::unmarkedDoors(building)) placeThing(door);
    for (std::size_t region = 0; region < m_things.size(); ++region) addClutter(region);
}

void TruthDetections::placeThing(const building::Landmark& landmark) {
    if (!landmark.text.empty()) m_texts.push_back(landmark.text);
    auto region = m_world->building().regionIndex(landmark.region);
    bool gone = chance(m_options.stale);
    if (!region || gone || !detectable(landmark)) return;
    Thing thing{landmark.kind, landmark.templateId, landmark.text, landmark.position, landmark.heading};
    thing.heightM = landmark.heightM.value_or(thing.heightM);
    thing.wideM = landmark.widthM.value_or(thing.wideM);
    thing.tallM = landmark.tallM.value_or(thing.tallM);
    thing.reachM = m_options.camera ? reachOf(landmark) : m_options.reachM;
    m_things[*region].push_back(std::move(thing));
}

void TruthDetections::addClutter(std::size_t region) {
    constexpr Kind kClutter[] = {Kind::Rectangle, Kind::Poster, Kind::Locker, Kind::Door};
    const Polygon& polygon = m_world->building().regions()[region].polygon;
    auto box = boundingBox(polygon.outer);
    for (double wanted = m_options.clutterPerM2 * area(polygon); box && wanted > 0.0; wanted -= 1.0) {
        if (!chance(std::min(1.0, wanted))) break;
        Point2 at{box->low.x + box->width() * m_random.uniformDouble(),
                  box->low.y + box->height() * m_random.uniformDouble()};
        Thing thing{kClutter[below(std::size(kClutter))], {}, {}, at, Radians{between(-kPi, kPi)}};
        if (contains(polygon, at)) m_things[region].push_back(std::move(thing));
        if (wanted < 1.0) break;
    }
}

bool TruthDetections::inView(const Thing& thing, std::size_t region, const Passage* through,
                             double range) const {
    Radians direction = directionOf(thing.at - m_pose.position);
    if (through == nullptr) return m_world->free(region, m_pose.position, direction, range) > range - 0.2;
    if (!segmentsCross(m_pose.position, thing.at, through->gap.a, through->gap.b)) return false;
    if (m_world->free(m_region, m_pose.position, direction, range) < range - 0.2) return false;
    // The rest of the way, seen from the object, for the sides of its own region.
    Point2 back = thing.at + (m_pose.position - thing.at) * (0.25 / std::max(0.25, range));
    double rest = std::max(0.0, range - 0.25);
    return m_world->free(region, back, directionOf(m_pose.position - thing.at), rest) > rest - 0.05;
}

void TruthDetections::see(Thing& thing, std::size_t region, const Passage* through) {
    Point2 to = thing.at - m_pose.position;
    double range = length(to);
    if (range > thing.reachM || range < 0.3) return;
    Radians bearing = wrapped(directionOf(to) - m_pose.heading);
    if (std::abs(toDegrees(bearing)) > m_options.viewDegrees / 2.0) return;
    double facing = 1.0;
    if (thing.facing) {
        double c = -(to.x * std::cos(thing.facing->value) + to.y * std::sin(thing.facing->value)) / range;
        facing = c < 0.02 ? 0.0 : std::min(1.0, (c - 0.02) / 0.5);
    }
    if (facing <= 0.0 || !inView(thing, region, through, range)) return;
    if (m_pose.time - thing.lastSeen > kVisitSeconds) thing.luck = between(0.2, 1.8);
    if (m_pose.time - thing.lastSeen > kFollowedSeconds) {
        thing.track = ++m_lastTrack;
        thing.confirmations = 0;
    }
    thing.lastSeen = m_pose.time;
    if (!chance(seenPerSecond(thing, range) * facing * m_seconds)) return;
    ++thing.confirmations;
    // What is followed is told from its second sight on, and then a few times a second.
    if (m_options.camera && (thing.confirmations < 2 || m_pose.time - thing.lastTold < kLookSeconds)) return;
    thing.lastTold = m_pose.time;
    tell(thing, range, bearing, false);
}

double TruthDetections::seenPerSecond(const Thing& thing, double range) const {
    double rate = m_options.detectionsPerSecond * thing.luck;
    if (m_options.camera) {
        constexpr double kTrained = 6.0;
        double far = std::clamp((thing.reachM - range) / (0.4 * thing.reachM), 0.0, 1.0);
        return rate * far * (thing.templateId.empty() ? 1.0 : kTrained);
    }
    double prominent = thing.kind == Kind::ExitSign ? 1.6 : thing.kind == Kind::Stairs ? 1.3 : 1.0;
    return rate * prominent * farFactor(range, m_options.reachM);
}

Kind TruthDetections::confused(Kind kind) {
    double u = m_random.uniformDouble();
    switch (kind) {
    case Kind::Door:
        return u < 0.6 ? Kind::Rectangle : Kind::Locker;
    case Kind::Locker:
        return u < 0.5 ? Kind::Door : Kind::Rectangle;
    case Kind::Rectangle:
        return u < 0.6 ? Kind::Poster : Kind::Door;
    case Kind::ExitSign:
        return u < 0.7 ? Kind::Rectangle : Kind::Poster;
    case Kind::Text:
        return Kind::Poster;
    default:
        return Kind::Rectangle;
    }
}

std::string TruthDetections::misread(std::string text) {
    static const std::string kLetters = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ";
    int wrong = chance(m_options.misread) ? (chance(0.8) ? 1 : 2) : 0;
    for (int i = 0; i < wrong && !text.empty(); ++i) {
        std::size_t at = below(text.size());
        if (chance(0.15) && text.size() > 1)
            text.erase(at, 1);
        else
            text[at] = kLetters[below(kLetters.size())];
    }
    return text;
}

void TruthDetections::tell(const Thing& thing, double range, Radians bearing, bool invented) {
    recognition::Detection detection;
    bool wrong = !invented && chance(m_options.wrongKind);
    detection.kind = wrong ? confused(thing.kind) : thing.kind;
    if (!wrong) detection.templateId = thing.templateId;
    if (detection.kind == Kind::Text) detection.text = invented ? thing.text : misread(thing.text);
    double spread = invented ? 0.0 : m_options.camera ? kCameraSpread : rangeSpread(thing.kind);
    double measured =
        std::clamp(range * std::exp(spread * m_random.normal()), 0.45, m_options.camera ? 25.0 : 6.0);
    double half = m_options.viewDegrees / 2.0;
    double degrees =
        toDegrees(bearing) + (invented ? 0.0 : (m_options.camera ? 1.5 : 3.0) * m_random.normal());
    degrees = std::clamp(degrees, -half, half);
    bool sized = !m_options.camera || thing.kind == Kind::Door || !thing.templateId.empty();
    if (sized && !chance(m_options.noRange)) detection.rangeM = measured;
    if (m_options.camera) {
        if (detection.rangeM) detection.rangeSpread = 2.0 * kCameraSpread;
        detection.track = thing.track;
        detection.confirmations = std::max(1, thing.confirmations);
    }
    detection.bearing = fromDegrees(degrees);
    detection.image = kImage;
    detection.score = 0.7;
    double focal = kImage.width / 2.0 / std::tan(fromDegrees(half).value);
    double x = kImage.width / 2.0 - focal * std::tan(fromDegrees(degrees).value);
    double y = kImage.height / 2.0 - focal * (thing.heightM - m_pose.eyeHeightM) / std::max(0.5, range);
    double wide = std::min(focal * thing.wideM / std::max(0.5, range), 600.0),
           tall = std::min(focal * thing.tallM / std::max(0.5, range), 460.0);
    detection.quad = quadOf({x - wide / 2.0, y - tall / 2.0, wide, tall});
    m_sight.detections.push_back(std::move(detection));
}

void TruthDetections::invent() {
    if (!chance(m_options.falsePerSecond * m_seconds)) return;
    constexpr std::array<std::pair<Kind, double>, 7> kShares{{{Kind::Door, 0.18},
                                                              {Kind::Rectangle, 0.48},
                                                              {Kind::Poster, 0.72},
                                                              {Kind::Text, 0.86},
                                                              {Kind::Locker, 0.94},
                                                              {Kind::Extinguisher, 0.97},
                                                              {Kind::ExitSign, 1.0}}};
    double u = m_random.uniformDouble();
    Thing thing;
    thing.kind = std::find_if(kShares.begin(), kShares.end(), [&](const auto& share) {
                     return u < share.second;
                 })->first;
    thing.text = chance(0.5) ? "EXIT" : std::to_string(100 + below(900));
    if (chance(0.15) && !m_texts.empty()) thing.text = m_texts[below(m_texts.size())];
    double half = m_options.viewDegrees / 2.0;
    tell(thing, std::exp(std::log(2.0) + 0.5 * m_random.normal()), fromDegrees(between(-half, half)), true);
}

void TruthDetections::seeRegion(std::size_t region, const Passage* through) {
    for (Thing& thing : m_things[region]) see(thing, region, through);
}

recognition::Motion TruthDetections::motion() {
    recognition::Motion motion;
    m_walkedM += m_pose.speed * m_seconds;
    double seconds = m_pose.time - m_motionAt;
    if (seconds <= 0.0) return motion;
    Radians turn = wrapped(m_pose.heading - m_motionHeading);
    double speed = std::max(0.0, m_walkedM / seconds * m_scale * (1.0 + 0.12 * m_random.normal())) +
                   0.03 * std::abs(m_random.normal());
    bool lost = chance(m_options.lostFlow);
    if (!lost) {
        motion.turn = turn + fromDegrees(1.5 * std::sqrt(seconds) * m_random.normal());
        motion.speed = speed;
    }
    m_motionAt = m_pose.time;
    m_motionHeading = m_pose.heading;
    m_walkedM = 0.0;
    return motion;
}

TruthSight TruthDetections::look(const CameraPose& pose, std::size_t region) {
    m_seconds = m_looked ? std::max(0.0, pose.time - m_pose.time) : 0.0;
    if (!m_looked) {
        m_motionAt = pose.time;
        m_motionHeading = pose.heading;
    }
    m_looked = true;
    m_pose = pose;
    m_region = region;
    m_sight.detections.clear();
    if (pose.time - m_sceneAt >= kSceneSeconds) {
        ++m_sight.scene;
        m_sceneAt = pose.time;
    }
    m_sight.motion = motion();
    bool between = pose.level != m_world->building().regions()[region].level;
    if (!between) {
        seeRegion(region, nullptr);
        for (const Passage& passage : m_world->passagesOf(region)) {
            if (passage.kind != building::AccessKind::Opening || passage.changesLevel()) continue;
            double farthest = m_options.camera ? 20.0 : m_options.reachM;
            if (distanceToSegment(pose.position, passage.gap.a, passage.gap.b) > farthest) continue;
            seeRegion(passage.into, &passage);
        }
    }
    invent();
    return m_sight;
}

} // namespace farol::simulation
