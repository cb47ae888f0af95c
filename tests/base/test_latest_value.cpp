#include "core/base/latest_value.h"

#include <gtest/gtest.h>
#include <memory>
#include <thread>
#include <vector>

namespace farol {
namespace {

TEST(LatestValue, KeepsTheNewestAndCountsTheDropped) {
    LatestValue<int> slot;
    slot.put(1);
    slot.put(2);
    slot.put(3);
    EXPECT_EQ(slot.dropped(), 2U);
    EXPECT_EQ(slot.tryTake(), 3);
    EXPECT_EQ(slot.tryTake(), std::nullopt);
}

TEST(LatestValue, HandsOverWhatCannotBeCopied) {
    LatestValue<std::unique_ptr<int>> slot;
    slot.put(std::make_unique<int>(5));
    auto taken = slot.take();
    ASSERT_TRUE(taken.has_value());
    EXPECT_EQ(**taken, 5);
}

TEST(LatestValue, AClosedMailboxStillGivesItsLastValue) {
    LatestValue<int> slot;
    slot.put(1);
    slot.close();
    slot.put(2);
    EXPECT_EQ(slot.take(), 1);
    EXPECT_EQ(slot.take(), std::nullopt);
    EXPECT_FALSE(slot.putWhenFree(3));
}

TEST(LatestValue, NothingIsLostWhenTheProducerWaits) {
    LatestValue<int> slot;
    constexpr int kCount = 2000;
    std::thread producer([&] {
        for (int i = 0; i < kCount; ++i) ASSERT_TRUE(slot.putWhenFree(i));
        slot.close();
    });
    std::vector<int> received;
    while (auto value = slot.take()) received.push_back(*value);
    producer.join();
    ASSERT_EQ(received.size(), static_cast<std::size_t>(kCount));
    for (int i = 0; i < kCount; ++i) EXPECT_EQ(received[static_cast<std::size_t>(i)], i);
    EXPECT_EQ(slot.dropped(), 0U);
}

TEST(LatestValue, OrderIsKeptAndEveryFrameIsTakenOrCounted) {
    LatestValue<int> slot;
    constexpr int kCount = 20000;
    std::thread producer([&] {
        for (int i = 0; i < kCount; ++i) slot.put(i);
        slot.close();
    });
    int last = -1;
    std::uint64_t taken = 0;
    while (auto value = slot.take()) {
        EXPECT_GT(*value, last);
        last = *value;
        ++taken;
    }
    producer.join();
    EXPECT_EQ(last, kCount - 1) << "the newest value must arrive";
    EXPECT_EQ(taken + slot.dropped(), static_cast<std::uint64_t>(kCount));
}

TEST(LatestValue, ClosingWakesAWaitingConsumer) {
    LatestValue<int> slot;
    std::thread consumer([&] { EXPECT_EQ(slot.take(), std::nullopt); });
    slot.close();
    consumer.join();
}

} // namespace
} // namespace farol
