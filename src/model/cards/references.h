#pragma once
// Where other options name node groups and surfaces: so that a repair does not change what somebody else
// uses.
#include "deck/card.h"

#include <string_view>

namespace drawbead {

struct Reference {
    std::string_view keyword; ///< the option and all that begins with it and a slash
    Link link;                ///< node_group or surface
    uint8_t card;             ///< data card, from 1; 0: a list of ids
    uint8_t column;
};

/// Options whose columns are known. An option that is neither here nor in `without_references` counts as a
/// user when any of its cells equals the id.
inline constexpr Reference references[] = {
    {"GRNOD/GRNOD", Link::node_group, 0, 0}, {"GRNOD/GRNODNS", Link::node_group, 0, 0},
    {"GRNOD/SURF", Link::surface, 0, 0},     {"LINE/SURF", Link::surface, 0, 0},
    {"LINE/EDGE", Link::surface, 0, 0},      {"SURF/SURF", Link::surface, 0, 0},
    {"SURF/DSURF", Link::surface, 0, 0},     {"TH/SURF", Link::surface, 0, 0},
    {"RBODY", Link::node_group, 1, 61},      {"RBODY", Link::surface, 1, 91},
    {"BCS", Link::node_group, 1, 21},        {"IMPVEL", Link::node_group, 1, 41},
    {"IMPDISP", Link::node_group, 1, 41},    {"IMPACC", Link::node_group, 1, 41},
    {"CLOAD", Link::node_group, 1, 41},      {"GRAV", Link::node_group, 1, 41},
    {"INIVEL/TRA", Link::node_group, 1, 61}, {"INIVEL/ROT", Link::node_group, 1, 61},
    {"INIVEL/T+G", Link::node_group, 1, 61}, {"RBE2", Link::node_group, 1, 31},
    {"RLINK", Link::node_group, 1, 21},      {"CYL_JOINT", Link::node_group, 1, 21},
    {"RWALL", Link::node_group, 1, 21},      {"RWALL", Link::node_group, 1, 31},
    {"TRANSFORM", Link::node_group, 1, 1},   {"ADMAS", Link::node_group, 1, 21},
    {"PLOAD", Link::surface, 1, 1},          {"INTER/TYPE2", Link::node_group, 1, 1},
    {"INTER/TYPE2", Link::surface, 1, 11},   {"INTER/TYPE5", Link::node_group, 1, 1},
    {"INTER/TYPE5", Link::surface, 1, 11},   {"INTER/TYPE7", Link::node_group, 1, 1},
    {"INTER/TYPE7", Link::surface, 1, 11},   {"INTER/TYPE10", Link::node_group, 1, 1},
    {"INTER/TYPE10", Link::surface, 1, 11},  {"INTER/TYPE3", Link::surface, 1, 1},
    {"INTER/TYPE3", Link::surface, 1, 11},
};

/// Options that name neither.
inline constexpr std::string_view without_references[] = {
    "BEGIN",     "END",    "TITLE",    "NODE",        "CNODE",  "SHELL",     "SH3N",         "QUAD",
    "TRIA",      "BRICK",  "TETRA4",   "TETRA10",     "PENTA6", "BRIC20",    "SHEL16",       "TRUSS",
    "BEAM",      "SPRING", "SPHCEL",   "PART",        "SUBSET", "PROP",      "PLY",          "STACK",
    "MAT",       "FAIL",   "EOS",      "VISC",        "HEAT",   "FUNCT",     "FUNCT_PYTHON", "TABLE",
    "UNIT",      "SKEW",   "FRAME",    "BOX",         "SENSOR", "PARAMETER", "ANALY",        "DEF_SHELL",
    "DEF_SOLID", "IOFLAG", "SPMD",     "MEMORY",      "RANDOM", "SHFRA",     "ADMESH",       "GRSHEL",
    "GRSH3N",    "GRTRIA", "GRBRIC",   "GRPART",      "TH",     "/SUBMODEL", "/ENDSUB",      "INISHE",
    "INISH3",    "INIBRI", "STAMPING", "UPWIND",      "REFSTA", "XREF",      "EREF",         "GRNOD",
    "SURF",      "LINE",   "SET",      "INTER/TYPE8", "RBE3",   "ACTIV",     "DAMP/FUNCT",
};

} // namespace drawbead
