#include "report/json_report.h"

#include "report/utf8.h"
#include "report/writer.h"

#include <set>

namespace drawbead {

namespace {

using Layout = JsonWriter::Layout;

void write_units(JsonWriter& json, std::string_view name, const std::string& mass, const std::string& length,
                 const std::string& time) {
    json.key(name);
    json.begin_object(Layout::line);
    json.member("mass", mass);
    json.member("length", length);
    json.member("time", time);
    json.end();
}

void write_characters(JsonWriter& json, const ResolvedPlace& place) {
    if (place.character_column) json.member("character_column", place.character_column);
    if (place.end_character_column) json.member("end_character_column", place.end_character_column);
}

/// The first place of a finding comes with its line.
void write_place(JsonWriter& json, const ResolvedPlace& place, bool first) {
    json.begin_object(Layout::line);
    json.member("file", place.file);
    json.member("line", place.line);
    json.member("column", place.column);
    json.member("end_column", place.end_column);
    write_characters(json, place);
    if (first && !place.snippet.empty()) json.member("snippet", place.snippet);
    json.end();
}

void write_fix(JsonWriter& json, const FixOffer& fix) {
    json.begin_object(fix.changes.empty() ? Layout::line : Layout::block);
    json.member("title", fix.title);
    json.member("applicability", fix.applicability == FixAvailability::safe ? "safe" : "unsafe");
    if (!fix.changes.empty()) {
        json.key("changes");
        json.begin_array();
        for (const FileChange& change : fix.changes) {
            json.begin_object();
            json.member("file", change.path);
            json.key("edits");
            json.begin_array();
            for (const FileEdit& e : change.edits) {
                json.begin_object(Layout::line);
                json.member("offset", e.offset);
                json.member("removed", e.removed);
                json.member("line", e.where.line);
                json.member("column", e.where.column);
                json.member("end_line", e.end_line);
                json.member("end_column", e.where.end_column);
                write_characters(json, e.where);
                json.member("text", e.text);
                json.end();
            }
            json.end();
            json.end();
        }
        json.end();
    }
    json.end();
}

void write_entities(JsonWriter& json, const Entities& entities) {
    json.key("entities");
    json.begin_object();
    json.member_list("nodes", entities.nodes.ids);
    json.member_list("segments", entities.segments.ids);
    json.member_list("elements", entities.elements.ids);
    json.end();
    json.key("entity_counts");
    json.begin_object(Layout::line);
    json.member("nodes", entities.nodes.count);
    json.member("segments", entities.segments.count);
    json.member("elements", entities.elements.count);
    json.end();
}

/// Names are keys; one that comes again gets a number, since keys must differ.
void write_measured(JsonWriter& json, const std::vector<Measure>& measures) {
    json.key("measured");
    json.begin_object();
    std::set<std::string> used;
    for (const Measure& measure : measures) {
        std::string key = measure.name;
        for (int n = 2; !used.insert(key).second; ++n)
            key = measure.name + " " + std::to_string(n);
        json.key(key);
        json.begin_object(Layout::line);
        json.member("value", measure.value);
        json.member("unit", measure.unit);
        json.end();
    }
    json.end();
}

void write_starter(JsonWriter& json, const StarterMessages& starter) {
    json.begin_object();
    json.member_list("messages", starter.messages);
    json.key("interfaces");
    json.begin_array();
    for (const StarterMessages::Interface& one : starter.interfaces) {
        json.begin_object();
        json.member("id", one.id);
        json.member_list("messages", one.messages);
        json.member_list("nodes_346", one.nodes_346);
        json.end();
    }
    json.end();
    json.end();
}

void write_deck(JsonWriter& json, const DeckResult& deck) {
    std::vector<std::string> damaged;
    json.note_damaged(&damaged);
    json.begin_object();
    json.member("path", deck.path);
    json.key("failure");
    if (deck.failed())
        write_failure(json, deck);
    else
        json.null();
    json.key("info");
    if (deck.failed())
        json.null();
    else
        write_info(json, deck.info);
    json.key("starter");
    if (deck.starter)
        write_starter(json, *deck.starter);
    else
        json.null();
    json.key("findings");
    json.begin_array();
    for (const Finding& finding : deck.findings) {
        json.begin_object();
        write_finding_members(json, finding);
        json.end();
    }
    json.end();
    json.member("suppressed", deck.suppressed);
    json.member("known", deck.known);
    json.key("gone");
    json.begin_array();
    for (const BaselineEntry& entry : deck.gone) {
        json.begin_object(Layout::line);
        json.member("code", entry.code);
        json.key("interface");
        if (entry.interface_id)
            json.value(*entry.interface_id);
        else
            json.null();
        json.member("fingerprint", entry.fingerprint);
        json.member("count", entry.count);
        json.end();
    }
    json.end();
    json.member("fail_on", deck.fail_on ? name(*deck.fail_on) : "never");
    json.note_damaged(nullptr);
    if (!damaged.empty()) {
        for (std::string& text : damaged)
            text = percent_encoded(text);
        json.member_list("raw_texts", damaged);
    }
    json.end();
}

class JsonReportWriter final : public ReportWriter {
public:
    JsonReportWriter(OutputSink& out, const WriterOptions& options) : json_(out) {
        json_.begin_object();
        json_.member("tool", "drawbead");
        json_.member("version", options.tool_version);
        json_.member("schema", 1);
        if (options.shard) {
            json_.key("shard");
            json_.begin_object(Layout::line);
            json_.member("number", options.shard->number);
            json_.member("of", options.shard->of);
            json_.end();
        }
        json_.key("decks");
        json_.begin_array();
    }
    void deck(const DeckResult& deck) override { write_deck(json_, deck); }
    void end(const Summary& summary) override {
        json_.end();
        json_.key("summary");
        json_.begin_object();
        write_summary_members(json_, summary);
        json_.end();
        json_.end();
    }

private:
    JsonWriter json_;
};

} // namespace

void write_finding_members(JsonWriter& json, const Finding& finding) {
    json.member("code", finding.code);
    json.member("name", finding.name);
    json.member("severity", name(finding.severity));
    json.member("message", finding.message);
    json.key("interface");
    if (finding.interface_id)
        json.value(*finding.interface_id);
    else
        json.null();
    json.key("places");
    json.begin_array();
    for (const ResolvedPlace& place : finding.places)
        write_place(json, place, &place == &finding.places.front());
    json.end();
    json.member("place_count", std::max<uint64_t>(finding.place_count, finding.places.size()));
    write_entities(json, finding.entities);
    write_measured(json, finding.measured);
    json.key("notes");
    json.begin_array();
    for (const std::string& note : finding.notes)
        json.value(note);
    json.end();
    json.member("help", finding.help);
    json.key("fixes");
    json.begin_array();
    for (const FixOffer& fix : finding.fixes)
        write_fix(json, fix);
    json.end();
    json.member("fingerprint", finding.fingerprint);
}

void write_failure(JsonWriter& json, const DeckResult& deck) {
    json.begin_object();
    json.member("message", deck.failure);
    json.member("help", deck.failure_help);
    json.member("file", deck.failure_place.file.empty() ? deck.path : deck.failure_place.file);
    json.member("line", deck.failure_place.line);
    json.member("column", deck.failure_place.column);
    json.end();
}

void write_summary_members(JsonWriter& json, const Summary& summary) {
    json.member("decks", summary.decks);
    json.member("failed", summary.failed);
    json.member("interfaces", summary.interfaces);
    json.member("errors", summary.errors);
    json.member("warnings", summary.warnings);
    json.member("infos", summary.infos);
    json.member("suppressed", summary.suppressed);
    json.member("known", summary.known);
    json.member("gone", summary.gone);
    if (summary.interrupted) {
        json.member("interrupted", true);
        json.member("asked", summary.asked);
    }
}

void write_info(JsonWriter& json, const DeckInfo& info) {
    json.begin_object();
    json.member("version", info.version);
    json.member("run_name", info.run_name);
    json.key("units");
    json.begin_object();
    write_units(json, "work", info.mass_unit, info.length_unit, info.time_unit);
    write_units(json, "input", info.input_mass_unit, info.input_length_unit, info.input_time_unit);
    json.end();
    json.key("files");
    json.begin_array();
    for (const std::string& file : info.files)
        json.value(file);
    json.end();
    json.member("bytes", info.bytes);
    json.member("nodes", info.nodes);
    json.member("shells4", info.shells4);
    json.member("shells3", info.shells3);
    json.member("solids", info.solids);
    json.member("parts", info.parts);
    json.key("interfaces_type8");
    json.begin_array();
    for (const InterfaceSummary& one : info.interfaces) {
        json.begin_object(Layout::line);
        json.member("id", one.id);
        json.member("title", one.title);
        json.member("nodes", one.nodes);
        json.member("segments", one.segments);
        json.member("length", one.length);
        json.end();
    }
    json.end();
    json.key("keywords");
    json.begin_object();
    for (const auto& [keyword, blocks] : info.keywords)
        json.member(keyword, blocks);
    json.end();
    json.end();
}

std::unique_ptr<ReportWriter> json_writer(OutputSink& out, const WriterOptions& options) {
    return std::make_unique<JsonReportWriter>(out, options);
}

} // namespace drawbead
