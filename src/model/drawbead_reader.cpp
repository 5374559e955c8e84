#include "model/drawbead_reader.h"

#include "model/cards/type8.h"
#include "model/option_reader.h"

#include <array>

namespace drawbead {

std::optional<BlockIndex> find_node_group(const OptionIndex& index, int64_t id) {
    const auto block = index.find(Family::node_group, id);
    return block ? block : index.find(Family::set, id);
}

std::optional<BlockIndex> find_surface(const OptionIndex& index, int64_t id) {
    const auto block = index.find(Family::surface, id);
    return block ? block : index.find(Family::set, id);
}

namespace {

constexpr std::array<const CardSchema*, 3> schemas{&type8_references, &type8_forces, &type8_last};

/// Whether both ids of a first card exist.
bool names_group_and_surface(const Deck& deck, ScopeId scope, const OptionIndex& index, const Span& line) {
    const Card card = read_card(deck, scope, line, type8_references);
    const int64_t offset = deck.scope(scope).offsets.general;
    const Cell &group = card["grnd_IDs"], &surface = card["surf_IDm"];
    return group.state == CellState::ok && surface.state == CellState::ok && group.integer > 0 &&
           surface.integer > 0 && find_node_group(index, Deck::global_id(group.integer, offset)) &&
           find_surface(index, Deck::global_id(surface.integer, offset));
}

Drawbead read_drawbead(const Deck& deck, const OptionIndex& index, const Option& option, IssueLog& issues) {
    OptionReader reader(deck, option.block, issues);
    const ScopeId scope = reader.block().scope;
    Drawbead bead;
    bead.id = option.id;
    bead.block = option.block;
    bead.title = reader.title();
    bead.title_line = reader.title_line();

    std::vector<Span> lines;
    for (Span line; reader.line(line);)
        lines.push_back(line);
    // A forgotten title swallows the first card: then what stands in the title's place names a group and a
    // surface and the line after it does not.
    bead.title_missing = !reader.has_title_line() ||
                         (names_group_and_surface(deck, scope, index, bead.title_line) &&
                          (lines.empty() || !names_group_and_surface(deck, scope, index, lines[0])));

    for (std::size_t i = 0; i < schemas.size(); ++i) {
        bead.cards[i] = i < lines.size() ? read_card(deck, scope, lines[i], *schemas[i])
                                         : missing_card(deck, scope, *schemas[i]);
        issues.check(bead.cards[i]);
    }
    for (std::size_t i = schemas.size(); i < lines.size(); ++i)
        if (!trim(deck.text(lines[i])).empty()) bead.extra.push_back(lines[i]);

    const int64_t offset = deck.scope(scope).offsets.general;
    bead.group_id = reader.reference(bead.cards[0], "grnd_IDs", offset);
    bead.surface_id = reader.reference(bead.cards[0], "surf_IDm", offset);
    const auto iform = static_cast<int>(bead.cards[0]["Iform"].integer);
    bead.iform = iform == 0 ? 2 : iform;
    bead.fn_first = reader.real(bead.cards[1], "Fn");
    bead.ft_first = reader.real(bead.cards[1], "Ft");
    bead.depth = reader.real(bead.cards[1], "Depth");
    bead.t_start = reader.real(bead.cards[1], "Tstart");
    const double t_stop = reader.real(bead.cards[1], "Tstop");
    if (t_stop != 0) bead.t_stop = t_stop;
    bead.fn_last = reader.real(bead.cards[2], "Fn_last");
    bead.ft_last = reader.real(bead.cards[2], "Ft_last");
    reader.factor(force_per_length_dimension); // an unknown unit is reported even when every value is 0
    bead.unit_known = reader.unit_known();
    return bead;
}

} // namespace

std::vector<Drawbead> read_drawbeads(const Deck& deck, const OptionIndex& index, IssueLog& issues) {
    std::vector<Drawbead> beads;
    for (const Option& option : index.all(Family::interface))
        if (deck.blocks()[option.block].keyword == "INTER/TYPE8")
            beads.push_back(read_drawbead(deck, index, option, issues));
    return beads;
}

} // namespace drawbead
