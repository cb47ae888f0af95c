#include "core/base/file.h"

#include "core/base/base_sayings.h"

#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <unistd.h>
#include <vector>

namespace farol {

namespace fs = std::filesystem;

namespace {

/// No room on the disk, in the user's share of it, or in what a file may grow to.
bool isFull(int errorNumber) {
    return errorNumber == ENOSPC || errorNumber == EDQUOT || errorNumber == EFBIG;
}

} // namespace

Error systemError(int errorNumber, const std::string& action, const std::string& context) {
    ErrorCode code = isFull(errorNumber)     ? ErrorCode::NoSpace
                     : errorNumber == ENOENT ? ErrorCode::NotFound
                                             : ErrorCode::Io;
    return {code, action + ": " + std::strerror(errorNumber), context};
}

namespace {

Result<void> syncPath(const fs::path& path, int flags) {
    int descriptor = ::open(path.c_str(), flags | O_CLOEXEC);
    if (descriptor < 0) return systemError(errno, said(BaseSaying::NotReopened), path.string());
    int failed = ::fsync(descriptor) != 0 ? errno : 0;
    ::close(descriptor);
    if (failed != 0 && failed != EINVAL)
        return systemError(failed, said(BaseSaying::NotWrittenToDisk), path.string());
    return {};
}

Result<void> fillTemporary(const fs::path& target, const fs::path& temporary, bool seed,
                           const std::function<Result<void>(const fs::path&)>& write) {
    std::error_code failure;
    if (seed && fs::exists(target, failure)) {
        fs::copy_file(target, temporary, fs::copy_options::overwrite_existing, failure);
        if (failure) return systemError(failure.value(), said(BaseSaying::NotCopied), temporary.string());
    }
    if (auto written = write(temporary); !written) return written;
    if (auto synced = syncPath(temporary, O_RDWR); !synced) return synced;
    fs::rename(temporary, target, failure);
    if (failure) return systemError(failure.value(), said(BaseSaying::NotPutInPlace), target.string());
    // The rename itself must survive a power cut; a file system that cannot sync folders is not an error.
    fs::path folder = target.parent_path().empty() ? fs::path(".") : target.parent_path();
    (void)syncPath(folder, O_RDONLY | O_DIRECTORY);
    return {};
}

/// Names of temporary files: MAP.saving-HOST-PROCESS-NUMBER.EXTENSION
std::string savingMark(const fs::path& target) {
    char host[256] = {};
    if (::gethostname(host, sizeof host - 1) != 0) host[0] = 0;
    return target.stem().string() + ".saving-" + host + "-";
}

void removeWithSidecars(const fs::path& file) {
    std::error_code ignored;
    for (const char* suffix : {"", "-wal", "-shm", "-journal"}) fs::remove(file.string() + suffix, ignored);
}

/// What programs of this machine left that were killed in the middle of a save.
void sweep(const fs::path& target) {
    std::string mark = savingMark(target);
    fs::path folder = target.parent_path().empty() ? fs::path(".") : target.parent_path();
    std::error_code failure;
    std::vector<fs::path> stale;
    for (fs::directory_iterator at(folder, failure), end; !failure && at != end; at.increment(failure)) {
        std::string name = at->path().filename().string();
        if (name.rfind(mark, 0) != 0) continue;
        int process = 0;
        auto [rest, wrong] = std::from_chars(name.data() + mark.size(), name.data() + name.size(), process);
        // A program killed while it swept may have left a journal alone: endings do not matter.
        bool ours = wrong == std::errc() && process > 0 && *rest == '-';
        if (ours && ::kill(process, 0) != 0 && errno == ESRCH) stale.push_back(at->path());
    }
    for (const fs::path& file : stale) removeWithSidecars(file);
}

/// A database only says that it could not write; asking the disk itself tells why. The file is given up
/// anyway.
bool takesNoMore(const fs::path& temporary) {
    constexpr std::uintmax_t kLeastBytes = 16U << 20U;
    std::error_code failure;
    std::uintmax_t now = fs::exists(temporary, failure) ? fs::file_size(temporary, failure) : 0;
    int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    if (descriptor < 0) return isFull(errno);
    int failed = ::posix_fallocate(descriptor, 0, static_cast<off_t>(2 * now + kLeastBytes));
    ::close(descriptor);
    return isFull(failed);
}

} // namespace

Result<void> replaceFile(const fs::path& named, bool seed,
                         const std::function<Result<void>(const fs::path&)>& write) {
    static std::atomic<unsigned> counter{0};
    std::error_code failure;
    fs::path target = fs::is_symlink(named, failure) ? fs::weakly_canonical(named, failure) : named;
    if (fs::exists(target, failure) && !fs::is_regular_file(target, failure))
        return Error{ErrorCode::InvalidArgument, said(BaseSaying::NoOrdinaryFile), named.string()};
    sweep(target);
    // The extension stays last: GDAL chooses and checks formats by it.
    fs::path temporary = target.parent_path() / (savingMark(target) + std::to_string(::getpid()) + "-" +
                                                 std::to_string(counter++) + target.extension().string());
    auto result = fillTemporary(target, temporary, seed, write);
    if (result) return result;
    ErrorCode code = result.error().code;
    bool refused = code == ErrorCode::Io || code == ErrorCode::Corrupt || code == ErrorCode::Internal;
    bool full = code == ErrorCode::NoSpace || (refused && takesNoMore(temporary));
    removeWithSidecars(temporary);
    if (full)
        return Error{ErrorCode::NoSpace,
                     "the disk is full: free some space and save again; what was there before is untouched",
                     named.string()};
    return result;
}

Result<std::string> readFile(const fs::path& path) {
    std::error_code failure;
    if (fs::is_directory(path, failure))
        return Error{ErrorCode::InvalidArgument, "is a folder; a file is wanted", path.string()};
    errno = 0;
    std::ifstream in(path, std::ios::binary);
    if (!in) return systemError(errno != 0 ? errno : ENOENT, said(BaseSaying::NotOpened), path.string());
    std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    if (in.bad()) return systemError(EIO, said(BaseSaying::NotRead), path.string());
    return bytes;
}

} // namespace farol
