#include "rules/kin/path_report.h"
#include "rules/lin/bead_report.h"
#include "rules/stb/blank.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>

namespace drawbead {

namespace {

void say(const RuleContext& context, const BeadAnalysis& a, const Affected& nodes, const BeadPath* path,
         FindingSink& sink) {
    const bool at_start = path == nullptr;
    Draft draft = draft_at(context, *a.bead, cells_of(*a.bead).t_start);
    for (const std::size_t i : nodes.place)
        draft.entities.nodes.add(node_id(context, a, i));
    if (at_start) draft.severity = Severity::info;
    draft.message =
        counted(nodes.place.size(), "node") + " of " + std::to_string(a.x.size()) + " of " +
        bead_name(*a.bead) + (nodes.place.size() == 1 ? " is" : " are") + " in reach of DEPTH already when " +
        (at_start ? std::string("the run begins")
                  : "the window opens at " + time_text(context, a.bead->t_start)) +
        "; the force comes in one step: " +
        (at_start ? fn_force_text(context, a, nodes.fn) : force_text(context, a, nodes.fn, nodes.ft));
    if (path != nullptr) note_blank(*path, draft);
    measure_cost(context, a, nodes.fn, at_start ? 0 : nodes.ft, draft);
    draft.help = at_start
                     ? "start with the tool open by more than DEPTH and half the thickness, so that the ramp "
                       "of Fn is passed"
                     : "let the window open before the bead comes within DEPTH of the sheet";
    sink.add(std::move(draft));
}

/// Nodes on the ramp or beyond it in the first cycle.
Affected in_reach_at_start(const BeadAnalysis& a, const InterfaceContact& first) {
    Affected out;
    for (std::size_t i = 0; i < a.x.size(); ++i) {
        const BeadNodeContact& n = first.contact.node[i];
        if (!n.inside || !(n.penetration > 0)) continue;
        if (a.side.node.size() == a.x.size() && a.side.node[i] != Facing::toward) continue; // SRF001, SRF004
        const double share = std::min(n.penetration / a.bead->depth, 1.0);
        out.place.push_back(i);
        out.fn += share * a.fn_force(i);
    }
    return out;
}

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        const Drawbead& bead = *a->bead;
        if (bead.depth <= 0) continue; // PAR003: there is no ramp at all
        if (bead.t_start <= 0) {
            // The restraint grows with the motion of the sheet, which is at rest in the first cycle.
            const InterfaceContact* first = first_cycle(context, *a);
            if (first == nullptr || bead.fn_first == 0) continue;
            const Affected nodes = in_reach_at_start(*a, *first);
            if (nodes.fn != 0) say(context, *a, nodes, nullptr, sink);
            continue;
        }
        const BeadPath* path = path_of(context, *a);
        if (path == nullptr || !path->opens) continue;
        const Affected nodes = affected(*a, *path, [](const NodePath& node) { return node.opening_share; });
        if (nodes.fn != 0 || nodes.ft != 0) say(context, *a, nodes, path, sink);
    }
}

} // namespace

extern const Rule KIN002{{.code = "KIN002",
                          .name = "steps-on",
                          .summary = "bead nodes are within DEPTH of the sheet already when the window opens",
                          .severity = Severity::warning},
                         needs_motion | needs_sides,
                         check};

} // namespace drawbead
