#pragma once
// The lines that are not data: keywords and #include.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace drawbead {

/// Length of the byte order mark that some editors write at the beginning of a file: 3, or 0 without one. The
/// first line begins behind it.
uint64_t byte_order_mark(std::string_view file);

/// A keyword line cut into its fields: /K1/K2/…/ID/UNIT
struct KeywordLine {
    std::string_view keyword; ///< "GRNOD/NODENS", without slashes at its ends; "/SUBMODEL" for //SUBMODEL
    std::string_view id;      ///< digits or &name, empty when not given
    std::string_view unit;    ///< likewise
    std::string_view rest;    ///< what follows the unit field, without its slash
};

/// `line` begins with the slash.
KeywordLine cut_keyword_line(std::string_view line);

struct IncludeDirective {
    std::string path;    ///< joined over continuation lines, quotes removed
    uint64_t next = 0;   ///< offset of the first byte after the directive
    bool run_on = false; ///< text sticks to the word, as in "#includes": it may be a comment
};

/// The #include whose line starts at `offset`, with its continuations; empty when the line is no #include.
std::optional<IncludeDirective> include_at(std::string_view bytes, uint64_t offset);

} // namespace drawbead
