#include "rules/limits.h"
#include "rules/lin/bead_report.h"
#include "rules/lin/near_hops.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <limits>
#include <set>

namespace drawbead {

namespace {

/// Where a bead runs, without the gaps that LIN001 speaks of.
LineHops hops_of(const BeadAnalysis& a) {
    LineHops line{a.x, {}};
    std::vector<bool> gap(a.x.size(), false);
    for (const LineHop& one : a.check.gaps)
        gap[one.from] = true;
    for (uint32_t i = 0; i + 1 < a.x.size(); ++i)
        if (!gap[i]) line.hops.push_back({i, i + 1});
    return line;
}

/// Beads that press the sheet from its two sides do not meet.
bool on_one_side(const BeadAnalysis& a, uint32_t i, const BeadAnalysis& b, uint32_t j) {
    if (a.hit.empty() || b.hit.empty()) return true;
    return dot(a.x[i] - a.hit[i].closest.foot.point, b.x[j] - b.hit[j].closest.foot.point) >= 0;
}

/// Whether a hop ends at a node that both beads list: LIN013 speaks of that.
bool at_shared_node(const BeadAnalysis& a, const HopEnds& p, const std::set<NodeRow>& shared) {
    return shared.count(a.group->nodes[p.from]) != 0 || shared.count(a.group->nodes[p.to]) != 0;
}

std::set<NodeRow> shared_nodes(const BeadAnalysis& a, const BeadAnalysis& b) {
    const std::set<NodeRow> first(a.group->nodes.begin(), a.group->nodes.end());
    std::set<NodeRow> shared;
    for (const NodeRow row : b.group->nodes)
        if (first.count(row) != 0) shared.insert(row);
    return shared;
}

/// A round bead of depth DEPTH is twice as wide.
double half_width(const RuleContext& context, const BeadAnalysis& a) {
    return context.limits.LIN014_half_width_depths * std::max(a.bead->depth, 0.0);
}

void check(const RuleContext& context, FindingSink& sink) {
    const UnitSystem& units = context.deck.work_units();
    std::vector<const BeadAnalysis*> beads;
    for (const BeadAnalysis* a : beads_with_order(context))
        if (!a->check.scrambled && !a->check.too_short) beads.push_back(a);
    if (beads.size() < 2) return;
    // So that the same pair is told alike whatever the order of the blocks.
    std::stable_sort(beads.begin(), beads.end(),
                     [](const auto* p, const auto* q) { return p->bead->id < q->bead->id; });
    std::vector<LineHops> lines;
    for (const BeadAnalysis* a : beads)
        lines.push_back(hops_of(*a));
    for (std::size_t q = 1; q < beads.size(); ++q)
        for (std::size_t p = 0; p < q; ++p) {
            const BeadAnalysis &a = *beads[p], &b = *beads[q];
            if (!windows_overlap(*a.bead, *b.bead)) continue;
            const double width = half_width(context, a) + half_width(context, b);
            const double touching =
                context.limits.LIN014_touch_steps * std::min(a.check.median_hop, b.check.median_hop);
            const std::vector<NearHops> near = near_hops(lines[p], lines[q], std::max(width, touching));
            if (near.empty()) continue;
            const std::set<NodeRow> shared = shared_nodes(a, b);
            std::vector<bool> near_node(b.x.size(), false);
            double least = std::numeric_limits<double>::infinity();
            bool crossing = false;
            for (const NearHops& pair : near) {
                const uint32_t i = pair.first.from, j = pair.second.from;
                if (pair.ends_meet || !on_one_side(a, i, b, j)) continue;
                if (at_shared_node(a, pair.first, shared) || at_shared_node(b, pair.second, shared)) continue;
                least = std::min(least, pair.distance);
                crossing = crossing || pair.distance <= touching;
                // The end of the hop that is closer to the other bead.
                near_node[pair.along_second < 0.5 ? j : j + 1] = true;
            }
            std::vector<std::size_t> found;
            double fn = 0, ft = 0;
            for (std::size_t i = 0; i < near_node.size(); ++i) {
                if (!near_node[i]) continue;
                found.push_back(i);
                fn += b.fn_force(i);
                ft += b.ft_force(i);
            }
            if (found.empty()) continue;
            const std::vector<Span> places = list_places(context, b);
            Draft draft = draft_at_position(context, b, places, found.front());
            draft.discriminator = "bead " + std::to_string(a.bead->id);
            for (const std::size_t i : found) {
                draft.entities.nodes.add(node_id(context, b, i));
                if (i != found.front() && draft.related.size() < 99) draft.related.push_back(places[i]);
            }
            draft.place_count = found.size();
            draft.message = bead_name(*b.bead) + (crossing ? " crosses or touches " : " comes closer to ") +
                            bead_name(*a.bead) + (crossing ? std::string() : " than both are wide") + " at " +
                            counted(found.size(), "node") + " (" +
                            quantity(least, units, length_dimension, 3) + " apart, DEPTH " +
                            quantity(a.bead->depth, units, length_dimension, 3) + " and " +
                            quantity(b.bead->depth, units, length_dimension, 3) +
                            "); both act on the same strip of the sheet: " + force_text(context, b, fn, ft);
            draft.measured.push_back({"distance", least, unit_name(units, length_dimension)});
            measure_cost(context, b, fn, ft, draft);
            draft.help = "end one bead before the other begins, or set them apart by their real distance";
            sink.add(std::move(draft));
        }
}

} // namespace

extern const Rule LIN014{{.code = "LIN014",
                          .name = "beads-overlap",
                          .summary = "two beads cross, or run closer to each other than they are wide",
                          .severity = Severity::warning},
                         needs_closest,
                         check};

} // namespace drawbead
