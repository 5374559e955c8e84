#include "fix/surface_repair.h"

#include "model/cards/lists.h"
#include "model/cards/type8.h"
#include "model/members.h"
#include "model/sets.h"
#include "model/users.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace drawbead {

namespace {

bool is_triangle(const Segment& s) {
    return s.n[2] == s.n[3];
}

/// What the list of a surface names: "PART" of "PART/EXT".
std::string_view list_kind(const Surface& surface) {
    return std::string_view(surface.type).substr(0, surface.type.find('/'));
}

/// Lists in which a minus sign is known to turn what it names.
bool is_element_list(const Surface& surface) {
    static constexpr std::string_view kinds[] = {"PART",   "SUBSET", "MAT",   "PROP",
                                                 "GRSHEL", "GRSH3N", "GRTRIA"};
    return std::find(std::begin(kinds), std::end(kinds), list_kind(surface)) != std::end(kinds);
}

/// Lines of segments are turned 4321, as the Starter does with the faces of solids; elements keep their first
/// node (1432), at which their own axes begin.
enum class TurnedLine { segment, element };

/// Which old cell comes to each place. `nodes`: 3 without a fourth node; `repeated`: the fourth is the third.
std::vector<std::size_t> turned_order(TurnedLine what, std::size_t nodes, bool repeated) {
    const bool segment = what == TurnedLine::segment;
    if (nodes == 3) return segment ? std::vector<std::size_t>{2, 1, 0} : std::vector<std::size_t>{0, 2, 1};
    if (repeated)
        return segment ? std::vector<std::size_t>{2, 1, 0, 0} : std::vector<std::size_t>{0, 2, 1, 1};
    return segment ? std::vector<std::size_t>{3, 2, 1, 0} : std::vector<std::size_t>{0, 3, 2, 1};
}

/// Turns a line of cells: id, then up to `most` node ids. The text of the cells is moved as it is, and a
/// triangle keeps the form in which its third node is written.
void turn_line(const Deck& deck, ScopeId scope, const Span& line, std::size_t most, TurnedLine what,
               CellEditor& cells) {
    const std::string_view text = deck.text(line);
    constexpr const char* too_few = "a line of segments has fewer than three nodes";
    if (text.find(',') != std::string_view::npos) {
        const Card card = read_card(deck, scope, line, segment_card);
        std::vector<Cell> node;
        for (const Cell& cell : card.cells)
            if (cell.state != CellState::absent) node.push_back(cell);
        node.erase(node.begin());
        node.resize(std::min(node.size(), most));
        while (!node.empty() && (!node.back().given() || node.back().integer == 0))
            node.pop_back();
        if (node.size() < 3) return cells.fail(too_few);
        const auto order = turned_order(what, node.size(), node.size() == 4 && node[3].text == node[2].text);
        for (std::size_t i = 0; i < node.size(); ++i)
            if (order[i] != i) cells.replace(node[i].place, std::string(node[order[i]].text));
        return;
    }
    const std::size_t width = deck.scope(scope).layout < 45 ? 8 : 10;
    std::array<std::string, 4> cell;
    std::size_t end = width;
    for (std::size_t i = 0; i < most; ++i) {
        const std::size_t begin = width * (i + 1);
        if (begin >= text.size()) break;
        cell[i] = text.substr(begin, width);
        end = begin + cell[i].size();
        cell[i].resize(width, ' ');
    }
    if (trim(cell[2]).empty()) return cells.fail(too_few);
    const std::string_view fourth = trim(cell[3]);
    const auto order = turned_order(what, fourth.empty() || fourth == "0" ? 3 : 4, fourth == trim(cell[2]));
    std::string now;
    for (const std::size_t from : order)
        now += cell[from];
    if (order.size() == 3) now += cell[3];
    // A line that ends inside its last cell ends there again, unless a node stands behind.
    const std::size_t length = end - width;
    if (now.size() > length) now.erase(std::max(length, now.find_last_not_of(' ') + 1));
    cells.replace({line.file, line.begin + width, line.begin + end}, std::move(now));
}

/// What is turned for one group of beads, sorted out.
struct Turned {
    std::vector<bool> segment; ///< by segment: turn it
    uint64_t count = 0;        ///< of turned ones
    uint64_t lines = 0, elements = 0;
    bool all = false;          ///< everything that the Starter does not turn itself
    bool all_elements = false; ///< … of what is made from elements
};

class SurfaceRepair {
public:
    SurfaceRepair(const Model& model, uint32_t surface, const std::vector<BeadVotes>& votes,
                  FixPlanner& planner)
        : model_(model), deck_(model.deck()), surface_(model.surfaces()[surface]), votes_(votes),
          planner_(planner), block_(deck_.blocks()[surface_.block]) {}

    std::optional<Fix> make() {
        if (!surface_.evaluated)
            return planner_.decline("surface " + std::to_string(surface_.id) + " could not be expanded");
        const SegmentTurns turns = find_turns(surface_.segments, model_.nodes().size(), votes_);
        if (turns.groups.empty()) return planner_.decline("the side of its beads cannot be told");
        const bool outside = !surface_.users.empty() || !turns.undecided.empty();
        planner_.claim(surface_.block);
        bool any = false, kept = false; // `kept`: a group has the surface for itself
        for (const TurnGroup& group : turns.groups) {
            for (const uint32_t b : group.beads)
                planner_.claim(votes_[b].block);
            if (group.segments.empty()) {
                kept = true;
                continue;
            }
            any = true;
            const Turned turned = sort_out(group);
            const bool by_elements =
                planner_.choices().normals == NormalsMode::elements ||
                (planner_.choices().unsafe && !fits_signed_groups() && !turned.all_elements);
            if (by_elements && turns.groups.size() == 1) {
                turn_elements(turned);
            } else if (kept || outside || !turn_in_place(turned)) {
                own_surface(group, turned);
            } else {
                kept = true;
            }
            if (planner_.failed()) return std::nullopt;
            for (const uint32_t b : group.beads)
                fix_.changes.push_back({votes_[b].bead, turned.count, 0});
        }
        if (!any) {
            return planner_.decline(turns.undecided.empty()
                                        ? "no bead tells the side of the segments that disagree"
                                        : "the side of the segments cannot be told from the beads");
        }
        if (turns.groups.size() > 1 && kept) fix_.title = "a second, reversed surface";
        return std::move(fix_);
    }

private:
    Turned sort_out(const TurnGroup& group) const {
        Turned t;
        t.segment.assign(surface_.segments.size(), false);
        t.count = group.segments.size();
        for (const uint32_t s : group.segments) {
            t.segment[s] = true;
            ++(s < surface_.lines.size() ? t.lines : t.elements);
        }
        uint64_t lines = 0, elements = 0;
        for (uint32_t s = 0; s < surface_.segments.size(); ++s)
            if (!surface_.segments[s].solid_backed) ++(s < surface_.lines.size() ? lines : elements);
        t.all = t.count == lines + elements;
        t.all_elements = t.elements == elements && elements > 0;
        return t;
    }

    // ---- changes where the surface stands

    /// False when there is no edit of the surface itself that turns these segments and no others.
    bool turn_in_place(const Turned& t) {
        if (surface_.type == "SEG") return turn_lines(t);
        if (surface_.type == "SET") return t.all && surface_.lines.empty() && turn_clauses();
        if (surface_.type == "SURF") {
            if (t.elements == 0 && lines_are_free()) return turn_lines(t);
            // A minus sign writes 4321, which makes a warning of every triangle.
            if (t.all && !any_triangle()) return turn_signs([](const SurfaceSource&) { return true; });
            return false;
        }
        if (!is_element_list(surface_) || (surface_.sources.size() == 1 && !t.all_elements)) return false;
        if (t.all_elements) return turn_signs([](const SurfaceSource&) { return true; });
        if (list_kind(surface_) == "PART") return turn_parts(t);
        if (list_kind(surface_).substr(0, 2) == "GR") return turn_groups(t);
        return false;
    }

    bool turn_lines(const Turned& t) {
        if (!lines_are_free()) return false;
        for (std::size_t s = 0; s < surface_.lines.size(); ++s)
            if (t.segment[s])
                turn_line(deck_, scope_of_line(surface_.lines[s]), surface_.lines[s], 4, TurnedLine::segment,
                          planner_.cells());
        fix_.title = "these segment lines turned (4321)";
        return true;
    }

    template <class Wanted>
    bool turn_signs(const Wanted& wanted) {
        for (const SurfaceSource& source : surface_.sources)
            if (wanted(source)) planner_.cells().set_listed_id(block_.scope, source.place, -written(source));
        fix_.title = "reversed sign in the surface";
        return true;
    }

    /// Whole parts, each listed once.
    bool turn_parts(const Turned& t) {
        std::map<int64_t, std::array<uint64_t, 2>> parts; // segments that stay, that turn
        for (uint32_t s = 0; s < surface_.segments.size(); ++s)
            if (const Part* part = model_.part_of(surface_.segments[s]);
                part && !surface_.segments[s].solid_backed)
                ++parts[part->id][t.segment[s]];
        std::map<int64_t, int> listed;
        for (const SurfaceSource& source : surface_.sources)
            ++listed[std::abs(source.id)];
        for (const auto& [id, count] : parts)
            if ((count[0] > 0 && count[1] > 0) || (count[1] > 0 && listed[id] != 1)) return false;
        return turn_signs([&](const SurfaceSource& source) {
            const auto at = parts.find(std::abs(source.id));
            return at != parts.end() && at->second[1] > 0;
        });
    }

    /// Whole groups of listed elements, of which no two share an element.
    bool turn_groups(const Turned& t) {
        struct Element {
            int64_t id;
            bool turned, seen;
        };
        std::vector<Element> elements;
        elements.reserve(surface_.segments.size());
        for (uint32_t s = 0; s < surface_.segments.size(); ++s)
            elements.push_back({value(model_.element_id(surface_.segments[s])), t.segment[s], false});
        std::sort(elements.begin(), elements.end(),
                  [](const Element& a, const Element& b) { return a.id < b.id; });
        const Family family = list_kind(surface_) == "GRSHEL" ? Family::shell_group : Family::sh3n_group;
        std::map<int64_t, bool> turn; // by group id
        IssueLog unreported;
        for (const SurfaceSource& source : surface_.sources) {
            const int64_t id = std::abs(source.id);
            const auto group = planner_.options().find(family, id);
            if (!group || turn.count(id) != 0) return false;
            std::array<bool, 2> found{};
            for (const Member& member : read_membership(deck_, *group, unreported).members) {
                if ((member.kind != MemberKind::shell && member.kind != MemberKind::sh3n) || member.minus ||
                    member.first != member.last)
                    return false;
                const auto element =
                    std::lower_bound(elements.begin(), elements.end(), member.first,
                                     [](const Element& e, int64_t wanted) { return e.id < wanted; });
                if (element == elements.end() || element->id != member.first) continue;
                if (std::exchange(element->seen, true)) return false;
                found[element->turned] = true;
            }
            if (found[0] && found[1]) return false;
            turn[id] = found[1];
        }
        return turn_signs([&](const SurfaceSource& source) { return turn[std::abs(source.id)]; });
    }

    /// Adds or takes away `_O` on every clause of a set.
    bool turn_clauses() {
        struct Change {
            Span line;
            uint32_t column;
            std::string key;
            bool was_reversed;
            std::optional<Span> free; ///< the key where commas cut the line
        };
        std::vector<Change> changes;
        for (const SurfaceSource& source : surface_.sources) {
            const std::string_view key = deck_.text(source.place);
            const std::string name(key.substr(0, key.find('_')));
            if (name == "NODE" || name == "NODENS") continue; // says nothing of segments
            const bool plain = key == name, reversed = key == name + "_O";
            const SourceFile& file = deck_.file(source.place.file);
            const uint64_t begin = file.line_begin(source.place.begin);
            const Span line{source.place.file, begin, begin + file.line_at(begin).size()};
            const auto column = static_cast<uint32_t>(source.place.begin - begin) + 1;
            if ((!plain && !reversed) || column + name.size() + 1 > 10) return false;
            const bool free = deck_.text(line).find(',') != std::string_view::npos;
            changes.push_back(
                {line, column, name, reversed, free ? std::optional(source.place) : std::nullopt});
        }
        for (const Change& c : changes)
            if (c.free)
                planner_.cells().replace(*c.free, c.key + (c.was_reversed ? "" : "_O"));
            else
                planner_.cells().set_columns(c.line, c.column, static_cast<uint32_t>(c.key.size()) + 2,
                                             c.key + (c.was_reversed ? "  " : "_O"));
        fix_.title = "clauses of the set reversed";
        return true;
    }

    void turn_elements(const Turned& t) {
        if (t.lines > 0 && !turn_lines(t))
            return planner_.cells().fail("its segment lines are used by another surface");
        RowLines quads(deck_, model_.shells4().pieces), triangles(deck_, model_.shells3().pieces);
        for (uint32_t s = static_cast<uint32_t>(surface_.lines.size()); s < surface_.segments.size(); ++s) {
            const Segment& segment = surface_.segments[s];
            if (!t.segment[s]) continue;
            if (segment.kind != ElementKind::shell4 && segment.kind != ElementKind::shell3)
                return planner_.cells().fail("some of the segments are no shells");
            const bool quad = segment.kind == ElementKind::shell4;
            const Span line = (quad ? quads : triangles).line(segment.element);
            turn_line(deck_, scope_of_line(line), line, quad ? 4 : 3, TurnedLine::element, planner_.cells());
        }
        fix_.title = "nodes of elements in reverse order";
        if (planner_.choices().normals != NormalsMode::elements) fix_.applicability = FixAvailability::unsafe;
    }

    // ---- a surface of the beads' own

    void own_surface(const TurnGroup& group, const Turned& t) {
        served_ = surface_.block;
        const int64_t offset = deck_.scope(block_.scope).offsets.general;
        const int64_t id = planner_.free_id(Family::surface, served_);
        if (planner_.failed()) return;
        const std::string title =
            "surface " + std::to_string(surface_.id) + " as bead " + bead_list(group) + " sees it";
        const bool copied = t.all && copy_reversed(id, title);
        if (!copied && !signed_groups(id, title, t)) return;
        for (const uint32_t b : group.beads) {
            const Drawbead* bead = find_bead(votes_[b].block);
            const Scope& scope = deck_.scope(deck_.blocks()[bead->block].scope);
            const int64_t there = id + offset - scope.offsets.general;
            if (there < 1) return planner_.cells().fail("the new surface cannot be named in its submodel");
            planner_.cells().set_cell(bead->cards[0], "surf_IDm", std::to_string(there));
        }
        if (fix_.title.empty())
            fix_.title = copied ? "a reversed surface of its own" : "signed groups in a surface of its own";
    }

    /// The same list with other signs, or the same lines the other way round.
    bool copy_reversed(int64_t id, const std::string& title) {
        if (surface_.type == "SEG") return false;
        const bool surfaces = surface_.type == "SURF" && !any_triangle();
        if (!surfaces && !is_element_list(surface_)) return false;
        std::vector<int64_t> ids;
        for (const SurfaceSource& source : surface_.sources)
            ids.push_back(-written(source));
        BlockWriter block(deck_, served_);
        block.header("SURF/" + surface_.type, id, title);
        block.ids(ids);
        planner_.add_after(served_, block.text());
        return true;
    }

    /// Elements by groups with signs and SEG lines as they are to look, joined where they are of several
    /// kinds.
    bool signed_groups(int64_t id, const std::string& title, const Turned& t) {
        if (!fits_signed_groups()) {
            planner_.decline("a surface with faces of solids cannot be turned in part");
            return false;
        }
        struct Lists {
            std::vector<int64_t> plus, minus;
        };
        Lists quads, triangles;
        const int64_t offset = deck_.scope(block_.scope).offsets.element;
        for (uint32_t s = static_cast<uint32_t>(surface_.lines.size()); s < surface_.segments.size(); ++s) {
            const Segment& segment = surface_.segments[s];
            const int64_t element = int64_t{value(model_.element_id(segment))} - offset;
            if (element < 1) {
                planner_.decline("its elements cannot be named inside the submodel of the surface");
                return false;
            }
            Lists& lists = segment.kind == ElementKind::shell4 ? quads : triangles;
            const bool minus = (segment.sense < 0) != t.segment[s];
            (minus ? lists.minus : lists.plus).push_back(element);
        }
        std::vector<int64_t> parts; // ids of the surfaces that make up the new one
        std::string text;
        const int kinds = int{!surface_.lines.empty()} + int{!quads.plus.empty() || !quads.minus.empty()} +
                          int{!triangles.plus.empty() || !triangles.minus.empty()};
        const auto part_id = [&] {
            parts.push_back(kinds == 1 ? id : planner_.free_id(Family::surface, served_));
            return parts.back();
        };
        if (!surface_.lines.empty()) {
            const int64_t own = part_id();
            text += copied_lines(own, title, t);
        }
        const auto write = [&](Lists& lists, Family family, std::string_view group, std::string_view type) {
            if (lists.plus.empty() && lists.minus.empty()) return;
            std::vector<int64_t> ids;
            for (std::vector<int64_t>* list : {&lists.plus, &lists.minus}) {
                if (list->empty()) continue;
                if (!std::is_sorted(list->begin(), list->end())) std::sort(list->begin(), list->end());
                if (std::adjacent_find(list->begin(), list->end()) != list->end())
                    return planner_.cells().fail("the surface holds an element twice");
                const bool minus = list == &lists.minus;
                const int64_t group_id = planner_.free_id(family, served_);
                ids.push_back(minus ? -group_id : group_id);
                BlockWriter block(deck_, served_);
                block.header(group, group_id, title.substr(0, 80) + (minus ? ": turned" : ": not turned"));
                block.ids(*list);
                text += block.text();
            }
            BlockWriter block(deck_, served_);
            block.header("SURF/" + std::string(type), part_id(), title);
            block.ids(ids);
            text += block.text();
        };
        write(quads, Family::shell_group, "GRSHEL/SHEL", "GRSHEL");
        write(triangles, Family::sh3n_group, "GRSH3N/SH3N", "GRSH3N");
        if (kinds > 1) {
            BlockWriter block(deck_, served_);
            block.header("SURF/SURF", id, title);
            block.ids(parts);
            text += block.text();
        }
        if (planner_.failed()) return false;
        planner_.add_after(served_, text);
        return true;
    }

    std::string copied_lines(int64_t id, const std::string& title, const Turned& t) {
        BlockWriter block(deck_, served_);
        block.header("SURF/SEG", id, title);
        const int64_t offset = deck_.scope(block_.scope).offsets.node;
        const uint32_t width = block.id_width();
        for (std::size_t s = 0; s < surface_.lines.size(); ++s) {
            const Segment& segment = surface_.segments[s];
            std::array<NodeRow, 4> n = segment.n;
            // What the Starter turns itself is written in any order.
            if (t.segment[s]) {
                if (is_triangle(segment))
                    n = {n[2], n[1], n[0], n[0]};
                else
                    std::reverse(n.begin(), n.end());
            }
            std::string line;
            const auto put = [&](int64_t number) {
                const std::string text = std::to_string(number);
                if (number < 1 || text.size() > width)
                    planner_.cells().fail("its nodes cannot be named inside the submodel of the surface");
                line += std::string(width - std::min<std::size_t>(text.size(), width), ' ') + text;
            };
            put(static_cast<int64_t>(s) + 1);
            for (std::size_t k = 0; k < 4; ++k)
                put(int64_t{value(model_.nodes().user_id(n[k]))} - offset);
            block.line(line);
        }
        return block.text();
    }

    // ---- what the surface is made of

    bool fits_signed_groups() const { return surface_.type != "DSURF" && !has_solid_faces(surface_); }

    int64_t written(const SurfaceSource& source) const {
        using Kind = SurfaceSource::Kind;
        const Offsets& offsets = deck_.scope(block_.scope).offsets;
        const int64_t offset = source.kind == Kind::part       ? offsets.part
                               : source.kind == Kind::material ? offsets.material
                               : source.kind == Kind::property ? offsets.property
                                                               : offsets.general;
        return Deck::global_id(source.id, -offset);
    }

    /// Whether a 4321 of a segment is no segment as the solver wants it.
    bool any_triangle() const {
        return std::any_of(surface_.segments.begin(), surface_.segments.end(),
                           [](const Segment& s) { return is_triangle(s); });
    }

    /// Whether nobody but this surface uses the blocks that its SEG lines stand in.
    bool lines_are_free() {
        if (surface_.type == "SEG") return true;
        if (surface_.type != "SURF") return false;
        for (const SurfaceSource& source : surface_.sources) {
            const auto block = planner_.options().find(Family::surface, std::abs(source.id));
            if (!block) return false;
            if (deck_.blocks()[*block].keyword != "SURF/SEG") {
                if (deck_.blocks()[*block].keyword == "SURF/SURF") return false; // lines further down
                continue;
            }
            std::vector<NodeGroup> none;
            std::vector<Surface> one(1);
            one[0].id = std::abs(source.id);
            one[0].block = *block;
            find_users(deck_, planner_.options(), none, one);
            for (const BlockIndex user : one[0].users)
                if (user != surface_.block) return false;
            for (const Surface& other : model_.surfaces())
                if (other.block == *block) return false;
            planner_.claim(*block);
        }
        return true;
    }

    ScopeId scope_of_line(const Span& line) {
        if (last_ && holds(*last_, line)) return last_->scope;
        for (const Block& block : deck_.blocks())
            if (holds(block, line)) {
                last_ = &block;
                return block.scope;
            }
        return block_.scope;
    }
    static bool holds(const Block& block, const Span& line) {
        return block.text.file == line.file && block.text.begin <= line.begin && line.begin < block.text.end;
    }

    const Drawbead* find_bead(BlockIndex block) const {
        for (const Drawbead& bead : model_.drawbeads())
            if (bead.block == block) return &bead;
        return nullptr;
    }

    std::string bead_list(const TurnGroup& group) const {
        std::string text;
        for (std::size_t i = 0; i < group.beads.size() && i < 4; ++i)
            text += (i ? ", " : "") + std::to_string(votes_[group.beads[i]].bead);
        if (group.beads.size() > 4) text += " ...";
        return text;
    }

    const Model& model_;
    const Deck& deck_;
    const Surface& surface_;
    const std::vector<BeadVotes>& votes_;
    FixPlanner& planner_;
    const Block& block_;
    BlockIndex served_ = 0;
    const Block* last_ = nullptr; ///< that a line was found in
    Fix fix_;
};

} // namespace

std::optional<Fix> repair_surface(const Model& model, uint32_t surface, const std::vector<BeadVotes>& votes,
                                  FixPlanner& planner) {
    return SurfaceRepair(model, surface, votes, planner).make();
}

bool has_solid_faces(const Surface& surface) {
    // They stand behind everything else.
    return surface.segments.size() > surface.lines.size() &&
           surface.segments[surface.segments.size() - 1].kind == ElementKind::solid;
}

} // namespace drawbead
