#include "report/fix_report.h"

#include "report/json.h"
#include "report/text.h"

#include <charconv>

namespace drawbead {

namespace {

std::string number_text(double value) {
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 6);
    return {buffer, end.ptr};
}

std::string force_text(double value, const FixReport& report) {
    return number_text(value) + (report.force_unit.empty() ? "" : " " + report.force_unit);
}

std::string messages_text(const std::vector<int>& messages) {
    std::string text;
    for (const int m : messages)
        text += (text.empty() ? "" : ", ") + std::to_string(m);
    return text.empty() ? "nothing" : text;
}

/// "a" where nothing changed, "a -> b" where it did.
std::string change(const std::string& before, const std::string& after) {
    return before == after ? before : before + " -> " + after;
}

using State = InterfaceOutcome::State;

std::string interface_line(const FixReport& report, const InterfaceOutcome& one) {
    std::string text = "bead " + std::to_string(one.id);
    if (!one.title.empty()) text += " '" + terminal_safe(one.title) + "'";
    if (!one.before) text += " (new)";
    text += ": ";
    if (!one.after) return text + "removed";
    if (one.segments_turned) text += how_many(one.segments_turned, "segment") + " turned, ";
    if (one.nodes_moved) text += how_many(one.nodes_moved, "node") + " moved, ";
    const State& after = *one.after;
    const State& before = one.before ? *one.before : after;
    text += "nodes " + change(std::to_string(before.nodes), std::to_string(after.nodes));
    text += "; sum of Fn L " + change(force_text(before.fn, report), force_text(after.fn, report));
    text += ", of Ft L " + change(force_text(before.ft, report), force_text(after.ft, report));
    if (!after.slope.empty() || !before.slope.empty()) text += "; slope " + change(before.slope, after.slope);
    text += "; the Starter says " + change(messages_text(before.messages), messages_text(after.messages));
    return text;
}

void write_state(JsonWriter& json, std::string_view key, const std::optional<State>& state) {
    json.key(key);
    if (!state) return json.null();
    json.begin_object();
    json.member("nodes", state->nodes);
    json.member("fn_total", state->fn);
    json.member("ft_total", state->ft);
    json.member("slope", state->slope);
    json.member_list("starter_messages", state->messages);
    json.end();
}

void write_place(JsonWriter& json, const ResolvedPlace& place) {
    json.member("file", place.file);
    json.member("line", place.line);
    json.member("column", place.column);
}

void write_interface_id(JsonWriter& json, const std::optional<int64_t>& id) {
    json.key("interface");
    if (id)
        json.value(*id);
    else
        json.null();
}

void write_deck(JsonWriter& json, const FixReport& report) {
    json.begin_object();
    json.member("path", report.path);
    json.key("failure");
    if (report.failed()) {
        json.begin_object();
        json.member("message", report.failure);
        json.member("help", report.failure_help);
        json.end();
    } else {
        json.null();
    }
    json.member("force_unit", report.force_unit);
    json.key("applied");
    json.begin_array();
    for (const AppliedFix& fix : report.applied) {
        json.begin_object();
        json.member("code", fix.code);
        json.member("name", fix.name);
        json.member("title", fix.title);
        json.member("applicability", fix.safe ? "safe" : "unsafe");
        write_interface_id(json, fix.interface_id);
        write_place(json, fix.place);
        json.member("message", fix.message);
        json.end();
    }
    json.end();
    json.key("not_applied");
    json.begin_array();
    for (const DeclinedFix& fix : report.declined) {
        json.begin_object();
        json.member("code", fix.code);
        json.member("name", fix.name);
        json.member("title", fix.title);
        write_interface_id(json, fix.interface_id);
        write_place(json, fix.place);
        json.member("why", fix.why);
        json.member("needs_unsafe", fix.needs_unsafe);
        json.end();
    }
    json.end();
    json.key("interfaces");
    json.begin_array();
    for (const InterfaceOutcome& one : report.interfaces) {
        json.begin_object();
        json.member("id", one.id);
        json.member("title", one.title);
        json.member("segments_turned", one.segments_turned);
        json.member("nodes_moved", one.nodes_moved);
        write_state(json, "before", one.before);
        write_state(json, "after", one.after);
        json.end();
    }
    json.end();
    json.key("files");
    json.begin_array();
    for (const FileChange& file : report.files) {
        json.begin_object();
        json.member("path", file.path);
        json.key("edits");
        json.begin_array();
        for (const FileEdit& e : file.edits) {
            json.begin_object(JsonWriter::Layout::line);
            json.member("offset", e.offset);
            json.member("removed", e.removed);
            json.member("line", e.where.line);
            json.member("column", e.where.column);
            json.member("text", e.text);
            json.end();
        }
        json.end();
        json.end();
    }
    json.end();
    json.member_list("written", report.written);
    json.key("remaining");
    json.begin_object();
    json.member("errors", report.remaining.errors);
    json.member("warnings", report.remaining.warnings);
    json.member("notes", report.remaining.infos);
    json.end();
    json.end();
}

} // namespace

void write_fix_text(OutputSink& out, const FixReport& report, bool colour) {
    const Palette palette(colour);
    const auto line = [&](const ResolvedPlace& place, std::string_view paint, std::string_view verb,
                          const std::string& code, const std::string& name, const std::string& rest) {
        std::string text(palette.bold);
        text += place_text(place) + ":";
        text += palette.reset;
        text += ' ';
        text += paint;
        text += verb;
        text += palette.reset;
        out.write(text + " " + code + " " + name + ": " + terminal_safe(rest) + "\n");
    };
    for (const AppliedFix& fix : report.applied)
        line(fix.place, palette.cyan,
             std::string(report.proposed ? "would fix" : "fixed") + (fix.safe ? ":" : " (unsafe):"), fix.code,
             fix.name, fix.title);
    for (const DeclinedFix& fix : report.declined)
        line(fix.place, palette.yellow, "not fixed:", fix.code, fix.name, fix.why);
    for (const InterfaceOutcome& one : report.interfaces)
        out.write("  " + interface_line(report, one) + "\n");
    std::string text = terminal_safe(report.path) + ": ";
    if (report.applied.empty())
        text += "nothing repaired";
    else
        text += how_many(report.applied.size(), "repair") + " in " + how_many(report.files.size(), "file");
    if (report.proposed && !report.applied.empty()) text += ", nothing written";
    if (!report.written.empty()) {
        text += ", written:";
        for (const std::string& path : report.written)
            text += " " + terminal_safe(path);
    }
    std::string left;
    const auto remains = [&](uint64_t count, std::string_view noun) {
        if (count) left += (left.empty() ? "" : ", ") + how_many(count, noun);
    };
    remains(report.remaining.errors, "error");
    remains(report.remaining.warnings, "warning");
    remains(report.remaining.infos, "note");
    out.write(text + "; " + (left.empty() ? "nothing" : left) + " left\n");
}

void write_fix_json(OutputSink& out, std::span<const FixReport> reports, std::string_view tool_version) {
    JsonWriter json(out);
    json.begin_object();
    json.member("tool", "drawbead");
    json.member("version", tool_version);
    json.member("schema", 1);
    json.key("decks");
    json.begin_array();
    for (const FixReport& report : reports)
        write_deck(json, report);
    json.end();
    json.end();
}

} // namespace drawbead
