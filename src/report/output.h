#pragma once
// Where results go. Writing is buffered, and no write error is lost: a full disk or a closed pipe is seen at
// the latest by finish().
#include "base/result.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace drawbead {

class OutputSink {
public:
    OutputSink() = default;
    OutputSink(const OutputSink&) = delete;
    OutputSink& operator=(const OutputSink&) = delete;
    virtual ~OutputSink() = default;

    /// Appends to the buffer; hands it over when it is full. After the first error everything is dropped.
    void write(std::string_view text);
    void write(char c) { write(std::string_view(&c, 1)); }
    /// Hands over what is buffered.
    void flush();
    bool failed() const { return error_.has_value(); }
    /// The reader of a pipe has gone: nothing that anyone wants to be told.
    bool reader_gone() const { return reader_gone_; }
    /// Flushes, and for a file makes it appear under its name. Returns the first error since the start.
    virtual Result<void> finish();
    /// From now on everything is dropped, and finish() returns this error, unless there was one before.
    void fail(Error error);

protected:
    virtual std::optional<Error> put(std::string_view text) = 0;
    bool reader_gone_ = false;

private:
    std::string buffer_;
    std::optional<Error> error_;
};

/// Collects the text: tests, and whatever wants it in memory.
class StringSink final : public OutputSink {
public:
    const std::string& text() {
        flush();
        return text_;
    }

private:
    std::optional<Error> put(std::string_view text) override;
    std::string text_;
};

/// A file descriptor: standard output, or a file that appears under its name only when it is complete.
class FileSink final : public OutputSink {
public:
    /// Writes to an open descriptor, which stays open. `name` is for messages.
    FileSink(int descriptor, std::string name);
    /// Writes beside `path` and takes its place in finish(), with the permissions of the file that it
    /// replaces; without finish() nothing remains. A symbolic link is followed. Something that is not a
    /// regular file (a pipe, a terminal, /dev/null) is written directly.
    static Result<std::unique_ptr<FileSink>> replace(const std::string& path);
    ~FileSink() override;

    Result<void> finish() override;

private:
    std::optional<Error> put(std::string_view text) override;
    Error system_error(int code) const;

    int descriptor_ = -1;
    bool owned_ = false;
    std::string name_;      ///< as the user gave it
    std::string target_;    ///< links resolved; empty when written directly
    std::string temporary_; ///< beside the target; empty when written directly
};

} // namespace drawbead
