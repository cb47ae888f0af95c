#include "core/base/database_source.h"
#include "core/base/ogr.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace farol {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(DatabaseSource, FilesAreShownAsTheyAre) {
    for (const char* file : {"campus.gpkg", "/maps/PG campus.gpkg", "C:maps.gpkg", ""}) {
        EXPECT_FALSE(isDatabase(file));
        EXPECT_EQ(shownSource(file), file);
    }
}

TEST(DatabaseSource, APasswordIsNeverShown) {
    EXPECT_EQ(shownSource("PG:dbname=campus host=maps user=anna password=hunter2"),
              "PG:dbname=campus host=maps user=anna");
    EXPECT_EQ(shownSource("pg: password = 'hunter2 \\' x' dbname='a b'"), "PG:dbname='a b'");
    for (const char* source : {"PG:dbname=campus password=two words hunter2", "PG:password='hunter2",
                               "PG:hunter2", "PG:passwort=hunter2", "postgresql://anna:hunter2@maps/campus",
                               "PG:postgresql://anna:hunter2@maps/campus", "PG:dbname=x =hunter2"}) {
        EXPECT_TRUE(isDatabase(source));
        EXPECT_THAT(shownSource(source), Not(HasSubstr("hunter2"))) << source;
        auto opened = openVector(source);
        ASSERT_FALSE(opened.ok());
        EXPECT_EQ(opened.error().code, ErrorCode::InvalidArgument);
        EXPECT_THAT(opened.error().text(), Not(HasSubstr("hunter2"))) << source;
        EXPECT_THAT(opened.error().text(), HasSubstr("dbname=campus host=maps")) << "it says how to write it";
    }
    EXPECT_EQ(withoutSecrets("bad: PG:dbname=x password=hunter2 and hunter2", "PG:dbname=x password=hunter2"),
              "bad: PG:dbname=x and ***");
}

TEST(DatabaseSource, NobodyWaitsForEver) {
    EXPECT_EQ(*checkedConnection("PG:dbname=campus"), "PG:dbname=campus connect_timeout=10");
    EXPECT_EQ(*checkedConnection("PG:dbname=campus connect_timeout=3"), "PG:dbname=campus connect_timeout=3");
}

TEST(DatabaseSource, AServerThatIsNotThereIsSaidSo) {
    auto opened = openVector("PG:dbname=campus host=/nowhere/at/all user=anna password=hunter2");
    ASSERT_FALSE(opened.ok());
    EXPECT_EQ(opened.error().code, ErrorCode::Unavailable);
    EXPECT_EQ(opened.error().context, "PG:dbname=campus host=/nowhere/at/all user=anna");
    EXPECT_THAT(opened.error().text(), Not(HasSubstr("hunter2")));
}

} // namespace
} // namespace farol
