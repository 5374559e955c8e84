#include "model/line_kernels.h"

#include <cmath>
#include <cstring>
#include <fast_float/fast_float.h>

namespace drawbead {

namespace {

/// Without blanks on both sides.
std::string_view without_blanks(std::string_view cell) {
    while (!cell.empty() && cell.front() == ' ')
        cell.remove_prefix(1);
    while (!cell.empty() && cell.back() == ' ')
        cell.remove_suffix(1);
    return cell;
}

bool plain_integer(std::string_view cell, uint32_t& value) {
    cell = without_blanks(cell);
    if (cell.size() > 10) return false;
    uint64_t sum = 0;
    for (char c : cell) {
        if (c < '0' || c > '9') return false;
        sum = 10 * sum + static_cast<uint64_t>(c - '0');
    }
    value = static_cast<uint32_t>(sum);
    return sum <= largest_id;
}

bool read_node_line(std::string_view line, CellWidths widths, NodeRows& rows) {
    uint32_t id = 0;
    const uint32_t i = widths.integer, r = widths.real;
    if (!plain_integer(columns(line, 0, i), id) || id == 0) return false;
    const int64_t global = id + rows.id_offset;
    if (global < 1 || global > largest_id) return false;
    Vec3 x;
    if (!plain_real(columns(line, i, r), x.x) || !plain_real(columns(line, i + r, r), x.y) ||
        !plain_real(columns(line, i + 2 * r, r), x.z))
        return false;
    if (!is_blank(columns(line, i + 3 * r, line.size()))) return false;
    rows.id[rows.count] = static_cast<uint32_t>(global);
    rows.x[rows.count] = {x.x * rows.factor, x.y * rows.factor, x.z * rows.factor};
    ++rows.count;
    return true;
}

bool read_id_line(std::string_view line, CellWidths widths, IdRows& rows) {
    uint32_t* values = rows.values + rows.count * rows.cells;
    for (uint32_t cell = 0; cell < rows.cells; ++cell)
        if (!plain_integer(columns(line, cell * widths.integer, widths.integer), values[cell])) return false;
    if (values[0] == 0) return false;
    std::string_view more = columns(line, widths.integer * rows.cells, line.size());
    if (is_blank(more)) more = {};
    if (more.find(',') != std::string_view::npos) return false;
    rows.more[rows.count] = more;
    ++rows.count;
    return true;
}

/// The line at `at`, its line end left out; `next` is the start of the following one.
std::string_view take_line(const char* at, const char* end, const char*& next) {
    const char* stop = line_end(at, end);
    next = stop < end ? stop + 1 : end;
    if (stop > at && stop[-1] == '\r') --stop;
    return {at, static_cast<std::size_t>(stop - at)};
}

/// `wide` takes as many lines as it can; the line that it does not take is tried by `single`, which may stop
/// the run.
template <class Rows, class Wide, class Single>
void read_lines(LineRange& range, Rows& rows, const Wide& wide, const Single& single) {
    while (range.at < range.end && rows.count < rows.capacity) {
        wide(range, rows);
        if (range.at == range.end || rows.count == rows.capacity) return;
        const char* next = nullptr;
        if (!single(take_line(range.at, range.end, next), rows)) return;
        range.at = next;
    }
}

} // namespace

Kernel best_kernel() {
    static const Kernel best = runs_here(Kernel::avx2) ? Kernel::avx2 : Kernel::portable;
    return best;
}

bool runs_here(Kernel kernel) {
    if (kernel == Kernel::portable) return true;
#if defined(__x86_64__)
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") &&
           __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("popcnt");
#else
    return false;
#endif
}

bool is_blank(std::string_view text) {
    for (char c : text)
        if (c != ' ' && c != '\t' && c != '\r' && c != '\x1a') return false;
    return true;
}

const char* line_end(const char* at, const char* end) {
    const void* found = std::memchr(at, '\n', static_cast<std::size_t>(end - at));
    return found ? static_cast<const char*>(found) : end;
}

uint64_t count_data_lines(std::string_view text) {
    uint64_t count = 0;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (at < end) {
        const char* const stop = line_end(at, end);
        count += !is_skipped({at, static_cast<std::size_t>(stop - at)});
        at = stop + 1;
    }
    return count;
}

bool plain_real(std::string_view cell, double& value) {
    cell = without_blanks(cell);
    if (cell.empty()) {
        value = 0;
        return true;
    }
    // Names of infinities and "nan" are not numbers of a deck.
    const char first = cell.front() == '-' && cell.size() > 1 ? cell[1] : cell.front();
    if (first != '.' && (first < '0' || first > '9')) return false;
    const auto [end, error] = fast_float::from_chars(cell.data(), cell.data() + cell.size(), value);
    return error == std::errc() && end == cell.data() + cell.size() && std::isfinite(value);
}

void read_node_lines(Kernel kernel, CellWidths widths, LineRange& range, NodeRows& rows) {
    const auto single = [widths](std::string_view line, NodeRows& to) {
        return read_node_line(line, widths, to);
    };
#if defined(__x86_64__)
    if (kernel == Kernel::avx2 && widths.integer == 10 && widths.real == 20) {
        read_lines(range, rows, read_node_lines_avx2, single);
        return;
    }
#endif
    static_cast<void>(kernel);
    read_lines(
        range, rows, [](LineRange&, NodeRows&) {}, single);
}

void read_id_lines(Kernel kernel, CellWidths widths, LineRange& range, IdRows& rows) {
    const auto single = [widths](std::string_view line, IdRows& to) {
        return read_id_line(line, widths, to);
    };
#if defined(__x86_64__)
    if (kernel == Kernel::avx2 && widths.integer == 10 && (rows.cells == 4 || rows.cells == 5)) {
        read_lines(range, rows, read_id_lines_avx2, single);
        return;
    }
#endif
    static_cast<void>(kernel);
    read_lines(
        range, rows, [](LineRange&, IdRows&) {}, single);
}

} // namespace drawbead
