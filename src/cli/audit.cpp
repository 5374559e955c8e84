#include "force/audit.h"

#include "cli/audit_deck.h"
#include "cli/commands.h"
#include "cli/reading.h"
#include "report/json.h"
#include "report/table.h"
#include "report/text.h"
#include "rules/text.h"

#include <unistd.h>

namespace drawbead {

namespace {

constexpr int all_digits = 17, few_digits = 4;

struct Audited {
    AuditResult result;
    std::vector<int64_t> interfaces;    ///< user ids, as AuditResult::energies
    std::vector<ManualDistance> manual; ///< empty under --law solver
};

std::string segment_text(const std::array<int64_t, 4>& nodes) {
    std::string text;
    for (const int64_t node : nodes)
        text += (text.empty() ? "" : " ") + std::to_string(node);
    return text;
}

std::string place_text(uint64_t line, int64_t cycle, int64_t interface_id, int64_t node) {
    return "line " + std::to_string(line) + ", cycle " + std::to_string(cycle) + ", interface " +
           std::to_string(interface_id) + ", node " + std::to_string(node);
}

void write_text(OutputSink& out, const AuditCommand& command, const Audited& audited,
                const UnitSystem& units) {
    const AuditResult& r = audited.result;
    const auto force = [&](double value) { return quantity(value, units, force_dimension); };
    const std::string energy_unit =
        unit_name(units, force_dimension) + ' ' + unit_name(units, length_dimension);
    const auto energy = [&](double value) {
        return number(value, few_digits) + (energy_unit.size() > 1 ? ' ' + energy_unit : "");
    };
    out.write(terminal_safe(command.trace) + ": " + counted(r.rows, "row") + ", " +
              counted(r.cycles, "cycle") + ", " + counted(r.energies.size(), "interface") +
              ", largest force " + force(r.force_scale) + "\n\n");
    std::vector<std::vector<std::string>> rows{
        {"quantity", "deviation", "scale", "equal", "largest at", "recorded", "recomputed"}};
    for (const AuditQuantity& q : r.quantities) {
        if (!q.applies) continue;
        const std::string equal = std::to_string(q.exact) + " of " + std::to_string(q.values);
        rows.push_back({q.name, number(q.deviation, 3) + (q.within ? "" : " OUT"),
                        number(q.scale, few_digits), equal, "", "", ""});
        if (q.line == 0) continue;
        rows.back()[4] = place_text(q.line, q.cycle, q.interface_id, q.node);
        rows.back()[5] = number(q.recorded, all_digits);
        rows.back()[6] = number(q.recomputed, all_digits);
    }
    out.write(text_table(rows, {1, 2, 3}));
    const AuditSearch& s = r.search;
    if (s.rows > 0)
        out.write("segment choice: the same in " + std::to_string(s.same) + " of " + counted(s.rows, "row") +
                  (s.same == s.rows ? "" : " OUT") + '\n');
    if (s.line > 0)
        out.write("  first other at " + place_text(s.line, s.cycle, s.interface_id, s.node) + ": recorded " +
                  segment_text(s.recorded) + ", replayed " + segment_text(s.replayed) + '\n');
    for (const std::string& note : r.notes)
        out.write("note: " + note + '\n');

    out.write("\nenergy over the record\n");
    rows = {{"interface", "normal work", "restraint work", "stored", "dissipated", "created"}};
    for (std::size_t i = 0; i < r.energies.size(); ++i) {
        const BeadEnergy& e = r.energies[i];
        rows.push_back({std::to_string(audited.interfaces[i]), energy(e.normal_work),
                        energy(e.restraint_work), energy(e.stored), energy(e.dissipated), energy(e.created)});
    }
    out.write(text_table(rows, {0, 1, 2, 3, 4, 5}, 2));

    for (const ManualDistance& m : audited.manual) {
        out.write("\ndistance from the manual's law, interface " + std::to_string(m.interface_id) +
                  (m.whole_surface ? "" : " (closest point of the recorded segments: the blank deforms)") +
                  '\n');
        rows = {{"total", "solver's largest", "manual's largest", "largest difference", "", "in cycle",
                 "mean difference", ""}};
        const auto add = [&](const char* name, const ManualDistance::Total& t) {
            rows.push_back({name, force(t.largest_solver), force(t.largest_manual), force(t.largest),
                            number(t.percent(t.largest), 3) + " %", std::to_string(t.cycle), force(t.mean),
                            number(t.percent(t.mean), 3) + " %"});
        };
        add("restraint", m.restraint);
        add("normal force", m.normal);
        out.write(text_table(rows, {1, 2, 3, 4, 5, 6, 7}, 2));
    }
    out.write(r.within ? "\nwithin " : "\nOUT of ");
    out.write("tolerance " + number(command.tolerance, few_digits) + '\n');
}

void write_json(OutputSink& out, const AuditCommand& command, const Audited& audited,
                const UnitSystem& units) {
    const AuditResult& r = audited.result;
    using Layout = JsonWriter::Layout;
    JsonWriter json(out);
    json.begin_object();
    json.member("tool", "drawbead");
    json.member("version", tool_version());
    json.member("schema", 1);
    json.member("deck", command.deck);
    json.member("trace", command.trace);
    json.member("tolerance", command.tolerance);
    json.member("within", r.within);
    json.member("rows", r.rows);
    json.member("cycles", r.cycles);
    json.key("units");
    json.begin_object(Layout::line);
    json.member("force", unit_name(units, force_dimension));
    json.member("length", unit_name(units, length_dimension));
    json.end();
    json.member("force_scale", r.force_scale);
    json.key("quantities");
    json.begin_array();
    const auto place = [&](uint64_t line, int64_t cycle, int64_t interface_id, int64_t node) {
        json.member("line", line);
        json.member("cycle", cycle);
        json.member("interface", interface_id);
        json.member("node", node);
    };
    for (const AuditQuantity& q : r.quantities) {
        json.begin_object(Layout::line);
        json.member("name", q.name);
        json.member("within", q.within);
        json.member("applies", q.applies);
        json.member("deviation", q.deviation);
        json.member("scale", q.scale);
        json.member("values", q.values);
        json.member("exact", q.exact);
        json.key("largest");
        if (q.line > 0) {
            json.begin_object(Layout::line);
            place(q.line, q.cycle, q.interface_id, q.node);
            json.member("recorded", q.recorded);
            json.member("recomputed", q.recomputed);
            json.end();
        } else {
            json.null();
        }
        json.end();
    }
    json.end();
    json.key("segment_choice");
    json.begin_object();
    json.member("rows", r.search.rows);
    json.member("same", r.search.same);
    json.member("unchecked", r.search.unchecked);
    json.key("first_other");
    if (r.search.line > 0) {
        json.begin_object(Layout::line);
        place(r.search.line, r.search.cycle, r.search.interface_id, r.search.node);
        json.member_list("recorded", r.search.recorded);
        json.member_list("replayed", r.search.replayed);
        json.end();
    } else {
        json.null();
    }
    json.end();
    json.key("energies");
    json.begin_array();
    for (std::size_t i = 0; i < r.energies.size(); ++i) {
        const BeadEnergy& e = r.energies[i];
        json.begin_object(Layout::line);
        json.member("interface", audited.interfaces[i]);
        json.member("normal_work", e.normal_work);
        json.member("restraint_work", e.restraint_work);
        json.member("stored", e.stored);
        json.member("dissipated", e.dissipated);
        json.member("created", e.created);
        json.end();
    }
    json.end();
    json.key("manual");
    json.begin_array();
    for (const ManualDistance& m : audited.manual) {
        json.begin_object();
        json.member("interface", m.interface_id);
        json.member("whole_surface", m.whole_surface);
        const auto total = [&](const char* name, const ManualDistance::Total& t) {
            json.key(name);
            json.begin_object(Layout::line);
            json.member("solver_largest", t.largest_solver);
            json.member("manual_largest", t.largest_manual);
            json.member("largest", t.largest);
            json.member("largest_percent", t.percent(t.largest));
            json.member("mean", t.mean);
            json.member("mean_percent", t.percent(t.mean));
            json.member("cycle", t.cycle);
            json.end();
        };
        total("restraint", m.restraint);
        total("normal", m.normal);
        json.end();
    }
    json.end();
    json.member_list("notes", r.notes);
    json.end();
}

} // namespace

int run(const AuditCommand& command) {
    const auto fail = [](const Error& error) {
        say_error(error);
        return exit_failed;
    };
    const Result<DeckSource> source = deck_source(command.deck, command.reading);
    if (!source) return fail(source.error());
    const unsigned threads = thread_count(command.reading);
    const Result<Deck> deck =
        Deck::read(source->name, *source->reader, read_options(command.reading, threads));
    if (!deck) {
        Error error = deck.error();
        if (error.path.empty()) error.path = source->name;
        return fail(error);
    }
    const Model model = Model::build(*deck, audit_needs, threads);
    const Result<AuditDeck> facts = audit_deck(model, threads);
    if (!facts) return fail(facts.error());
    Result<Trace> trace = read_trace(command.trace);
    if (!trace) return fail(trace.error());
    number_by_drawbead(*trace, *facts);
    Result<AuditResult> result = audit(*trace, *facts, {command.tolerance});
    if (!result) return fail(result.error());
    Audited audited{std::move(*result), {}, {}};
    for (const AuditInterface& bead : facts->interfaces)
        audited.interfaces.push_back(bead.id);
    if (command.law == AuditLaw::manual) audited.manual = manual_distance(*trace, *facts);

    std::unique_ptr<FileSink> out = std::make_unique<FileSink>(STDOUT_FILENO, "standard output");
    if (!command.file.empty()) {
        Result<std::unique_ptr<FileSink>> file = FileSink::replace(command.file);
        if (!file) return fail(file.error());
        out = std::move(*file);
    }
    if (command.json)
        write_json(*out, command, audited, deck->work_units());
    else
        write_text(*out, command, audited, deck->work_units());
    if (const int status = finish(*out); status != exit_clean) return status;
    return audited.result.within ? exit_clean : exit_findings;
}

} // namespace drawbead
