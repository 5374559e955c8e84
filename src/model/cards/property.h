#pragma once
// Thickness on property cards, as far as a drawbead's blank can have it.
#include "deck/card.h"

#include <string_view>

namespace drawbead {

/// Where a property type keeps its shell thickness.
enum class ThicknessCard : uint8_t {
    none,  ///< not a shell
    third, ///< third data card
    first, ///< optional first data card
    stack, ///< third data card, else the sum of its plies
    plies, ///< the sum of its plies
    other, ///< plies that another option lists
};

struct PropertyName {
    std::string_view name;
    int type;
    ThicknessCard thickness;
};

/// Names after /PROP/ as the solver knows them; TYPEn and TYPE0n besides.
inline constexpr PropertyName property_names[] = {
    {"VOID", 0, ThicknessCard::first},      {"SHELL", 1, ThicknessCard::third},
    {"TRUSS", 2, ThicknessCard::none},      {"BEAM", 3, ThicknessCard::none},
    {"SPRING", 4, ThicknessCard::none},     {"RIVET", 5, ThicknessCard::none},
    {"SOL_ORTH", 6, ThicknessCard::none},   {"SPR_GENE", 8, ThicknessCard::none},
    {"SH_ORTH", 9, ThicknessCard::third},   {"SH_COMP", 10, ThicknessCard::third},
    {"SH_SANDW", 11, ThicknessCard::third}, {"SPR_PUL", 12, ThicknessCard::none},
    {"SPR_BEAM", 13, ThicknessCard::none},  {"SOLID", 14, ThicknessCard::none},
    {"FLUID", 14, ThicknessCard::none},     {"POROUS", 15, ThicknessCard::none},
    {"SH_FABR", 16, ThicknessCard::third},  {"STACK", 17, ThicknessCard::stack},
    {"INT_BEAM", 18, ThicknessCard::none},  {"PLY", 19, ThicknessCard::none},
    {"TSHELL", 20, ThicknessCard::none},    {"TSH_ORTH", 21, ThicknessCard::none},
    {"TSH_COMP", 22, ThicknessCard::none},  {"CONNECT", 43, ThicknessCard::none},
    {"PCOMPP", 52, ThicknessCard::other},
};

/// What the numbers of TYPEn say when no name of the table above has them.
constexpr ThicknessCard thickness_card_of_type(int type) {
    for (const PropertyName& p : property_names)
        if (p.type == type) return p.thickness;
    return type == 51 ? ThicknessCard::plies : ThicknessCard::none;
}

inline constexpr Field shell_thickness_fields[] = {
    {.name = "Thick",
     .column = 17,
     .width = 16,
     .kind = Kind::real,
     .dimension = length_dimension,
     .until = 44},
    {.name = "Thick",
     .column = 21,
     .width = 20,
     .kind = Kind::real,
     .dimension = length_dimension,
     .since = 45},
};
inline constexpr CardSchema shell_thickness_card{"shell thickness", shell_thickness_fields};

inline constexpr Field void_thickness_fields[] = {
    {.name = "Thick",
     .column = 1,
     .width = 16,
     .kind = Kind::real,
     .dimension = length_dimension,
     .until = 44},
    {.name = "Thick",
     .column = 1,
     .width = 20,
     .kind = Kind::real,
     .dimension = length_dimension,
     .since = 45},
};
inline constexpr CardSchema void_thickness_card{"void thickness", void_thickness_fields};

/// First card of a ply; on stacks the same columns of every second line after the fourth card name the ply.
inline constexpr Field ply_fields[] = {
    {.name = "mat_ID", .column = 1, .link = Link::material},
    {.name = "Thick", .column = 11, .width = 20, .kind = Kind::real, .dimension = length_dimension},
};
inline constexpr CardSchema ply_card{"ply", ply_fields};

inline constexpr Field stack_ply_fields[] = {{.name = "ply_ID", .column = 1, .link = Link::property}};
inline constexpr CardSchema stack_ply_card{"ply of a stack", stack_ply_fields};

} // namespace drawbead
