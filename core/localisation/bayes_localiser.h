#pragma once
// A filter over where the user is, which way the camera looks and where the user is heading: a cloud of
// weighted walkers on the walking map, each with its own pace and intention. Answers a probability, and knows
// when it does not know.

#include "core/base/error.h"
#include "core/localisation/localiser.h"
#include "core/localisation/sensor_model.h"

#include <memory>

namespace farol::localisation {

/// How people walk. Rates per second.
struct WalkingOptions {
    double speed = 0.75, speedSpread = 0.2; ///< metres a second
    double slowest = 0.35, fastest = 1.3;
    double hurryShare = 0.04, hurrySpeed = 2.2; ///< some walkers are ready for anybody faster, up to that
    double stopRate = 0.036, goRate = 0.34;
    double followShare = 0.9;   ///< of walkers that go to the destination after it was told
    double strayRate = 0.008;   ///< leaves the way
    bool guided = false;        ///< knows the way only from what is said: stands and searches anywhere
    double strayAtNode = 0.03;  ///< takes another door than the right one
    double straightBack = 0.5;  ///< how gladly a stray goes back through the door just passed
    double returnRate = 0.05;   ///< finds back to the way
    double swaySigmaDeg = 24.0; ///< of the camera about the way of walking
    double swaySeconds = 1.5;   ///< and how soon it comes back
    double looksAway = 0.1;     ///< each second, of those who walk
    double lookShareGoing = 0.12, lookShareStanding = 0.5; ///< looks anywhere
    double turnSigmaDeg = 5.0;                             ///< of a measured turn
    double unknownTurnSigmaDeg = 35.0;
    double distanceSigma = 0.3; ///< of a measured speed, as a share
    /// Exponent of a measured pace. 1: as it is. Below: people keep their pace better than a picture tells
    /// it, in which a wide room or a floor that mirrors looks like a slower walk.
    double paceTrust = 1.0;
    double headingTrust = 0.5; ///< exponent of what a measured turn tells
    bool free = false;         ///< goes where the camera looks, between the walls, and not from door to door
    double bodySwayDeg = 15.0; ///< of the camera about the body, for those who walk freely
    double throughUnasked = 0.4; ///< how likely a door is taken that does not lead on, against one that does
    double alongWallM = 0.5;     ///< nobody walks into walls for longer
    double doorRate = 1.0, doorUnasked = 0.15;   ///< takes the door at hand, facing it
    double climbRate = 0.3, climbUnasked = 0.03; ///< takes the stairs or the lift at hand
    double otherDoor = 0.6;                      ///< told of a door, how likely another is taken for it
    double climbUntold = 0.003;                  ///< climbs who was told of something else

    Result<void> check() const;
    /// Of one who obeys what is told, and is not on a way that he knows.
    static WalkingOptions obedient();
};

struct BayesOptions {
    SensorOptions sensors;
    WalkingOptions walking;
    std::size_t walkers = 0;     ///< 0: by the size of the map
    double trust = 0.8;          ///< exponent of a detection's likelihood ratio
    double trustRepeated = 0.35; ///< of one like another in the last `repeatSeconds`
    double repeatSeconds = 4.0;
    double trackSeconds = 1.5;   ///< the same thing, followed all the while, tells anew only then
    double climbSees = 0.05;     ///< what is seen on stairs and in lifts, against elsewhere
    double missTrust = 0.5;      ///< exponent of what should have been seen and was not
    double lostRate = 0.0006;    ///< per second: carried elsewhere, unseen
    double blindLostRate = 0.03; ///< the same while the camera gives nothing
    double watchSeconds = 15.0;  ///< how often some begin to look everywhere, apart from the belief
    double startTrust = 0.97;
    double resetAt = 3.5, resetShare = 0.3; ///< log evidence against the belief, and what is doubted then
    double evenness = 0.4; ///< 0: walkers by the share of their region; 1: every region alike
    bool useMotion = true;
    bool rawConfidence = false; ///< the bare shares, for making the table of confidences
    std::uint64_t seed = 0x5eedfa201ULL;

    Result<void> check() const;
};

std::unique_ptr<Localiser> makeBayesLocaliser(std::shared_ptr<const building::Building> building,
                                              BayesOptions options = {});

} // namespace farol::localisation
