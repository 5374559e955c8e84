#pragma once
// A trace cycle by cycle, and the motion of a blank that moves as one.
#include "contact/segment_mesh.h"
#include "force/trace.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace drawbead {

/// Calls visit(rows) for the rows of each cycle and interface, in order.
template <class Visit>
void each_bead_cycle(const Trace& trace, Visit&& visit) {
    const std::vector<TraceRow>& rows = trace.rows;
    for (std::size_t begin = 0, end = 0; begin < rows.size(); begin = end) {
        while (end < rows.size() && rows[end][TraceColumn::ncycle] == rows[begin][TraceColumn::ncycle] &&
               rows[end][TraceColumn::nin] == rows[begin][TraceColumn::nin])
            ++end;
        visit(std::span(rows).subspan(begin, end - begin));
    }
}

/// Three columns of a row, from `first` on.
Vec3 vector_at(const TraceRow& row, TraceColumn first);

/// x, y or z by number.
inline constexpr std::array<double Vec3::*, 3> axes{&Vec3::x, &Vec3::y, &Vec3::z};

/// User ids of a row's segment.
std::array<uint32_t, 4> segment_of(const TraceRow&);

/// Positions of all nodes of a surface, as one bead's rows tell them when the blank translates as one: summed
/// cycle by cycle as the solver does, so that ties of the search are the solver's.
class RigidBlank {
public:
    explicit RigidBlank(const NearMesh& mesh) : mesh_(&mesh), x_(mesh.x) {}

    /// Moves on to the cycle of these rows. False, for good, when the blank does not move as one.
    bool follow(std::span<const TraceRow> rows);

    bool moves_as_one() const { return unknown_.empty(); }
    const std::string& why_not() const { return unknown_; }
    const std::vector<Vec3>& x() const { return x_; }
    Vec3 moved() const { return moved_; } ///< since the deck
    Vec3 velocity() const { return velocity_; }

private:
    const NearMesh* mesh_;
    std::vector<Vec3> x_;
    Vec3 moved_, velocity_;
    std::optional<int64_t> cycle_;
    std::string unknown_;

    struct Corner {
        std::size_t local;
        Vec3 x, v;
    };
    void begin(const std::vector<Corner>&);
};

} // namespace drawbead
