#include "core/simulation/furniture.h"
#include "core/simulation/hash.h"
#include "core/simulation/scene_parts.h"
#include "core/simulation/sign_pictures.h"
#include "core/simulation/wall_spots.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace farol::simulation {

namespace {

using building::Landmark;

struct Usual {
    Measures size;
    double centreM = 1.5; ///< height of the middle; standing things ignore it
    bool stands = false;
};

Usual usualOf(Kind kind) {
    switch (kind) {
    case Kind::Door:
        return {{0.9, 2.05, 0.03}, 1.03, true};
    case Kind::Elevator:
        return {{1.1, 2.1, 0.03}, 1.05, true};
    case Kind::Extinguisher:
        return {{0.17, 0.55, 0.2}, 0.95, false};
    case Kind::ExitSign:
        return {{0.4, 0.2, 0.03}, 2.3, false};
    case Kind::Sign:
    case Kind::Text:
        return {{0.3, 0.12, 0.012}, 1.55, false};
    case Kind::Rectangle:
        return {{0.6, 0.8, 0.06}, 1.4, false};
    case Kind::Window:
        return {{1.2, 1.1, 0.02}, 1.55, false};
    case Kind::Locker:
        return {{1.2, 1.8, 0.45}, 0.9, true};
    case Kind::Poster:
        return {{0.6, 0.85, 0.006}, 1.5, false};
    case Kind::Picture:
        return {{0.7, 0.5, 0.03}, 1.55, false};
    case Kind::Fountain:
        return {{0.45, 0.6, 0.34}, 0.75, false};
    case Kind::Hydrant:
        return {{0.65, 0.75, 0.16}, 1.1, false};
    case Kind::VendingMachine:
        return {{0.95, 1.83, 0.8}, 0.92, true};
    case Kind::Bin:
        return {{0.4, 0.75, 0.4}, 0.4, true};
    case Kind::Plant:
        return {{0.7, 1.5, 0.5}, 0.7, true};
    case Kind::Furniture:
        return {{1.3, 0.85, 0.5}, 0.45, true};
    case Kind::Stairs:
        return {{0.3, 0.3, 0.012}, 2.0, false};
    default:
        return {{0.5, 0.6, 0.04}, 1.4, false};
    }
}

/// The front of a template as its first photograph shows it, straightened; empty without one.
cv::Mat photographOf(const recognition::Template& entry) {
    for (const recognition::View& view : entry.views) {
        if (view.jpeg.empty()) continue;
        std::vector<std::uint8_t> bytes(view.jpeg.begin(), view.jpeg.end());
        cv::Mat picture = cv::imdecode(bytes, cv::IMREAD_COLOR);
        if (picture.empty()) continue;
        std::vector<cv::Point2f> from;
        for (const ImagePoint& p : view.outline)
            from.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y));
        double wide = std::max(cv::norm(from[1] - from[0]), cv::norm(from[2] - from[3]));
        double tall = std::max(cv::norm(from[3] - from[0]), cv::norm(from[2] - from[1]));
        if (wide < 8.0 || tall < 8.0) continue;
        double scale = std::min(1.0, 640.0 / std::max(wide, tall));
        cv::Size pixels(std::max(16, static_cast<int>(wide * scale)),
                        std::max(16, static_cast<int>(tall * scale)));
        auto w = static_cast<float>(pixels.width), h = static_cast<float>(pixels.height);
        std::vector<cv::Point2f> to{{0.0F, 0.0F}, {w, 0.0F}, {w, h}, {0.0F, h}};
        cv::Mat front;
        cv::warpPerspective(picture, front, cv::getPerspectiveTransform(from, to), pixels, cv::INTER_AREA,
                            cv::BORDER_REPLICATE);
        return front;
    }
    return {};
}

class LandmarkMaker {
public:
    LandmarkMaker(SceneData& scene, const SceneOptions& options, const recognition::LandmarkLibrary* library)
        : m_scene(scene), m_options(options), m_library(library), m_builder(scene.mesh) {
        for (const Portal& portal : scene.plan.portals)
            if (portal.landmark) m_windows.insert(*portal.landmark);
    }

    void make(std::size_t index) {
        const Landmark& landmark = m_scene.building->landmarks()[index];
        if (landmark.kind == Kind::Place || !isFinite(landmark.position) || !std::isfinite(landmark.level))
            return;
        if (partOfBuilding(index, landmark)) return;
        if (landmark.kind == Kind::Window && m_windows.count(index) > 0) return;
        auto region = m_scene.building->regionIndex(landmark.region);
        if (!region) region = m_scene.building->regionAt(landmark.position, landmark.level);
        Usual usual = usualOf(landmark.kind);
        sized(landmark, usual);
        const Storey& storey = m_scene.plan.storeys.at(landmark.level);
        double centre = usual.stands ? usual.size.tall / 2 : usual.centreM;
        if (landmark.heightM && std::isfinite(*landmark.heightM))
            centre = std::clamp(*landmark.heightM, usual.size.tall / 2,
                                storey.ceilingM - 0.02 - usual.size.tall / 2);
        centre = std::min(centre, storey.ceilingM - 0.02 - usual.size.tall / 2);
        Spot spot = spotOf(landmark, region, usual, storey.floorZ + centre);
        begin(index, landmark, spot);
        build(landmark, spot, usual, storey.floorZ);
        m_builder.setThing(-1);
    }

private:
    static bool good(const std::optional<double>& metres) {
        return metres && *metres > 0.02 && *metres < 12.0;
    }

    void sized(const Landmark& landmark, Usual& usual) const {
        const recognition::Template* entry = templateOf(landmark);
        if (entry && good(entry->widthM)) usual.size.width = *entry->widthM;
        if (entry && good(entry->heightM)) usual.size.tall = *entry->heightM;
        if (good(landmark.widthM)) usual.size.width = *landmark.widthM;
        if (good(landmark.tallM)) usual.size.tall = *landmark.tallM;
        if (!good(landmark.widthM) && !landmark.text.empty() && landmark.kind != Kind::ExitSign && !entry) {
            double letters = static_cast<double>(std::min<std::size_t>(landmark.text.size(), 20));
            usual.size.width = std::max(usual.size.width, usual.size.tall * (0.5 + 0.42 * letters));
        }
    }

    const recognition::Template* templateOf(const Landmark& landmark) const {
        return m_library && !landmark.templateId.empty() ? m_library->find(landmark.templateId) : nullptr;
    }

    /// Doors, lifts, windows and stairs that stand as accesses in the map are there already.
    bool partOfBuilding(std::size_t index, const Landmark& landmark) {
        if (landmark.kind != Kind::Door && landmark.kind != Kind::Elevator && landmark.kind != Kind::Stairs)
            return false;
        if (templateOf(landmark) && landmark.kind != Kind::Stairs) return false; // it has a look of its own
        Vec3 at = vecOf(landmark.position - m_scene.plan.origin, 0.0);
        std::size_t best = m_scene.things.size();
        float least = landmark.kind == Kind::Stairs ? 6.0F : 1.2F;
        for (std::size_t i = 0; i < m_scene.things.size(); ++i) {
            const Thing& thing = m_scene.things[i];
            bool fits = landmark.kind == Kind::Stairs ? thing.stairs : thing.opening;
            if (!fits || thing.landmark || thing.level != landmark.level) continue;
            Vec3 way = thing.centre - at;
            float gap = std::sqrt(way.x * way.x + way.y * way.y);
            if (gap < least) {
                least = gap;
                best = i;
            }
        }
        if (best == m_scene.things.size()) return false;
        m_scene.things[best].landmark = index;
        return true;
    }

    Spot spotOf(const Landmark& landmark, std::optional<std::size_t> region, const Usual& usual, double z) {
        Point2 at = landmark.position - m_scene.plan.origin;
        m_onWall = false;
        if (region) {
            double reach = usual.stands ? 0.4 + usual.size.deep : 0.7;
            auto wall = wallSpot(m_scene, *region, at, landmark.heading, usual.size.width, reach);
            // Without a heading a thing near a wall hangs on it.
            if (!wall && !landmark.heading)
                wall = wallSpot(m_scene, *region, at, std::nullopt, usual.size.width, 1.0);
            if (wall) {
                m_onWall = true;
                return spotAt(vecOf(wall->position + wall->edge->inward * 0.001, z), wall->edge->inward);
            }
        }
        Point2 front{1.0, 0.0};
        if (landmark.heading)
            front = {std::cos(landmark.heading->value), std::sin(landmark.heading->value)};
        else if (region)
            front = m_scene.plan.regions[*region].axis;
        return spotAt(vecOf(at - front * (usual.stands ? usual.size.deep / 2 : 0.0), z), front);
    }

    void begin(std::size_t index, const Landmark& landmark, const Spot& spot) {
        Thing thing;
        thing.landmark = index;
        thing.level = landmark.level;
        thing.centre = spot.middle;
        thing.facing = spot.front;
        m_thing = m_scene.things.size();
        m_scene.things.push_back(thing);
        m_builder.setThing(static_cast<std::int32_t>(m_thing));
    }

    void board(const Spot& spot, const Measures& size, const cv::Mat& picture, Vec3 sides,
               float glow = 0.0F) {
        board(spot, size, addTexture(m_scene, picture), sides, glow);
    }
    void board(const Spot& spot, const Measures& size, std::uint32_t texture, Vec3 sides, float glow = 0.0F) {
        auto corners = addBoard(m_builder, spot, size, texture, sides, glow);
        Thing& thing = m_scene.things[m_thing];
        if (size.deep < 0.1) thing.corners = corners; // else its sides are seen too
        thing.centre = (corners[0] + corners[2]) * 0.5F;
    }

    /// Pictures that several landmarks share are drawn once.
    template <class Make>
    std::uint32_t shared(const Landmark& landmark, const Measures& size, const Make& make) {
        std::string key =
            !landmark.templateId.empty() ? "t " + landmark.templateId.value : "l " + landmark.id.value;
        key += " " + std::string(kindName(landmark.kind)) + " " + landmark.text + " " +
               std::to_string(std::lround(100.0 * size.width / size.tall));
        auto found = m_drawn.find(key);
        if (found != m_drawn.end()) return found->second;
        return m_drawn[key] = addTexture(m_scene, make(hashOf(hashOf(m_options.seed, 5), key)));
    }

    void build(const Landmark& landmark, const Spot& spot, const Usual& usual, double floorZ) {
        const Measures& size = usual.size;
        if (const recognition::Template* entry = templateOf(landmark)) {
            auto known = m_photographs.find(entry->id.value);
            if (known == m_photographs.end()) {
                cv::Mat photograph = photographOf(*entry);
                std::optional<std::uint32_t> texture;
                if (!photograph.empty()) texture = addTexture(m_scene, photograph);
                known = m_photographs.emplace(entry->id.value, texture).first;
            }
            if (known->second) {
                Measures flat = size;
                flat.deep = std::min(flat.deep, 0.06);
                board(spot, flat, *known->second, linearOf(90, 90, 90));
                return;
            }
        }
        std::uint64_t seed = hashOf(m_options.seed, landmark.templateId.empty() ? landmark.id.value
                                                                                : landmark.templateId.value);
        Spot floor = spot;
        floor.middle.z = static_cast<float>(floorZ);
        buildKind(landmark, spot, floor, size, seed);
    }

    void buildKind(const Landmark& landmark, const Spot& spot, const Spot& floor, const Measures& size,
                   std::uint64_t seed) {
        double aspect = size.width / size.tall;
        Vec3 grey = linearOf(150, 150, 150);
        switch (landmark.kind) {
        case Kind::Extinguisher:
            extinguisher(spot, floor, size, seed);
            return;
        case Kind::ExitSign:
            exit(landmark, spot, size);
            return;
        case Kind::Locker:
            board(spot, size,
                  shared(landmark, size, [&](std::uint64_t s) { return lockerDoors(size.width, s); }), grey);
            return;
        case Kind::VendingMachine:
            board(spot, size, shared(landmark, size, [](std::uint64_t s) { return vendingFront(s); }),
                  linearOf(70, 70, 76), 0.25F);
            return;
        case Kind::Fountain:
            addFountain(m_builder, spot, size);
            return;
        case Kind::Hydrant:
            board(spot, size, shared(landmark, size, [](std::uint64_t) { return hydrantSign(); }),
                  linearOf(180, 20, 24));
            return;
        case Kind::Bin:
            addBin(m_builder, floor, size, seed);
            return;
        case Kind::Plant:
            addPlant(m_builder, floor, size, seed);
            return;
        case Kind::Furniture:
            addFurniture(m_builder, floor, size, seed);
            return;
        case Kind::Picture:
            board(spot, size,
                  shared(landmark, size, [&](std::uint64_t s) { return paintedPicture(aspect, s); }),
                  linearOf(60, 46, 36));
            return;
        case Kind::Door:
        case Kind::Elevator:
            falseDoor(landmark.kind, spot, size);
            return;
        case Kind::Stairs:
            board(spot, size, shared(landmark, size, [](std::uint64_t) { return stairsSign(); }), grey);
            return;
        default:
            board(spot, size,
                  shared(landmark, size, [&](std::uint64_t s) { return flatPicture(landmark, aspect, s); }),
                  grey);
            return;
        }
    }

    static cv::Mat flatPicture(const Landmark& landmark, double aspect, std::uint64_t seed) {
        std::string words = landmark.kindText + " " + landmark.templateId.value + " " + landmark.id.value;
        bool notices = words.find("notice") != std::string::npos || words.find("board") != std::string::npos;
        switch (landmark.kind) {
        case Kind::Sign:
        case Kind::Text:
            return textSign(landmark.text, aspect, seed);
        case Kind::Poster:
            return notices ? noticeBoard(aspect, seed) : poster(landmark.text, aspect, seed);
        case Kind::Window:
            return windowView(aspect);
        case Kind::Rectangle:
            return cv::Mat(64, 48, CV_8UC3, cv::Scalar(160, 164, 162));
        default:
            break;
        }
        if (!landmark.text.empty()) return textSign(landmark.text, aspect, seed);
        return notices || aspect > 1.1 ? noticeBoard(aspect, seed) : poster("", aspect, seed);
    }

    void extinguisher(const Spot& spot, const Spot& floor, const Measures& size, std::uint64_t seed) {
        addExtinguisher(m_scene, m_builder, spot, size, seed);
        m_scene.things[m_thing].centre = spot.at(0.0, 0.0, size.width / 2);
        m_scene.things[m_thing].facing = spot.front;
        if (!m_onWall) return;
        m_builder.setThing(-1); // the sign above it is not the thing itself
        if (!m_extinguisherSign) m_extinguisherSign = addTexture(m_scene, extinguisherSign());
        Spot above = floor;
        above.middle =
            above.at(0.0, static_cast<double>(spot.middle.z - floor.middle.z) + size.tall / 2 + 0.38, 0.0);
        addBoard(m_builder, above, {0.2, 0.2, 0.006}, *m_extinguisherSign, linearOf(190, 30, 30));
    }

    void exit(const Landmark& landmark, const Spot& spot, const Measures& size) {
        std::string words = landmark.text + " " + landmark.templateId.value;
        auto says = [&](const char* word) { return words.find(word) != std::string::npos; };
        int arrow = says("left") || says("<") || says("esquerda")   ? -1
                    : says("right") || says(">") || says("direita") ? 1
                                                                    : 0;
        auto& texture = m_exitSigns[arrow];
        if (!texture) texture = addTexture(m_scene, exitSign(arrow));
        board(spot, size, *texture, linearOf(30, 110, 60), 0.55F);
        if (m_onWall) return;
        // Hung from the ceiling: the same picture on its back, and two rods.
        Spot back{spot.middle, spot.right * -1.0F, spot.front * -1.0F};
        m_builder.setThing(-1);
        addBoard(m_builder, back, {size.width, size.tall, 0.002}, *texture, linearOf(30, 110, 60), 0.55F);
        Paint rod = paintOf(Material::Metal);
        double ceiling =
            m_scene.plan.storeys.at(landmark.level).floorZ + m_scene.plan.storeys.at(landmark.level).ceilingM;
        for (double x : {-0.35, 0.35}) {
            Vec3 foot = spot.at(x * size.width, size.tall / 2, 0.01);
            Vec3 top = foot;
            top.z = static_cast<float>(ceiling);
            if (top.z > foot.z + 0.01F) m_builder.beam(foot, top, 0.012F, rod);
        }
    }

    /// A door that the map knows only as a landmark: shut, with frame and handle.
    void falseDoor(Kind kind, const Spot& spot, const Measures& size) {
        bool lift = kind == Kind::Elevator;
        Paint leaf = lift ? paintOf(Material::Metal, linearOf(210, 210, 214))
                          : paintOf(Material::DoorWood, linearOf(220, 210, 200));
        Paint frame = lift ? paintOf(Material::Metal, linearOf(150, 150, 156))
                           : paintOf(Material::Plain, linearOf(150, 140, 130));
        double w = size.width, h = size.tall;
        auto panel = [&](double x0, double x1, double z0, double z1, double deep, const Paint& paint) {
            m_builder.box(spot.at(x0, z0, deep), spot.right * static_cast<float>(x1 - x0),
                          spot.front * static_cast<float>(-deep), kUp * static_cast<float>(z1 - z0), paint);
        };
        panel(-w / 2 - 0.07, -w / 2, -h / 2, h / 2 + 0.07, 0.03, frame);
        panel(w / 2, w / 2 + 0.07, -h / 2, h / 2 + 0.07, 0.03, frame);
        panel(-w / 2, w / 2, h / 2, h / 2 + 0.07, 0.03, frame);
        if (lift) {
            panel(-w / 2, -0.003, -h / 2, h / 2, 0.008, leaf);
            panel(0.003, w / 2, -h / 2, h / 2, 0.008, leaf);
        } else {
            panel(-w / 2, w / 2, -h / 2 + 0.01, h / 2, 0.008, leaf);
            Paint metal = paintOf(Material::Metal, linearOf(200, 200, 204));
            panel(w / 2 - 0.1, w / 2 - 0.06, -0.1, 0.1, 0.016, metal);
            m_builder.box(spot.at(w / 2 - 0.2, 0.02, 0.07), spot.right * 0.13F, spot.front * -0.018F,
                          kUp * 0.02F, metal);
        }
        m_scene.things[m_thing].corners = std::array<Vec3, 4>{
            spot.at(-w / 2 - 0.07, h / 2 + 0.07, 0.03), spot.at(w / 2 + 0.07, h / 2 + 0.07, 0.03),
            spot.at(w / 2 + 0.07, -h / 2, 0.03), spot.at(-w / 2 - 0.07, -h / 2, 0.03)};
    }

    SceneData& m_scene;
    const SceneOptions& m_options;
    const recognition::LandmarkLibrary* m_library;
    MeshBuilder m_builder;
    bool m_onWall = false;
    std::size_t m_thing = 0;
    std::set<std::size_t> m_windows; ///< landmarks that are holes in walls
    std::map<std::string, std::uint32_t> m_drawn;
    std::map<std::string, std::optional<std::uint32_t>> m_photographs;
    std::map<int, std::optional<std::uint32_t>> m_exitSigns;
    std::optional<std::uint32_t> m_extinguisherSign;
};

} // namespace

void addLandmarks(SceneData& scene, const SceneOptions& options,
                  const recognition::LandmarkLibrary* library) {
    LandmarkMaker maker(scene, options, library);
    for (std::size_t i = 0; i < scene.building->landmarks().size(); ++i) maker.make(i);
}

} // namespace farol::simulation
