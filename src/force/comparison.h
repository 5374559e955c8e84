#pragma once
// Recorded values beside recomputed ones: how far apart, where, and whether that is more than rounding.
#include "force/audit.h"

#include <cstdint>
#include <string>
#include <vector>

namespace drawbead {

/// When a difference counts.
enum class Agreement : uint8_t {
    law,     ///< recomputed: within the tolerance of the scale, and within a change of the ninth digit
    same,    ///< the same number recorded twice: within a change of the ninth digit
    pattern, ///< a relation that a run need not follow: one or two breaks of it count, more make it void
};

/// All compared values of one quantity.
class Comparison {
public:
    Comparison(std::string name, Agreement agreement, bool is_force = false)
        : name_(std::move(name)), agreement_(agreement), is_force_(is_force) {}

    /// Values no more than `rounding` apart count as equal: of sums whose order is not known.
    void add(double recorded, double recomputed, const TraceRow& row, double rounding = 0);
    /// Three columns from `first` on.
    void add(const TraceRow& row, TraceColumn first, const Vec3& recomputed);

    bool is_force() const { return is_force_; }
    bool used() const { return values_ > 0; }
    double scale() const { return scale_; } ///< largest recorded magnitude

    AuditQuantity result(double scale, double tolerance, const std::vector<AuditInterface>&) const;

private:
    struct Difference {
        double recorded, recomputed;
        const TraceRow* row;
    };
    std::string name_;
    Agreement agreement_;
    bool is_force_;
    double scale_ = 0;
    uint64_t values_ = 0;
    std::vector<Difference> differences_;

    bool lone_breaks() const;
};

} // namespace drawbead
