#include "core/base/file.h"

#include <cerrno>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace farol {
namespace {

namespace fs = std::filesystem;

class ReplaceFile : public testing::Test {
protected:
    void SetUp() override {
        // One folder a test: CTest runs them side by side, each in a process of its own.
        const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
        m_folder = fs::path(testing::TempDir()) / ("farol_replace_file_" + name);
        fs::remove_all(m_folder);
        fs::create_directories(m_folder);
        m_target = m_folder / "map.gpkg";
        std::ofstream(m_target) << "old";
    }
    void TearDown() override { fs::remove_all(m_folder); }

    std::string content() const { return readFile(m_target).value(); }
    std::size_t filesLeft() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(m_folder), fs::directory_iterator{}));
    }
    static Result<void> writeNew(const fs::path& path) {
        std::ofstream(path) << "new";
        return {};
    }

    fs::path m_folder;
    fs::path m_target;
};

TEST_F(ReplaceFile, PutsTheNewContentInPlace) {
    ASSERT_TRUE(replaceFile(m_target, false, writeNew).ok());
    EXPECT_EQ(content(), "new");
    EXPECT_EQ(filesLeft(), 1U);
}

TEST_F(ReplaceFile, LeavesTheOldFileWholeWhenWritingFails) {
    auto result = replaceFile(m_target, false, [](const fs::path& path) -> Result<void> {
        std::ofstream(path) << "ha";
        return Error{ErrorCode::NoSpace, "the disk is full", path.string()};
    });
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::NoSpace);
    EXPECT_EQ(content(), "old");
    EXPECT_EQ(filesLeft(), 1U) << "the temporary file is left behind";
}

TEST_F(ReplaceFile, StartsFromTheOldContentWhenSeeded) {
    auto result = replaceFile(m_target, true, [](const fs::path& path) -> Result<void> {
        EXPECT_EQ(readFile(path).value(), "old");
        EXPECT_EQ(path.extension(), ".gpkg");
        std::ofstream(path, std::ios::app) << "er";
        return {};
    });
    ASSERT_TRUE(result.ok());
    EXPECT_EQ(content(), "older");
}

TEST_F(ReplaceFile, SweepsWhatKilledProgramsLeft) {
    fs::path left, inUse;
    ASSERT_TRUE(replaceFile(m_target, false, [&](const fs::path& path) {
                    left = inUse = path;
                    return writeNew(path);
                }).ok());
    pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    ASSERT_GT(child, 0);
    ::waitpid(child, nullptr, 0); // from here on there is no such process
    std::string name = left.filename().string(), own = "-" + std::to_string(::getpid()) + "-";
    left.replace_filename(
        std::string(name).replace(name.find(own), own.size(), "-" + std::to_string(child) + "-"));
    for (const std::string& file : {left.string(), left.string() + "-journal", inUse.string()})
        std::ofstream(file) << "half";
    ASSERT_TRUE(replaceFile(m_target, false, writeNew).ok());
    EXPECT_FALSE(fs::exists(left));
    EXPECT_FALSE(fs::exists(left.string() + "-journal"));
    EXPECT_TRUE(fs::exists(inUse)) << "another save of a living program";
}

TEST_F(ReplaceFile, SaysWhichFolderIsMissing) {
    auto result = replaceFile(m_folder / "none" / "map.gpkg", false, writeNew);
    ASSERT_FALSE(result.ok());
    EXPECT_NE(result.error().text().find("none"), std::string::npos);
}

TEST(ReadFile, TellsMissingFilesAndFolders) {
    EXPECT_EQ(readFile("no-such-file").error().code, ErrorCode::NotFound);
    EXPECT_EQ(readFile(testing::TempDir()).error().code, ErrorCode::InvalidArgument);
}

TEST(SystemError, KnowsAFullDisk) {
    EXPECT_EQ(systemError(ENOSPC, "cannot write", "x").code, ErrorCode::NoSpace);
    EXPECT_EQ(systemError(EACCES, "cannot write", "x").code, ErrorCode::Io);
}

} // namespace
} // namespace farol
