#include "rules/lin/bead_report.h"

#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <cmath>

namespace drawbead {

std::vector<Span> list_places(const RuleContext& context, const BeadAnalysis& a) {
    std::vector<Span> places;
    for (const ListedNode& entry : a.group->listed)
        if (entry.row != no_node) places.push_back(entry.place);
    if (places.size() != a.group->nodes.size())
        places.assign(a.group->nodes.size(), context.deck.blocks()[a.group->block].header);
    return places;
}

int64_t node_id(const RuleContext& context, const BeadAnalysis& a, std::size_t i) {
    return value(context.model.nodes().user_id(a.group->nodes[i]));
}

namespace {

std::string one_cost(const RuleContext& context, double cost, double total, const char* limit, bool plus) {
    const std::string force = quantity(cost, context.deck.work_units(), force_dimension);
    return (plus && cost > 0 ? "+" : "") + force + " of " + limit + ", " +
           number(total != 0 ? 100 * cost / std::abs(total) : 0, 3) + " % of its total";
}

std::string both_costs(const RuleContext& context, const BeadAnalysis& a, double fn, double ft, bool plus) {
    std::string text;
    if (a.fn_total != 0) text = one_cost(context, fn, a.fn_total, "Fn", plus);
    if (a.ft_total != 0) {
        if (!text.empty()) text += ", and ";
        text += one_cost(context, ft, a.ft_total, "Ft", plus);
    }
    return text.empty() ? "0 N, the bead has no force" : text;
}

} // namespace

std::string cost_text(const RuleContext& context, const BeadAnalysis& a, double fn, double ft) {
    return both_costs(context, a, fn, ft, true);
}

std::string force_text(const RuleContext& context, const BeadAnalysis& a, double fn, double ft) {
    return both_costs(context, a, fn, ft, false);
}

std::string fn_cost_text(const RuleContext& context, const BeadAnalysis& a, double fn) {
    return one_cost(context, fn, a.fn_total, "Fn", true);
}

std::string ft_cost_text(const RuleContext& context, const BeadAnalysis& a, double ft) {
    return one_cost(context, ft, a.ft_total, "Ft", true);
}

std::string fn_force_text(const RuleContext& context, const BeadAnalysis& a, double fn) {
    return one_cost(context, fn, a.fn_total, "Fn", false);
}

std::string ft_force_text(const RuleContext& context, const BeadAnalysis& a, double ft) {
    return one_cost(context, ft, a.ft_total, "Ft", false);
}

void measure_cost(const RuleContext& context, const BeadAnalysis& a, double fn, double ft, Draft& draft) {
    const std::string unit = unit_name(context.deck.work_units(), force_dimension);
    draft.measured.push_back({"normal force", fn, unit});
    draft.measured.push_back({"restraint", ft, unit});
    if (a.fn_total != 0)
        draft.measured.push_back({"share of normal force", 100 * fn / std::abs(a.fn_total), "%"});
    if (a.ft_total != 0)
        draft.measured.push_back({"share of restraint", 100 * ft / std::abs(a.ft_total), "%"});
}

std::vector<std::vector<uint32_t>> list_pieces(const BeadAnalysis& a) {
    std::vector<std::vector<uint32_t>> pieces;
    const std::vector<uint32_t> starts = a.check.piece_starts();
    for (std::size_t p = 0; p < starts.size(); ++p) {
        const uint32_t end = p + 1 < starts.size() ? starts[p + 1] : static_cast<uint32_t>(a.x.size());
        pieces.emplace_back();
        for (uint32_t i = starts[p]; i < end; ++i)
            pieces.back().push_back(i);
    }
    return pieces;
}

Forces forces_of_pieces(const BeadAnalysis& a, const std::vector<std::vector<uint32_t>>& pieces) {
    Forces total;
    for (const std::vector<uint32_t>& piece : pieces) {
        std::vector<Vec3> x;
        for (const uint32_t i : piece)
            x.push_back(a.x[i]);
        const BeadLine line = bead_line(x);
        for (std::size_t k = 0; k < piece.size(); ++k) {
            total.fn += a.fn[piece[k]] * line.tributary[k];
            total.ft += a.ft[piece[k]] * line.tributary[k];
        }
    }
    return total;
}

Draft draft_at_position(const RuleContext&, const BeadAnalysis& a, const std::vector<Span>& places,
                        std::size_t i) {
    Draft draft;
    draft.interface_id = a.bead->id;
    draft.primary = places[i];
    return draft;
}

std::vector<const BeadAnalysis*> beads_with_nodes(const RuleContext& context) {
    std::vector<const BeadAnalysis*> beads;
    for (const BeadAnalysis& a : context.analysis.beads)
        if (!a.x.empty() && cards_usable(context, *a.bead)) beads.push_back(&a);
    return beads;
}

std::vector<const BeadAnalysis*> beads_with_order(const RuleContext& context) {
    std::vector<const BeadAnalysis*> beads;
    for (const BeadAnalysis* a : beads_with_nodes(context))
        if (a->order_is_the_authors) beads.push_back(a);
    return beads;
}

bool windows_overlap(const Drawbead& a, const Drawbead& b) {
    return std::max(a.t_start, b.t_start) <= std::min(a.t_stop, b.t_stop);
}

Span segment_place(const RuleContext& context, const Surface& surface, uint32_t segment) {
    if (segment < surface.lines.size()) return surface.lines[segment];
    const Segment& s = surface.segments[segment];
    if (s.kind == ElementKind::none) return context.deck.blocks()[surface.block].header;
    return context.model.element_line(s);
}

std::string segment_name(const RuleContext& context, const Surface& surface, uint32_t segment) {
    const Segment& s = surface.segments[segment];
    if (s.kind == ElementKind::none) return "segment " + std::to_string(segment + 1);
    return (s.kind == ElementKind::solid ? "solid " : "shell ") +
           std::to_string(value(context.model.element_id(s)));
}

void add_segment(const RuleContext& context, const Surface& surface, uint32_t segment, Entities& entities) {
    const Segment& s = surface.segments[segment];
    uint64_t corners = 0; // the number of a segment changes with the order of the blocks, its nodes do not
    for (const NodeRow row : s.n)
        corners += EntityList::mixed(static_cast<uint64_t>(value(context.model.nodes().user_id(row))));
    entities.segments.add(segment + 1, corners);
    if (s.kind != ElementKind::none) entities.elements.add(value(context.model.element_id(s)));
}

} // namespace drawbead
