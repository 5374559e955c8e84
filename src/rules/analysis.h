#pragma once
// What is computed once per deck from the model and shared by the rules: bead lines, what lies under them,
// and which way it looks.
#include "bead/bead_line.h"
#include "bead/line_check.h"
#include "contact/blank_stiffness.h"
#include "contact/closest_segment.h"
#include "contact/segment_mesh.h"
#include "deck/engine_deck.h"
#include "model/model.h"
#include "rules/card_lines.h"
#include "rules/srf/bead_side.h"
#include "rules/srf/edge_clash.h"
#include "scene/bead_path.h"
#include "scene/deck_contact.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace drawbead {

struct Limits;

/// What rules need beside the model. A rule puts these into its `needs`; bits from 2^16 on belong to the
/// analysis.
inline constexpr Needs analysis_lines{1u << 16}, analysis_closest{1u << 17}, analysis_sides{1u << 18},
    analysis_clashes{1u << 19}, analysis_contact{1u << 20}, analysis_layers{1u << 21}, analysis_run{1u << 22},
    analysis_motion{1u << 23};
inline constexpr Needs needs_lines = analysis_lines | Needs::coordinates;
inline constexpr Needs needs_closest = analysis_closest | needs_lines | Needs::blank_elements;
inline constexpr Needs needs_sides = analysis_sides | needs_closest;
inline constexpr Needs needs_first_cycle = analysis_contact | needs_contact | needs_closest;
inline constexpr Needs needs_motion = analysis_motion | analysis_run | needs_first_cycle | Needs::motion;
inline constexpr Needs needs_layers = analysis_layers | needs_sides;
inline constexpr Needs needs_clashes = analysis_clashes | Needs::coordinates | Needs::blank_elements;

/// The segment under a bead node.
struct BeadHit {
    uint32_t segment = no_segment; ///< index in the surface; no_segment where the surface has none
    ClosestHit closest;
    double element = 0;                ///< root of the segment's area
    uint32_t other_layer = no_segment; ///< of the surface, at a similar distance, when layers were asked for
    double other_layer_distance = 0;   ///< signed
};

/// One interface. Vectors run along its list; they are empty for what was not asked for or cannot be had.
struct BeadAnalysis {
    const Drawbead* bead = nullptr;
    const NodeGroup* group = nullptr; ///< nullptr when undefined; as `surface`
    const Surface* surface = nullptr;
    bool order_is_the_authors = false; ///< the group keeps the order in which its nodes are listed
    std::vector<Vec3> x;
    BeadLine line;
    LineCheck check;                   ///< with element sizes only when closest segments were asked for
    std::vector<double> fn, ft;        ///< limits per length as the solver takes them
    double fn_total = 0, ft_total = 0; ///< sum of limit times tributary length: force
    std::vector<BeadHit> hit;
    BeadSide side; ///< segments are local numbers of the surface's NearMesh

    double fn_force(std::size_t i) const { return fn[i] * line.tributary[i]; }
    double ft_force(std::size_t i) const { return ft[i] * line.tributary[i]; }
};

/// One main surface.
struct SurfaceAnalysis {
    NearMesh near; ///< around all its beads
    EdgeClashes clashes;
};

/// What is known of the run beside the deck.
struct RunFacts {
    std::optional<EngineDeck>
        engine; ///< the engine deck beside the starter deck, when analysis_run is asked for
    /// Who moves the nodes, and until when, instead of the deck: a scene.
    PrescribedMotion prescribed;
    std::optional<double> scene_end;

    std::optional<double> end() const { return scene_end ? scene_end : engine ? engine->end : std::nullopt; }
};

struct Analysis {
    RunFacts run;
    std::vector<CardLines> cards;          ///< as Model::drawbeads(), always
    std::vector<BeadAnalysis> beads;       ///< as Model::drawbeads()
    std::vector<SurfaceAnalysis> surfaces; ///< as Model::surfaces()
    DeckContact contact; ///< the first cycle as the solver sees it, without other layers; when asked for. Its
                         ///< meshes may have become those of `surfaces`
    std::vector<BeadPath> path; ///< as Model::drawbeads(); empty unless analysis_motion was asked for
    std::vector<StarterVerdict> starter; ///< as Model::drawbeads(); empty unless coordinates and blank
                                         ///< elements were asked for
};

/// Computes what `needs` names, as the limits of the rules say. The model must outlive the result, which does
/// not depend on the count of threads.
Analysis analyse(const Deck&, const Model&, const Limits&, Needs needs, unsigned threads, RunFacts = {});

} // namespace drawbead
