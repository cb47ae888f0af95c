#include "core/session/navigator.h"
#include "tests/session/walk_fixture.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace farol::session {
namespace {

std::unique_ptr<Navigator> navigator(const NavigatorOptions& options = {}) {
    auto made = Navigator::create(test::threeRooms(), options);
    EXPECT_TRUE(made);
    return std::move(made).value();
}

building::Location room(const char* id) {
    return {RegionId(id), std::nullopt};
}

bool told(const NavigationStep& step, guidance::CueKind kind) {
    return std::any_of(step.cues.begin(), step.cues.end(),
                       [&](const guidance::Cue& cue) { return cue.kind == kind; });
}

TEST(Navigator, FollowsTheWalkerFromRoomToRoom) {
    auto walk = navigator();
    walk->start(0.0, RegionId("A"));
    std::vector<std::string> regions;
    for (const Percept& percept : test::walkThroughTheRooms()) {
        NavigationStep step = walk->advance(percept);
        std::string region = step.fix.region ? step.fix.region->value : "?";
        if (regions.empty() || regions.back() != region) regions.push_back(region);
    }
    EXPECT_THAT(regions, testing::ElementsAre("A", "B", "C"));
}

TEST(Navigator, TellsTheRouteWithTheStepAfterTheDestination) {
    auto walk = navigator();
    walk->start(0.0, RegionId("A"));
    auto percepts = test::walkThroughTheRooms();
    EXPECT_EQ(walk->advance(percepts[0]).progress.travel, guidance::Travel::NoDestination);
    walk->setDestination(room("C"));
    bool routeTold = false;
    for (std::size_t i = 1; i < 4; ++i) {
        NavigationStep step = walk->advance(percepts[i]);
        ASSERT_TRUE(step.progress.route);
        EXPECT_THAT(step.progress.route->regions,
                    testing::ElementsAre(RegionId("A"), RegionId("B"), RegionId("C")));
        routeTold = routeTold || told(step, guidance::CueKind::RouteStart);
    }
    EXPECT_TRUE(routeTold);
}

/// Keeps what it is told; the place is always the first room.
class Listening final : public localisation::Localiser {
public:
    explicit Listening(std::vector<std::optional<localisation::ToldWay>>& told) : m_told(told) {}
    void start(double, const std::optional<RegionId>&) override {}
    void setRoute(const localisation::RouteContext&) override {}
    void told(const std::optional<localisation::ToldWay>& way) override { m_told.push_back(way); }
    localisation::Fix update(double time, std::span<const localisation::Observation>,
                             const std::deque<localisation::Observation>&) override {
        localisation::Fix fix;
        fix.time = fix.evidenceTime = time;
        fix.region = RegionId("A");
        fix.confidence = 0.9;
        return fix;
    }
    std::string name() const override { return "listening"; }

private:
    std::vector<std::optional<localisation::ToldWay>>& m_told;
};

TEST(Navigator, OnlyWhatTheVoiceBeganToSayCountsAsTold) {
    for (bool reported : {false, true}) {
        std::vector<std::optional<localisation::ToldWay>> told;
        NavigatorOptions options;
        options.heardIsReported = reported;
        auto walk = Navigator::create(test::threeRooms(), options, std::make_unique<Listening>(told));
        ASSERT_TRUE(walk);
        (*walk)->setDestination(room("C"));
        NavigationStep step = (*walk)->advance(test::walkThroughTheRooms().front());
        ASSERT_FALSE(step.cues.empty());
        EXPECT_EQ(told.size(), reported ? 0U : 1U) << "muted, or still waiting";
        for (int twice = 0; twice < 2; ++twice)
            for (const guidance::Cue& cue : step.cues) (*walk)->heard(cue.id);
        EXPECT_EQ(told.size(), 1U);
        (*walk)->heard(77777);
        EXPECT_EQ(told.size(), 1U);
        const guidance::Cue answer = (*walk)->answer(guidance::Question::Next);
        EXPECT_EQ(told.size(), 1U) << "not before it is heard";
        (*walk)->heard(answer.id);
        EXPECT_EQ(told.size(), reported ? 2U : 1U);
    }
}

/// Two minutes in the first room, asked every ten seconds what to do; the voice says what comes from `from`
/// to `to`.
std::vector<std::optional<localisation::ToldWay>> toldWhileHeard(double from, double to) {
    std::vector<std::optional<localisation::ToldWay>> told;
    NavigatorOptions options;
    options.heardIsReported = true;
    auto walk = Navigator::create(test::threeRooms(), options, std::make_unique<Listening>(told));
    if (!walk) return told;
    (*walk)->setDestination(room("C"));
    for (int i = 0; i < 240; ++i) {
        Percept percept;
        percept.frame = static_cast<std::uint64_t>(i);
        percept.time = 0.5 * i;
        std::vector<guidance::Cue> cues = (*walk)->advance(percept).cues;
        if (i % 20 == 19) cues.push_back((*walk)->answer(guidance::Question::Next));
        if (percept.time < from || percept.time > to) continue;
        for (const guidance::Cue& cue : cues) (*walk)->heard(cue.id);
    }
    return told;
}

TEST(Navigator, OrdersThatNobodyHearsAreNotBelievedToBeCarriedOut) {
    using Told = std::vector<std::optional<localisation::ToldWay>>;
    constexpr double kEver = 1000.0;
    for (const auto& way : toldWhileHeard(0.0, kEver)) {
        ASSERT_TRUE(way) << "the voice speaks";
        EXPECT_FALSE(way->passages.empty());
    }

    Told muted = toldWhileHeard(0.0, 35.0);
    ASSERT_GT(muted.size(), 1U);
    EXPECT_FALSE(muted.back()) << "muted on the way: nobody knows what the user does";
    muted.pop_back();
    for (const auto& way : muted) EXPECT_TRUE(way);

    EXPECT_TRUE(toldWhileHeard(kEver, kEver).empty()) << "no voice from the beginning: never known";

    Told again = toldWhileHeard(80.0, kEver);
    ASSERT_FALSE(again.empty());
    for (const auto& way : again) EXPECT_TRUE(way) << "the voice is back";
}

TEST(Navigator, SaysThatARoomCannotBeReached) {
    auto walk = navigator();
    walk->start(0.0, RegionId("A"));
    walk->setDestination(room("D"));
    bool said = false;
    for (const Percept& percept : test::walkThroughTheRooms()) {
        NavigationStep step = walk->advance(percept);
        said = said || told(step, guidance::CueKind::NoRoute);
    }
    EXPECT_TRUE(said);
}

TEST(Navigator, ALookAheadChangesNothing) {
    auto plain = navigator();
    auto curious = navigator();
    test::Lines a, b;
    for (Navigator* each : {plain.get(), curious.get()}) {
        each->start(0.0, RegionId("A"));
        each->setDestination(room("C"));
    }
    EXPECT_EQ(curious->preview().travel, guidance::Travel::OnRoute);
    for (const Percept& percept : test::walkThroughTheRooms()) {
        a.step(plain->advance(percept));
        b.step(curious->advance(percept));
        curious->preview();
        curious->preview();
    }
    EXPECT_EQ(a.text, b.text);
}

TEST(Navigator, AnswersAreForThePresentPlaceAndChangeNothing) {
    auto asked = navigator(), silent = navigator();
    for (auto* walk : {asked.get(), silent.get()}) {
        walk->start(0.0, RegionId("A"));
        walk->setDestination(room("C"));
    }
    guidance::Cue before = asked->answer(guidance::Question::Preview);
    EXPECT_EQ(before.kind, guidance::CueKind::Itinerary) << "before the first frame";
    EXPECT_EQ(before.steps.size(), 2U);
    std::vector<std::string> told[2];
    for (const Percept& percept : test::walkThroughTheRooms()) {
        for (const guidance::Cue& cue : asked->advance(percept).cues)
            told[0].push_back(cueKindName(cue.kind));
        for (const guidance::Cue& cue : silent->advance(percept).cues)
            told[1].push_back(cueKindName(cue.kind));
        for (auto question :
             {guidance::Question::WhereAmI, guidance::Question::AroundMe, guidance::Question::Next,
              guidance::Question::Remaining, guidance::Question::Repeat})
            EXPECT_TRUE(asked->answer(question).asked);
    }
    EXPECT_EQ(told[0], told[1]);
}

TEST(Navigator, ANewStartForgetsWhatWasSeen) {
    auto walk = navigator();
    walk->start(0.0, RegionId("A"));
    auto percepts = test::walkThroughTheRooms();
    NavigationStep before;
    for (std::size_t i = 0; i < 9; ++i) before = walk->advance(percepts[i]);
    EXPECT_FALSE(before.history.empty());
    walk->start(before.fix.time, std::nullopt);
    Percept nothing;
    nothing.time = before.fix.time;
    NavigationStep after = walk->advance(nothing);
    EXPECT_TRUE(after.history.empty());
    EXPECT_FALSE(after.fix.region);
}

TEST(Navigator, TimeNeverRunsBackwards) {
    auto walk = navigator();
    Percept percept;
    percept.time = 10.0;
    walk->advance(percept);
    percept.time = 3.0;
    EXPECT_EQ(walk->advance(percept).percept.time, 10.0);
}

TEST(Navigator, WarningsCountWithTheOtherCues) {
    auto walk = navigator();
    guidance::Cue first = walk->warning(guidance::CueReason::CameraLost, "unplugged");
    guidance::Cue second = walk->warning(guidance::CueReason::CameraBack, "");
    EXPECT_EQ(first.kind, guidance::CueKind::Warning);
    EXPECT_EQ(first.detail, "unplugged");
    EXPECT_LT(first.id, second.id);
}

TEST(Navigator, UnknownMethodsAreNamed) {
    NavigatorOptions options;
    options.localiser = "magic";
    auto made = Navigator::create(test::threeRooms(), options);
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::InvalidArgument);
    EXPECT_THAT(made.error().text(), testing::HasSubstr("voting"));
    options = {};
    options.planner = "magic";
    ASSERT_FALSE(Navigator::create(test::threeRooms(), options));
    ASSERT_FALSE(Navigator::create(nullptr));
    options = {};
    options.history.capacity = 0;
    ASSERT_FALSE(Navigator::create(test::threeRooms(), options));
}

} // namespace
} // namespace farol::session
