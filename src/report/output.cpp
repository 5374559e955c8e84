#include "report/output.h"

#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace drawbead {

namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 16;

Error cannot_write(const std::string& path, int code) {
    return Error{"cannot write: " + std::generic_category().message(code), path, 0, 0, ""};
}

/// What the process would give a new file; there is no way to ask without setting it.
mode_t new_file_mode() {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666 & ~mask;
}

} // namespace

void OutputSink::write(std::string_view text) {
    if (error_) return;
    buffer_ += text;
    if (buffer_.size() >= buffer_size) flush();
}

void OutputSink::flush() {
    if (!error_ && !buffer_.empty())
        if (std::optional<Error> error = put(buffer_)) fail(std::move(*error));
    buffer_.clear();
}

void OutputSink::fail(Error error) {
    if (!error_) error_ = std::move(error);
}

Result<void> OutputSink::finish() {
    flush();
    if (error_) return *error_;
    return {};
}

std::optional<Error> StringSink::put(std::string_view text) {
    text_ += text;
    return std::nullopt;
}

FileSink::FileSink(int descriptor, std::string name) : descriptor_(descriptor), name_(std::move(name)) {}

Result<std::unique_ptr<FileSink>> FileSink::replace(const std::string& path) {
    struct stat existing {};
    const bool exists = ::stat(path.c_str(), &existing) == 0;
    if (exists && S_ISDIR(existing.st_mode)) return cannot_write(path, EISDIR);
    if (exists && !S_ISREG(existing.st_mode)) {
        const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
        if (descriptor < 0) return cannot_write(path, errno);
        auto sink = std::make_unique<FileSink>(descriptor, path);
        sink->owned_ = true;
        return sink;
    }
    // A file that may not be written must not be replaced either, even where the folder allows it.
    if (exists && ::access(path.c_str(), W_OK) != 0) return cannot_write(path, errno);
    std::string target = path;
    if (exists) {
        char* resolved = ::realpath(path.c_str(), nullptr);
        if (!resolved) return cannot_write(path, errno);
        target = resolved;
        std::free(resolved);
    }
    std::string temporary = target + ".XXXXXX";
    const int descriptor = ::mkstemp(temporary.data());
    if (descriptor < 0) return cannot_write(path, errno);
    ::fchmod(descriptor, exists ? existing.st_mode & 07777 : new_file_mode());
    auto sink = std::make_unique<FileSink>(descriptor, path);
    sink->owned_ = true;
    sink->target_ = std::move(target);
    sink->temporary_ = std::move(temporary);
    return sink;
}

FileSink::~FileSink() {
    if (owned_ && descriptor_ >= 0) ::close(descriptor_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

Error FileSink::system_error(int code) const {
    return cannot_write(name_, code);
}

std::optional<Error> FileSink::put(std::string_view text) {
    while (!text.empty()) {
        const ssize_t count = ::write(descriptor_, text.data(), text.size());
        if (count < 0) {
            if (errno == EINTR) continue;
            reader_gone_ = errno == EPIPE;
            return system_error(errno);
        }
        text.remove_prefix(static_cast<std::size_t>(count));
    }
    return std::nullopt;
}

Result<void> FileSink::finish() {
    flush();
    if (owned_ && descriptor_ >= 0) {
        // Some file systems report a full disk only here.
        if (::close(descriptor_) != 0 && errno != EINTR) fail(system_error(errno));
        descriptor_ = -1;
    }
    if (!temporary_.empty() && !failed()) {
        if (std::rename(temporary_.c_str(), target_.c_str()) == 0)
            temporary_.clear();
        else
            fail(system_error(errno));
    }
    return OutputSink::finish();
}

} // namespace drawbead
