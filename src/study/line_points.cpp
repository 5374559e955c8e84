#include "study/line_points.h"

namespace drawbead {

namespace {

constexpr int most_halvings = 6; // of half a hop, by the adaptive rule

} // namespace

std::vector<LinePoint> line_points(std::size_t count, const LineRule& line, const PartChanges& changes) {
    std::vector<LinePoint> out;
    // A single node has no line; its force is that of no length.
    if (line.kind == LineRule::Kind::nodes || count < 2) {
        for (uint32_t i = 0; i < count; ++i)
            out.push_back({i, i, 0, i, 0, true});
        return out;
    }
    const auto add = [&](uint32_t a, double from, double to) {
        const double at = 0.5 * (from + to);
        out.push_back({a, a + 1, at, at < 0.5 ? a : a + 1, to - from, true});
    };
    for (uint32_t a = 0; a + 1 < count; ++a) {
        if (line.kind == LineRule::Kind::points) {
            const double parts = line.points;
            for (uint32_t p = 0; p < line.points; ++p)
                add(a, p / parts, (p + 1) / parts);
            continue;
        }
        const auto halve = [&](const auto& self, double from, double to, int depth) -> void {
            if (depth < most_halvings && changes && changes(a, from, to)) {
                self(self, from, 0.5 * (from + to), depth + 1);
                self(self, 0.5 * (from + to), to, depth + 1);
            } else {
                add(a, from, to);
            }
        };
        halve(halve, 0, 0.5, 0);
        halve(halve, 0.5, 1, 0);
    }
    const auto last = static_cast<uint32_t>(count - 1);
    out.push_back({0, 1, 0, 0, 1, false});
    out.push_back({last - 1, last, 1, last, 1, false});
    return out;
}

} // namespace drawbead
