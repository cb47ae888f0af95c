#include "core/base/file.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <unistd.h>

namespace farol {

namespace fs = std::filesystem;

Error systemError(int errorNumber, const std::string& action, const std::string& context) {
    ErrorCode code = errorNumber == ENOSPC || errorNumber == EDQUOT ? ErrorCode::NoSpace
                     : errorNumber == ENOENT                        ? ErrorCode::NotFound
                                                                    : ErrorCode::Io;
    return {code, action + ": " + std::strerror(errorNumber), context};
}

namespace {

Result<void> syncPath(const fs::path& path, int flags) {
    int descriptor = ::open(path.c_str(), flags | O_CLOEXEC);
    if (descriptor < 0) return systemError(errno, "cannot reopen for writing", path.string());
    int failed = ::fsync(descriptor) != 0 ? errno : 0;
    ::close(descriptor);
    if (failed != 0 && failed != EINVAL) return systemError(failed, "cannot write to disk", path.string());
    return {};
}

Result<void> fillTemporary(const fs::path& target, const fs::path& temporary, bool seed,
                           const std::function<Result<void>(const fs::path&)>& write) {
    std::error_code failure;
    if (seed && fs::exists(target, failure)) {
        fs::copy_file(target, temporary, fs::copy_options::overwrite_existing, failure);
        if (failure) return systemError(failure.value(), "cannot copy before saving", temporary.string());
    }
    if (auto written = write(temporary); !written) return written;
    if (auto synced = syncPath(temporary, O_RDWR); !synced) return synced;
    fs::rename(temporary, target, failure);
    if (failure) return systemError(failure.value(), "cannot put the new file in place", target.string());
    // The rename itself must survive a power cut; a file system that cannot sync folders is not an error.
    fs::path folder = target.parent_path().empty() ? fs::path(".") : target.parent_path();
    (void)syncPath(folder, O_RDONLY | O_DIRECTORY);
    return {};
}

} // namespace

Result<void> replaceFile(const fs::path& target, bool seed,
                         const std::function<Result<void>(const fs::path&)>& write) {
    static std::atomic<unsigned> counter{0};
    // The extension stays last: GDAL chooses and checks formats by it.
    fs::path temporary =
        target.parent_path() / (target.stem().string() + ".saving-" + std::to_string(::getpid()) + "-" +
                                std::to_string(counter++) + target.extension().string());
    auto result = fillTemporary(target, temporary, seed, write);
    if (!result) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        for (const char* suffix : {"-wal", "-shm", "-journal"})
            fs::remove(temporary.string() + suffix, ignored);
    }
    return result;
}

Result<std::string> readFile(const fs::path& path) {
    std::error_code failure;
    if (fs::is_directory(path, failure))
        return Error{ErrorCode::InvalidArgument, "is a folder; a file is wanted", path.string()};
    errno = 0;
    std::ifstream in(path, std::ios::binary);
    if (!in) return systemError(errno != 0 ? errno : ENOENT, "cannot open", path.string());
    std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    if (in.bad()) return systemError(EIO, "cannot read", path.string());
    return bytes;
}

} // namespace farol
