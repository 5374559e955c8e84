#pragma once
// Plain lines of node and element tables, read at memory speed. A kernel checks what it reads: it stops at
// the first line that is not plain (a comment, a blank line, a sign before an id, a tab, a parameter, a
// comma, text after the last cell …) and leaves that line to an exact reader. Within plain lines all kernels
// give the same bits.
#include "geometry/vec3.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace drawbead {

enum class Kernel : uint8_t { portable, avx2 };

/// The fastest kernel that this processor can run.
Kernel best_kernel();
bool runs_here(Kernel);

/// Widths of cells: 10 and 20 columns, or 8 and 16 in layouts 41 to 44.
struct CellWidths {
    uint32_t integer = 10, real = 20;
};

inline constexpr uint32_t largest_id = 0x7fffffff;

/// Lines to read: [at, end) inside the bytes of a file, which may all be touched. `at` is a line start and
/// moves on to the line where the kernel stopped, or to `end`; `end` is a line start or the end of the file.
struct LineRange {
    const char* at = nullptr;
    const char* end = nullptr;
    std::string_view file;
};

/// Where node lines go: written id + id_offset, coordinates times `factor`.
struct NodeRows {
    uint32_t* id = nullptr;
    Vec3* x = nullptr;
    std::size_t capacity = 0, count = 0;
    int64_t id_offset = 0;
    double factor = 1;
};

/// Reads id, x, y, z of consecutive plain lines. Stops also at an id that is not in 1 … largest_id with its
/// offset.
void read_node_lines(Kernel, CellWidths, LineRange&, NodeRows&);

/// Where lines of `cells` integers go, one after the other, as written; a blank cell is 0.
struct IdRows {
    uint32_t* values = nullptr;
    std::string_view* more = nullptr; ///< per line: the text after the last cell, empty when blank
    uint32_t cells = 0;
    std::size_t capacity = 0, count = 0; ///< in lines
};

/// Reads integers 0 … largest_id of consecutive plain lines, which may have text without a comma after the
/// last cell. Stops also at a line whose first cell is 0 or blank.
void read_id_lines(Kernel, CellWidths, LineRange&, IdRows&);

/// A real cell, blanks around it allowed, correctly rounded; a blank cell is 0. False when it is not plain.
bool plain_real(std::string_view cell, double& value);

/// The part of `line` in the columns [column, column + width), counted from 0; empty beyond the line's end.
inline std::string_view columns(std::string_view line, std::size_t column, std::size_t width) {
    return column < line.size() ? line.substr(column, width) : std::string_view{};
}
/// Blanks, tabs and carriage returns only.
bool is_blank(std::string_view text);
/// A line that the tables skip: a comment, or blank.
inline bool is_skipped(std::string_view line) {
    return line.empty() || line.front() == '#' || line.front() == '$' ||
           (line.front() <= ' ' && is_blank(line));
}
/// Number of data lines: neither comment nor blank.
uint64_t count_data_lines(std::string_view text);
/// The end of the line at `at`: its newline, or `end`.
const char* line_end(const char* at, const char* end);

#if defined(__x86_64__)
// line_kernels_avx2.cpp: plain lines of 10 and 20 columns; each reads lines until one does not suit it.
void read_node_lines_avx2(LineRange&, NodeRows&);
void read_id_lines_avx2(LineRange&, IdRows&);
#endif

} // namespace drawbead
