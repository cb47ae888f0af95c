#include "ui/demo/simulated_walks.h"

#include <utility>

namespace farol::ui {

namespace {

constexpr const char* kSimulation = "sim:";
constexpr double kFramesPerSecond = 8.0;

/// A walk that the session owns and others talk to.
class SharedWalk : public capture::FrameSource {
public:
    explicit SharedWalk(std::shared_ptr<simulation::WalkSource> walk) : m_walk(std::move(walk)) {
        m_walk->onEvent([this](const capture::SourceEvent& event) { tell(event.kind, event.message); });
    }
    ~SharedWalk() override { m_walk->onEvent({}); }

    std::optional<capture::Frame> next() override { return m_walk->next(); }
    bool live() const override { return m_walk->live(); }
    bool keepsPace() const override { return m_walk->keepsPace(); }
    void setSpeed(double factor) override { m_walk->setSpeed(factor); }
    double framePeriod() const override { return m_walk->framePeriod(); }
    std::string description() const override { return m_walk->description(); }
    void requestStop() override {
        capture::FrameSource::requestStop();
        m_walk->requestStop();
    }

private:
    std::shared_ptr<simulation::WalkSource> m_walk;
};

} // namespace

bool isSimulation(const QString& source) {
    return source.startsWith(QLatin1String(kSimulation));
}

QString startOfSimulation(const QString& source) {
    return source.mid(QLatin1String(kSimulation).size());
}

void SimulatedWalks::plan(WalkPlan plan) {
    std::scoped_lock lock(m_mutex);
    m_plan = std::move(plan);
}

std::shared_ptr<simulation::WalkSource> SimulatedWalks::current() const {
    std::scoped_lock lock(m_mutex);
    return m_current;
}

Result<simulation::World> SimulatedWalks::worldOf(const std::shared_ptr<const building::Building>& building) {
    std::scoped_lock lock(m_building);
    if (!m_world || m_world->building() != building) {
        m_world.reset();
        auto world = simulation::buildWorld(building);
        if (!world) return world.error();
        m_world.emplace(std::move(world).value());
    }
    return *m_world;
}

Result<std::unique_ptr<capture::FrameSource>> SimulatedWalks::open() {
    WalkPlan plan;
    {
        std::scoped_lock lock(m_mutex);
        plan = m_plan;
    }
    if (!plan.building)
        return Error{ErrorCode::InvalidArgument, "a simulated walk needs a map; open one first", "sim:"};
    if (plan.from.empty())
        return Error{ErrorCode::InvalidArgument,
                     "there is no place in this map from which a simulated walk could start", "sim:"};
    auto world = worldOf(plan.building);
    if (!world) return world.error();
    simulation::WalkSourceOptions options;
    options.walker.seed = options.camera.seed = plan.seed;
    options.camera.shake = simulation::Shake::Chest;
    options.framesPerSecond = kFramesPerSecond;
    options.mostSeconds = plan.mostSeconds;
    options.afterArrivalS = plan.afterArrivalS;
    auto made = simulation::WalkSource::create(*world, {plan.from, {}}, options);
    if (!made) return made.error();
    std::shared_ptr<simulation::WalkSource> walk = std::move(made).value();
    std::scoped_lock lock(m_mutex);
    m_current = walk;
    return std::unique_ptr<capture::FrameSource>(new SharedWalk(std::move(walk)));
}

} // namespace farol::ui
