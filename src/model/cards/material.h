#pragma once
// Elastic constants on material cards. Most laws hold density on card 1 and E, nu on card 2.
#include "deck/card.h"

#include <string_view>

namespace drawbead {

/// Where a law keeps its moduli.
enum class ElasticCards : uint8_t {
    isotropic,  ///< card 2: E, nu
    hill,       ///< LAW93: card 2 E11 E22 E33 G12 nu12, card 3 G13 G23 nu13 nu23
    composite,  ///< LAW15, 19, 25: card 2 E11 E22 nu12
    voided,     ///< LAW0: one optional card with density, E and, from 140 on, nu
    predefined, ///< PLAS_PREDEF: one card with a name
    none,       ///< fluids, gases, foams, explosives: no Young's modulus that a contact could use
};

struct LawName {
    std::string_view name; ///< as after /MAT/
    int law;
    ElasticCards cards;
};

/// Names besides LAWn and LAW0n.
inline constexpr LawName law_names[] = {
    {"VOID", 0, ElasticCards::voided},
    {"ELAST", 1, ElasticCards::isotropic},
    {"PLAS_JOHNS", 2, ElasticCards::isotropic},
    {"JOHNS", 2, ElasticCards::isotropic},
    {"PLAS_ZERIL", 2, ElasticCards::isotropic},
    {"ZERIL", 2, ElasticCards::isotropic},
    {"PLAS_PREDEF", 2, ElasticCards::predefined},
    {"HYDPLA", 3, ElasticCards::none},
    {"HYD_JCOOK", 4, ElasticCards::none},
    {"JWL", 5, ElasticCards::none},
    {"HYDRO", 6, ElasticCards::none},
    {"HYD_VISC", 6, ElasticCards::none},
    {"K-EPS", 6, ElasticCards::none},
    {"BOUND", 11, ElasticCards::none},
    {"RIGID", 13, ElasticCards::isotropic},
    {"CHANG", 15, ElasticCards::composite},
    {"THERM", 18, ElasticCards::none},
    {"FABRI", 19, ElasticCards::composite},
    {"BIMAT", 20, ElasticCards::none},
    {"DAMA", 22, ElasticCards::isotropic},
    {"PLAS_DAM", 23, ElasticCards::isotropic},
    {"COMPSH", 25, ElasticCards::composite},
    {"SESAM", 26, ElasticCards::none},
    {"PLAS_BRIT", 27, ElasticCards::isotropic},
    {"HILL", 32, ElasticCards::isotropic},
    {"FOAM_PLAS", 33, ElasticCards::none},
    {"BOLTZMAN", 34, ElasticCards::none},
    {"FOAM_VISC", 35, ElasticCards::none},
    {"PLAS_TAB", 36, ElasticCards::isotropic},
    {"BIPHAS", 37, ElasticCards::none},
    {"VISC_TAB", 38, ElasticCards::none},
    {"KELVINMAX", 40, ElasticCards::none},
    {"LEE_TARVER", 41, ElasticCards::none},
    {"OGDEN", 42, ElasticCards::none},
    {"HILL_TAB", 43, ElasticCards::isotropic},
    {"COWPER", 44, ElasticCards::isotropic},
    {"LES_FLUID", 46, ElasticCards::none},
    {"ZHAO", 48, ElasticCards::isotropic},
    {"MULTIMAT", 51, ElasticCards::none},
    {"MULTIFLUID", 51, ElasticCards::none},
    {"GURSON", 52, ElasticCards::isotropic},
    {"BARLAT3", 57, ElasticCards::isotropic},
    {"BARLAT", 57, ElasticCards::isotropic},
    {"PLAS_T3", 60, ElasticCards::isotropic},
    {"VISC_HYP", 62, ElasticCards::none},
    {"HANSEL", 63, ElasticCards::isotropic},
    {"UGINE_ALZ", 64, ElasticCards::isotropic},
    {"FOAM_TAB", 70, ElasticCards::none},
    {"HILL_MMC", 72, ElasticCards::isotropic},
    {"SAMP", 76, ElasticCards::isotropic},
    {"YUMODEL", 78, ElasticCards::isotropic},
    {"BARLAT2000", 87, ElasticCards::isotropic},
    {"ORTH_HILL", 93, ElasticCards::hill},
    {"CONVERSE", 93, ElasticCards::hill},
    {"JOHNS_VOCE_DRUCKER", 104, ElasticCards::isotropic},
    {"VEGTER", 110, ElasticCards::isotropic},
    {"PLAS_RATE", 121, ElasticCards::isotropic},
    {"GAS", -1, ElasticCards::none},
};
/// Isotropic laws that have no name but their number.
inline constexpr int unnamed_isotropic_laws[] = {66, 73, 80, 84, 109};

inline constexpr Field density_fields[] = {
    {.name = "Rho",
     .column = 1,
     .width = 16,
     .kind = Kind::real,
     .dimension = density_dimension,
     .until = 44},
    {.name = "Rho",
     .column = 1,
     .width = 20,
     .kind = Kind::real,
     .dimension = density_dimension,
     .since = 45},
};
inline constexpr CardSchema density_card{"density", density_fields};

inline constexpr Field isotropic_fields[] = {
    {.name = "E", .column = 1, .width = 16, .kind = Kind::real, .dimension = pressure_dimension, .until = 44},
    {.name = "nu", .column = 17, .width = 16, .kind = Kind::real, .until = 44},
    {.name = "E", .column = 1, .width = 20, .kind = Kind::real, .dimension = pressure_dimension, .since = 45},
    {.name = "nu", .column = 21, .width = 20, .kind = Kind::real, .since = 45},
};
inline constexpr CardSchema isotropic_card{"elastic constants", isotropic_fields};

inline constexpr Field void_fields[] = {
    {.name = "Rho",
     .column = 1,
     .width = 20,
     .kind = Kind::real,
     .dimension = density_dimension,
     .since = 45},
    {.name = "E",
     .column = 21,
     .width = 20,
     .kind = Kind::real,
     .dimension = pressure_dimension,
     .since = 45},
    {.name = "nu", .column = 41, .width = 20, .kind = Kind::real, .since = 140},
};
inline constexpr CardSchema void_card{"void", void_fields};

inline constexpr Field composite_fields[] = {
    {.name = "E11", .column = 1, .width = 20, .kind = Kind::real, .dimension = pressure_dimension},
    {.name = "E22", .column = 21, .width = 20, .kind = Kind::real, .dimension = pressure_dimension},
    {.name = "nu12", .column = 41, .width = 20, .kind = Kind::real},
};
inline constexpr CardSchema composite_card{"orthotropic constants", composite_fields};

inline constexpr Field hill_fields[] = {
    {.name = "E11", .column = 1, .width = 20, .kind = Kind::real, .dimension = pressure_dimension},
    {.name = "E22", .column = 21, .width = 20, .kind = Kind::real, .dimension = pressure_dimension},
    {.name = "E33", .column = 41, .width = 20, .kind = Kind::real, .dimension = pressure_dimension},
    {.name = "G12", .column = 61, .width = 20, .kind = Kind::real, .dimension = pressure_dimension},
    {.name = "nu12", .column = 81, .width = 20, .kind = Kind::real},
};
inline constexpr CardSchema hill_card{"orthotropic constants", hill_fields};

inline constexpr Field hill_shear_fields[] = {
    {.name = "G13", .column = 1, .width = 20, .kind = Kind::real, .dimension = pressure_dimension},
    {.name = "G23", .column = 21, .width = 20, .kind = Kind::real, .dimension = pressure_dimension},
    {.name = "nu13", .column = 41, .width = 20, .kind = Kind::real},
    {.name = "nu23", .column = 61, .width = 20, .kind = Kind::real},
};
inline constexpr CardSchema hill_shear_card{"orthotropic shear constants", hill_shear_fields};

/// Constants that the solver has for the names of PLAS_PREDEF, in Pa.
struct PredefinedMaterial {
    std::string_view name;
    double young, poisson;
};
inline constexpr PredefinedMaterial predefined_materials[] = {
    {"STEEL", 210e9, 0.3},  {"HSS", 210e9, 0.3},       {"UHSS", 210e9, 0.3},
    {"AA5182", 70e9, 0.33}, {"AA6082-T6", 70e9, 0.33}, {"PA6GF30", 7e9, 0.35},
};

} // namespace drawbead
