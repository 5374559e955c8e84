#include "config/options.h"

#include "report/json.h"
#include "rules/limits.h"
#include "rules/rule.h"

#include <algorithm>
#include <array>
#include <set>

namespace drawbead {

std::span<const ConfigOption> config_options() {
    using Value = ConfigOption::Kind;
    using Where = ConfigOption::Where;
    static constexpr std::array table{
        ConfigOption{"select", Value::rules, Where::both, "ALL", "Rules to run."},
        ConfigOption{"ignore", Value::rules, Where::both, "[]",
                     "Rules not to run; it wins over select where it is as precise or more."},
        ConfigOption{"severity", Value::severities, Where::both, "{}",
                     "Severities instead of the rules' own; the most precise name counts."},
        ConfigOption{"fail-on", Value::fail_on, Where::both, "error",
                     "Least severity that gives exit status 1."},
        ConfigOption{"include-path", Value::folders, Where::file, "[]",
                     "Further folders to look for includes in, relative to the file."},
        ConfigOption{"limits", Value::limits, Where::both, "{}", "Limits of rules, see below."},
        ConfigOption{"overrides", Value::overrides, Where::file, "[]",
                     "What holds for some decks only; of several that fit, the later one wins."},
        ConfigOption{"paths", Value::paths, Where::override, "-",
                     "The decks that an override is for: patterns relative to the file."},
    };
    return table;
}

std::span<const std::string_view> fail_on_words() {
    static constexpr std::array<std::string_view, 4> words{"error", "warning", "info", "never"};
    return words;
}

std::vector<std::string> all_rule_words() {
    std::vector<std::string> words;
    std::set<std::string> families;
    for (const Rule& rule : registry()) {
        words.emplace_back(rule.info.code);
        families.emplace(rule.info.family());
    }
    words.insert(words.end(), families.begin(), families.end());
    words.emplace_back("ALL");
    for (const Rule& rule : registry())
        words.emplace_back(rule.info.name);
    return words;
}

namespace {

/// Texts of the tables are plain ASCII without quotes and backslashes in need of more (a test sees to it).
std::string in_quotes(std::string_view text) {
    return '"' + std::string(text) + '"';
}

std::string with_default(const ConfigOption& option) {
    std::string text(option.text);
    if (option.usual != "-") text += " Default: " + std::string(option.usual) + ".";
    return text;
}

std::string schema_of(const ConfigOption& option) {
    using Value = ConfigOption::Kind;
    const std::string text = ", \"description\": " + in_quotes(with_default(option)) + "}";
    switch (option.kind) {
    case Value::rules:
        return option.key == "select" ? "{\"$ref\": \"#/definitions/some-rules\"" + text
                                      : "{\"$ref\": \"#/definitions/rules\"" + text;
    case Value::severities:
        return "{\"$ref\": \"#/definitions/severity\"" + text;
    case Value::fail_on: {
        std::string words;
        for (const std::string_view word : fail_on_words())
            words += (words.empty() ? "" : ", ") + in_quotes(word);
        return "{\"enum\": [" + words + "]" + text;
    }
    case Value::folders:
        return "{\"$ref\": \"#/definitions/paths\"" + text;
    case Value::paths:
        return "{\"$ref\": \"#/definitions/patterns\"" + text;
    case Value::limits:
        return "{\"$ref\": \"#/definitions/limits\"" + text;
    case Value::overrides:
        break;
    }
    return "{\"type\": \"array\", \"items\": {\"$ref\": \"#/definitions/override\"}" + text;
}

std::string properties(const char* indent, ConfigOption::Where where) {
    std::string out;
    for (const ConfigOption& option : config_options()) {
        if (option.where != ConfigOption::Where::both && option.where != where) continue;
        out += (out.empty() ? "" : ",\n") + std::string(indent) + in_quotes(option.key) + ": " +
               schema_of(option);
    }
    return out + "\n";
}

/// Calls act(rule, its limits) by rule.
template <class Act>
void each_rule_with_limits(Act&& act) {
    const auto all = limit_table();
    for (std::size_t i = 0; i < all.size();) {
        std::size_t end = i;
        while (end < all.size() && all[end].rule == all[i].rule)
            ++end;
        act(all[i].rule, all.subspan(i, end - i));
        i = end;
    }
}

std::string limits_schema() {
    std::string out;
    each_rule_with_limits([&](std::string_view rule, std::span<const LimitInfo> limits) {
        out += (out.empty() ? "" : ",\n") + std::string("        ") + in_quotes(rule) +
               ": {\n          \"type\": \"object\",\n          \"additionalProperties\": false,\n"
               "          \"properties\": {\n";
        for (const LimitInfo& limit : limits) {
            std::string text(limit.text);
            std::replace(text.begin(), text.end(), '`', '\'');
            if (!limit.unit.empty()) text += " In " + std::string(limit.unit) + ".";
            out += "            " + in_quotes(limit.key()) +
                   ": {\"type\": \"number\", \"minimum\": " + json_number(limit.least) +
                   ", \"maximum\": " + json_number(limit.most) +
                   ", \"default\": " + json_number(limit.usual) + ", \"description\": " + in_quotes(text) +
                   "}" + (&limit == &limits.back() ? "\n" : ",\n");
        }
        out += "          }\n        }";
    });
    return out + "\n";
}

} // namespace

std::string config_schema() {
    using Where = ConfigOption::Where;
    return R"({
  "$schema": "http://json-schema.org/draft-07/schema#",
  "title": "drawbead configuration",
  "description": "What .drawbead.yaml holds, as YAML. Made from the table of options in the program.",
  "type": ["object", "null"],
  "additionalProperties": false,
  "properties": {
)" + properties("    ", Where::file) +
           R"(  },
  "definitions": {
    "word": {"type": "string", "minLength": 1, "description": "Code, family or name of a rule, or ALL; letter case of codes does not matter."},
    "rules": {"oneOf": [{"$ref": "#/definitions/word"}, {"type": "array", "items": {"$ref": "#/definitions/word"}}]},
    "some-rules": {"oneOf": [{"$ref": "#/definitions/word"}, {"type": "array", "minItems": 1, "items": {"$ref": "#/definitions/word"}}]},
    "paths": {"oneOf": [{"type": "string", "minLength": 1}, {"type": "array", "items": {"type": "string", "minLength": 1}}]},
    "patterns": {"oneOf": [{"type": "string", "minLength": 1}, {"type": "array", "minItems": 1, "items": {"type": "string", "minLength": 1}}]},
    "severity": {"type": "object", "additionalProperties": {"enum": ["error", "warning", "info"]}},
    "limits": {
      "type": "object",
      "additionalProperties": false,
      "properties": {
)" + limits_schema() +
           R"(      }
    },
    "override": {
      "type": "object",
      "required": ["paths"],
      "additionalProperties": false,
      "properties": {
)" + properties("        ", Where::override) +
           R"(      }
    }
  }
}
)";
}

std::string config_page() {
    std::string out = R"(# Configuration

<!-- Made from the table of options in the program by docs/make_configuration.py: change src/config/options.cpp and
src/rules/limits.h, not this file. -->

`drawbead check` and `drawbead fix` read `.drawbead.yaml`. It is looked for in the folder of each deck, then in the folders above; the first one found holds for the deck, and nothing is taken from those further up. `--config FILE` takes this file for all decks, `--isolated` takes none. A deck from standard input is looked at where `--stdin-filename` says, else in the current folder.

```yaml
select: ALL
ignore: [ENG, LIN010]
severity:
  LIN005: error
limits:
  LIN005:
    turn-degrees: 30
overrides:
  - paths: legacy/
    ignore: [ENG, LIN]
```

The command line wins over overrides, these over the rest of the file, and the file over the defaults. Each of `select`, `ignore`, `fail-on` and `include-path` takes the whole place of what it wins over; `severity` and `limits` are joined entry by entry.

`drawbead check --show-config PATH…` prints what holds for each deck, as a file that can be used again, with the place of each value beside it. A file with a mistake stops the run before any deck is read, with exit status 2. `drawbead schema config` prints the JSON Schema for editors.

A severity changes what is printed and the exit status. It changes neither what a repair may leave behind nor what `drawbead` says of the Starter's messages.

## Keys

| key | value | default | what it does |
|---|---|---|---|
)";
    using Value = ConfigOption::Kind;
    for (const ConfigOption& option : config_options()) {
        const auto value = [&]() -> std::string_view {
            switch (option.kind) {
            case Value::rules:
                return "codes, families (`SRF`), names or `ALL`";
            case Value::severities:
                return "a map from these to `error`, `warning` or `info`";
            case Value::fail_on:
                return "`error`, `warning`, `info` or `never`";
            case Value::folders:
                return "a folder or a list";
            case Value::limits:
                return "a map from codes to maps";
            case Value::paths:
                return "a pattern or a list";
            case Value::overrides:
                break;
            }
            return "a list of maps";
        };
        const bool only_override = option.where == ConfigOption::Where::override;
        out += "| `" + std::string(option.key) + "`" + (only_override ? " (in overrides)" : "") + " | " +
               std::string(value()) + " | " +
               (option.usual == "-" ? "" : "`" + std::string(option.usual) + "`") + " | " +
               std::string(option.text) + " |\n";
    }
    out += "\nAn override has `paths` and any of";
    for (const ConfigOption& option : config_options())
        if (option.where == ConfigOption::Where::both) out += " `" + std::string(option.key) + "`";
    out += R"(.

In patterns `*`, `?` and `[…]` stay within one name and `**` stands for any number of folders. A pattern without a `/` is held against the name of the deck in any folder; one that ends with `/` means all decks below that folder. Patterns are relative to the folder of the file.

## Limits

Keys with a unit in their name are in this unit whatever the deck's units are; all others are ratios. A value must lie in its range. `drawbead explain CODE` says more about a rule.

| rule | key | default | range | unit | what it does |
|---|---|---|---|---|---|
)";
    for (const LimitInfo& limit : limit_table())
        out += "| " + std::string(limit.rule) + " | `" + limit.key() + "` | " + json_number(limit.usual) +
               " | " + json_number(limit.least) + " to " + json_number(limit.most) + " | " +
               std::string(limit.unit) + " | " + std::string(limit.text) + " |\n";
    return out;
}

} // namespace drawbead
