#pragma once
// Recomputes a solver run from its recorded kinematics, and says how far the record and the law are apart.
#include "base/result.h"
#include "contact/blank_stiffness.h"
#include "contact/segment_mesh.h"
#include "force/energy_book.h"
#include "force/node_force.h"
#include "force/trace.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace drawbead {

/// What the deck says of one main surface.
struct AuditSurface {
    NearMesh mesh;                                        ///< the whole surface as the deck places it
    std::vector<std::optional<SegmentStiffness>> segment; ///< by local segment; empty: not decidable
    std::vector<double> mass;      ///< by local node: of the shells and solids around it; 0: not decidable
    std::vector<double> thickness; ///< by local segment: on the element's card, else the property's; 0: solid
};

/// What the deck says of one interface, in work units.
struct AuditInterface {
    int64_t id = 0;
    int64_t rank = 0; ///< among all interfaces of the deck, of any type, from 1
    int iform = 2;
    BeadLaw<double> law;
    double t_start = 0, t_stop = 1e30;
    std::vector<int64_t> nodes; ///< user ids in list order
    std::vector<Vec3> start;    ///< their positions in the deck
    std::size_t surface = 0;    ///< index into AuditDeck::surfaces
};

struct AuditDeck {
    std::vector<AuditSurface> surfaces;
    std::vector<AuditInterface> interfaces; ///< input order
    bool adaptive = false;                  ///< /ADMESH: the run makes nodes and segments of its own
};

/// The largest deviation of one quantity.
struct AuditQuantity {
    std::string name;
    double scale = 0;               ///< largest magnitude in the trace: what deviations are divided by
    double deviation = 0;           ///< largest |recorded − recomputed| / scale
    uint64_t values = 0, exact = 0; ///< compared; equal to the last bit
    uint64_t line = 0;              ///< of the largest deviation in the trace; 0: all are equal
    int64_t cycle = 0, interface_id = 0, node = 0;
    double recorded = 0, recomputed = 0;
    bool within = true;
    bool applies = true; ///< false: a relation between rows that this run does not follow
};

/// The solver's choice of segment, replayed.
struct AuditSearch {
    uint64_t rows = 0, same = 0;
    std::string unchecked; ///< why not all rows were looked at; empty: all were
    uint64_t line = 0;     ///< of the first other segment
    int64_t cycle = 0, interface_id = 0, node = 0;
    std::array<int64_t, 4> recorded{}, replayed{};
};

struct AuditResult {
    std::vector<AuditQuantity> quantities;
    AuditSearch search;
    std::vector<BeadEnergy> energies; ///< over the record, in work units; as AuditDeck::interfaces
    uint64_t rows = 0, cycles = 0;
    double force_scale = 0;
    bool within = true;
    std::vector<std::string> notes;
};

struct AuditOptions {
    double tolerance = 1e-12; ///< of each quantity's scale; forces share one scale
};

/// Rewrites `nin`, the rank of an interface in the deck, to its rank among the drawbeads, from 1. Traces of
/// decks that hold nothing but drawbeads, and those that count so, stay as they are.
void number_by_drawbead(Trace&, const AuditDeck&);

/// The trace is numbered by drawbead. An error when the trace does not belong to the deck (unknown interface,
/// other bead nodes, segments that the surface does not have) or does not start where the time window opens.
Result<AuditResult> audit(const Trace&, const AuditDeck&, const AuditOptions&);

/// How far one bead's run was from the manual's law.
struct ManualDistance {
    int64_t interface_id = 0;
    struct Total {
        double largest_solver = 0, largest_manual = 0; ///< norms of the total over time: force
        double largest = 0, mean = 0;                  ///< norm of the difference of the totals: force
        uint64_t line = 0;                             ///< first row of the cycle of the largest
        int64_t cycle = 0;

        /// In % of the manual's largest total, or of the solver's where the manual has none.
        double percent(double difference) const;
    } restraint, normal;
    bool whole_surface =
        true; ///< false: the blank deforms, so the closest point is that of the traced segment
};

/// Along the recorded motion, at the record's steps. The trace must be one that `audit` takes.
std::vector<ManualDistance> manual_distance(const Trace&, const AuditDeck&);

} // namespace drawbead
