#include "rules/lin/bead_report.h"
#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <map>

namespace drawbead {

namespace {

std::string name_of(const RuleContext& context, const Attachment& held) {
    return "/" + std::string(context.deck.blocks()[held.block].keyword) + "/" + std::to_string(held.id);
}

/// The two options that hold a node against each other: two rigid bodies, or one and something else.
std::optional<std::pair<Attachment, Attachment>> rivals(std::span<const Attachment> held) {
    const auto is_body = [](const Attachment& a) { return a.kind == Attachment::Kind::rigid_body; };
    const auto body = std::find_if(held.begin(), held.end(), is_body);
    if (body == held.end()) return std::nullopt;
    const auto other =
        std::find_if(held.begin(), held.end(), [&](const Attachment& a) { return a.block != body->block; });
    if (other == held.end()) return std::nullopt;
    return std::pair(*body, *other);
}

/// Positions of the list that a finding is about, in one draft.
Draft draft_of(const RuleContext& context, const BeadAnalysis& a, const std::vector<std::size_t>& positions) {
    const std::vector<Span> places = list_places(context, a);
    Draft draft = draft_at_position(context, a, places, positions.front());
    for (const std::size_t i : positions) {
        draft.entities.nodes.add(node_id(context, a, i));
        if (i != positions.front() && draft.related.size() < 99) draft.related.push_back(places[i]);
    }
    draft.place_count = positions.size();
    return draft;
}

std::vector<int64_t> ids_of(const RuleContext& context, const BeadAnalysis& a,
                            const std::vector<std::size_t>& positions) {
    std::vector<int64_t> ids;
    for (const std::size_t i : positions)
        ids.push_back(node_id(context, a, i));
    return ids;
}

/// Nodes that two options hold at once.
void check_rivals(const RuleContext& context, const BeadAnalysis& a, FindingSink& sink) {
    std::map<std::pair<BlockIndex, BlockIndex>, std::vector<std::size_t>> found;
    std::map<std::pair<BlockIndex, BlockIndex>, std::string> names;
    for (std::size_t i = 0; i < a.x.size(); ++i)
        if (const auto pair = rivals(context.model.attachments(a.group->nodes[i]))) {
            const std::pair key(pair->first.block, pair->second.block);
            found[key].push_back(i);
            if (const auto [name, is_new] = names.try_emplace(key); is_new)
                name->second = name_of(context, pair->first) + " and by " + name_of(context, pair->second);
        }
    for (const auto& [key, positions] : found) {
        double fn = 0, ft = 0;
        for (const std::size_t i : positions) {
            fn += a.fn_force(i);
            ft += a.ft_force(i);
        }
        Draft draft = draft_of(context, a, positions);
        draft.discriminator = names[key];
        draft.message = counted(positions.size(), "node") + " of " + bead_name(*a.bead) +
                        (positions.size() == 1 ? " is" : " are") + " held by " + names[key] + " (" +
                        listed(ids_of(context, a, positions)) +
                        "); which of them moves the bead is not defined: " + force_text(context, a, fn, ft);
        measure_cost(context, a, fn, ft, draft);
        draft.help = "leave the nodes to one rigid body and hold its main node";
        sink.add(std::move(draft));
    }
}

/// A bead that hangs on two bodies.
void check_bodies(const RuleContext& context, const BeadAnalysis& a, FindingSink& sink) {
    std::map<int64_t, std::vector<std::size_t>> of_body;
    for (std::size_t i = 0; i < a.x.size(); ++i)
        for (const Attachment& held : context.model.attachments(a.group->nodes[i]))
            if (held.kind == Attachment::Kind::rigid_body) {
                of_body[held.id].push_back(i);
                break;
            }
    if (of_body.size() < 2) return;
    const auto fewer = [](const auto& p, const auto& q) { return p.second.size() < q.second.size(); };
    const auto most = std::max_element(of_body.begin(), of_body.end(), fewer);
    std::vector<std::size_t> others;
    std::string bodies;
    for (const auto& [id, positions] : of_body) {
        if (id == most->first) continue;
        others.insert(others.end(), positions.begin(), positions.end());
        bodies += (bodies.empty() ? "" : ", ") + std::to_string(id);
    }
    std::sort(others.begin(), others.end());
    double fn = 0, ft = 0;
    for (const std::size_t i : others) {
        fn += a.fn_force(i);
        ft += a.ft_force(i);
    }
    Draft draft = draft_of(context, a, others);
    draft.discriminator = "bodies";
    draft.message = bead_name(*a.bead) + " hangs on two tools: " + counted(most->second.size(), "node") +
                    " on rigid body " + std::to_string(most->first) + ", " + std::to_string(others.size()) +
                    " on " + bodies + " (" + listed(ids_of(context, a, others)) +
                    "); where they part, so does the bead: " + force_text(context, a, fn, ft);
    measure_cost(context, a, fn, ft, draft);
    draft.help = "put all nodes of the bead on the tool that carries it, or make one bead per tool";
    sink.add(std::move(draft));
}

void check(const RuleContext& context, FindingSink& sink) {
    for (const BeadAnalysis* a : beads_with_nodes(context)) {
        check_rivals(context, *a, sink);
        check_bodies(context, *a, sink);
    }
}

} // namespace

extern const Rule CTX002{{.code = "CTX002",
                          .name = "attached-to-two",
                          .summary = "bead nodes that two options hold, or beads on two tools",
                          .severity = Severity::warning},
                         needs_lines | Needs::attachments,
                         check};

} // namespace drawbead
