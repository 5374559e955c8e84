#include "report/accuracy.h"

#include "report/json.h"
#include "report/table.h"
#include "report/text.h"

#include <algorithm>
#include <cstdio>

namespace drawbead {

namespace {

using Layout = JsonWriter::Layout;

std::string digits(double value, int count) {
    if (value == 0) return "0";
    char text[32];
    std::snprintf(text, sizeof text, "%.*g", count, value);
    return text;
}

/// A relative error in percent: two digits, "0" where it is rounding of doubles.
std::string percent(double value) {
    return value < 1e-12 ? "0" : digits(100 * value, 2);
}

std::string with_unit(double value, const std::string& unit) {
    return digits(value, 6) + (unit.empty() ? "" : " " + unit);
}

std::string seconds(double value) {
    return value < 1 ? digits(1e3 * value, 3) + " ms" : digits(value, 3) + " s";
}

std::string tolerance_text(double tolerance) {
    return digits(100 * tolerance, 6) + " %";
}

std::vector<std::size_t> columns(std::size_t first, std::size_t count) {
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < count; ++i)
        out.push_back(first + i);
    return out;
}

std::string remark(const AccuracyReport& r, std::size_t row) {
    std::string out;
    const auto add = [&](const std::string& what) { out += (out.empty() ? "" : ", ") + what; };
    for (const AccuracyPick& pick : r.picks)
        if (pick.row == row) add("cheapest within " + tolerance_text(pick.tolerance));
    if (r.rows[row].at_floor) add("at the floor");
    return out;
}

void write_beads(OutputSink& out, const AccuracyReport& r) {
    std::vector<std::vector<std::string>> rows{{"bead", "nodes", "largest restraint", "normal force", "work",
                                                "dissipated", "first slip", "worst node"}};
    for (const AccuracyBead& bead : r.beads) {
        const AccuracyValues& v = bead.reference;
        rows.push_back(
            {std::to_string(bead.id), std::to_string(bead.nodes),
             with_unit(v.largest_restraint, r.force_unit), with_unit(v.normal, r.force_unit),
             with_unit(v.work, r.energy_unit), with_unit(v.dissipated, r.energy_unit),
             v.first_slip ? with_unit(*v.first_slip, r.time_unit) : "never",
             v.worst > 0 ? std::to_string(v.worst_node) + ": " + with_unit(v.worst, r.force_unit) : "none"});
    }
    out.write(text_table(rows, {}, 2));
}

void write_rows(OutputSink& out, const AccuracyReport& r, bool all) {
    std::vector<std::vector<std::string>> rows{{"settings", "restraint"}};
    for (const std::string& q : r.quantities)
        rows[0].push_back(q + " %");
    for (const char* head : {"evaluations", "time", ""})
        rows[0].emplace_back(head);
    for (std::size_t i = 0; i < r.rows.size(); ++i) {
        const AccuracyRow& row = r.rows[i];
        if (!all && !row.on_front) continue;
        double largest = 0;
        for (const AccuracyValues& v : row.values)
            largest = std::max(largest, v.largest_restraint);
        rows.push_back({row.brief, with_unit(largest, r.force_unit)});
        for (const double e : row.worst)
            rows.back().push_back(percent(e));
        rows.back().push_back(std::to_string(row.evaluations));
        rows.back().push_back(row.median ? seconds(*row.median) + " (least " + seconds(*row.least) + ")"
                                         : "");
        rows.back().push_back(remark(r, i));
    }
    out.write(text_table(rows, columns(1, r.quantities.size() + 2), 2));
}

void write_apart(OutputSink& out, const AccuracyReport& r) {
    std::vector<std::vector<std::string>> rows{{""}};
    for (const std::string& q : r.quantities)
        rows[0].push_back(q + " %");
    const auto add = [&](const std::string& what, const AccuracyErrors& errors) {
        rows.push_back({what});
        for (const double e : errors)
            rows.back().push_back(percent(e));
    };
    add("the solver's law", r.solver);
    add("the manual's, as evaluate runs it", r.evaluate);
    out.write(text_table(rows, columns(1, r.quantities.size()), 2));
}

void write_orders(OutputSink& out, const AccuracyReport& r) {
    std::vector<std::vector<std::string>> rows{{"knob", "quantity", "expected", "observed", "levels", ""}};
    for (const AccuracyOrder& o : r.orders) {
        std::string levels;
        for (std::size_t i = o.first; i < o.first + o.count && i < o.error.size(); ++i)
            levels += (levels.empty() ? "" : " ") + digits(o.error[i], 2);
        rows.push_back({o.knob, o.quantity, o.expected ? digits(*o.expected, 2) : "exact",
                        o.observed ? digits(*o.observed, 3) : "", levels, o.verdict});
    }
    out.write(text_table(rows, {2, 3}, 2));
}

} // namespace

void write_accuracy_text(OutputSink& out, const AccuracyReport& r, bool all) {
    out.write(terminal_safe(r.scene) + ": " + terminal_safe(r.deck) + ", manual law to " +
              with_unit(r.end, r.time_unit) + "\n\n");
    out.write("reference (" + r.reading + "), " + std::to_string(r.reference_evaluations) +
              " evaluations; two resolutions of it agree to " +
              (r.reference_error < 1e-12 ? "rounding" : digits(100 * r.reference_error, 2) + " %") + "\n");
    write_beads(out, r);
    out.write(all ? "\nsettings\n"
                  : "\nsettings on the front (--all for every one of " + std::to_string(r.rows.size()) +
                        ")\n");
    write_rows(out, r, all);
    for (const AccuracyPick& pick : r.picks) {
        if (pick.row) {
            if (pick.asked)
                out.write("\nwithin " + tolerance_text(pick.tolerance) +
                          ", for the scene:\naccuracy: " + r.rows[*pick.row].yaml + "\n");
        } else {
            const AccuracyRow& best = r.rows[pick.best];
            out.write("\nnothing is within " + tolerance_text(pick.tolerance) + "; the best has " +
                      percent(best.error) + " %: " + best.brief + ", " + std::to_string(best.evaluations) +
                      " evaluations\n");
        }
    }
    out.write("\ndifference of laws, not an error of steps, at the scene's " +
              how_many(r.scene_steps, "step") + '\n');
    write_apart(out, r);
    out.write("\nother readings of the line, from the reference\n");
    {
        std::vector<std::vector<std::string>> rows{{""}};
        for (const std::string& q : r.quantities)
            rows[0].push_back(q + " %");
        for (const auto& [name, errors] : r.readings) {
            rows.push_back({name});
            for (const double e : errors)
                rows.back().push_back(percent(e));
        }
        out.write(text_table(rows, columns(1, r.quantities.size()), 2));
    }
    out.write("\norders, " + std::string(r.kinked ? "kinked" : "smooth") + " motion\n");
    write_orders(out, r);
    out.write("\nFt itself is known to about " + digits(100 * r.known_to, 2) +
              " % (friction, material): " + with_unit(r.known_to * r.largest_restraint, r.force_unit) +
              " of " + with_unit(r.largest_restraint, r.force_unit) +
              ". Errors below 1 % change no decision; finer settings serve comparisons of two runs.\n");
    for (const auto& [id, why] : r.left_out)
        out.write("interface " + std::to_string(id) + " left out: " + terminal_safe(why) + '\n');
    for (const std::string& note : r.notes)
        out.write("note: " + terminal_safe(note) + '\n');
}

namespace {

class AccuracyJson {
public:
    AccuracyJson(OutputSink& out, const AccuracyReport& report) : json_(out), r_(report) {}

    void write(std::string_view version) {
        json_.begin_object();
        json_.member("tool", "drawbead");
        json_.member("version", version);
        json_.member("schema", 1);
        json_.member("deck", r_.deck);
        json_.member("scene", r_.scene);
        json_.key("units");
        json_.begin_object(Layout::line);
        json_.member("force", r_.force_unit);
        json_.member("length", r_.length_unit);
        json_.member("time", r_.time_unit);
        json_.member("energy", r_.energy_unit);
        json_.end();
        json_.member("begin", r_.begin);
        json_.member("end", r_.end);
        json_.member("kinked", r_.kinked);
        json_.member_list("quantities", r_.keys);
        reference();
        json_.key("rows");
        json_.begin_array();
        for (const AccuracyRow& one : r_.rows)
            row(one);
        json_.end();
        picks();
        json_.key("differences_of_laws");
        json_.begin_object();
        json_.member("steps", r_.scene_steps);
        errors("solver", r_.solver);
        errors("evaluate", r_.evaluate);
        json_.end();
        orders();
        json_.member("orders_hold", r_.orders_hold());
        json_.member("known_to", r_.known_to);
        json_.member("largest_restraint", r_.largest_restraint);
        json_.member("repeats", r_.repeats);
        json_.key("left_out");
        json_.begin_array();
        for (const auto& [id, why] : r_.left_out) {
            json_.begin_object(Layout::line);
            json_.member("interface", id);
            json_.member("why", why);
            json_.end();
        }
        json_.end();
        json_.member_list("notes", r_.notes);
        json_.end();
    }

private:
    void optional(std::string_view key, const std::optional<double>& value) {
        json_.key(key);
        value ? json_.value(*value) : json_.null();
    }

    void errors(std::string_view key, const AccuracyErrors& values) {
        json_.key(key);
        json_.begin_object(Layout::line);
        for (std::size_t i = 0; i < values.size(); ++i)
            json_.member(r_.keys[i], values[i]);
        json_.end();
    }

    void values(const AccuracyValues& v) {
        json_.key("values");
        json_.begin_object(Layout::line);
        json_.member("largest_restraint", v.largest_restraint);
        json_.member("normal", v.normal);
        json_.member("work", v.work);
        json_.member("dissipated", v.dissipated);
        optional("first_slip", v.first_slip);
        json_.member("worst", v.worst);
        json_.member("worst_node", v.worst_node);
        json_.end();
    }

    void reference() {
        json_.key("reference");
        json_.begin_object();
        json_.member("reading", r_.reading);
        json_.member("evaluations", r_.reference_evaluations);
        json_.member("error", r_.reference_error);
        json_.key("beads");
        json_.begin_array();
        for (const AccuracyBead& bead : r_.beads) {
            json_.begin_object();
            json_.member("interface", bead.id);
            json_.member("title", bead.title);
            json_.member("nodes", bead.nodes);
            values(bead.reference);
            optional("first_contact", bead.first_contact);
            errors("solver", bead.solver);
            errors("evaluate", bead.evaluate);
            json_.end();
        }
        json_.end();
        json_.key("other_readings");
        json_.begin_object();
        for (const auto& [name, apart] : r_.readings)
            errors(name, apart);
        json_.end();
        json_.end();
    }

    void row(const AccuracyRow& one) {
        json_.begin_object();
        json_.key("settings");
        json_.begin_object(Layout::line);
        for (const auto& [key, word] : one.settings) {
            const bool number = !word.empty() && word.find_first_not_of("0123456789") == std::string::npos;
            json_.key(key);
            number ? json_.value(static_cast<uint64_t>(std::stoull(word))) : json_.value(word);
        }
        json_.end();
        json_.member("error", one.error);
        errors("errors", one.worst);
        json_.key("beads");
        json_.begin_array();
        for (std::size_t b = 0; b < one.values.size(); ++b) {
            json_.begin_object();
            json_.member("interface", r_.beads[b].id);
            values(one.values[b]);
            errors("errors", one.errors[b]);
            json_.end();
        }
        json_.end();
        json_.key("cost");
        json_.begin_object(Layout::line);
        json_.member("evaluations", one.evaluations);
        json_.member("instants", one.instants);
        json_.member("searches", one.searches);
        json_.member("follows", one.follows);
        json_.member("projections", one.projections);
        json_.end();
        json_.key("seconds");
        if (one.median) {
            json_.begin_object(Layout::line);
            json_.member("median", *one.median);
            json_.member("least", *one.least);
            json_.end();
        } else {
            json_.null();
        }
        json_.member("at_floor", one.at_floor);
        json_.member("on_front", one.on_front);
        json_.end();
    }

    void picks() {
        json_.key("picks");
        json_.begin_array();
        for (const AccuracyPick& pick : r_.picks) {
            json_.begin_object();
            json_.member("tolerance", pick.tolerance);
            json_.member("asked", pick.asked);
            json_.key("row");
            pick.row ? json_.value(*pick.row) : json_.null();
            json_.key("yaml");
            pick.row ? json_.value(r_.rows[*pick.row].yaml) : json_.null();
            json_.member("best_row", pick.best);
            json_.member("best_error", r_.rows[pick.best].error);
            json_.end();
        }
        json_.end();
    }

    void orders() {
        json_.key("orders");
        json_.begin_array();
        for (const AccuracyOrder& o : r_.orders) {
            json_.begin_object();
            json_.member("knob", o.knob);
            json_.member("quantity", o.quantity);
            optional("expected", o.expected);
            optional("observed", o.observed);
            json_.member("verdict", o.verdict);
            json_.member("below", o.below);
            json_.key("fitted");
            json_.begin_object(Layout::line);
            json_.member("first", o.first);
            json_.member("count", o.count);
            json_.end();
            json_.member_list("size", o.size);
            json_.member_list("error", o.error);
            json_.end();
        }
        json_.end();
    }

    JsonWriter json_;
    const AccuracyReport& r_;
};

} // namespace

void write_accuracy_json(OutputSink& out, const AccuracyReport& report, std::string_view version) {
    AccuracyJson(out, report).write(version);
}

void write_accuracy_csv(OutputSink& out, const AccuracyReport& r) {
    std::string head;
    if (!r.rows.empty())
        for (const auto& [key, word] : r.rows.front().settings)
            head += key + ',';
    for (const std::string& key : r.keys)
        head += key + ',';
    out.write(head +
              "error,evaluations,instants,searches,follows,projections,median_s,least_s,at_floor,on_front\n");
    for (const AccuracyRow& row : r.rows) {
        std::string line;
        for (const auto& [key, word] : row.settings)
            line += word + ',';
        for (const double e : row.worst)
            line += json_number(e) + ',';
        line += json_number(row.error);
        for (const uint64_t n : {row.evaluations, row.instants, row.searches, row.follows, row.projections})
            line += ',' + std::to_string(n);
        line += ',' + (row.median ? json_number(*row.median) : "") + ',' +
                (row.least ? json_number(*row.least) : "");
        line += row.at_floor ? ",1" : ",0";
        line += row.on_front ? ",1\n" : ",0\n";
        out.write(line);
    }
}

} // namespace drawbead
