#include "report/evaluation.h"

#include "report/json.h"
#include "report/table.h"
#include "report/text.h"

#include <cstdio>

namespace drawbead {

namespace {

using Layout = JsonWriter::Layout;

std::string short_number(double value) {
    if (value == 0) return "0";
    char text[32];
    std::snprintf(text, sizeof text, "%.5g", value);
    return text;
}

std::string with_unit(double value, const std::string& unit) {
    return short_number(value) + (unit.empty() ? "" : " " + unit);
}

std::string share(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f %%", 100 * value);
    return text;
}

std::string bead_name(const EvaluatedBead& bead) {
    return "interface " + std::to_string(bead.id) +
           (bead.title.empty() ? "" : " (" + terminal_safe(bead.title) + ")");
}

void write_effects(OutputSink& out, const EvaluatedLaw& law, std::size_t indent) {
    std::vector<std::vector<std::string>> rows{{"effect", "", "estimated", "actual", "reason"}};
    for (const PlannedEffect& e : law.effects)
        rows.push_back({e.name, e.forced ? "FORCED" : e.verdict, std::to_string(e.estimated),
                        e.actual ? std::to_string(*e.actual) : "", e.what + ": " + terminal_safe(e.reason)});
    if (!law.effects.empty() && !law.effects.front().actual)
        for (auto& row : rows)
            row.erase(row.begin() + 3);
    out.write(text_table(
        rows, rows.front().size() == 5 ? std::vector<std::size_t>{2, 3} : std::vector<std::size_t>{2},
        indent));
}

void write_notes(OutputSink& out, const EvaluationReport& report) {
    for (const auto& [id, why] : report.left_out)
        out.write("interface " + std::to_string(id) + " left out: " + terminal_safe(why) + '\n');
    for (const std::string& note : report.notes)
        out.write("note: " + terminal_safe(note) + '\n');
}

void write_units(JsonWriter& json, const EvaluationReport& report) {
    json.key("units");
    json.begin_object(Layout::line);
    json.member("force", report.force_unit);
    json.member("length", report.length_unit);
    json.member("time", report.time_unit);
    json.member("energy", report.energy_unit);
    json.member("impulse", report.impulse_unit);
    json.end();
}

void write_head(JsonWriter& json, const EvaluationReport& report, std::string_view version) {
    json.member("tool", "drawbead");
    json.member("version", version);
    json.member("schema", 1);
    json.member("deck", report.deck);
    json.member("scene", report.scene);
    write_units(json, report);
    json.member("steps", report.steps);
    json.member("begin", report.begin);
    json.member("end", report.end);
}

void write_tail(JsonWriter& json, const EvaluationReport& report) {
    json.key("left_out");
    json.begin_array();
    for (const auto& [id, why] : report.left_out) {
        json.begin_object(Layout::line);
        json.member("interface", id);
        json.member("why", why);
        json.end();
    }
    json.end();
    json.member_list("notes", report.notes);
}

void write_effects(JsonWriter& json, const EvaluatedLaw& law) {
    json.key("effects");
    json.begin_array();
    for (const PlannedEffect& e : law.effects) {
        json.begin_object(Layout::line);
        json.member("name", e.name);
        json.member("verdict", e.verdict);
        json.member("forced", e.forced);
        json.member("reason", e.reason);
        json.member("estimated", e.estimated);
        if (e.actual) json.member("actual", *e.actual);
        json.end();
    }
    json.end();
}

void member(JsonWriter& json, std::string_view name, const Peak& peak) {
    json.key(name);
    json.begin_object(Layout::line);
    json.member("value", peak.value);
    json.member("time", peak.time);
    json.end();
}

void member(JsonWriter& json, std::string_view name, const std::optional<double>& value) {
    json.key(name);
    if (value)
        json.value(*value);
    else
        json.null();
}

void member(JsonWriter& json, std::string_view name, const std::optional<int64_t>& value) {
    json.key(name);
    if (value)
        json.value(*value);
    else
        json.null();
}

void write_law(JsonWriter& json, const EvaluatedLaw& law) {
    json.begin_object();
    json.member("law", law.law);
    member(json, "force", law.force);
    json.member_list("force_vector", law.force_vector);
    json.member_list("couple", law.couple);
    member(json, "couple_norm", law.couple_norm);
    member(json, "normal", law.normal);
    member(json, "restraint", law.restraint);
    member(json, "normal_sum", law.normal_sum);
    member(json, "restraint_sum", law.restraint_sum);
    json.member("normal_share", law.normal_share());
    json.member("restraint_share", law.restraint_share());
    json.member_list("impulse", law.impulse);
    json.key("energy");
    json.begin_object(Layout::line);
    json.member("normal_work", law.normal_work);
    json.member("restraint_work", law.restraint_work);
    json.member("tool_work", law.tool_work);
    json.member("stored", law.stored);
    json.member("dissipated", law.dissipated);
    json.member("created", law.created);
    json.end();
    member(json, "first_contact", law.first_contact);
    member(json, "first_plateau", law.first_plateau);
    member(json, "first_slip", law.first_slip);
    json.key("nodes");
    json.begin_object(Layout::line);
    json.member("in_contact", law.in_contact);
    json.member("on_plateau", law.on_plateau);
    json.member("ever_in_contact", law.ever_in_contact);
    json.end();
    json.key("worst_node");
    json.begin_object(Layout::line);
    json.member("node", law.worst_node);
    json.member("restraint", law.worst.value);
    json.member("time", law.worst.time);
    json.end();
    write_effects(json, law);
    json.end();
}

void write_difference(JsonWriter& json, std::string_view name, const std::optional<LawDifference>& d) {
    json.key(name);
    if (!d) {
        json.null();
        return;
    }
    json.begin_object(Layout::line);
    json.member("largest", d->largest.value);
    json.member("largest_percent", d->percent(d->largest.value));
    json.member("time", d->largest.time);
    json.member("mean", d->mean);
    json.member("mean_percent", d->percent(d->mean));
    json.end();
}

} // namespace

void write_evaluation_text(OutputSink& out, const EvaluationReport& r) {
    const auto force = [&](double v) { return with_unit(v, r.force_unit); };
    const auto time = [&](const std::optional<double>& t) {
        return t ? with_unit(*t, r.time_unit) : std::string("never");
    };
    const auto peak = [&](const Peak& p, const std::string& unit) {
        return with_unit(p.value, unit) + " at " + with_unit(p.time, r.time_unit);
    };
    out.write(terminal_safe(r.scene.empty() ? r.deck : r.scene + ": " + r.deck) + ", " +
              how_many(r.steps, "step") + " to " + with_unit(r.end, r.time_unit) + '\n');
    for (const EvaluatedBead& bead : r.beads) {
        out.write('\n' + bead_name(bead) + ", " + how_many(bead.nodes, "node") +
                  (bead.tool ? ", rigid body " + std::to_string(*bead.tool) : "") + '\n');
        std::vector<std::vector<std::string>> rows{{""}};
        const auto row = [&](const std::string& name, const auto& cell) {
            rows.push_back({name});
            for (const EvaluatedLaw& law : bead.laws)
                rows.back().push_back(cell(law));
        };
        for (const EvaluatedLaw& law : bead.laws)
            rows[0].push_back(law.law);
        using L = EvaluatedLaw;
        const auto of_nodes = [&](uint64_t n) {
            return std::to_string(n) + " of " + std::to_string(bead.nodes) + " nodes, " +
                   share(bead.nodes > 0 ? static_cast<double>(n) / static_cast<double>(bead.nodes) : 0);
        };
        row("largest force", [&](const L& l) { return peak(l.force, r.force_unit); });
        row("largest normal force", [&](const L& l) { return peak(l.normal, r.force_unit); });
        row("largest restraint", [&](const L& l) { return peak(l.restraint, r.force_unit); });
        row("largest couple", [&](const L& l) { return peak(l.couple_norm, r.energy_unit); });
        row("share of Fn",
            [&](const L& l) { return share(l.normal_share()) + " of " + force(l.normal_capacity); });
        row("share of Ft",
            [&](const L& l) { return share(l.restraint_share()) + " of " + force(l.restraint_capacity); });
        row("impulse", [&](const L& l) {
            return short_number(l.impulse[0]) + ' ' + short_number(l.impulse[1]) + ' ' +
                   with_unit(l.impulse[2], r.impulse_unit);
        });
        row("work of the normal force", [&](const L& l) { return with_unit(l.normal_work, r.energy_unit); });
        row("work of the restraint", [&](const L& l) { return with_unit(l.restraint_work, r.energy_unit); });
        row("work on the tool", [&](const L& l) { return with_unit(l.tool_work, r.energy_unit); });
        row("dissipated", [&](const L& l) { return with_unit(l.dissipated, r.energy_unit); });
        row("stored at the end", [&](const L& l) { return with_unit(l.stored, r.energy_unit); });
        row("created", [&](const L& l) { return with_unit(l.created, r.energy_unit); });
        row("first contact", [&](const L& l) { return time(l.first_contact); });
        row("plateau reached", [&](const L& l) { return time(l.first_plateau); });
        row("first slip", [&](const L& l) { return time(l.first_slip); });
        row("engaged at most", [&](const L& l) { return of_nodes(l.in_contact); });
        row("on the plateau at most", [&](const L& l) { return of_nodes(l.on_plateau); });
        row("largest at one node", [&](const L& l) {
            return l.worst.value > 0
                       ? "node " + std::to_string(l.worst_node) + ", " + peak(l.worst, r.force_unit)
                       : std::string("none");
        });
        out.write(text_table(rows, {}, 2));
        const auto difference = [&](const char* name, const std::optional<LawDifference>& d) {
            if (!d) return;
            out.write(std::string("  laws apart, ") + name + ": up to " + force(d->largest.value) + " (" +
                      short_number(d->percent(d->largest.value)) + " %) at " +
                      with_unit(d->largest.time, r.time_unit) + ", " + force(d->mean) + " (" +
                      short_number(d->percent(d->mean)) + " %) in the mean\n");
        };
        difference("restraint", bead.restraint_difference);
        difference("normal force", bead.normal_difference);
        for (const EvaluatedLaw& law : bead.laws) {
            if (law.effects.empty()) continue;
            out.write("  effects, law " + law.law + '\n');
            write_effects(out, law, 4);
        }
    }
    if (!r.tools.empty()) out.write("\n");
    for (const EvaluatedTool& tool : r.tools) {
        out.write(
            (tool.id ? "rigid body " + std::to_string(*tool.id) : std::string("beads on no rigid body")) +
            ", " + how_many(tool.interfaces.size(), "bead") + ":");
        for (const EvaluatedTool::Sum& sum : tool.sums)
            out.write(" law " + sum.law + ": normal force up to " + peak(sum.normal, r.force_unit) +
                      (sum.holding ? ", " + (*sum.holding > 0 ? share(sum.share()) + " of the " : "") +
                                         with_unit(*sum.holding, r.force_unit) + " that hold it then"
                                   : ", which its holding force must carry") +
                      "; restraint up to " + peak(sum.restraint, r.force_unit) +
                      (&sum == &tool.sums.back() ? "" : ";"));
        out.write('\n');
    }
    write_notes(out, r);
}

void write_evaluation_json(OutputSink& out, const EvaluationReport& report, std::string_view version) {
    JsonWriter json(out);
    json.begin_object();
    write_head(json, report, version);
    json.key("beads");
    json.begin_array();
    for (const EvaluatedBead& bead : report.beads) {
        json.begin_object();
        json.member("interface", bead.id);
        json.member("title", bead.title);
        json.member("iform", bead.iform);
        json.member("nodes", bead.nodes);
        member(json, "rigid_body", bead.tool);
        json.key("laws");
        json.begin_array();
        for (const EvaluatedLaw& law : bead.laws)
            write_law(json, law);
        json.end();
        write_difference(json, "restraint_difference", bead.restraint_difference);
        write_difference(json, "normal_difference", bead.normal_difference);
        json.end();
    }
    json.end();
    json.key("tools");
    json.begin_array();
    for (const EvaluatedTool& tool : report.tools) {
        json.begin_object();
        member(json, "rigid_body", tool.id);
        json.member_list("interfaces", tool.interfaces);
        json.key("sums");
        json.begin_array();
        for (const EvaluatedTool::Sum& sum : tool.sums) {
            json.begin_object();
            json.member("law", sum.law);
            member(json, "normal", sum.normal);
            json.member_list("normal_vector", sum.normal_vector);
            member(json, "holding", sum.holding);
            member(json, "restraint", sum.restraint);
            json.end();
        }
        json.end();
        json.end();
    }
    json.end();
    write_tail(json, report);
    json.end();
}

void write_plan_text(OutputSink& out, const EvaluationReport& report) {
    out.write(terminal_safe(report.scene.empty() ? report.deck : report.scene + ": " + report.deck) + ", " +
              how_many(report.steps, "step") + " to " + with_unit(report.end, report.time_unit) + '\n');
    for (const EvaluatedBead& bead : report.beads)
        for (const EvaluatedLaw& law : bead.laws) {
            out.write('\n' + bead_name(bead) + ", " + how_many(bead.nodes, "node") + ", law " + law.law +
                      '\n');
            write_effects(out, law, 2);
        }
    write_notes(out, report);
}

void write_plan_json(OutputSink& out, const EvaluationReport& report, std::string_view version) {
    JsonWriter json(out);
    json.begin_object();
    write_head(json, report, version);
    json.key("beads");
    json.begin_array();
    for (const EvaluatedBead& bead : report.beads) {
        json.begin_object();
        json.member("interface", bead.id);
        json.member("nodes", bead.nodes);
        json.key("laws");
        json.begin_array();
        for (const EvaluatedLaw& law : bead.laws) {
            json.begin_object();
            json.member("law", law.law);
            write_effects(json, law);
            json.end();
        }
        json.end();
        json.end();
    }
    json.end();
    write_tail(json, report);
    json.end();
}

void write_samples_header(OutputSink& out) {
    out.write("law,ncycle,tt,nin,interface,inod,node,seg_n1,seg_n2,seg_n3,seg_n4,xface,ssc,ttc,dist,pen,"
              "fnx,fny,fnz,ftx,fty,ftz,fx,fy,fz,xi,yi,zi\n");
}

void write_samples(OutputSink& out, const SampledBead& bead) {
    const std::string begin = bead.law + ',' + std::to_string(bead.step) + ',' + json_number(bead.time) +
                              ',' + std::to_string(bead.rank) + ',' + std::to_string(bead.interface_id) + ',';
    for (const SampledNode& node : bead.nodes) {
        std::string line = begin + std::to_string(node.place) + ',' + std::to_string(node.id);
        for (const int64_t corner : node.segment)
            line += ',' + (node.found ? std::to_string(corner) : "");
        line += node.inside ? ",1" : ",0";
        const auto add = [&](double value) { line += ',' + json_number(value == 0 ? 0 : value); };
        for (const double value : {node.xi, node.eta, node.distance, node.penetration})
            add(value);
        for (const double value : node.normal)
            add(value);
        for (const double value : node.restraint)
            add(value);
        for (std::size_t k = 0; k < 3; ++k)
            add(node.normal[k] + node.restraint[k]);
        for (const double value : node.x)
            add(value);
        out.write(line + '\n');
    }
}

} // namespace drawbead
