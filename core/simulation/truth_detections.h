#pragma once
// What detectors would say of a frame, drawn from the truth instead of a picture: with misses, false ones,
// confused kinds, misread numbers and a map that is not up to date, at the rates of the localisation study.
// And the picture's motion since the look before, as it would be measured.

#include "core/localisation/random.h"
#include "core/recognition/detection.h"
#include "core/simulation/camera_pose.h"
#include "core/simulation/walk_world.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace farol::simulation {

struct TruthDetectionOptions {
    std::uint64_t seed = 1;
    double detectionsPerSecond = 0.33; ///< of one landmark in full view
    double wrongKind = 0.07, misread = 0.15, noRange = 0.07;
    double stale = 0.05;                                 ///< landmarks of the map that are no longer there
    double falsePerSecond = 0.018, clutterPerM2 = 0.035; ///< invented; and real, but not in the map
    double lostFlow = 0.05;                              ///< motion that cannot be told
    double viewDegrees = 60.0;
    double reachM = 4.2;
    /// As this program's own recognisers see rendered pictures: trained things as far as their size allows,
    /// in nearly each look, with a range good to a tenth; followed from look to look; hardly anything
    /// invented.
    bool camera = false;

    static TruthDetectionOptions ofCamera();
    Result<void> check() const;
};

struct TruthSight {
    std::vector<recognition::Detection> detections;
    recognition::Motion motion; ///< since the last time that it told any
    int scene = 0;
};

/// Deterministic. Called with rising times.
class TruthDetections {
public:
    TruthDetections(std::shared_ptr<const WalkWorld> world, const TruthDetectionOptions& options);

    TruthSight look(const CameraPose& pose, std::size_t region);

private:
    struct Thing {
        Kind kind = Kind::Other;
        TemplateId templateId;
        std::string text;
        Point2 at;
        std::optional<Radians> facing;
        double heightM = 1.4, wideM = 0.5, tallM = 0.5;
        double luck = 1.0; ///< of being found on this visit: misses of one object go together
        double lastSeen = -100.0, lastTold = -100.0;
        double reachM = 4.2;
        std::uint64_t track = 0; ///< of this visit
        int confirmations = 0;
    };

    void placeThings();
    void placeThing(const building::Landmark& landmark);
    void addClutter(std::size_t region);
    void seeRegion(std::size_t region, const Passage* through);
    void see(Thing& thing, std::size_t region, const Passage* through);
    bool inView(const Thing& thing, std::size_t region, const Passage* through, double range) const;
    void tell(const Thing& thing, double range, Radians bearing, bool invented);
    double seenPerSecond(const Thing& thing, double range) const;
    void invent();
    recognition::Motion motion();
    Kind confused(Kind kind);
    std::string misread(std::string text);

    bool chance(double probability) { return m_random.uniformDouble() < probability; }
    double between(double low, double high) { return low + (high - low) * m_random.uniformDouble(); }
    std::size_t below(std::size_t count);

    std::shared_ptr<const WalkWorld> m_world;
    TruthDetectionOptions m_options;
    localisation::Random m_random;
    std::vector<std::vector<Thing>> m_things; ///< of each region
    std::vector<std::string> m_texts;         ///< of the map
    double m_scale;                           ///< of the motion's speed, which is not known
    std::uint64_t m_lastTrack = 0;

    CameraPose m_pose;
    std::size_t m_region = 0;
    double m_seconds = 0.0; ///< since the look before
    TruthSight m_sight;
    bool m_looked = false;
    double m_motionAt = 0.0, m_walkedM = 0.0;
    Radians m_motionHeading;
    double m_sceneAt = 0.0;
};

} // namespace farol::simulation
