#include "core/base/ids.h"
#include "core/base/kind.h"
#include "core/base/log.h"

#include <gtest/gtest.h>
#include <set>
#include <string>
#include <unordered_set>

namespace farol {
namespace {

TEST(Kinds, EveryNameReadsBack) {
    std::set<std::string> names;
    for (Kind kind : allKinds()) {
        EXPECT_EQ(kindFromName(kindName(kind)), kind);
        names.insert(std::string(kindName(kind)));
    }
    EXPECT_EQ(names.size(), 20U) << "the design lists twenty kinds";
    EXPECT_EQ(kindName(Kind::VendingMachine), "vending_machine");
    EXPECT_EQ(kindFromName("Door"), std::nullopt) << "names are exact";
}

TEST(Ids, CompareAndHashByText) {
    std::unordered_set<RegionId> seen{RegionId("R1"), RegionId("R2"), RegionId("R1")};
    EXPECT_EQ(seen.size(), 2U);
    EXPECT_LT(RegionId("R1"), RegionId("R2"));
    EXPECT_TRUE(RegionId().empty());
}

TEST(Log, GoesToTheSinkThatIsSet) {
    std::string heard;
    setLogSink([&](LogLevel level, const std::string& message) {
        heard += (level == LogLevel::Warning ? "W " : "? ") + message;
    });
    logWarning("the camera went away");
    setLogSink(nullptr);
    logWarning("nobody listens");
    EXPECT_EQ(heard, "W the camera went away");
}

} // namespace
} // namespace farol
