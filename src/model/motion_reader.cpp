#include "model/motion_reader.h"

#include "model/cards/motion.h"
#include "model/cards/options.h"
#include "model/drawbead_reader.h"
#include "model/option_reader.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace drawbead {

namespace {

using Condition = MotionCondition;

/// Functions by id, each read when it is first asked for.
class Functions {
public:
    Functions(const Deck& deck, IssueLog& issues) : deck_(deck), issues_(issues) {
        const auto blocks = deck.blocks();
        for (BlockIndex i = 0; i < blocks.size(); ++i) {
            const int64_t id = Deck::global_id(blocks[i].id, deck.scope(blocks[i].scope).offsets.general);
            if (blocks[i].keyword == "FUNCT") block_.emplace(id, i);
            if (blocks[i].keyword == "MOVE_FUNCT") moved_.emplace(id, i);
        }
    }

    uint32_t index_of(int64_t id) {
        const auto [known, is_new] = index_.emplace(id, static_cast<uint32_t>(functions_.size()));
        if (is_new) functions_.push_back(read(id));
        return known->second;
    }

    std::vector<MotionFunction> take() { return std::move(functions_); }

private:
    MotionFunction read(int64_t id) {
        MotionFunction f;
        f.id = id;
        const std::string name = "/FUNCT/" + std::to_string(id);
        const auto block = block_.find(id);
        if (block == block_.end()) {
            f.unusable = name + " is not defined";
            return f;
        }
        OptionReader reader(deck_, block->second, issues_);
        DataLines lines(deck_, list_text(deck_, reader.block()));
        for (Span line; lines.next_filled(line);) {
            const Card card = read_card(deck_, reader.block().scope, line, function_card);
            issues_.check(card);
            f.x.push_back(card["X"].real);
            f.y.push_back(card["Y"].real);
        }
        if (moved_.count(id) > 0)
            f.unusable = name + " is changed by a /MOVE_FUNCT, which is not read";
        else if (f.x.size() < 2)
            f.unusable = name + " has fewer than two points";
        else if (std::adjacent_find(f.x.begin(), f.x.end(), [](double a, double b) { return !(a < b); }) !=
                 f.x.end())
            f.unusable = "the abscissae of " + name + " do not increase";
        return f;
    }

    const Deck& deck_;
    IssueLog& issues_;
    std::map<int64_t, BlockIndex> block_, moved_;
    std::map<int64_t, uint32_t> index_;
    std::vector<MotionFunction> functions_;
};

class MotionReader {
public:
    MotionReader(const Deck& deck, const OptionIndex& index, IssueLog& issues)
        : deck_(deck), index_(index), issues_(issues), functions_(deck, issues) {}

    MotionOptions read_loads() {
        const auto blocks = deck_.blocks();
        for (BlockIndex i = 0; i < blocks.size(); ++i)
            if (blocks[i].keyword == "RBODY")
                rigid_body(i);
            else if (blocks[i].keyword == "CLOAD")
                load(i);
        return {functions_.take(), std::move(conditions_), 0};
    }

    MotionOptions read() {
        const auto blocks = deck_.blocks();
        for (BlockIndex i = 0; i < blocks.size(); ++i) {
            const std::string_view keyword = blocks[i].keyword;
            const bool plain = subtype(keyword).empty() || subtype(keyword) == "LAGMUL";
            if (is_option(keyword, "BCS") && plain)
                boundary_condition(i);
            else if (is_option(keyword, "IMPVEL") && plain)
                imposed(i, Condition::Kind::velocity, imposed_velocity_card);
            else if (is_option(keyword, "IMPDISP") && plain)
                imposed(i, Condition::Kind::displacement, imposed_displacement_card);
            else if (keyword == "INIVEL/TRA" || keyword == "INIVEL/T+G")
                initial_velocity(i);
            else if (keyword == "INIVEL/ROT" || keyword == "INIVEL/AXIS")
                initial_unread(i);
            else if (keyword == "CLOAD")
                load(i);
            else if (keyword == "RBODY")
                rigid_body(i);
            else
                other(i);
        }
        return {functions_.take(), std::move(conditions_), 0};
    }

private:
    GroupCondition& add(BlockIndex block, Condition::Kind kind, OptionReader& reader, const Card& card) {
        GroupCondition& one = conditions_.emplace_back();
        one.condition.kind = kind;
        one.condition.block = block;
        one.condition.id = Deck::global_id(deck_.blocks()[block].id, reader.scope().offsets.general);
        one.group =
            find_node_group(index_, reader.reference(card, "grnd_ID", reader.scope().offsets.general));
        return one;
    }

    static void refuse(Condition& condition, std::string why) {
        condition.kind = Condition::Kind::unknown;
        condition.why = std::move(why);
    }

    /// 0 stands for 1 in the units of the option.
    static void take_scales(OptionReader& reader, const Card& card, Dimension of_values,
                            Condition& condition) {
        const auto factor_of = [&](std::string_view field, Dimension dimension) {
            const double value = reader.real(card, field);
            return value != 0 ? value : reader.factor(dimension);
        };
        condition.time_scale = factor_of("Ascale_x", time_dimension);
        condition.scale = factor_of("Fscale_Y", of_values);
    }

    /// False: none of X, Y, Z, XX, YY, ZZ.
    static bool take_direction(std::string_view direction, Condition& condition) {
        static constexpr std::string_view axes[]{"X", "Y", "Z"}, turns[]{"XX", "YY", "ZZ"};
        bool known = false;
        for (std::size_t k = 0; k < 3; ++k) {
            condition.translation[k] = direction == axes[k];
            condition.rotation[k] = direction == turns[k];
            known = known || condition.translation[k] || condition.rotation[k];
        }
        return known;
    }

    void boundary_condition(BlockIndex block) {
        OptionReader reader(deck_, block, issues_);
        const Card card = reader.card(bcs_card);
        if (!card.present) return;
        Condition& condition = add(block, Condition::Kind::fixed, reader, card).condition;
        static constexpr std::string_view translations[]{"Tx", "Ty", "Tz"}, rotations[]{"Rx", "Ry", "Rz"};
        for (std::size_t k = 0; k < 3; ++k) {
            condition.translation[k] = card[translations[k]].integer == 1;
            condition.rotation[k] = card[rotations[k]].integer == 1;
        }
        // All or nothing is the same in every skew.
        const auto mixed = [](const std::array<bool, 3>& held) {
            return held[0] != held[1] || held[1] != held[2];
        };
        if (card["skew_ID"].integer != 0 && (mixed(condition.translation) || mixed(condition.rotation)))
            refuse(condition, "directions of a skew are not read");
    }

    void imposed(BlockIndex block, Condition::Kind kind, const CardSchema& scales) {
        OptionReader reader(deck_, block, issues_);
        const Card card = reader.card(imposed_first_card);
        if (!card.present) return;
        const Card scale = reader.card(scales);
        Condition& condition = add(block, kind, reader, card).condition;
        take_scales(reader, scale, scales.fields[1].dimension, condition);
        condition.t_start = reader.real(scale, "Tstart");
        if (const double stop = reader.real(scale, "Tstop"); stop != 0) condition.t_stop = stop;
        condition.sensor = card["sensor_ID"].integer;
        condition.function =
            functions_.index_of(reader.reference(card, "funct_IDT", reader.scope().offsets.general));
        const std::string_view direction = card["Dir"].text;
        if (!take_direction(direction, condition))
            refuse(condition, "direction '" + std::string(direction) + "' is not read");
        else if (card["skew_ID"].integer != 0 || card["frame_ID"].integer != 0)
            refuse(condition, "directions of a skew or frame are not read");
        else if (std::find(condition.rotation.begin(), condition.rotation.end(), true) !=
                 condition.rotation.end())
            refuse(condition, "imposed rotations are not read");
    }

    void initial_velocity(BlockIndex block) {
        OptionReader reader(deck_, block, issues_);
        const Card card = reader.card(initial_velocity_card);
        if (!card.present) return;
        Condition& condition = add(block, Condition::Kind::initial_velocity, reader, card).condition;
        condition.velocity = {reader.real(card, "Vx"), reader.real(card, "Vy"), reader.real(card, "Vz")};
        if (card["skew_ID"].integer != 0) refuse(condition, "directions of a skew are not read");
    }

    void initial_unread(BlockIndex block) {
        OptionReader reader(deck_, block, issues_);
        const bool about_axis = reader.block().keyword == "INIVEL/AXIS";
        const Card card = reader.card(about_axis ? initial_axis_card : initial_velocity_card);
        if (!card.present) return;
        Condition& condition = add(block, Condition::Kind::initial_unread, reader, card).condition;
        condition.why = "initial rotations are not read; the first cycle counts as if there were none";
    }

    void load(BlockIndex block) {
        OptionReader reader(deck_, block, issues_);
        const Card card = reader.card(load_card);
        if (!card.present) return;
        Condition& condition = add(block, Condition::Kind::load, reader, card).condition;
        take_scales(reader, card, force_dimension, condition);
        condition.sensor = card["sensor_ID"].integer;
        condition.function =
            functions_.index_of(reader.reference(card, "funct_IDT", reader.scope().offsets.general));
        take_direction(card["Dir"].text, condition);
        // As functions of something else than time they are no force that is known.
        if (card["skew_ID"].integer != 0)
            condition.why = "directions of a skew are not read";
        else if (card["Itypfun"].integer > 1)
            condition.why = "its function is not one of time";
    }

    void rigid_body(BlockIndex block) {
        OptionReader reader(deck_, block, issues_);
        const Card card = reader.card(rigid_body_card);
        if (!card.present) return;
        GroupCondition& one = add(block, Condition::Kind::rigid_body, reader, card);
        one.condition.sensor = card["sens_ID"].integer;
        one.nodes.push_back(reader.reference(card, "node_ID", reader.scope().offsets.node));
    }

    /// What holds nodes in ways that are not read: enough to know which nodes.
    void other(BlockIndex block) {
        const std::string_view keyword = deck_.blocks()[block].keyword;
        const auto* holder = std::find_if(std::begin(node_holders), std::end(node_holders),
                                          [&](const NodeHolder& h) { return is_option(keyword, h.keyword); });
        if (holder == std::end(node_holders) || keyword != holder->keyword) return;
        OptionReader reader(deck_, block, issues_);
        Span line;
        if (!reader.line(line)) return;
        GroupCondition& one = conditions_.emplace_back();
        one.condition.block = block;
        one.condition.id = Deck::global_id(deck_.blocks()[block].id, reader.scope().offsets.general);
        one.condition.why = "it is not read";
        const auto id_at = [&](uint32_t column, int64_t offset) {
            const Cell cell = read_cell(deck_, reader.block().scope, line, column, 10, Kind::integer);
            return Deck::global_id(cell.integer, offset);
        };
        for (uint32_t n = 0; n < holder->own_nodes; ++n)
            one.nodes.push_back(id_at(10 * n + 1, reader.scope().offsets.node));
        if (holder->group_column)
            one.group = find_node_group(index_, id_at(holder->group_column, reader.scope().offsets.general));
    }

    const Deck& deck_;
    const OptionIndex& index_;
    IssueLog& issues_;
    Functions functions_;
    std::vector<GroupCondition> conditions_;
};

} // namespace

MotionOptions read_motion_options(const Deck& deck, const OptionIndex& index, IssueLog& issues) {
    return MotionReader(deck, index, issues).read();
}

void add_loads(const Deck& deck, const OptionIndex& index, IssueLog& issues, MotionOptions& options) {
    MotionOptions loads = MotionReader(deck, index, issues).read_loads();
    options.functions = std::move(loads.functions);
    options.conditions.insert(options.conditions.end(), std::make_move_iterator(loads.conditions.begin()),
                              std::make_move_iterator(loads.conditions.end()));
}

MotionOptions target_options(const OptionIndex& index, std::span<const MotionTarget> targets,
                             std::span<const Drawbead> beads) {
    MotionOptions out;
    out.targets = targets.size();
    for (uint32_t t = 0; t < targets.size(); ++t) {
        const MotionTarget& target = targets[t];
        GroupCondition one;
        one.condition.kind = MotionCondition::Kind::asked;
        one.condition.function = t;
        const auto refer = [&](MemberKind kind) {
            Member member;
            member.kind = kind;
            member.first = member.last = target.id;
            one.member = member;
        };
        using Target = MotionTarget::Kind;
        switch (target.kind) {
        case Target::node_group:
            one.group = find_node_group(index, target.id);
            if (!one.group) continue;
            break;
        case Target::surface:
            if (!index.find(Family::surface, target.id)) {
                // A set gives a surface too, if a drawbead uses it as one.
                const auto user = std::find_if(beads.begin(), beads.end(), [&](const Drawbead& bead) {
                    return bead.surface && bead.surface_id == target.id;
                });
                if (user == beads.end()) continue;
                one.main_surface = user->surface;
                break;
            }
            refer(MemberKind::surface);
            break;
        case Target::part:
            if (!index.find(Family::part, target.id)) continue;
            refer(MemberKind::part);
            break;
        case Target::bead:
        case Target::main_surface: {
            const auto bead = std::find_if(beads.begin(), beads.end(),
                                           [&](const Drawbead& b) { return b.id == target.id; });
            if (bead == beads.end()) continue;
            (target.kind == Target::bead ? one.bead : one.main_surface) =
                target.kind == Target::bead ? bead->group : bead->surface;
            break;
        }
        }
        out.conditions.push_back(std::move(one));
    }
    return out;
}

DeckMotion find_motion(MotionOptions options, Resolver& resolver, const NodeSet& nodes,
                       const std::function<void(NodeSet&)>& add_surfaces, std::size_t node_count,
                       std::span<const NodeGroup> groups, std::span<const Surface> surfaces) {
    DeckMotion out;
    out.functions = std::move(options.functions);
    out.classes.emplace_back();
    out.of_node = Buffer<uint32_t>::zeroed(node_count);
    out.target_nodes.resize(options.targets);

    NodeSet wanted = nodes;
    for (GroupCondition& one : options.conditions) {
        if (one.condition.kind != MotionCondition::Kind::rigid_body) continue;
        if (const auto main = resolver.row(one.nodes.front())) {
            one.condition.main = *main;
            wanted.insert(*main);
        }
    }
    std::map<BlockIndex, std::vector<NodeRow>> of_group; // one group may serve many conditions
    bool beads_only = true;
    for (const GroupCondition& one : options.conditions) {
        beads_only = beads_only && !one.member && !one.main_surface;
        for (const int64_t id : one.nodes)
            if (const auto node = resolver.row(id)) beads_only = beads_only && wanted.contains(*node);
        if (!one.group || of_group.contains(*one.group)) continue;
        if (!resolver.lists_nodes(*one.group)) {
            beads_only = false;
            continue;
        }
        NodeSet set(node_count);
        resolver.nodes(*one.group, set, nullptr);
        beads_only = beads_only && wanted.contains(set);
        of_group.emplace(*one.group, set.rows());
    }
    if (!beads_only) {
        add_surfaces(wanted);
        for (auto& [group, rows] : of_group)
            std::erase_if(rows, [&](NodeRow node) { return !wanted.contains(node); });
    }

    std::map<std::pair<uint32_t, uint32_t>, uint32_t> next_class;
    for (GroupCondition& one : options.conditions) {
        const auto number = static_cast<uint32_t>(out.conditions.size());
        out.conditions.push_back(std::move(one.condition));
        const MotionCondition& condition = out.conditions.back();
        std::size_t held = 0;
        std::pair<uint32_t, uint32_t> last{0, 0}; // neighbours mostly go from and to the same classes
        const auto act = [&](NodeRow node) {
            uint32_t& at = out.of_node[index(node)];
            if (!out.classes[at].empty() && out.classes[at].back() == number) return;
            ++held;
            if (at == last.first && last.second != 0) {
                at = last.second;
                return;
            }
            const auto [next, is_new] =
                next_class.try_emplace({at, number}, static_cast<uint32_t>(out.classes.size()));
            if (is_new) {
                out.classes.push_back(out.classes[at]);
                out.classes.back().push_back(number);
            }
            last = {at, next->second};
            at = next->second;
        };
        if (one.member) {
            NodeSet set(node_count);
            resolver.member_nodes(*one.member, set, &wanted);
            set.intersect(wanted);
            for (const NodeRow node : set.rows())
                act(node);
        }
        if (one.bead)
            for (const NodeRow node : groups[*one.bead].nodes)
                act(node);
        if (one.main_surface)
            for (const Segment& segment : surfaces[*one.main_surface].segments)
                for (const NodeRow node : segment.n)
                    if (node != no_node) act(node);
        if (one.group) {
            auto known = of_group.find(*one.group);
            if (known == of_group.end()) {
                NodeSet set(node_count);
                resolver.nodes(*one.group, set, &wanted);
                set.intersect(wanted);
                known = of_group.emplace(*one.group, set.rows()).first;
            }
            for (const NodeRow node : known->second)
                if (node != condition.main) act(node); // a rigid body's main node does not follow itself
        }
        if (condition.kind != MotionCondition::Kind::rigid_body)
            for (const int64_t id : one.nodes)
                if (const auto node = resolver.row(id); node && wanted.contains(*node)) act(*node);
        if (condition.kind == MotionCondition::Kind::asked) out.target_nodes[condition.function] = held;
    }
    return out;
}

} // namespace drawbead
