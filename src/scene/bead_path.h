#pragma once
// How the nodes of a bead go over their blank during the run, as far as the deck or a scene says: a few
// samples, enough for rules and far from an evaluation.
#include "scene/class_motion.h"
#include "scene/deck_contact.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace drawbead {

struct PathRequest {
    PrescribedMotion prescribed;
    std::optional<double> end; ///< of the run, when it is known
    unsigned threads = 1;
};

/// One node of a bead, and its neighbours in the list that it stands for. Work units.
struct NodePath {
    uint32_t begin = 0, end = 0, place = 0;
    double element = 0; ///< root of the area of the segment under it at the start
    /// When the window opens: of the ramp, 0 out of reach, 1 on the plateau.
    double opening_share = 0;
    double opening_distance = 0; ///< signed
    /// Over the open window: distance less DEPTH and half thickness, at its smallest; negative in reach.
    double nearest = std::numeric_limits<double>::infinity();
    /// Lost reach while it was in it, and came back: in the open window.
    struct Lift {
        double off = 0, back = 0; ///< times
        double height = 0;        ///< largest distance less DEPTH and half thickness
    };
    std::optional<Lift> lift;
    std::optional<double> left; ///< time at which it came beside the blank, out of its reach
    /// Ways across the bead while in reach: of the node itself, and past the blank.
    double tool_way = 0, slide_way = 0;
    double tool_speed = 0;    ///< largest of the node itself, likewise
    double travel_before = 0; ///< along the blank, from the start to the opening of the window
};

struct BeadPath {
    std::string unknown = "it was not asked for"; ///< why nothing is known; empty when the bead's motion is
    /// Why the blank's motion is not known. Then it is taken as at rest where the deck has it, and as pushed
    /// along where a bead node comes through it. Empty when it is known.
    std::string blank_unknown;
    bool bead_moves = false, blank_moves = false;
    bool opens = false;        ///< the samples reach the opening of the window
    bool whole_run = false;    ///< they cover the run, or all of the motion when its end is not known
    double begin = 0, end = 0; ///< times of the first and the last sample
    double travel = 0; ///< largest distance of a bead node from its start along a blank that is known, until
                       ///< the window closes
    std::vector<NodePath> node; ///< ascending places

    bool known() const { return unknown.empty(); }
    bool blank_known() const { return known() && blank_unknown.empty(); }
};

/// By Model::drawbeads(). The model must be read with needs_contact | Needs::motion, and the contact be that
/// of its first cycle. Beads whose motion is not known cost nothing. Does not depend on the threads.
std::vector<BeadPath> bead_paths(const Model&, const DeckContact&, const PathRequest&);

/// The time from which on a motion stands still by itself; empty when it does not.
std::optional<double> rest_time(const Motion&);

} // namespace drawbead
