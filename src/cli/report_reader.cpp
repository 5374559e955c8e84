#include "cli/report_reader.h"

#include "deck/file_reader.h"
#include "report/utf8.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>

namespace drawbead {

namespace {

using Json = nlohmann::ordered_json;

/// What is wrong with a document, by the way to the member.
struct Wrong {
    std::string what;
};

/// A value and how it was reached. A value of another kind than asked for is noted in `wrong`, the first one
/// only, and is as if it were 0 or empty.
class Value {
public:
    Value(const Json* json, std::string way, Wrong& wrong)
        : json_(json), way_(std::move(way)), wrong_(&wrong) {}

    bool has(const char* key) const { return json_ && json_->is_object() && json_->contains(key); }
    bool is_null() const { return json_ && json_->is_null(); }
    Value operator[](const char* key) const {
        if (has(key)) return {&(*json_)[key], way_ + (way_.empty() ? "" : ".") + key, *wrong_};
        note(way_.empty() ? "" : way_ + ".", std::string("\"") + key + "\" is missing");
        return {nullptr, {}, *wrong_};
    }
    std::string text() const {
        return is(json_ && json_->is_string(), "a text") ? json_->get<std::string>() : "";
    }
    uint64_t count() const {
        return is(json_ && json_->is_number_unsigned(), "a count") ? json_->get<uint64_t>() : 0;
    }
    uint32_t column() const { return static_cast<uint32_t>(std::min<uint64_t>(count(), UINT32_MAX)); }
    int64_t integer() const {
        return is(json_ && json_->is_number_integer(), "an integer") ? json_->get<int64_t>() : 0;
    }
    /// null stands for what JSON cannot hold.
    double number() const {
        if (is_null()) return std::numeric_limits<double>::quiet_NaN();
        return is(json_ && json_->is_number(), "a number") ? json_->get<double>() : 0;
    }
    template <class Use>
    void each(const Use& use) const {
        if (!is(json_ && json_->is_array(), "a list")) return;
        for (std::size_t i = 0; i < json_->size(); ++i)
            use(Value(&(*json_)[i], way_ + '[' + std::to_string(i) + ']', *wrong_));
    }
    template <class Use>
    void each_member(const Use& use) const {
        if (!is(json_ && json_->is_object(), "an object")) return;
        for (const auto& [key, value] : json_->items())
            use(key, Value(&value, way_ + '.' + key, *wrong_));
    }
    std::vector<int64_t> integers() const {
        std::vector<int64_t> list;
        each([&](const Value& v) { list.push_back(v.integer()); });
        return list;
    }
    std::vector<int> messages() const {
        std::vector<int> list;
        each([&](const Value& v) { list.push_back(static_cast<int>(v.integer())); });
        return list;
    }
    std::vector<std::string> texts() const {
        std::vector<std::string> list;
        each([&](const Value& v) { list.push_back(v.text()); });
        return list;
    }
    /// One of the names of an enumeration.
    template <class T>
    T one_of(std::optional<T> value) const {
        is(value.has_value(), "a known word");
        return value.value_or(T{});
    }

private:
    bool is(bool right, const char* what) const {
        if (!right && json_) note(way_, std::string(" is not ") + what);
        return right;
    }
    void note(const std::string& way, const std::string& what) const {
        if (wrong_->what.empty()) wrong_->what = way + what;
    }

    const Json* json_;
    std::string way_;
    Wrong* wrong_;
};

/// Puts the bytes back that JSON could not hold: `texts` has every text with a U+FFFD in it, in order.
void restore(Json& json, const std::vector<std::string>& texts, std::size_t& next, int depth = 0) {
    constexpr int deepest = 32; // of a report it is 8
    if (json.is_string()) {
        const auto& text = json.get_ref<const std::string&>();
        if (text.find("\xef\xbf\xbd") != std::string::npos && next < texts.size())
            json = percent_decoded(texts[next++]);
    } else if (json.is_structured() && depth < deepest) {
        for (Json& part : json)
            restore(part, texts, next, depth + 1);
    }
}

void restore_bytes(Json& deck) {
    if (!deck.is_object() || !deck.contains("raw_texts")) return;
    const Json raw = deck["raw_texts"];
    deck.erase("raw_texts");
    std::vector<std::string> texts;
    if (raw.is_array())
        for (const Json& text : raw)
            texts.push_back(text.is_string() ? text.get<std::string>() : "");
    std::size_t next = 0;
    restore(deck, texts, next);
}

void read_characters(const Value& json, ResolvedPlace& place) {
    if (json.has("character_column")) place.character_column = json["character_column"].column();
    if (json.has("end_character_column")) place.end_character_column = json["end_character_column"].column();
}

ResolvedPlace place_of(const Value& json) {
    ResolvedPlace place;
    place.file = json["file"].text();
    place.line = json["line"].count();
    place.column = json["column"].column();
    place.end_column = json["end_column"].column();
    if (json.has("snippet")) place.snippet = json["snippet"].text();
    read_characters(json, place);
    return place;
}

EntityList list_of(const Value& ids, const Value& count) {
    return {count.count(), ids.integers()};
}

FixOffer offer_of(const Value& json) {
    FixOffer offer;
    offer.title = json["title"].text();
    offer.applicability =
        json["applicability"].text() == "safe" ? FixAvailability::safe : FixAvailability::unsafe;
    if (!json.has("changes")) return offer;
    json["changes"].each([&](const Value& file) {
        FileChange change{file["file"].text(), {}};
        file["edits"].each([&](const Value& one) {
            FileEdit edit;
            edit.offset = one["offset"].count();
            edit.removed = one["removed"].count();
            edit.where.line = one["line"].count();
            edit.where.column = one["column"].column();
            edit.end_line = one["end_line"].count();
            edit.where.end_column = one["end_column"].column();
            read_characters(one, edit.where);
            edit.text = one["text"].text();
            change.edits.push_back(std::move(edit));
        });
        offer.changes.push_back(std::move(change));
    });
    return offer;
}

Finding finding_of(const Value& json) {
    Finding f;
    f.code = json["code"].text();
    f.name = json["name"].text();
    const Value severity = json["severity"];
    f.severity = severity.one_of(severity_from(severity.text()));
    f.message = json["message"].text();
    if (const Value id = json["interface"]; !id.is_null()) f.interface_id = id.integer();
    json["places"].each([&](const Value& place) { f.places.push_back(place_of(place)); });
    f.place_count = json["place_count"].count();
    const Value ids = json["entities"], counts = json["entity_counts"];
    f.entities.nodes = list_of(ids["nodes"], counts["nodes"]);
    f.entities.segments = list_of(ids["segments"], counts["segments"]);
    f.entities.elements = list_of(ids["elements"], counts["elements"]);
    json["measured"].each_member([&](const std::string& name, const Value& measure) {
        f.measured.push_back({name, measure["value"].number(), measure["unit"].text()});
    });
    f.notes = json["notes"].texts();
    f.help = json["help"].text();
    json["fixes"].each([&](const Value& fix) { f.fixes.push_back(offer_of(fix)); });
    f.fingerprint = json["fingerprint"].text();
    return f;
}

DeckInfo info_of(const Value& json) {
    DeckInfo info;
    info.version = static_cast<int>(json["version"].integer());
    info.run_name = json["run_name"].text();
    const Value work = json["units"]["work"], input = json["units"]["input"];
    info.mass_unit = work["mass"].text();
    info.length_unit = work["length"].text();
    info.time_unit = work["time"].text();
    info.input_mass_unit = input["mass"].text();
    info.input_length_unit = input["length"].text();
    info.input_time_unit = input["time"].text();
    info.files = json["files"].texts();
    info.bytes = json["bytes"].count();
    info.nodes = json["nodes"].count();
    info.shells4 = json["shells4"].count();
    info.shells3 = json["shells3"].count();
    info.solids = json["solids"].count();
    info.parts = json["parts"].count();
    json["interfaces_type8"].each([&](const Value& one) {
        info.interfaces.push_back({one["id"].integer(), one["title"].text(), one["nodes"].count(),
                                   one["segments"].count(), one["length"].number()});
    });
    json["keywords"].each_member(
        [&](const std::string& keyword, const Value& blocks) { info.keywords[keyword] = blocks.count(); });
    return info;
}

BaselineEntry entry_of(const Value& json) {
    BaselineEntry entry{json["fingerprint"].text(), json["code"].text(), std::nullopt, json["count"].count()};
    if (const Value interface_id = json["interface"]; !interface_id.is_null())
        entry.interface_id = interface_id.integer();
    return entry;
}

DeckResult deck_of(const Value& json) {
    DeckResult deck;
    deck.path = json["path"].text();
    // Reports of the time before it stood with each deck do not have it.
    if (json.has("fail_on")) {
        const std::string word = json["fail_on"].text();
        deck.fail_on = severity_from(word);
        if (word != "never") json["fail_on"].one_of(deck.fail_on);
    }
    if (const Value failure = json["failure"]; !failure.is_null()) {
        deck.failure = failure["message"].text();
        deck.failure_help = failure["help"].text();
        deck.failure_place.file = failure["file"].text();
        deck.failure_place.line = failure["line"].count();
        deck.failure_place.column = deck.failure_place.end_column = failure["column"].column();
        return deck;
    }
    deck.info = info_of(json["info"]);
    if (const Value starter = json["starter"]; !starter.is_null()) {
        deck.starter.emplace();
        deck.starter->messages = starter["messages"].messages();
        starter["interfaces"].each([&](const Value& one) {
            deck.starter->interfaces.push_back(
                {one["id"].integer(), one["messages"].messages(), one["nodes_346"].integers()});
        });
    }
    json["findings"].each([&](const Value& finding) { deck.findings.push_back(finding_of(finding)); });
    // Reports of the time before suppressions and baselines do not have these.
    if (json.has("suppressed")) deck.suppressed = json["suppressed"].count();
    if (json.has("known")) deck.known = json["known"].count();
    if (json.has("gone"))
        json["gone"].each([&](const Value& entry) { deck.gone.push_back(entry_of(entry)); });
    return deck;
}

/// The place of a byte as a person counts.
Error at_byte(const std::string& path, std::string_view text, std::size_t byte, std::string message) {
    const std::string_view before = text.substr(0, byte ? byte - 1 : 0);
    const std::size_t line_end = before.rfind('\n');
    const std::size_t column = before.size() - (line_end == std::string_view::npos ? 0 : line_end + 1) + 1;
    return {std::move(message), path,
            static_cast<uint64_t>(std::count(before.begin(), before.end(), '\n')) + 1,
            static_cast<uint32_t>(column), "give reports that 'drawbead check --format json' wrote"};
}

/// Parses without exceptions and keeps the place of the first mistake.
struct Builder : nlohmann::detail::json_sax_dom_parser<Json> {
    explicit Builder(Json& document) : json_sax_dom_parser(document, false) {}
    bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception&) {
        wrong_at = position;
        return false;
    }
    std::size_t wrong_at = 0;
};

} // namespace

Result<ReadReport> read_report(const std::string& path) {
    DiskReader disk;
    const Result<FileBytes> bytes = disk.read(path);
    if (!bytes) return bytes.error();
    return parse_report(bytes->view(), path);
}

Result<ReadReport> parse_report(std::string_view text, const std::string& path) {
    Json json;
    Builder builder(json);
    if (!Json::sax_parse(text.begin(), text.end(), &builder))
        return at_byte(path, text, builder.wrong_at, "this is no JSON, or it is cut");
    Wrong wrong;
    const Value root(&json, "", wrong);
    ReadReport report;
    report.path = path;
    if (!json.is_object() || !root.has("tool") || root["tool"].text() != "drawbead" || !root.has("summary") ||
        !root.has("decks"))
        return Error{"this is no report of 'drawbead check --format json'", path, 0, 0, ""};
    if (const uint64_t schema = root["schema"].count(); schema != 1)
        return Error{"the report is of schema " + std::to_string(schema) + ", and 1 is the one known here",
                     path, 0, 0, "use the drawbead that wrote it, or a later one"};
    report.tool_version = root["version"].text();
    if (root.has("shard")) report.shard = {root["shard"]["number"].count(), root["shard"]["of"].count()};
    const Value summary = root["summary"];
    report.asked = summary["decks"].count();
    if (summary.has("interrupted")) {
        report.interrupted = true;
        report.asked = summary["asked"].count();
    }
    if (json["decks"].is_array())
        for (Json& deck : json["decks"])
            restore_bytes(deck);
    root["decks"].each([&](const Value& deck) { report.decks.push_back(deck_of(deck)); });
    if (!wrong.what.empty()) return Error{"not a report as it should be: " + wrong.what, path, 0, 0, ""};
    if (report.shard && (report.shard->number < 1 || report.shard->number > report.shard->of))
        return Error{"not a report as it should be: shard " + std::to_string(report.shard->number) + " of " +
                         std::to_string(report.shard->of),
                     path, 0, 0, ""};
    return report;
}

} // namespace drawbead
