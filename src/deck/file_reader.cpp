#include "deck/file_reader.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace drawbead {

namespace {

constexpr std::size_t map_from = std::size_t{32} << 20;

Error system_error(const std::string& path, int number) {
    return Error{"cannot read '" + path + "': " + std::strerror(number), path, 0, 0, ""};
}

class Descriptor {
public:
    explicit Descriptor(int fd) : fd_(fd) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (fd_ >= 0) close(fd_);
    }
    int get() const { return fd_; }

private:
    int fd_;
};

/// Memory that is filled once: neither zeroed before nor copied after.
struct Bytes {
    std::unique_ptr<char[]> memory;
    std::size_t size = 0;
};

/// Reads to the end of the file; `expected` only sizes the first buffer (pipes and /proc files say 0). A zero
/// byte follows.
Result<Bytes> read_all(int fd, const std::string& path, std::size_t expected) {
    std::size_t room = expected + 1;
    Bytes out{std::unique_ptr<char[]>(new char[room]), 0};
    for (;;) {
        if (out.size == room) {
            std::unique_ptr<char[]> larger(new char[2 * room]);
            std::memcpy(larger.get(), out.memory.get(), out.size);
            out.memory = std::move(larger);
            room *= 2;
        }
        const ssize_t got = ::read(fd, out.memory.get() + out.size, room - out.size);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return system_error(path, errno);
        if (got == 0) break;
        out.size += static_cast<std::size_t>(got);
    }
    out.memory[out.size] = '\0'; // there is room: the loop ends with a read of at least one byte
    return out;
}

} // namespace

FileBytes::FileBytes(std::string text) : size_(text.size()), owned_(new char[text.size() + 1]) {
    std::memcpy(owned_.get(), text.data(), text.size());
    owned_[text.size()] = '\0';
    data_ = owned_.get();
}

FileBytes FileBytes::view_of(std::string_view bytes) {
    FileBytes out;
    out.data_ = bytes.data();
    out.size_ = bytes.size();
    return out;
}

FileBytes::FileBytes(FileBytes&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)),
      owned_(std::move(other.owned_)), mapped_(std::exchange(other.mapped_, false)) {}

FileBytes& FileBytes::operator=(FileBytes&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(owned_, other.owned_);
    std::swap(mapped_, other.mapped_);
    return *this;
}

FileBytes::~FileBytes() {
    if (mapped_) munmap(const_cast<char*>(data_), size_);
}

Result<FileBytes> DiskReader::read(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return system_error(path, errno);
    if (S_ISDIR(status.st_mode)) return Error{"cannot read '" + path + "': it is a folder", path, 0, 0, ""};
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.get() < 0 || ::fstat(file.get(), &status) != 0) return system_error(path, errno);
    stamps_[path] = {static_cast<uint64_t>(status.st_size), status.st_mtim.tv_sec, status.st_mtim.tv_nsec,
                     status.st_ino};
    const auto size = static_cast<std::size_t>(status.st_size);
    if (S_ISREG(status.st_mode) && size >= map_from) {
        void* memory = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.get(), 0);
        if (memory == MAP_FAILED) return system_error(path, errno);
        FileBytes bytes;
        bytes.data_ = static_cast<const char*>(memory);
        bytes.size_ = size;
        bytes.mapped_ = true;
        return bytes;
    }
    auto read = read_all(file.get(), path, S_ISREG(status.st_mode) ? size : 0);
    if (!read) return read.error();
    FileBytes bytes;
    bytes.owned_ = std::move(read->memory);
    bytes.data_ = bytes.owned_.get();
    bytes.size_ = read->size;
    return bytes;
}

bool DiskReader::exists(const std::string& path) {
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0;
}

std::string DiskReader::identity(const std::string& path) {
    std::error_code failure;
    const auto real = std::filesystem::canonical(path, failure);
    return failure ? path : real.string();
}

bool DiskReader::changed_since_read(const std::string& path) {
    const auto known = stamps_.find(path);
    if (known == stamps_.end()) return false;
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return true;
    const Stamp now{static_cast<uint64_t>(status.st_size), status.st_mtim.tv_sec, status.st_mtim.tv_nsec,
                    status.st_ino};
    return now != known->second;
}

Result<FileBytes> MemoryReader::read(const std::string& path) {
    const auto file = files_.find(path);
    if (file == files_.end())
        return Error{"cannot read '" + path + "': No such file or directory", path, 0, 0, ""};
    return FileBytes(file->second);
}

std::string join_path(std::string_view from, std::string_view path) {
    const std::filesystem::path wanted(path);
    if (wanted.is_absolute()) return wanted.lexically_normal().string();
    return (std::filesystem::path(from).parent_path() / wanted).lexically_normal().string();
}

} // namespace drawbead
