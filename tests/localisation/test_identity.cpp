#include "core/localisation/identity.h"
#include "tests/localisation/walk.h"

#include <gtest/gtest.h>

using namespace farol;
using namespace farol::localisation;
using farol::test::seen;

namespace {

building::Landmark landmark(Kind kind, const std::string& templateId = {}, const std::string& text = {}) {
    building::Landmark result;
    result.kind = kind;
    result.templateId = TemplateId(templateId);
    result.text = text;
    return result;
}

bool matches(const recognition::Detection& detection, const building::Landmark& mapped, int tolerance = 0) {
    return sameThing(identityOf(mapped), identityOf(detection), tolerance);
}

TEST(Identity, TrainedTemplateDecidesWhenBothHaveOne) {
    EXPECT_TRUE(identical(seen(Kind::Poster, "fair"), seen(Kind::Poster, "fair")));
    EXPECT_FALSE(identical(seen(Kind::Poster, "fair"), seen(Kind::Poster, "concert")));
    EXPECT_TRUE(matches(seen(Kind::Poster, "fair"), landmark(Kind::Picture, "fair")));
}

TEST(Identity, KindDecidesWhenOneWasNeverTrained) {
    EXPECT_TRUE(matches(seen(Kind::Extinguisher, "red"), landmark(Kind::Extinguisher)));
    EXPECT_TRUE(matches(seen(Kind::Door), landmark(Kind::Door, "blue door")));
    EXPECT_FALSE(matches(seen(Kind::Door), landmark(Kind::Window)));
}

TEST(Identity, PlaceIsKnownByItsTemplateOnly) {
    EXPECT_TRUE(matches(seen(Kind::Place, "p1"), landmark(Kind::Place, "p1")));
    EXPECT_FALSE(matches(seen(Kind::Place, "p2"), landmark(Kind::Place, "p1")));
    EXPECT_FALSE(matches(seen(Kind::Place), landmark(Kind::Place, "p1")));
    EXPECT_FALSE(matches(seen(Kind::Place), landmark(Kind::Place)));
}

TEST(Identity, SignsAndTextsNeedTheSameWords) {
    EXPECT_TRUE(matches(seen(Kind::Text, {}, "2.14"), landmark(Kind::Text, {}, "2.14")));
    EXPECT_FALSE(matches(seen(Kind::Text, {}, "2.14"), landmark(Kind::Text, {}, "2.15")));
    EXPECT_FALSE(matches(seen(Kind::Sign, {}, "exit"), landmark(Kind::Sign, {}, "toilets")));
    EXPECT_FALSE(matches(seen(Kind::Text), landmark(Kind::Text, {}, "2.14")));
    EXPECT_TRUE(matches(seen(Kind::Sign), landmark(Kind::Sign)));
}

TEST(Identity, CaseAccentsAndSpacesDoNotMakeAnotherText) {
    EXPECT_TRUE(matches(seen(Kind::Text, {}, " sortie  A "), landmark(Kind::Text, {}, "Sortié a")));
}

TEST(Identity, WordsReadAreTheWordsOnADoorPlateToo) {
    EXPECT_TRUE(matches(seen(Kind::Text, {}, "2.14"), landmark(Kind::Door, {}, "2.14")));
    EXPECT_FALSE(matches(seen(Kind::Text, {}, "2.15"), landmark(Kind::Door, {}, "2.14")));
    EXPECT_FALSE(matches(seen(Kind::Text, {}, "2.15"), landmark(Kind::Door)));
}

TEST(Identity, ToleranceForgivesReadingErrorsButNeverTheWholeText) {
    EXPECT_FALSE(matches(seen(Kind::Text, {}, "SECRETARlA"), landmark(Kind::Text, {}, "SECRETARIA")));
    EXPECT_TRUE(matches(seen(Kind::Text, {}, "SECRETARlA"), landmark(Kind::Text, {}, "SECRETARIA"), 1));
    EXPECT_FALSE(matches(seen(Kind::Text, {}, "SECRFTARlA"), landmark(Kind::Text, {}, "SECRETARIA"), 1));
    EXPECT_FALSE(matches(seen(Kind::Text, {}, "B"), landmark(Kind::Text, {}, "A"), 1));
}

} // namespace
