#pragma once
// What the Starter fixes before the first cycle: stiffness k and half thickness g per segment, the slope of
// the normal force, and what it says about an interface. As observed on solver runs.
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace drawbead {

/// Of one segment. A segment without an element has k = 0 and takes no part in the minimum.
struct SegmentStiffness {
    double k = 0;              ///< force per length
    double half_thickness = 0; ///< g; 0 for solid faces
    double smallest =
        std::numeric_limits<double>::infinity(); ///< of all k that entered the minimum for this segment
};

/// 0.2 E t.
double shell_stiffness(double young, double thickness);
/// 0.2 A^2 K / V with A = half the cross product of the face's diagonals, V the one-point volume; 0 without
/// volume.
double solid_face_stiffness(double face_area, double bulk, double volume);

SegmentStiffness of_shell(double young, double thickness);
SegmentStiffness of_solid_face(double face_area, double bulk, double volume);
/// A solid's face that a shell contains too: the shell's k and g, both in the minimum.
SegmentStiffness coated(const SegmentStiffness& face, const SegmentStiffness& shell);

/// Smallest k over the surface; infinity when no segment has an element.
double smallest_stiffness(std::span<const SegmentStiffness>);

enum class Slope : uint8_t {
    none,         ///< Fn_first = 0
    ramp,         ///< Fn_first / DEPTH everywhere
    reset,        ///< warning 1040: every segment its own k
    depth_absent, ///< DEPTH <= 1e-20: every segment its own k, warning 1043
};

struct SlopeChoice {
    Slope kind = Slope::none;
    double ramp = 0; ///< Fn_first / DEPTH, where that is asked; force / length^2

    /// The slope of a segment with stiffness k.
    double of(double k) const { return kind == Slope::none ? 0 : kind == Slope::ramp ? ramp : k; }
};

SlopeChoice choose_slope(double fn_first, double depth, double smallest_k);

/// The slope a bead node really reads: the solver indexes the segments' table with the node's place in the
/// list. `k_in_storage_order` needs as many entries as there are bead nodes, or all `segments`. Empty past
/// the end.
std::optional<double> slope_read(const SlopeChoice&, std::span<const double> k_in_storage_order,
                                 std::size_t segments, std::size_t bead_node);

struct StarterInput {
    bool group_ordered = true; ///< NODENS or what counts as it
    int iform = 2;
    bool admesh_idt = false; ///< /ADMESH/GLOBAL with Idt = 1
    double fn_first = 0, depth = 0, smallest_k = 0;
};

/// What the Starter will say about one interface.
struct StarterVerdict {
    bool error_112 = false, error_703 = false, warning_1040 = false, warning_1043 = false;
    std::vector<uint32_t> nodes_346; ///< places in the bead's list, ascending; any: one warning 499 too

    bool stops() const { return error_112 || error_703; }
    bool clean() const { return !stops() && !warning_1040 && !warning_1043 && nodes_346.empty(); }
};

StarterVerdict starter_verdict(const StarterInput&, std::vector<uint32_t> nodes_346);

} // namespace drawbead
