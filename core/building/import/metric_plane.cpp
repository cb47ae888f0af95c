#include "core/base/ogr.h"
#include "core/base/text.h"
#include "core/building/import/finishing.h"

#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string_view>

namespace farol::building {

namespace {

/// A building in degrees is smaller than this; one in metres is larger.
constexpr double kLargestDegrees = 0.3;
/// The grid of a CRS may be this much longer or shorter than the ground.
constexpr double kScaleTolerance = 0.01;
/// In no unit of any CRS is a place on earth further than this; transforming what is may take for ever.
constexpr double kFurthestUnits = 1e9;

using Points = std::vector<Point2*>;

Points pointsOf(BuildingData& data) {
    Points points;
    auto each = [&](std::vector<Point2>& line) {
        for (Point2& point : line) points.push_back(&point);
    };
    for (Region& region : data.regions) {
        each(region.polygon.outer);
        for (Ring& hole : region.polygon.holes) each(hole);
    }
    for (Access& access : data.accesses) each(access.line);
    for (Wall& wall : data.walls) each(wall.line);
    for (Landmark& landmark : data.landmarks) points.push_back(&landmark.position);
    return points;
}

std::optional<Box2> extentOf(const Points& points) {
    std::optional<Box2> box;
    for (const Point2* point : points) {
        if (!isFinite(*point)) continue;
        if (!box) box = Box2{*point, *point};
        box->low = {std::min(box->low.x, point->x), std::min(box->low.y, point->y)};
        box->high = {std::max(box->high.x, point->x), std::max(box->high.y, point->y)};
    }
    return box;
}

Point2 middle(const Box2& box) {
    return (box.low + box.high) * 0.5;
}
Point2 swapped(Point2 p) {
    return {p.y, p.x};
}
bool onEarth(const Box2& box) {
    return box.low.x >= -180.0 && box.high.x <= 180.0 && box.low.y >= -90.0 && box.high.y <= 90.0;
}
bool looksLikeDegrees(const Box2& box) {
    return onEarth(box) && std::max(box.width(), box.height()) < kLargestDegrees &&
           std::max(std::abs(box.low.x), std::abs(box.low.y)) > 1.0;
}

OGRSpatialReference wgs84() {
    OGRSpatialReference reference;
    reference.importFromEPSG(4326);
    reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return reference;
}

using Transform = std::unique_ptr<OGRCoordinateTransformation>;

std::optional<Point2> transformed(OGRCoordinateTransformation& transform, Point2 point) {
    int good = FALSE;
    if (transform.Transform(1, &point.x, &point.y, nullptr, &good) == FALSE && good == FALSE)
        return std::nullopt;
    return good != FALSE && isFinite(point) ? std::optional(point) : std::nullopt;
}

std::string wktOf(const OGRSpatialReference& reference) {
    char* text = nullptr;
    const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
    std::string wkt;
    if (reference.exportToWkt(&text, options) == OGRERR_NONE && text != nullptr) wkt = text;
    CPLFree(text);
    return wkt;
}

class MetricPlane {
public:
    MetricPlane(RawMap& raw, FindingList& findings)
        : m_raw(raw), m_findings(findings), m_points(pointsOf(raw.data)) {}

    Result<void> run() {
        for (Point2* point : m_points) // no numbers: told and left out with their features
            if (!(std::abs(point->x) <= kFurthestUnits && std::abs(point->y) <= kFurthestUnits))
                *point = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
        auto box = extentOf(m_points);
        if (!box) return Error{ErrorCode::Corrupt, english(Sentence::NoCoordinates), ""};
        m_box = *box;
        if (auto understood = readReference(); !understood) return understood;
        judgeUnits();
        if (!m_reference) return stayLocal();
        unflip();
        if (m_reference->IsGeographic() == FALSE && staysMetric()) {
            m_raw.data.crs = wktOf(*m_reference);
            return {};
        }
        return toUtm();
    }

private:
    void note(Severity severity, const std::string& rule, const Message& message) {
        m_findings.add({severity, rule, message, "", {}});
    }

    Result<void> readReference() {
        const std::string& crs = m_raw.data.crs;
        if (!crs.empty()) {
            OGRSpatialReference reference;
            GdalMessages quiet;
            if (reference.SetFromUserInput(
                    crs.c_str(), OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()) != OGRERR_NONE)
                note(Severity::Warning, "crs-unknown", Sentence::CrsNotUnderstood);
            else if (reference.IsLocal() == FALSE)
                m_reference = reference;
        } else if (m_raw.coordinates == RawCoordinates::Geographic) {
            m_reference = wgs84();
        }
        if (m_reference) m_reference->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        if (m_reference && m_reference->IsGeocentric() != FALSE)
            return Error{ErrorCode::UnsupportedFormat, english(Sentence::Geocentric), ""};
        return {};
    }

    /// Degrees that call themselves metres, metres that call themselves degrees, and either without a word.
    void judgeUnits() {
        bool geographic = m_reference && m_reference->IsGeographic() != FALSE;
        Box2 turned{swapped(m_box.low), swapped(m_box.high)};
        if (!geographic && m_raw.coordinates != RawCoordinates::Metric &&
            (looksLikeDegrees(m_box) || looksLikeDegrees(turned))) {
            note(Severity::Warning, m_reference ? "crs-degrees-for-metres" : "crs-missing",
                 m_reference ? Sentence::CrsMetresButDegrees : Sentence::CrsMissingDegrees);
            m_reference = wgs84();
        } else if (geographic && !onEarth(m_box) && !onEarth(turned)) {
            note(Severity::Warning, "crs-metres-for-degrees", Sentence::CrsDegreesButMetres);
            m_reference.reset();
        } else if (!m_reference && m_raw.coordinates != RawCoordinates::Metric) {
            note(Severity::Warning, "crs-missing", Sentence::CrsMissingMetres);
        }
    }

    Result<void> stayLocal() {
        m_raw.data.crs.clear();
        if (std::max({std::abs(m_box.low.x), std::abs(m_box.low.y), std::abs(m_box.high.x),
                      std::abs(m_box.high.y)}) > 1e8)
            return Error{ErrorCode::Corrupt, english(Sentence::BeyondAnyBuilding), ""};
        return {};
    }

    bool isFlipped() {
        if (m_reference->IsGeographic() != FALSE) {
            Box2 turned{swapped(m_box.low), swapped(m_box.high)};
            return !onEarth(m_box) && onEarth(turned);
        }
        double west = 0, south = 0, east = 0, north = 0;
        GdalMessages quiet;
        if (m_reference->GetAreaOfUse(&west, &south, &east, &north, nullptr) == FALSE || west > east)
            return false;
        OGRSpatialReference degrees = wgs84();
        Transform transform(OGRCreateCoordinateTransformation(&*m_reference, &degrees));
        if (transform == nullptr) return false;
        auto within = [&](Point2 point) {
            auto place = transformed(*transform, point);
            return place && place->x >= west - 1 && place->x <= east + 1 && place->y >= south - 1 &&
                   place->y <= north + 1;
        };
        return !within(middle(m_box)) && within(swapped(middle(m_box)));
    }

    void unflip() {
        if (!isFlipped()) return;
        note(Severity::Warning, "axes-flipped", Sentence::AxesExchanged);
        for (Point2* point : m_points) *point = swapped(*point);
        m_box = {swapped(m_box.low), swapped(m_box.high)};
    }

    bool isWebMercator() const {
        const char* projection = m_reference->GetAttrValue("PROJECTION");
        std::string_view words = projection == nullptr ? "" : projection;
        return words.rfind("Mercator", 0) == 0 || words.find("Pseudo") != std::string_view::npos ||
               std::string_view(m_reference->GetName()).find("Pseudo-Mercator") != std::string_view::npos;
    }

    /// Metres that are as long as on the ground?
    bool staysMetric() {
        if (std::abs(m_reference->GetLinearUnits() - 1.0) > 1e-9 || isWebMercator()) return false;
        GdalMessages quiet;
        OGRSpatialReference degrees = wgs84();
        Transform transform(OGRCreateCoordinateTransformation(&*m_reference, &degrees));
        if (transform == nullptr) return true;
        constexpr double kProbe = 100.0, kPi = 3.14159265358979323846, kMetresPerDegree = 111320.0;
        auto here = transformed(*transform, middle(m_box));
        auto there = transformed(*transform, middle(m_box) + Point2{kProbe, 0.0});
        if (!here || !there) return true;
        double eastwards = (there->x - here->x) * kMetresPerDegree * std::cos(here->y * kPi / 180.0);
        double northwards = (there->y - here->y) * kMetresPerDegree;
        return std::abs(std::hypot(eastwards, northwards) / kProbe - 1.0) < kScaleTolerance;
    }

    static int utmCode(Point2 place) {
        if (place.y >= 84.0) return 32661;
        if (place.y < -80.0) return 32761;
        int zone = std::clamp(static_cast<int>(std::floor((place.x + 180.0) / 6.0)) + 1, 1, 60);
        return (place.y >= 0.0 ? 32600 : 32700) + zone;
    }

    Result<void> toUtm() {
        GdalMessages messages;
        OGRSpatialReference degrees = wgs84(), metric;
        Transform toDegrees(OGRCreateCoordinateTransformation(&*m_reference, &degrees));
        auto place = toDegrees == nullptr ? std::nullopt : transformed(*toDegrees, middle(m_box));
        if (!place) return messages.error(ErrorCode::Corrupt, english(Sentence::OutsideTheirCrs), "");
        metric.importFromEPSG(utmCode(*place));
        metric.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        Transform transform(OGRCreateCoordinateTransformation(&*m_reference, &metric));
        if (transform == nullptr)
            return messages.error(ErrorCode::Corrupt, english(Sentence::CrsNotToMetres), "");
        std::vector<double> x, y;
        for (const Point2* point : m_points) {
            x.push_back(point->x);
            y.push_back(point->y);
        }
        std::vector<int> good(x.size(), FALSE);
        if (!x.empty())
            transform->Transform(static_cast<int>(x.size()), x.data(), y.data(), nullptr, good.data());
        for (std::size_t i = 0; i < x.size(); ++i) {
            double none = std::numeric_limits<double>::quiet_NaN(); // mended or dropped with its feature
            *m_points[i] = good[i] != FALSE ? Point2{x[i], y[i]} : Point2{none, none};
        }
        const char* name = m_reference->GetName();
        note(Severity::Note, "crs-projected",
             name == nullptr ? said(Sentence::CoordinatesBroughtUnnamed, metric.GetName())
                             : said(Sentence::CoordinatesBrought, name, metric.GetName()));
        m_raw.data.crs = wktOf(metric);
        return {};
    }

    RawMap& m_raw;
    FindingList& m_findings;
    Points m_points;
    Box2 m_box;
    std::optional<OGRSpatialReference> m_reference;
};

} // namespace

Result<void> toMetricPlane(RawMap& raw, FindingList& findings) {
    return MetricPlane(raw, findings).run();
}

} // namespace farol::building
