#include "rules/lin/list_repair.h"

#include "model/option_reader.h"
#include "rules/lin/bead_report.h"
#include "rules/support.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace drawbead {

namespace {

constexpr std::size_t longest_title = 100;

bool is_list_keyword(std::string_view keyword) {
    const std::string_view type = subtype(keyword);
    return is_option(keyword, "GRNOD") && (type == "NODE" || type == "CNODE" || type == "NODENS");
}

/// Whether the list that the solver reads stands in the group's own block, entry by entry.
bool is_listed(const RuleContext& context, const NodeGroup& group) {
    const Block& block = context.deck.blocks()[group.block];
    return std::all_of(group.listed.begin(), group.listed.end(), [&](const ListedNode& entry) {
        return entry.place.file == block.text.file && entry.place.begin >= block.text.begin &&
               entry.place.end <= block.text.end;
    });
}

/// The entries that name existing nodes.
std::vector<const ListedNode*> entries_of(const NodeGroup& group) {
    std::vector<const ListedNode*> entries;
    for (const ListedNode& entry : group.listed)
        if (entry.row != no_node) entries.push_back(&entry);
    return entries;
}

/// Whether an option takes a group as a set, so that an order means nothing to it.
bool takes_a_set(const Block& block) {
    for (const std::string_view keyword : {"BCS", "IMPVEL", "IMPDISP", "IMPACC", "RBODY", "CLOAD", "GRAV",
                                           "INIVEL", "ADMAS", "GRNOD/GRNOD", "TRANSFORM", "RBE2"})
        if (is_option(block.keyword, keyword)) return true;
    return false;
}

/// The other beads on the same group.
std::vector<const BeadAnalysis*> companions(const RuleContext& context, const BeadAnalysis& a) {
    std::vector<const BeadAnalysis*> others;
    for (const BeadAnalysis& other : context.analysis.beads)
        if (&other != &a && other.group == a.group) others.push_back(&other);
    return others;
}

bool is_in_two_places(const Deck& deck, BlockIndex block) {
    return instances_of(deck, block).size() > 1;
}

/// The cells of a line of ids.
uint32_t cell_width(const Deck& deck, BlockIndex block) {
    return deck.scope(deck.blocks()[block].scope).layout < 45 ? 8 : 10;
}

Span line_of(const Deck& deck, const Span& place) {
    const SourceFile& file = deck.file(place.file);
    const uint64_t begin = file.line_begin(place.begin);
    return {place.file, begin, begin + file.line_at(place.begin).size()};
}

bool is_free(const Deck& deck, const Span& line) {
    return deck.text(line).find(',') != std::string_view::npos;
}

std::string title_with(const std::string& title, const std::string& otherwise, std::size_t piece) {
    const std::string ending = ", piece " + std::to_string(piece);
    std::string text = title.empty() ? otherwise : title;
    if (text.size() + ending.size() > longest_title) text.resize(longest_title - ending.size());
    return text + ending;
}

void add_moves(const BeadAnalysis& a, const std::vector<uint32_t>& order, Fix& fix) {
    uint64_t moved = a.group->nodes.size() - std::min(order.size(), a.group->nodes.size());
    if (!std::is_sorted(order.begin(), order.end()))
        for (uint32_t k = 0; k < order.size(); ++k)
            moved += a.group->nodes[order[k]] != a.group->nodes[k];
    fix.changes.push_back({a.bead->id, 0, moved});
}

/// Writes the entries of a list anew: `order` of them, the rest goes. Lists of nodes may have blank cells;
/// what is only left out is blanked there.
void rewrite_entries(const Deck& deck, const NodeGroup& group, const std::vector<const ListedNode*>& entries,
                     const std::vector<uint32_t>& order, FixPlanner& planner) {
    const ScopeId scope = deck.blocks()[group.block].scope;
    std::vector<const ListedNode*> dropped;
    if (group.type != "SET" && std::is_sorted(order.begin(), order.end())) {
        std::vector<bool> kept(entries.size(), false);
        for (const uint32_t i : order)
            kept[i] = true;
        for (std::size_t i = 0; i < entries.size(); ++i)
            if (!kept[i]) dropped.push_back(entries[i]);
    } else {
        for (std::size_t k = 0; k < order.size(); ++k)
            if (entries[order[k]]->written != entries[k]->written)
                planner.cells().set_listed_id(scope, entries[k]->place, entries[order[k]]->written);
        dropped.assign(entries.begin() + static_cast<std::ptrdiff_t>(order.size()), entries.end());
    }
    drop_entries(deck, group.block, group.listed, dropped, planner);
}

/// Puts the ids of an interface's pieces behind it in /TH/INTER and the like.
void follow_in_histories(const RuleContext& context, int64_t old_id, const std::vector<int64_t>& new_ids,
                         FixPlanner& planner) {
    const Deck& deck = context.deck;
    for (BlockIndex i = 0; i < deck.blocks().size(); ++i) {
        if (!is_interface_history(deck.blocks()[i])) continue;
        const Scope& scope = deck.scope(deck.blocks()[i].scope);
        const std::vector<ListedNode> ids = listed_interfaces(deck, i);
        const bool named = std::any_of(ids.begin(), ids.end(), [&](const ListedNode& id) {
            return Deck::global_id(id.written, scope.offsets.general) == old_id;
        });
        if (!named) continue;
        const ListedNode& last = ids.back();
        const Span line = line_of(deck, last.place);
        const uint32_t width = cell_width(deck, i);
        auto cell = static_cast<uint32_t>((last.place.begin - line.begin) / width);
        std::vector<int64_t> rest;
        std::string behind;
        for (const int64_t id : new_ids) {
            const int64_t written = id - scope.offsets.general;
            if (written <= 0) return planner.cells().fail("a time history cannot name the new interface");
            if (is_free(deck, line))
                behind += "," + std::to_string(written);
            else if (++cell < 10)
                planner.cells().set_columns(line, cell * width + 1, width, std::to_string(written));
            else
                rest.push_back(written);
        }
        if (!behind.empty())
            planner.cells().replace({last.place.file, last.place.end, last.place.end}, behind);
        if (rest.empty()) continue;
        BlockWriter writer(deck, i);
        writer.ids(rest);
        planner.add_after(i, writer.text());
    }
}

/// A /INTER/SUB of the interface gets a twin for each new one.
void follow_in_parts(const RuleContext& context, int64_t old_id, const std::vector<int64_t>& new_ids,
                     FixPlanner& planner) {
    const Deck& deck = context.deck;
    for (BlockIndex i = 0; i < deck.blocks().size(); ++i) {
        const Block& block = deck.blocks()[i];
        if (!is_option(block.keyword, "INTER/SUB")) continue;
        IssueLog unreported;
        OptionReader reader(deck, i, unreported);
        Span line;
        if (!reader.line(line)) continue;
        const int64_t offset = deck.scope(block.scope).offsets.general;
        const uint32_t width = cell_width(deck, i);
        const Cell parent = read_cell(deck, block.scope, line, 1, width, Kind::integer);
        if (!parent.given() || Deck::global_id(parent.integer, offset) != old_id) continue;
        std::vector<int64_t> twins;
        for (const int64_t id : new_ids) {
            const int64_t written = id - offset, own = planner.free_id(Family::interface, i);
            if (written <= 0) return planner.cells().fail("a /INTER/SUB cannot name the new interface");
            BlockCopy copy(deck, i);
            copy.cells().set_header_id(i, own);
            if (is_free(deck, line))
                copy.cells().replace(parent.place, std::to_string(written));
            else
                copy.cells().set_columns(line, 1, width, std::to_string(written));
            planner.add_after(i, copy.text());
            twins.push_back(own + offset);
        }
        follow_in_histories(context, Deck::global_id(block.id, offset), twins, planner);
    }
}

} // namespace

const BeadAnalysis* analysed_bead(const RuleContext& context, const Draft& draft) {
    for (const BeadAnalysis& a : context.analysis.beads)
        if (draft.interface_id && a.bead->id == *draft.interface_id) return &a;
    return nullptr;
}

bool limits_are_constant(const Drawbead& bead) {
    return (!bead.fn_varies() || bead.fn_last == bead.fn_first || bead.fn_first == 0) &&
           (!bead.ft_varies() || bead.ft_last == bead.ft_first);
}

double never_zero(double value, double other) {
    return value == 0 ? other / 1e6 : value;
}

std::vector<uint32_t> whole_walk(const LineCheck& check) {
    std::vector<std::vector<uint32_t>> behind(check.nodes);
    for (const std::vector<LinePair>* pairs : {&check.repeated, &check.coincident})
        for (const LinePair& pair : *pairs)
            behind[pair.first].push_back(pair.second);
    std::vector<uint32_t> order;
    const auto add = [&](uint32_t i, const auto& self) -> void {
        order.push_back(i);
        for (const uint32_t k : behind[i])
            self(k, self);
    };
    for (const uint32_t i : check.walk.order)
        add(i, add);
    return order;
}

std::vector<std::string_view> hidden_by_list() {
    return {"LIN", "KIN", "STB", "ENG"};
}

bool list_is_whole(const BeadAnalysis& a) {
    return std::none_of(a.group->listed.begin(), a.group->listed.end(),
                        [](const ListedNode& node) { return node.row == no_node && node.written != 0; });
}

bool walk_is_safe(const LineCheck& check, const Drawbead& bead) {
    const LineWalk& walk = check.walk;
    if (!walk.unambiguous || walk.closed || walk.order.empty()) return false;
    return limits_are_constant(bead) || (walk.pieces.size() == 1 && walk.order.front() == 0);
}

SortedOrder order_of_sorted(const BeadAnalysis& a) {
    SortedOrder sorted;
    if (!a.group || !a.group->evaluated || a.x.size() < 2 || a.x.size() != a.group->nodes.size()) return {};
    // The file's own order, where it has one; each node once.
    std::vector<uint32_t> own;
    if (!a.group->listed.empty()) {
        std::map<NodeRow, uint32_t> position;
        for (uint32_t i = 0; i < a.group->nodes.size(); ++i)
            position.emplace(a.group->nodes[i], i);
        for (const ListedNode& entry : a.group->listed)
            if (const auto at = position.find(entry.row); entry.row != no_node && at != position.end()) {
                own.push_back(at->second);
                position.erase(at);
            }
    }
    const bool from_file = own.size() == a.x.size();
    if (!from_file) {
        own.resize(a.x.size());
        std::iota(own.begin(), own.end(), 0u);
    }
    std::vector<Vec3> x;
    std::vector<uint32_t> node;
    std::vector<double> element;
    for (const uint32_t i : own) {
        x.push_back(a.x[i]);
        node.push_back(index(a.group->nodes[i]));
        if (!a.hit.empty()) element.push_back(a.hit[i].element);
    }
    const LineCheck check = check_line(x, node, element);
    if (check.too_short || !check.walk.branches.empty()) return {};
    const std::vector<uint32_t> order = whole_walk(check);
    if (order.size() != own.size()) return {};
    for (const uint32_t k : order)
        sorted.order.push_back(own[k]);
    const bool either_end = limits_are_constant(*a.bead) && check.walk.unambiguous && !check.walk.closed;
    sorted.safe = (from_file && !check.scrambled) || either_end;
    return sorted;
}

bool set_list(const RuleContext& context, const BeadAnalysis& a, const std::vector<uint32_t>& order,
              FixPlanner& planner, Fix& fix) {
    const NodeGroup& group = *a.group;
    const std::vector<const ListedNode*> entries = entries_of(group);
    bool here = group.order == NodeGroup::Order::unsorted && entries.size() == group.nodes.size() &&
                is_listed(context, group);
    for (std::size_t i = 0; here && i < entries.size(); ++i)
        here = entries[i]->row == group.nodes[i];
    // Others that want the order, or the nodes that go.
    std::set<NodeRow> kept, all(group.nodes.begin(), group.nodes.end());
    for (const uint32_t i : order)
        kept.insert(group.nodes[i]);
    const bool same_nodes = kept == all, same_order = std::is_sorted(order.begin(), order.end());
    for (const BlockIndex user : group.users)
        here = here && same_nodes && (same_order || takes_a_set(context.deck.blocks()[user]));
    for (const BeadAnalysis* other : companions(context, a))
        here = here && same_nodes &&
               (same_order || planner.choices().unsafe || limits_are_constant(*other->bead));
    if (here) {
        rewrite_entries(context.deck, group, entries, order, planner);
    } else {
        std::vector<NodeRow> nodes;
        for (const uint32_t i : order)
            nodes.push_back(group.nodes[i]);
        const int64_t own = add_ordered_group(context, a, nodes,
                                              group.title.empty() ? "nodes of " + bead_name(*a.bead)
                                                                  : group.title + ", along the bead",
                                              planner);
        if (own == 0 || !use_group(context, a, own, planner.cells())) return false;
    }
    add_moves(a, order, fix);
    return !planner.failed();
}

int64_t add_ordered_group(const RuleContext& context, const BeadAnalysis& a,
                          const std::vector<NodeRow>& nodes, const std::string& title, FixPlanner& planner) {
    const Deck& deck = context.deck;
    const Block &bead = deck.blocks()[a.bead->block], &old = deck.blocks()[a.group->block];
    const bool bead_twice = is_in_two_places(deck, a.bead->block);
    std::vector<BlockIndex> places;
    if (!is_in_two_places(deck, a.group->block) || (bead_twice && bead.scope == old.scope))
        places.push_back(a.group->block);
    if (!bead_twice || bead.scope == old.scope) places.push_back(a.bead->block);
    if (bead_twice && bead.scope != old.scope) places.clear();
    for (const BlockIndex served : places) {
        const Scope& scope = deck.scope(deck.blocks()[served].scope);
        std::vector<int64_t> written;
        for (const NodeRow row : nodes)
            written.push_back(int64_t{value(context.model.nodes().user_id(row))} - scope.offsets.node);
        if (std::any_of(written.begin(), written.end(), [](int64_t id) { return id <= 0; })) continue;
        const int64_t id = planner.free_id(Family::node_group, served);
        if (id == 0) return 0;
        const int64_t global = Deck::global_id(id, scope.offsets.general);
        if (global - deck.scope(bead.scope).offsets.general <= 0) continue;
        BlockWriter writer(deck, served);
        writer.header("GRNOD/NODENS", id, title.substr(0, longest_title));
        writer.ids(written);
        planner.add_after(served, writer.text());
        return global;
    }
    planner.cells().fail(bead_twice ? "the interface stands in a file that is included more than once"
                                    : "no place in the deck can hold a node group of the bead's own");
    return 0;
}

bool use_group(const RuleContext& context, const BeadAnalysis& a, int64_t group, CellEditor& editor) {
    const Block& block = context.deck.blocks()[a.bead->block];
    const int64_t written = group - context.deck.scope(block.scope).offsets.general;
    if (written <= 0)
        editor.fail("the interface cannot name the new node group");
    else
        editor.set_cell(a.bead->cards[0], "grnd_IDs", std::to_string(written));
    return !editor.failed();
}

bool make_ordered(const RuleContext& context, const BeadAnalysis& a, const SortedOrder& sorted,
                  FixPlanner& planner, Fix& fix) {
    const NodeGroup& group = *a.group;
    const Block& block = context.deck.blocks()[group.block];
    bool here = is_list_keyword(block.keyword) && group.users.empty() && is_listed(context, group);
    for (const BeadAnalysis* other : companions(context, a))
        here = here && (planner.choices().unsafe || order_of_sorted(*other).safe);
    const std::string_view header = context.deck.text(block.header);
    const std::string_view type = subtype(block.keyword);
    const std::size_t at = header.find("/" + std::string(type), 1);
    if (!here || at == std::string_view::npos) {
        std::vector<NodeRow> nodes;
        for (const uint32_t i : sorted.order)
            nodes.push_back(group.nodes[i]);
        const int64_t own = add_ordered_group(context, a, nodes,
                                              group.title.empty() ? "nodes of " + bead_name(*a.bead)
                                                                  : group.title + ", along the bead",
                                              planner);
        if (own == 0 || !use_group(context, a, own, planner.cells())) return false;
        add_moves(a, sorted.order, fix);
        return !planner.failed();
    }
    // In the list: its entries without repeated ones, which the solver has dropped.
    std::map<NodeRow, uint32_t> rank;
    for (uint32_t k = 0; k < sorted.order.size(); ++k)
        rank.emplace(group.nodes[sorted.order[k]], k);
    const std::vector<const ListedNode*> entries = entries_of(group);
    std::vector<uint32_t> order(sorted.order.size());
    std::vector<bool> seen(sorted.order.size(), false);
    for (uint32_t i = 0; i < entries.size(); ++i) {
        const auto known = rank.find(entries[i]->row);
        if (known == rank.end() || seen[known->second]) continue;
        seen[known->second] = true;
        order[known->second] = i;
    }
    planner.cells().replace(
        {block.header.file, block.header.begin + at + 1, block.header.begin + at + 1 + type.size()},
        "NODENS");
    rewrite_entries(context.deck, group, entries, order, planner);
    add_moves(a, sorted.order, fix);
    for (const BeadAnalysis* other : companions(context, a))
        add_moves(*other, sorted.order, fix);
    return !planner.failed();
}

std::vector<EndLimits> present_limits(const BeadAnalysis& a,
                                      const std::vector<std::vector<uint32_t>>& pieces) {
    const Drawbead& bead = *a.bead;
    std::vector<EndLimits> limits;
    for (const std::vector<uint32_t>& piece : pieces) {
        EndLimits one{bead.fn_first, bead.fn_last, bead.ft_first, bead.ft_last};
        const auto ends = [&](double& first, double& last, const std::vector<double>& at) {
            if (piece.front() != 0) first = at[piece.front()];
            if (piece.back() + 1 != a.x.size()) last = at[piece.back()];
            const double f = first, l = last;
            first = never_zero(f, l);
            last = never_zero(l, f);
        };
        if (bead.fn_varies() && bead.fn_first != 0) ends(one.fn_first, one.fn_last, a.fn);
        if (bead.ft_varies()) ends(one.ft_first, one.ft_last, a.ft);
        limits.push_back(one);
    }
    return limits;
}

bool pieces_are_lines(const BeadAnalysis& a, const std::vector<std::vector<uint32_t>>& pieces) {
    return pieces.size() > 1 && std::all_of(pieces.begin(), pieces.end(), [&](const auto& piece) {
               return std::any_of(piece.begin(), piece.end(), [&](uint32_t i) {
                   return a.group->nodes[i] != a.group->nodes[piece.front()];
               });
           });
}

std::vector<std::vector<uint32_t>> cut_at_nodes(const BeadAnalysis& a, const std::vector<LineTurn>& turns) {
    std::vector<std::vector<uint32_t>> pieces(1);
    for (uint32_t i = 0; i < a.x.size(); ++i) {
        pieces.back().push_back(i);
        if (std::any_of(turns.begin(), turns.end(), [&](const LineTurn& t) { return t.at == i; }))
            pieces.push_back({i});
    }
    return pieces;
}

bool split_bead(const RuleContext& context, const BeadAnalysis& a,
                const std::vector<std::vector<uint32_t>>& pieces, const std::vector<EndLimits>& limits,
                FixPlanner& planner, Fix& fix) {
    const Deck& deck = context.deck;
    const Drawbead& bead = *a.bead;
    const Block& block = deck.blocks()[bead.block];
    const int64_t offset = deck.scope(block.scope).offsets.general;
    if (!block.id_given) {
        planner.cells().fail("the header of the interface has no id");
        return false;
    }
    const auto nodes_of = [&](const std::vector<uint32_t>& piece) {
        std::vector<NodeRow> nodes;
        for (const uint32_t i : piece)
            nodes.push_back(a.group->nodes[i]);
        return nodes;
    };
    const std::string group_title = a.group->title.empty() ? "nodes of " + bead_name(bead) : a.group->title;
    const auto write_limits = [&](const EndLimits& old, const EndLimits& now, CellEditor& editor) {
        const auto write = [&](std::size_t card, std::string_view field, double before, double after) {
            if (before == after) return;
            const std::string text = cell_text(deck, block, force_per_length_dimension, after);
            if (text.empty())
                editor.fail("a limit of a piece cannot be written");
            else
                editor.set_cell(bead.cards[card], field, text);
        };
        write(1, "Fn", old.fn_first, now.fn_first);
        write(1, "Ft", old.ft_first, now.ft_first);
        write(2, "Fn_last", old.fn_last, now.fn_last);
        write(2, "Ft_last", old.ft_last, now.ft_last);
    };
    const EndLimits whole{bead.fn_first, bead.fn_last, bead.ft_first, bead.ft_last};

    // The first piece: in the old group when nobody else uses it.
    const std::vector<const ListedNode*> entries = entries_of(*a.group);
    bool here = a.group->order == NodeGroup::Order::unsorted && entries.size() == a.group->nodes.size() &&
                is_listed(context, *a.group) && a.group->users.empty() && companions(context, a).empty();
    for (std::size_t i = 0; here && i < entries.size(); ++i)
        here = entries[i]->row == a.group->nodes[i];
    if (here) {
        rewrite_entries(deck, *a.group, entries, pieces[0], planner);
    } else {
        const int64_t own =
            add_ordered_group(context, a, nodes_of(pieces[0]), title_with(group_title, {}, 1), planner);
        if (own == 0 || !use_group(context, a, own, planner.cells())) return false;
    }
    write_limits(whole, limits[0], planner.cells());
    fix.changes.push_back({bead.id, 0, a.group->nodes.size() - pieces[0].size()});

    std::vector<int64_t> new_ids;
    for (std::size_t p = 1; p < pieces.size(); ++p) {
        const int64_t group =
            add_ordered_group(context, a, nodes_of(pieces[p]), title_with(group_title, {}, p + 1), planner);
        if (group == 0) return false;
        const int64_t id = planner.free_id(Family::interface, bead.block);
        if (id == 0) return false;
        BlockCopy copy(deck, bead.block);
        copy.cells().set_header_id(bead.block, id);
        if (bead.title_line.end > bead.title_line.begin && !bead.title_missing)
            copy.cells().replace(bead.title_line, title_with(bead.title, bead_name(bead), p + 1));
        use_group(context, a, group, copy.cells());
        write_limits(whole, limits[p], copy.cells());
        const std::string text = copy.text();
        if (copy.cells().failed()) planner.cells().fail(copy.cells().failure());
        planner.add_after(bead.block, text);
        new_ids.push_back(id + offset);
        fix.changes.push_back({new_ids.back(), 0, pieces[p].size()});
    }
    follow_in_histories(context, bead.id, new_ids, planner);
    follow_in_parts(context, bead.id, new_ids, planner);
    return !planner.failed();
}

void drop_entries(const Deck& deck, BlockIndex block, const std::vector<ListedNode>& all,
                  const std::vector<const ListedNode*>& dropped, FixPlanner& planner) {
    if (dropped.empty()) return;
    const uint32_t width = cell_width(deck, block);
    const SourceFile& file = deck.file(dropped.front()->place.file);
    std::map<uint64_t, std::size_t> left; // entries that stay, by line
    for (const ListedNode& entry : all)
        ++left[file.line_begin(entry.place.begin)];
    for (const ListedNode* entry : dropped)
        --left[file.line_begin(entry->place.begin)];
    std::set<uint64_t> deleted;
    for (const ListedNode* entry : dropped) {
        const Span line = line_of(deck, entry->place);
        const std::string_view text = deck.text(line);
        const bool key = text[0] != ' ' && (text[0] < '0' || text[0] > '9') && text[0] != '&' &&
                         text[0] != '-' && text[0] != '\t' && text[0] != ',';
        if (left[line.begin] == 0 && !key) {
            if (deleted.insert(line.begin).second) planner.cells().delete_lines(line);
        } else if (is_free(deck, line)) {
            planner.cells().replace(entry->place, "");
        } else {
            const auto cell = static_cast<uint32_t>((entry->place.begin - line.begin) / width);
            planner.cells().set_columns(line, cell * width + 1, width, "");
        }
    }
}

void drop_listed(const Deck& deck, const NodeGroup& group, const std::vector<const ListedNode*>& dropped,
                 FixPlanner& planner) {
    if (group.type != "SET" || group.nodens_clauses.size() > 1)
        return drop_entries(deck, group.block, group.listed, dropped, planner);
    // A blank cell in a clause may count as a zero: those behind move up.
    std::vector<const ListedNode*> entries;
    std::vector<uint32_t> kept;
    for (const ListedNode& entry : group.listed) {
        if (std::find(dropped.begin(), dropped.end(), &entry) == dropped.end())
            kept.push_back(static_cast<uint32_t>(entries.size()));
        entries.push_back(&entry);
    }
    rewrite_entries(deck, group, entries, kept, planner);
}

void append_entry(const Deck& deck, BlockIndex block, const Span& last_entry, uint32_t first_cell,
                  int64_t written, FixPlanner& planner) {
    const uint32_t width = cell_width(deck, block);
    const Span line = line_of(deck, last_entry);
    const std::string text = std::to_string(written);
    const auto cell = static_cast<uint32_t>((last_entry.begin - line.begin) / width) + 1;
    const bool free = is_free(deck, line);
    const auto commas = std::count(deck.text(line).begin(), deck.text(line).end(), ',');
    if (free && commas < 9)
        return planner.cells().replace({last_entry.file, last_entry.end, last_entry.end}, "," + text);
    if (!free && cell < 10) return planner.cells().set_columns(line, cell * width + 1, width, text);
    const std::string row =
        std::string(first_cell * width + width - std::min<std::size_t>(width, text.size()), ' ') + text;
    const SourceFile& file = deck.file(line.file);
    const uint64_t next = file.next_line(line.begin);
    const BlockEnd end = block_end(deck, block);
    const bool unended = next == file.bytes().size() && file.bytes().back() != '\n';
    planner.cells().replace({line.file, next, next}, unended ? end.line_end + row : row + end.line_end);
}

bool is_interface_history(const Block& block) {
    std::string_view keyword = block.keyword;
    const std::size_t slash = keyword.find('/');
    if (slash == std::string_view::npos) return false;
    const std::string_view first = keyword.substr(0, slash), second = subtype(keyword);
    const bool history =
        first == "TH" || (first.size() == 3 && first[0] >= 'A' && first[0] <= 'I' && first.substr(1) == "TH");
    return history && second == "INTER";
}

std::vector<ListedNode> listed_interfaces(const Deck& deck, BlockIndex index) {
    std::vector<ListedNode> ids;
    const Block& block = deck.blocks()[index];
    const uint32_t width = cell_width(deck, index);
    IssueLog unreported;
    OptionReader reader(deck, index, unreported);
    for (Span line; reader.line(line);) {
        const std::string_view text = deck.text(line);
        if (text.find_first_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz") !=
                std::string_view::npos &&
            text.find('&') == std::string_view::npos)
            continue; // names of variables
        if (text.find(',') != std::string_view::npos) {
            for (std::size_t at = 0; at < text.size();) {
                const std::size_t comma = std::min(text.find(',', at), text.size());
                const std::string_view part = trim(text.substr(at, comma - at));
                const IntegerCell number = parse_integer(part);
                if (!part.empty() && number.state == NumberState::ok) {
                    const auto begin = line.begin + static_cast<uint64_t>(part.data() - text.data());
                    ids.push_back({number.value, no_node, {line.file, begin, begin + part.size()}});
                }
                at = comma + 1;
            }
            continue;
        }
        for (uint32_t cell = 0; cell < 10 && cell * width < text.size(); ++cell) {
            const Cell one = read_cell(deck, block.scope, line, cell * width + 1, width, Kind::integer);
            if (one.given()) ids.push_back({one.integer, no_node, one.place});
        }
    }
    return ids;
}

} // namespace drawbead
