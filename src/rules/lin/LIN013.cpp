#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <map>
#include <utility>

namespace drawbead {

namespace {

/// Whether any node is in two lists.
bool any_shared(const std::vector<const BeadAnalysis*>& beads) {
    std::vector<std::pair<NodeRow, std::size_t>> all;
    for (std::size_t k = 0; k < beads.size(); ++k)
        for (const NodeRow node : beads[k]->group->nodes)
            all.emplace_back(node, k);
    std::sort(all.begin(), all.end());
    return std::adjacent_find(all.begin(), all.end(), [](const auto& p, const auto& q) {
               return p.first == q.first && p.second != q.second;
           }) != all.end();
}

void check(const RuleContext& context, FindingSink& sink) {
    std::vector<const BeadAnalysis*> beads = beads_with_nodes(context);
    if (beads.size() < 2 || !any_shared(beads)) return;
    // So that the same pair is told alike whatever the order of the blocks.
    std::stable_sort(beads.begin(), beads.end(),
                     [](const auto* p, const auto* q) { return p->bead->id < q->bead->id; });
    // The beads of each node, and for each pair of beads the positions in the second one's list.
    std::map<NodeRow, std::vector<std::size_t>> beads_of;
    std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> shared;
    for (std::size_t k = 0; k < beads.size(); ++k)
        for (std::size_t i = 0; i < beads[k]->x.size(); ++i) {
            const NodeRow node = beads[k]->group->nodes[i];
            std::vector<std::size_t>& before = beads_of[node];
            for (const std::size_t one : before) {
                if (one == k) continue;
                // Beads that meet at their ends have half a step there each.
                const std::vector<NodeRow>& other = beads[one]->group->nodes;
                if ((i == 0 || i + 1 == beads[k]->x.size()) &&
                    (node == other.front() || node == other.back()))
                    continue;
                shared[{one, k}].push_back(i);
            }
            if (before.empty() || before.back() != k) before.push_back(k);
        }
    for (const auto& [pair, positions] : shared) {
        const BeadAnalysis &a = *beads[pair.first], &b = *beads[pair.second];
        if (!windows_overlap(*a.bead, *b.bead)) continue;
        double fn = 0, ft = 0;
        for (const std::size_t i : positions) {
            fn += b.fn_force(i);
            ft += b.ft_force(i);
        }
        const std::vector<Span> places = list_places(context, b);
        Draft draft = draft_at_position(context, b, places, positions.front());
        draft.discriminator = "bead " + std::to_string(a.bead->id);
        std::vector<int64_t> ids;
        for (const std::size_t i : positions) {
            ids.push_back(node_id(context, b, i));
            draft.entities.nodes.add(ids.back());
            if (i != positions.front() && draft.related.size() < 99) draft.related.push_back(places[i]);
        }
        draft.place_count = positions.size();
        draft.message = counted(positions.size(), "node") + " of " + bead_name(*b.bead) +
                        (positions.size() == 1 ? " is" : " are") + " in the list of " + bead_name(*a.bead) +
                        ", too (" + listed(ids) +
                        "); both act there at the same time: " + cost_text(context, b, fn, ft);
        measure_cost(context, b, fn, ft, draft);
        draft.help = "give each bead nodes of its own, or time windows that do not overlap";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule LIN013{{.code = "LIN013",
                          .name = "node-in-two-beads",
                          .summary = "a node is listed by two beads that act at the same time",
                          .severity = Severity::warning},
                         needs_lines,
                         check};

} // namespace drawbead
