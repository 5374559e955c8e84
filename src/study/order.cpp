#include "study/order.h"

#include <algorithm>
#include <cmath>

namespace drawbead {

namespace {

constexpr double slack = 0.1;
constexpr std::size_t fitted = 3;

OrderVerdict verdict_of(double order, double expected) {
    return order >= expected - slack ? OrderVerdict::as_expected : OrderVerdict::below;
}

} // namespace

std::string_view name(OrderVerdict v) {
    switch (v) {
    case OrderVerdict::as_expected:
        return "as expected";
    case OrderVerdict::below:
        return "below the expected";
    case OrderVerdict::exact:
        return "exact";
    case OrderVerdict::unresolved:
        break;
    }
    return "not resolved";
}

ObservedOrder observed_order(std::span<const double> size, std::span<const double> error, double expected,
                             OrderRange range) {
    ObservedOrder out;
    if (!error.empty() && *std::max_element(error.begin(), error.end()) <= range.floor) {
        out.verdict = OrderVerdict::exact;
        return out;
    }
    std::size_t end = error.size();
    while (end > 0 && !(error[end - 1] > range.floor))
        --end;
    if (end < fitted) return out;
    const std::size_t begin = end - fitted;
    double x_mean = 0, y_mean = 0;
    for (std::size_t i = begin; i < end; ++i) {
        if (!(error[i] > range.floor) || !(error[i] <= range.most)) return out;
        x_mean += std::log(size[i]) / fitted;
        y_mean += std::log(error[i]) / fitted;
    }
    double xy = 0, xx = 0;
    for (std::size_t i = begin; i < end; ++i) {
        const double x = std::log(size[i]) - x_mean;
        xy += x * (std::log(error[i]) - y_mean);
        xx += x * x;
    }
    out.order = xy / xx;
    out.first = begin;
    out.count = fitted;
    out.verdict = verdict_of(*out.order, expected);
    return out;
}

ObservedOrder order_of_differences(std::span<const double> value, double expected, double scale,
                                   double floor) {
    ObservedOrder out;
    if (value.size() < fitted) return out;
    const std::size_t n = value.size();
    const double coarse = std::abs(value[n - 3] - value[n - 2]), fine = std::abs(value[n - 2] - value[n - 1]);
    if (!(std::max(coarse, fine) > floor * scale)) {
        out.verdict = OrderVerdict::exact;
        return out;
    }
    if (!(fine > floor * scale) || !(fine < coarse)) return out;
    out.order = std::log2(coarse / fine);
    out.first = n - fitted;
    out.count = fitted;
    out.verdict = verdict_of(*out.order, expected);
    return out;
}

} // namespace drawbead
