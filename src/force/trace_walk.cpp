#include "force/trace_walk.h"

#include <algorithm>
#include <map>

namespace drawbead {

using C = TraceColumn;

Vec3 vector_at(const TraceRow& row, TraceColumn first) {
    return {row[first], row[after(first, 1)], row[after(first, 2)]};
}

std::array<uint32_t, 4> segment_of(const TraceRow& row) {
    std::array<uint32_t, 4> nodes;
    for (std::size_t k = 0; k < 4; ++k)
        nodes[k] = static_cast<uint32_t>(row.integer(after(C::seg_n1, k)));
    return nodes;
}

/// Positions at the first recorded cycle. A coordinate has been summed in steps until then: nodes that began
/// at a recorded node's coordinate are where that one is, to the bit; the others are to rounding.
void RigidBlank::begin(const std::vector<Corner>& corners) {
    const Vec3 moved = corners.front().x - mesh_->x[corners.front().local];
    for (const auto axis : axes) {
        std::map<double, double> now;
        for (const Corner& c : corners)
            now.emplace(mesh_->x[c.local].*axis, c.x.*axis);
        for (std::size_t i = 0; i < x_.size(); ++i) {
            const double at = mesh_->x[i].*axis;
            const auto known = now.find(at);
            x_[i].*axis = known != now.end() ? known->second : at + moved.*axis;
        }
    }
}

bool RigidBlank::follow(std::span<const TraceRow> rows) {
    if (!moves_as_one()) return false;
    const auto fail = [&](std::string why) {
        unknown_ = std::move(why) + " from cycle " + std::to_string(rows.front().integer(C::ncycle)) + " on";
        return false;
    };
    std::vector<Corner> corners; // of the deck's nodes: those that adaptive meshing makes are not its own
    for (const TraceRow& row : rows) {
        const auto nodes = segment_of(row);
        for (std::size_t k = 0; k < 4; ++k) {
            const auto at = std::lower_bound(mesh_->node_id.begin(), mesh_->node_id.end(), nodes[k]);
            if (at == mesh_->node_id.end() || *at != nodes[k]) continue;
            corners.push_back({static_cast<std::size_t>(at - mesh_->node_id.begin()),
                               vector_at(row, after(C::x1, 3 * k)), vector_at(row, after(C::vx1, 3 * k))});
        }
    }
    if (corners.empty()) return fail("no node of the deck's blank is in the record");
    velocity_ = corners.front().v;
    for (const Corner& c : corners)
        if (c.v != velocity_) return fail("the blank does not move as one");

    const int64_t cycle = rows.front().integer(C::ncycle);
    if (cycle_ && cycle == *cycle_ + 1) { // as the solver adds it up
        const Vec3 step = rows.front()[C::dt1] * velocity_;
        for (Vec3& p : x_)
            p += step;
    } else {
        begin(corners);
    }
    cycle_ = cycle;
    moved_ = corners.front().x - mesh_->x[corners.front().local];
    double size = 0;
    for (const Vec3& p : {mesh_->surface_min, mesh_->surface_max})
        size = std::max(size, norm(p + moved_));
    for (const Corner& c : corners) {
        if (distance(c.x, x_[c.local]) > 1e-10 * size) return fail("the blank does not move as one");
        x_[c.local] = c.x;
    }
    return true;
}

} // namespace drawbead
