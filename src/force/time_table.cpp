#include "force/time_table.h"

#include <algorithm>
#include <cassert>

namespace drawbead {

TimeTable::TimeTable(std::vector<double> t, std::vector<double> y) : t_(std::move(t)), y_(std::move(y)) {
    assert(!t_.empty() && t_.size() == y_.size());
    area_.assign(t_.size(), 0.0);
    for (std::size_t i = 1; i < t_.size(); ++i)
        area_[i] = area_[i - 1] + 0.5 * (y_[i - 1] + y_[i]) * (t_[i] - t_[i - 1]);
}

std::size_t TimeTable::piece(double t) const {
    if (t_.size() < 3) return 0;
    const auto inner = std::upper_bound(t_.begin() + 1, t_.end() - 1, t);
    return static_cast<std::size_t>(inner - t_.begin()) - 1;
}

double TimeTable::slope(double t) const {
    if (t_.size() < 2) return 0;
    const std::size_t i = piece(t);
    return (y_[i + 1] - y_[i]) / (t_[i + 1] - t_[i]);
}

double TimeTable::value(double t) const {
    if (t_.size() < 2) return y_.front();
    const std::size_t i = piece(t);
    return y_[i] + (y_[i + 1] - y_[i]) / (t_[i + 1] - t_[i]) * (t - t_[i]);
}

double TimeTable::antiderivative(double t) const {
    const std::size_t i = piece(t);
    return area_[i] + 0.5 * (y_[i] + value(t)) * (t - t_[i]);
}

double TimeTable::integral(double a, double b) const {
    return antiderivative(b) - antiderivative(a);
}

std::vector<double> TimeTable::corners(double a, double b) const {
    std::vector<double> out;
    const auto add = [&](double t) {
        if (t > a && t < b) out.push_back(t);
    };
    for (std::size_t i = 0; i < t_.size(); ++i)
        add(t_[i]);
    for (std::size_t i = 0; i + 1 < t_.size(); ++i) {
        const double from = i == 0 ? a : t_[i], to = i + 2 == t_.size() ? b : t_[i + 1];
        const double rate = (y_[i + 1] - y_[i]) / (t_[i + 1] - t_[i]);
        if (rate == 0) continue;
        const double zero = t_[i] - y_[i] / rate;
        if (zero > from && zero < to) add(zero);
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

} // namespace drawbead
