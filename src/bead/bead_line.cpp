#include "bead/bead_line.h"

namespace drawbead {

Vec3 half_chord(std::span<const Vec3> x, std::size_t i) {
    const Vec3 next = x[i + 1 < x.size() ? i + 1 : i], previous = x[i > 0 ? i - 1 : 0];
    return 0.5 * (next - previous);
}

BeadLine bead_line(std::span<const Vec3> x) {
    BeadLine line;
    line.s.reserve(x.size());
    line.half_chord.reserve(x.size());
    line.tributary.reserve(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (i > 0) {
            line.hop.push_back(distance(x[i - 1], x[i]));
            line.length += line.hop.back();
        }
        line.s.push_back(line.length);
        line.half_chord.push_back(half_chord(x, i));
        line.tributary.push_back(norm(line.half_chord.back()));
    }
    return line;
}

double arc_tributary(const BeadLine& line, std::size_t i) {
    double sum = 0;
    if (i > 0) sum += line.hop[i - 1];
    if (i < line.hop.size()) sum += line.hop[i];
    return 0.5 * sum;
}

double limit_along(double first, double last, double s, double s_total) {
    if (last == 0 || !(s_total > 0)) return first;
    return first + (s / s_total) * (last - first);
}

double normal_limit_along(double first, double last, double s, double s_total) {
    return first == 0 ? 0 : limit_along(first, last, s, s_total);
}

} // namespace drawbead
