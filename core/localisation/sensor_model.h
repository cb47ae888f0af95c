#pragma once
// How likely a detection is from a pose: which landmarks can be seen from there, how they are confused,
// misread and misjudged in range, and how often something is detected that the map does not know.

#include "core/base/error.h"
#include "core/localisation/walking_map.h"
#include "core/recognition/detection.h"

#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace farol::localisation {

/// By the poor eyes no landmark is recognised from farther away.
inline constexpr float kPoorlySeenM = 4.6F;
inline constexpr std::size_t kKindCount = static_cast<std::size_t>(Kind::Other) + 1;

/// Probabilities and rates of the sensors, fitted on walks of buildings of our own (tests/bench/README.md).
struct SensorOptions {
    /// What the recognisers of this program see through a camera: trained things as far as their size allows,
    /// again and again. Off: eyes as poor as those of the localisation study, 4 m and one sight in three
    /// seconds.
    bool camera = false;
    double detectionsPerSecond = 0.35; ///< of one landmark in full view
    double falsePerSecond = 0.0168;    ///< of things that the map does not hold
    double sameKind = 0.94;            ///< a landmark is reported as what it is
    /// For each thing on the map, so many like it that the map does not hold: they are found as surely, but
    /// anywhere.
    double unmappedShare = 0.0;
    double mappedFalseText = 0.15; ///< share of false texts that stand elsewhere in the map
    double textRead = 0.72, textOneOff = 0.2, textTwoOff = 0.03;
    double positionSigmaM = 0.45; ///< of where the walker is beside the straight line
    double stairsSigmaM = 0.45;   ///< the same towards stairs
    double bearingSigmaDeg = 4.0;
    double zoneSigmaDeg = 7.0; ///< when the bearing is guessed from the place in the picture
    double placeSigmaM = 1.5, placeSigmaDeg = 30.0; ///< from where a trained place is recognised
    double otherTemplate = 0.02; ///< a landmark is taken for one of another template of its kind
    /// Stairs that the map does not list, from whichever end: how surely they are found, against listed ones.
    double unmarkedStairs = 0.3;
    /// What floors of one building look like: an unsurveyed spot just above or below a place is taken for it,
    /// against the place itself.
    double unsurveyedTwin = 0.9;
    double lookAlikeFalse = 10.0; ///< how much oftener a place is told wrongly where another fits as well
    double farthestM = 20.0;      ///< of what a camera recognises
    double sizesAway = 22.0;      ///< a trained thing is recognised from so many of its own sizes away
    double missShare = 0.25;      ///< of what a camera should have seen: misses of one thing go together

    /// Eyes of this program's own recognisers, fitted on rendered pictures.
    static SensorOptions ofCamera();

    Result<void> check() const;
};

/// A detection made ready: factors that do not depend on the pose.
struct Look {
    Kind kind = Kind::Other;
    std::array<float, kKindCount> kindFactor{}; ///< detections per second of a landmark of that kind
    std::vector<float> textFactor;              ///< of each distinct text of the map; empty: not a text
    std::int32_t templateIndex = -1;            ///< -1: none, or one that the map does not hold
    /// Of a place that was told with its look-alikes: of each template of the map, how well the view fits it
    /// beside the told one. Empty: not told.
    std::vector<float> placeFactor;
    bool hasTemplate = false;
    float otherTemplate = 0.0F; ///< likelihood of another template of the map, against the told one
    float logRange = 0.0F;      ///< natural logarithm of metres
    bool hasRange = false;
    float rangeVariance = 0.0F;
    float bearingDeg = 0.0F;
    float besideM = 0.0F; ///< deviation of the walker and of the thing from where they are thought to be
    bool hasBearing = false;
    float bearingVariance = 0.0F;
    float inverseFalse = 0.0F;     ///< 1 / likelihood of a false detection like this
    std::vector<double> groupSums; ///< running sum of the groups drawn from: kinds, then texts; or items
    double uniformRatio = 0.0; ///< likelihood ratio against a false detection, averaged over the whole map
};

/// Where the camera looks, in degrees; `unknownShare`: how likely it looks anywhere at all.
struct Gaze {
    float yawDeg = 0.0F;
    float variance = 0.0F;
    float unknownShare = 0.0F;
};

/// What most probably caused a detection, and how far it lies beside where it was expected.
struct Cause {
    float part = 0.0F; ///< of the ratio
    float offDeg = 0.0F;
    float variance = 0.0F; ///< of offDeg, for a camera that looks exactly there
};

/// A pose from which a detection could have been made.
struct BirthPose {
    std::uint32_t region = 0;
    Spot at;
    float yawDeg = 0.0F;
};

class SensorModel {
public:
    SensorModel(std::shared_ptr<const WalkingMap> map, const SensorOptions& options);

    Look prepare(const recognition::Detection& detection) const;
    /// Likelihood of the mapped landmarks against a false detection; 0: no landmark explains it.
    float ratio(const Look& look, std::uint32_t region, Spot at, const Gaze& gaze,
                Cause* cause = nullptr) const;
    /// Detections per second to be expected there.
    float expectedRate(std::uint32_t region, Spot at, const Gaze& gaze) const;
    /// The same for cameras that look in each of evenly spread directions (the first half a step from east),
    /// known to within `sigmaDeg`; cheaper than one by one.
    void expectedRates(std::uint32_t region, Spot at, float sigmaDeg, std::span<float> byDirection) const;
    /// A pose drawn in proportion to ratio(); `next` gives numbers from 0 to 1. Empty when no place was
    /// found.
    template <class Next>
    std::optional<BirthPose> drawPose(const Look& look, Next&& next) const;

private:
    struct Item { ///< a landmark
        Spot at;
        float nx = 0.0F, ny = 0.0F; ///< the way it faces; (0, 0): any
        std::uint32_t region = 0;
        std::int32_t text = -1, templateIndex = -1;
        std::uint8_t kind = 0;
        bool twin = false;   ///< no place, but what one on another floor may be mistaken for
        float share = 0.0F;  ///< of all walking from where it is in view
        float reachM = 0.0F; ///< recognised from no farther away
        float plain = 1.0F;  ///< how surely it is found, against others of its kind
    };
    struct View { ///< a landmark as seen from a region
        float along = 0.0F;
        std::uint32_t item = 0;
        std::int32_t opening = -1; ///< through which it is seen
    };
    struct Gap {
        Spot a, b;
    };
    struct Geometry {
        float range = 0.0F, dx = 0.0F, dy = 0.0F, visible = 0.0F;
    };

    using Texts = std::map<std::string, std::int32_t>;

    void addLandmarks();
    void addLandmark(const building::Landmark& landmark, Texts& texts, float plain = 1.0F);
    void addItem(Item item);
    void addTwins();
    static bool surveyed(const Item& like, const std::vector<Item>& places);
    void addViews();
    void weighLookAlikes(const recognition::Detection& detection, Look& look, double& falseFactor) const;
    static double falsePlace(double strength);
    bool elsewhere(std::int32_t one, std::int32_t other) const;
    bool geometryOf(const Item& item, const View& view, std::uint32_t region, Spot at,
                    Geometry& geometry) const;
    float reachOf(const building::Landmark& landmark) const;
    float visibleAt(const Item& item, float range) const;
    double spreadOfRange(const recognition::Detection& detection) const;
    double oftenerThanDoors(Kind kind, bool trained) const;
    static float inPicture(float offDeg, float steepness);
    float rateOf(const Item& item, const Geometry& geometry) const;
    float factorOf(const Look& look, const Item& item) const;
    float placeRatio(const Look& look, const Item& item, Spot at, const Gaze& gaze, float factor) const;
    float likelihoodOf(const Look& look, const Geometry& geometry, const Gaze& gaze) const;
    Cause causeOf(const Look& look, const Geometry& geometry, const Gaze& gaze, float part) const;
    std::span<const View> viewsNear(std::uint32_t region, Spot at) const;
    void readText(const recognition::Detection& detection, Look& look, double& falseFactor) const;
    void weighUniform(Look& look) const;
    std::uint32_t drawItem(const Look& look, double u, double v) const;
    BirthPose poseAt(const Item& item, const Look& look, double u, double v, double w) const;

    std::shared_ptr<const WalkingMap> m_map;
    SensorOptions m_options;
    float m_farthestM; ///< no landmark is recognised from farther away
    std::vector<Item> m_items;
    std::vector<View> m_views;
    std::vector<std::uint32_t> m_firstView;
    std::vector<char> m_alongY; ///< of each region: sorted by y, else by x
    std::vector<Gap> m_gaps;
    std::vector<std::string> m_texts, m_shapes; ///< distinct; and with look-alike letters as one
    std::vector<std::vector<std::uint32_t>> m_itemsOfText;
    std::vector<float> m_shareOfText;
    std::map<std::string, std::int32_t> m_templates;
    std::map<std::int32_t, std::vector<std::uint32_t>> m_placesOf; ///< of each template, without twins
    std::array<std::vector<std::uint32_t>, kKindCount> m_itemsOfKind;
    std::array<std::vector<float>, kKindCount> m_sharesUpTo;
};

template <class Next>
std::optional<BirthPose> SensorModel::drawPose(const Look& look, Next&& next) const {
    if (look.uniformRatio <= 0.0) return std::nullopt;
    double u = next(), v = next();
    std::uint32_t index = drawItem(look, u, v);
    if (index >= m_items.size()) return std::nullopt;
    const Item& item = m_items[index];
    constexpr int kTries = 6;
    for (int i = 0; i < kTries; ++i) {
        double a = next(), b = next(), c = next();
        BirthPose pose = poseAt(item, look, a, b, c);
        if (m_map->inside(pose.region, pose.at)) return pose;
    }
    return std::nullopt;
}

/// Edit distance of two texts, 3 for all above 2; bytes, as texts are folded.
int shortEditDistance(std::string_view a, std::string_view b);

} // namespace farol::localisation
