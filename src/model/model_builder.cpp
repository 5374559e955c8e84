#include "base/parallel.h"
#include "model/attachments.h"
#include "model/cards/options.h"
#include "model/demand.h"
#include "model/drawbead_reader.h"
#include "model/motion_reader.h"
#include "model/option_reader.h"
#include "model/part_reader.h"
#include "model/transform.h"
#include "model/users.h"

#include <algorithm>
#include <atomic>

namespace drawbead {

/// Builds a model in one pass: options first, then the tables as far as the drawbeads need them, then what
/// refers to table rows.
class ModelBuilder {
public:
    ModelBuilder(const Deck& deck, Needs needs, unsigned threads,
                 std::optional<std::span<const MotionTarget>> targets)
        : deck_(deck), needs_(needs), threads_(threads), targets_(targets), index_(deck, issues_) {
        model_.deck_ = &deck;
    }

    Model build() {
        read_options();
        const PartPicker picker(deck_, index_, model_.parts_, issues_);
        Tables tables = read_tables(deck_, request(picker), threads_);
        expand(picker, tables);
        model_.counts_ = tables.counts;
        model_.nodes_ = std::move(tables.nodes);
        model_.shells4_ = std::move(tables.shells4);
        model_.shells3_ = std::move(tables.shells3);
        model_.solids_ = std::move(tables.solids);
        check_blanks();
        model_.issues_ = issues_.take();
        model_.issues_.insert(model_.issues_.end(), tables.issues.begin(), tables.issues.end());
        return std::move(model_);
    }

private:
    void read_options() {
        model_.parts_ = read_parts(deck_, index_, issues_);
        model_.properties_ = read_properties(deck_, index_, issues_);
        model_.materials_ = read_materials(deck_, index_, issues_);
        const auto number = [](const auto& entities, std::map<int64_t, uint32_t>& rows) {
            for (uint32_t i = 0; i < entities.size(); ++i)
                rows.emplace(entities[i].id, i);
        };
        number(model_.parts_, model_.part_index_);
        number(model_.properties_, model_.property_index_);
        number(model_.materials_, model_.material_index_);
        model_.drawbeads_ = read_drawbeads(deck_, index_, issues_);
        for (BlockIndex i = 0; i < deck_.blocks().size() && !model_.admesh_; ++i)
            if (deck_.blocks()[i].keyword == "ADMESH/GLOBAL") {
                OptionReader reader(deck_, i, issues_, false);
                const Card card = reader.card(admesh_global_card);
                model_.admesh_ = Admesh{i, card["Level"].integer, card["Idt"].integer};
            }
        for (BlockIndex i = 0; i < deck_.blocks().size(); ++i)
            if (deck_.blocks()[i].keyword == "IOFLAG") {
                OptionReader reader(deck_, i, issues_, false);
                model_.ipri_ = reader.card(ioflag_card)["Ipri"].integer;
                break;
            }
        take_references();
        if (with_nodes()) transforms_ = read_transforms(deck_, issues_);
        if (has(needs_, Needs::attachments) && !model_.drawbeads_.empty())
            holders_ = read_holders(deck_, index_, issues_);
        if (with_motion())
            motion_ = targets_ ? target_options(index_, *targets_, model_.drawbeads_)
                               : read_motion_options(deck_, index_, issues_);
        if (with_motion() && targets_) add_loads(deck_, index_, issues_, motion_);
    }

    /// Groups and surfaces that drawbeads use, each once, in the order in which they are first used.
    void take_references() {
        std::map<BlockIndex, uint32_t> groups, surfaces;
        for (Drawbead& bead : model_.drawbeads_) {
            if (const auto block = find_node_group(index_, bead.group_id)) {
                bead.group = groups.emplace(*block, static_cast<uint32_t>(group_ids_.size())).first->second;
                if (*bead.group == group_ids_.size()) group_ids_.push_back({bead.group_id, *block});
            }
            if (const auto block = find_surface(index_, bead.surface_id)) {
                bead.surface =
                    surfaces.emplace(*block, static_cast<uint32_t>(surface_ids_.size())).first->second;
                if (*bead.surface == surface_ids_.size()) surface_ids_.push_back({bead.surface_id, *block});
            }
        }
    }

    bool with_nodes() const {
        constexpr Needs geometric =
            Needs::coordinates | Needs::blank_elements | Needs::element_thickness | Needs::attachments;
        return !model_.drawbeads_.empty() && (uint32_t(needs_) & uint32_t(geometric)) != 0;
    }
    bool with_elements() const {
        return with_nodes() && (has(needs_, Needs::blank_elements) || has(needs_, Needs::element_thickness));
    }

    bool with_motion() const {
        return has(needs_, Needs::motion) && with_elements() && !model_.drawbeads_.empty();
    }

    TableRequest request(const PartPicker& picker) const {
        TableRequest request;
        request.counts = has(needs_, Needs::counts);
        request.coordinates = with_nodes();
        Demand demand(deck_, index_, picker);
        if (with_nodes()) {
            for (const Option& group : group_ids_)
                demand.add_group(group.block);
            for (const Transform& transform : transforms_)
                if (const auto group = find_node_group(index_, transform.group)) demand.add_group(*group);
            for (const Holder& holder : holders_)
                if (holder.group) demand.add_group(*holder.group);
            for (const GroupCondition& one : motion_.conditions) {
                if (one.group) demand.add_group(*one.group);
                if (one.member) demand.add_member(*one.member);
            }
        }
        if (with_elements())
            for (const Option& surface : surface_ids_)
                demand.add_surface(surface.block, true);
        using Elements = TableRequest::Elements;
        request.elements = demand.all() ? Elements::all : demand.any() ? Elements::of_parts : Elements::none;
        request.parts = demand.parts();
        request.solids = demand.solids();
        request.element_ids = demand.ids();
        if (has(needs_, Needs::all_element_ids)) {
            request.elements = Elements::all;
            request.solids = request.element_ids = true;
        }
        request.thickness = has(needs_, Needs::element_thickness);
        return request;
    }

    void expand(const PartPicker& picker, Tables& tables) {
        Resolver resolver(deck_, index_, picker, tables, issues_, threads_);
        for (const Option& group : group_ids_) {
            model_.groups_.push_back(with_nodes() ? resolver.group(group.id, group.block)
                                                  : bare_group(group));
        }
        std::vector<SurfaceContent> contents;
        for (const Option& option : surface_ids_) {
            Surface surface;
            surface.id = option.id;
            surface.block = option.block;
            const Block& block = deck_.blocks()[option.block];
            surface.type = is_option(block.keyword, "SET") ? "SET" : std::string(subtype(block.keyword));
            surface.title = OptionReader(deck_, option.block, issues_).title();
            surface.sources = resolver.sources(option.block);
            if (with_elements()) contents.push_back(resolver.surface(option.block));
            model_.surfaces_.push_back(std::move(surface));
        }
        if (!holders_.empty()) {
            NodeSet bead_nodes(tables.nodes.size());
            for (const NodeGroup& group : model_.groups_)
                for (const NodeRow node : group.nodes)
                    bead_nodes.insert(node);
            model_.attachments_ = find_attachments(holders_, resolver, bead_nodes);
        }
        apply_transforms(transforms_, deck_, index_, picker, resolver, threads_, tables.nodes);
        const auto stronger = [&](ShellRef a, ShellRef b) { return is_stronger(tables, a, b); };
        for (std::size_t i = 0; i < contents.size(); ++i) {
            Surface& surface = model_.surfaces_[i];
            surface.evaluated = contents[i].evaluated;
            write_segments(contents[i], tables, threads_, surface);
            find_elements_behind(tables, threads_, stronger, surface);
            turn_faces_outward(tables, surface);
            note_blanks(contents[i], tables, surface);
            contents[i] = {};
        }
        if (with_motion()) {
            NodeSet nodes(tables.nodes.size());
            for (const NodeGroup& group : model_.groups_)
                for (const NodeRow node : group.nodes)
                    nodes.insert(node);
            const std::size_t count = tables.nodes.size();
            model_.motion_ = find_motion(
                std::move(motion_), resolver, nodes, [&](NodeSet& set) { add_surface_nodes(count, set); },
                count, model_.groups_, model_.surfaces_);
        }
        if (has(needs_, Needs::surface_users)) find_users(deck_, index_, model_.groups_, model_.surfaces_);
    }

    /// The nodes of all main surfaces. Threads mark bytes, as bits of one word would be theirs in turn only.
    void add_surface_nodes(std::size_t node_count, NodeSet& nodes) {
        constexpr std::size_t piece = 1 << 16; // whole words of the set
        const auto pieces = [](std::size_t count) { return (count + piece - 1) / piece; };
        std::vector<uint8_t> marked(node_count, 0);
        for (const Surface& surface : model_.surfaces_) {
            const SegmentList& segments = surface.segments;
            parallel_for(threads_, pieces(segments.size()), [&](std::size_t p) {
                for (std::size_t i = p * piece; i < std::min(segments.size(), (p + 1) * piece); ++i)
                    for (const NodeRow node : segments.nodes(i))
                        if (node != no_node)
                            std::atomic_ref(marked[index(node)]).store(1, std::memory_order_relaxed);
            });
        }
        parallel_for(threads_, pieces(node_count), [&](std::size_t p) {
            for (std::size_t i = p * piece; i < std::min(node_count, (p + 1) * piece); ++i)
                if (marked[i]) nodes.insert(NodeRow{static_cast<uint32_t>(i)});
        });
    }

    /// Without coordinates: the list as written.
    NodeGroup bare_group(const Option& option) {
        const Block& block = deck_.blocks()[option.block];
        NodeGroup group;
        group.id = option.id;
        group.block = option.block;
        group.title = OptionReader(deck_, option.block, issues_).title();
        if (is_option(block.keyword, "SET")) {
            group.type = "SET";
            bool plain = true;
            for (const SetClause& clause : read_set(deck_, index_, option.block, issues_)) {
                if (clause.key != "NODENS") continue;
                plain = plain && !clause.remove && !clause.intersect && group.nodens_clauses.empty();
                group.nodens_clauses.push_back(clause.place);
                group.evaluated = group.evaluated && clause.supported;
                for (const WrittenId& id : clause.nodes)
                    group.listed.push_back({id.id, no_node, id.place});
            }
            if (!group.nodens_clauses.empty())
                group.order = plain ? NodeGroup::Order::unsorted : NodeGroup::Order::lost_in_set;
            return group;
        }
        group.type = is_ordered_list(block.keyword) ? "NODENS" : std::string(subtype(block.keyword));
        if (group.type == "NODENS" || group.type == "GRNODNS") group.order = NodeGroup::Order::unsorted;
        if (is_node_list(block.keyword))
            for (const WrittenId& id : read_ids(deck_, block, issues_))
                group.listed.push_back({id.id, no_node, id.place});
        return group;
    }

    /// The thicker shell gives the stiffness, then the one of higher modulus.
    bool is_stronger(const Tables& tables, ShellRef a, ShellRef b) const {
        const auto rank = [&](ShellRef shell) {
            const ShellTable& table = shell.kind == ElementKind::shell3 ? tables.shells3 : tables.shells4;
            const Part* part = model_.part(table.part(shell.row));
            const Property* property = part ? model_.property(part->property) : nullptr;
            const Material* material = part ? model_.material(part->material) : nullptr;
            return std::pair(property ? property->thickness : 0, material ? material->young : 0);
        };
        return rank(a) > rank(b);
    }

    /// The parts that a surface's elements belong to.
    void note_blanks(const SurfaceContent& content, const Tables& tables, const Surface& surface) {
        const auto of_runs = [&](const std::vector<SegmentRun>& runs,
                                 const std::vector<ElementRange>& ranges) {
            for (const SegmentRun& run : runs)
                for (auto range = range_at(ranges, run.begin);
                     range != ranges.end() && range->row_begin < run.end; ++range)
                    blanks_.insert(range->part);
        };
        of_runs(content.shells4, tables.shells4.ranges);
        of_runs(content.shells3, tables.shells3.ranges);
        const auto of_segment = [&](const Segment& segment) {
            if (segment.kind == ElementKind::none) return;
            const auto& ranges = segment.kind == ElementKind::shell4   ? tables.shells4.ranges
                                 : segment.kind == ElementKind::shell3 ? tables.shells3.ranges
                                                                       : tables.solids.ranges;
            const auto range = range_at(ranges, segment.element);
            if (range != ranges.end()) blanks_.insert(range->part);
        };
        for (std::size_t i = 0; i < surface.lines.size(); ++i)
            of_segment(surface.segments[i]);
        for (const Segment& face : content.faces)
            of_segment(face);
    }

    static std::vector<ElementRange>::const_iterator range_at(const std::vector<ElementRange>& ranges,
                                                              uint32_t row) {
        return std::upper_bound(ranges.begin(), ranges.end(), row,
                                [](uint32_t r, const ElementRange& range) { return r < range.row_end; });
    }

    /// A blank's part needs its property and material.
    void check_blanks() {
        for (const PartId id : blanks_) {
            const Part* part = model_.part(id);
            if (!part) continue;
            const Block& block = deck_.blocks()[part->block];
            const std::string subject = "part " + std::to_string(id);
            if (!model_.property(part->property))
                issues_.add(ReadIssue::Kind::property_missing, block.header, subject,
                            std::to_string(part->property));
            if (!model_.material(part->material))
                issues_.add(ReadIssue::Kind::material_missing, block.header, subject,
                            std::to_string(part->material));
        }
    }

    const Deck& deck_;
    Needs needs_;
    unsigned threads_;
    std::optional<std::span<const MotionTarget>> targets_;
    IssueLog issues_;
    OptionIndex index_;
    Model model_;
    std::vector<Option> group_ids_, surface_ids_;
    std::vector<Transform> transforms_;
    std::vector<Holder> holders_;
    MotionOptions motion_;
    std::set<PartId> blanks_;
};

Model Model::build(const Deck& deck, Needs needs, unsigned threads) {
    return ModelBuilder(deck, needs, threads, {}).build();
}

Model Model::build(const Deck& deck, Needs needs, unsigned threads, std::span<const MotionTarget> targets) {
    return ModelBuilder(deck, needs, threads, targets).build();
}

} // namespace drawbead
