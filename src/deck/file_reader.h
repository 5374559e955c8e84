#pragma once
// Bytes of files, behind an interface so that include handling can be tested without a disk.
#include "base/result.h"

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace drawbead {

/// The bytes of one file: owned memory below 32 MB, a private read-only mapping above.
class FileBytes {
public:
    FileBytes() = default;
    explicit FileBytes(std::string text);
    /// Bytes that somebody else owns and keeps.
    static FileBytes view_of(std::string_view bytes);
    FileBytes(FileBytes&&) noexcept;
    FileBytes& operator=(FileBytes&&) noexcept;
    ~FileBytes();

    std::string_view view() const { return {data_, size_}; }

private:
    friend class DiskReader;
    const char* data_ = nullptr;
    std::size_t size_ = 0;
    std::unique_ptr<char[]> owned_;
    bool mapped_ = false;
};

class FileReader {
public:
    virtual ~FileReader() = default;
    /// All bytes of a regular file, or why not (missing, a folder, no permission), without place.
    virtual Result<FileBytes> read(const std::string& path) = 0;
    virtual bool exists(const std::string& path) = 0;
    /// The same text for two paths of the same file (device and inode on a disk), for cycle detection.
    virtual std::string identity(const std::string& path) = 0;
    /// Whether the bytes of `path` may have changed since `read`: mapped files can be rewritten by others
    /// meanwhile.
    virtual bool changed_since_read(const std::string& path) = 0;
};

class DiskReader final : public FileReader {
public:
    Result<FileBytes> read(const std::string& path) override;
    bool exists(const std::string& path) override;
    std::string identity(const std::string& path) override;
    bool changed_since_read(const std::string& path) override;

private:
    struct Stamp {
        uint64_t size = 0;
        int64_t seconds = 0, nanoseconds = 0;
        uint64_t inode = 0;
        friend bool operator==(const Stamp&, const Stamp&) = default;
    };
    std::map<std::string, Stamp> stamps_;
};

/// Files that live in memory: tests, fuzzing, standard input.
class MemoryReader : public FileReader {
public:
    void add(std::string path, std::string text) { files_[std::move(path)] = std::move(text); }
    Result<FileBytes> read(const std::string& path) override;
    bool exists(const std::string& path) override { return files_.count(path) != 0; }
    std::string identity(const std::string& path) override { return path; }
    bool changed_since_read(const std::string&) override { return false; }

private:
    std::map<std::string, std::string> files_;
};

/// `path` seen from the folder of the file `from`; an absolute path stays, "." and ".." are folded.
std::string join_path(std::string_view from, std::string_view path);

} // namespace drawbead
