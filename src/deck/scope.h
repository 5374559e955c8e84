#pragma once
// What holds for the text of one instance of a file or submodel.
#include "deck/place.h"
#include "deck/units.h"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace drawbead {

/// Added to every id written inside a submodel, definitions and references alike; 0 stays 0.
struct Offsets {
    int64_t general = 0; ///< groups, surfaces, interfaces, subsets, boxes, functions
    int64_t node = 0, element = 0, part = 0, material = 0, property = 0, submodel = 0;
    friend bool operator==(const Offsets&, const Offsets&) = default;
};

struct Parameter {
    enum class Kind : uint8_t { real, integer, text };
    Kind kind = Kind::real;
    double value = 0;
    std::string text;
    Span place;
};
/// Sorted by name; transparent compare so that look-ups take a string_view.
using ParameterTable = std::map<std::string, Parameter, std::less<>>;

struct Scope {
    ScopeId parent{}; ///< the root is its own parent
    FileId file{};
    Span included_by;          ///< the #include line, or the //SUBMODEL header; empty for the root
    int version = 0;           ///< as written on /BEGIN
    int layout = 0;            ///< the card layouts that the solver takes for it
    UnitSystem input;          ///< units of numbers written here
    int64_t unit_id = 0;       ///< of //SUBMODEL, for options that have none of their own
    Offsets offsets;           ///< accumulated over nested submodels
    int64_t submodel = 0;      ///< global id of the innermost //SUBMODEL, 0 outside
    ParameterTable parameters; ///< local ones
    uint32_t depth = 0;
};

} // namespace drawbead
