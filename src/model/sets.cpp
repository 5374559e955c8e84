#include "model/sets.h"

#include "model/cards/lists.h"

#include <algorithm>
#include <optional>

namespace drawbead {

namespace {

struct Key {
    std::string_view name;
    std::optional<MemberKind> kind; ///< empty: NODENS, SEG, or nothing that a drawbead could use
    bool supported;
};
constexpr Key keys[] = {
    {"PART", MemberKind::part, true},     {"SUBS", MemberKind::subset, true},
    {"SUBM", MemberKind::submodel, true}, {"SHELL", MemberKind::shell, true},
    {"SH3N", MemberKind::sh3n, true},     {"SOLID", MemberKind::solid, true},
    {"NODE", MemberKind::node, true},     {"SET", MemberKind::set, true},
    {"SETCOL", MemberKind::set, true},    {"ALL", MemberKind::everything, true},
    {"NODENS", std::nullopt, true},       {"SEG", std::nullopt, true},
    {"BOX", MemberKind::box, true},       {"BOX2", MemberKind::box_touching, true},
};

/// Splits "PART_GD" into its name and suffix letters.
void read_key(std::string_view text, SetClause& clause, bool& ranges) {
    const std::size_t underscore = text.find('_');
    const std::string_view name = text.substr(0, underscore);
    clause.key = name;
    if (underscore == std::string_view::npos) return;
    for (const char suffix : text.substr(underscore + 1)) {
        switch (suffix) {
        case 'D':
            clause.remove = true;
            break;
        case 'I':
            clause.intersect = true;
            break;
        case 'O':
            clause.reversed = true;
            break;
        case 'G':
            ranges = true;
            break;
        case 'A':
            clause.all_faces = true;
            break;
        case 'E':
            break; // external faces are the default
        default:
            clause.supported = false; // _B and _C restrict the clause to a box
        }
    }
}

bool begins_with_letter(std::string_view cell) {
    return !cell.empty() && ((cell[0] >= 'A' && cell[0] <= 'Z') || (cell[0] >= 'a' && cell[0] <= 'z'));
}

/// The nine cells [11-100] of a clause line. Triples of `_G` are cut by column: a blank cell is a 0 in them.
void read_clause_cells(const Deck& deck, ScopeId scope, const Span& line, bool ranges, IssueLog& issues,
                       std::vector<WrittenId>& ids) {
    for (const Cell& cell : read_card(deck, scope, line, set_ids_card).cells)
        if ((issues.check(cell, "id") && cell.given()) || ranges) ids.push_back({cell.integer, cell.place});
}

void finish(SetClause& clause, bool ranges, const std::vector<WrittenId>& ids, const Deck& deck) {
    if (clause.key == "NODENS") {
        clause.supported = clause.supported && !ranges; // which order generated nodes have is not known
        if (clause.supported) clause.nodes = ids;
        return;
    }
    if (clause.key == "SEG") return;
    const Key* key =
        std::find_if(std::begin(keys), std::end(keys), [&](const Key& k) { return k.name == clause.key; });
    if (key == std::end(keys)) {
        clause.supported = false;
        return;
    }
    if (*key->kind == MemberKind::everything) {
        Member all;
        all.kind = MemberKind::everything;
        all.place = clause.place;
        clause.members.push_back(all);
        return;
    }
    // Ids of collections are the same inside and outside of submodels.
    const int64_t offset = clause.key == "SETCOL" ? 0 : offset_of(deck.scope(clause.scope), *key->kind);
    const auto add = [&](int64_t first, int64_t last, int64_t step, const Span& place) {
        Member member;
        member.kind = *key->kind;
        member.first = Deck::global_id(first, offset);
        member.last = Deck::global_id(last, offset);
        member.step = step;
        member.place = place;
        clause.members.push_back(member);
    };
    if (!ranges) {
        for (const WrittenId& id : ids)
            if (id.id > 0) add(id.id, id.id, 1, id.place);
        return;
    }
    for (std::size_t i = 0; i + 2 < ids.size(); i += 3) {
        const int64_t step = ids[i + 2].id > 0 ? ids[i + 2].id : 1;
        const int64_t first = ids[i].id == 0 ? step : ids[i].id; // no id is 0
        if (first > 0 && first <= ids[i + 1].id) add(first, ids[i + 1].id, step, ids[i].place);
    }
}

void read_block(const Deck& deck, BlockIndex index, IssueLog& issues, std::vector<SetClause>& clauses) {
    OptionReader reader(deck, index, issues);
    const ScopeId scope = reader.block().scope;
    std::vector<WrittenId> ids;
    bool open = false, ranges = false;
    Span line;
    while (reader.line(line)) {
        const std::string_view text = deck.text(line);
        const std::string_view head = trim(text.substr(0, std::min<std::size_t>(10, text.find(','))));
        if (trim(text).empty()) continue;
        if (begins_with_letter(head)) {
            if (open) finish(clauses.back(), ranges, ids, deck);
            ids.clear();
            ranges = false;
            SetClause clause;
            clause.scope = scope;
            const auto at = line.begin + static_cast<uint64_t>(head.data() - text.data());
            clause.place = {line.file, at, at + head.size()};
            read_key(head, clause, ranges);
            clauses.push_back(std::move(clause));
            open = true;
        }
        if (open && clauses.back().key == "SEG") {
            ListedSegment segment;
            const bool indented = head.empty() || begins_with_letter(head);
            if (begins_with_letter(head) && trim(text.substr(std::min<std::size_t>(10, text.size()))).empty())
                continue;
            if (read_segment(deck, scope, line, indented ? SegmentLine::indented : SegmentLine::plain, issues,
                             segment))
                clauses.back().segments.push_back(segment);
            continue;
        }
        if (open) read_clause_cells(deck, scope, line, ranges, issues, ids);
    }
    if (open) finish(clauses.back(), ranges, ids, deck);
}

} // namespace

std::vector<SetClause> read_set(const Deck& deck, const OptionIndex& index, BlockIndex block,
                                IssueLog& issues) {
    std::vector<SetClause> clauses;
    if (subtype(deck.blocks()[block].keyword) != "COLLECT") {
        read_block(deck, block, issues, clauses);
        return clauses;
    }
    int64_t id = 0;
    for (const Option& option : index.all(Family::set))
        if (option.block == block) id = option.id;
    for (const Option& option : index.all(Family::set))
        if (option.id == id && subtype(deck.blocks()[option.block].keyword) == "COLLECT")
            read_block(deck, option.block, issues, clauses);
    return clauses;
}

bool read_segment(const Deck& deck, ScopeId scope, const Span& line, SegmentLine form, IssueLog& issues,
                  ListedSegment& segment) {
    const Scope& here = deck.scope(scope);
    const int64_t offset = here.offsets.node;
    const auto cut = [](int64_t id) {
        return static_cast<int32_t>(std::clamp<int64_t>(id, -2147483647, 2147483647));
    };
    const bool indented = form == SegmentLine::indented;
    std::string_view text = deck.text(line);
    const bool free_format = text.find(',') != std::string_view::npos;
    if (indented) text = text.substr(std::min<std::size_t>(10, text.size()));
    std::array<int64_t, 5> plain{};
    segment.line = line;
    if (!free_format &&
        read_plain_cells(text, here.layout < 45 && !indented ? 8 : 10, plain.size(), plain.data())) {
        for (std::size_t i = 0; i < 4; ++i)
            segment.node[i] = cut(Deck::global_id(plain[i + 1], offset));
    } else {
        const Card card = read_card(deck, scope, line, indented ? set_segment_card : segment_card);
        static constexpr std::string_view names[] = {"node_ID1", "node_ID2", "node_ID3", "node_ID4"};
        issues.check(card);
        for (std::size_t i = 0; i < 4; ++i)
            segment.node[i] = cut(Deck::global_id(card[names[i]].integer, offset));
    }
    if (segment.node[3] == 0) segment.node[3] = segment.node[2];
    return segment.node[0] != 0 && segment.node[1] != 0 && segment.node[2] != 0;
}

} // namespace drawbead
