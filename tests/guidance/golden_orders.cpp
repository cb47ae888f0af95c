// golden_orders: is every order of the golden walks, and of walks through the demo building, understood from
// its sentence as it was meant?

#include "core/session/closed_loop.h"
#include "core/simulation/spoken_instruction.h"
#include "tests/guidance/golden_walk.h"
#include "ui/speech/phrasebook.h"

#include <QCoreApplication>

#include <cmath>
#include <cstdio>

#include "resources/demo/demo_building.h"

namespace {

using farol::Radians;
using farol::guidance::Cue;
using farol::guidance::CueKind;
using farol::routing::Side;
using farol::simulation::Feature;
using farol::simulation::Order;
using farol::simulation::WalkInstruction;
using farol::simulation::WalkTask;

/// A side that comes from an hour is a side to who hears it.
Side sideOf(const WalkInstruction& meant) {
    if (meant.task.side != Side::None || !meant.hour) return meant.task.side;
    int hour = ((*meant.hour % 12) + 12) % 12;
    return hour >= 2 && hour <= 4 ? Side::Right : hour >= 8 && hour <= 10 ? Side::Left : Side::None;
}

bool sameTurn(const std::optional<Radians>& a, const std::optional<Radians>& b) {
    return a.has_value() == b.has_value() && (!a || std::abs(farol::wrapped(*a - *b).value) < 1e-6);
}

/// Empty when the sentence was heard as it was meant; what it leaves out may be left out.
const char* difference(const WalkInstruction& meant, const WalkInstruction& heard) {
    if (meant.order != heard.order) return "order";
    if (meant.order == Order::Sweep) return meant.sweep == heard.sweep ? nullptr : "sweep";
    if (meant.order != Order::Go) return nullptr;
    if (meant.now != heard.now) return "now";
    if (meant.astray != heard.astray) return "astray";
    if (!sameTurn(meant.turnFirst, heard.turnFirst)) return "turn first";
    const WalkTask &task = meant.task, &said = heard.task;
    if (task.feature != said.feature) return "feature";
    bool isLift = task.feature == Feature::Elevator; // "Soon: a lift" leaves open which way
    if (task.vertical != said.vertical && !(isLift && said.vertical == farol::routing::Vertical::None))
        return "up or down";
    if (said.side != sideOf(meant)) return "side";
    if (said.number != 0 && said.number != task.number) return "number";
    if (said.alongWall != task.alongWall) return "along the wall";
    if (said.ahead && !task.ahead) return "ahead";
    if (task.feature == Feature::Turn && !sameTurn(task.turn, said.turn)) return "turn";
    if (said.behind && !sameTurn(task.behind, said.behind)) return "turn behind";
    if (said.turn && task.turn && !sameTurn(task.turn, said.turn)) return "turn at it";
    if (!said.into.empty() && said.into != task.into) return "place";
    if (!said.level.empty() && said.level != task.level) return "level";
    if (heard.then.feature != Feature::None && heard.then.feature != meant.then.feature) return "then";
    if (heard.distanceM && !meant.distanceM) return "distance";
    if (heard.distanceM && std::abs(*heard.distanceM - *meant.distanceM) > 5.5) return "distance";
    return nullptr;
}

struct Listener {
    int orders = 0, wrong = 0;

    void hear(const Cue& cue, const QString& words) {
        // Answers to questions are told, not done.
        if (cue.asked || cue.kind == CueKind::Itinerary || cue.kind == CueKind::Around) return;
        WalkInstruction meant = farol::simulation::instructionOf(cue);
        WalkInstruction heard = farol::simulation::instructionFrom(words.toStdString());
        orders += meant.order != Order::Inform ? 1 : 0;
        if (words.isEmpty()) return;
        const char* what = difference(meant, heard);
        if (what == nullptr) return;
        ++wrong;
        std::printf("%s: \"%s\"\n", what, qUtf8Printable(words));
    }
};

void listenInDemo(Listener& listener) {
    auto world = std::make_shared<const farol::simulation::WalkWorld>(
        std::make_shared<const farol::building::Building>(farol::demo::demoBuilding()));
    const auto& regions = world->building().regions();
    farol::ui::Phrasebook words;
    for (std::size_t walk = 0; walk < 16; ++walk) {
        farol::session::ClosedLoopOptions options;
        options.walker.seed = walk;
        options.truePlace = walk % 2 == 0 ? farol::session::TruePlace::Spot : farol::session::TruePlace::No;
        farol::simulation::TruthDetectionOptions detections;
        detections.seed = walk;
        std::size_t from = (walk * 37 + 3) % regions.size(), to = (walk * 53 + 70) % regions.size();
        auto loop = farol::session::ClosedLoop::create(world, {regions[from].id, {}}, {regions[to].id, {}},
                                                       options, farol::session::truthEye(world, detections));
        if (!loop) continue;
        (*loop)->setEar([&](const Cue& cue) {
            listener.hear(cue, words.sentence(cue));
            return std::optional(farol::simulation::instructionOf(cue));
        });
        if (!(*loop)->run()) ++listener.wrong;
    }
}

} // namespace

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    if (!farol::ui::installTranslation(QStringLiteral("en"))) return 1;
    Listener listener;
    for (const farol::test::GoldenBuilding& golden : farol::test::goldenBuildings())
        farol::test::listenToWalk(golden,
                                  [&](const Cue& cue, const QString& words) { listener.hear(cue, words); });
    int golden = listener.orders;
    listenInDemo(listener);
    std::printf("%d orders of the golden walks, %d of the demo building, %d not heard as meant\n", golden,
                listener.orders - golden, listener.wrong);
    return golden > 50 && listener.orders > golden + 200 && listener.wrong == 0 ? 0 : 1;
}
