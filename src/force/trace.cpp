#include "force/trace.h"

#include <algorithm>
#include <cmath>
#include <fast_float/fast_float.h>
#include <map>
#include <sys/stat.h>
#include <utility>
#include <zlib.h>

namespace drawbead {

namespace {

constexpr std::array<std::string_view, trace_column_count> column_names{
    "ncycle",  "tt",        "dt1",        "nin",   "inod",  "node", "seg_n1", "seg_n2", "seg_n3", "seg_n4",
    "xface",   "ssc",       "ttc",        "h1",    "h2",    "h3",   "h4",     "dist",   "gapn",   "pen",
    "depth",   "segnx",     "segny",      "segnz", "tgx",   "tgy",  "tgz",    "li2",    "trib",   "vv",
    "stf",     "slopen_ig", "slopen_seg", "ftlim", "fnlim", "fni",  "fnni",   "fnx",    "fny",    "fnz",
    "ftx",     "fty",       "ftz",        "fx",    "fy",    "fz",   "ftsavx", "ftsavy", "ftsavz", "distlin",
    "disttot", "xi",        "yi",         "zi",    "x1",    "y1",   "z1",     "x2",     "y2",     "z2",
    "x3",      "y3",        "z3",         "x4",    "y4",    "z4",   "vx1",    "vy1",    "vz1",    "vx2",
    "vy2",     "vz2",       "vx3",        "vy3",   "vz3",   "vx4",  "vy4",    "vz4",    "m1",     "m2",
    "m3",      "m4"};

constexpr std::array<TraceColumn, 9> integer_columns{
    TraceColumn::ncycle, TraceColumn::nin,    TraceColumn::inod,   TraceColumn::node, TraceColumn::seg_n1,
    TraceColumn::seg_n2, TraceColumn::seg_n3, TraceColumn::seg_n4, TraceColumn::xface};

/// What else a solver's record has: must be numbers, but nothing is computed from them.
constexpr std::array<std::string_view, 2> other_columns{"dt12", "seg"};
constexpr std::size_t other_column = trace_column_count, ignored_column = trace_column_count + 1;

constexpr std::size_t most_bytes = std::size_t{4} << 30;

bool is_integer_column(std::size_t c) {
    return std::any_of(integer_columns.begin(), integer_columns.end(),
                       [&](TraceColumn i) { return static_cast<std::size_t>(i) == c; });
}

std::string_view strip(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t'))
        text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
        text.remove_suffix(1);
    return text;
}

/// A cell for a message.
std::string shown(std::string_view cell) {
    constexpr std::size_t most = 40;
    return std::string(cell.substr(0, most)) + (cell.size() > most ? "..." : "");
}

class TraceParser {
public:
    TraceParser(std::string_view text, const std::string& path) : text_(text), path_(path) {}

    Result<Trace> run() {
        Trace trace;
        trace.path = path_;
        std::string_view line;
        if (constexpr std::string_view mark = "\xEF\xBB\xBF"; text_.substr(0, mark.size()) == mark)
            text_.remove_prefix(mark.size()); // a byte order mark
        if (!next(line) || strip(line).empty())
            return fail(1, 0, "the trace is empty", "the first line must name the columns");
        if (auto head = header(line); !head) return head.error();
        while (next(line)) {
            if (strip(line).empty()) continue;
            TraceRow row;
            row.line = line_;
            if (at_ > text_.size() && !ends_in_full(line))
                return fail(line_, 0, "the last line has no end: the trace is cut", "take the whole file");
            if (auto cells = parse_row(line, row); !cells) return cells.error();
            trace.rows.push_back(row);
        }
        if (trace.rows.empty())
            return fail(line_, 0, "the trace has no rows", "was the time window ever open?");
        if (auto order = check_order(trace); !order) return order.error();
        return trace;
    }

private:
    Error fail(uint64_t line, uint32_t column, std::string message, std::string help) const {
        return Error{std::move(message), path_, line, column, std::move(help)};
    }

    bool next(std::string_view& line) {
        if (at_ >= text_.size()) return false;
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        line = text_.substr(at_, end - at_);
        at_ = end + 1;
        ++line_;
        return true;
    }

    /// Whether a line without an end can be whole all the same: its last value ends another line too.
    bool ends_in_full(std::string_view line) const {
        const std::size_t comma = line.rfind(',');
        return comma != std::string_view::npos &&
               text_.find(std::string(line.substr(comma)) + '\n') != std::string_view::npos;
    }

    Result<void> header(std::string_view line) {
        std::map<std::string_view, std::size_t> known;
        for (std::size_t c = 0; c < trace_column_count; ++c)
            known.emplace(column_names[c], c);
        std::array<bool, trace_column_count> found{};
        for (std::size_t begin = 0;;) {
            const std::size_t comma = std::min(line.find(',', begin), line.size());
            const std::string_view label = strip(line.substr(begin, comma - begin));
            const auto column = known.find(label);
            if (column == known.end()) {
                const bool other =
                    std::find(other_columns.begin(), other_columns.end(), label) != other_columns.end();
                target_.push_back(other ? other_column : ignored_column);
            } else {
                if (found[column->second])
                    return fail(1, static_cast<uint32_t>(begin + 1),
                                "column '" + std::string(column->first) + "' stands twice", "remove one");
                found[column->second] = true;
                target_.push_back(column->second);
            }
            names_.emplace_back(label);
            if (comma == line.size()) break;
            begin = comma + 1;
        }
        if (std::find(found.begin(), found.end(), true) == found.end())
            return fail(1, 0, "the first line names no column of a trace", "is this a trace?");
        std::string missing;
        for (std::size_t c = 0; c < trace_column_count; ++c)
            if (!found[c]) missing += (missing.empty() ? "" : ", ") + std::string(column_names[c]);
        if (!missing.empty())
            return fail(1, 0, "the trace lacks the columns " + missing,
                        "record them, or name them in the first line");
        return {};
    }

    Result<void> parse_row(std::string_view line, TraceRow& row) {
        std::size_t begin = 0;
        for (std::size_t field = 0; field < target_.size(); ++field) {
            if (begin > line.size())
                return fail(line_, 0,
                            "the row has " + std::to_string(field) + " of " + std::to_string(target_.size()) +
                                " values: the trace is cut or damaged",
                            "take the whole file");
            const std::size_t comma = std::min(line.find(',', begin), line.size());
            const std::string_view cell = strip(line.substr(begin, comma - begin));
            const auto column = static_cast<uint32_t>(begin + 1);
            begin = comma + 1;
            if (target_[field] == ignored_column) continue;
            double value = 0;
            const char* first = cell.data() + (!cell.empty() && cell[0] == '+');
            const auto read = fast_float::from_chars(first, cell.data() + cell.size(), value);
            const auto refuse = [&](const std::string& why, const char* help) {
                return fail(line_, column, names_[field] + " is '" + shown(cell) + "', " + why, help);
            };
            if (cell.empty() || read.ec != std::errc() || read.ptr != cell.data() + cell.size())
                return refuse("not a number", "repair the row");
            if (!std::isfinite(value))
                return refuse("which is not finite", "the run was no longer valid there");
            if (target_[field] == other_column) continue;
            if (is_integer_column(target_[field]) &&
                (value != std::floor(value) || std::abs(value) > 2147483647.0))
                return refuse("not an id or a count", "repair the row");
            constexpr double most_cycles = 1e8; // a run of so many would be a record of many gigabytes
            if (target_[field] == static_cast<std::size_t>(TraceColumn::ncycle) &&
                (value < 0 || value > most_cycles))
                return refuse("not a cycle from 0 to 100000000", "repair the row");
            row.value[target_[field]] = value;
        }
        if (begin <= line.size())
            return fail(line_, static_cast<uint32_t>(begin + 1),
                        "the row has more values than the first line has columns", "repair the row");
        return {};
    }

    /// Cycles ascend by one, interfaces ascend within a cycle, nodes count from 1 and are equally many in
    /// each cycle.
    Result<void> check_order(const Trace& trace) const {
        using C = TraceColumn;
        std::map<int64_t, int64_t> size_of; // interface -> bead nodes
        const std::vector<TraceRow>& rows = trace.rows;
        for (std::size_t i = 0; i < rows.size();) {
            const int64_t cycle = rows[i].integer(C::ncycle), nin = rows[i].integer(C::nin);
            std::size_t end = i;
            int64_t expected = 1;
            for (; end < rows.size() && rows[end].integer(C::ncycle) == cycle &&
                   rows[end].integer(C::nin) == nin;
                 ++end, ++expected) {
                if (rows[end].integer(C::inod) != expected)
                    return fail(rows[end].line, 0,
                                "cycle " + std::to_string(cycle) + " has node " +
                                    std::to_string(rows[end].integer(C::inod)) + " where node " +
                                    std::to_string(expected) + " is due",
                                "rows are missing or swapped");
                if (rows[end][C::tt] != rows[i][C::tt] || rows[end][C::dt1] != rows[i][C::dt1])
                    return fail(rows[end].line, 0,
                                "time or time step changes within cycle " + std::to_string(cycle),
                                "rows are damaged or swapped");
            }
            const int64_t nodes = expected - 1;
            const auto [known, first] = size_of.emplace(nin, nodes);
            if (!first && known->second != nodes)
                return fail(rows[end - 1].line, 0,
                            "cycle " + std::to_string(cycle) + " of interface number " + std::to_string(nin) +
                                " has " + std::to_string(nodes) + " nodes, earlier cycles " +
                                std::to_string(known->second),
                            "rows are missing");
            if (end < rows.size()) {
                const int64_t next_cycle = rows[end].integer(C::ncycle), next_nin = rows[end].integer(C::nin);
                const bool same = next_cycle == cycle;
                if (next_cycle < cycle || (same && next_nin <= nin))
                    return fail(rows[end].line, 0,
                                "rows are out of order: cycle " + std::to_string(next_cycle) +
                                    " comes after cycle " + std::to_string(cycle),
                                "sort them by cycle, interface and node");
                if (!same && next_cycle != cycle + 1 && size_of.size() == 1)
                    return fail(rows[end].line, 0,
                                "cycles " + std::to_string(cycle + 1) + " to " +
                                    std::to_string(next_cycle - 1) + " are missing",
                                "the stored force of incremental restraint needs every cycle");
                if (!same && rows[end][C::tt] < rows[i][C::tt])
                    return fail(rows[end].line, 0, "time runs backwards", "rows are damaged or swapped");
            }
            i = end;
        }
        return {};
    }

    std::string_view text_;
    const std::string& path_;
    std::size_t at_ = 0;
    uint64_t line_ = 0;
    std::vector<std::size_t>
        target_; ///< per column of the file: which of ours, other_column or ignored_column
    std::vector<std::string> names_; ///< per column of the file
};

} // namespace

std::string_view name(TraceColumn column) {
    return column_names[static_cast<std::size_t>(column)];
}

Result<Trace> parse_trace(std::string_view text, const std::string& path) {
    return TraceParser(text, path).run();
}

Result<Trace> read_trace(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0)
        return Error{"cannot read the trace: no such file", path, 0, 0, ""};
    if (S_ISDIR(status.st_mode)) return Error{"cannot read the trace: it is a folder", path, 0, 0, ""};
    gzFile file = gzopen(path.c_str(), "rb");
    if (!file) return Error{"cannot open the trace", path, 0, 0, "is it readable?"};
    gzbuffer(file, 1u << 18);
    std::string text;
    std::string failure;
    for (;;) {
        const std::size_t used = text.size();
        constexpr std::size_t portion = std::size_t{1} << 22;
        text.resize(used + portion);
        const int got = gzread(file, text.data() + used, portion);
        text.resize(used + static_cast<std::size_t>(std::max(got, 0)));
        if (got < 0) {
            int code = 0;
            failure = gzerror(file, &code);
        }
        if (text.size() > most_bytes) failure = "larger than 4 GB";
        if (got <= 0 || !failure.empty()) break;
    }
    const int closed = gzclose(file);
    if (failure.empty() && closed == Z_BUF_ERROR) failure = "the compressed file is cut";
    if (!failure.empty())
        return Error{"cannot read the trace: " + failure, path, 0, 0, "take the whole file"};
    return parse_trace(text, path);
}

} // namespace drawbead
