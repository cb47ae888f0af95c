#include "core/guidance/clock.h"

#include <gtest/gtest.h>
#include <limits>
#include <utility>
#include <vector>

using namespace farol;
using namespace farol::guidance;

namespace {

TEST(Clock, HoursOfThePaperRepaired) {
    const std::vector<std::pair<double, int>> vectors{{0, 12},  {-30, 1}, {-90, 3},  {180, 6},  {-180, 6},
                                                      {90, 9},  {30, 11}, {270, 3},  {-270, 9}, {60, 10},
                                                      {-60, 2}, {150, 7}, {-150, 5}, {720, 12}, {-750, 1}};
    for (auto [degrees, hour] : vectors) EXPECT_EQ(clockHour(fromDegrees(degrees)), hour) << degrees;
}

TEST(Clock, RoundsToTheNearestHourAndNeverSaysZero) {
    EXPECT_EQ(clockHour(fromDegrees(14)), 12);
    EXPECT_EQ(clockHour(fromDegrees(-14)), 12);
    EXPECT_EQ(clockHour(fromDegrees(16)), 11);
    EXPECT_EQ(clockHour(fromDegrees(-16)), 1);
    for (int degrees = -720; degrees <= 720; ++degrees) {
        int hour = clockHour(fromDegrees(degrees));
        EXPECT_GE(hour, 1);
        EXPECT_LE(hour, 12);
    }
    EXPECT_EQ(clockHour({std::numeric_limits<double>::quiet_NaN()}), 12);
}

TEST(TurnWords, Bins) {
    EXPECT_EQ(turnWord(fromDegrees(0)), TurnWord::Straight);
    EXPECT_EQ(turnWord(fromDegrees(5)), TurnWord::Straight);
    EXPECT_EQ(turnWord(fromDegrees(22)), TurnWord::Straight);
    EXPECT_EQ(turnWord(fromDegrees(23)), TurnWord::SlightLeft);
    EXPECT_EQ(turnWord(fromDegrees(-23)), TurnWord::SlightRight);
    EXPECT_EQ(turnWord(fromDegrees(61)), TurnWord::Left);
    EXPECT_EQ(turnWord(fromDegrees(90)), TurnWord::Left);
    EXPECT_EQ(turnWord(fromDegrees(-90)), TurnWord::Right);
    EXPECT_EQ(turnWord(fromDegrees(121)), TurnWord::SharpLeft);
    EXPECT_EQ(turnWord(fromDegrees(-121)), TurnWord::SharpRight);
    EXPECT_EQ(turnWord(fromDegrees(151)), TurnWord::Back);
    EXPECT_EQ(turnWord(fromDegrees(180)), TurnWord::Back);
    EXPECT_EQ(turnWord(fromDegrees(-180)), TurnWord::Back);
    EXPECT_EQ(turnWord(fromDegrees(270)), TurnWord::Right) << "the same as a quarter to the right";
}

} // namespace
