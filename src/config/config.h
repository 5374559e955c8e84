#pragma once
// A configuration file as it stands: what it says, and where.
#include "base/result.h"
#include "findings/finding.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drawbead {

/// Where a value comes from: a place in a file, the command line, or nowhere: the default.
struct Origin {
    std::string file; ///< "command line" for that; empty: the default
    uint64_t line = 0;
    uint32_t column = 0;

    std::string text() const; ///< "default", "command line", ".drawbead.yaml:3:5"
};

template <class T>
struct Chosen {
    T value{};
    Origin origin{};
};

/// What a file, one of its overrides, or a command line says. Words name rules: codes and families in
/// capitals.
struct Choices {
    std::optional<Chosen<std::vector<std::string>>> select, ignore;
    std::map<std::string, Chosen<Severity>> severity;
    std::optional<Chosen<std::string>> fail_on;                   ///< a word of fail_on_words()
    std::optional<Chosen<std::vector<std::string>>> include_path; ///< as they can be opened
    std::map<std::size_t, Chosen<double>> limits;                 ///< by place in limit_table()
};

struct Override {
    std::vector<std::string> paths;
    Choices choices;
};

struct Config {
    std::string path;
    Choices choices;
    std::vector<Override> overrides;
};

/// An error has the place of the mistake. `path` is what messages and origins say, and what paths in the text
/// are relative to.
Result<Config> parse_config(std::string_view text, const std::string& path);
Result<Config> read_config(const std::string& path);

} // namespace drawbead
