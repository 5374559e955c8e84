#include "deck/source_file.h"

#include <algorithm>
#include <cstring>

namespace drawbead {

SourceFile::SourceFile(std::string path, FileBytes bytes, unsigned threads)
    : path_(std::move(path)), bytes_(std::move(bytes)), scan_(scan_lines(bytes_.view(), threads)) {}

uint64_t SourceFile::newlines_before(uint64_t offset) const {
    const uint64_t k = std::min(offset / LineScan::stride, uint64_t{scan_.newlines.size() - 1});
    return scan_.newlines[k] + count_newlines(text(k * LineScan::stride, offset));
}

uint64_t SourceFile::lines() const {
    const std::string_view all = bytes();
    return scan_.newlines.back() + (!all.empty() && all.back() != '\n');
}

uint64_t SourceFile::line_begin(uint64_t offset) const {
    if (offset == 0) return 0;
    const std::size_t newline = bytes().rfind('\n', offset - 1);
    return newline == std::string_view::npos ? 0 : newline + 1;
}

uint64_t SourceFile::next_line(uint64_t offset) const {
    const std::size_t newline = bytes().find('\n', offset);
    return newline == std::string_view::npos ? bytes().size() : newline + 1;
}

std::string_view SourceFile::line_at(uint64_t offset) const {
    const uint64_t begin = line_begin(offset);
    const std::size_t newline = bytes().find('\n', offset);
    uint64_t end = newline == std::string_view::npos ? bytes().size() : newline;
    if (end > begin && bytes()[end - 1] == '\r') --end;
    return text(begin, end);
}

SourceFile::Position SourceFile::at(uint64_t offset) const {
    return {newlines_before(offset) + 1, static_cast<uint32_t>(offset - line_begin(offset)) + 1};
}

} // namespace drawbead
