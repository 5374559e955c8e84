#pragma once
// The recorded kinematics and forces of a solver run: one CSV row per cycle and active bead node.
#include "base/result.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace drawbead {

/// Columns that an audit needs, in the order of `trace_columns`.
enum class TraceColumn : uint8_t {
    ncycle,
    tt,
    dt1,
    nin,
    inod,
    node,
    seg_n1,
    seg_n2,
    seg_n3,
    seg_n4,
    xface,
    ssc,
    ttc,
    h1,
    h2,
    h3,
    h4,
    dist,
    gapn,
    pen,
    depth,
    segnx,
    segny,
    segnz,
    tgx,
    tgy,
    tgz,
    li2,
    trib,
    vv,
    stf,
    slopen_ig,
    slopen_seg,
    ftlim,
    fnlim,
    fni,
    fnni,
    fnx,
    fny,
    fnz,
    ftx,
    fty,
    ftz,
    fx,
    fy,
    fz,
    ftsavx,
    ftsavy,
    ftsavz,
    distlin,
    disttot,
    xi,
    yi,
    zi,
    x1,
    y1,
    z1,
    x2,
    y2,
    z2,
    x3,
    y3,
    z3,
    x4,
    y4,
    z4,
    vx1,
    vy1,
    vz1,
    vx2,
    vy2,
    vz2,
    vx3,
    vy3,
    vz3,
    vx4,
    vy4,
    vz4,
    m1,
    m2,
    m3,
    m4,
    count
};
inline constexpr std::size_t trace_column_count = static_cast<std::size_t>(TraceColumn::count);
std::string_view name(TraceColumn);

struct TraceRow {
    std::array<double, trace_column_count> value;
    uint64_t line = 0; ///< in the file, from 1

    double operator[](TraceColumn c) const { return value[static_cast<std::size_t>(c)]; }
    int64_t integer(TraceColumn c) const { return static_cast<int64_t>((*this)[c]); }
};

/// The column `k` places after `first`.
constexpr TraceColumn after(TraceColumn first, std::size_t k) {
    return static_cast<TraceColumn>(static_cast<std::size_t>(first) + k);
}

/// Rows in file order: cycles ascend without a gap, within a cycle interfaces ascend, within an interface
/// `inod` runs 1, 2, … n with the same n in every cycle.
struct Trace {
    std::string path;
    std::vector<TraceRow> rows;
};

/// Reads plain or gzip-compressed text. Columns may stand in any order; all missing ones are named. `seg` and
/// `dt12`, which a solver's record has too, are not needed but must be numbers; other columns are ignored.
/// Anything that is not a complete, finite, ordered trace is refused with its line and column.
Result<Trace> read_trace(const std::string& path);
/// As read_trace, for text in memory.
Result<Trace> parse_trace(std::string_view text, const std::string& path);

} // namespace drawbead
