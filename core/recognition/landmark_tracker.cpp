#include "core/recognition/landmark_tracker.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace farol::recognition {

namespace {

constexpr std::size_t kMostPictures = 120, kMostFollowed = 200;
constexpr double kGrowthSeconds = 2.5;
/// Of boxes of something untrained that was not followed meanwhile: the paper's overlap test (3b).
constexpr double kOverlapWhenLost = 0.5;

double sizeOf(const Quad& quad) {
    ImageBox box = boundingBox(quad);
    return std::sqrt(std::max(1e-6, box.area()));
}

bool flows(const Detection& seen) {
    // A place is the whole view: it lasts as long as it is recognised.
    return seen.kind != Kind::Place;
}

/// The same thing as far as a look can tell without its place in the picture.
bool alike(Sense sense, const Detection& a, const Detection& b) {
    // Words are read now so, now otherwise: a line is known by where it is.
    if (sense == Sense::Text) return true;
    return a.kind == b.kind && a.templateId == b.templateId;
}

bool inView(const Quad& quad, ImageSize size) {
    ImageBox box = boundingBox(quad);
    return box.x >= 0.0 && box.y >= 0.0 && box.x + box.width <= size.width &&
           box.y + box.height <= size.height;
}

} // namespace

Result<void> TrackerOptions::check() const {
    if (auto checked = flow.check(); !checked) return checked;
    auto wrong = [](const char* what, const char* which) {
        return Error{ErrorCode::InvalidArgument, what, which};
    };
    for (double seconds :
         {maxGapSeconds, unconfirmedSeconds, blindSeconds, rejoinSeconds, rejoinUntrainedSeconds})
        if (!(seconds >= 0.0)) return wrong("a time is not negative", "maxGapSeconds ... rejoinSeconds");
    if (!(sameOverlap > 0.0 && sameOverlap <= 1.0))
        return wrong("a share lies between 0 and 1", "sameOverlap");
    if (!(horizontalViewDegrees > 10.0 && horizontalViewDegrees < 150.0))
        return wrong("the camera's view is not an angle from 10 to 150 degrees", "horizontalViewDegrees");
    if (maxMisses < 1) return wrong("at least one look without it is borne", "maxMisses");
    return {};
}

LandmarkTracker::LandmarkTracker(TrackerOptions options) : m_options(options) {}

/// Direction to a column of the picture, left positive.
double LandmarkTracker::yawOf(double x, int width) const {
    double focal = 0.5 * width / std::tan(m_options.horizontalViewDegrees * kPi / 360.0);
    return -std::atan2(x - 0.5 * width, focal);
}

std::optional<std::size_t> LandmarkTracker::pictureOf(std::uint64_t frame) const {
    for (std::size_t i = m_pictures.size(); i-- > 0;)
        if (m_pictures[i].frame == frame) return i;
    return std::nullopt;
}

const QuadState* LandmarkTracker::stateIn(const Followed& one, std::uint64_t frame) const {
    for (const Past& past : one.past)
        if (past.frame == frame) return &past.state;
    return nullptr;
}

Quad LandmarkTracker::quadIn(const Followed& one, const Picture& picture) const {
    const QuadState* state = stateIn(one, picture.frame);
    return state != nullptr && flows(one.seen) ? picture.flow.toFull(state->quad) : one.seen.quad;
}

bool LandmarkTracker::sparse(std::uint64_t frame) const {
    auto index = pictureOf(frame);
    return !index || m_pictures[*index].sparse;
}

void LandmarkTracker::forget(std::uint64_t oldestNeeded) {
    while (m_pictures.size() > kMostPictures || (m_pictures.size() > 2 && m_pictures[0].frame < oldestNeeded))
        m_pictures.pop_front();
    if (m_pictures.empty()) return;
    std::uint64_t oldest = m_pictures.front().frame;
    for (Followed& one : m_followed)
        while (one.past.size() > 1 && one.past.front().frame < oldest) one.past.pop_front();
    // Later than a lost thing can be known again, since looks come late.
    double longest = m_options.rejoinSeconds + m_options.rejoinUntrainedSeconds + m_options.blindSeconds;
    double now = m_pictures.back().time;
    std::erase_if(m_followed,
                  [&](const Followed& one) { return !one.alive && now - one.lastTime > longest; });
    while (m_followed.size() > kMostFollowed) {
        auto oldestLost = std::find_if(m_followed.begin(), m_followed.end(),
                                       [](const Followed& one) { return !one.alive; });
        m_followed.erase(oldestLost != m_followed.end() ? oldestLost : m_followed.begin());
    }
}

void LandmarkTracker::end(Followed& one, const char* reason, double value) {
    if (!one.alive) return;
    one.alive = false;
    one.leftView = std::string_view(reason) == flowEndName(FlowEnd::LeftView);
    m_ended.push_back({"tracks", one.seen.kind, one.seen.templateId, one.track.now.quad, reason, value});
}

/// As of an earlier frame, whatever was made of it since.
void LandmarkTracker::endAt(Followed& one, const Picture& picture, const char* reason, double value) {
    while (one.past.size() > 1 && one.past.back().frame > picture.frame) one.past.pop_back();
    one.lastTime = picture.time;
    one.lastScene = picture.scene;
    present(one);
    end(one, reason, value);
}

/// One frame further; false: it ended there.
bool LandmarkTracker::step(Followed& one, const Picture& from, const Picture& to) {
    if (!to.follows) {
        end(one, to.sparse ? "frames_too_far_apart" : "cut", to.time - from.time);
        return false;
    }
    if (to.time - one.track.confirmedTime > m_options.blindSeconds) {
        end(one, "unconfirmed", to.time - one.track.confirmedTime);
        return false;
    }
    QuadState next = one.past.back().state;
    if (flows(one.seen)) {
        FlowEnd why = FlowEnd::None;
        auto state = carried(one.anchor, one.past.back().state, from.flow, to.flow, m_options.flow, why);
        if (!state) {
            end(one, flowEndName(why), static_cast<double>(one.past.back().state.points.size()));
            return false;
        }
        next = std::move(*state);
    }
    one.past.push_back({to.frame, std::move(next)});
    one.lastTime = to.time;
    one.lastScene = to.scene;
    return true;
}

/// From the frame after `firstPicture` to the present.
void LandmarkTracker::carry(Followed& one, std::size_t firstPicture) {
    for (std::size_t i = firstPicture; one.alive && i + 1 < m_pictures.size(); ++i)
        if (!step(one, m_pictures[i], m_pictures[i + 1])) break;
    present(one);
}

/// What is told of it, as of the newest frame it was followed into.
void LandmarkTracker::present(Followed& one) const {
    Detection& now = one.track.now;
    std::uint64_t track = now.track;
    int confirmations = now.confirmations;
    now = one.seen;
    now.track = track;
    now.confirmations = confirmations;
    if (!flows(one.seen) || one.past.empty() || m_pictures.empty()) return;
    auto index = pictureOf(one.past.back().frame);
    if (!index) return;
    now.quad = m_pictures[*index].flow.toFull(one.past.back().state.quad);
    if (now.rangeM) now.rangeM = *now.rangeM * sizeOf(one.seen.quad) / sizeOf(now.quad);
    if (!now.bearing || now.image.width <= 0) return;
    double before = boundingBox(one.seen.quad).centre().x, after = boundingBox(now.quad).centre().x;
    now.bearing =
        Radians{now.bearing->value + yawOf(after, now.image.width) - yawOf(before, now.image.width)};
}

void LandmarkTracker::advance(const cv::Mat& image, std::uint64_t frame, double time, int scene, bool cut,
                              std::uint64_t oldestNeeded) {
    Picture picture{
        frame, time, scene, false, true, {image.cols, image.rows}, FlowPicture(image, m_options.flow)};
    if (!m_pictures.empty()) {
        const Picture& before = m_pictures.back();
        double gap = time - before.time;
        picture.sparse = !(gap >= 0.0 && gap <= m_options.maxGapSeconds);
        picture.follows = !picture.sparse && !cut && before.size == picture.size && !picture.flow.empty();
        if (!(gap >= 0.0) || frame <= before.frame) {
            // Another walk, or a clock that was set back: nothing from before counts.
            m_pictures.clear();
            m_followed.clear();
        }
    }
    m_pictures.push_back(std::move(picture));
    if (m_pictures.size() > 1)
        for (Followed& one : m_followed)
            if (one.alive) carry(one, m_pictures.size() - 2);
    forget(oldestNeeded);
}

/// For each detection the followed thing it is, or -1. Best overlaps first.
std::vector<int> LandmarkTracker::matched(Sense sense, const Picture& picture,
                                          const std::vector<Detection>& found) const {
    std::vector<Match> matches;
    for (std::size_t d = 0; d < found.size(); ++d)
        for (std::size_t f = 0; f < m_followed.size(); ++f) {
            const Followed& one = m_followed[f];
            if (one.sense != sense || !alike(sense, one.seen, found[d])) continue;
            if (stateIn(one, picture.frame) == nullptr) continue;
            double shared = overlap(boundingBox(quadIn(one, picture)), boundingBox(found[d].quad));
            if (shared >= m_options.sameOverlap) matches.push_back({d, f, shared});
        }
    std::stable_sort(matches.begin(), matches.end(),
                     [](const Match& a, const Match& b) { return a.overlap > b.overlap; });
    std::vector<int> owners(found.size(), -1);
    for (const Match& match : matches) {
        auto followed = static_cast<int>(match.followed);
        bool taken = std::find(owners.begin(), owners.end(), followed) != owners.end();
        if (!taken && owners[match.found] < 0) owners[match.found] = followed;
    }
    return owners;
}

/// A thing that was lost before this picture and is seen again: trained things and words anywhere in the same
/// scene, others only where they were a moment ago.
std::optional<std::size_t> LandmarkTracker::lostOne(Sense sense, const Picture& picture,
                                                    const Detection& seen,
                                                    const std::vector<int>& taken) const {
    std::optional<std::size_t> best;
    double bestOverlap = -1.0;
    for (std::size_t f = 0; f < m_followed.size(); ++f) {
        const Followed& one = m_followed[f];
        if (one.sense != sense || !alike(sense, one.seen, seen) || one.alive) continue;
        if (one.lastTime >= picture.time || one.lastScene != picture.scene) continue;
        if (std::find(taken.begin(), taken.end(), static_cast<int>(f)) != taken.end()) continue;
        bool known = sense == Sense::Text ? one.seen.text == seen.text : !seen.templateId.empty();
        double longest = known ? m_options.rejoinSeconds : m_options.rejoinUntrainedSeconds;
        double shared = overlap(boundingBox(one.track.now.quad), boundingBox(seen.quad));
        bool near = shared >= kOverlapWhenLost;
        if (picture.time - one.lastTime > longest || (!near && (!known || one.leftView))) continue;
        if (shared > bestOverlap) {
            best = f;
            bestOverlap = shared;
        }
    }
    return best;
}

std::size_t LandmarkTracker::begin(Sense sense, const Picture& picture, const Detection& seen) {
    Followed one;
    one.sense = sense;
    one.seen = seen;
    one.track.now.track = m_nextTrack++;
    one.track.now.confirmations = 0;
    one.track.firstTime = picture.time;
    m_followed.push_back(std::move(one));
    return m_followed.size() - 1;
}

/// Recognition has seen it in this picture: from there on it is followed anew.
void LandmarkTracker::see(Followed& one, std::size_t index, const Detection& seen) {
    const Picture& picture = m_pictures[index];
    one.seen = seen;
    one.misses = 0;
    one.alive = true;
    one.leftView = false;
    one.lastTime = picture.time;
    one.lastScene = picture.scene;
    ++one.track.now.confirmations;
    one.track.confirmedTime = picture.time;
    one.sizes.push_back({picture.time, std::log(sizeOf(seen.quad))});
    while (picture.time - one.sizes.front().time > kGrowthSeconds) one.sizes.pop_front();
    one.track.growth.reset();
    auto n = static_cast<double>(one.sizes.size());
    double t = 0.0, s = 0.0, tt = 0.0, ts = 0.0;
    for (const Sized& each : one.sizes) {
        double at = each.time - one.sizes.front().time;
        t += at / n;
        s += each.logSize / n;
        tt += at * at / n;
        ts += at * each.logSize / n;
    }
    constexpr double kLeastSpread = 0.01; // of the times, seconds squared: a third of a second between three
    if (n >= 3.0 && tt - t * t > kLeastSpread) one.track.growth = (ts - t * s) / (tt - t * t);
    one.anchor = flows(seen) ? anchorAt(picture.flow, seen.quad, m_options.flow) : QuadAnchor{};
    one.past.clear();
    one.past.push_back({picture.frame, stateAt(one.anchor)});
    carry(one, index);
}

/// What this look should have seen and did not, or saw as something else.
void LandmarkTracker::deny(Sense sense, const Picture& picture, const std::vector<Detection>& found,
                           const std::vector<int>& owners) {
    for (std::size_t f = 0; f < m_followed.size(); ++f) {
        Followed& one = m_followed[f];
        if (one.sense != sense || !one.alive || stateIn(one, picture.frame) == nullptr) continue;
        if (std::find(owners.begin(), owners.end(), static_cast<int>(f)) != owners.end()) continue;
        Quad quad = quadIn(one, picture);
        bool other = std::any_of(found.begin(), found.end(), [&](const Detection& seen) {
            return sense == Sense::Landmarks && flows(seen) == flows(one.seen) &&
                   !alike(sense, one.seen, seen) && overlap(boundingBox(quad), boundingBox(seen.quad)) > 0.5;
        });
        if (other) {
            endAt(one, picture, "contradicted", 0.0);
            continue;
        }
        if (!inView(quad, picture.size) && flows(one.seen)) continue;
        ++one.misses;
        double unseen = picture.time - one.track.confirmedTime;
        bool onceOnly = one.track.now.confirmations == 1 && one.misses >= m_options.maxMisses;
        bool tooLong = one.misses >= m_options.maxMisses && unseen > m_options.unconfirmedSeconds;
        if (onceOnly || tooLong) endAt(one, picture, "unconfirmed", unseen);
    }
}

std::vector<Detection> LandmarkTracker::join(Sense sense, std::uint64_t frame, std::vector<Detection> found,
                                             bool complete) {
    auto index = pictureOf(frame);
    if (!index) return found; // older than anything that is still known
    std::vector<int> owners = matched(sense, m_pictures[*index], found);
    for (std::size_t d = 0; d < found.size(); ++d) {
        if (owners[d] >= 0) continue;
        auto lost = lostOne(sense, m_pictures[*index], found[d], owners);
        owners[d] = static_cast<int>(lost ? *lost : begin(sense, m_pictures[*index], found[d]));
    }
    for (std::size_t d = 0; d < found.size(); ++d)
        see(m_followed[static_cast<std::size_t>(owners[d])], *index, found[d]);
    if (complete) deny(sense, m_pictures[*index], found, owners);
    for (std::size_t d = 0; d < found.size(); ++d)
        found[d] = m_followed[static_cast<std::size_t>(owners[d])].track.now;
    return found;
}

std::vector<Track> LandmarkTracker::tracks() const {
    std::vector<Track> result;
    for (const Followed& one : m_followed)
        if (one.alive) result.push_back(one.track);
    std::sort(result.begin(), result.end(),
              [](const Track& a, const Track& b) { return a.now.track < b.now.track; });
    return result;
}

std::vector<Quad> LandmarkTracker::quadsOf(Sense sense) const {
    std::vector<Quad> quads;
    for (const Followed& one : m_followed)
        if (one.alive && one.sense == sense) quads.push_back(one.track.now.quad);
    return quads;
}

std::vector<Rejection> LandmarkTracker::takeEnded() {
    return std::exchange(m_ended, {});
}

} // namespace farol::recognition
