#pragma once
// Which segment the solver takes, and where on it: not always the closest one. Every rule and tie here is as
// observed on solver runs (same segment in each of more than 100 000 rows), sums in the solver's order.
#include "contact/segment_mesh.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace drawbead {

/// What the solver remembers of a bead node from cycle to cycle. Local numbers of a NearMesh.
struct Track {
    uint32_t nearest = 0; ///< main node
    uint32_t segment = 0;
};

/// The solver's projection on one segment.
struct SolverHit {
    uint32_t segment = 0;      ///< local number
    double xi = 0, eta = 0;    ///< clamped to [-1, 1] when inside
    bool at_rim = false;       ///< segments around the track's node are missing: the NearMesh is too small
    bool inside = false;       ///< |xi| and |eta| <= 1.05 before clamping: `xface`
    std::array<double, 4> h{}; ///< bilinear weights
    Vec3 normal;               ///< unit vector of the segment's area vector
    double d = 0;              ///< n . (x - sum h X), signed
};

/// The Starter's box search for the start node of each bead node of one interface. The boxes depend on all
/// main nodes and all bead nodes of that interface. Needs the NearMesh to cover what it scans.
class StartSearch {
public:
    /// `bead`: start positions of all the interface's bead nodes.
    StartSearch(const NearMesh&, std::span<const Vec3> bead);

    /// Local main node, after the refinement pass; empty when the NearMesh does not cover the scan.
    std::optional<uint32_t> start_node(Vec3 bead) const;

private:
    using Cell = std::array<uint32_t, 3>;
    const NearMesh& mesh_;
    Vec3 min_;
    std::array<double, 3> extent_{};
    Cell count_{1, 1, 1};
    std::vector<uint64_t> occupied_; ///< one bit per cell with local nodes in it
    std::vector<uint32_t> rank_;     ///< occupied cells before each word of the bits
    std::vector<uint32_t> begin_;    ///< by rank of the occupied cell: into `node_`
    std::vector<uint32_t> node_;     ///< local nodes, ascending in each cell

    Cell first_{}, last_{};    ///< range of the occupied cells
    Vec3 part_min_, part_max_; ///< nodes outside this box around the bead are left out

    Cell cell_of(Vec3) const;
    bool covers(Vec3 lo, Vec3 hi) const;
    bool covers(const Cell& lo, const Cell& hi) const;
    template <class Visit>
    void each_node(Cell lo, Cell hi, Vec3 from, const double& squared_bound, Visit&&) const;
};

/// Start node and start segment of one bead node; empty as in StartSearch.
std::optional<Track> solver_start(const StartSearch&, const NearMesh&, Vec3 bead);

/// One cycle: node, kept or new segment, projection. `x`: positions of the local nodes now.
SolverHit solver_step(Track&, const NearMesh&, std::span<const Vec3> x, Vec3 bead);

/// The part of solver_step that changes the track. False: segments around the track's node are missing.
bool solver_follow(Track&, const NearMesh&, std::span<const Vec3> x, Vec3 bead);

/// The projection of one cycle on given corners (`triangle`: node 3 repeated). hit.segment is left alone.
SolverHit solver_project(const Corners&, bool triangle, Vec3 bead);

/// Warning 346 for a bead node on its start segment: the Starter sees it on the wrong side of the normal.
/// `ipri`: of /IOFLAG; from 1 on, nodes outside the segment are skipped.
bool warns_346(const Corners&, bool triangle, Vec3 bead, int ipri = 0);

/// delta = DEPTH - d + g inside, 0 outside; DEPTH <= 0: 1 everywhere.
double solver_penetration(const SolverHit&, double depth, double half_thickness);

/// T = n x l, L^2 = max(T . T, 1e-20), L.
struct SolverTributary {
    Vec3 t;
    double l2 = 0, l = 0;
};
SolverTributary solver_tributary(Vec3 normal, Vec3 half_chord);

} // namespace drawbead
