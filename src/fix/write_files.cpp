#include "fix/write_files.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <optional>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace drawbead {

namespace {

constexpr std::size_t compared_up_to = std::size_t{32} << 20;

Error cannot(const std::string& what, const std::string& path, int code, std::string help) {
    return Error{"cannot " + what + ": " + std::generic_category().message(code), path, 0, 0,
                 std::move(help)};
}

constexpr const char* untouched = "no file was changed";

/// A file that is written beside its target and takes its place on command; it vanishes otherwise.
class Replacement {
public:
    Replacement() = default;
    Replacement(const Replacement&) = delete;
    Replacement& operator=(const Replacement&) = delete;
    ~Replacement() {
        if (!temporary_.empty()) ::unlink(temporary_.c_str());
        if (!backup_.empty()) ::unlink(backup_.c_str());
    }

    /// Writes all bytes to the disk. `like`: whose permissions it takes when the target does not exist.
    std::optional<Error> prepare(const std::string& path, std::string_view text, const std::string& like) {
        path_ = path;
        struct stat old {};
        const bool exists = ::stat(path.c_str(), &old) == 0;
        if (exists && !S_ISREG(old.st_mode)) {
            errno = S_ISDIR(old.st_mode) ? EISDIR : EINVAL;
            return cannot("write", path, errno, "only regular files are replaced");
        }
        // A file that may not be written must not be replaced either, even where the folder allows it.
        if (exists && ::access(path.c_str(), W_OK) != 0) return cannot("write", path, errno, untouched);
        target_ = path;
        if (exists) {
            char* resolved = ::realpath(path.c_str(), nullptr);
            if (!resolved) return cannot("write", path, errno, untouched);
            target_ = resolved;
            std::free(resolved);
        } else if (::stat(like.c_str(), &old) != 0) {
            old.st_mode = 0644;
        }
        std::string name = target_ + ".XXXXXX";
        const int file = ::mkstemp(name.data());
        if (file < 0) return cannot("write beside the file", path, errno, untouched);
        temporary_ = std::move(name);
        const auto failed = [&](int code) {
            ::close(file);
            return cannot("write", path, code, untouched);
        };
        while (!text.empty()) {
            const ssize_t count = ::write(file, text.data(), text.size());
            if (count < 0 && errno == EINTR) continue;
            if (count < 0) return failed(errno);
            text.remove_prefix(static_cast<std::size_t>(count));
        }
        if (exists && ::fchown(file, old.st_uid, old.st_gid) != 0 && errno != EPERM) return failed(errno);
        if (::fchmod(file, old.st_mode & 07777) != 0) return failed(errno);
        if (::fsync(file) != 0) return failed(errno);
        if (::close(file) != 0 && errno != EINTR) return cannot("write", path, errno, untouched);
        return std::nullopt;
    }

    /// Gives the old file a second name.
    std::optional<Error> keep_old() {
        std::string name = target_ + ".old.XXXXXX";
        const int file = ::mkstemp(name.data());
        if (file < 0) return cannot("write beside the file", path_, errno, untouched);
        ::close(file);
        ::unlink(name.c_str());
        if (::link(target_.c_str(), name.c_str()) != 0)
            return cannot("keep the old file under a second name", path_, errno, untouched);
        backup_ = std::move(name);
        return std::nullopt;
    }

    std::optional<Error> put_in_place() {
        if (std::rename(temporary_.c_str(), target_.c_str()) != 0)
            return cannot("replace the file", path_, errno, untouched);
        temporary_.clear();
        return std::nullopt;
    }
    /// False when the old file remains under its second name only.
    bool put_back() {
        if (backup_.empty() || std::rename(backup_.c_str(), target_.c_str()) != 0) return false;
        backup_.clear();
        return true;
    }
    std::string leave_backup() { return std::exchange(backup_, {}); }

    /// So that the new name is on the disk, too. Some file systems cannot; that is no error.
    void sync_folder() const {
        const std::size_t slash = target_.rfind('/');
        const std::string folder = slash == std::string::npos ? "." : target_.substr(0, slash + 1);
        const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (file < 0) return;
        ::fsync(file);
        ::close(file);
    }

private:
    std::string path_, target_, temporary_, backup_;
};

/// Whether a file holds other bytes.
bool differs(const std::string& path, std::string_view bytes) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return true;
    std::string buffer(std::size_t{1} << 16, '\0');
    bool different = false;
    for (std::size_t at = 0; !different;) {
        const ssize_t count = ::read(file, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        const auto size = static_cast<std::size_t>(count < 0 ? 0 : count);
        different = count < 0 || size > bytes.size() - at ||
                    std::memcmp(buffer.data(), bytes.data() + at, size) != 0 ||
                    (count == 0 && at != bytes.size());
        at += size;
        if (count == 0) break;
    }
    ::close(file);
    return different;
}

} // namespace

Result<void> replace_files(const std::vector<FileToWrite>& files,
                           const std::function<bool(const std::string& path)>& changed) {
    std::vector<Replacement> all(files.size());
    for (std::size_t i = 0; i < files.size(); ++i)
        if (auto error = all[i].prepare(files[i].path, files[i].text, {})) return *error;
    for (const FileToWrite& file : files)
        if (changed(file.path) ||
            (file.original.size() < compared_up_to && differs(file.path, file.original)))
            return Error{"the file was changed by somebody else while it was being repaired", file.path, 0, 0,
                         "no file was changed by this run; run it again"};
    for (std::size_t i = 0; files.size() > 1 && i < files.size(); ++i)
        if (auto error = all[i].keep_old()) return *error;
    for (std::size_t i = 0; i < files.size(); ++i) {
        auto error = all[i].put_in_place();
        if (!error) continue;
        for (std::size_t k = 0; k < i; ++k)
            if (!all[k].put_back())
                error->help =
                    "the old bytes of '" + files[k].path + "' are in '" + all[k].leave_backup() + "'";
        return *error;
    }
    for (const Replacement& one : all)
        one.sync_folder();
    return {};
}

Result<void> write_file(const std::string& path, std::string_view text, const std::string& like) {
    Replacement one;
    if (auto error = one.prepare(path, text, like)) return *error;
    if (auto error = one.put_in_place()) return *error;
    one.sync_folder();
    return {};
}

} // namespace drawbead
