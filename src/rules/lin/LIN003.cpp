#include "rules/lin/bead_report.h"
#include "rules/lin/list_repair.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>

namespace drawbead {

namespace {

constexpr const char* drop_repeated = "drop the repeated entries";
constexpr const char* drop_coincident = "drop the second node of each pair";

void say_repeated(const RuleContext& context, const BeadAnalysis& a, FindingSink& sink) {
    const LineCheck& list = a.check;
    if (list.repeated.empty()) return;
    const std::vector<Span> places = list_places(context, a);
    const LinePair& first = list.repeated.front();
    Draft draft = draft_at_position(context, a, places, first.second);
    const std::string node = "node " + std::to_string(node_id(context, a, first.first));
    if (list.closed_by_repeat)
        draft.message = node + " is both the first and the last of the list of " + bead_name(*a.bead);
    else
        draft.message = node + " stands twice in the list of " + bead_name(*a.bead) + ", at places " +
                        std::to_string(first.first + 1) + " and " + std::to_string(first.second + 1);
    if (list.repeated.size() > 1)
        draft.message += " (and " + std::to_string(list.repeated.size() - 1) + " more)";
    draft.message += "; the Engine stops when it reads the restart file, there is no run: " +
                     cost_text(context, a, -a.fn_total, -a.ft_total);
    for (const LinePair& pair : list.repeated) {
        if (&pair != &first) draft.related.push_back(places[pair.second]);
        draft.entities.nodes.add(node_id(context, a, pair.first));
    }
    measure_cost(context, a, -a.fn_total, -a.ft_total, draft);
    draft.help = list.closed_by_repeat
                     ? "take the last entry away; a new node at the place of the first one closes the loop"
                     : "take the repeated entries away";
    draft.fixes.push_back({drop_repeated, FixAvailability::safe});
    sink.add(std::move(draft));
}

void say_coincident(const RuleContext& context, const BeadAnalysis& a, FindingSink& sink) {
    const LineCheck& list = a.check;
    if (list.coincident.empty()) return;
    std::vector<bool> dropped(a.x.size(), false);
    for (const LinePair& pair : list.coincident)
        dropped[pair.second] = true;
    std::vector<std::vector<uint32_t>> kept(1);
    for (uint32_t i = 0; i < a.x.size(); ++i)
        if (!dropped[i]) kept[0].push_back(i);
    const Forces without = forces_of_pieces(a, kept);
    const double fn = a.fn_total - without.fn, ft = a.ft_total - without.ft;

    const std::vector<Span> places = list_places(context, a);
    const LinePair& first = list.coincident.front();
    Draft draft = draft_at_position(context, a, places, first.second);
    draft.discriminator = "coincident";
    draft.message = "nodes " + std::to_string(node_id(context, a, first.first)) + " and " +
                    std::to_string(node_id(context, a, first.second)) + " of " + bead_name(*a.bead) +
                    " stand at the same place";
    if (list.coincident.size() > 1)
        draft.message += " (and " + std::to_string(list.coincident.size() - 1) + " more pairs)";
    draft.message +=
        "; a step without length splits the force of one place: " + cost_text(context, a, fn, ft);
    for (const LinePair& pair : list.coincident) {
        if (&pair != &first) draft.related.push_back(places[pair.second]);
        draft.entities.nodes.add(node_id(context, a, pair.first));
        draft.entities.nodes.add(node_id(context, a, pair.second));
    }
    measure_cost(context, a, fn, ft, draft);
    draft.help = "take one node of each pair out of the list";
    if (a.order_is_the_authors) draft.fixes.push_back({drop_coincident, FixAvailability::safe});
    sink.add(std::move(draft));
}

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        // A group that the solver sorts holds each node once.
        if (a->order_is_the_authors) say_repeated(context, *a, sink);
        say_coincident(context, *a, sink);
    }
}

/// What a node listed at `i` adds to the way along the list; ends weigh like hops.
double detour(const BeadAnalysis& a, uint32_t i) {
    const bool first = i == 0, last = i + 1 == a.x.size();
    const double before = first ? 0 : distance(a.x[i - 1], a.x[i]);
    const double after = last ? 0 : distance(a.x[i], a.x[i + 1]);
    return before + after - (first || last ? 0 : distance(a.x[i - 1], a.x[i + 1]));
}

std::optional<Fix> fix(const RuleContext& context, const Draft& draft, FixPlanner& planner) {
    const BeadAnalysis* a = analysed_bead(context, draft);
    if (!a) return planner.decline("the interface has no list of nodes");
    const bool coincident = draft.discriminator == "coincident";
    std::vector<bool> dropped(a->x.size(), false);
    if (coincident) {
        for (const LinePair& pair : a->check.coincident)
            dropped[pair.second] = true;
    } else {
        // Of the places of a node the one on the way stays; the first where both are.
        for (const LinePair& pair : a->check.repeated) {
            const bool second = a->check.closed_by_repeat || dropped[pair.first] ||
                                detour(*a, pair.first) <= detour(*a, pair.second) * (1 + 1e-9);
            dropped[second ? pair.second : pair.first] = true;
        }
    }
    std::vector<uint32_t> kept;
    for (uint32_t i = 0; i < a->x.size(); ++i)
        if (!dropped[i]) kept.push_back(i);
    if (kept.size() == a->x.size()) return planner.decline("no entry is to be dropped");
    Fix fix{coincident ? drop_coincident : drop_repeated, FixAvailability::safe, {}};
    if (!a->order_is_the_authors) return planner.decline("the order of the list comes first");
    fix.uncovers = hidden_by_list();
    if (!set_list(context, *a, kept, planner, fix)) return std::nullopt;
    return fix;
}

} // namespace

extern const Rule LIN003{{.code = "LIN003",
                          .name = "node-repeated",
                          .summary = "a node stands twice in the list, or two nodes at one place",
                          .severity = Severity::error,
                          .fix = FixAvailability::safe},
                         needs_lines,
                         check,
                         needs_list_users,
                         fix};

} // namespace drawbead
