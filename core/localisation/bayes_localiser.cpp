#include "core/localisation/bayes_localiser.h"

#include "core/base/text.h"
#include "core/localisation/confidence_table.h"
#include "core/localisation/motion_log.h"
#include "core/localisation/quick_math.h"
#include "core/localisation/walker_cloud.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace farol::localisation {

namespace {

constexpr double kStepS = 0.5; // the cloud moves on in steps no shorter, unless something was seen
constexpr double kLongestStepS = 1.0;
constexpr std::size_t kVotesKept = 8;
constexpr double kLeastWeight = 1e-12;
constexpr double kGuess = 0.5;
constexpr double kWatchPart = 0.6; // of the weight without a walker, for those who look everywhere
constexpr float kCertainly = 0.8F; // of what was seen: then it also tells where the camera looks

class BayesLocaliser : public Localiser {
public:
    BayesLocaliser(std::shared_ptr<const building::Building> building, const BayesOptions& options)
        : m_options(options),
          m_building(std::move(building)),
          m_map(std::make_shared<WalkingMap>(m_building)),
          m_sensors(m_map, options.sensors),
          m_cloud(m_map, options),
          m_motion(options.walking.paceTrust) {
        m_mass.assign(m_building->regions().size(), 0.0);
        m_meanRate = meanRate();
        start(0.0, std::nullopt);
    }

    void start(double time, const std::optional<RegionId>& region) override;
    void setRoute(const RouteContext& route) override;
    void told(const std::optional<ToldWay>& way) override { m_cloud.told(way); }
    Fix update(double time, std::span<const Observation> fresh,
               const std::deque<Observation>& history) override;
    void moved(double time, const recognition::Motion& motion) override {
        if (m_options.useMotion) m_motion.add(time, motion);
    }
    std::string name() const override {
        if (!m_options.walking.guided) return "bayes";
        return m_options.sensors.camera ? "bayes-guided" : "bayes-guided-sparse";
    }

private:
    struct Repeat {
        double time;
        Kind kind;
        std::string text;
        TemplateId templateId;
        std::optional<std::uint64_t> track;
    };

    void advanceTo(double time);
    void step(double seconds);
    void weigh(const Observation& seen);
    double trustIn(const Observation& seen);
    void doubt(double logUniform, double logBelief);
    void giveBirth(const Look& look, double mass);
    void normalise();
    void embody();
    Fix summary(double time);
    std::string noteNow() const;
    void placeWithin(Fix& fix, std::uint32_t region) const;
    void addVotes(Fix& fix, const std::vector<std::uint32_t>& order) const;
    void sumMasses();
    double meanRate() const;

    BayesOptions m_options;
    std::shared_ptr<const building::Building> m_building;
    std::shared_ptr<WalkingMap> m_map;
    SensorModel m_sensors;
    WalkerCloud m_cloud;
    MotionLog m_motion;
    double m_meanRate = 0.0; ///< detections per second to be expected anywhere
    double m_lost = 1.0;     ///< weight of "anywhere": no walker stands for it
    double m_time = 0.0, m_evidenceTime = 0.0, m_watchSince = 0.0;
    double m_against = 0.0;  ///< log evidence that the belief is wrong
    bool m_grounded = false; ///< the start was told, or something on the map was recognised since
    bool m_strange = false;  ///< what was seen last is like nothing on the map
    std::vector<Repeat> m_recent;
    std::vector<double> m_mass; ///< of each region
    std::vector<std::uint32_t> m_touched;
    std::optional<building::Location> m_destination;
};

void BayesLocaliser::start(double time, const std::optional<RegionId>& region) {
    m_cloud.clear(m_options.seed);
    m_motion.clear();
    m_recent.clear();
    m_against = 0.0;
    m_time = std::isfinite(time) ? time : 0.0;
    m_evidenceTime = m_watchSince = m_time;
    m_lost = 1.0;
    if (m_building->regions().empty()) return;
    auto index = region ? m_building->regionIndex(*region) : std::nullopt;
    m_strange = false;
    m_grounded = index.has_value();
    std::size_t all = m_cloud.capacity();
    constexpr double kAnywhere = 0.2;
    if (index) {
        m_cloud.spread(all, m_options.startTrust, static_cast<std::uint32_t>(*index));
        m_lost = 1.0 - m_options.startTrust;
    } else {
        m_cloud.spread(all, 1.0 - kAnywhere, std::nullopt);
        m_lost = kAnywhere;
    }
}

void BayesLocaliser::setRoute(const RouteContext& route) {
    auto same = [](const std::optional<building::Location>& a, const std::optional<building::Location>& b) {
        return a.has_value() == b.has_value() &&
               (!a || (a->region == b->region && a->position == b->position));
    };
    if (same(route.destination, m_destination)) return;
    m_destination = route.destination;
    auto index = m_destination ? m_building->regionIndex(m_destination->region) : std::nullopt;
    if (!index) {
        m_map->clearGoal();
    } else {
        auto region = static_cast<std::uint32_t>(*index);
        Spot spot =
            m_destination->position ? m_map->local(*m_destination->position) : m_map->middleOf(region);
        m_map->setGoal(region, spot);
    }
    m_cloud.reconsider();
}

double BayesLocaliser::meanRate() const {
    constexpr int kSamples = 400;
    if (m_building->regions().empty() || m_map->totalWeight() <= 0.0) return 0.0;
    Random random(m_options.seed);
    double sum = 0.0;
    for (int i = 0; i < kSamples; ++i) {
        std::uint32_t region = m_map->regionAtShare((i + random.uniformDouble()) / kSamples);
        float u = random.uniform(), v = random.uniform();
        Gaze gaze{360.0F * random.uniform(), 400.0F, 0.1F};
        sum += double(m_sensors.expectedRate(region, m_map->spotIn(region, u, v), gaze));
    }
    return sum / kSamples;
}

void BayesLocaliser::step(double seconds) {
    MotionSpan span = m_motion.take(seconds);
    // Whoever is lost stands and turns as everybody does; only what should have been seen tells them apart.
    m_lost *= m_cloud.advance(span, m_sensors, m_options.missTrust) *
              std::exp(-m_options.missTrust * m_meanRate * seconds);
    double rate = m_motion.blind() ? m_options.blindLostRate : m_options.lostRate;
    double carried = 1.0 - std::exp(-rate * seconds);
    double belief = m_cloud.totalWeight();
    m_cloud.scale(1.0 - carried);
    m_lost += carried * belief;
    normalise();
    embody();
    if (m_time - m_watchSince >= m_options.watchSeconds) {
        m_watchSince = m_time;
        m_cloud.changeWatch(kWatchPart * m_lost);
        m_lost *= 1.0 - kWatchPart;
    }
    m_cloud.renew();
}

/// Much weight without a walker: walkers all over the map take it, as they can follow what comes.
void BayesLocaliser::embody() {
    constexpr double kMuch = 0.3, kPart = 0.75;
    if (m_lost < kMuch) return;
    m_cloud.spread(m_cloud.capacity() / 2, kPart * m_lost, std::nullopt);
    m_lost *= 1.0 - kPart;
}

void BayesLocaliser::normalise() {
    double total = m_cloud.totalWeight() + m_lost;
    if (!(total > kLeastWeight) || !std::isfinite(total)) {
        // Nothing explains what was seen: begin anew rather than divide by nothing.
        m_cloud.walkers().clear();
        m_cloud.spread(m_cloud.capacity(), 0.5, std::nullopt);
        m_lost = 0.5;
        return;
    }
    m_cloud.scale(1.0 / total);
    m_lost /= total;
}

void BayesLocaliser::advanceTo(double time) {
    constexpr double kMostS = 120.0; // beyond, the cloud knows nothing anyway
    double gap = time - m_time;
    if (gap > kMostS) m_time = time - kMostS;
    while (time - m_time > 1e-6) {
        double seconds = std::min(kLongestStepS, time - m_time);
        m_time += seconds;
        step(seconds);
    }
    m_time = time;
}

double BayesLocaliser::trustIn(const Observation& seen) {
    const recognition::Detection& detection = seen.detection;
    std::string text = foldedForMatching(detection.text);
    double trust = m_options.trust;
    std::erase_if(m_recent,
                  [&](const Repeat& each) { return seen.time - each.time > m_options.repeatSeconds; });
    for (const Repeat& each : m_recent) {
        // What is followed from frame to frame is known to be the same thing, or another one.
        if (each.track && seen.track) {
            if (*each.track == *seen.track)
                trust = seen.time - each.time < m_options.trackSeconds ? 0.0 : m_options.trustRepeated;
            continue;
        }
        if (each.kind == detection.kind && each.templateId == detection.templateId &&
            shortEditDistance(each.text, text) <= 1)
            trust = std::min(trust, m_options.trustRepeated);
    }
    if (trust > 0.0) m_recent.push_back({seen.time, detection.kind, text, detection.templateId, seen.track});
    return trust;
}

/// Does "anywhere" explain what was seen lately much better than the belief does? Then part of the belief is
/// given up.
void BayesLocaliser::doubt(double logUniform, double logBelief) {
    m_against = std::max(0.0, m_against + logUniform - logBelief);
    if (m_against <= m_options.resetAt) return;
    m_against = m_options.resetAt / 2.0;
    double belief = m_cloud.totalWeight(), share = m_options.resetShare;
    m_cloud.scale(1.0 - share);
    constexpr double kSpreadPart = 0.5; // of what is given up; the rest waits for the next sight
    m_cloud.spread(m_cloud.capacity() / 6, kSpreadPart * share * belief, std::nullopt, m_cloud.watch());
    m_lost += (1.0 - kSpreadPart) * share * belief;
}

void BayesLocaliser::giveBirth(const Look& look, double mass) {
    constexpr std::size_t kMost = 200, kFewest = 40;
    if (mass < 1e-7) return;
    auto wanted = static_cast<std::size_t>(mass * static_cast<double>(m_cloud.capacity()));
    std::size_t count = std::clamp(wanted, kFewest, kMost), born = 0, first = m_cloud.walkers().size();
    for (std::size_t i = 0; i < count; ++i) {
        auto pose = m_sensors.drawPose(look, [this] { return m_cloud.random().uniformDouble(); });
        if (!pose) continue;
        m_cloud.walkers().push_back(m_cloud.born(*pose, 1.0F));
        ++born;
    }
    if (born == 0) return;
    auto each = static_cast<float>(mass / static_cast<double>(born));
    for (std::size_t i = first; i < m_cloud.walkers().size(); ++i) m_cloud.walkers()[i].weight = each;
}

void BayesLocaliser::weigh(const Observation& seen) {
    Look look = m_sensors.prepare(seen.detection);
    double trust = trustIn(seen), before = m_cloud.totalWeight();
    if (trust <= 0.0) return;
    m_strange = look.uniformRatio <= 0.0;
    m_grounded = m_grounded || !m_strange;
    auto power = static_cast<float>(trust);
    for (Walker& walker : m_cloud.walkers()) {
        Cause cause;
        float ratio = m_sensors.ratio(look, walker.region, walker.at, m_cloud.gazeOf(walker), &cause);
        // On stairs and in lifts next to nothing is recognised, but for the steps themselves.
        if (walker.climbTo >= 0 && look.kind != Kind::Stairs)
            ratio *= static_cast<float>(m_options.climbSees);
        if (ratio <= 0.0F) continue;
        walker.weight *= quickExp(power * std::log(1.0F + ratio));
        if (look.hasBearing && cause.part > kCertainly * (1.0F + ratio)) m_cloud.face(walker, cause);
    }
    double after = m_cloud.totalWeight();
    double uniform = std::pow(1.0 + look.uniformRatio, trust);
    double births = m_lost * (uniform - 1.0);
    giveBirth(look, births);
    if (before > 1e-6 && after > 0.0) doubt(std::log(uniform), std::log(after / before));
    normalise();
    m_cloud.renew();
    m_evidenceTime = std::max(m_evidenceTime, seen.time);
}

Fix BayesLocaliser::update(double time, std::span<const Observation> fresh, const std::deque<Observation>&) {
    if (!std::isfinite(time)) time = m_time;
    if (m_building->regions().empty()) {
        Fix fix;
        fix.time = time;
        fix.note = "the map has no regions";
        return fix;
    }
    m_motion.now(time);
    if (!fresh.empty() || time - m_time >= kStepS) advanceTo(std::max(time, m_time));
    for (const Observation& seen : fresh) weigh(seen);
    return summary(std::max(time, m_time));
}

void BayesLocaliser::sumMasses() {
    for (std::uint32_t region : m_touched) m_mass[region] = 0.0;
    m_touched.clear();
    for (const Walker& walker : m_cloud.walkers()) {
        if (m_mass[walker.region] == 0.0) m_touched.push_back(walker.region);
        m_mass[walker.region] += double(walker.weight) + 1e-300;
    }
}

Fix BayesLocaliser::summary(double time) {
    sumMasses();
    Fix fix;
    fix.time = time;
    fix.evidenceTime = m_evidenceTime;
    fix.followed = m_options.walking.free;
    std::vector<std::uint32_t> order = m_touched;
    std::sort(order.begin(), order.end(), [this](std::uint32_t a, std::uint32_t b) {
        return m_mass[a] != m_mass[b] ? m_mass[a] > m_mass[b] : a < b;
    });
    if (order.empty()) {
        fix.note = "nothing is known of the place";
        return fix;
    }
    std::uint32_t best = order.front();
    const building::Region& region = m_building->regions()[best];
    auto shareOf = [&](std::uint32_t r) {
        return m_mass[r] + m_lost * m_map->weightOf(r) / std::max(1.0, m_map->totalWeight());
    };
    fix.region = region.id;
    fix.level = region.level;
    double mass = shareOf(best), near = mass;
    fix.near.push_back(region.id);
    for (std::size_t neighbour : m_building->neighboursOf(best)) {
        near += shareOf(static_cast<std::uint32_t>(neighbour));
        fix.near.push_back(m_building->regions()[neighbour].id);
    }
    auto stated = [&](Statement withMotion, Statement without, double share) {
        share = std::min(1.0, share);
        return m_options.rawConfidence ? share : calibrated(m_motion.known() ? withMotion : without, share);
    };
    fix.confidence = stated(Statement::RegionByMotion, Statement::Region, mass);
    fix.nearConfidence = stated(Statement::NearByMotion, Statement::Near, near);
    // Where nothing was recognised yet even the only region of a map is no more than a guess.
    if (!m_grounded && !m_options.rawConfidence) {
        fix.confidence = std::min(fix.confidence, kGuess);
        fix.nearConfidence = std::min(fix.nearConfidence, kGuess);
    }
    fix.nearConfidence = std::max(fix.nearConfidence, fix.confidence);
    fix.note = noteNow();
    placeWithin(fix, best);
    addVotes(fix, order);
    return fix;
}

std::string BayesLocaliser::noteNow() const {
    if (m_building->landmarks().empty())
        return "the map has no landmarks, so nothing that is seen tells where the user is";
    if (!m_grounded) return "the start is unknown: no landmark seen yet";
    return m_strange ? "the map has no landmark like what was seen last" : "";
}

void BayesLocaliser::placeWithin(Fix& fix, std::uint32_t region) const {
    double sum = 0.0, x = 0.0, y = 0.0, xx = 0.0, yy = 0.0, east = 0.0, north = 0.0, walking = 0.0;
    for (const Walker& walker : m_cloud.walkers()) {
        if (walker.region != region) continue;
        double w = double(walker.weight), px = double(walker.at.x), py = double(walker.at.y);
        sum += w;
        x += w * px;
        y += w * py;
        xx += w * px * px;
        yy += w * py * py;
        if (walker.climbTo >= 0) continue;
        double heading = double(walker.headingDeg) * kPi / 180.0;
        east += w * std::cos(heading);
        north += w * std::sin(heading);
        walking += w;
    }
    if (!(sum > 0.0)) return;
    x /= sum;
    y /= sum;
    double variance = std::max(0.0, xx / sum - x * x) + std::max(0.0, yy / sum - y * y);
    fix.position = m_map->global({static_cast<float>(x), static_cast<float>(y)});
    double beside = m_options.sensors.positionSigmaM;
    fix.sigmaM = std::sqrt(variance / 2.0 + beside * beside);
    constexpr double kLeastResultant = 0.3;
    double resultant = walking > 0.5 * sum ? std::hypot(east, north) / walking : 0.0;
    if (resultant < kLeastResultant) return;
    fix.heading = Radians{std::atan2(north, east)};
    fix.headingSigma = Radians{std::sqrt(std::max(0.0, -2.0 * std::log(std::min(1.0, resultant))))};
}

void BayesLocaliser::addVotes(Fix& fix, const std::vector<std::uint32_t>& order) const {
    for (std::size_t i = 0; i < std::min(kVotesKept, order.size()); ++i) {
        double mass = m_mass[order[i]];
        if (mass < 0.005) break;
        RegionVote vote;
        vote.region = m_building->regions()[order[i]].id;
        vote.vote = mass;
        vote.terms = {{"weight", mass}, {"lost", m_lost}, {"against", m_against}};
        fix.votes.push_back(std::move(vote));
    }
}

} // namespace

WalkingOptions WalkingOptions::obedient() {
    // Found in the closed loop, where standing still at the goal is no sign of having reached it.
    WalkingOptions walking;
    walking.guided = true;
    walking.free = true;
    walking.followShare = 0.6;
    walking.strayRate = 0.05;
    walking.strayAtNode = 0.1;
    walking.returnRate = 0.1;
    return walking;
}

Result<void> WalkingOptions::check() const {
    bool speeds = slowest > 0.0 && slowest <= fastest && fastest <= hurrySpeed && speedSpread >= 0.0 &&
                  hurryShare >= 0.0 && hurryShare <= 1.0;
    bool rates =
        stopRate >= 0.0 && goRate >= 0.0 && strayRate >= 0.0 && returnRate >= 0.0 && straightBack >= 0.0;
    bool sigmas = swaySigmaDeg > 0.0 && turnSigmaDeg >= 0.0 && unknownTurnSigmaDeg >= 0.0 &&
                  paceTrust > 0.0 && paceTrust <= 1.0;
    bool freely = bodySwayDeg >= 0.0 && swaySeconds > 0.0 && throughUnasked >= 0.0 && alongWallM > 0.0 &&
                  otherDoor >= 0.0 && climbUntold >= 0.0 && doorRate >= 0.0 && doorUnasked >= 0.0 &&
                  climbRate >= 0.0 && climbUnasked >= 0.0;
    if (speeds && rates && sigmas && freely) return {};
    return Error{ErrorCode::InvalidArgument, "rates are not negative, speeds and deviations are above 0",
                 "bayes.walking"};
}

Result<void> BayesOptions::check() const {
    if (auto checked = sensors.check(); !checked) return checked;
    if (auto checked = walking.check(); !checked) return checked;
    bool shares = startTrust > 0.0 && startTrust < 1.0 && resetShare >= 0.0 && resetShare < 1.0 &&
                  climbSees >= 0.0 && climbSees <= 1.0 && evenness >= 0.0 && evenness <= 1.0;
    if (shares && trust >= 0.0 && trustRepeated >= 0.0 && trackSeconds >= 0.0 && lostRate >= 0.0 &&
        blindLostRate >= 0.0)
        return {};
    return Error{ErrorCode::InvalidArgument, "shares are between 0 and 1, rates and exponents not negative",
                 "bayes"};
}

std::unique_ptr<Localiser> makeBayesLocaliser(std::shared_ptr<const building::Building> building,
                                              BayesOptions options) {
    return std::make_unique<BayesLocaliser>(std::move(building), options);
}

} // namespace farol::localisation
