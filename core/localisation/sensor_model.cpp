#include "core/localisation/sensor_model.h"

#include "core/base/text.h"
#include "core/building/unmarked_landmarks.h"
#include "core/localisation/quick_math.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace farol::localisation {

using building::Landmark;
using recognition::Detection;

namespace {

constexpr float kHalfViewDeg = 30.0F; // of the camera
constexpr float kSteepness = 1.7F;    // of a logistic curve, to be like a normal one of sigma 1
constexpr float kRadToDeg = 57.29578F;
constexpr float kLog2 = 0.6931472F;
constexpr double kLetters = 36.0, kGuessedLetter = 1.0 / 30.0;
constexpr double kViewM2 = 7.0; // full views of a wall object, in square metres of a corridor

std::size_t indexOf(Kind kind) {
    return static_cast<std::size_t>(kind);
}

/// Of all false detections, the share of each kind.
double falseShare(Kind kind) {
    switch (kind) {
    case Kind::Door:
        return 0.18;
    case Kind::Rectangle:
        return 0.30;
    case Kind::Poster:
        return 0.24;
    case Kind::Text:
        return 0.14;
    case Kind::Locker:
        return 0.12;
    case Kind::Extinguisher:
    case Kind::ExitSign:
        return 0.04;
    default:
        return 0.02;
    }
}

/// Known by what is printed on it; others of the same maker share its heading or its frame.
bool printed(Kind kind) {
    return kind == Kind::Poster || kind == Kind::Picture || kind == Kind::Sign || kind == Kind::Other;
}

/// Log-odds of a match that is as often right as matches are in general.
constexpr double kUsualStrength = 5.25;

/// How much oftener than usual a trained thing that is this well explained (logarithm of the odds) is another
/// one that shares a part with it. In rendered walks with many posters that the map does not hold 13 of 24
/// were others below 2.5, 19 of 108 up to 5 and 1 of 700 above; of exit signs, extinguishers and bins, which
/// are as weakly explained more often, 1 of 578.
double weaklyExplained(Kind kind, double strength) {
    constexpr double kLeast = -2.0, kMost = 3.25;
    if (!printed(kind) || strength <= 0.0) return 1.0;
    return std::exp(std::clamp(kUsualStrength - strength, kLeast, kMost));
}

/// A thing that is well explained is seldom taken for another of the map: none of some 1,100 in the same
/// walks, of whatever strength.
double takenForOther(Kind kind, double strength) {
    constexpr double kLeast = -2.3;
    if (!printed(kind) || strength <= 0.0) return 1.0;
    return std::exp(std::clamp(kUsualStrength - strength, kLeast, 0.0));
}

/// A mapped `actual` is reported as `reported`: share of the confusions.
double lookAlike(Kind actual, Kind reported) {
    auto is = [&](Kind a, Kind b) { return actual == a && reported == b; };
    if (is(Kind::Door, Kind::Rectangle) || is(Kind::Rectangle, Kind::Poster)) return 0.6;
    if (is(Kind::Door, Kind::Locker) || is(Kind::Rectangle, Kind::Door)) return 0.4;
    if (is(Kind::Locker, Kind::Door) || is(Kind::Locker, Kind::Rectangle)) return 0.5;
    if (is(Kind::ExitSign, Kind::Rectangle)) return 0.7;
    if (is(Kind::ExitSign, Kind::Poster)) return 0.3;
    if (is(Kind::Text, Kind::Poster)) return 1.0;
    bool own = actual == Kind::Door || actual == Kind::Rectangle || actual == Kind::Locker ||
               actual == Kind::ExitSign || actual == Kind::Text;
    if (own || actual == Kind::Place) return 0.0;
    return reported == Kind::Rectangle ? 1.0 : 0.0;
}

/// Signs and door plates are read as texts too.
bool wordy(Kind kind) {
    return kind == Kind::Text || kind == Kind::Sign;
}

float wrapDeg(float a) {
    while (a > 180.0F) a -= 360.0F;
    while (a <= -180.0F) a += 360.0F;
    return a;
}

float normalDensity(float x, float variance) {
    return quickExp(-0.5F * x * x / variance) * 0.39894228F / std::sqrt(variance);
}

/// Letters that are read for one another are the same here: "floor o" is "floor 0", and not "floor 1".
std::string shapeOf(std::string text) {
    constexpr std::string_view kRead = "oilszb", kMeant = "011528";
    for (char& c : text)
        if (auto at = kRead.find(c); at != std::string_view::npos) c = kMeant[at];
    return text;
}

/// Of the logarithm of the range of what is no landmark.
float falseRangeVariance(const SensorOptions& options) {
    return options.camera ? 1.0F : 0.25F;
}

bool crosses(Spot a, Spot b, Spot c, Spot d) {
    auto side = [](Spot p, Spot q, Spot r) { return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x); };
    return side(a, b, c) * side(a, b, d) <= 0.0F && side(c, d, a) * side(c, d, b) <= 0.0F;
}

} // namespace

int shortEditDistance(std::string_view a, std::string_view b) {
    constexpr int kMany = 3;
    constexpr std::size_t kLongest = 30;
    if (a == b) return 0;
    std::size_t longer = std::max(a.size(), b.size()), shorter = std::min(a.size(), b.size());
    if (longer - shorter > 2 || longer > kLongest) return kMany;
    std::array<int, kLongest + 1> row{};
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        int diagonal = row[0], least = row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            int change = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({change, row[j] + 1, row[j - 1] + 1});
            least = std::min(least, row[j]);
        }
        if (least >= kMany) return kMany;
    }
    return std::min(row[b.size()], kMany);
}

Result<void> SensorOptions::check() const {
    bool rates = detectionsPerSecond > 0.0 && falsePerSecond > 0.0;
    bool sigmas = positionSigmaM > 0.0 && stairsSigmaM > 0.0 && bearingSigmaDeg > 0.0 && zoneSigmaDeg > 0.0 &&
                  placeSigmaM > 0.0 && placeSigmaDeg > 0.0;
    bool shares = sameKind > 0.0 && sameKind <= 1.0 && unmappedShare >= 0.0 && mappedFalseText >= 0.0 &&
                  mappedFalseText < 1.0 && otherTemplate >= 0.0 && otherTemplate <= 1.0 &&
                  unsurveyedTwin >= 0.0 && unsurveyedTwin <= 1.0 && lookAlikeFalse >= 0.0 &&
                  farthestM > 0.0 && sizesAway > 0.0 && unmarkedStairs >= 0.0 && unmarkedStairs <= 1.0 &&
                  missShare >= 0.0 && missShare <= 1.0;
    if (rates && sigmas && shares) return {};
    return Error{ErrorCode::InvalidArgument, "rates and deviations are above 0, shares from 0 to 1",
                 "bayes.sensors"};
}

SensorModel::SensorModel(std::shared_ptr<const WalkingMap> map, const SensorOptions& options)
    : m_map(std::move(map)), m_options(options), m_farthestM(kPoorlySeenM) {
    addLandmarks();
    addViews();
}

void SensorModel::addLandmarks() {
    const auto& building = m_map->building();
    Texts texts;
    for (const Landmark& landmark : building.landmarks()) addLandmark(landmark, texts);
    if (m_options.camera) {
        for (const Landmark& door : building::unmarkedDoors(building)) addLandmark(door, texts);
        for (const Landmark& stairs : building::unmarkedStairs(building))
            addLandmark(stairs, texts, static_cast<float>(m_options.unmarkedStairs));
    }
    addTwins();
}

void SensorModel::addLandmark(const Landmark& landmark, Texts& texts, float plain) {
    const auto& building = m_map->building();
    auto region = building.regionIndex(landmark.region);
    if (!region) region = building.regionAt(landmark.position, landmark.level);
    if (!region || !isFinite(landmark.position)) return;
    Item item;
    item.at = m_map->local(landmark.position);
    item.region = static_cast<std::uint32_t>(*region);
    item.kind = static_cast<std::uint8_t>(indexOf(landmark.kind));
    item.reachM = reachOf(landmark);
    item.plain = plain;
    m_farthestM = std::max(m_farthestM, item.reachM);
    if (landmark.heading) {
        item.nx = static_cast<float>(std::cos(landmark.heading->value));
        item.ny = static_cast<float>(std::sin(landmark.heading->value));
    }
    if (!landmark.templateId.empty())
        item.templateIndex =
            m_templates.try_emplace(landmark.templateId.value, static_cast<std::int32_t>(m_templates.size()))
                .first->second;
    if (landmark.kind == Kind::Place && item.templateIndex >= 0)
        m_placesOf[item.templateIndex].push_back(static_cast<std::uint32_t>(m_items.size()));
    if (std::string text = foldedForMatching(landmark.text); !text.empty()) {
        item.text = texts.try_emplace(text, static_cast<std::int32_t>(texts.size())).first->second;
        if (static_cast<std::size_t>(item.text) == m_texts.size()) {
            m_texts.push_back(text);
            m_shapes.push_back(shapeOf(text));
            m_itemsOfText.emplace_back();
            m_shareOfText.push_back(0.0F);
        }
    }
    addItem(item);
}

void SensorModel::addItem(Item item) {
    auto index = static_cast<std::uint32_t>(m_items.size());
    double size = std::max(1.0, area(m_map->building().regions()[item.region].polygon));
    item.share = item.plain * static_cast<float>(std::min(size, kViewM2) * m_map->weightOf(item.region) /
                                                 size / std::max(1.0, m_map->totalWeight()));
    m_itemsOfKind[item.kind].push_back(index);
    auto& sums = m_sharesUpTo[item.kind];
    sums.push_back((sums.empty() ? 0.0F : sums.back()) + item.share);
    if (item.text >= 0 && wordy(static_cast<Kind>(item.kind))) {
        m_itemsOfText[static_cast<std::size_t>(item.text)].push_back(index);
        m_shareOfText[static_cast<std::size_t>(item.text)] += item.share;
    }
    m_items.push_back(item);
}

void SensorModel::addViews() {
    const auto& building = m_map->building();
    std::size_t count = building.regions().size();
    std::vector<std::vector<std::uint32_t>> own(count);
    for (std::uint32_t i = 0; i < m_items.size(); ++i) own[m_items[i].region].push_back(i);
    std::vector<std::vector<std::int32_t>> gaps(count);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
    for (const building::Access& access : building.accesses()) {
        auto a = building.regionIndex(access.regionA), b = building.regionIndex(access.regionB);
        if (access.kind != building::AccessKind::Opening || !a || !b || access.line.empty()) continue;
        Point2 p = access.line.front(), q = access.line.back();
        double wide = access.widthM.value_or(1.2);
        if (distance(p, q) < 0.2) p = p - Point2{wide / 2, wide / 2}, q = q + Point2{wide / 2, wide / 2};
        auto gap = static_cast<std::int32_t>(m_gaps.size());
        m_gaps.push_back({m_map->local(p), m_map->local(q)});
        sides.emplace_back(static_cast<std::uint32_t>(*a), static_cast<std::uint32_t>(*b));
        gaps[*a].push_back(gap);
        gaps[*b].push_back(gap);
    }
    m_firstView.assign(count + 1, 0);
    m_alongY.assign(count, 0);
    for (std::uint32_t r = 0; r < count; ++r) {
        auto box = boundingBox(building.regions()[r].polygon.outer);
        m_alongY[r] = box && box->height() > box->width() ? 1 : 0;
        std::size_t first = m_views.size();
        auto add = [&](std::uint32_t item, std::int32_t gap) {
            m_views.push_back({m_alongY[r] != 0 ? m_items[item].at.y : m_items[item].at.x, item, gap});
        };
        for (std::uint32_t item : own[r]) add(item, -1);
        for (std::int32_t gap : gaps[r]) {
            auto [a, b] = sides[static_cast<std::size_t>(gap)];
            const Gap& line = m_gaps[static_cast<std::size_t>(gap)];
            Spot middle{(line.a.x + line.b.x) / 2, (line.a.y + line.b.y) / 2};
            for (std::uint32_t item : own[a == r ? b : a])
                if (m_items[item].kind != indexOf(Kind::Place) &&
                    gapBetween(m_items[item].at, middle) < m_items[item].reachM)
                    add(item, gap);
        }
        std::sort(m_views.begin() + static_cast<std::ptrdiff_t>(first), m_views.end(),
                  [](const View& x, const View& y) {
                      return x.along != y.along ? x.along < y.along : x.item < y.item;
                  });
        m_firstView[r + 1] = static_cast<std::uint32_t>(m_views.size());
    }
}

std::span<const SensorModel::View> SensorModel::viewsNear(std::uint32_t region, Spot at) const {
    float along = m_alongY[region] != 0 ? at.y : at.x;
    auto first = m_views.begin() + m_firstView[region], last = m_views.begin() + m_firstView[region + 1];
    auto low = std::lower_bound(first, last, along - m_farthestM,
                                [](const View& view, float value) { return view.along < value; });
    auto high = low;
    while (high != last && high->along <= along + m_farthestM) ++high;
    return {low, high};
}

bool SensorModel::geometryOf(const Item& item, const View& view, std::uint32_t region, Spot at,
                             Geometry& geometry) const {
    geometry.dx = item.at.x - at.x;
    geometry.dy = item.at.y - at.y;
    float square = geometry.dx * geometry.dx + geometry.dy * geometry.dy;
    if (square > item.reachM * item.reachM) return false;
    if (view.opening >= 0) {
        const Gap& gap = m_gaps[static_cast<std::size_t>(view.opening)];
        if (!crosses(at, item.at, gap.a, gap.b)) return false;
    }
    geometry.range = std::sqrt(square);
    // Far things may stand round a corner.
    if (view.opening < 0 && geometry.range > kPoorlySeenM && m_map->bent(region)) {
        constexpr float kBeforeM = 0.3F;
        float part = 1.0F - kBeforeM / geometry.range;
        if (!m_map->straight(region, at, {at.x + part * geometry.dx, at.y + part * geometry.dy}))
            return false;
    }
    float facing = 1.0F;
    if (item.nx != 0.0F || item.ny != 0.0F) {
        float cosine = -(geometry.dx * item.nx + geometry.dy * item.ny) / std::max(geometry.range, 0.2F);
        facing = cosine < 0.02F ? 0.02F : std::min(1.0F, (cosine - 0.02F) / 0.5F + 0.02F);
    }
    geometry.visible = visibleAt(item, geometry.range) * facing * item.plain;
    return true;
}

float SensorModel::factorOf(const Look& look, const Item& item) const {
    float factor = look.kindFactor[item.kind];
    if (factor <= 0.0F) return 0.0F;
    Kind kind = static_cast<Kind>(item.kind);
    if (!look.textFactor.empty() && wordy(kind)) {
        if (item.text < 0) return 0.0F;
        factor *= look.textFactor[static_cast<std::size_t>(item.text)];
    }
    if (item.twin) factor *= static_cast<float>(m_options.unsurveyedTwin);
    if (!look.placeFactor.empty() && item.templateIndex >= 0)
        return factor * look.placeFactor[static_cast<std::size_t>(item.templateIndex)];
    if (look.hasTemplate && item.templateIndex >= 0 && item.templateIndex != look.templateIndex)
        factor *= look.otherTemplate;
    return factor;
}

float SensorModel::likelihoodOf(const Look& look, const Geometry& geometry, const Gaze& gaze) const {
    float likelihood = geometry.visible;
    float spread = look.besideM;
    float beside = spread / std::max(geometry.range, 0.5F);
    if (look.hasRange) {
        float off = look.logRange - std::log(std::max(geometry.range, 0.5F));
        likelihood *= normalDensity(off, look.rangeVariance + beside * beside);
    }
    float sway = kRadToDeg * 0.7F * spread / std::max(geometry.range, 0.7F);
    float direction = quickDirectionDeg(geometry.dx, geometry.dy);
    float variance = gaze.variance + sway * sway + look.bearingVariance;
    if (look.hasBearing) {
        float off = wrapDeg(direction - look.bearingDeg - gaze.yawDeg);
        return likelihood *
               ((1.0F - gaze.unknownShare) * normalDensity(off, variance) + gaze.unknownShare / 360.0F);
    }
    float off = wrapDeg(direction - gaze.yawDeg), scale = std::sqrt(2.0F * variance);
    float inView = 0.5F * (std::erf((off + kHalfViewDeg) / scale) - std::erf((off - kHalfViewDeg) / scale));
    return likelihood *
           ((1.0F - gaze.unknownShare) * inView + gaze.unknownShare * 2.0F * kHalfViewDeg / 360.0F);
}

Cause SensorModel::causeOf(const Look& look, const Geometry& geometry, const Gaze& gaze, float part) const {
    float spread = look.besideM;
    float sway = kRadToDeg * 0.7F * spread / std::max(geometry.range, 0.7F);
    float direction = quickDirectionDeg(geometry.dx, geometry.dy);
    return {part, wrapDeg(direction - look.bearingDeg - gaze.yawDeg), sway * sway + look.bearingVariance};
}

float SensorModel::ratio(const Look& look, std::uint32_t region, Spot at, const Gaze& gaze,
                         Cause* cause) const {
    float sum = 0.0F;
    for (const View& view : viewsNear(region, at)) {
        const Item& item = m_items[view.item];
        float factor = factorOf(look, item);
        if (factor <= 0.0F) continue;
        if (item.kind == indexOf(Kind::Place)) {
            sum += placeRatio(look, item, at, gaze, factor);
            continue;
        }
        Geometry geometry;
        if (!geometryOf(item, view, region, at, geometry)) continue;
        float part = factor * likelihoodOf(look, geometry, gaze) * look.inverseFalse;
        if (cause != nullptr && part > cause->part) *cause = causeOf(look, geometry, gaze, part);
        sum += part;
    }
    return sum;
}

/// Close enough to the share of a normal distribution within the picture, and much cheaper.
float SensorModel::inPicture(float offDeg, float steepness) {
    return 1.0F / (1.0F + quickExp(steepness * (std::abs(offDeg) - kHalfViewDeg)));
}

float SensorModel::rateOf(const Item& item, const Geometry& geometry) const {
    double rate = m_options.detectionsPerSecond *
                  oftenerThanDoors(static_cast<Kind>(item.kind), item.templateIndex >= 0);
    if (m_options.camera) rate *= m_options.missShare;
    return static_cast<float>(rate) * geometry.visible;
}

float SensorModel::expectedRate(std::uint32_t region, Spot at, const Gaze& gaze) const {
    float sum = 0.0F, steep = kSteepness / (std::sqrt(gaze.variance) + 1.0F);
    for (const View& view : viewsNear(region, at)) {
        const Item& item = m_items[view.item];
        Geometry geometry;
        if (item.kind == indexOf(Kind::Place) || !geometryOf(item, view, region, at, geometry)) continue;
        float off = wrapDeg(quickDirectionDeg(geometry.dx, geometry.dy) - gaze.yawDeg);
        float any = gaze.unknownShare * 2.0F * kHalfViewDeg / 360.0F;
        sum += rateOf(item, geometry) * ((1.0F - gaze.unknownShare) * inPicture(off, steep) + any);
    }
    return sum;
}

void SensorModel::expectedRates(std::uint32_t region, Spot at, float sigmaDeg,
                                std::span<float> byDirection) const {
    std::fill(byDirection.begin(), byDirection.end(), 0.0F);
    float steep = kSteepness / (sigmaDeg + 1.0F), sector = 360.0F / static_cast<float>(byDirection.size());
    for (const View& view : viewsNear(region, at)) {
        const Item& item = m_items[view.item];
        Geometry geometry;
        if (item.kind == indexOf(Kind::Place) || !geometryOf(item, view, region, at, geometry)) continue;
        float rate = rateOf(item, geometry), direction = quickDirectionDeg(geometry.dx, geometry.dy);
        for (std::size_t i = 0; i < byDirection.size(); ++i)
            byDirection[i] +=
                rate * inPicture(wrapDeg(direction - (static_cast<float>(i) + 0.5F) * sector), steep);
    }
}

void SensorModel::readText(const Detection& detection, Look& look, double& falseFactor) const {
    constexpr double kLooksAlike = 0.15; // of readings: all wrong letters look like the right ones
    std::string text = foldedForMatching(detection.text), shape = shapeOf(text);
    look.textFactor.assign(std::max<std::size_t>(1, m_texts.size()), 0.0F);
    double sum = 0.0, share = 0.0;
    for (std::size_t t = 0; t < m_texts.size(); ++t) {
        int edits = shortEditDistance(text, m_texts[t]);
        double letters = kLetters * static_cast<double>(std::max<std::size_t>(1, m_texts[t].size()));
        double factor = edits == 0             ? m_options.textRead
                        : shape == m_shapes[t] ? kLooksAlike
                        : edits == 1           ? 6.0 * m_options.textOneOff / letters
                        : edits == 2           ? 12.0 * m_options.textTwoOff / (letters * letters)
                                               : 0.0;
        look.textFactor[t] = static_cast<float>(factor);
        sum += factor * double(m_shareOfText[t]);
        share += double(m_shareOfText[t]);
    }
    double guessed =
        std::pow(kGuessedLetter, static_cast<double>(std::clamp<std::size_t>(text.size(), 2, 20)));
    double mapped = share > 0.0 ? sum / share : 0.0;
    falseFactor *= m_options.mappedFalseText * mapped + (1.0 - m_options.mappedFalseText) * guessed;
}

Look SensorModel::prepare(const Detection& detection) const {
    Look look;
    look.kind = detection.kind;
    look.besideM = static_cast<float>(detection.kind == Kind::Stairs ? m_options.stairsSigmaM
                                                                     : m_options.positionSigmaM);
    double same = m_options.sameKind;
    for (Kind actual : allKinds()) {
        double share = actual == detection.kind ? same : (1.0 - same) * lookAlike(actual, detection.kind);
        // The reader answers "text" whatever the words stand on.
        if (detection.kind == Kind::Text && actual == Kind::Sign) share = same;
        look.kindFactor[indexOf(actual)] = static_cast<float>(
            m_options.detectionsPerSecond * oftenerThanDoors(actual, !detection.templateId.empty()) * share);
    }
    double falseLikelihood = m_options.falsePerSecond * falseShare(detection.kind);
    if (detection.kind == Kind::Place) falseLikelihood = falsePlace(detection.strength);
    // Inventions seldom last: what was seen again and again is more likely there.
    constexpr int kMostConfirmations = 4;
    falseLikelihood /= std::clamp(detection.confirmations, 1, kMostConfirmations);
    if (wordy(detection.kind) && !detection.text.empty()) readText(detection, look, falseLikelihood);
    if (!detection.templateId.empty()) {
        falseLikelihood *= weaklyExplained(detection.kind, detection.strength);
        look.hasTemplate = true;
        look.otherTemplate =
            static_cast<float>(m_options.otherTemplate * takenForOther(detection.kind, detection.strength));
        auto found = m_templates.find(detection.templateId.value);
        if (found != m_templates.end()) look.templateIndex = found->second;
        if (detection.kind == Kind::Place && detection.strength > 0.0)
            weighLookAlikes(detection, look, falseLikelihood);
        if (!m_templates.empty() && detection.kind != Kind::Place)
            falseLikelihood /= static_cast<double>(std::min<std::size_t>(20, m_templates.size()));
    }
    if (detection.rangeM && std::isfinite(*detection.rangeM) && *detection.rangeM > 0.0) {
        look.hasRange = true;
        look.logRange = static_cast<float>(std::log(std::clamp(*detection.rangeM, 0.3, 20.0)));
        double sigma = spreadOfRange(detection);
        look.rangeVariance = static_cast<float>(sigma * sigma);
        if (detection.kind != Kind::Place)
            falseLikelihood *= double(normalDensity(look.logRange - kLog2, falseRangeVariance(m_options)));
    }
    double sigma = m_options.bearingSigmaDeg;
    if (detection.bearing && std::isfinite(detection.bearing->value)) {
        look.hasBearing = true;
        look.bearingDeg = static_cast<float>(toDegrees(wrapped(*detection.bearing)));
    } else if (detection.image.width > 0) {
        double middle = boundingBox(detection.quad).centre().x / detection.image.width;
        look.hasBearing = std::isfinite(middle);
        look.bearingDeg =
            static_cast<float>((0.5 - std::clamp(middle, 0.0, 1.0)) * 2.0 * double(kHalfViewDeg));
        sigma = m_options.zoneSigmaDeg;
    }
    look.bearingVariance = static_cast<float>(sigma * sigma);
    if (look.hasBearing && detection.kind != Kind::Place) falseLikelihood /= 2.0 * double(kHalfViewDeg);
    look.inverseFalse = static_cast<float>(1.0 / std::max(1e-30, falseLikelihood));
    weighUniform(look);
    if (detection.kind != Kind::Place) {
        double unmapped = 1.0 + m_options.unmappedShare * look.uniformRatio;
        look.inverseFalse = static_cast<float>(double(look.inverseFalse) / unmapped);
        look.uniformRatio /= unmapped;
    }
    return look;
}

/// The share of all walking from which each landmark is seen, times what it would give there. Summed by
/// groups, so that landmarks can be drawn by it: the kinds and the distinct texts, or with a template the
/// landmarks themselves.
void SensorModel::weighUniform(Look& look) const {
    double perFalse = double(look.inverseFalse) / (look.hasBearing ? 360.0 : 6.0);
    if (look.hasRange && look.kind != Kind::Place)
        perFalse *= double(normalDensity(look.logRange - kLog2, falseRangeVariance(m_options)));
    if (look.kind == Kind::Place) perFalse = double(look.inverseFalse) * m_options.placeSigmaDeg / 144.0;
    double sum = 0.0;
    auto add = [&](double part) { look.groupSums.push_back(sum += part); };
    if (look.hasTemplate) {
        for (const Item& item : m_items) {
            bool counts = !look.placeFactor.empty() || item.templateIndex == look.templateIndex ||
                          item.templateIndex < 0;
            add(counts ? double(factorOf(look, item)) * double(item.share) : 0.0);
        }
        look.uniformRatio = sum * perFalse;
        return;
    }
    bool words = !look.textFactor.empty();
    for (std::size_t k = 0; k < kKindCount; ++k) {
        bool counts = !m_itemsOfKind[k].empty() && !(words && wordy(static_cast<Kind>(k)));
        add(counts ? double(look.kindFactor[k]) * double(m_sharesUpTo[k].back()) : 0.0);
    }
    double rate = double(look.kindFactor[indexOf(Kind::Text)]);
    for (std::size_t t = 0; words && t < m_texts.size(); ++t)
        add(rate * double(look.textFactor[t]) * double(m_shareOfText[t]));
    look.uniformRatio = sum * perFalse;
}

/// A landmark drawn by its part of uniformRatio; m_items.size() for none.
std::uint32_t SensorModel::drawItem(const Look& look, double u, double v) const {
    auto none = static_cast<std::uint32_t>(m_items.size());
    const std::vector<double>& sums = look.groupSums;
    if (sums.empty() || sums.back() <= 0.0) return none;
    auto it = std::upper_bound(sums.begin(), sums.end(), u * sums.back());
    if (it == sums.end()) return none;
    auto chosen = static_cast<std::size_t>(it - sums.begin());
    if (look.hasTemplate) return static_cast<std::uint32_t>(chosen);
    if (chosen >= kKindCount) {
        const auto& items = m_itemsOfText[chosen - kKindCount];
        auto i = static_cast<std::size_t>(v * static_cast<double>(items.size()));
        return items.empty() ? none : items[std::min(i, items.size() - 1)];
    }
    const auto& shares = m_sharesUpTo[chosen];
    auto at = std::upper_bound(shares.begin(), shares.end(), static_cast<float>(v) * shares.back());
    auto i = std::min(static_cast<std::size_t>(at - shares.begin()), shares.size() - 1);
    return m_itemsOfKind[chosen][i];
}

BirthPose SensorModel::poseAt(const Item& item, const Look& look, double u, double v, double w) const {
    constexpr double kHalfArc = 1.2; // radians to either side of the way the object faces
    BirthPose pose;
    pose.region = item.region;
    double normal =
        item.nx != 0.0F || item.ny != 0.0F ? std::atan2(double(item.ny), double(item.nx)) : 2.0 * kPi * w;
    if (item.kind == indexOf(Kind::Place)) {
        double away = 2.0 * kPi * u, range = 1.2 * v;
        pose.at = {item.at.x + float(range * std::cos(away)), item.at.y + float(range * std::sin(away))};
        pose.yawDeg = static_cast<float>(normal) * kRadToDeg;
        return pose;
    }
    double away = normal + kHalfArc * (2.0 * u - 1.0);
    double spread = look.hasRange ? std::sqrt(double(look.rangeVariance)) : 0.4;
    double range =
        std::exp((look.hasRange ? double(look.logRange) : double(kLog2)) + spread * 2.0 * (v - 0.5) * 1.7);
    range = std::clamp(range, 0.3, double(item.reachM) - 0.1);
    pose.at = {item.at.x + float(range * std::cos(away)), item.at.y + float(range * std::sin(away))};
    pose.yawDeg = static_cast<float>(away) * kRadToDeg + 180.0F - look.bearingDeg;
    return pose;
}

} // namespace farol::localisation
