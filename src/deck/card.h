#pragma once
// The card mechanism: a card is data (name, columns, kind, dimension, versions); reading and explaining it is
// generic.
#include "deck/number.h"
#include "deck/place.h"
#include "deck/units.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace drawbead {

class Deck;

enum class Kind : uint8_t { integer, real, text };
enum class Link : uint8_t {
    none,
    node,
    node_group,
    surface,
    part,
    property,
    material,
    subset,
    function,
    submodel
};

inline constexpr int newest_layout = 9999; ///< `until` of a field that still exists

/// One field of a card, in the layouts `since` … `until` (both included). Columns count from 1.
struct Field {
    std::string_view name;
    uint8_t column = 1, width = 10;
    Kind kind = Kind::integer;
    Dimension dimension = dimensionless;
    int since = 0, until = newest_layout;
    Link link = Link::none;
};

/// A card of a block; the fields of all layouts stand in one list.
struct CardSchema {
    std::string_view name;
    std::span<const Field> fields;
};

enum class CellState : uint8_t {
    blank,
    ok,
    trailing, ///< more text after the number; the solver ignores it
    garbage,  ///< not a number
    not_finite,
    unknown_parameter, ///< `&name` that no /PARAMETER defines
    absent,            ///< the layout of this version has no such field
};

/// One cell as written. `real` and `integer` hold the value in the deck's input units, 0 unless state is
/// ok/trailing.
struct Cell {
    CellState state = CellState::absent;
    std::string_view text; ///< trimmed
    double real = 0;
    int64_t integer = 0;
    Span place; ///< the trimmed text; for a blank cell its columns as far as the line has them

    bool given() const { return state == CellState::ok || state == CellState::trailing; }
};

/// A card as read: one Cell per field of the schema, in the schema's order.
struct Card {
    const CardSchema* schema = nullptr;
    bool present = false;     ///< false: the line does not exist, all cells are absent or blank
    bool free_format = false; ///< the line holds a comma
    Span line;                ///< without the line end
    std::vector<Cell> cells;

    const Cell&
    operator[](std::string_view field) const; ///< in the layout at hand; a static absent cell otherwise
};

/// Cuts a free-format line: commas and blanks both separate, and nothing between two commas is an empty
/// field. The fields are places of `text`.
std::vector<std::string_view> free_fields(std::string_view text);

/// Reads `line` (a place in `scope`'s file) by the schema's layout for the scope's version. Cells are cut by
/// column; a line with a comma is cut at commas, each gap between fields counting as one empty field. `&name`
/// is replaced. Cards of nothing but text have no free format.
Card read_card(const Deck&, ScopeId, Span line, const CardSchema&);
/// A card whose line does not exist.
Card missing_card(const Deck&, ScopeId, const CardSchema&);

/// Reads one cell of a line by columns, with parameters.
Cell read_cell(const Deck&, ScopeId, Span line, uint32_t column, uint32_t width, Kind);

} // namespace drawbead
