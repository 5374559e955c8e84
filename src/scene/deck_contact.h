#pragma once
// From a model's drawbeads to what the solver makes of them: the inputs of `contact`, taken from the deck
// alone.
#include "bead/bead_line.h"
#include "contact/bead_contact.h"
#include "model/model.h"
#include "scene/main_surface.h"

#include <memory>
#include <string>
#include <vector>

namespace drawbead {

/// What reading a model for contact needs.
inline constexpr Needs needs_contact =
    Needs::coordinates | Needs::blank_elements | Needs::element_thickness | Needs::attachments;

/// One interface. Vectors run along its list, in the order in which the solver takes the nodes: by user id
/// when the group is of a sorted type.
struct InterfaceContact {
    const Drawbead* bead = nullptr;
    const NodeGroup* group = nullptr; ///< nullptr when undefined; as `surface`
    const Surface* surface = nullptr;
    std::string unknown; ///< why `contact` is empty; empty when it is not
    std::vector<Vec3> x;
    BeadLine line;
    std::vector<double> fn, ft; ///< limits per length as the solver takes them
    BeadContact contact;
    std::vector<Track> track; ///< local numbers of the surface's NearMesh, before the first cycle
    StarterVerdict starter;
};

/// One main surface, shared by its interfaces.
struct SurfaceScene {
    std::unique_ptr<const SurfaceStiffness> stiffness; ///< empty when the surface has no segments
    NearMesh mesh;                                     ///< what the beads need of it
    std::shared_ptr<const SegmentTree> tree;           ///< of `mesh`
};

struct DeckContact {
    std::vector<InterfaceContact> interfaces; ///< as Model::drawbeads()
    std::vector<SurfaceScene> surfaces;       ///< as Model::surfaces()
};

/// Everything about the first cycle, with the deck's positions. The model, read with needs_contact, must
/// outlive it. The result does not depend on options.threads.
DeckContact contact_of(const Model&, const ContactOptions&);

/// The Starter's verdict alone, by Model::drawbeads(): what contact_of says in less time. Needs coordinates
/// and blank elements.
std::vector<StarterVerdict> starter_of(const Model&, unsigned threads);

} // namespace drawbead
