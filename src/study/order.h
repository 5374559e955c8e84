#pragma once
// Observed orders of convergence.
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace drawbead {

enum class OrderVerdict : uint8_t {
    as_expected, ///< no less than expected, to 0.1
    below,       ///< by more than 0.1
    exact,       ///< no error above the round-off floor
    unresolved,  ///< fewer than three levels in the range where an order can be seen
};
std::string_view name(OrderVerdict);

struct ObservedOrder {
    OrderVerdict verdict = OrderVerdict::unresolved;
    std::optional<double> order;
    std::size_t first = 0, count = 0; ///< the levels that were fitted
};

/// Errors below `floor` are rounding, those above `most` no longer follow the leading term.
struct OrderRange {
    double floor = 1e-12, most = 0.1;
};

/// Slope of log(error) over log(size) by least squares, over the three finest levels in the range. `size`:
/// of a step or a part, descending, one per error.
ObservedOrder observed_order(std::span<const double> size, std::span<const double> error, double expected,
                             OrderRange range = {});

/// The order without a reference: from the differences of values at sizes that halve, the finest three.
ObservedOrder order_of_differences(std::span<const double> value, double expected, double scale,
                                   double floor = 1e-10);

} // namespace drawbead
