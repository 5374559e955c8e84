#include "contact/blank_stiffness.h"

#include <algorithm>

namespace drawbead {

double shell_stiffness(double young, double thickness) {
    return 0.2 * young * thickness;
}

double solid_face_stiffness(double face_area, double bulk, double volume) {
    return volume > 0 ? 0.2 * face_area * face_area * bulk / volume : 0;
}

SegmentStiffness of_shell(double young, double thickness) {
    const double k = shell_stiffness(young, thickness);
    return {k, 0.5 * thickness, k};
}

SegmentStiffness of_solid_face(double face_area, double bulk, double volume) {
    const double k = solid_face_stiffness(face_area, bulk, volume);
    return {k, 0, k};
}

SegmentStiffness coated(const SegmentStiffness& face, const SegmentStiffness& shell) {
    return {shell.k, shell.half_thickness, std::min(face.smallest, shell.smallest)};
}

double smallest_stiffness(std::span<const SegmentStiffness> segments) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const SegmentStiffness& s : segments)
        smallest = std::min(smallest, s.smallest);
    return smallest;
}

SlopeChoice choose_slope(double fn_first, double depth, double smallest_k) {
    if (fn_first == 0) return {Slope::none, 0};
    if (depth <= 1e-20) return {Slope::depth_absent, 0};
    const double ramp = fn_first / depth;
    return {ramp > smallest_k && smallest_k != 0 ? Slope::reset : Slope::ramp, ramp};
}

std::optional<double> slope_read(const SlopeChoice& slope, std::span<const double> k_in_storage_order,
                                 std::size_t segments, std::size_t bead_node) {
    if (bead_node >= segments) return {};
    if (slope.kind == Slope::none || slope.kind == Slope::ramp) return slope.of(0);
    if (bead_node >= k_in_storage_order.size()) return {};
    return k_in_storage_order[bead_node];
}

StarterVerdict starter_verdict(const StarterInput& in, std::vector<uint32_t> nodes_346) {
    const Slope slope = choose_slope(in.fn_first, in.depth, in.smallest_k).kind;
    StarterVerdict verdict;
    verdict.error_112 = !in.group_ordered;
    verdict.error_703 = in.iform == 1 && in.admesh_idt;
    verdict.warning_1040 = slope == Slope::reset;
    verdict.warning_1043 = slope == Slope::depth_absent;
    verdict.nodes_346 = std::move(nodes_346);
    return verdict;
}

} // namespace drawbead
