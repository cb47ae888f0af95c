#include "core/base/error.h"

#include <gtest/gtest.h>
#include <memory>

namespace farol {
namespace {

Result<int> half(int number) {
    if (number % 2 != 0)
        return Error{ErrorCode::InvalidArgument, "is odd; give an even number", std::to_string(number)};
    return number / 2;
}

TEST(Result, HoldsAValueOrAnError) {
    EXPECT_EQ(half(4).value(), 2);
    auto odd = half(3);
    ASSERT_FALSE(odd.ok());
    EXPECT_EQ(odd.error().code, ErrorCode::InvalidArgument);
    EXPECT_EQ(odd.error().text(), "3: is odd; give an even number");
}

TEST(Result, MovesWhatCannotBeCopied) {
    Result<std::unique_ptr<int>> made(std::make_unique<int>(7));
    std::unique_ptr<int> taken = std::move(made).value();
    EXPECT_EQ(*taken, 7);
}

TEST(Result, OfVoidIsDoneUnlessToldOtherwise) {
    EXPECT_TRUE(Result<void>{}.ok());
    Result<void> failed = Error{ErrorCode::NoSpace, "the disk is full", ""};
    EXPECT_EQ(failed.error().text(), "the disk is full");
    EXPECT_STREQ(errorCodeName(failed.error().code), "no_space");
}

} // namespace
} // namespace farol
