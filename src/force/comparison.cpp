#include "force/comparison.h"

#include <algorithm>
#include <cmath>

namespace drawbead {

namespace {

/// Nine significant digits are what a reader of a trace relies on: a change in the ninth moves a value by at
/// least 1e-9 of itself.
constexpr double digit_tolerance = 3e-10;
/// Values below this share of their scale may be nothing but rounding.
constexpr double noise = 64 * 2.220446049250313e-16;

} // namespace

void Comparison::add(double recorded, double recomputed, const TraceRow& row, double rounding) {
    scale_ = std::max(scale_, std::abs(recorded));
    ++values_;
    const bool equal = recorded == recomputed || std::abs(recorded - recomputed) <= rounding;
    if (!equal) differences_.push_back({recorded, recomputed, &row});
}

void Comparison::add(const TraceRow& row, TraceColumn first, const Vec3& recomputed) {
    add(row[first], recomputed.x, row);
    add(row[after(first, 1)], recomputed.y, row);
    add(row[after(first, 2)], recomputed.z, row);
}

/// What one damaged value breaks, among so many values, is no property of the run.
bool Comparison::lone_breaks() const {
    constexpr uint64_t most = 2, share = 8;
    const uint64_t breaks = differences_.size();
    return breaks > 0 && breaks <= most && breaks * share <= values_;
}

AuditQuantity Comparison::result(double scale, double tolerance,
                                 const std::vector<AuditInterface>& interfaces) const {
    AuditQuantity out;
    out.name = name_;
    out.scale = scale;
    out.values = values_;
    out.exact = values_ - differences_.size();
    const double divisor = scale > 0 ? scale : 1;
    // Where nearly every value is reproduced to the last bit, a lone deviating one is not rounding.
    const bool bitwise = differences_.size() == 1 || differences_.size() * 100 < values_;
    const double digits = std::max(digit_tolerance, tolerance);
    const auto is_bad = [&](const Difference& d, double deviation, double relative, bool counts) {
        if (!std::isfinite(d.recomputed)) return true;
        switch (agreement_) {
        case Agreement::law:
            return deviation > tolerance || (counts && relative > digits);
        case Agreement::same:
            return relative > digits;
        case Agreement::pattern:
            break;
        }
        return lone_breaks();
    };
    double worst = -1;
    for (const Difference& d : differences_) {
        const double difference = std::abs(d.recorded - d.recomputed);
        const double deviation = difference / divisor;
        const double relative = difference / std::max(std::abs(d.recorded), std::abs(d.recomputed));
        const bool counts = bitwise || std::abs(d.recorded) > noise * divisor;
        const bool bad = is_bad(d, deviation, relative, counts);
        if (agreement_ == Agreement::pattern && !bad) continue; // void
        out.deviation = std::max(out.deviation, deviation);
        if (bad) out.within = false;
        const double rank = (bad ? 1e3 : 0) + deviation + (counts ? relative : 0);
        if (rank <= worst) continue;
        worst = rank;
        out.line = d.row->line;
        out.cycle = d.row->integer(TraceColumn::ncycle);
        out.interface_id = interfaces[static_cast<std::size_t>(d.row->integer(TraceColumn::nin) - 1)].id;
        out.node = d.row->integer(TraceColumn::node);
        out.recorded = d.recorded;
        out.recomputed = d.recomputed;
    }
    out.applies = agreement_ != Agreement::pattern || differences_.empty() || lone_breaks();
    return out;
}

} // namespace drawbead
