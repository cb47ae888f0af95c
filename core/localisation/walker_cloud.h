#pragma once
// The walkers of the filter: how they move, choose their way, are weighed and drawn anew.

#include "core/localisation/bayes_localiser.h"
#include "core/localisation/random.h"
#include "core/localisation/rate_cache.h"

#include <vector>

namespace farol::localisation {

/// One guess of the user's whole state.
struct Walker {
    static constexpr std::int32_t kToSpot = -1, kResting = -2;

    Spot at, target;
    std::uint32_t region = 0;
    std::int32_t node = kToSpot; ///< walked to; or kToSpot, kResting
    std::int32_t climbTo = -1;   ///< the node beyond stairs or a lift while on them
    float climbM = 0.0F;         ///< still to climb
    float speed = 0.75F;
    float headingDeg = 0.0F;                 ///< of walking
    float yawDeg = 0.0F, yawVariance = 1e6F; ///< of the camera
    float graceS = 0.0F;                     ///< still turning to the new heading
    float swayDeg = 0.0F;                    ///< of the camera against the body, of those who walk freely
    float weight = 0.0F;
    std::uint8_t watch = 0; ///< 0: of the belief; 1, 2: of those kept apart from it
    bool follows = false;
    bool stands = false;
    bool climbShows = false; ///< the picture tells the steps of this climb
};

/// What is known of the motion of a span of time.
struct MotionSpan {
    double seconds = 0.0;
    bool measured = false;      ///< the picture told at least the speed
    double pace = 1.0;          ///< times the walker's own speed
    float turnDeg = 0.0F;       ///< of the camera
    double unseenSeconds = 0.0; ///< of which the turn is not known
    /// In which the picture showed something. Before a bare wall or covered it tells no motion either: then
    /// nothing could be seen, and nothing is missed.
    double shownSeconds = 0.0;
};

class WalkerCloud {
public:
    WalkerCloud(std::shared_ptr<WalkingMap> map, const BayesOptions& options);

    std::vector<Walker>& walkers() { return m_walkers; }
    const std::vector<Walker>& walkers() const { return m_walkers; }
    Random& random() { return m_random; }
    void clear(std::uint64_t seed);
    std::size_t capacity() const { return m_capacity; }

    /// Walkers all over the map (`region` empty) or in a region, together of that weight.
    void spread(std::size_t count, double weight, std::optional<std::uint32_t> region,
                std::uint8_t watch = 0);
    /// A walker at a pose, heading about where the camera looks.
    Walker born(const BirthPose& pose, float weight);
    /// Every walker thinks anew about the way: a goal was set or taken away.
    void reconsider();
    void told(const std::optional<ToldWay>& way) { m_told = way; }
    /// How well the motion fits, in the mean: what it did to the weights beside the things not seen.
    double advance(const MotionSpan& motion, const SensorModel& sensors, double missTrust);
    /// What was seen off the place expected corrects where the walker's camera looks.
    void face(Walker& walker, const Cause& cause) const;
    Gaze gazeOf(const Walker& walker) const;
    double totalWeight() const;
    void scale(double factor);
    /// Draws walkers anew where too few carry the weight: of the belief, and of each watch by itself, so that
    /// a young doubt has its time before it is weighed against the belief.
    void renew();
    std::size_t watchCapacity() const { return m_capacity / 4; }
    /// The older watch joins the belief, and a new one begins with walkers all over the map.
    void changeWatch(double weight);
    std::uint8_t watch() const { return m_watch; }
    double meanSpeed() const;

private:
    void choose(Walker& walker, std::int32_t from);
    void chooseWay(Walker& walker);
    float weighNodes(const Walker& walker, std::int32_t from);
    void wander(Walker& walker, std::int32_t from);
    void headFor(Walker& walker, std::int32_t node, Spot target);
    void changeMind(Walker& walker, double seconds);
    void walk(Walker& walker, float metres);
    void arrive(Walker& walker);
    void climb(Walker& walker, float metres);
    float turn(Walker& walker, const MotionSpan& motion, bool moving);
    float settle(Walker& walker);
    float standingWeight(Walker& walker, const MotionSpan& motion, bool moving);
    float drawSpeed();
    // Walking freely (stride.cpp): where the camera looks, between the walls.
    void stride(Walker& walker, const MotionSpan& motion, bool moving, float metres);
    void roam(Walker& walker, float metres);
    bool passThrough(Walker& walker, Spot way, float& metres);
    void slide(Walker& walker, Spot way, float metres);
    float doorShare(std::uint32_t node) const;
    double climbRate(std::uint32_t node) const;
    void mayTake(Walker& walker, bool moving, float seconds);
    void renew(std::size_t first, std::size_t last, std::size_t capacity);

    std::shared_ptr<WalkingMap> m_map;
    BayesOptions m_options;
    Random m_random;
    std::size_t m_capacity;
    RateCache m_rates;
    std::vector<Walker> m_walkers, m_sorted;
    std::vector<std::uint32_t> m_nodes;        ///< scratch of wander()
    std::vector<float> m_weights;              ///< scratch of wander() and chooseWay()
    std::vector<double> m_sums;                ///< scratch of renew()
    std::vector<float> m_shares;               ///< of each region; scratch of renew()
    double m_speed = 0.0, m_speedSpread = 0.0; ///< of walkers yet to come: what is known of this user
    bool m_motionKnown = false;
    std::uint8_t m_watch = 1;      ///< the younger
    std::optional<ToldWay> m_told; ///< empty: nobody told what is said
};

float wrappedDeg(float degrees);

} // namespace farol::localisation
