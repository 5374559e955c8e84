#include "deck/scan.h"

#include "base/parallel.h"
#include "deck/keyword_line.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

namespace drawbead {

namespace {

constexpr std::size_t chunk = 64;

/// Whether a line begins at `offset`; the one behind a byte order mark counts.
bool begins_line(std::string_view bytes, uint64_t offset) {
    return offset == 0 || bytes[offset - 1] == '\n' || (offset == 3 && byte_order_mark(bytes) == 3);
}

/// Whether the slash or '#' at `offset` opens a line that the deck reader must look at.
bool is_mark(std::string_view bytes, uint64_t offset) {
    if (bytes[offset] == '#') {
        if (!begins_line(bytes, offset)) return false;
        if (offset + 1 >= bytes.size()) return false;
        const char next = bytes[offset + 1];
        return next == 'i' || next == 'I' || next == 'e' || next == 'E' || next == '!';
    }
    // A keyword line, possibly indented: nothing but blanks before the slash.
    uint64_t at = offset;
    while (at > 0 && (bytes[at - 1] == ' ' || bytes[at - 1] == '\t'))
        --at;
    if (!begins_line(bytes, at)) return false;
    if (at == offset) return true;
    const char next = offset + 1 < bytes.size() ? bytes[offset + 1] : '\0';
    return (next >= 'A' && next <= 'Z') || next == '/';
}

/// Whether the '#' at `offset` opens a comment line that begins with a word and a colon.
bool is_remark(std::string_view bytes, uint64_t offset) {
    constexpr uint64_t longest_word = 32;
    if (bytes[offset] != '#' || (offset > 0 && bytes[offset - 1] != '\n')) return false;
    uint64_t at = offset + 1;
    while (at < bytes.size() && (bytes[at] == ' ' || bytes[at] == '\t'))
        ++at;
    const uint64_t word = at;
    while (at < bytes.size() && at - word < longest_word &&
           ((bytes[at] >= 'a' && bytes[at] <= 'z') || (bytes[at] >= 'A' && bytes[at] <= 'Z')))
        ++at;
    return at > word && at < bytes.size() && bytes[at] == ':';
}

struct Piece {
    std::vector<uint64_t> marks, remarks;
    uint64_t newlines = 0;
};

void note(std::string_view bytes, uint64_t offset, Piece& piece) {
    if (is_mark(bytes, offset))
        piece.marks.push_back(offset);
    else if (is_remark(bytes, offset))
        piece.remarks.push_back(offset);
}

/// Body of the scan, compiled for the base instruction set and for AVX2: the compiler turns the inner loop
/// into a few vector compares per chunk.
__attribute__((always_inline)) inline void scan_body(std::string_view bytes, uint64_t begin, uint64_t end,
                                                     Piece& piece) {
    uint64_t at = begin;
    const char* data = bytes.data();
    for (; at + chunk <= end; at += chunk) {
        unsigned char count = 0;
        unsigned char interesting = 0;
        for (std::size_t i = 0; i < chunk; ++i) {
            const char c = data[at + i];
            count = static_cast<unsigned char>(count + (c == '\n'));
            interesting = static_cast<unsigned char>(interesting | ((c == '/') | (c == '#')));
        }
        piece.newlines += count;
        if (!interesting) continue;
        for (std::size_t i = 0; i < chunk; ++i)
            if (data[at + i] == '/' || data[at + i] == '#') note(bytes, at + i, piece);
    }
    for (; at < end; ++at) {
        piece.newlines += data[at] == '\n';
        if (data[at] == '/' || data[at] == '#') note(bytes, at, piece);
    }
}

void scan_base(std::string_view bytes, uint64_t begin, uint64_t end, Piece& piece) {
    scan_body(bytes, begin, end, piece);
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) void scan_avx2(std::string_view bytes, uint64_t begin, uint64_t end,
                                               Piece& piece) {
    scan_body(bytes, begin, end, piece);
}
#endif

using ScanFunction = void (*)(std::string_view, uint64_t, uint64_t, Piece&);

ScanFunction pick_scan() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2")) return scan_avx2;
#endif
    return scan_base;
}

} // namespace

LineScan scan_lines(std::string_view bytes, unsigned threads) {
    const std::size_t count = (bytes.size() + LineScan::stride - 1) / LineScan::stride;
    std::vector<Piece> pieces(count);
    const ScanFunction scan = pick_scan();
    parallel_for(threads, count, [&](std::size_t k) {
        const uint64_t begin = k * LineScan::stride;
        scan(bytes, begin, std::min<uint64_t>(begin + LineScan::stride, bytes.size()), pieces[k]);
    });
    LineScan result;
    result.newlines.reserve(count + 1);
    result.newlines.push_back(0);
    for (const Piece& piece : pieces) {
        result.newlines.push_back(result.newlines.back() + piece.newlines);
        result.marks.insert(result.marks.end(), piece.marks.begin(), piece.marks.end());
        result.remarks.insert(result.remarks.end(), piece.remarks.begin(), piece.remarks.end());
    }
    return result;
}

uint64_t count_newlines(std::string_view bytes) {
    // A byte holds the count of a chunk, so that the compiler adds up sixteen of them at a time.
    uint64_t newlines = 0;
    std::size_t at = 0;
    for (; at + chunk <= bytes.size(); at += chunk) {
        unsigned char count = 0;
        for (std::size_t i = 0; i < chunk; ++i)
            count = static_cast<unsigned char>(count + (bytes[at + i] == '\n'));
        newlines += count;
    }
    for (; at < bytes.size(); ++at)
        newlines += bytes[at] == '\n';
    return newlines;
}

} // namespace drawbead
