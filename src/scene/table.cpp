#include "scene/table.h"

#include <cmath>
#include <map>

namespace drawbead {

namespace {

std::array<int64_t, 4> user_ids(const Model& model, const SegmentNodes& rows) {
    std::array<int64_t, 4> ids;
    for (std::size_t k = 0; k < 4; ++k)
        ids[k] = model.nodes().id[rows[k]];
    return ids;
}

/// Node rows of a segment as the solver holds it.
SegmentNodes nodes_of(const Segment& segment) {
    return {index(segment.n[0]), index(segment.n[1]), index(segment.n[2]), index(segment.n[3])};
}

void take_segment(const Model& model, const InterfaceContact& one, std::size_t i, BeadTableRow& row) {
    const BeadNodeContact& node = one.contact.node[i];
    if (node.segment == no_segment || node.closest == no_segment) return; // positions that are no numbers
    const Drawbead& bead = *one.bead;
    row.met = true;
    row.tributary = node.solver_tributary;
    row.n = user_ids(model, node.nodes);
    row.xi = node.xi;
    row.eta = node.eta;
    row.inside = node.inside;
    row.distance = node.distance;
    row.half_thickness = node.half_thickness;
    row.penetration = node.penetration;
    row.stiffness = node.k;
    row.slope = node.slope;
    row.slope_read = node.slope_read;
    row.reset = one.contact.slope.kind == Slope::reset;
    row.closest_n = user_ids(model, nodes_of(one.surface->segments[node.closest]));
    row.closest_distance = node.exact.d;
    row.same_segment = node.segment == node.closest;
    // The manual's comparison as it stands there: a force per squared length against a force per length.
    row.manual_slope = bead.depth > 0 ? bead.fn_first / bead.depth : node.k;
    row.manual_reset = bead.fn_first != 0 && (!(bead.depth > 0) || row.manual_slope > node.k);
}

void add(BeadForces& sum, const BeadTableRow& row) {
    ++sum.nodes;
    sum.fn += row.fn_limit * row.tributary;
    sum.ft += row.ft_limit * row.tributary;
}

std::optional<int64_t> rigid_body_of(const Model& model, NodeRow node) {
    for (const Attachment& one : model.attachments(node))
        if (one.kind == Attachment::Kind::rigid_body) return one.id;
    return {};
}

BeadTable bead_table(const Model& model, const InterfaceContact& one) {
    const UnitSystem& units = model.deck().work_units();
    BeadTable table;
    table.interface_id = one.bead->id;
    table.title = one.bead->title;
    table.unknown = one.unknown;
    const std::string per_length = unit_name(units, force_per_length_dimension);
    const std::string per_area = unit_name(units, pressure_dimension);
    table.slope_unit = one.contact.slope.kind == Slope::ramp ? per_area : per_length;
    table.manual_slope_unit = one.bead->depth > 0 ? per_area : per_length;
    table.rows.resize(one.x.size());
    for (std::size_t i = 0; i < one.x.size(); ++i) {
        BeadTableRow& row = table.rows[i];
        row.node = value(model.nodes().user_id(one.group->nodes[i]));
        row.s = one.line.s[i];
        row.tributary = one.line.tributary[i];
        row.fn_limit = one.fn[i];
        row.ft_limit = one.ft[i];
        if (table.on_surface()) take_segment(model, one, i, row);
        if (!row.met) continue;
        BeadTotals& totals = table.totals;
        totals.inside += row.inside;
        totals.different_segments += !row.same_segment;
        const double difference = std::abs(row.distance - row.closest_distance);
        if (totals.largest_difference_node == 0 || difference > totals.largest_difference) {
            totals.largest_difference = difference;
            totals.largest_difference_node = row.node;
        }
    }
    table.totals.length = one.line.length;
    for (const BeadTableRow& row : table.rows)
        add(table.totals.force, row);
    return table;
}

} // namespace

DeckTable table_of(const Model& model, const DeckContact& contact, std::optional<InterfaceId> only) {
    const UnitSystem& units = model.deck().work_units();
    DeckTable out;
    out.length_unit = unit_name(units, length_dimension);
    out.force_unit = unit_name(units, force_dimension);
    out.force_per_length_unit = unit_name(units, force_per_length_dimension);

    std::map<int64_t, ToolTotals> tools;
    ToolTotals free_nodes;
    std::vector<uint8_t> doubted(contact.surfaces.size(), 0);
    for (const InterfaceContact& one : contact.interfaces) {
        if (only && one.bead->id != *only) continue;
        out.beads.push_back(bead_table(model, one));
        const BeadTable& table = out.beads.back();
        if (!table.on_surface())
            out.warnings.push_back("interface " + std::to_string(one.bead->id) +
                                   " is not computed: " + table.unknown);
        else if (!doubted[*one.bead->surface]) {
            doubted[*one.bead->surface] = 1;
            for (const std::string& doubt : contact.surfaces[*one.bead->surface].stiffness->doubts())
                out.warnings.push_back("stiffness on surface " + std::to_string(one.surface->id) +
                                       " is not certain: " + doubt);
        }
        out.length += table.totals.length;
        for (std::size_t i = 0; i < table.rows.size(); ++i) {
            const std::optional<int64_t> body = rigid_body_of(model, one.group->nodes[i]);
            ToolTotals& tool = body ? tools[*body] : free_nodes;
            tool.rigid_body = body;
            if (tool.interfaces.empty() || tool.interfaces.back() != one.bead->id)
                tool.interfaces.push_back(one.bead->id);
            add(tool.force, table.rows[i]);
            add(out.force, table.rows[i]);
        }
    }
    for (auto& [id, tool] : tools)
        out.tools.push_back(std::move(tool));
    if (free_nodes.force.nodes > 0) out.tools.push_back(std::move(free_nodes));
    return out;
}

} // namespace drawbead
