#pragma once
// A main surface of a model as the mathematics of contact takes it: its segments, and the stiffness of the
// elements behind them.
#include "contact/blank_stiffness.h"
#include "contact/segment_mesh.h"
#include "model/model.h"

#include <cstdint>
#include <string>
#include <vector>

namespace drawbead {

/// The segments in the order of Surface::segments; solid-backed ones look outward. Model and surface must
/// outlive it.
SegmentMesh segment_mesh(const Model&, const Surface&);

/// k and half thickness of the segments of one surface, as observed on solver runs: the thickness of the
/// property and the modulus of the material; a shell on a solid's face gives both, but the minimum over the
/// surface sees the solid too. Parts are looked at once, segments only when asked for.
class SurfaceStiffness {
public:
    /// Model and surface must outlive it.
    SurfaceStiffness(const Model&, const Surface&, unsigned threads);

    /// Of a segment by its index in Surface::segments.
    SegmentStiffness operator()(uint32_t segment) const;

    /// Smallest k over the surface; infinity when no segment has an element of known stiffness.
    double smallest() const { return smallest_; }

    /// k of the first `count` segments in the solver's storage order, or of all when there are fewer.
    std::vector<double> in_storage_order(std::size_t count) const;

    /// Parts whose stiffness is not what the solver takes, and why; their segments count as if no element
    /// were behind them, unless the text says otherwise.
    const std::vector<std::string>& doubts() const { return doubts_; }

private:
    /// What the elements of one range of a table have in common.
    struct Range {
        double modulus = 0; ///< Young's for shells, bulk for solids
        double thickness = 0;
        bool element_thickness = false; ///< the thickness on the element's card goes before the property's
        bool known = false;
        std::string doubt;
    };
    static std::vector<Range> ranges_of(const Model&, const std::vector<ElementRange>&, bool solids);
    SegmentStiffness of_shell_row(const ShellTable&, const std::vector<Range>&, uint32_t row) const;
    SegmentStiffness of_face(const Segment&, uint32_t solid) const;
    bool same_everywhere() const;
    void look_at_all(unsigned threads);

    const Model& model_;
    const Surface& surface_;
    std::vector<Range> shells4_, shells3_, solids_; ///< as the tables' ranges
    bool same_ = false;                             ///< every segment has the same k
    double smallest_ = std::numeric_limits<double>::infinity();
    std::vector<std::string> doubts_;
};

} // namespace drawbead
