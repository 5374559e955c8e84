#pragma once
// What a configuration file may say: one table for the reader, the JSON Schema and the page. Limits of rules
// are in rules/limits.h.
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace drawbead {

struct ConfigOption {
    enum class Kind : uint8_t {
        rules,      ///< a code, family or name, or a list of them
        severities, ///< a map from these to a severity
        fail_on,    ///< error, warning, info or never
        folders,    ///< a path or a list of paths, relative to the file
        limits,     ///< a map from codes to maps of limits
        paths,      ///< a pattern or a list of patterns, relative to the file
        overrides,  ///< a list of maps
    };
    enum class Where : uint8_t { file, both, override };

    std::string_view key;
    Kind kind;
    Where where;
    std::string_view usual; ///< as it would be written; "-": none
    std::string_view text;
};
std::span<const ConfigOption> config_options();

/// The words of fail-on, and of severities, which is all of these but the last.
std::span<const std::string_view> fail_on_words();

/// Codes, families, "ALL" and names of rules.
std::vector<std::string> all_rule_words();

/// What `drawbead schema config` prints: schemas/config.schema.json.
std::string config_schema();
/// What `drawbead explain configuration` prints: docs/configuration.md.
std::string config_page();

} // namespace drawbead
