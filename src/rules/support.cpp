#include "rules/support.h"

#include "rules/analysis.h"
#include "rules/text.h"

#include <algorithm>
#include <cmath>

namespace drawbead {

namespace {

constexpr Field tens(std::string_view name, uint8_t column) {
    return {name, column, 10, Kind::integer};
}
constexpr Field twenties(std::string_view name, uint8_t column) {
    return {name, column, 20, Kind::real};
}
constexpr std::array integer_columns{
    tens("1-10", 1),   tens("11-20", 11), tens("21-30", 21), tens("31-40", 31), tens("41-50", 41),
    tens("51-60", 51), tens("61-70", 61), tens("71-80", 71), tens("81-90", 81), tens("91-100", 91)};
constexpr std::array real_columns{twenties("1-20", 1), twenties("21-40", 21), twenties("41-60", 41),
                                  twenties("61-80", 61), twenties("81-100", 81)};
constexpr CardSchema integer_card{"columns of ten", integer_columns};
constexpr CardSchema real_card{"columns of twenty", real_columns};

} // namespace

const CardLines& cards_of(const RuleContext& context, const Drawbead& bead) {
    return context.analysis.cards[static_cast<std::size_t>(&bead - context.model.drawbeads().data())];
}

bool cards_usable(const RuleContext& context, const Drawbead& bead) {
    return cards_of(context, bead).usable();
}

Card all_columns(const Deck& deck, const Drawbead& bead, const Span& line, int card) {
    return read_card(deck, deck.blocks()[bead.block].scope, line, card == 1 ? integer_card : real_card);
}

const Scope& scope_of(const Deck& deck, const Drawbead& bead) {
    return deck.scope(deck.blocks()[bead.block].scope);
}

std::string bead_name(const Drawbead& bead) {
    return "bead " + std::to_string(bead.id);
}

Draft draft_at_header(const RuleContext& context, const Drawbead& bead) {
    Draft draft;
    draft.interface_id = bead.id;
    draft.primary = context.deck.blocks()[bead.block].header;
    return draft;
}

Draft draft_at(const RuleContext& context, const Drawbead& bead, const Cell& cell) {
    Draft draft = draft_at_header(context, bead);
    if (cell.state != CellState::absent && cell.place.begin != 0) draft.primary = cell.place;
    return draft;
}

DrawbeadCells cells_of(const Drawbead& bead) {
    const auto& [one, two, three] = bead.cards;
    return {one["grnd_IDs"], one["surf_IDm"], one["Iform"], two["Fn"],        two["Ft"],
            two["Depth"],    two["Tstart"],   two["Tstop"], three["Fn_last"], three["Ft_last"]};
}

bool readable(const Cell& cell) {
    return cell.state == CellState::blank || cell.state == CellState::absent || cell.given();
}

double line_length(const Model& model, const Drawbead& bead) {
    if (!bead.group || model.nodes().x.size() < model.nodes().size()) return 0;
    const std::vector<NodeRow>& nodes = model.groups()[*bead.group].nodes;
    double length = 0;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        const Vec3 a = model.nodes()[nodes[i - 1]], b = model.nodes()[nodes[i]];
        length +=
            std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y) + (b.z - a.z) * (b.z - a.z));
    }
    return length;
}

std::string force_over_line(const RuleContext& context, const Drawbead& bead, double force_per_length) {
    const double length = line_length(context.model, bead);
    if (length == 0) return "";
    const UnitSystem& units = context.deck.work_units();
    return quantity(force_per_length * length, units, force_dimension) + " over " +
           quantity(length, units, length_dimension);
}

void measure_force(const RuleContext& context, const Drawbead& bead, std::string name,
                   double force_per_length, Draft& draft) {
    const double length = line_length(context.model, bead);
    if (length == 0) return;
    draft.measured.push_back(
        {std::move(name), force_per_length * length, unit_name(context.deck.work_units(), force_dimension)});
}

double in_units_of_block(const RuleContext& context, const Drawbead& bead, double force_per_length) {
    const Block& block = context.deck.blocks()[bead.block];
    return force_per_length /
           context.deck.factor(block.scope, block.unit, force_per_length_dimension).value_or(1);
}

std::string lost_include_note(const Deck& deck, std::string_view what) {
    for (const Notice& notice : deck.notices())
        switch (notice.kind) {
        case Notice::Kind::include_missing:
        case Notice::Kind::include_unreadable:
        case Notice::Kind::include_cycle:
        case Notice::Kind::include_too_deep:
        case Notice::Kind::include_outside_root:
            return "an include could not be read; " + std::string(what) + " may be defined there";
        default:
            break;
        }
    return "";
}

void note_lost_include(const RuleContext& context, std::string_view what, Draft& draft) {
    if (std::string note = lost_include_note(context.deck, what); !note.empty())
        draft.notes.push_back(std::move(note));
}

const Block* BlockFinder::at(const Span& place) {
    const auto before = [](const Span& a, const Span& b) {
        return std::pair(a.file, a.begin) < std::pair(b.file, b.begin);
    };
    if (blocks_.empty()) {
        for (const Block& block : deck_.blocks())
            blocks_.push_back(&block);
        std::stable_sort(blocks_.begin(), blocks_.end(),
                         [&](const Block* a, const Block* b) { return before(a->header, b->header); });
    }
    const auto after =
        std::upper_bound(blocks_.begin(), blocks_.end(), place,
                         [&](const Span& p, const Block* block) { return before(p, block->header); });
    if (after == blocks_.begin()) return nullptr;
    const Block* block = *(after - 1);
    return block->header.file == place.file && place.begin <= block->text.end ? block : nullptr;
}

bool concerns_drawbeads(const Block& block) {
    const std::string_view keyword = block.keyword;
    for (const std::string_view start : {"INTER/TYPE8", "GRNOD", "SURF", "SET", "NODE"})
        if (keyword.substr(0, start.size()) == start) return true;
    return false;
}

std::string header_name(const Block& block) {
    std::string name = "/" + std::string(block.keyword);
    if (block.id_given) name += "/" + std::to_string(block.id);
    return name;
}

std::vector<std::string_view> hidden_by_cards() {
    return {"SYN", "REF", "LIN", "SRF", "PAR", "STB", "KIN", "CTX", "ENG"};
}

const Drawbead* drawbead_of(const RuleContext& context, const Draft& draft) {
    const Drawbead* first = nullptr;
    for (const Drawbead& bead : context.model.drawbeads()) {
        if (draft.interface_id != bead.id) continue;
        if (!first) first = &bead;
        // Several may have one id: the finding is about the one in which it stands.
        const Block& block = context.deck.blocks()[bead.block];
        const Span& at = draft.primary;
        if (at.file == block.header.file && at.begin >= block.header.begin && at.begin < block.text.end)
            return &bead;
    }
    return first;
}

std::optional<Fix> write_iform_2(const RuleContext& context, const Draft& draft, FixPlanner& planner) {
    const Drawbead* bead = drawbead_of(context, draft);
    if (!bead) return planner.decline("the interface is not known");
    planner.cells().set_cell(bead->cards[0], "Iform", "2");
    return Fix{iform_2_title, FixAvailability::unsafe, {{bead->id, 0, 0}}};
}

std::optional<Fix> write_positive(const RuleContext& context, const Draft& draft, FixPlanner& planner) {
    const Drawbead* bead = drawbead_of(context, draft);
    if (!bead) return planner.decline("the interface is not known");
    for (const Card& card : bead->cards) {
        const Cell& cell = card[draft.discriminator];
        if (!cell.given() || !(cell.real < 0)) continue;
        // The author's digits, where the minus sign stands before them.
        const bool plain = cell.state == CellState::ok && cell.text.size() > 1 && cell.text[0] == '-';
        planner.cells().set_cell(card, draft.discriminator,
                                 plain ? std::string(cell.text.substr(1)) : real_text(-cell.real));
        return Fix{positive_title, FixAvailability::unsafe, {{bead->id, 0, 0}}};
    }
    return planner.decline("the number is not negative as it is written");
}

void set_places(Draft& draft, const std::vector<Span>& places) {
    if (places.empty()) return;
    draft.primary = places.front();
    draft.related.assign(places.begin() + 1, places.begin() + static_cast<std::ptrdiff_t>(
                                                                  std::min<std::size_t>(places.size(), 100)));
    draft.place_count = places.size();
}

} // namespace drawbead
