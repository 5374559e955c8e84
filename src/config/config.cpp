#include "config/config.h"

#include "base/nearest.h"
#include "config/options.h"
#include "config/yaml_tree.h"
#include "report/json.h"
#include "rules/check.h"
#include "rules/limits.h"
#include "rules/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <set>

namespace drawbead {

std::string Origin::text() const {
    if (file.empty()) return "default";
    if (line == 0) return file;
    return file + ":" + std::to_string(line) + ":" + std::to_string(column);
}

namespace {

using Words = std::vector<std::string>;
using Shape = YamlNode::Kind;

std::string known_words(const Words& words) {
    std::string text = "known here:";
    for (const std::string& word : words)
        text += (text.back() == ':' ? " " : ", ") + word;
    return text;
}

/// Reads a tree and stops at the first mistake.
class ConfigParser {
public:
    explicit ConfigParser(const std::string& path) : path_(path) { config_.path = path; }

    Result<Config> parse(const YamlNode& root) {
        if (root.kind == Shape::empty) return std::move(config_); // a file of comments only
        if (root.kind != Shape::map)
            fail(root, "a configuration is a map of keys", "it may begin with: ignore: [ENG]");
        else
            read_choices(root, ConfigOption::Where::file, config_.choices);
        if (error_) return *error_;
        return std::move(config_);
    }

private:
    const std::string& path_;
    Config config_;
    std::optional<Error> error_;

    void fail(const YamlNode& node, std::string message, std::string help = {}) {
        if (!error_) error_ = Error{std::move(message), path_, node.line, node.column, std::move(help)};
    }
    void fail_unknown(const YamlNode& node, const std::string& what, const Words& words) {
        const std::string help = did_you_mean(node.text, words);
        fail(node, what + " " + drawbead::quoted(node.text), help.empty() ? known_words(words) : help);
    }
    Origin origin(const YamlNode& node) const { return {path_, node.line, node.column}; }

    std::string text(const YamlNode& node, const std::string& what) {
        if (node.kind == Shape::scalar && !node.text.empty()) return node.text;
        fail(node, what + " needs a word");
        return {};
    }

    /// One word or a list of them.
    std::vector<const YamlNode*> words(const YamlNode& node, const std::string& what) {
        std::vector<const YamlNode*> all;
        if (node.kind == Shape::scalar && !node.text.empty()) all.push_back(&node);
        for (const YamlNode& item : node.items) {
            text(item, "an entry of " + what);
            all.push_back(&item);
        }
        if (node.kind != Shape::list && all.empty()) fail(node, what + " needs a word or a list");
        return all;
    }

    /// A word that names rules, as Selection wants it.
    std::string rule_word(const YamlNode& node) {
        for (const std::string& word : {upper_case(node.text), node.text})
            if (!Selection{{word}, {}}.unknown()) return word;
        std::string help = did_you_mean(node.text, all_rule_words());
        if (help.empty()) help = "'drawbead rules' lists all";
        fail(node, "no rule or family " + drawbead::quoted(node.text), help);
        return {};
    }

    Chosen<Words> rules(const YamlNode& node, const std::string& what) {
        Chosen<Words> out{{}, origin(node)};
        for (const YamlNode* word : words(node, what))
            if (!error_) out.value.push_back(rule_word(*word));
        return out;
    }

    Chosen<Words> paths(const YamlNode& node, const std::string& what, bool beside) {
        Chosen<Words> out{{}, origin(node)};
        const std::filesystem::path folder = std::filesystem::path(path_).parent_path();
        for (const YamlNode* word : words(node, what))
            out.value.push_back(beside ? (folder / word->text).lexically_normal().string() : word->text);
        return out;
    }

    Words patterns(const YamlNode& node) {
        for (const YamlNode* word : words(node, "paths"))
            if (word->text.find_first_not_of("./") == std::string::npos && word->text != "./")
                fail(*word, "no deck has a path like " + drawbead::quoted(word->text),
                     "./ stands for all decks below the folder of this file");
        return paths(node, "paths", false).value;
    }

    void severities(const YamlNode& node, Choices& choices) {
        if (node.kind != Shape::map) return fail(node, "severity needs a map", "such as {LIN005: error}");
        std::map<std::string, const YamlNode*> named;
        for (const auto& [key, value] : node.entries) {
            std::string word = rule_word(key);
            if (const Rule* rule = find_rule(word)) word = rule->info.code; // of a code or a name
            const auto [first, is_new] = named.emplace(word, &key);
            if (!is_new)
                fail(key,
                     drawbead::quoted(key.text) + " is " + drawbead::quoted(first->second->text) +
                         " of line " + std::to_string(first->second->line) + " again",
                     "leave one of the two");
            const std::string name = text(value, "a severity");
            const std::optional<Severity> severity = severity_from(name);
            if (!error_ && !severity) fail_unknown(value, "severity knows no", {"error", "warning", "info"});
            if (error_) return;
            choices.severity[word] = {*severity, origin(value)};
        }
    }

    void fail_on(const YamlNode& node, Choices& choices) {
        const Words words(fail_on_words().begin(), fail_on_words().end());
        const std::string word = text(node, "fail-on");
        if (!error_ && std::find(words.begin(), words.end(), word) == words.end())
            fail_unknown(node, "fail-on knows no", words);
        choices.fail_on = {word, origin(node)};
    }

    void limits(const YamlNode& node, Choices& choices) {
        if (node.kind != Shape::map)
            return fail(node, "limits needs a map", "such as {LIN005: {turn-degrees: 30}}");
        const auto table = limit_table();
        for (const auto& [rule, values] : node.entries) {
            Words codes, keys;
            for (const LimitInfo& limit : table) {
                if (codes.empty() || codes.back() != limit.rule) codes.emplace_back(limit.rule);
                if (limit.rule == rule.text) keys.push_back(limit.key());
            }
            if (keys.empty()) {
                if (const Rule* known = find_rule(rule.text);
                    known != nullptr && known->info.code == rule.text)
                    return fail(rule, rule.text + " has no limits",
                                "'drawbead explain configuration' lists all");
                const Rule* named = find_rule(rule.text);
                if (named != nullptr)
                    return fail(rule, "limits go by codes", "write " + std::string(named->info.code));
                return fail_unknown(rule, "no rule with limits", codes);
            }
            if (values.kind != Shape::map) return fail(values, rule.text + " needs a map of limits");
            for (const auto& [key, value] : values.entries) {
                const auto at = std::find_if(table.begin(), table.end(), [&](const LimitInfo& limit) {
                    return limit.rule == rule.text && limit.key() == key.text;
                });
                if (at == table.end()) return fail_unknown(key, rule.text + " has no limit", keys);
                const std::optional<double> given = limit_value(value, *at);
                if (!given) return;
                choices.limits[static_cast<std::size_t>(at - table.begin())] = {*given, origin(value)};
            }
        }
    }

    std::optional<double> limit_value(const YamlNode& node, const LimitInfo& limit) {
        const std::string what = std::string(limit.rule) + " " + limit.key();
        double value = 0;
        const char* begin = node.text.data();
        const char* const end = begin + node.text.size();
        if (node.text.size() > 1 && node.text[0] == '+' && node.text[1] != '-') ++begin; // of YAML's numbers
        const auto [stop, code] = std::from_chars(begin, end, value);
        const bool whole = node.kind == Shape::scalar && !node.quoted && code == std::errc() && stop == end;
        if (!whole || !std::isfinite(value)) {
            fail(node,
                 what + " needs a number" +
                     (node.kind == Shape::scalar ? ", not " + drawbead::quoted(node.text) : std::string()));
            return std::nullopt;
        }
        if (value < limit.least || value > limit.most) {
            fail(node, what + " must be " + json_number(limit.least) + " to " + json_number(limit.most) +
                           (limit.unit.empty() ? "" : " " + std::string(limit.unit)) + ", not " + node.text);
            return std::nullopt;
        }
        return value;
    }

    void overrides(const YamlNode& node) {
        if (node.kind != Shape::list)
            return fail(node, "overrides needs a list", "each entry begins with - paths:");
        for (const YamlNode& item : node.items) {
            if (item.kind != Shape::map)
                return fail(item, "an override needs a map", "it begins with paths:");
            Override one;
            for (const auto& [key, value] : item.entries)
                if (key.text == "paths") one.paths = patterns(value);
            if (one.paths.empty()) fail(item, "an override needs paths", "such as paths: [legacy/]");
            read_choices(item, ConfigOption::Where::override, one.choices);
            if (error_) return;
            config_.overrides.push_back(std::move(one));
        }
    }

    void read_choices(const YamlNode& map, ConfigOption::Where where, Choices& choices) {
        Words keys;
        for (const ConfigOption& option : config_options())
            if (option.where == ConfigOption::Where::both || option.where == where)
                keys.emplace_back(option.key);
        for (const auto& [key, value] : map.entries) {
            if (error_) return;
            if (std::find(keys.begin(), keys.end(), key.text) == keys.end()) {
                const auto options = config_options();
                const bool elsewhere =
                    std::any_of(options.begin(), options.end(),
                                [&, word = key.text](const ConfigOption& o) { return o.key == word; });
                if (elsewhere)
                    return fail(key,
                                "key " + drawbead::quoted(key.text) +
                                    (where == ConfigOption::Where::file ? " stands in an override only"
                                                                        : " cannot stand in an override"));
                return fail_unknown(key, "unknown key", keys);
            }
            if (key.text == "select") {
                choices.select = rules(value, key.text);
                if (choices.select->value.empty())
                    fail(value, "select needs a rule at least", "leave it out, or write ALL");
            } else if (key.text == "ignore")
                choices.ignore = rules(value, key.text);
            else if (key.text == "severity")
                severities(value, choices);
            else if (key.text == "fail-on")
                fail_on(value, choices);
            else if (key.text == "include-path")
                choices.include_path = paths(value, key.text, true);
            else if (key.text == "limits")
                limits(value, choices);
            else if (key.text == "overrides")
                overrides(value);
        }
    }
};

} // namespace

Result<Config> parse_config(std::string_view text, const std::string& path) {
    const Result<YamlNode> root = read_yaml(text, path);
    if (!root) return root.error();
    return ConfigParser(path).parse(*root);
}

} // namespace drawbead
